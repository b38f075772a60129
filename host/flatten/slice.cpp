#include "host/flatten/slice.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace halfspace {
namespace {

// a w^2 + b w + c with polynomials in v; a is a constant.
struct Section {
  mpz_class a;
  Polynomial b, c;
};

// Times 2^(2 shift).
Section section_of(const SliceForm& form, const Dyadic& at) {
  const auto& q = form.q;
  const mpz_class& u = at.number;
  const mpz_class one = mpz_class(1) << at.shift;
  return {q[2] * one * one,
          {(q[5] * u + q[8] * one) * one, q[4] * one * one},
          {q[0] * u * u + (q[6] * u + q[9] * one) * one, (q[3] * u + q[7] * one) * one, q[1] * one * one}};
}

Polynomial scaled(const Polynomial& p, const mpz_class& factor) { return times(p, {factor}); }

// Vanishes where the conic turns, or runs to infinity.
Polynomial turns_of(const Section& s) {
  if (sgn(s.a) != 0) return minus(times(s.b, s.b), scaled(s.c, 4 * s.a));
  return degree(s.b) >= 0 ? s.b : s.c;
}

// The resultant in w.
Polynomial meetings_of(const Section& s, const Section& t) {
  Polynomial bc = minus(times(s.b, t.c), times(t.b, s.c));
  if (sgn(s.a) == 0 && sgn(t.a) == 0) return bc;
  const Polynomial ac = minus(scaled(t.c, s.a), scaled(s.c, t.a));
  const Polynomial ab = minus(scaled(t.b, s.a), scaled(s.b, t.a));
  return minus(times(ac, ac), times(ab, bc));
}

struct Span {
  mpz_class low, high;  // positions
};
using Spans = std::vector<Span>;

// The section is searched where |v| and |w| are no larger than this, far outside the body's frame. Beyond, the noise of coefficients
// (2^-105) grows with the square of the distance, and a plane taken twice opens into a wedge.
constexpr int window = 16;

const mpz_class& far() {
  static const mpz_class position = mpz_class(window) << position_bits;
  return position;
}

// Vanishes where the conic crosses the window's side at w.
Polynomial side_of(const Section& s, int w) { return plus(plus(s.c, scaled(s.b, w)), {s.a * w * w}); }

void append(Spans& spans, mpz_class low, mpz_class high) { spans.push_back({std::move(low), std::move(high)}); }

Spans all_or_none(bool all) {
  Spans result;
  if (all) append(result, -far(), far());
  return result;
}

// Where slope w + constant < 0.
Spans negative_ray(const mpz_class& slope, const mpz_class& constant) {
  if (sgn(slope) == 0) return all_or_none(sgn(constant) < 0);
  const mpz_class root = -(constant << position_bits) / slope;
  Spans result;
  sgn(slope) > 0 ? append(result, -far(), root) : append(result, root, far());
  return result;
}

// Where c2 w^2 + c1 w + c0 < 0.
Spans negative_part(const mpz_class& c2, const mpz_class& c1, const mpz_class& c0) {
  if (sgn(c2) == 0) return negative_ray(c1, c0);
  const mpz_class d = c1 * c1 - 4 * c2 * c0;
  if (sgn(d) <= 0) return all_or_none(sgn(c2) < 0);
  const mpz_class root = sqrt(mpz_class(d << (2 * position_bits)));
  const mpz_class middle = -(c1 << position_bits);
  mpz_class one = (middle - root) / (2 * c2);
  mpz_class other = (middle + root) / (2 * c2);
  Spans result;
  if (sgn(c2) > 0) {
    append(result, std::move(one), std::move(other));
  } else {
    append(result, -far(), std::move(other));
    append(result, std::move(one), far());
  }
  return result;
}

Spans common_part(const Spans& a, const Spans& b) {
  constexpr int least_width = 8;  // roots are off by two at most
  Spans result;
  for (const Span& s : a) {
    for (const Span& t : b) {
      Span both{std::max(s.low, t.low), std::min(s.high, t.high)};
      if (both.high - both.low > least_width) result.push_back(std::move(both));
    }
  }
  return result;
}

bool meets_line(const std::vector<Section>& sections, const Dyadic& v) {
  const mpz_class one = mpz_class(1) << v.shift;
  Spans left = all_or_none(true);
  for (const Section& s : sections) {
    left = common_part(left, negative_part(s.a * one * one, (s.b[1] * v.number + s.b[0] * one) * one,
                                           (s.c[2] * v.number + s.c[1] * one) * v.number + s.c[0] * one * one));
    if (left.empty()) return false;
  }
  return true;
}

}  // namespace

bool meets_plane(std::span<const SliceForm> forms, const Dyadic& u) {
  std::vector<Section> sections;
  for (const SliceForm& form : forms) sections.push_back(section_of(form, u));
  std::vector<Polynomial> marks;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    marks.push_back(turns_of(sections[i]));
    for (const int w : {-window, window}) marks.push_back(side_of(sections[i], w));
    for (std::size_t j = 0; j < i; ++j) marks.push_back(meetings_of(sections[i], sections[j]));
  }
  const RootGaps gaps(marks, -far(), far());
  for (std::size_t i = 0; i < gaps.count(); ++i) {
    if (!gaps.is_empty(i) && meets_line(sections, gaps.inside(i))) return true;
  }
  return false;
}

}  // namespace halfspace
