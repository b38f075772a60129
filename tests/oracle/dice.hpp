// dice.hpp - random numbers that are the same on every machine: a seed names a scene for good.
// The standard fixes std::mt19937_64 but not its distributions, so these are our own. (The slight bias of the
// remainder does not matter here.)
#pragma once

#include <cstdint>
#include <initializer_list>
#include <random>

namespace halfspace::oracle {

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : bits_(seed) {}

  // 0 .. n - 1.
  std::int64_t below(std::int64_t n) { return static_cast<std::int64_t>(bits_() % static_cast<std::uint64_t>(n)); }

  // Both ends included.
  std::int64_t between(std::int64_t least, std::int64_t most) { return least + below(most - least + 1); }

  bool chance(int percent) { return below(100) < percent; }

  std::int64_t one_of(std::initializer_list<std::int64_t> values) {
    return values.begin()[below(static_cast<std::int64_t>(values.size()))];
  }

 private:
  std::mt19937_64 bits_;
};

}  // namespace halfspace::oracle
