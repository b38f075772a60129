// bound_form.hpp - what values a half-space can have in a box, in doubles, rounding included.
// Exact   The range holds all values. A sum of T in size, of at most 40 terms of at most four factors, each known to 2^-52, is
//         off by less than 2^-46 T; 2^-44 T is added to either side.
#pragma once

#include <array>

#include "host/flatten/matrix.hpp"

namespace halfspace {

struct CentredBox {
  std::array<double, 3> middle{}, half{};
};

struct ValueRange {
  double low = 0, high = 0;
  double high_in_the_middle = 0;  // the middle's own value is not above it
};

// Negative inside.
class BoundForm {
 public:
  explicit BoundForm(const RealHalfSpace& shape);
  [[nodiscard]] ValueRange over(const CentredBox& cell) const;

  // Far away: of (x', y', t) it has the sign that this form has of x / t, where the point x is `sign` along `axis` and (x', y') along the
  // two axes after it. t = 0 is infinity.
  [[nodiscard]] BoundForm towards(std::size_t axis, double sign) const;

 private:
  BoundForm() = default;
  void add_up();

  bool is_plane_ = false;
  std::array<std::array<double, 3>, 3> a_{};  // x a x + 2 g x + k
  std::array<double, 3> g_{};
  double k_ = 0;
  double square_terms_ = 0, linear_terms_ = 0;  // sums of sizes where no coordinate is larger than 1
};

}  // namespace halfspace
