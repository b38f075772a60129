// quotient_ridge.hpp - where along a scan line a face whose z is a quotient grows lighter: the sign of the quartic
//   w = L' |N|^2 - L (|N|^2)' / 2 = sum over i of N_i (L' N_i - L N_i')
// L and N_i are of second degree in tau, and so is L' N_i - L N_i', as the cubes cancel. Its Bernstein coefficients between two dots, which are
// its polar form's values there, tell how often it can vanish (ridge_form.hpp).
// Units   tau = t 2^-half_bits in [-1, 1]; every quantity has 30 bits of fraction. On each line L and N are scaled to fill them.
// Errors  of w and its polar form: quotient_ridge.cpp.
// Source  Farin, Curves and Surfaces for CAGD: blossoms, variation diminution. The form is ours.
#pragma once

#include <array>
#include <cstdint>

#include "firmware/core/quotient_forms.hpp"
#include "firmware/core/ridge_form.hpp"

namespace halfspace {

class QuotientRidge {
 public:
  // A dot of the line.
  struct Dot {
    std::int32_t tau, w;
    // Of dI/dx: -1, 0 for unsure, 1.
    [[nodiscard]] int sign() const { return w > form_error ? 1 : w < -form_error ? -1 : 0; }
  };

  explicit QuotientRidge(const QuotientLine& line);

  [[nodiscard]] Dot at(std::int32_t t) const;
  // Between a < b: monotone, or with exactly one turn (`ridge`, be it of most or of least intensity).
  [[nodiscard]] Course course(const Dot& a, const Dot& b) const;

 private:
  static constexpr std::int32_t form_error = 64, polar_error = 128;
  using Quartic = std::array<std::int32_t, 5>;

  int tau_shift_;
  Quartic w_;      // by powers of tau
  Quartic polar_;  // each over its binomial
};

}  // namespace halfspace
