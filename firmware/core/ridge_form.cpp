#include "firmware/core/ridge_form.hpp"

#include <algorithm>
#include <array>

namespace halfspace {
namespace {

constexpr std::int32_t form_error =
    160;  // of w, where s is exact: alpha and beta within 64 each, and their sum's rounding

// Product of two numbers of 30 bits of fraction.
std::int32_t times(std::int32_t a, std::int32_t b) { return static_cast<std::int32_t>(std::int64_t{a} * b >> 30); }

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
  [[nodiscard]] std::int32_t cut(int i, int shift) const {
    return static_cast<std::int32_t>(shifted_down(c[i], shift));
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

int RidgeDot::sign() const { return sure_sign(w, form_error + error); }

// The sizes of terms add up to at most 1 in D, to 1/2 in q and r, and to 1/4 in l and m: light and square may be scaled at will,
// D as s is. So no sum below reaches 1, nor do alpha, beta or w, nor w's polar form 2.
RidgeForm::RidgeForm(const SectionForms& forms, const LineForms& line)
    : discriminant_(line.d),
      deep_from_(forms.deep_from),
      limb_root_error_(forms.errors[0].root),
      tau_shift_(30 - line.half_bits) {
  const int hb = line.half_bits;
  const Terms d(line.d, hb);
  const Terms q(line.q, hb);
  const Terms r(line.r, hb);
  const Terms l(line.l, hb);
  root_shift_ = bits(d.size()) > 60 ? 1 : 0;
  const int q_shift = bits(q.size() + (r.size() >> (2 - root_shift_))) - 29;
  const std::int64_t m28 = std::int64_t{line.m} * (1 << SectionForms::light_fraction);
  const int l_shift = bits(l.size() + (magnitude(m28) << root_shift_)) - 28;
  for (int i = 0; i < 3; ++i) d_[i] = d.cut(i, 30 + 2 * root_shift_);
  const auto [d0, d1, d2] = d_;
  const std::int32_t q0 = q.cut(0, q_shift);
  const std::int32_t q1 = q.cut(1, q_shift);
  const std::int32_t q2 = q.cut(2, q_shift);
  // 32 bits of fraction and 30 of s against |N|^2; and s is scaled
  const std::int32_t r0 = r.cut(0, q_shift + 2 - root_shift_);
  const std::int32_t r1 = r.cut(1, q_shift + 2 - root_shift_);
  const std::int32_t l0 = l.cut(0, l_shift);
  const std::int32_t l1 = l.cut(1, l_shift);
  const auto m = static_cast<std::int32_t>(shifted_down(m28, l_shift - root_shift_));
  // 2 l' r - l r' = e + l1 r1 tau,  l r = p0 + p1 tau + l1 r1 tau^2
  const std::int32_t l0r1 = times(l0, r1);
  const std::int32_t l1r0 = times(l1, r0);
  const std::int32_t l1r1 = times(l1, r1);
  const std::int32_t e = 2 * l1r0 - l0r1;
  const std::int32_t p0 = times(l0, r0);
  const std::int32_t p1 = l0r1 + l1r0;
  beta_[0] = 2 * times(l1, q0) - times(l0, q1) + times(m, times(d1, r0) / 2 - times(d0, r1));
  beta_[1] = times(l1, q1) - 2 * times(l0, q2) + times(m, times(d2, r0) - times(d1, r1) / 2);
  alpha_[0] = times(d0, e) - times(d1, p0) / 2 + times(m, times(d1, q0) - times(q1, d0));
  alpha_[1] =
      times(d0, l1r1) + times(d1, e) - times(d1, p1) / 2 - times(d2, p0) + 2 * times(m, times(d2, q0) - times(q2, d0));
  alpha_[2] = times(d1, l1r1) / 2 + times(d2, e - p1) + times(m, times(d2, q1) - times(q2, d1));
}

RidgeDot RidgeForm::at(std::int32_t t) const {
  const std::int32_t s = discriminant_.root(t);
  const std::int32_t root_error = s >= deep_from_ ? SectionForms::deep_root_error : limb_root_error_;
  RidgeDot p;
  p.tau = static_cast<std::int32_t>(static_cast<std::uint32_t>(t) << tau_shift_);
  p.s = s >> root_shift_;
  p.beta = beta_[0] + times(beta_[1], p.tau);
  p.w = alpha_[0] + times(alpha_[1] + times(alpha_[2], p.tau), p.tau) + times(p.beta, p.s);
  p.error = (root_error >> root_shift_) + root_shift_;
  return p;
}

Course RidgeForm::course(const RidgeDot& a, const RidgeDot& b) const {
  const std::int32_t error = std::max(a.error, b.error);
  const auto mean = static_cast<std::int32_t>((std::int64_t{a.tau} + b.tau) >> 1);
  const std::int32_t tau_ab = times(a.tau, b.tau);
  const std::int32_t polar = d_[0] + times(d_[1], mean) + times(d_[2], tau_ab);
  const std::int32_t ss = times(a.s, b.s);
  const std::int32_t delta = polar - ss;
  if (polar + ss <= 2 * error + 8) return Course::unsure;  // the arc turns by half a circle or more
  const auto beta_s = static_cast<std::int32_t>((std::int64_t{a.beta} * b.s + std::int64_t{b.beta} * a.s) >> 31);
  const std::int32_t w_ab = alpha_[0] + times(alpha_[1], mean) + times(alpha_[2], tau_ab) + beta_s;
  const std::int64_t w_at = times(b.s, a.w) + times(a.s, w_ab) + times(delta, a.beta) / 2;
  const std::int64_t w_tb = times(a.s, b.w) + times(b.s, w_ab) + times(delta, b.beta) / 2;
  const std::int64_t middle = std::int64_t{times(times(b.s, b.s), a.w)} + times(times(a.s, a.s), b.w) +
                              ((4 * std::int64_t{ss} + delta) * w_ab >> 30) + 2 * std::int64_t{times(delta, beta_s)};
  // |w| < 1, so the root's error enters w_at and w_tb at most 8 times and the middle 41 times; the rest adds up to 330 and 1000.
  const std::int64_t side_error = 512 + 16 * std::int64_t{error};
  return course_of({a.sign(), sure_sign(w_at, side_error), sure_sign(middle, 2048 + 64 * std::int64_t{error}),
                    sure_sign(w_tb, side_error), b.sign()});
}

}  // namespace halfspace
