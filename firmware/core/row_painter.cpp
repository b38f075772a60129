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
  std::uint8_t* to = bytes.data();
  const std::size_t whole = bytes.size() / 4;
  for (const std::uint32_t word : words_.first(whole)) {
    to[0] = static_cast<std::uint8_t>(word >> 24);
    to[1] = static_cast<std::uint8_t>(word >> 16);
    to[2] = static_cast<std::uint8_t>(word >> 8);
    to[3] = static_cast<std::uint8_t>(word);
    to += 4;
  }
  for (std::size_t i = 4 * whole; i < bytes.size(); ++i) {
    bytes[i] = static_cast<std::uint8_t>(words_[whole] >> (24 - i % 4 * 8));
  }
  const bool has_spare_bits = page_.format == DotFormat::bilevel && page_.width % 8 != 0;
  if (has_spare_bits) bytes.back() &= static_cast<std::uint8_t>(0xff00U >> (page_.width % 8));
}

}  // namespace halfspace
