#include "firmware/core/track_strip.hpp"

#include <algorithm>

namespace halfspace {
namespace {

constexpr int unit = 30;
constexpr std::int32_t longest_strip = 16;  // lines

std::int32_t cut(std::int64_t v, int shift) {
  return static_cast<std::int32_t>(shift >= 0 ? v >> shift : v * (1LL << -shift));
}

StripQuadratic about(const BlockQuadratic& p, std::int32_t v, std::int32_t half, int half_bits) {
  const LinePolynomial line = p.on(v);
  return {cut(line.v0, unit),
          cut(line.v1, unit - half_bits),
          cut(line.v2, unit + 1 - 2 * half_bits),
          cut(half * plus_product(p.y, 2 * v, p.yy), unit),
          cut(half * p.xy, unit - half_bits),
          cut(half * half * p.yy, unit)};
}
// In units of 2^shift.
StripLinear about(const BlockLinear& p, std::int32_t v, std::int32_t half, int half_bits, int shift) {
  const LinePolynomial line = p.on(v);
  return {cut(line.v0, shift), cut(line.v1, shift - half_bits), cut(half * p.y, shift)};
}

}  // namespace

void TrackStrip::cover(const SectionForms& forms, std::int32_t y) {
  const std::int32_t rest = forms.y1 - y;
  const std::int32_t strips = (rest + longest_strip - 1) / longest_strip;
  first = y;
  end = y + (rest + strips - 1) / strips;
  half = std::max<std::int32_t>((end - first) / 2, 1);
  middle = first + half;
  const std::int32_t v = middle - forms.line;
  d = about(forms.d, v, half, forms.half_bits);
  q = about(forms.q, v, half, forms.half_bits);
  r = about(forms.r, v, half, forms.half_bits, SectionForms::root_fraction);
  l = about(forms.l, v, half, forms.half_bits, SectionForms::light_fraction + 2);
}

}  // namespace halfspace
