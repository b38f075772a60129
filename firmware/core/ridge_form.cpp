#include "firmware/core/ridge_form.hpp"

#include <algorithm>
#include <array>

#include "firmware/core/real.hpp"

namespace halfspace {
namespace {

// Of w, where s is exact: alpha and beta within 64 each, and their sum's rounding; and where they were cut from 60 bits.
constexpr std::int32_t plain_error = 160, cut_error = 16;
constexpr int few_bits = 18, many_bits = 26;  // of alpha and beta
constexpr std::int32_t far_error = 1 << 30;   // of a dot of which nothing is known: w is smaller
constexpr int most_scale = 11;                // of the weights of an arc

// Product of two numbers of 30 bits of fraction, or 60.
std::int32_t times(std::int32_t a, std::int32_t b) { return static_cast<std::int32_t>(std::int64_t{a} * b >> 30); }
std::int64_t times(std::int64_t a, std::int64_t b) {
  const auto product = static_cast<std::int64_t>(high_product(magnitude(a) << 2, magnitude(b) << 2));
  return (a < 0) == (b < 0) ? product : -product;
}

// v 2^-shift, rounded down.
constexpr std::int64_t shifted_down(std::int64_t v, int shift) {
  return shift >= 0 ? v >> shift : v * (std::int64_t{1} << std::min(-shift, 62));
}
std::int32_t narrowed(std::int64_t v, int shift) { return static_cast<std::int32_t>(shifted_down(v, shift)); }
// Half of the sum of a c and b d.
std::int32_t mixed(std::int32_t a, std::int32_t c, std::int32_t b, std::int32_t d) {
  return static_cast<std::int32_t>((std::int64_t{a} * c + std::int64_t{b} * d) >> 31);
}
std::int32_t size(std::int32_t v) { return v < 0 ? -v : v; }
int bits(std::uint64_t v) { return static_cast<int>(std::bit_width(v)); }
int sure_sign(std::int64_t value, std::int64_t error) { return value > error ? 1 : value < -error ? -1 : 0; }

// A polynomial in tau: its terms at tau = 1.
struct Terms {
  std::int64_t c[3];

  Terms(const LinePolynomial& p, int half_bits) : c{p.v0, p.v1 * (1LL << half_bits), p.v2 * (1LL << 2 * half_bits)} {}
  [[nodiscard]] std::uint64_t size() const { return magnitude(c[0]) + magnitude(c[1]) + magnitude(c[2]); }
  template <class Int>
  [[nodiscard]] Int cut(int i, int shift) const {
    return static_cast<Int>(shifted_down(c[i], shift));
  }
};

}  // namespace

// An unsure one is harmless between different neighbours only: elsewhere
// it may hide two changes.
Course course_of(const std::array<int, 5>& signs) {
  if (signs[0] == 0 || signs[4] == 0) return Course::unsure;
  int changes = 0;
  int before = signs[0];
  for (std::size_t i = 1; i < 5; ++i) {
    if (signs[i] == 0) {
      if (signs[i + 1] == 0 || signs[i + 1] == before) return Course::unsure;
    } else if (signs[i] != before) {
      before = signs[i];
      ++changes;
    }
  }
  if (changes > 1) return Course::unsure;
  return changes == 1 ? Course::ridge : before > 0 ? Course::rising : Course::falling;
}

namespace {

// alpha and beta of a line from its forms, 30 or 60 bits of fraction: sizes of terms add up to at most 1 in D, to 1/2 in q and r, and to 1/4 in l and m: light and square may be scaled at will, D as s is. So no sum below reaches 1, nor do alpha, beta or w, nor
// w's polar form 2.
template <class Int>
struct SlopeForm {
  Int alpha[3], beta[2];
  int most_up;  // bits that terms were scaled up by

