#include "host/resolve/quartic.hpp"

#include <flint/fmpz_mpoly.h>
#include <flint/fmpz_mpoly_factor.h>
#include <flint/nmod_poly.h>

#include <algorithm>
#include <array>

#include "host/resolve/curve_algebra.hpp"

namespace halfspace {
namespace {

// Polynomials in x, y, in this order.
const fmpz_mpoly_ctx_struct* plane() {
  static const struct Context {
    fmpz_mpoly_ctx_t ring;
    Context() { fmpz_mpoly_ctx_init(ring, 2, ORD_LEX); }
    ~Context() { fmpz_mpoly_ctx_clear(ring); }
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
  } context;
  return context.ring;
}

// A polynomial in FLINT's keeping.
class PlanePolynomial {
 public:
  PlanePolynomial() { fmpz_mpoly_init(p_, plane()); }
  explicit PlanePolynomial(const QuarticForm& form) : PlanePolynomial() {
    fmpz_t c;
    fmpz_init(c);
    for (ulong i = 0; i <= 4; ++i) {
      for (ulong j = 0; i + j <= 4; ++j) {
        const std::array<ulong, 2> powers{i, j};
        fmpz_set_mpz(c, form.q[quartic_index(i, j)].get_mpz_t());
        fmpz_mpoly_set_coeff_fmpz_ui(p_, c, powers.data(), plane());
      }
    }
    fmpz_clear(c);
  }
  PlanePolynomial(const PlanePolynomial&) = delete;
  PlanePolynomial& operator=(const PlanePolynomial&) = delete;
  ~PlanePolynomial() { fmpz_mpoly_clear(p_, plane()); }

  [[nodiscard]] fmpz_mpoly_struct* get() { return p_; }
  [[nodiscard]] mpz_class coefficient(ulong i, ulong j) const {
    fmpz_t c;
    fmpz_init(c);
    const std::array<ulong, 2> powers{i, j};
    fmpz_mpoly_get_coeff_fmpz_ui(c, p_, powers.data(), plane());
    mpz_class value;
    fmpz_get_mpz(value.get_mpz_t(), c);
    fmpz_clear(c);
    return value;
  }
  // In powers of y, of a polynomial without x.
  [[nodiscard]] Polynomial in_y() const {
    Polynomial result;
    const slong order = fmpz_mpoly_degree_si(p_, 1, plane());
    for (slong j = 0; j <= order; ++j) result.push_back(coefficient(0, static_cast<ulong>(j)));
    return result;
  }

