#include "host/report/page_floor.hpp"

#include "firmware/core/row_painter.hpp"
#include "host/report/processor_time.hpp"

namespace halfspace {

double page_floor_ns(const PageSize& size, int runs) {
  const Page page{size.width, size.height, DotFormat::bilevel, size.levels, size.levels - 1};
  std::vector<std::uint32_t> words(row_words(page));
  std::vector<PatternRow> patterns(static_cast<std::size_t>(size.levels) * cell_side);
  make_patterns(Screen::clustered, size.levels, patterns);
  RowPainter painter(page, words, patterns);
  const double seconds = median_seconds(runs, [&] {
    for (std::int32_t y = 0; y < size.height; ++y) {
      painter.begin(y);
      asm volatile("" : : "r"(words.data()) : "memory");  // the words are wanted
    }
  });
  return 1e9 * seconds / size.width / size.height;
}

}  // namespace halfspace
