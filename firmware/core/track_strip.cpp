#include "firmware/core/track_strip.hpp"

#include <algorithm>

namespace halfspace {
namespace {

constexpr int form_unit = 30;
constexpr std::int32_t longest_strip = 16;  // lines

std::int32_t cut(std::int64_t v, int shift) {
  return static_cast<std::int32_t>(shift >= 0 ? v >> shift : v * (1LL << -shift));
}

StripQuadratic about(const BlockQuadratic& p, std::int32_t v, std::int32_t half, int half_bits) {
  const LinePolynomial line = p.on(v);
  return {cut(line.v0, form_unit),
          cut(line.v1, form_unit - half_bits),
          cut(line.v2, form_unit + 1 - 2 * half_bits),
          cut(half * plus_product(p.y, 2 * v, p.yy), form_unit),
          cut(half * p.xy, form_unit - half_bits),
          cut(half * half * p.yy, form_unit)};
}
// In units of 2^shift.
StripLinear about(const BlockLinear& p, std::int32_t v, std::int32_t half, int half_bits, int shift) {
  const LinePolynomial line = p.on(v);
  return {cut(line.v0, shift), cut(line.v1, shift - half_bits), cut(half * p.y, shift)};
}

// Of paths, 2^-16 dot; and as far as units reach before any is known.
constexpr std::int32_t largest_dx = 8 << 16, largest_ddx = 1 << 14;
constexpr std::int32_t first_dx = 4 << 16, first_ddx = 1 << 11;

// To the block's ends, and an eighth beyond what the last strip's paths had.
TrackUnits units_for(std::int32_t half, std::int32_t most_dx, std::int32_t most_ddx) {
  const std::int32_t dx = most_dx == 0 ? first_dx : most_dx + most_dx / 8;
  const std::int32_t ddx = most_ddx == 0 ? first_ddx : most_ddx + most_ddx / 8;
  return {half << (16 - 13), (dx >> 9) + 1, (ddx >> 4) + 1};
}

std::int32_t size(std::int32_t v) { return v < 0 ? -v : v; }

}  // namespace

void TrackStrip::meet(std::int32_t dx, std::int32_t ddx) {
  most_dx = std::clamp(size(dx), most_dx, largest_dx);
  most_ddx = std::clamp(size(ddx), most_ddx, largest_ddx);
}

void TrackStrip::cover(const SectionForms& forms, std::int32_t y) {
  const std::int32_t rest = forms.y1 - y;
  const std::int32_t strips = (rest + longest_strip - 1) / longest_strip;
  first = y;
  end = y + (rest + strips - 1) / strips;
  half = std::max<std::int32_t>((end - first) / 2, 1);
  middle = first + half;
  from = forms.middle;
  unit = units_for(forms.half, most_dx, most_ddx);
  most_dx = most_ddx = 0;
  last[0].turn = last[1].turn = {};
  const std::int32_t v = middle - forms.line;
  d = about(forms.d, v, half, forms.half_bits);
  q = about(forms.q, v, half, forms.half_bits);
  r = about(forms.r, v, half, forms.half_bits, SectionForms::root_fraction);
  l = about(forms.l, v, half, forms.half_bits, SectionForms::light_fraction + 2);
}

}  // namespace halfspace
