#include "firmware/core/radical_plane.hpp"

#include <algorithm>
#include <utility>

#include "firmware/core/real.hpp"

namespace halfspace {
namespace {

constexpr int frame_bits = 17;  // of x and y in a face's frame
constexpr int value_bits = 61;  // of l: sums of three such stay inside 64 bits

// A line's signs: 1, the inner face is nearer; -1, the rival is; 0, it cannot be told.
class RadicalLine {
 public:
  RadicalLine(const ActiveFace& inner, const RadicalPlane& plane, std::int32_t y) : k_(inner.block) {
    const std::int32_t s = y - k_.y0;
    d_ = k_.d + part(k_.dy + k_.dyy * s, s, k_.y_bits);
    dx_ = k_.dx + k_.dxy * s;
    l_ = plane.c + plane.x * (k_.x0 - inner.origin_x) + plane.y * (y - inner.origin_y);
    lx_ = plane.x;
    const int unit = inner.inverse_exponent - depth_fraction - k_.shift;  // log2 of the block's
    shift_ = plane.fraction + unit;
    if (!is_usable()) return;
    const std::int32_t reach = std::max(std::abs(k_.x0 - inner.origin_x), std::abs(k_.x1 - inner.origin_x));
    error_ = 2 + (std::int64_t{2} * (reach + std::abs(y - inner.origin_y) + 1) >> shift_);
  }
  [[nodiscard]] bool is_usable() const { return k_.error >= 0 && k_.shift < 63 && shift_ >= 0 && shift_ < 64; }

  // l in units, to within error(); 2^30 where it is more.
  [[nodiscard]] std::int64_t plane(std::int32_t x) const {
    return std::min<std::int64_t>((l_ + lx_ * (x - k_.x0)) >> shift_, farthest);
  }
  [[nodiscard]] std::int64_t error() const { return error_; }
  // l's coefficients are off by less than 2 each, D by less than `shallow`; r is below 2^30.
  [[nodiscard]] int sign(std::int32_t x) const {
    const std::int64_t l = plane(x);
    if (l < -error_) return 1;
    const std::int64_t d = discriminant(x);
    if (d - k_.shallow >= (l + error_) * (l + error_)) return 1;
    return l > error_ && d + k_.shallow <= (l - error_) * (l - error_) ? -1 : 0;
  }
  // l is 2^30 at least, and taken for that.
  [[nodiscard]] bool is_far(std::int32_t x) const { return plane(x) == farthest; }
  // D - l^2 to within value_error(), where 0 < l and not is_far(); more than it where that is so.
  [[nodiscard]] std::int64_t value(std::int32_t x) const {
    const std::int64_t l = plane(x);
    return discriminant(x) - l * l;
  }
  [[nodiscard]] std::int64_t value_error() const { return (error_ + 1) * (std::int64_t{1} << 32); }

 private:
  [[nodiscard]] std::int64_t discriminant(std::int32_t x) const {
    const std::int32_t t = x - k_.x0;
    return d_ + part(dx_ + k_.dxx * t, t, k_.x_bits);
  }

  static constexpr std::int64_t farthest = 1 << 30;