 private:
  fmpz_mpoly_t p_;
};

Curve as_curve(const QuarticForm& p) {
  const auto& q = p.q;
  return {{q[quartic_index(2, 0)], q[quartic_index(1, 1)], q[quartic_index(0, 2)], q[quartic_index(1, 0)],
           q[quartic_index(0, 1)], q[quartic_index(0, 0)]}};
}

// The coefficient of x^i, in powers of y.
Polynomial coefficient_of(const QuarticForm& p, std::size_t i) {
  Polynomial c;
  for (std::size_t j = 0; i + j <= 4; ++j) c.push_back(p.q[quartic_index(i, j)]);
  return trimmed(c);
}

std::size_t degree_in_x(const QuarticForm& p) {
  std::size_t i = 4;
  while (i > 0 && coefficient_of(p, i).empty()) --i;
  return i;
}

// On some line modulo a prime, where its degree in x stays four: a product of forms would be one there, as x^4 leaves no factor without x.
// A form without factors has none on one line in four.
bool is_surely_irreducible(const QuarticForm& p) {
  constexpr ulong prime = 251;
  constexpr ulong lines = 8;
  std::array<ulong, 15> q{};
  std::transform(p.q.begin(), p.q.end(), q.begin(),
                 [](const mpz_class& c) { return mpz_fdiv_ui(c.get_mpz_t(), prime); });
  if (q[quartic_index(4, 0)] == 0) return false;
  nmod_poly_t on_line;
  nmod_poly_init(on_line, prime);
  bool found = false;
  for (ulong y = 0; y < lines && !found; ++y) {
    nmod_poly_zero(on_line);
    for (std::size_t i = 5; i-- > 0;) {
      ulong c = 0;
      for (std::size_t j = 5 - i; j-- > 0;) c = (c * y + q[quartic_index(i, j)]) % prime;
      nmod_poly_set_coeff_ui(on_line, static_cast<slong>(i), c);
    }
    found = nmod_poly_is_irreducible(on_line) != 0;
  }
  nmod_poly_clear(on_line);
  return found;
}

Polynomial scaled(int factor, Polynomial p) {
  for (mpz_class& c : p) c *= factor;
  return p;
}

// Of order two or more in x, up to a constant, by the coefficients of 1, x .. x^4; of order three times the square of the first coefficient. For
// order four by its seminvariants, 27 D = 4 i^3 - j^2.
template <class Coefficients>
Coefficients discriminant(const std::array<Coefficients, 5>& in_x, bool second_order) {
  const auto& [e, d, c, b, a] = in_x;
  if (second_order) return minus(times(d, d), scaled(4, times(c, e)));
  const Coefficients cc = times(c, c);
  const Coefficients ae = times(a, e);
  const Coefficients i = minus(plus(cc, scaled(12, ae)), scaled(3, times(b, d)));
  const Coefficients j =
      minus(times(c, plus(scaled(72, ae), scaled(9, times(b, d)))),
            plus(scaled(27, plus(times(a, times(d, d)), times(e, times(b, b)))), scaled(2, times(c, cc))));
  return minus(scaled(4, times(i, times(i, i))), times(j, j));
}

std::array<Polynomial, 5> in_powers_of_x(const QuarticForm& p) {
  return {coefficient_of(p, 0), coefficient_of(p, 1), coefficient_of(p, 2), coefficient_of(p, 3), coefficient_of(p, 4)};
}

// All divided by the same power of two.
std::array<IntervalPolynomial, 5> enclosed_in_powers_of_x(const QuarticForm& p) {
  std::size_t bits = 0;
  for (const mpz_class& c : p.q) bits = std::max(bits, mpz_sizeinbase(c.get_mpz_t(), 2));
  std::array<IntervalPolynomial, 5> in_x;
  for (std::size_t i = 0; i <= 4; ++i) {
    for (std::size_t j = 0; i + j <= 4; ++j) {
      const mpz_class& c = p.q[quartic_index(i, j)];
      in_x[i].c[j] = enclosure(c, static_cast<long>(bits));
      if (sgn(c) != 0) in_x[i].size = j + 1;
    }
  }
  return in_x;
}

void append_factor(const PlanePolynomial& factor, PlaneFactors& found) {
  QuarticForm form;
  for (ulong i = 0; i <= 4; ++i) {
    for (ulong j = 0; i + j <= 4; ++j) form.q[quartic_index(i, j)] = factor.coefficient(i, j);
  }
  make_canonical(form);
  if (degree_of(form) > 2) {
    found.quartics.push_back(std::move(form));
  } else {
    found.curves.push_back(as_curve(form));
  }
}

constexpr std::array<std::array<std::size_t, 2>, 6> curve_powers{{{2, 0}, {1, 1}, {0, 2}, {1, 0}, {0, 1}, {0, 0}}};

}  // namespace

QuarticForm as_quartic(const Curve& p) {
  QuarticForm form;
  for (std::size_t k = 0; k < 6; ++k) form.q[quartic_index(curve_powers[k][0], curve_powers[k][1])] = p.q[k];
  return form;
}

QuarticForm product(const Curve& p, const Curve& q) {
  QuarticForm form;
  for (std::size_t k = 0; k < 6; ++k) {
    if (sgn(p.q[k]) == 0) continue;
    for (std::size_t l = 0; l < 6; ++l) {
      form.q[quartic_index(curve_powers[k][0] + curve_powers[l][0], curve_powers[k][1] + curve_powers[l][1])] +=
          p.q[k] * q.q[l];
    }
  }
  return form;
}

QuarticForm operator+(QuarticForm p, const QuarticForm& q) {
  for (std::size_t i = 0; i < p.q.size(); ++i) p.q[i] += q.q[i];
  return p;
}

QuarticForm operator-(QuarticForm p, const QuarticForm& q) {
  for (std::size_t i = 0; i < p.q.size(); ++i) p.q[i] -= q.q[i];
  return p;
}

QuarticForm operator*(const mpz_class& factor, QuarticForm p) {
  for (mpz_class& c : p.q) c *= factor;
  return p;
}

bool is_zero(const QuarticForm& p) {
  return std::all_of(p.q.begin(), p.q.end(), [](const mpz_class& c) { return sgn(c) == 0; });
}

std::size_t degree_of(const QuarticForm& p) {
  for (std::size_t n = 4; n > 0; --n) {
    for (std::size_t j = 0; j <= n; ++j) {
      if (sgn(p.q[quartic_index(n - j, j)]) != 0) return n;
    }
  }
  return 0;
}

Polynomial restricted(const QuarticForm& p, long y) {
  Polynomial f(5);
  for (std::size_t i = 0; i <= 4; ++i) {
    f[i] = p.q[quartic_index(i, 4 - i)];
    for (std::size_t j = 4 - i; j-- > 0;) times_plus(f[i], y, p.q[quartic_index(i, j)]);
  }
  return f;
}

QuarticForm from_line(QuarticForm p, const mpz_class& start) {
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k + i < 4; ++k) {
      for (std::size_t j = 4 - i; j-- > k;) add_product(p.q[quartic_index(i, j)], p.q[quartic_index(i, j + 1)], start);
    }
  }
  return p;
}

