// ridge_form.hpp - where along a scan line a root face grows lighter: the sign of a form w = alpha(x) + beta(x) s.
//   With I = L / |N|, the sign of dI/dx is that of s (2 L' |N|^2 - L (|N|^2)'), where s' = D' / 2 s and s^2 = D:
//     beta  = 2 l' q - l q' + m (D' r / 2 - r' D)                          linear: the squares of x cancel
//     alpha = D (2 l' r - l r') + D' (m q - l r / 2) - m q' D              quadratic: the cubes cancel
//   From a to b the section s^2 = D is a rational Bezier arc with the control points A, T, B, where T is the pole of the chord.
//   With P the polar form of D and delta = P - s_a s_b = (ds^2 - D2 h^2) / 2, h = b - a, in homogeneous (x, s, 1)
//     T = s_b A + s_a B + (0, delta, 0), and the product of A's and B's weights is 2 (P + s_a s_b).
//   w is of second degree in (x, s, 1), so along the arc it is a quartic in Bernstein form, with the coefficients, up to
//   positive factors,
//     w_AA,  w_AT,  w_TT + (P + s_a s_b) w_AB,  w_TB,  w_BB
//   It has no more roots between a and b than these have changes of sign, and as many or an even number fewer.
// Scale   s_a, s_b and a root of delta are weights: all of them times c leaves the arc what it is. Where s is far below the largest of its
//         block the four products above are small, and what they err by is not; so the arc is scaled until the largest is near 1.
// Depth   By z in place of s (section_forms.hpp) the section is the conic C = a z^2 + 2 b z - c = 0, and with X = (x, z, 1), C and |N|^2 for
//         their symmetric matrices and L for its row
//     w = L . (C X x |N|^2 X) = alpha + beta z + gamma z^2         of second degree in X, so all of the above holds
//     T = s_b A + s_a B + (0, delta_z, 0),   delta_z = (2 b' h dz + a dz^2 - c2 h^2) / 2,   delta = a delta_z
// Units   tau = t 2^-half_bits in [-1, 1]; every quantity has 30 bits of fraction.
// Errors  Inputs are cut to within a unit, so alpha and beta are within 64, and w within plain_error + the root's (ridge_form.cpp).
// Source  Farin, Curves and Surfaces for CAGD: conics as rational quadratics, variation diminution. The forms are ours.
#pragma once

#include <array>
#include <cstdint>

#include "firmware/core/section_forms.hpp"

namespace halfspace {

// A dot of the section as the form needs it.
struct RidgeDot {
  std::int32_t s, tau;
  std::int32_t sigma;              // s or z
  std::int32_t w, slope;           // dw / dsigma
  std::int32_t root_error, error;  // of sigma in its own units, and of w
  // Of dI/dx: -1, 0 for unsure, 1.
  [[nodiscard]] int sign() const;
};

// What is known of the intensity between two dots.
enum class Course : std::uint8_t { unsure, rising, falling, ridge };
// From the signs of a quartic's five coefficients, 0 for unsure.
[[nodiscard]] Course course_of(const std::array<int, 5>& signs);

class RidgeForm {
 public:
  // Both outlive it. In words of 64 bits if so and they have more to tell.
  RidgeForm(const SectionForms& forms, const LineForms& line, bool wide);

  [[nodiscard]] RidgeDot at(std::int32_t t) const;
  // Between a < b: monotone, or with exactly one turn (`ridge`, be it of most or of least intensity).
  [[nodiscard]] Course course(const RidgeDot& a, const RidgeDot& b) const;

 private:
  // The weights of a section's arc between two dots, times a power of two.
  struct Arc {
    std::int32_t s_a, s_b, delta;
    std::int32_t bow;  // delta, or delta_z; of s or z as they are, so times the power once

    // `bend` is D2 h^2, 60 bits of fraction.
    Arc(std::int32_t at_a, std::int32_t at_b, std::int64_t bend)
        : s_a(at_a),
          s_b(at_b),
          delta(static_cast<std::int32_t>((std::int64_t{at_b - at_a} * (at_b - at_a) - bend) >> 31)),
          bow(delta) {}
    Arc(std::int32_t at_a, std::int32_t at_b, std::int32_t of_s, std::int32_t of_z)
        : s_a(at_a), s_b(at_b), delta(of_s), bow(of_z) {}
    // Half the product of its ends' weights, P + s_a s_b.
    [[nodiscard]] std::int64_t weight() const { return (std::int64_t{s_a} * s_b >> 29) + delta; }
  };

  void load(bool wide);
  void load_by_depth();
  void keep(const std::int64_t (&w)[6], int most_up);
  [[gnu::noinline]] void set_depth(RidgeDot& p, std::int32_t t) const;
  [[nodiscard]] std::int32_t beta_at(std::int32_t tau) const {
    return beta_[0] + static_cast<std::int32_t>(std::int64_t{beta_[1]} * tau >> 30);
  }
  [[nodiscard]] std::int32_t square_of_way(const RidgeDot& a, const RidgeDot& b) const;
  [[nodiscard]] std::int32_t w_between(const RidgeDot& a, const RidgeDot& b) const;
  [[nodiscard]] Course plain_course(const RidgeDot& a, const RidgeDot& b) const;
  [[nodiscard]] Course scaled_course(const RidgeDot& a, const RidgeDot& b) const;
  [[nodiscard]] Course depth_course(const RidgeDot& a, const RidgeDot& b) const;
  // What an arc errs by: its s, delta, and bow with what s makes of that.
  struct ArcErrors {
    std::int64_t root, delta, bow;
  };
  [[nodiscard]] Course course(const RidgeDot& a, const RidgeDot& b, const Arc& arc, const ArcErrors& errors) const;
  // From w's polar form and the errors of w_at and w_tb, and of the middle.
  [[nodiscard]] Course course(const RidgeDot& a, const RidgeDot& b, const Arc& arc, std::int32_t w_ab,
                              std::int64_t side_error, std::int64_t middle_error) const;

  const SectionForms& forms_;
  const LineForms& line_;
  int tau_shift_, root_shift_;
  std::int32_t form_error_;  // of w, where s is exact
  std::int32_t alpha_[3], beta_[2], gamma_ = 0;
};

}  // namespace halfspace
