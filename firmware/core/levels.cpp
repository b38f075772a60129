#include "firmware/core/shade.hpp"
#include "firmware/core/wide.hpp"

namespace halfspace {
namespace {

using Int = Wide<128>;  // t, most < 2^24, |light|^2 < 2^32, and a bit for each doubling: under 2^84

// floor(2^32 n / d) for 0 <= n < d.
std::uint32_t fraction(Int n, const Int& d) {
  std::uint32_t quotient = 0;
  for (int bit = 0; bit < 32; ++bit) {
    n += n;
    quotient <<= 1;
    if (n >= d) {
      n -= d;
      quotient |= 1;
    }
  }
  return quotient;
}

}  // namespace

LevelTable make_levels(const Lighting& lighting, std::int32_t levels, std::span<std::uint32_t> squares) {
  LevelTable table;
  table.levels = levels;
  table.squares = squares;
  std::int64_t l2 = 0;
  for (const std::int32_t l : lighting.light) l2 += static_cast<std::int64_t>(l) * l;
  while ((std::int64_t{1} << (2 * table.light_bits)) <= l2) ++table.light_bits;
  const std::int64_t most = static_cast<std::int64_t>(levels - 1) * lighting.parallel;
  const Int divisor = (Int(most) * Int(most)) << (2 * table.light_bits);
  for (std::int32_t k = 0; k < levels; ++k) {
    // (ambient + parallel cos) (levels - 1) >= k unit  <=>  t <= most cos
    const std::int64_t t =
        static_cast<std::int64_t>(k) * lighting.unit - static_cast<std::int64_t>(levels - 1) * lighting.ambient;
    squares[static_cast<std::size_t>(k)] = 0;
    if (t <= 0) table.ambient_level = k;
    if (t > 0 && t <= most) squares[static_cast<std::size_t>(k)] = fraction(Int(t) * Int(t) * Int(l2), divisor);
    if (t <= 0 || t <= most) table.top_level = k;
  }
  return table;
}

}  // namespace halfspace