  SlopeForm(const Terms& d, const Terms& q, const Terms& r, const Terms& l, std::int64_t line_m, int root_shift) {
    constexpr int fraction = sizeof(Int) == 4 ? 30 : 60;
    const int d_shift = 60 - fraction + 2 * root_shift;
    const int q_shift = bits(q.size() + (r.size() >> (2 - root_shift))) + 1 - fraction;
    const int l_shift = bits(l.size() + (magnitude(line_m) << root_shift)) + 2 - fraction;
    most_up = -std::min({d_shift, q_shift, l_shift, 0});
    const Int d0 = d.cut<Int>(0, d_shift), d1 = d.cut<Int>(1, d_shift), d2 = d.cut<Int>(2, d_shift);
    const Int q0 = q.cut<Int>(0, q_shift), q1 = q.cut<Int>(1, q_shift), q2 = q.cut<Int>(2, q_shift);
    // 32 bits of fraction and 30 of s against |N|^2; and s is scaled
    const int r_shift = q_shift + 2 - root_shift;
    const Int r0 = r.cut<Int>(0, r_shift), r1 = r.cut<Int>(1, r_shift);
    const Int l0 = l.cut<Int>(0, l_shift), l1 = l.cut<Int>(1, l_shift);
    const auto m = static_cast<Int>(shifted_down(line_m, l_shift - root_shift));
    // 2 l' r - l r' = e + l1 r1 tau,  l r = p0 + p1 tau + l1 r1 tau^2
    const Int l0r1 = times(l0, r1);
    const Int l1r0 = times(l1, r0);
    const Int l1r1 = times(l1, r1);
    const Int e = 2 * l1r0 - l0r1;
    const Int p0 = times(l0, r0);
    const Int p1 = l0r1 + l1r0;
    beta[0] = 2 * times(l1, q0) - times(l0, q1) + times(m, times(d1, r0) / 2 - times(d0, r1));
    beta[1] = times(l1, q1) - 2 * times(l0, q2) + times(m, times(d2, r0) - times(d1, r1) / 2);
    alpha[0] = times(d0, e) - times(d1, p0) / 2 + times(m, times(d1, q0) - times(q1, d0));
    alpha[1] = times(d0, l1r1) + times(d1, e) - times(d1, p1) / 2 - times(d2, p0) +
               2 * times(m, times(d2, q0) - times(q2, d0));
    alpha[2] = times(d1, l1r1) / 2 + times(d2, e - p1) + times(m, times(d2, q1) - times(q2, d1));
  }
  [[nodiscard]] std::uint64_t size() const {
    return magnitude(alpha[0]) + magnitude(alpha[1]) + magnitude(alpha[2]) + magnitude(beta[0]) + magnitude(beta[1]);
  }
};

}  // namespace

int RidgeDot::sign() const { return sure_sign(w, error); }

RidgeForm::RidgeForm(const SectionForms& forms, const LineForms& line, bool wide)
    : forms_(forms), line_(line), tau_shift_(30 - line.half_bits), root_shift_(0) {
  if (line.by_depth) {
    load_by_depth();
  } else {
    load(wide);
  }
}

// Words of 32 bits where alpha and beta keep enough of them.
void RidgeForm::load(bool wide) {
  const int hb = line_.half_bits;
  const Terms d(line_.d, hb), q(line_.q, hb), r(line_.r, hb), l(line_.l, hb);
  root_shift_ = bits(d.size()) > 60 ? 1 : 0;
  const SlopeForm<std::int32_t> form(d, q, r, l, forms_.wide_m, root_shift_);
  if (forms_.has_wide_slopes && form.size() >> (wide ? many_bits : few_bits) == 0) {
    const SlopeForm<std::int64_t> all(d, q, r, l, forms_.wide_m, root_shift_);
    return keep({all.alpha[0], all.alpha[1], all.alpha[2], all.beta[0], all.beta[1], 0}, all.most_up);
  }
  for (int i = 0; i < 3; ++i) alpha_[i] = form.alpha[i];
  for (int i = 0; i < 2; ++i) beta_[i] = form.beta[i];
  form_error_ = plain_error;
}

// The terms of w in 60 bits, cut to 30. What a term of the forms is off by, less than 8 deep_from units and 2^most_up of that when scaled, comes
// into w less than 8 times.
void RidgeForm::keep(const std::int64_t (&w)[6], int most_up) {
  std::uint64_t size = 1;
  for (const std::int64_t v : w) size += magnitude(v);
  const int shift = bits(size) - 29;
  for (int i = 0; i < 3; ++i) alpha_[i] = narrowed(w[i], shift);
  for (int i = 0; i < 2; ++i) beta_[i] = narrowed(w[3 + i], shift);
  gamma_ = narrowed(w[5], shift);
  const std::int64_t of_terms = std::int64_t{64} * forms_.deep_from + (std::int64_t{1} << (14 + line_.half_bits));
  const int up = most_up - shift;
  const bool is_lost = bits(magnitude(of_terms)) + up > 29;
  form_error_ = is_lost ? far_error / 2 : cut_error + narrowed(of_terms, -up) + 1;
}

// Sizes of terms add up to at most 1/2 in |N|^2's and C's matrices and 1/4 in L, so that nothing below reaches 1.
void RidgeForm::load_by_depth() {
  constexpr int fraction = 60;
  const int hb = line_.half_bits;
  const Terms q(line_.q, hb), r(line_.r, hb), l(line_.l, hb), b(line_.depth.b, hb), c(line_.depth.c, hb);
  const std::int64_t zz = forms_.depth.zz;
  const std::int64_t m = forms_.wide_m;
  const std::int64_t a = line_.depth.a;
  // Bits below those of 60: r has 62, b 50.
  const int n_shift = bits(q.size() + (r.size() >> 2) + (magnitude(zz))) + 1 - fraction;
  const int l_shift = bits(l.size() + magnitude(m)) + 2 - fraction;
  const int c_shift = bits((b.size() >> 2) + (magnitude(a) >> 12) + (c.size() >> 12)) + 1 + 12 - fraction;
  using Row = std::array<std::int64_t, 3>;  // of x, z, 1
  const std::int64_t r0 = r.cut<std::int64_t>(0, n_shift + 3), r1 = r.cut<std::int64_t>(1, n_shift + 3);
  const std::int64_t q1 = q.cut<std::int64_t>(1, n_shift + 1);
  const Row n[3] = {{q.cut<std::int64_t>(2, n_shift), r1, q1},
                    {r1, shifted_down(zz, n_shift), r0},
                    {q1, r0, q.cut<std::int64_t>(0, n_shift)}};
  const Row light{l.cut<std::int64_t>(1, l_shift), shifted_down(m, l_shift), l.cut<std::int64_t>(0, l_shift)};
  const std::int64_t b0 = b.cut<std::int64_t>(0, c_shift - 10), b1 = b.cut<std::int64_t>(1, c_shift - 10);
  const std::int64_t c1 = -c.cut<std::int64_t>(1, c_shift + 1);
  const Row conic[3] = {{-c.cut<std::int64_t>(2, c_shift), b1, c1},
                        {b1, shifted_down(a, c_shift), b0},
                        {c1, b0, -c.cut<std::int64_t>(0, c_shift)}};
  // w = X . |N|^2 (L x C) X
  Row turned[3];  // columns of L x C
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3, last = (k + 2) % 3;
      turned[i][k] = times(light[next], conic[i][last]) - times(light[last], conic[i][next]);
    }
  }
  const auto entry = [&](std::size_t i, std::size_t k) {
    return times(n[i][0], turned[k][0]) + times(n[i][1], turned[k][1]) + times(n[i][2], turned[k][2]);
  };
  keep({entry(2, 2), entry(0, 2) + entry(2, 0), entry(0, 0), entry(1, 2) + entry(2, 1), entry(0, 1) + entry(1, 0),
        entry(1, 1)},
       -std::min({n_shift, l_shift, c_shift, 0}));
}

