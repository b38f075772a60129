#include "firmware/core/line_section.hpp"

namespace halfspace {
namespace {

// In units of 2^unit. The terms at tau = 1 are up to 2 and 4 times those at the ends.
ShortPolynomial shortened(const LinePolynomial& p, int half_bits, int unit) {
  const auto cut = [](std::int64_t v, int shift) { return static_cast<std::int32_t>(v >> shift); };
  return {cut(p.v0, unit), cut(p.v1, unit + 2 - half_bits), cut(p.v2, unit + 3 - 2 * half_bits)};
}

}  // namespace

LineSection::LineSection(const SectionForms& forms, const LineForms& line)
    : forms_(forms),
      on_line_(line),
      tau_shift_(31 - line.half_bits),
      d_(shortened(line.d, line.half_bits, 28)),
      q_(shortened(line.q, line.half_bits, 28)),
      r_(shortened(line.r, line.half_bits, SectionForms::root_fraction)),
      l_(shortened(line.l, line.half_bits, SectionForms::light_fraction)) {}

ShortDot LineSection::asked_depth_dot(std::int32_t t) const { return depth_dot(t); }

}  // namespace halfspace
