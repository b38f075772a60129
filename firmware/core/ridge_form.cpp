#include "firmware/core/ridge_form.hpp"

#include <algorithm>
#include <array>

#include "firmware/core/real.hpp"

namespace halfspace {
namespace {

constexpr std::int32_t form_error =
    160;  // of w, where s is exact: alpha and beta within 64 each, and their sum's rounding

constexpr std::int32_t far_error = 1 << 29;  // of a dot of which nothing is known

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

int RidgeDot::sign() const { return sure_sign(w, form_error + error); }

RidgeForm::RidgeForm(const SectionForms& forms, const LineForms& line)
    : forms_(forms), line_(line), tau_shift_(30 - line.half_bits), shear_bits_(line.shear_bits) {
  const Terms d(line.d, line.half_bits);
  root_shift_ = bits(d.size()) > 60 ? 1 : 0;
  for (int i = 0; i < 3; ++i) d_[i] = d.cut<std::int32_t>(i, 30 + 2 * root_shift_);
  if (shear_bits_ == 0) {
    load();
  } else {
    load_sheared();
  }
}

void RidgeForm::load() {
  const int hb = line_.half_bits;
  (void)load_slope(alpha_, beta_, d_, {line_.q, hb}, {line_.r, hb}, {line_.l, hb}, line_.m, root_shift_);
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
  extra_error_ = static_cast<std::int32_t>(std::min<std::int64_t>(error + 1, 1 << 26));
}

RidgeDot RidgeForm::at(std::int32_t t) const {
  RidgeDot p;
  if (shear_bits_ == 0) {
    const std::int32_t s = line_.d.root(t);
    const std::int32_t root_error = s >= forms_.deep_from ? SectionForms::deep_root_error : forms_.errors[0].root;
    p.s = s >> root_shift_;
    p.sigma = p.s;
    p.error = (root_error >> root_shift_) + root_shift_;
  } else {
    shear(p, t);
  }
  p.tau = static_cast<std::int32_t>(static_cast<std::uint32_t>(t) << tau_shift_);
  p.beta = beta_[0] + times(beta_[1], p.tau);
  p.w = alpha_[0] + times(alpha_[1] + times(alpha_[2], p.tau), p.tau) + times(p.beta, p.sigma);
  return p;
}

void RidgeForm::shear(RidgeDot& p, std::int32_t t) const {
  const ShearedRoot root = forms_.sheared_root(line_.d, line_.plane, t);
  p.s = root.s >> root_shift_;
  p.sigma = root.is_far() ? 0 : static_cast<std::int32_t>(root.sigma) >> root_shift_;
  p.error = root.is_far() ? far_error : root.error + (1 << shear_bits_) + extra_error_;
}

Course RidgeForm::course(const RidgeDot& a, const RidgeDot& b) const {
  const std::int32_t error = std::max(a.error, b.error);
  const auto mean = static_cast<std::int32_t>((std::int64_t{a.tau} + b.tau) >> 1);
  const std::int32_t tau_ab = times(a.tau, b.tau);
  const std::int32_t polar = d_[0] + times(d_[1], mean) + times(d_[2], tau_ab);
  const std::int32_t ss = times(a.s, b.s);
  const std::int32_t delta = polar - ss;
  // The arc turns by half a circle or more; or its pole lies farther from the plane than words reach.
  if (polar + ss <= 2 * error + 8 || (delta < 0 ? -delta : delta) >> (31 - shear_bits_) != 0) return Course::unsure;
  const auto mixed = [&](std::int32_t of_a, std::int32_t of_b) {
    return static_cast<std::int32_t>((std::int64_t{a.beta} * of_b + std::int64_t{b.beta} * of_a) >> 31);
  };
  const std::int32_t beta_s = mixed(a.s, b.s);
  std::int32_t beta_sigma = beta_s;
  std::int64_t bow_a = 0;  // delta beta, where delta is of s
  std::int64_t bow_b = 0;
  std::int64_t bow_ab = 0;
  if (shear_bits_ == 0) {
    bow_a = times(delta, a.beta);
    bow_b = times(delta, b.beta);
    bow_ab = times(delta, beta_s);
  } else {
    const auto bowed = [&](std::int32_t beta) { return std::int64_t{delta} * beta >> (30 - shear_bits_); };
    beta_sigma = mixed(a.sigma, b.sigma);
    bow_a = bowed(a.beta);
    bow_b = bowed(b.beta);
    bow_ab = bowed(beta_s);
  }
  const std::int32_t w_ab = alpha_[0] + times(alpha_[1], mean) + times(alpha_[2], tau_ab) + beta_sigma;
  const std::int64_t w_at = times(b.s, a.w) + times(a.s, w_ab) + bow_a / 2;
  const std::int64_t w_tb = times(a.s, b.w) + times(b.s, w_ab) + bow_b / 2;
  const std::int64_t middle = std::int64_t{times(times(b.s, b.s), a.w)} + times(times(a.s, a.s), b.w) +
                              ((4 * std::int64_t{ss} + delta) * w_ab >> 30) + 2 * bow_ab;
  // |w| < 1, so the root's error enters w_at and w_tb at most 8 times and the middle 41 times; the rest adds up to 330 and 1000.
  const std::int64_t side_error = 512 + 16 * std::int64_t{error};
  return course_of({a.sign(), sure_sign(w_at, side_error), sure_sign(middle, 2048 + 64 * std::int64_t{error}),
                    sure_sign(w_tb, side_error), b.sign()});
}

}  // namespace halfspace