  const DepthBlock& k_;
  std::int64_t d_, dx_, l_, lx_;
  std::int64_t error_ = 0;  // of l in units: by less, its floor taken in
  int shift_;
};

// Dots a and b show the rival. The dot between where D - l^2 is greatest, or about there, by its slopes at both ends.
std::int32_t find_top(const RadicalLine& line, std::int32_t a, std::int32_t b) {
  if (b - a < 2) return a;
  const std::int64_t rise = line.value(a + 1) - line.value(a);
  const std::int64_t fall = line.value(b - 1) - line.value(b);
  if (rise <= 0) return a;
  if (fall <= 0) return b;
  const int shift = std::max(0, static_cast<int>(std::bit_width(static_cast<std::uint64_t>(rise | fall))) - 16);
  const auto up = static_cast<std::uint32_t>(rise >> shift);
  const auto down = static_cast<std::uint32_t>(fall >> shift);
  return a + static_cast<std::int32_t>(static_cast<std::uint32_t>(b - a) * up / (up + down));
}

// Whether D - l^2 is negative on all dots of a .. b, as it is at its top, about: it lies below the lines through that and its neighbours.
bool is_negative(const RadicalLine& line, std::int32_t a, std::int32_t b, std::int32_t top) {
  constexpr std::int64_t steepest = std::int64_t{1} << 45;
  const std::int64_t error = line.value_error();
  const std::int64_t value = line.value(top) + error;
  const auto is_below = [&](std::int32_t next, std::int32_t count) {
    const std::int64_t rise = line.value(next) - value + 3 * error;
    return rise <= steepest && value + std::max<std::int64_t>(rise, 0) * count < 0;
  };
  return !line.is_far(top) && (top == a || is_below(top - 1, top - a)) && (top == b || is_below(top + 1, b - top));
}

}  // namespace

// In the face's frame, with D_rival there: l = (D_rival a a - D a_rival a_rival - k k) / 2 k a_rival, in units of D's root. Second-order
// terms cancel.
RadicalPlane radical_plane(const ActiveFace& face, const ActiveFace& rival, const Wide<256>& k) {
  constexpr RadicalPlane none{0, 0, 0, RadicalPlane::missing};
  const ScaledQuadratic& d = face.surface.discriminant;
  const ScaledQuadratic& e = rival.surface.discriminant;
  const std::int32_t dx = face.origin_x - rival.origin_x;
  const std::int32_t dy = face.origin_y - rival.origin_y;
  if (d.exponent != 0 || e.exponent != 0 || std::max(std::abs(dx), std::abs(dy)) >> frame_bits != 0 || k.is_zero())
    return none;
  const BoundedReal a(face.c[2], 0);
  const BoundedReal b(rival.c[2], 0);
  const BoundedReal constant(k, 0);
  const BoundedReal a2 = a * a;
  const BoundedReal b2 = b * b;
  const BoundedReal scale = BoundedReal(1).half() / (constant * b);
  const BoundedReal x =
      (BoundedReal(e.q[0].times(2 * dx) + e.q[1].times(dy) + e.q[3], 0) * a2 - BoundedReal(d.q[3], 0) * b2) * scale;
  const BoundedReal y =
      (BoundedReal(e.q[2].times(2 * dy) + e.q[1].times(dx) + e.q[4], 0) * a2 - BoundedReal(d.q[4], 0) * b2) * scale;
  const BoundedReal c = (BoundedReal(e.at(dx, dy), 0) * a2 - BoundedReal(d.q[5], 0) * b2 - constant * constant) * scale;
  const int fraction = value_bits - 1 - std::max({c.bits(), x.bits() + frame_bits, y.bits() + frame_bits});
  const auto is_known = [&](const BoundedReal& value) { return value.error_of(fraction) <= 2; };
  if (fraction <= RadicalPlane::missing || fraction > INT16_MAX || !is_known(x) || !is_known(y) || !is_known(c))
    return none;
  return {c.fixed(fraction), x.fixed(fraction), y.fixed(fraction), static_cast<std::int16_t>(fraction)};
}

int nearer_by_plane(const ActiveFace& inner, const DepthProof& over) {
  const RadicalLine first(inner, over.radical, over.y0);
  const RadicalLine last(inner, over.radical, over.y1);
  if (!first.is_usable()) return 0;
  const std::int64_t corners[4] = {first.plane(over.x0), first.plane(over.x1), last.plane(over.x0),
                                   last.plane(over.x1)};
  const DepthBlock& k = inner.block;
  const DepthRange r = root_over(k, {over.x0 - k.x0, over.x1 - k.x0, over.y0 - k.y0, over.y1 - k.y0});
  const std::int64_t error = std::max(first.error(), last.error());
  if (r.low > *std::max_element(corners, corners + 4) + error) return 1;
  return r.high < *std::min_element(corners, corners + 4) - error ? -1 : 0;
}

bool find_inner_dots(const ActiveFace& inner, DepthProof& proof, std::int32_t y, std::int32_t a, std::int32_t b,
                     InnerDots& found) {
  const RadicalLine line(inner, proof.radical, y);
  const std::int32_t guess = std::exchange(proof.crossing, std::int16_t{-1});
  if (!line.is_usable()) return false;
  const int left = line.sign(a);
  const int right = line.sign(b);
  if (left == 0 || right == 0) return false;
  found = {a, b};
  if (left > 0 && right > 0) return true;
  std::int32_t top = left > 0 ? a : b;
  if (left == right) {
    top = find_top(line, a, b);
    const int sign = line.sign(top);
    if (sign < 0) found.to = a - 1;
    if (sign <= 0) return sign < 0 && is_negative(line, a, b, top);
  }
  const auto sign_at = [&line](std::int32_t x) { return line.sign(x); };
  if (left < 0) found.from = find_change(sign_at, a, top, left, guess);
  if (right < 0) found.to = find_change(sign_at, top, b, 1, guess) - 1;
  if (found.from < 0 || found.to < 0) return false;
  proof.crossing = static_cast<std::int16_t>(left < 0 ? found.from : found.to + 1);
  return true;
}

}  // namespace halfspace
