#include "host/flatten/far_directions.hpp"

#include <array>
#include <cmath>
#include <vector>

namespace halfspace {
namespace {

constexpr int most_parts = 400;
constexpr double rounding = 0x1p-44;
constexpr double underflow = 0x1p-800;

using Direction = std::array<double, 3>;

// Directions no further than `half` from the middle in two coordinates; the third is 1.
struct Part {
  Direction middle{};
  Direction half{};
};

// Positive where it forbids.
struct FarForm {
  bool is_plane = false;
  std::array<Direction, 3> rows{};  // Q, or n alone
  double margin = 0;
};

FarForm far_form(const Side& side) {
  FarForm form;
  form.is_plane = side.shape.kind == HalfSpaceKind::plane;
  double terms = 0;
  for (std::size_t i = 0; i < (form.is_plane ? 1U : 3U); ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const auto c = static_cast<double>(side.shape.c[form.is_plane ? j : quadric_index[i][j]]);
      form.rows[i][j] = side.complement ? -c : c;
      terms += std::abs(c);
    }
  }
  form.margin = rounding * terms + underflow;
  return form;
}

double dot(const Direction& a, const Direction& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
double sizes(const Direction& a, const Direction& half) {
  return std::abs(a[0]) * half[0] + std::abs(a[1]) * half[1] + std::abs(a[2]) * half[2];
}

// With the opposite directions, for which only planes differ.
struct Forbidden {
  bool there = false, opposite = false;
  [[nodiscard]] bool both() const { return there && opposite; }
};

void add(Forbidden& forbidden, const FarForm& form, const Part& part) {
  if (form.is_plane) {
    const double value = dot(form.rows[0], part.middle);
    const double change = sizes(form.rows[0], part.half) + form.margin;
    forbidden.there |= value - change > 0;
    forbidden.opposite |= -value - change > 0;
    return;
  }
  double value = 0;
  double change = form.margin;
  for (std::size_t i = 0; i < 3; ++i) {
    const double along = dot(form.rows[i], part.middle);
    value += along * part.middle[i];
    change += (2 * std::abs(along) + sizes(form.rows[i], part.half)) * part.half[i];
  }
  if (value - change > 0) forbidden = {true, true};
}

bool is_forbidden(const std::vector<FarForm>& forms, const Part& part) {
  Forbidden forbidden;
  for (const FarForm& form : forms) {
    add(forbidden, form, part);
    if (forbidden.both()) return true;
  }
  return false;
}

bool ends_in_face(const std::vector<FarForm>& forms, std::size_t axis) {
  const std::size_t u = (axis + 1) % 3;
  const std::size_t v = (axis + 2) % 3;
  Part whole{{0, 0, 0}, {1, 1, 1}};
  whole.middle[axis] = 1;
  whole.half[axis] = 0;
  std::vector<Part> open{whole};
  for (int n = 0; !open.empty(); ++n) {
    if (n == most_parts) return false;
    const Part part = open.back();
    open.pop_back();
    if (is_forbidden(forms, part)) continue;
    for (const int signs : {0, 1, 2, 3}) {
      Part quarter = part;
      quarter.half[u] = part.half[u] / 2;
      quarter.half[v] = part.half[v] / 2;
      quarter.middle[u] += (signs & 1) != 0 ? quarter.half[u] : -quarter.half[u];
      quarter.middle[v] += (signs & 2) != 0 ? quarter.half[v] : -quarter.half[v];
      open.push_back(quarter);
    }
  }
  return true;
}

}  // namespace

bool certainly_ends(std::span<const Side> sides) {
  std::vector<FarForm> forms;
  forms.reserve(sides.size());
  for (const Side& side : sides) forms.push_back(far_form(side));
  return ends_in_face(forms, 0) && ends_in_face(forms, 1) && ends_in_face(forms, 2);
}

}  // namespace halfspace
