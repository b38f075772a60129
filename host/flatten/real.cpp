#include "host/flatten/real.hpp"

#include <mpfr.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <utility>

namespace halfspace {
namespace {

constexpr int exponent_bias = 16383;
constexpr int fraction_bits = 112;
constexpr Bits128 hidden_bit = Bits128{1} << fraction_bits;
constexpr std::uint64_t sign_bit = std::uint64_t{1} << 63;

struct Parts {
  Bits128 mantissa = 0;  // below 2^113
  int exponent = 0;      // value = +-mantissa * 2^exponent
  bool negative = false;
};

Bits128 mantissa_of(Real v) { return (v.bits() & (hidden_bit - 1)) | hidden_bit; }

// Subnormal numbers (below 10^-4931) count as 0.
Parts parts_of(Real v) {
  const int biased = v.exponent_bits();
  if (biased == 0) return {};
  return {mantissa_of(v), biased - exponent_bias - fraction_bits, v.has_sign()};
}

int bit_width(Bits128 v) {
  const auto high = static_cast<std::uint64_t>(v >> 64);
  return static_cast<int>(high != 0 ? 64 + std::bit_width(high) : std::bit_width(static_cast<std::uint64_t>(v)));
}

// +-mantissa * 2^exponent, the mantissa cut to its 113 leading bits.
Real composed(Bits128 mantissa, long exponent, bool negative) {
  if (mantissa == 0) return 0;
  const int excess = bit_width(mantissa) - (fraction_bits + 1);
  if (excess > 0) {
    mantissa >>= excess;
    exponent += excess;
  }
  const long limit = exponent_bias - fraction_bits - 1;
  if (exponent > limit) return (negative ? -1 : 1) * power_of_two(exponent_bias) * 2;  // infinite
  if (exponent < -limit) return 0;
  if (excess < 0) {
    mantissa <<= -excess;
    exponent += excess;
  }
  const auto biased = static_cast<std::uint64_t>(exponent + exponent_bias + fraction_bits);
  return Real::of_bits(Bits128{negative} << 127 | Bits128{biased} << fraction_bits | (mantissa & (hidden_bit - 1)));
}

// m * 2^exponent, m cut to its 113 leading bits.
Real scaled(const mpz_class& m, long exponent) {
  static_assert(GMP_NUMB_BITS == 64);
  const auto excess = static_cast<long>(mpz_sizeinbase(m.get_mpz_t(), 2)) - (fraction_bits + 1);
  if (excess <= 0) {
    const Bits128 mantissa = Bits128{mpz_getlimbn(m.get_mpz_t(), 1)} << 64 | mpz_getlimbn(m.get_mpz_t(), 0);
    return composed(mantissa, exponent, m < 0);
  }
  const mpz_class top = abs(m) >> static_cast<unsigned long>(excess);
  return scaled(m < 0 ? mpz_class(-top) : top, exponent + excess);
}

mpz_class to_integer(Bits128 v, bool negative) {
  const std::array words{static_cast<std::uint64_t>(v), static_cast<std::uint64_t>(v >> 64)};
  mpz_class result = words[0];
  if (words[1] != 0) mpz_import(result.get_mpz_t(), 2, -1, sizeof(std::uint64_t), 0, 0, words.data());
  if (negative) mpz_neg(result.get_mpz_t(), result.get_mpz_t());
  return result;
}

// Ties away from zero; the exponent is negative.
Bits128 nearest_whole_of(const Parts& parts) {
  const int shift = -parts.exponent;
  if (shift > fraction_bits + 2) return 0;
  return (parts.mantissa + (Bits128{1} << (shift - 1))) >> shift;
}

class Mpfr {
 public:
  explicit Mpfr(mpfr_prec_t bits) { mpfr_init2(value_, bits); }
  ~Mpfr() { mpfr_clear(value_); }
  Mpfr(const Mpfr&) = delete;
  Mpfr& operator=(const Mpfr&) = delete;
  mpfr_ptr get() { return value_; }

  // To the nearest of 113 bits.
  [[nodiscard]] Real to_real() {
    mpfr_prec_round(value_, fraction_bits + 1, MPFR_RNDN);
    if (mpfr_zero_p(value_)) return 0;
    mpz_class mantissa;
    const mpfr_exp_t exponent = mpfr_get_z_2exp(mantissa.get_mpz_t(), value_);
    return scaled(mantissa, exponent);
  }

