#include "host/resolve/root_marks.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace halfspace {
namespace {

// A polynomial on whole lines, in doubles: what they tell is certain.
// Rounding  All coefficients are divided by one power of two, so that they are at most 1. A value and a Taylor coefficient are sums whose terms
//           pass at most 2 degree + 2 roundings of 2^-53, the coefficient's own counted twice: up to degree 30 they are within 2^-47 of
//           the sum of sizes. What underflows is below 2^-1074 2^(40 degree). Where a size overflows, nothing is certain.
class InDoubles {
 public:
  explicit InDoubles(const Polynomial& p) {
    std::size_t bits = 0;
    for (const mpz_class& c : p) bits = std::max(bits, mpz_sizeinbase(c.get_mpz_t(), 2));
    for (const mpz_class& c : p) {
      long own = 0;
      const double mantissa = mpz_get_d_2exp(&own, c.get_mpz_t());
      c_.push_back(std::ldexp(mantissa, static_cast<int>(std::max(own - static_cast<long>(bits), -4000L))));
    }
    if (c_.size() > 20) c_.clear();
  }

  // 0: not certain.
  [[nodiscard]] int sign_at(std::int64_t line) const {
    if (!is_near(line)) return 0;
    const auto y = static_cast<double>(line);
    double value = 0;
    double size = 0;
    for (std::size_t i = c_.size(); i-- > 0;) {
      value = value * y + c_[i];
      size = size * std::abs(y) + std::abs(c_[i]);
    }
    if (!(std::abs(value) > margin(size))) return 0;
    return value < 0 ? -1 : 1;
  }

  // No zero on (i, i + 1)? See may_vanish_after.
  [[nodiscard]] bool stays_apart_after(std::int64_t line) const {
    if (!is_near(line)) return false;
    const auto y = static_cast<double>(line);
    std::vector<double> t = c_;
    std::vector<double> size;
    for (const double c : c_) size.push_back(std::abs(c));
    for (std::size_t i = 0; i + 1 < t.size(); ++i) {
      for (std::size_t j = t.size() - 1; j-- > i;) {
        t[j] += t[j + 1] * y;
        size[j] += size[j + 1] * std::abs(y);
      }
    }
    double nearest = std::abs(t[0]) - margin(size[0]);
    for (std::size_t k = 1; k < t.size(); ++k) {
      const double against = t[0] < 0 ? t[k] : -t[k];
      nearest -= std::max(0.0, against) + margin(size[k]);
    }
    return nearest > 0;
  }

 private:
  // Twice what is off, so that the sums above may be rounded too.
  static double margin(double size) { return size * 0x1p-46 + 0x1p-200; }
  [[nodiscard]] bool is_near(std::int64_t line) const { return !c_.empty() && std::abs(line) < std::int64_t{1} << 40; }

