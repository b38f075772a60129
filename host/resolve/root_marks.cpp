#include "host/resolve/root_marks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace halfspace {
namespace {

// A polynomial on whole lines, in doubles: what they tell is certain.
// Rounding  Coefficients are at most 1, or not far above it. A value and a Taylor coefficient are sums whose terms pass at most 2 degree + 2
//           roundings of 2^-53: up to degree 30 they are within 2^-47 of the sum of sizes, and a coefficient is off by half its interval's
//           width. `error` holds twice what is off, so that the sums may be rounded too. What underflows is below 2^-1074 2^(24 degree).
//           Where a size overflows, nothing is certain.
class InDoubles {
 public:
  explicit InDoubles(const IntervalPolynomial& p) : size_(p.size) {
    for (std::size_t i = 0; i < size_; ++i) {
      c_[i] = (p.c[i].low + p.c[i].high) / 2;
      error_[i] = std::abs(c_[i]) * 0x1p-46 + (p.c[i].high - p.c[i].low);
    }
  }

  // 0: not certain.
  [[nodiscard]] int sign_at(std::int64_t line) const {
    if (!is_near(line)) return 0;
    const auto y = static_cast<double>(line);
    double value = 0;
    double error = 0;
    for (std::size_t i = size_; i-- > 0;) {
      value = value * y + c_[i];
      error = error * std::abs(y) + error_[i];
    }
    if (!(std::abs(value) > error + least)) return 0;
    return value < 0 ? -1 : 1;
  }

  // No zero on (i, i + 1)? With t = y - i in [0, 1] every term t^k lies between 0 and 1, which bounds the value from 0.
  [[nodiscard]] bool stays_apart_after(std::int64_t line) const {
    if (!is_near(line)) return false;
    const auto y = static_cast<double>(line);
    Coefficients t = c_;
    Coefficients error = error_;
    for (std::size_t i = 0; i + 1 < size_; ++i) {
      for (std::size_t j = size_ - 1; j-- > i;) {
        t[j] += t[j + 1] * y;
        error[j] += error[j + 1] * std::abs(y);
      }
    }
    double nearest = std::abs(t[0]) - error[0] - least;
    for (std::size_t k = 1; k < size_; ++k) {
      const double against = t[0] < 0 ? t[k] : -t[k];
      nearest -= std::max(0.0, against) + error[k] + least;
    }
    return nearest > 0;
  }

 private:
  using Coefficients = std::array<double, IntervalPolynomial::capacity>;
  static constexpr double least = 0x1p-500;
  [[nodiscard]] bool is_near(std::int64_t line) const { return size_ > 0 && std::abs(line) < std::int64_t{1} << 24; }

  Coefficients c_{}, error_{};
  std::size_t size_;
};

// A polynomial or one of its derivatives: in intervals, and exactly once that is asked for.
class AskedOnLines {
 public:
  AskedOnLines(const IntervalPolynomial& near, std::function<Polynomial()> make)
      : near_(near), in_doubles_(near), make_(std::move(make)) {}

  [[nodiscard]] std::size_t size() const { return near_.size; }
  [[nodiscard]] AskedOnLines slope() {
    return {derivative(near_), [this] { return derivative(exact()); }};
  }

  [[nodiscard]] int sign_at(std::int64_t line) {
    int certain = in_doubles_.sign_at(line);
    if (certain == 0 && !exact_) {
      (void)exact();
      certain = in_doubles_.sign_at(line);
    }
    return certain != 0 ? certain : sgn(value_at(exact(), static_cast<long>(line)));
  }

  // May it vanish on (i, i + 1)? With t = y - i in [0, 1] every term t^k lies between 0 and 1, which bounds it from 0.
  [[nodiscard]] bool may_vanish_after(std::int64_t i) {
    if (in_doubles_.stays_apart_after(i)) return false;
    const Polynomial t = shifted(exact(), static_cast<long>(i));
    const int side = sgn(t[0]);
    mpz_class nearest = abs(t[0]);
    for (std::size_t k = 1; k < t.size(); ++k) {
      if (sgn(t[k]) == -side) nearest -= abs(t[k]);
    }
    return sgn(nearest) <= 0;
  }

 private:
  [[nodiscard]] const Polynomial& exact() {
    if (!exact_) {
      exact_ = make_();
      in_doubles_ = InDoubles(enclosed(*exact_));
    }
    return *exact_;
  }

