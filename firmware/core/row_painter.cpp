#include "firmware/core/row_painter.hpp"

#include <algorithm>
#include <bit>

namespace halfspace {

RowPainter::RowPainter(const Page& page, std::span<std::uint32_t> words, std::span<const PatternRow> patterns,
                       std::span<const std::uint32_t> edges)
    : page_(page), words_(words), patterns_(patterns), edges_(edges) {
  if (edges_.empty()) return;
  std::int32_t count = -2 * cell_side;  // bits 0 and `levels` of every line
  for (const std::uint32_t word : edges_) count += std::popcount(word);
  edge_share_ = (count << share_bits) / (cell_side * (page_.levels - 1));
  edge_gap_ = (1 << 2 * share_bits) / std::max<std::int32_t>(edge_share_, 1);
}

void RowPainter::begin(std::int32_t y) {
  line_ = is_bilevel() ? patterns_.data() + y % cell_side * page_.levels : tones.data();
  if (!edges_.empty()) line_edges_ = edges_.data() + static_cast<std::size_t>(y % cell_side) * edge_words(page_.levels);
  fill(0, page_.width - 1, page_.background);
}

void RowPainter::fill(std::int32_t x0, std::int32_t x1, std::int32_t level) { RunPainter(*this, x0, level).end(x1); }

// Four bytes at once: compilers make one store of them where the machine allows it.
void RowPainter::copy_to(std::span<std::uint8_t> bytes) const {
  const std::byte* from = std::as_bytes(words_).data();
  std::byte* to = std::as_writable_bytes(bytes).data();
  for (std::size_t i = bytes.size() / 4; i > 0; --i, from += 4, to += 4) std::copy_n(from, 4, to);
  for (std::size_t i = bytes.size() % 4; i > 0; --i) *to++ = *from++;
  const bool has_spare_bits = page_.format == DotFormat::bilevel && page_.width % 8 != 0;
  if (has_spare_bits) bytes.back() &= static_cast<std::uint8_t>(0xff00U >> (page_.width % 8));
}

}  // namespace halfspace