  std::vector<double> c_;
};

// The same, exactly where doubles do not tell.
int sign_on_line(const Polynomial& p, const InDoubles& near, std::int64_t line) {
  const int certain = near.sign_at(line);
  return certain != 0 ? certain : sgn(value_at(p, static_cast<long>(line)));
}

// May p vanish on (i, i + 1)? With t = y - i in [0, 1] every term t^k lies between 0 and 1, which bounds p from 0.
bool may_vanish_after(const Polynomial& p, const InDoubles& near, std::int64_t i) {
  if (near.stays_apart_after(i)) return false;
  const Polynomial t = shifted(p, static_cast<long>(i));
  const int side = sgn(t[0]);
  mpz_class nearest = abs(t[0]);
  for (std::size_t k = 1; k < t.size(); ++k) {
    if (sgn(t[k]) == -side) nearest -= abs(t[k]);
  }
  return sgn(nearest) <= 0;
}

// The root of p in [from, to], where p is strictly monotone.
void mark_monotone_run(const Polynomial& p, const InDoubles& near, std::int64_t from, std::int64_t to,
                       std::vector<Mark>& marks) {
  if (from > to) return;
  const int before = sign_on_line(p, near, from);
  if (before == 0) return marks.push_back(2 * from);
  const int after = sign_on_line(p, near, to);
  if (after == 0) return marks.push_back(2 * to);
  if (before == after) return;
  while (to - from > 1) {
    const std::int64_t middle = from + (to - from) / 2;
    const int sign = sign_on_line(p, near, middle);
    if (sign == 0) return marks.push_back(2 * middle);
    (sign == before ? from : to) = middle;
  }
  marks.push_back(2 * from + 1);
}

// y^i * coefficient lists of a curve read as a2 x^2 + a1(y) x + a0(y).
struct InPowersOfX {
  Polynomial a2, a1, a0;
  explicit InPowersOfX(const Curve& p) : a2{p.q[0]}, a1{p.q[3], p.q[1]}, a0{p.q[5], p.q[4], p.q[2]} {}
};

int degree_in_x(const Curve& p) {
  if (sgn(p.q[0]) != 0) return 2;
  return sgn(p.q[1]) != 0 || sgn(p.q[3]) != 0 ? 1 : 0;
}

// Substitutes the root x = -a0/a1 of the first curve into the second.
Polynomial eliminate_linear(const InPowersOfX& l, const InPowersOfX& q) {
  const Polynomial squares = plus(times(q.a2, times(l.a0, l.a0)), times(q.a0, times(l.a1, l.a1)));
  return minus(squares, times(q.a1, times(l.a0, l.a1)));
}

// The resultant of two polynomials of second order in x.
Polynomial eliminate(const InPowersOfX& p, const InPowersOfX& q) {
  const Polynomial outer = minus(times(p.a2, q.a0), times(p.a0, q.a2));
  const Polynomial left = minus(times(p.a2, q.a1), times(p.a1, q.a2));
  const Polynomial right = minus(times(p.a1, q.a0), times(p.a0, q.a1));
  return minus(times(outer, outer), times(left, right));
}

}  // namespace

std::vector<Mark> root_marks(Polynomial p, std::int64_t first, std::int64_t last) {
  while (!p.empty() && sgn(p.back()) == 0) p.pop_back();
  if (p.size() <= 1) return {};
  const InDoubles near(p);
  std::vector<Mark> marks;
  std::int64_t from = first;
  for (const Mark turn :
       root_marks(derivative(p), first, last)) {  // recursion ends: the degree falls, at most to 0 from 4
    const bool on_line = turn % 2 == 0;
    const std::int64_t line = on_line ? turn / 2 : (turn - 1) / 2;
    mark_monotone_run(p, near, from, line, marks);
    if (!on_line && may_vanish_after(p, near, line)) marks.push_back(turn);
    from = on_line ? line : line + 1;
  }
  mark_monotone_run(p, near, from, last, marks);
  std::sort(marks.begin(), marks.end());
  marks.erase(std::unique(marks.begin(), marks.end()), marks.end());
  return marks;
}

Polynomial turning_lines(const Curve& p) {
  const InPowersOfX in_x(p);
  switch (degree_in_x(p)) {
    case 2:
      return minus(times(in_x.a1, in_x.a1), times({4}, times(in_x.a2, in_x.a0)));
    case 1:
      return in_x.a1;
    default:
      return in_x.a0;
  }
}

Polynomial meeting_lines(const Curve& p, const Curve& q) {
  const int degree_p = degree_in_x(p);
  const int degree_q = degree_in_x(q);
  if (degree_p == 0 || degree_q == 0) return {};  // its turning lines hold all its points
  const InPowersOfX in_p(p);
  const InPowersOfX in_q(q);
  if (degree_p == 1 && degree_q == 1) return minus(times(in_p.a1, in_q.a0), times(in_p.a0, in_q.a1));
  if (degree_p == 1) return eliminate_linear(in_p, in_q);
  if (degree_q == 1) return eliminate_linear(in_q, in_p);
  return eliminate(in_p, in_q);
}

}  // namespace halfspace
