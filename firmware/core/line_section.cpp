#include "firmware/core/line_section.hpp"

namespace halfspace {
namespace {

// In units of 2^unit. The terms at tau = 1 are up to 2 and 4 times those at the ends.
ShortPolynomial shortened(const LinePolynomial& p, int half_bits, int unit) {
  const auto cut = [](std::int64_t v, int shift) { return static_cast<std::int32_t>(v >> shift); };
  return {cut(p.v0, unit), cut(p.v1, unit + 2 - half_bits), cut(p.v2, unit + 3 - 2 * half_bits)};
}

}  // namespace

LineSection::LineSection(const SectionForms& forms, std::int32_t y)
    : forms_(forms),
      half_bits_(static_cast<int>(std::bit_width(static_cast<std::uint32_t>(forms.half)))),
      tau_shift_(31 - half_bits_),
      d_(forms.d.on(y - forms.line)),
      q_(forms.q.on(y - forms.line)),
      r_(forms.r.on(y - forms.line)),
      l_(forms.l.on(y - forms.line)),
      short_q_(shortened(q_, half_bits_, short_unit)),
      short_r_(shortened(r_, half_bits_, 32)),
      short_l_(shortened(l_, half_bits_, SectionForms::light_fraction)) {}

}  // namespace halfspace
