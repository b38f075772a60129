// traced_curve.hpp - a curve of a face with what is known of its making: where it meets others follows from that.
// A section of a quadric with a plane has, in the terms of sheet.hpp, P = line and R = factor constant: it is line^2 = factor^2 d.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "host/resolve/interval_curve.hpp"
#include "host/resolve/resolved_scene.hpp"

namespace halfspace {

// The curve is line^2 - factor^2 d = 0 up to a constant, d the same for all sections of a list. The limb d = 0 has the line 0.
struct Section {
  Curve line;
  mpz_class factor;
};

struct TracedCurve {
  Curve curve;  // irreducible over the rationals, canonical
  IntervalCurve enclosed;
  std::optional<Section> section;
  bool later = false;                      // of a half-space after the face's own
  bool own = false;                        // where the sheets begin: a limb or a pole
  std::vector<std::uint32_t> constraints;  // indices: of whose zeros it is a part
};

// Adds the factors of p, where the sheets begin.
void trace_own(Curve p, std::optional<Section>&& section, std::vector<TracedCurve>& curves);

// Adds the factors of p, none twice, as zeros of a constraint; `section` is p's.
void trace(Curve p, std::optional<Section>&& section, bool later, std::uint32_t constraint,
           std::vector<TracedCurve>& curves);

// Lines that pass through every point where two curves of second order meet: p meets each of them there. None known: nothing.
[[nodiscard]] std::optional<std::vector<Curve>> lines_through_meeting(const TracedCurve& p, const TracedCurve& q);

}  // namespace halfspace