  IntervalPolynomial near_;
  InDoubles in_doubles_;
  std::function<Polynomial()> make_;
  std::optional<Polynomial> exact_;
};

// The root of p in [from, to], where p is strictly monotone.
void mark_monotone_run(AskedOnLines& p, std::int64_t from, std::int64_t to, std::vector<Mark>& marks) {
  if (from > to) return;
  const int before = p.sign_at(from);
  if (before == 0) return marks.push_back(2 * from);
  const int after = p.sign_at(to);
  if (after == 0) return marks.push_back(2 * to);
  if (before == after) return;
  while (to - from > 1) {
    const std::int64_t middle = from + (to - from) / 2;
    const int sign = p.sign_at(middle);
    if (sign == 0) return marks.push_back(2 * middle);
    (sign == before ? from : to) = middle;
  }
  marks.push_back(2 * from + 1);
}

bool contains(const std::vector<Mark>& marks, Mark mark) {
  return std::find(marks.begin(), marks.end(), mark) != marks.end();
}

std::vector<Mark> marks_of(AskedOnLines p, std::int64_t first, std::int64_t last, const std::vector<Mark>& known) {
  if (p.size() <= 1) return {};
  std::vector<Mark> marks;
  std::int64_t from = first;
  for (const Mark turn : marks_of(p.slope(), first, last, {})) {  // recursion ends: the degree falls
    const bool on_line = turn % 2 == 0;
    const std::int64_t line = on_line ? turn / 2 : (turn - 1) / 2;
    mark_monotone_run(p, from, line, marks);
    if (!on_line && (contains(known, turn) || p.may_vanish_after(line))) marks.push_back(turn);
    from = on_line ? line : line + 1;
  }
  mark_monotone_run(p, from, last, marks);
  std::sort(marks.begin(), marks.end());
  marks.erase(std::unique(marks.begin(), marks.end()), marks.end());
  return marks;
}

// y^i * coefficient lists of a curve read as a2 x^2 + a1(y) x + a0(y).
template <class Coefficients>
struct InPowersOfX {
  Coefficients a2, a1, a0;
  template <class Form>
  explicit InPowersOfX(const Form& p) : a2{p.q[0]}, a1{p.q[3], p.q[1]}, a0{p.q[5], p.q[4], p.q[2]} {}
};

bool is_zero(const mpz_class& c) { return sgn(c) == 0; }
bool is_zero(const Interval& c) { return c.is_zero(); }

template <class Form>
int degree_in_x(const Form& p) {
  if (!is_zero(p.q[0])) return 2;
  return !is_zero(p.q[1]) || !is_zero(p.q[3]) ? 1 : 0;
}

// Substitutes the root x = -a0/a1 of the first curve into the second.
template <class Coefficients>
Coefficients eliminate_linear(const InPowersOfX<Coefficients>& l, const InPowersOfX<Coefficients>& q) {
  const Coefficients squares = plus(times(q.a2, times(l.a0, l.a0)), times(q.a0, times(l.a1, l.a1)));
  return minus(squares, times(q.a1, times(l.a0, l.a1)));
}

// The resultant of two polynomials of second order in x.
template <class Coefficients>
Coefficients eliminate(const InPowersOfX<Coefficients>& p, const InPowersOfX<Coefficients>& q) {
  const Coefficients outer = minus(times(p.a2, q.a0), times(p.a0, q.a2));
  const Coefficients left = minus(times(p.a2, q.a1), times(p.a1, q.a2));
  const Coefficients right = minus(times(p.a1, q.a0), times(p.a0, q.a1));
  return minus(times(outer, outer), times(left, right));
}

template <class Coefficients, class Form>
Coefficients meeting_lines_of(const Form& p, const Form& q) {
  const int degree_p = degree_in_x(p);
  const int degree_q = degree_in_x(q);
  if (degree_p == 0 || degree_q == 0) return {};  // its turning lines hold all its points
  const InPowersOfX<Coefficients> in_p(p);
  const InPowersOfX<Coefficients> in_q(q);
  if (degree_p == 1 && degree_q == 1) return minus(times(in_p.a1, in_q.a0), times(in_p.a0, in_q.a1));
  if (degree_p == 1) return eliminate_linear(in_p, in_q);
  if (degree_q == 1) return eliminate_linear(in_q, in_p);
  return eliminate(in_p, in_q);
}

}  // namespace

std::vector<Mark> root_marks(const Polynomial& p, std::int64_t first, std::int64_t last) {
  const Polynomial exact = trimmed(p);
  return marks_of({enclosed(exact), [&exact] { return Polynomial(exact); }}, first, last, {});
}

std::vector<Mark> root_marks(const IntervalPolynomial& near, const std::function<Polynomial()>& exact,
                             std::int64_t first, std::int64_t last, const std::vector<Mark>& multiple) {
  const bool knows_degree = near.size > 0 && !near.c[near.size - 1].may_vanish();
  return knows_degree ? marks_of({near, exact}, first, last, multiple) : root_marks(exact(), first, last);
}

Polynomial turning_lines(const Curve& p) {
  const InPowersOfX<Polynomial> in_x(p);
  switch (degree_in_x(p)) {
    case 2:
      return minus(times(in_x.a1, in_x.a1), times({4}, times(in_x.a2, in_x.a0)));
    case 1:
      return in_x.a1;
    default:
      return in_x.a0;
  }
}

Polynomial meeting_lines(const Curve& p, const Curve& q) { return meeting_lines_of<Polynomial>(p, q); }

IntervalPolynomial meeting_lines(const IntervalCurve& p, const IntervalCurve& q) {
  return meeting_lines_of<IntervalPolynomial>(p, q);
}

}  // namespace halfspace
