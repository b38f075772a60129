// quartic.hpp - polynomials of degree up to four in (x, y): products, factors over the rationals, and where two curves meet.
// The type is that of the arcs (resolved_scene.hpp).
// Exact  Everything; no coefficient overflows.
// Cost   Factors, discriminants and resultants are FLINT's: a tenth to a third of a millisecond each.
#pragma once

#include <vector>

#include "host/algebra/polynomial.hpp"
#include "host/resolve/resolved_scene.hpp"
#include "host/resolve/root_marks.hpp"

namespace halfspace {

// The place of x^i y^j among a QuarticForm's coefficients.
[[nodiscard]] constexpr std::size_t quartic_index(std::size_t i, std::size_t j) {
  constexpr std::size_t first[] = {14, 12, 9, 5, 0};
  return first[i + j] + j;
}
static_assert(quartic_index(4, 0) == 0 && quartic_index(0, 4) == 4 && quartic_index(3, 0) == 5 &&
              quartic_index(1, 1) == 10 && quartic_index(0, 1) == 13 && quartic_index(0, 0) == 14);

[[nodiscard]] QuarticForm as_quartic(const Curve& p);
[[nodiscard]] QuarticForm product(const Curve& p, const Curve& q);
[[nodiscard]] QuarticForm operator+(QuarticForm p, const QuarticForm& q);
[[nodiscard]] QuarticForm operator-(QuarticForm p, const QuarticForm& q);
[[nodiscard]] QuarticForm operator*(const mpz_class& factor, QuarticForm p);

[[nodiscard]] bool is_zero(const QuarticForm& p);
[[nodiscard]] std::size_t degree_of(const QuarticForm& p);  // 0 for zero

// Divides by the content and makes the first coefficient that is not 0 positive.
void make_canonical(QuarticForm& p);

// On the scan line y, in powers of x.
[[nodiscard]] Polynomial restricted(const QuarticForm& p, long y);

// p(x, start + y).
[[nodiscard]] QuarticForm from_line(QuarticForm p, const mpz_class& start);

// denominator^n p(x, t), n its degree, on the line x = (at + step t) / denominator, in powers of t.
[[nodiscard]] Polynomial along(const QuarticForm& p, const mpz_class& at, const mpz_class& step,
                               const mpz_class& denominator);

// Factors of a canonical form that are irreducible over the rationals, each once, canonical.
struct PlaneFactors {
  std::vector<Curve> curves;          // of degree one and two
  std::vector<QuarticForm> quartics;  // of degree three and four
};
[[nodiscard]] PlaneFactors factors(const QuarticForm& p);

// Where the roots in x of an irreducible curve appear, meet or go to infinity, and where the curve holds a whole line y = const. `nodes`: marks
// of points where it crosses itself, as far as they are known.
[[nodiscard]] std::vector<Mark> turn_marks(const QuarticForm& p, std::int64_t first, std::int64_t last,
                                           const std::vector<Mark>& nodes);

// A polynomial that vanishes at every y where two curves without a common component meet.
[[nodiscard]] Polynomial meeting_lines(const QuarticForm& p, const QuarticForm& q);

}  // namespace halfspace
