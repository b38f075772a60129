#include "host/resolve/sheet.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "host/algebra/content.hpp"

namespace halfspace {
namespace {

void negate(Surface& surface) {
  mpz_neg(surface.a.get_mpz_t(), surface.a.get_mpz_t());
  negate(surface.b);
  negate(surface.c);
  surface.sense = -surface.sense;
}

SheetShape shape_of(const Surface& surface, bool curved) {
  if (sgn(surface.a) != 0) return SheetShape::two_sheets;
  if (is_zero(surface.b)) return SheetShape::none;
  return curved ? SheetShape::rational : SheetShape::flat;
}

// Are the coefficients of s and t proportional?
bool same_surface(const Surface& s, const Surface& t) {
  const auto coefficients = [](const Surface& f) {
    return std::array{&f.a,      &f.b.q[3], &f.b.q[4], &f.b.q[5], &f.c.q[0],
                      &f.c.q[1], &f.c.q[2], &f.c.q[3], &f.c.q[4], &f.c.q[5]};
  };
  const auto p = coefficients(s);
  const auto q = coefficients(t);
  for (std::size_t i = 0; i < p.size(); ++i) {
    if ((sgn(*p[i]) == 0) != (sgn(*q[i]) == 0)) return false;
  }
  const auto leading = std::find_if(p.begin(), p.end(), [](const mpz_class* c) { return sgn(*c) != 0; });
  if (leading == p.end()) return false;
  const auto i = static_cast<std::size_t>(leading - p.begin());
  for (std::size_t j = i + 1; j < p.size(); ++j) {
    if (*p[i] * *q[j] != *p[j] * *q[i]) return false;
  }
  return true;
}

void divide_by_common_content(Curve& p, Curve& r) {
  const mpz_class divisor = gcd(content(p.q), content(r.q));
  if (divisor <= 1) return;
  for (mpz_class& q : p.q) q /= divisor;
  for (mpz_class& q : r.q) q /= divisor;
}

bool is_line(const Curve& p) { return sgn(p.q[0]) == 0 && sgn(p.q[1]) == 0 && sgn(p.q[2]) == 0; }

bool is_plane(const Surface& s) { return sgn(s.a) == 0 && is_constant(s.b) && is_line(s.c); }

// 2 a^2 (a' z^2 + b' z + c') on z = (-b + t sqrt(d)) / 2a, of a plane divided by a; of others without their common factor, for
// the quartic is made of them.
void set_form_on_two_sheets(const Surface& own, Constraint& other) {
  const Surface& k = other.surface;
  if (is_plane(k)) {
    other.p = minus_multiple(2 * own.a * k.c, k.b.q[5], own.b);
    other.r = k.b;
    return;
  }
  const Curve bb = product_of_lines(own.b, own.b);
  other.p = k.a * (bb - 2 * own.a * own.c) - own.a * product_of_lines(own.b, k.b) + 2 * own.a * own.a * k.c;
  other.r = own.a * k.b - k.a * own.b;
  divide_by_common_content(other.p, other.r);
}

// C^2 (a' z^2 + b' z + c') on a plane C z + l = 0 that is not parallel to the rays.
Curve value_on_plane(const Surface& k, const Surface& plane) {
  const mpz_class& slope = plane.b.q[5];
  const Curve line = minus_multiple(k.a * plane.c, slope, k.b);
  return plus_multiple(product_of_lines(line, plane.c), slope * slope, k.c);
}

// The same, of a plane divided by |C|.
Curve plane_on_plane(const Surface& k, const Surface& plane) {
  const mpz_class& slope = plane.b.q[5];
  Curve value = minus_multiple(slope * k.c, k.b.q[5], plane.c);
  return sgn(slope) < 0 ? -1 * value : value;
}

void set_form(const Sheets& sheets, Constraint& other) {
  if (sheets.shape == SheetShape::two_sheets) set_form_on_two_sheets(sheets.surface, other);
  if (sheets.shape == SheetShape::flat) {
    const Surface& k = other.surface;
    other.p = is_plane(k) ? plane_on_plane(k, sheets.surface) : value_on_plane(k, sheets.surface);
  }
}

// Where a plane meets the surface.
Curve section(const Surface& quadric, const Surface& plane) {
  return sgn(plane.b.q[5]) == 0 ? plane.c : value_on_plane(quadric, plane);
}

// A constraint's line and factor, where it is of first order on two sheets.
std::optional<Section> section_terms(const Sheets& sheets, const Constraint& k) {
  if (sheets.shape != SheetShape::two_sheets || !is_line(k.p) || !is_constant(k.r)) return std::nullopt;
  return Section{k.p, k.r.q[5]};
}

// On a curved sheet.
void set_meeting(const Sheets& sheets, const IntegerHalfSpace& half_space, Constraint& other) {
  const Surface& own = sheets.surface;
  const Surface& k = other.surface;
  if (!is_curved(half_space)) {
    other.section = section(own, k);
  } else if (sheets.shape == SheetShape::two_sheets) {
    other.n = product(other.p, other.p) - product(product_of_lines(other.r, other.r), sheets.d);
  } else {
    other.n = k.a * product(own.c, own.c) - product(product_of_lines(k.b, own.b), own.c) +
              product(product_of_lines(own.b, own.b), k.c);
  }
}

void add_quartic(const Sheets& sheets, KnownQuartic* curve, std::uint32_t constraint, const std::vector<Curve>& others,
                 std::vector<TracedQuartic>& quartics) {
  auto traced = std::find_if(quartics.begin(), quartics.end(),
                             [curve](const TracedQuartic& known) { return known.curve == curve; });
  if (traced == quartics.end()) {
    const Constraint& k = sheets.constraints[constraint];
    traced = quartics.insert(traced, {curve, {}, {}, std::nullopt});
    if (sheets.shape == SheetShape::two_sheets) traced->radical = Radical{k.p, k.r};
  }
  traced->constraints.push_back(constraint);
  traced->others.push_back(&others);
}

// The curves of a quadric on a quadric's sheets. n vanishes throughout where both hold a plane: then P^2 = R^2 d, and the value
// P + R sqrt(d) changes sign on P = 0 at most.
void trace_meeting(const Sheets& sheets, std::uint32_t index, QuarticTable& table, BoundingCurves& bounds) {
  const Constraint& k = sheets.constraints[index];
  const bool later = k.half_space > sheets.half_space;
  if (is_zero(k.n)) return trace(k.p, std::nullopt, later, index, bounds.curves);
  const KnownFactors& parts = table.factors_of(k.n);
  const bool is_one = parts.curves.size() == 1;
  for (const Curve& part : parts.curves) {
    trace(part, is_one ? section_terms(sheets, k) : std::nullopt, later, index, bounds.curves);
  }
  for (KnownQuartic* part : parts.quartics) add_quartic(sheets, part, index, parts.curves, bounds.quartics);
}

}  // namespace

bool is_curved(const IntegerHalfSpace& half_space) {
  const auto& c = half_space.c;
  return half_space.kind == HalfSpaceKind::quadric &&
         std::any_of(c.begin(), c.begin() + 6, [](const mpz_class& q) { return sgn(q) != 0; });
}

Surface surface_of(const IntegerHalfSpace& half_space) {
  const auto& c = half_space.c;
  const int sense = half_space.complement ? -1 : 1;
  if (half_space.kind == HalfSpaceKind::plane) return {0, constant_curve(c[2]), {{0, 0, 0, c[0], c[1], c[3]}}, sense};
  const auto twice = [&c](std::size_t i) { return sgn(c[i]) == 0 ? mpz_class() : mpz_class(2 * c[i]); };
  return {c[2], {{0, 0, 0, twice(5), twice(4), twice(8)}}, {{c[0], twice(3), c[1], twice(6), twice(7), c[9]}}, sense};
}

Sheets::Sheets(const IntegerBody& body, std::uint32_t index)
    : half_space(index),
      curved(is_curved(body.half_spaces[index])),
      shape(SheetShape::none),
      surface(surface_of(body.half_spaces[index])) {
  shape = shape_of(surface, curved);
  if (shape == SheetShape::none) return;
  if (sgn(surface.a) < 0) negate(surface);
  if (shape == SheetShape::two_sheets) {
    d = product_of_lines(surface.b, surface.b);
    subtract_multiple(d, 4 * surface.a, surface.c);
  }
  constraints.reserve(body.half_spaces.size() - 1);
  for (std::uint32_t k = 0; k < body.half_spaces.size(); ++k) {
    if (k == index) continue;
    Surface other_surface = surface_of(body.half_spaces[k]);
    if (same_surface(surface, other_surface)) continue;
    Constraint& other = constraints.emplace_back();
    other.half_space = k;
    other.surface = std::move(other_surface);
    set_form(*this, other);
    if (curved) set_meeting(*this, body.half_spaces[k], other);
  }
}

std::span<const Sheet> sheets_in(const Sheets& sheets) {
  static constexpr std::array all{Sheet::only, Sheet::front, Sheet::back};
  if (sheets.shape == SheetShape::none) return {};
  const bool is_single = sheets.shape != SheetShape::two_sheets;
  return std::span(all).subspan(is_single ? 0 : 1, is_single ? 1 : 2);
}

bool has_zero_constraint(const Sheets& sheets) {
  return std::any_of(sheets.constraints.begin(), sheets.constraints.end(), [&](const Constraint& k) {
    if (!sheets.curved) return is_zero(k.p);
    return k.section ? is_zero(*k.section) : is_zero(k.n);
  });
}

BoundingCurves bounding_curves(const Sheets& sheets, QuarticTable& table) {
  BoundingCurves bounds;
  std::vector<TracedCurve>& curves = bounds.curves;
  curves.reserve(1 + sheets.constraints.size());
  if (sheets.shape == SheetShape::two_sheets) {
    std::optional<Section> limb;
    limb.emplace().factor = 1;
    trace_own(sheets.d, std::move(limb), curves);
  }
  if (sheets.shape == SheetShape::rational) trace_own(sheets.surface.b, std::nullopt, curves);
  for (std::uint32_t i = 0; i < sheets.constraints.size(); ++i) {
    const Constraint& k = sheets.constraints[i];
    const bool later = k.half_space > sheets.half_space;
    if (!sheets.curved) {
      trace(k.p, std::nullopt, later, i, curves);
    } else if (k.section) {
      trace(*k.section, section_terms(sheets, k), later, i, curves);
    } else {
      trace_meeting(sheets, i, table, bounds);
    }
  }
  return bounds;
}

}  // namespace halfspace
