// cross_arc.hpp - light and normal across the rulings of a cone or cylinder, as forms in one parameter tau from 0 to 1.
//   A scan line meets the face in an arc of the conic s^2 = D(x). From A = (xA, sA) to B it is the rational curve
//     A sigma^2 + 2 kappa T sigma tau + B tau^2,    sigma = 1 - tau,
//     T = sB A + sA B + (0, P - sA sB),    kappa^2 = 1 / 2 (P + sA sB),    P the polar form of D at xA and xB,
//   in homogeneous (x, s, 1): T is the pole of the chord. So is N, linear there, but for a positive factor that changes with tau, and
//     L = l0 sigma^2 + 2 l1 sigma tau + l2 tau^2                  |N|^2: of fourth degree, n0 .. n4 in Bernstein form
//   and the intensity L / |N| rises where the quartic w = dL/dtau n - L dn/dtau / 2 (its fifth power cancels) is positive.
//   All lines have the same arc, since N keeps its direction along a ruling: tau tells the ruling.
//   A face without z^2 has such forms in x itself: N is of second degree there (quotient_forms.hpp), and T the polar form at xA and xB.
// Units   forms 2^-60, scaled below 1; tau 2^-32; a ruling's place on the way from A to B 2^-24.
// Errors  The line's numbers may be known to within errors only; the arc's forms hold for all that they allow, to within unsure() and
//         what rise() and turns() keep to themselves. A place is off by less than 1/4.
// Cost    On a Cortex-M3 some 200 instructions a point, 30,000 to make an arc.
// Source  Farin, Curves and Surfaces for CAGD: conics as rational quadratics, blossoms, variation diminution.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#include "firmware/core/real.hpp"
#include "firmware/core/shade.hpp"

namespace halfspace {

using RealVector = std::array<BoundedReal, 3>;

// One scan line's forms about a dot of it: x counts from there.
struct CrossLine {
  BoundedReal d0, d1, d2;          // D = d2 + d1 x + d0 x^2
  RealVector normal, normal_step;  // N = normal + normal_step x + normal_root s
  RealVector normal_root;
};

struct ArcEnd {
  BoundedReal x, s;
};

// L, |N|^2 and their slopes at a point of the arc.
struct ArcLight {
  std::int64_t light, square, light_slope, square_slope;
};

struct LevelBar;

class CrossArc {
 public:
  // False where the forms cannot be told well enough.
  [[nodiscard]] bool make(const CrossLine& line, const ArcEnd& a, const ArcEnd& b, const Lighting& lighting);
  // From N at A, at T and at B, and 2 kappa sA, 2 kappa (sA + sB): 1 and 2 where tau itself goes evenly from A to B.
  [[nodiscard]] bool make(const RealVector& na, const RealVector& nt, const RealVector& nb,
                          const std::array<BoundedReal, 2>& places, const Lighting& lighting);

  [[nodiscard]] ArcLight at(std::uint32_t tau) const;
  [[nodiscard]] std::int32_t place(std::uint32_t tau) const;
  // Whether the two below may be told at all: not where it is the same everywhere.
  [[nodiscard]] bool has_slope() const { return slope_error_ < most_error; }
  // Of the intensity's slope; 0 where it is not certain.
  [[nodiscard]] int rise(std::uint32_t tau) const;
  // Places change by less than 2^(3 + steepness_bits) of tau.
  [[nodiscard]] int steepness_bits() const {
    return std::max(0, static_cast<int>(std::bit_width(static_cast<std::uint64_t>(weight_))) - 31);
  }
  // What L^2 - t^2 |N|^2 must exceed.
  [[nodiscard]] std::int64_t unsure() const { return unsure_; }
  // An upper bound of how often the intensity turns from a to b; `many` where it cannot be told.
  [[nodiscard]] int turns(std::uint32_t a, std::uint32_t b) const;
  static constexpr int many = 9;
  // The sign of a level's excess if it is sure to be the same on the whole arc, as where a cone is lit along its axis; else 0.
  [[nodiscard]] int sign_of_excess(const LevelBar& bar) const;

  static constexpr std::int64_t most_error = std::int64_t{1} << 40;  // of forms

 private:
  [[nodiscard]] std::int64_t blossom(std::uint32_t a, std::uint32_t b, int of_b) const;
  [[nodiscard]] int sign_of_excess(const LevelBar& bar, const std::array<std::int64_t, 3>& light,
                                   const std::array<std::int64_t, 5>& square) const;

  std::array<std::int64_t, 3> light_{};             // powers of tau
  std::array<std::int64_t, 5> square_{}, slope_{};  // the latter w
  std::array<std::int64_t, 5> slope_points_{};      // w in Bernstein form
  std::int64_t unsure_ = 0, slope_error_ = 0;
  std::int64_t weight_a_ = 0, weight_ = 0;  // 2 kappa sA, 2 kappa (sA + sB): 2^-30
};

// L^2 - t^2 |N|^2 with L's sign, and Newton's step towards its zero.
struct LevelBar {
  std::int64_t square = 0;     // t^2, 2^-60
  std::int32_t threshold = 0;  // t, 2^-30

  [[nodiscard]] std::int64_t excess(const ArcLight& at) const;
  [[nodiscard]] std::int64_t slope(const ArcLight& at) const;  // 2^-58
  [[nodiscard]] std::int64_t step(const ArcLight& at, std::int64_t excess) const;
};
}  // namespace halfspace
