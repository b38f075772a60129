// quartic_table.hpp - what is known of the quartics of one body, each worked out once however many faces ask.
// Two quadrics have one n up to a constant, on whichever of them the sheets are.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "host/resolve/line_root.hpp"
#include "host/resolve/quartic.hpp"
#include "host/resolve/root_marks.hpp"

namespace halfspace {

// References stay valid as long as the table.
class QuarticTable {
 public:
  // Marks are those of the local lines y0 .. y1.
  QuarticTable(std::int64_t y0, std::int64_t y1) : y0_(y0), y1_(y1) {}

  // p is not zero.
  [[nodiscard]] const PlaneFactors& factors_of(QuarticForm p);

  // Of irreducible curves, canonical: where one turns, where two meet.
  [[nodiscard]] const std::vector<Mark>& turns(const QuarticForm& p);
  [[nodiscard]] const std::vector<Mark>& meetings(const QuarticForm& p, const QuarticForm& q);

  // Of an irreducible curve, canonical: its roots on a local line.
  [[nodiscard]] const std::vector<LineRoot>& roots(const QuarticForm& p, std::int64_t y);

 private:
  using Key = std::array<mpz_class, 15>;

  std::int64_t y0_, y1_;
  std::map<Key, PlaneFactors> factors_;
  std::map<Key, std::vector<Mark>> turns_;
  std::map<std::pair<Key, Key>, std::vector<Mark>> meetings_;
  std::map<Key, std::map<std::int64_t, std::vector<LineRoot>>> roots_;
};

}  // namespace halfspace