RidgeDot RidgeForm::at(std::int32_t t) const {
  RidgeDot p;
  p.tau = static_cast<std::int32_t>(static_cast<std::uint32_t>(t) << tau_shift_);
  if (line_.by_depth) {
    set_depth(p, t);
    return p;
  }
  p.s = line_.d.root(t);
  p.sigma = p.s >> root_shift_;
  p.slope = beta_at(p.tau);
  p.root_error = p.s >= forms_.deep_from ? SectionForms::deep_root_error : forms_.errors[0].root;
  p.error = form_error_ + p.root_error;
  p.w = alpha_[0] + times(alpha_[1] + times(alpha_[2], p.tau), p.tau) + times(p.slope, p.sigma);
  return p;
}

void RidgeForm::set_depth(RidgeDot& p, std::int32_t t) const {
  const DotDepth at = forms_.depth_at(line_.d, line_.depth, t);
  p.s = at.s;
  p.sigma = at.z;
  p.root_error = at.error;
  const std::int32_t square = times(gamma_, p.sigma);
  const std::int32_t slope = beta_at(p.tau) + square;
  p.slope = slope + square;
  p.w = alpha_[0] + times(alpha_[1] + times(alpha_[2], p.tau), p.tau) + times(slope, p.sigma);
  p.error = at.is_far() ? far_error : form_error_ + times(size(p.slope), at.error) + 2;
}