 private:
  mpfr_t value_;
};

constexpr mpfr_prec_t working_bits = 192;

Real zero(bool negative) { return Real::of_bits(Bits128{negative} << 127); }

// Infinite and nan, 0 and subnormal.
bool is_special(Real v) { return static_cast<unsigned>(v.exponent_bits()) - 1U >= 0x7ffeU; }

Words words_of(Bits128 v) { return {static_cast<std::uint64_t>(v), static_cast<std::uint64_t>(v >> 64)}; }

// The mantissa's leading bit at bit 127.
Words aligned_mantissa(Real v) {
  const auto [low, high] = v.words();
  return {low << 15, high << 15 | low >> 49 | std::uint64_t{1} << 63};
}

// +-top * 2^(biased exponent of its leading bit, which is bit 127), to the nearest, ties to even; `more`: bits below are not all 0.
Real rounded(Words top, bool more, int biased, bool negative) {
  constexpr int dropped = 127 - fraction_bits;
  std::uint64_t low = top.low >> dropped | top.high << (64 - dropped);
  std::uint64_t high = top.high >> dropped;  // with the hidden bit, which raises the exponent by 1
  const std::uint64_t rest = (top.low & ((1U << dropped) - 1)) << 1 | (more ? 1U : 0U);
  const std::uint64_t up = rest + (low & 1U) > 1U << dropped ? 1 : 0;
  low += up;
  high += low < up ? 1 : 0;  // a carry out of the mantissa raises the exponent and leaves 0
  high += static_cast<std::uint64_t>(biased - 1) << 48;
  return Real::of_words({low, high | (negative ? std::uint64_t{1} << 63 : 0)});
}

// +-(whole + rest / 2^64) 2^(biased exponent of bit 112, which is its leading bit, less 112), to the nearest, ties to even; the last bit of `rest`
// also stands for what is beyond it.
Real to_nearest(Words whole, std::uint64_t rest, int biased, std::uint64_t sign) {
  const std::uint64_t up = rest > sign_bit - (whole.low & 1U) ? 1 : 0;
  const std::uint64_t low = whole.low + up;
  const std::uint64_t carry = low < up ? 1 : 0;  // a carry out of the mantissa raises the exponent and leaves 0
  // With the hidden bit, which raises the exponent by 1.
  return Real::of_words({low, (whole.high + carry + (static_cast<std::uint64_t>(biased - 1) << 48)) | sign});
}

// Both between 2^-8191 and 2^8192 in size: the exponent's first two bits differ. Sums are normal then, or 0.
bool are_mild(Real a, Real b) {
  const std::uint64_t u = a.words().high;
  const std::uint64_t v = b.words().high;
  return ((u ^ u << 1) & (v ^ v << 1) & (std::uint64_t{1} << 62)) != 0;
}

// What is 0, infinite, nan, very small or very large.
[[gnu::noinline]] Real special_product(Real a, Real b) {
  if ((is_zero(a) && finite(b)) || (is_zero(b) && finite(a))) return zero(a.has_sign() != b.has_sign());
  return Real::of(a.native() * b.native());
}

// Of numbers that are special, or so far apart that the smaller one only tells where the larger is rounded to.
[[gnu::noinline]] Real distant_sum(Real larger, Real smaller) {
  if (is_zero(smaller)) return is_zero(larger) ? Real::of_bits(larger.bits() & smaller.bits()) : larger;
  return Real::of(larger.native() + smaller.native());
}

// Up to 34 digits, and 10^34, are whole numbers that 113 bits hold: a quotient of them is rounded once.
constexpr std::size_t most_digits = 34;
constexpr std::size_t digits_of_a_word = 19;

Real power_of_ten(std::size_t n) {
  Bits128 five = 1;
  for (std::size_t i = 0; i < n; ++i) five *= 5;
  return composed(five, static_cast<long>(n), false);
}

// Whole holds as many digits as the text has characters. None: it has an exponent.
template <class Whole>
std::optional<Real> short_decimal(const std::string& text) {
  static const auto powers = [] {
    std::array<Real, most_digits + 1> all;
    for (std::size_t n = 0; n <= most_digits; ++n) all[n] = power_of_ten(n);
    return all;
  }();
  Whole digits = 0;
  std::size_t end_of_whole = text.size();
  for (std::size_t i = 0; i < text.size(); ++i) {
    const unsigned digit = static_cast<unsigned char>(text[i]) - unsigned{'0'};
    if (digit <= 9) {
      digits = digits * 10 + digit;
    } else if (text[i] == '.') {
      end_of_whole = i + 1;
    } else if (text[i] != '-') {
      return std::nullopt;
    }
  }
  const Real whole = composed(digits, 0, text.front() == '-' && digits != 0);
  const std::size_t power = text.size() - end_of_whole;
  return power == 0 ? whole : whole / powers[power];
}

// A number for the compiler to divide by; by std::bit_cast clang's analyzer (14) does not survive a quotient.
NativeReal copied(Real v) {
  const auto words = v.words();
  NativeReal native;
  static_assert(sizeof native == sizeof words);
  std::memcpy(&native, &words, sizeof native);
  return native;
}

// The next 64 bits of rest / divisor, of which 2^127 <= divisor and rest < divisor; rest becomes what is left of them (Knuth 4.3.1, D).
std::uint64_t next_digit(Bits128& rest, Bits128 divisor) {
  constexpr std::uint64_t most = ~std::uint64_t{0};
  const Words by = words_of(divisor);
  const bool is_most = static_cast<std::uint64_t>(rest >> 64) == by.high;
  std::uint64_t digit = is_most ? most : static_cast<std::uint64_t>(rest / by.high);
  const Bits128 left = rest - Bits128{digit} * by.high;
  const Bits128 product = Bits128{digit} * by.low;
  rest = (left << 64) - product;
  if (left > most || left << 64 >= product) return digit;
  do {  // at most twice
    --digit;
    rest += divisor;
  } while (rest >= divisor);
  return digit;
}

// Of 2^112 <= v < 2^114, cut: a root in doubles is off by 2^6, and by less than 1 after one of Newton's steps.
Bits128 whole_root(Bits128 v) {
  const auto near =
      static_cast<std::uint64_t>(std::sqrt(static_cast<double>(static_cast<std::uint64_t>(v >> 50))) * 0x1p25);
  const auto square = Bits128{near} * near;
  const bool above = square > v;
  const auto off = static_cast<std::uint64_t>(above ? square - v : v - square) / (2 * near);
  std::uint64_t root = above ? near - off : near + off;
  while (Bits128{root} * root > v) --root;
  while (Bits128{root + 1} * (root + 1) <= v) ++root;
  return root;
}

}  // namespace

// Mantissas of 113 and 128 bits: the product's upper two words are the result's, or half of it.
Real operator*(Real a, Real b) {
  const int exponent = a.exponent_bits() + b.exponent_bits() - exponent_bias;  // 1 or more if both are mild
  if (!are_mild(a, b) || exponent > 0x7ffd) return special_product(a, b);
  const Bits128 mantissa = mantissa_of(a);
  const Words u = words_of(mantissa);
  const Words v = aligned_mantissa(b);
  // No sum is 2^128, as (2^64 - 1)^2 + 2 (2^64 - 1) is less.
  const Bits128 low = Bits128{u.low} * v.low;
  const Bits128 left = Bits128{u.high} * v.low + (low >> 64);
  const Bits128 right = Bits128{u.low} * v.high + static_cast<std::uint64_t>(left);
  const Words top = words_of(Bits128{u.high} * v.high + (left >> 64) + (right >> 64));
  const auto next = static_cast<std::uint64_t>(right);
  // Where its first bit is 0, once more: by a shift rather than by a branch that nobody can predict.
  const auto up = static_cast<int>(~top.high >> 48 & 1U);
  const Words whole{top.low << up | (next >> 63 & static_cast<unsigned>(up)),
                    top.high << up | (top.low >> 63 & static_cast<unsigned>(up))};
  const std::uint64_t rest = next << up | (static_cast<std::uint64_t>(low) != 0 ? 1U : 0U);
  return to_nearest(whole, rest, exponent + 1 - up, (a.words().high ^ b.words().high) & sign_bit);
}

// With 64 bits more, of which the last tells whether there is anything beyond: enough, as only terms of equal or neighbouring exponents,
// which have one bit there at most, cancel more than one.
Real operator+(Real a, Real b) {
  if (a.size_bits() < b.size_bits()) std::swap(a, b);
  const int apart = a.exponent_bits() - b.exponent_bits();
  if (!are_mild(a, b) || apart > 126) return distant_sum(a, b);
  const Words larger = words_of(mantissa_of(a));
  Words term = words_of(mantissa_of(b));  // at the larger one's places
  std::uint64_t rest = 0;
  if (apart >= 64) {
    const Bits128 beyond = mantissa_of(b) << (128 - apart);
    rest = words_of(beyond).high | (words_of(beyond).low != 0 ? 1U : 0U);
    term = {term.high >> (apart - 64), 0};
  } else if (apart > 0) {
    rest = term.low << (64 - apart);
    term = {term.low >> apart | term.high << (64 - apart), term.high >> apart};
  }
  const std::uint64_t sign = a.words().high & sign_bit;
  const int exponent = a.exponent_bits();
  if (a.has_sign() == b.has_sign()) {
    const std::uint64_t low = larger.low + term.low;
    const std::uint64_t high = larger.high + term.high + (low < term.low ? 1 : 0);
    if (high >> 49 == 0) return to_nearest({low, high}, rest, exponent, sign);
    return to_nearest({low >> 1 | high << 63, high >> 1}, rest >> 1 | low << 63 | (rest & 1U), exponent + 1, sign);
  }
  const std::uint64_t borrow = rest != 0 ? 1 : 0;
  const std::uint64_t left = larger.low - term.low;
  const std::uint64_t low = left - borrow;
  const std::uint64_t high = larger.high - term.high - (larger.low < term.low ? 1 : 0) - (left < borrow ? 1 : 0);
  rest = 0 - rest;
  if (high >> 48 != 0) return to_nearest({low, high}, rest, exponent, sign);
  const Bits128 whole = Bits128{high} << 65 | Bits128{low} << 1 | rest >> 63;
  if (whole == 0) return 0;
  const int up = fraction_bits + 1 - bit_width(whole);
  return to_nearest(words_of(whole << up), rest << 1, exponent - 1 - up, sign);
}

// The quotient's mantissa in two digits of 64 bits; both mantissas lose their last place to that, so that the first one is below the second.
Real operator/(Real a, Real b) {
  const bool negative = a.has_sign() != b.has_sign();
  if (is_zero(a) && !is_special(b)) return zero(negative);
  const int exponent = a.exponent_bits() - b.exponent_bits() + exponent_bias;
  if (is_special(a) || is_special(b) || exponent < 2 || exponent > 0x7ffd) return Real::of(copied(a) / copied(b));
  // Most quotients are halves, and a power of two leaves the mantissa.
  if ((b.bits() & (hidden_bit - 1)) == 0) return rounded(aligned_mantissa(a), false, exponent, negative);
  const Bits128 divisor = mantissa_of(b) << 15;
  Bits128 rest = mantissa_of(a) << 14;
  const std::uint64_t high = next_digit(rest, divisor);
  const std::uint64_t low = next_digit(rest, divisor);
  const auto up = static_cast<int>(~high >> 63);  // the quotient is above 1/4 of 2^128
  const Bits128 top = (Bits128{high} << 64 | low) << up;
  return rounded(words_of(top), rest != 0, exponent - up, negative);
}

Real power_of_two(int exponent) {
  return Real::of_bits(Bits128{static_cast<std::uint64_t>(exponent + exponent_bias)} << fraction_bits);
}

// Zimmermann's square root in two digits: with the root s of the leading half and what is left of it, the next digit is rest / 2s or one
// less. All of the lower half's bits are 0.
Real square_root(Real v) {
  constexpr int digit = 57;
  const Parts parts = parts_of(v);
  if (!(v > 0) || parts.mantissa == 0) return 0;
  const int odd = parts.exponent & 1;  // the exponent left over must be even
  const Bits128 half = parts.mantissa << odd;
  const Bits128 first = whole_root(half);  // 57 bits
  const Bits128 rest = (half - first * first) << digit;
  const Bits128 next = rest / (2 * first);
  Bits128 root = (first << digit) + next;
  if ((rest - next * (2 * first)) << digit < next * next) --root;
  return composed(root, (parts.exponent - odd) / 2 - digit, false);
}

Real decimal_to_real(const std::string& text) {
  if (text.size() <= most_digits) {
    const bool is_in_a_word = text.size() <= digits_of_a_word;
    const auto quick = is_in_a_word ? short_decimal<std::uint64_t>(text) : short_decimal<Bits128>(text);
    if (quick) return *quick;
  }
  Mpfr value(fraction_bits + 1);
  mpfr_set_str(value.get(), text.c_str(), 10, MPFR_RNDN);
  return value.to_real();
}

Real to_real(const mpz_class& v) { return scaled(v, 0); }

mpz_class round_to_integer(Real v) {
  const Parts parts = parts_of(v);
  if (parts.exponent < 0) return to_integer(nearest_whole_of(parts), parts.negative);
  return to_integer(parts.mantissa, parts.negative) << static_cast<unsigned long>(parts.exponent);
}

Real nearest_whole(Real v) {
  const int fraction = exponent_bias + fraction_bits - v.exponent_bits();  // bits of it
  if (fraction <= 0) return v;
  if (fraction > fraction_bits) return fraction == fraction_bits + 1 ? Real(v.has_sign() ? -1 : 1) : 0;
  const Bits128 half = Bits128{1} << (fraction - 1);
  return Real::of_bits((v.bits() + half) & -(half << 1));  // a carry out of the mantissa raises the exponent
}

std::int64_t nearest_word(Real v) {
  const Parts parts = parts_of(v);
  if (parts.mantissa == 0) return 0;
  const auto whole = static_cast<std::int64_t>(nearest_whole_of(parts));
  return parts.negative ? -whole : whole;
}

// The fraction as 64 bits is, in two's complement, what is above the nearest whole.
double rounding_of(Real v, int bits) {
  const Parts parts = parts_of(v);
  const int shift = -(parts.exponent + bits);
  if (shift <= 0 || shift > 128 + fraction_bits) return 0;
  const Bits128 fraction = shift <= 128 ? parts.mantissa << (128 - shift) : parts.mantissa >> (shift - 128);
  const auto above = static_cast<double>(static_cast<std::int64_t>(fraction >> 64)) * 0x1p-64;
  return parts.negative ? above : -above;
}

Bits128 whole_bits(Real v) {
  const Parts parts = parts_of(v);
  if (parts.exponent >= 0) return parts.mantissa << parts.exponent;
  return -parts.exponent > fraction_bits ? 0 : parts.mantissa >> -parts.exponent;
}

std::int64_t floor_within_62_bits(Real v) {
  constexpr std::int64_t most = std::int64_t{1} << 62;
  const Parts parts = parts_of(v);
  if (parts.mantissa == 0) return 0;
  if (parts.exponent > 62 - (fraction_bits + 1)) return parts.negative ? -most : most;
  const int shift = std::min(-parts.exponent, fraction_bits + 1);
  const auto whole = static_cast<std::int64_t>(parts.mantissa >> shift);
  if (!parts.negative) return whole;
  return Bits128{static_cast<std::uint64_t>(whole)} << shift == parts.mantissa ? -whole : -whole - 1;
}

double double_above(Real v) {
  const auto nearest = static_cast<double>(v);
  if (nearest == 0 && v == 0) return 0;
  return std::nextafter(nearest, std::numeric_limits<double>::infinity());
}

SineCosine sine_cosine_of_degrees(const std::string& text) {
  Mpfr angle(working_bits + 1100);  // every decimal up to 10^308 keeps its position in the turn
  Mpfr sine(working_bits);
  Mpfr cosine(working_bits);
  mpfr_set_str(angle.get(), text.c_str(), 10, MPFR_RNDN);
  mpfr_sinu(sine.get(), angle.get(), 360, MPFR_RNDN);
  mpfr_cosu(cosine.get(), angle.get(), 360, MPFR_RNDN);
  return {sine.to_real(), cosine.to_real()};
}

}  // namespace halfspace
