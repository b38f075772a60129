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

// As dot(), of sigma. Where that is too far for words the errors are so large that nothing follows.
ShortDot LineSection::sheared_dot(std::int32_t t) const {
  const ShearedRoot root = forms_.sheared_root(on_line_.d, on_line_.plane, t);
  const std::int32_t root_error = (root.error >> forms_.shear.bits) + 4;
  if (root.is_far()) return {root.s, 0, 0, 0, root_error, 1 << 30, 1 << 26};
  const std::int32_t twice = static_cast<std::int32_t>(root.sigma) << 1;
  const std::int32_t r = r_.linear(tau(t));
  const std::int32_t l = l_.linear(tau(t)) + (high_product(forms_.m, twice) << 1);
  const std::int32_t square = q_.at(tau(t)) + high_product(r << 3, twice);
  return {root.s, r, l, square, root_error, root.error * forms_.m_size + 22, root.error + 118};
}

}  // namespace halfspace