Course RidgeForm::course(const RidgeDot& a, const RidgeDot& b) const {
  if (line_.by_depth) return depth_course(a, b);
  const Course known = plain_course(a, b);
  return known != Course::unsure ? known : scaled_course(a, b);
}

// h^2
std::int32_t RidgeForm::square_of_way(const RidgeDot& a, const RidgeDot& b) const {
  const std::uint32_t way = static_cast<std::uint32_t>(b.tau) - static_cast<std::uint32_t>(a.tau);
  const auto h = static_cast<std::int32_t>(way >> tau_shift_);
  return h * h;
}

// |w|, |beta| and s are at most 1, |delta| at most 5/4. The root's error enters delta twice, w_at and w_tb 5 times and the middle 28 times; the
// rest adds up to 2, and to 9/4 and 9 of the form's with floors.
Course RidgeForm::plain_course(const RidgeDot& a, const RidgeDot& b) const {
  const std::int32_t error = std::max(a.root_error, b.root_error);
  const std::int64_t bend = plus_product(0, square_of_way(a, b), line_.d.v2);
  const Arc arc(a.sigma, b.sigma, bend >> 2 * root_shift_);
  if (arc.weight() <= 6 * error + 8) return Course::unsure;
  return course(a, b, arc, w_between(a, b), 8 * error + std::int64_t{3} * form_error_ + 32,
                32 * error + std::int64_t{12} * form_error_ + 128);
}

// The arc times a power of two, such that s or its pole is near 1: where s is small, so are its products with w. A chord across the block may
// have to be scaled down. With e what s errs by then:
//   delta     2 e of its square, 1 more of its error's, h^2 units of D2 h^2, 2 of floors
Course RidgeForm::scaled_course(const RidgeDot& a, const RidgeDot& b) const {
  const std::int32_t square = square_of_way(a, b);
  const std::int64_t bend = plus_product(0, square, line_.d.v2);
  const int room = 30 - bits(magnitude(a.s | b.s));
  const int scale = std::min({room, (std::countl_zero(magnitude(bend)) - 4) >> 1, most_scale});
  const std::int64_t root_error = shifted_down(std::max(a.root_error, b.root_error), -scale) + 1;
  if (root_error >> 15 != 0) return Course::unsure;
  const std::int64_t delta_error = 2 * root_error + shifted_down(square, 30 - 2 * scale) + 4;
  Arc arc(static_cast<std::int32_t>(shifted_down(a.s, -scale)), static_cast<std::int32_t>(shifted_down(b.s, -scale)),
          shifted_down(bend, -2 * scale));
  arc.bow = static_cast<std::int32_t>(shifted_down(arc.bow, scale + root_shift_));
  return course(a, b, arc, {root_error, delta_error, shifted_down(root_error + delta_error, scale) + 1});
}

// delta_z errs by what z does, times what s changes by, by term_error h^2 of c2 h^2 and h 2^13 of b'; all in 60 bits.
Course RidgeForm::depth_course(const RidgeDot& a, const RidgeDot& b) const {
  if (a.error == far_error || b.error == far_error) return Course::unsure;
  const LineDepth& depth = line_.depth;
  const std::int32_t square = square_of_way(a, b);
  const std::uint32_t way = (static_cast<std::uint32_t>(b.tau) - static_cast<std::uint32_t>(a.tau)) >> tau_shift_;
  const std::int64_t change = std::int64_t{b.sigma} - a.sigma;
  const std::int64_t wide_change = change * (1 << 30);
  const std::int64_t of_b =
      plus_product(0, static_cast<std::int32_t>(way), depth.b.v1) * (1 << (30 - BlockDepth::fraction));
  const std::int64_t of_a = times(depth.a, wide_change);
  if ((magnitude(of_b) | magnitude(of_a)) >> 61 != 0) return Course::unsure;
  const std::int64_t bend = plus_product(2 * times(of_b, wide_change) + times(of_a, wide_change), -square, depth.c.v2);
  const std::int64_t delta = times(bend, depth.a);
  const std::int64_t change_error = 4 * std::int64_t{std::max(a.root_error, b.root_error)};
  const std::int64_t bend_error = change_error * static_cast<std::int64_t>((magnitude(of_b) + magnitude(of_a)) >> 30) +
                                  (std::int64_t{way} << 14) + std::int64_t{BlockDepth::term_error} * square + 16;

  const int room = 30 - bits(magnitude(a.s | b.s));
  const int scale = std::min(
      {room, std::countl_zero(magnitude(bend)) - 3, (std::countl_zero(magnitude(delta)) - 4) >> 1, most_scale});
  const std::int32_t least_s = std::max<std::int32_t>(std::min(a.s, b.s), 1);
  const std::int64_t root_error =
      shifted_down(std::min(forms_.deep_from / least_s + 4, forms_.errors[0].root), -scale) + 1;
  const std::int64_t delta_error =
      shifted_down(times(bend_error, static_cast<std::int64_t>(magnitude(depth.a))), 31 - 2 * scale) +
      shifted_down(1, -std::max(scale, 0)) + 4;
  const std::int64_t bow_error = shifted_down(bend_error, 31 - scale) + 2;
  if ((root_error | delta_error | bow_error) >> 20 != 0) return Course::unsure;
  const Arc arc(static_cast<std::int32_t>(shifted_down(a.s, -scale)),
                static_cast<std::int32_t>(shifted_down(b.s, -scale)),
                static_cast<std::int32_t>(shifted_down(delta, 31 - 2 * scale)),
                static_cast<std::int32_t>(shifted_down(bend, 31 - scale)));
  return course(a, b, arc, {root_error, delta_error, bow_error + root_error});
}

