// level_search.hpp - from certain and uncertain comparisons to the level of a dot: the part that both shaders share.
#pragma once

#include <cstdint>

#include "firmware/core/exact.hpp"
#include "firmware/core/shade.hpp"

namespace halfspace {

// L and |N|^2 at a dot, on scales such that level k is reached when L > 0 and L^2 >= squares[k] |N|^2 / 2^32.
// Ranges  |L| < 2^31.5, |N|^2 < 2^62.
struct Light {
  std::int64_t l = 0;
  std::int64_t n2 = 0;
};

// What L, and L^2 - t |N|^2, must exceed to be certain.
struct Margin {
  std::int64_t light = 0;
  std::int64_t squares = 0;

  // From the errors of L and of |N|^2; 2^31 more covers the rounding of t and of its product.
  static Margin of(std::int64_t light_error, std::int64_t square_error) {
    return {light_error, (light_error << 33) + light_error * light_error + square_error + (std::int64_t{1} << 31)};
  }
};

enum class Answer : std::uint8_t { no, yes, unsure };

// (t * a) >> 32 for 0 <= a < 2^63: two products of 32 bits, or one of 64.
inline std::int64_t scale_by(std::uint32_t t, std::int64_t a) {
  const auto u = static_cast<std::uint64_t>(a);
  if constexpr (limb_bits == 64) {
    return static_cast<std::int64_t>((static_cast<DoubleLimb>(u) * t) >> 32);
  } else {
    return static_cast<std::int64_t>(t * (u >> 32) + ((t * (u & 0xffffffffU)) >> 32));
  }
}

// Unsigned, so that a job that lies about its widths gets a wrong level and nothing worse.
inline Answer compare(const Light& light, const Margin& margin, std::uint32_t square) {
  if (light.l <= margin.light) return light.l < -margin.light ? Answer::no : Answer::unsure;
  const auto l = static_cast<std::uint64_t>(light.l);
  const auto difference = static_cast<std::int64_t>(l * l - static_cast<std::uint64_t>(scale_by(square, light.n2)));
  if (difference > margin.squares) return Answer::yes;
  return difference < -margin.squares ? Answer::no : Answer::unsure;
}

// The levels between which a dot keeps the level of the dot before: the fast way round search_level.
struct LevelWindow {
  std::uint32_t low = 0, high = 0;           // LevelTable::squares of the level and of the next one
  bool open_low = false, open_high = false;  // nothing lies below or above

  static LevelWindow of(const LevelTable& table, std::int32_t level) {
    LevelWindow w;
    w.open_low = level <= table.ambient_level;
    w.open_high = level >= table.top_level;
    w.low = table.squares[static_cast<std::size_t>(level)];
    w.high = w.open_high ? 0 : table.squares[static_cast<std::size_t>(level) + 1];
    return w;
  }
  // True when the dot is certain to have the level.
  [[nodiscard]] bool holds(const Light& light, const Margin& margin) const {
    return (open_low || compare(light, margin, low) == Answer::yes) &&
           (open_high || compare(light, margin, high) == Answer::no);
  }
};

// The largest level that `reaches(k)` grants, by bisection; from the level of the dot before (-1: none) in steps that double first
// [Bentley, Yao 1976], since a dot of a small face may lie a hundred levels on.
template <class Reaches>
std::int32_t search_level(const LevelTable& table, std::int32_t level, Reaches reaches) {
  const auto asks = [&](std::int32_t k) {
    if (k <= table.ambient_level) return true;
    return k <= table.top_level && reaches(k);
  };
  std::int32_t low = table.ambient_level;
  std::int32_t high = table.top_level + 1;
  if (level >= 0) {
    const bool rises = asks(level + 1);
    if (!rises && asks(level)) return level;
    std::int32_t step = 1;
    if (rises) {
      for (low = level + 1; asks(low + step); step *= 2) low += step;
      high = low + step;
    } else {
      for (high = level; !asks(high - step); step *= 2) high -= step;
      low = high - step;
    }
  }
  while (high - low > 1) {
    const std::int32_t middle = (low + high) / 2;
    (asks(middle) ? low : high) = middle;
  }
  return low;
}

// Runs level_at(x, level of the dot before or -1) over the span and paints runs of equal levels.
template <class LevelAt>
void paint_levels(const ShadeJob& job, std::int32_t x0, std::int32_t x1, LevelAt level_at) {
  std::int32_t from = x0;
  std::int32_t level = -1;
  std::uint32_t runs = 1;
  for (std::int32_t x = x0; x <= x1; ++x) {
    const std::int32_t k = level_at(x, level);
    if (k == level) continue;
    if (level >= 0) {
      job.painter.fill(from, x - 1, level);
      ++runs;
    }
    from = x;
    level = k;
  }
  job.painter.fill(from, x1, level);
  job.counters.level_spans += runs;
  job.counters.intensities += static_cast<std::uint32_t>(x1 - x0 + 1);
}

}  // namespace halfspace