Polynomial along(const QuarticForm& p, const mpz_class& at, const mpz_class& step, const mpz_class& denominator) {
  const std::size_t order = degree_of(p);
  Polynomial sum(order + 1);
  mpz_class scale = 1;
  for (std::size_t i = order + 1; i-- > 0;) {  // Horner's scheme in x
    const std::size_t rest = order - i;
    for (std::size_t k = rest; k > 0; --k) {
      sum[k] *= at;
      add_product(sum[k], sum[k - 1], step);
    }
    sum[0] *= at;
    for (std::size_t j = 0; j <= rest; ++j) add_product(sum[j], scale, p.q[quartic_index(i, j)]);
    scale *= denominator;
  }
  return sum;
}

void make_canonical(QuarticForm& p) {
  mpz_class divisor = 0;
  for (const mpz_class& c : p.q) divisor = gcd(divisor, c);
  const auto leading = std::find_if(p.q.begin(), p.q.end(), [](const mpz_class& c) { return sgn(c) != 0; });
  if (leading == p.q.end()) return;
  if (sgn(*leading) < 0) divisor = -divisor;
  for (mpz_class& c : p.q) mpz_divexact(c.get_mpz_t(), c.get_mpz_t(), divisor.get_mpz_t());
}

PlaneFactors factors(const QuarticForm& p) {
  PlaneFactors found;
  if (degree_of(p) <= 2) {
    append_factors(as_curve(p), found.curves);
    return found;
  }
  if (is_surely_irreducible(p)) {
    found.quartics.push_back(p);
    return found;
  }
  PlanePolynomial whole(p);
  fmpz_mpoly_factor_t parts;
  fmpz_mpoly_factor_init(parts, plane());
  fmpz_mpoly_factor(parts, whole.get(), plane());
  for (slong i = 0; i < fmpz_mpoly_factor_length(parts, plane()); ++i) {
    PlanePolynomial part;
    fmpz_mpoly_factor_get_base(part.get(), parts, i, plane());
    append_factor(part, found);
  }
  fmpz_mpoly_factor_clear(parts, plane());
  return found;
}

std::vector<Mark> turn_marks(const QuarticForm& p, std::int64_t first, std::int64_t last,
                             const std::vector<Mark>& nodes) {
  const std::size_t order = degree_in_x(p);
  std::vector<Mark> marks = root_marks(coefficient_of(p, order), first, last);
  if (order <= 1) return marks;
  const bool second_order = order == 2;
  const std::vector<Mark> turns = root_marks(
      discriminant(enclosed_in_powers_of_x(p), second_order),
      [&] { return discriminant(in_powers_of_x(p), second_order); }, first, last, nodes);
  marks.insert(marks.end(), turns.begin(), turns.end());
  return marks;
}

Polynomial meeting_lines(const QuarticForm& p, const QuarticForm& q) {
  if (degree_in_x(p) == 0 || degree_in_x(q) == 0) return {};  // its turning lines hold all its points
  PlanePolynomial a(p);
  PlanePolynomial b(q);
  PlanePolynomial resultant;
  fmpz_mpoly_resultant(resultant.get(), a.get(), b.get(), 0, plane());
  return resultant.in_y();
}

}  // namespace halfspace
