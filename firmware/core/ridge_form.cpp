#include "firmware/core/ridge_form.hpp"

#include <algorithm>
#include <array>

#include "firmware/core/real.hpp"

namespace halfspace {
namespace {

constexpr std::int32_t plain_error =
    160;  // of w, where s is exact: alpha and beta within 64 each, and their sum's rounding
constexpr std::int32_t far_error = 1 << 30;  // of a dot of which nothing is known: w is smaller
constexpr int most_scale = 11;               // of the weights of an arc

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

// alpha and beta of a line from its forms, `fraction` bits of fraction: sizes of terms add up to at most 1 in D, to 1/2 in q and r, and to
// 1/4 in l and m: light and square may be scaled at will, D as s is. So no sum below reaches 1, nor do alpha, beta or w, nor w's polar form 2.
// Gives the bits that a form was scaled up by.
template <class Int>
[[gnu::always_inline]] inline int load_slope(Int (&alpha)[3], Int (&beta)[2], const Int (&d)[3], const Terms& q,
                                             const Terms& r, const Terms& l, std::int32_t line_m, int root_shift) {
  constexpr int fraction = sizeof(Int) == 4 ? 30 : 60;
  const int q_shift = bits(q.size() + (r.size() >> (2 - root_shift))) + 1 - fraction;
  const std::int64_t m28 = std::int64_t{line_m} * (1 << SectionForms::light_fraction);
  const int l_shift = bits(l.size() + (magnitude(m28) << root_shift)) + 2 - fraction;
  const auto [d0, d1, d2] = d;
  const auto q0 = q.cut<Int>(0, q_shift), q1 = q.cut<Int>(1, q_shift), q2 = q.cut<Int>(2, q_shift);
  // 32 bits of fraction and 30 of s against |N|^2; and s is scaled
  const auto r0 = r.cut<Int>(0, q_shift + 2 - root_shift), r1 = r.cut<Int>(1, q_shift + 2 - root_shift);
  const auto l0 = l.cut<Int>(0, l_shift), l1 = l.cut<Int>(1, l_shift);
  const auto m = static_cast<Int>(shifted_down(m28, l_shift - root_shift));
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
  alpha[1] =
      times(d0, l1r1) + times(d1, e) - times(d1, p1) / 2 - times(d2, p0) + 2 * times(m, times(d2, q0) - times(q2, d0));
  alpha[2] = times(d1, l1r1) / 2 + times(d2, e - p1) + times(m, times(d2, q1) - times(q2, d1));
  return -std::min({q_shift, l_shift, 0});
}

}  // namespace

int RidgeDot::sign() const { return sure_sign(w, error); }

RidgeForm::RidgeForm(const SectionForms& forms, const LineForms& line)
    : forms_(forms), line_(line), tau_shift_(30 - line.half_bits), shear_bits_(line.shear_bits) {
  const Terms d(line.d, line.half_bits);
  root_shift_ = bits(d.size()) > 60 ? 1 : 0;
  if (shear_bits_ == 0) {
    const int down = 30 + 2 * root_shift_;
    load({d.cut<std::int32_t>(0, down), d.cut<std::int32_t>(1, down), d.cut<std::int32_t>(2, down)});
  } else {
    load_sheared();
  }
}

void RidgeForm::load(const std::int32_t (&d)[3]) {
  const int hb = line_.half_bits;
  (void)load_slope(alpha_, beta_, d, {line_.q, hb}, {line_.r, hb}, {line_.l, hb}, line_.m, root_shift_);
  form_error_ = plain_error;
}

// A form's terms are off by less than deep_from in all, and by 2^most_up of that when scaled; so alpha, beta and the former with the plane
// by less than 64, 64 and 256 times that.
void RidgeForm::load_sheared() {
  const int hb = line_.half_bits;
  const Terms of_d(line_.d, hb);
  const RootForms& by_root = forms_.by_root;
  const std::int32_t v = line_.v;
  std::int64_t alpha[3];
  std::int64_t beta[2];
  const std::int64_t d[3] = {of_d.cut<std::int64_t>(0, 2 * root_shift_), of_d.cut<std::int64_t>(1, 2 * root_shift_),
                             of_d.cut<std::int64_t>(2, 2 * root_shift_)};
  const int most_up = load_slope(alpha, beta, d, {by_root.q.on(v), hb}, {by_root.r.on(v), hb}, {by_root.l.on(v), hb},
                                 by_root.m, root_shift_);
  const Terms plane(line_.plane, hb);
  const auto plane0 = plane.cut<std::int64_t>(0, root_shift_ + Shear::fraction - 30);
  const auto plane1 = plane.cut<std::int64_t>(1, root_shift_ + Shear::fraction - 30);
  alpha[0] += times(beta[0], plane0);
  alpha[1] += times(beta[0], plane1) + times(beta[1], plane0);
  alpha[2] += times(beta[1], plane1);
  std::uint64_t size = 1;
  for (const std::int64_t a : alpha) size += magnitude(a);
  for (const std::int64_t b : beta) size += magnitude(b) >> shear_bits_;
  const int shift = bits(size) - 30;
  for (int i = 0; i < 3; ++i) alpha_[i] = static_cast<std::int32_t>(shifted_down(alpha[i], shift));
  for (int i = 0; i < 2; ++i) beta_[i] = static_cast<std::int32_t>(shifted_down(beta[i], shift + shear_bits_));
  const std::int64_t error = shifted_down(std::int64_t{512} * forms_.deep_from, shift - most_up);
  form_error_ =
      plain_error + (1 << shear_bits_) + static_cast<std::int32_t>(std::min<std::int64_t>(error + 1, far_error));
}

RidgeDot RidgeForm::at(std::int32_t t) const {
  RidgeDot p;
  p.tau = static_cast<std::int32_t>(static_cast<std::uint32_t>(t) << tau_shift_);
  if (shear_bits_ == 0) {
    const std::int32_t s = line_.d.root(t);
    p.s = s;
    p.sigma = s >> root_shift_;
    p.root_error = s >= forms_.deep_from ? SectionForms::deep_root_error : forms_.errors[0].root;
    p.error = form_error_ + p.root_error;
  } else {
    shear(p, t);
  }
  p.w = alpha_[0] + times(alpha_[1] + times(alpha_[2], p.tau), p.tau) + times(beta_at(p.tau), p.sigma);
  return p;
}

void RidgeForm::shear(RidgeDot& p, std::int32_t t) const {
  const ShearedRoot root = forms_.sheared_root(line_.d, line_.plane, t);
  p.s = root.fine;
  p.sigma = root.is_far() ? 0 : static_cast<std::int32_t>(root.sigma) >> root_shift_;
  p.root_error = root.is_far() ? far_error : root.error;
  p.error = root.is_far() ? far_error : form_error_ + times(size(beta_at(p.tau)), root.error) + 2;
}

Course RidgeForm::course(const RidgeDot& a, const RidgeDot& b) const {
  const Course known = shear_bits_ == 0 ? plain_course(a, b) : Course::unsure;
  return known != Course::unsure ? known : scaled_course(a, b);
}

// h^2
std::int32_t RidgeForm::square_of_way(const RidgeDot& a, const RidgeDot& b) const {
  const std::uint32_t way = static_cast<std::uint32_t>(b.tau) - static_cast<std::uint32_t>(a.tau);
  const auto h = static_cast<std::int32_t>(way >> tau_shift_);
  return h * h;
}

// |w|, |beta| and s are at most 1, |delta| at most 5/4. The root's error enters delta twice, w_at and w_tb 5 times and the middle 28 times; the
// rest adds up to 2, 360 and 1400.
Course RidgeForm::plain_course(const RidgeDot& a, const RidgeDot& b) const {
  const std::int32_t error = std::max(a.root_error, b.root_error);
  const std::int64_t bend = plus_product(0, square_of_way(a, b), line_.d.v2);
  const Arc arc(a.sigma, b.sigma, bend >> 2 * root_shift_, 30);
  if (arc.weight() <= 6 * error + 8) return Course::unsure;
  return course(a, b, arc, w_between(a, b), 8 * error + 512, 32 * error + 2048);
}

// The arc times a power of two, such that s or its pole is near 1: where s is small, so are its products with w. With e what s errs by then, and
// g such that beta is that of s 2^g:
//   delta     2 e of its square, 1 more of its error's, h^2 units of D2 h^2, 2 of floors
//   w_at      2 E of w, |w| 2 e of s, |beta| 2^g delta's / 2; beta's part of E once, 4 of floors: less than E
//   middle    7 E, |w| (12 e + delta's), 2 |beta| 2^g (delta's + e), 4 E of beta's part; floors less than E
Course RidgeForm::scaled_course(const RidgeDot& a, const RidgeDot& b) const {
  const std::int32_t square = square_of_way(a, b);
  const std::int64_t bend = plus_product(0, square, line_.d.v2);
  const int room = 30 + shear_bits_ - bits(magnitude(a.s | b.s));
  const int scale = std::min({room, (std::countl_zero(magnitude(bend)) - 4) >> 1, most_scale});
  const int down = shear_bits_ - scale;
  const std::int32_t sigma_error = std::max(a.root_error, b.root_error);
  const std::int64_t root_error = shifted_down(sigma_error, down) + 1;
  if (root_error >> 15 != 0) return Course::unsure;
  const Arc arc(static_cast<std::int32_t>(shifted_down(a.s, down)), static_cast<std::int32_t>(shifted_down(b.s, down)),
                shifted_down(bend, -2 * scale), 30 - down + root_shift_);
  const auto delta_error = static_cast<std::int32_t>(2 * root_error + shifted_down(square, 30 - 2 * scale) + 4);
  if (arc.weight() <= delta_error + 4 * root_error + 4) return Course::unsure;
  const std::int32_t w_ab = w_between(a, b);
  const std::int32_t most_w = std::max({size(a.w), size(b.w), size(w_ab)});
  const std::int32_t most_beta = std::max(size(beta_at(a.tau)), size(beta_at(b.tau)));
  const std::int64_t of_w = form_error_ + times(most_beta, sigma_error) + 2;
  const std::int64_t of_roots = times(most_w, static_cast<std::int32_t>(12 * root_error) + delta_error) +
                                arc.bow(most_beta, static_cast<std::int32_t>(root_error) + delta_error);
  return course(a, b, arc, w_ab, 4 * of_w + of_roots, 16 * of_w + 2 * of_roots);
}

// w's polar form.
std::int32_t RidgeForm::w_between(const RidgeDot& a, const RidgeDot& b) const {
  const auto mean = static_cast<std::int32_t>((std::int64_t{a.tau} + b.tau) >> 1);
  return alpha_[0] + times(alpha_[1], mean) + times(alpha_[2], times(a.tau, b.tau)) +
         mixed(beta_at(a.tau), b.sigma, beta_at(b.tau), a.sigma);
}

Course RidgeForm::course(const RidgeDot& a, const RidgeDot& b, const Arc& arc, std::int32_t w_ab,
                         std::int64_t side_error, std::int64_t middle_error) const {
  const std::int32_t beta_a = beta_at(a.tau);
  const std::int32_t beta_b = beta_at(b.tau);
  const std::int64_t w_at = std::int64_t{times(arc.s_b, a.w)} + times(arc.s_a, w_ab) + arc.bow(beta_a) / 2;
  const std::int64_t w_tb = std::int64_t{times(arc.s_a, b.w)} + times(arc.s_b, w_ab) + arc.bow(beta_b) / 2;
  const std::int64_t middle = std::int64_t{times(times(arc.s_b, arc.s_b), a.w)} + times(times(arc.s_a, arc.s_a), b.w) +
                              ((arc.weight() + 2 * std::int64_t{times(arc.s_a, arc.s_b)}) * w_ab >> 30) +
                              2 * arc.bow(mixed(beta_a, arc.s_b, beta_b, arc.s_a));
  return course_of(
      {a.sign(), sure_sign(w_at, side_error), sure_sign(middle, middle_error), sure_sign(w_tb, side_error), b.sign()});
}

}  // namespace halfspace