// With E what w errs by, and e, D and G what s, delta and bow do:
//   w_at      2 E of w, |w| 2 e of s, |beta| G / 2; beta's part of E once, 4 of floors: less than E
//   middle    7 E, |w| (12 e + D), 2 |beta| G, 4 E of beta's part; floors less than E; |gamma| 3 G
Course RidgeForm::course(const RidgeDot& a, const RidgeDot& b, const Arc& arc, const ArcErrors& errors) const {
  if (errors.delta >> 20 != 0 || arc.weight() <= errors.delta + 4 * errors.root + 4) return Course::unsure;
  const std::int32_t w_ab = w_between(a, b);
  const std::int32_t most_w = std::max({size(a.w), size(b.w), size(w_ab)});
  const std::int32_t most_beta = std::max(size(a.slope), size(b.slope)) + 2 * size(gamma_);
  const std::int64_t of_w = form_error_ + times(most_beta, std::max(a.root_error, b.root_error)) + 2;
  const std::int64_t of_roots = times(most_w, static_cast<std::int32_t>(12 * errors.root + errors.delta)) +
                                times(most_beta, static_cast<std::int32_t>(errors.bow)) + 2;
  return course(a, b, arc, w_ab, 4 * of_w + of_roots, 16 * of_w + 2 * of_roots);
}

// w's polar form.
std::int32_t RidgeForm::w_between(const RidgeDot& a, const RidgeDot& b) const {
  const auto mean = static_cast<std::int32_t>((std::int64_t{a.tau} + b.tau) >> 1);
  return alpha_[0] + times(alpha_[1], mean) + times(alpha_[2], times(a.tau, b.tau)) +
         mixed(a.slope, b.sigma, b.slope, a.sigma) - times(gamma_, times(a.sigma, b.sigma));
}

Course RidgeForm::course(const RidgeDot& a, const RidgeDot& b, const Arc& arc, std::int32_t w_ab,
                         std::int64_t side_error, std::int64_t middle_error) const {
  const std::int64_t w_at = std::int64_t{times(arc.s_b, a.w)} + times(arc.s_a, w_ab) + times(a.slope, arc.bow) / 2;
  const std::int64_t w_tb = std::int64_t{times(arc.s_a, b.w)} + times(arc.s_b, w_ab) + times(b.slope, arc.bow) / 2;
  const std::int64_t middle = std::int64_t{times(times(arc.s_b, arc.s_b), a.w)} + times(times(arc.s_a, arc.s_a), b.w) +
                              ((arc.weight() + 2 * std::int64_t{times(arc.s_a, arc.s_b)}) * w_ab >> 30) +
                              2 * (std::int64_t{mixed(a.slope, arc.s_b, b.slope, arc.s_a)} * arc.bow >> 30) +
                              times(gamma_, times(arc.bow, arc.bow));
  return course_of(
      {a.sign(), sure_sign(w_at, side_error), sure_sign(middle, middle_error), sure_sign(w_tb, side_error), b.sign()});
}

}  // namespace halfspace
