#include "host/flatten/view.hpp"

#include <algorithm>

namespace halfspace {
namespace {

// Sines below this count as 0: decimals of parallel vectors, however they were computed, agree far better.
const Real parallel_sine = power_of_two(-80);

Vector3 to_vector(const std::array<Number, 3>& values) {
  return {decimal_to_real(values[0].text), decimal_to_real(values[1].text), decimal_to_real(values[2].text)};
}

// Parameters as they are set from left to right: the last of a kind holds, and so does the last of dop and cop.
struct Parameters {
  Vector3 vrp{};
  std::optional<Vector3> vpn;
  Vector3 vup{0, 1, 0};
  Vector3 dop = to_vector({Number{".3", .3}, Number{".3", .3}, Number{"-1", -1}});
  Vector3 cop{};
  bool perspective = false;
  std::optional<Real> half_width, half_height;
  std::optional<ClippingPlanes> clipping;

  void set(const ViewParameter& p);
};

void Parameters::set(const ViewParameter& p) {
  const Vector3 v =
      p.key == ViewKey::whh || p.key == ViewKey::whw || p.key == ViewKey::fbp ? Vector3{} : to_vector(p.values);
  const Vector3 direction = p.option == ViewOption::point ? difference(v, vrp) : v;
  switch (p.key) {
    case ViewKey::vrp:
      vrp = v;
      break;
    case ViewKey::vpn:
      vpn = direction;
      break;
    case ViewKey::vup:
      vup = direction;
      break;
    case ViewKey::dop:
      dop = direction;
      perspective = false;
      break;
    case ViewKey::cop:
      cop = p.option == ViewOption::relative ? sum(vrp, v) : v;
      perspective = true;
      break;
    case ViewKey::whh:
      half_height = decimal_to_real(p.values[0].text);
      break;
    case ViewKey::whw:
      half_width = decimal_to_real(p.values[0].text);
      break;
    case ViewKey::fbp:
      clipping = {decimal_to_real(p.values[0].text), decimal_to_real(p.values[1].text), p.position};
      break;
  }
}

// Where the parameter that is to blame stands; the view itself where it is a default.
SourcePosition position_of(const ViewStatement* view, ViewKey key) {
  if (view == nullptr) return {};
  SourcePosition position = view->position;
  for (const ViewParameter& p : view->parameters) {
    if (p.key == key) position = p.position;
  }
  return position;
}

class Settler {
 public:
  Settler(const ViewStatement* statement, Diagnostics& diagnostics)
      : statement_(statement), diagnostics_(diagnostics) {}

  std::optional<View> settle() {
    Parameters p;
    if (statement_ != nullptr) {
      for (const ViewParameter& parameter : statement_->parameters) p.set(parameter);
      view_.position = statement_->position;
    }
    view_.vrp = p.vrp;
    view_.cop = p.cop;
    view_.perspective = p.perspective;
    if (!settle_frame(p) || !settle_projection(p) || !settle_sizes(p)) return std::nullopt;
    return view_;
  }

 private:
  bool fail(ViewKey blame, const std::string& message) {
    diagnostics_.push_back({Severity::error, position_of(statement_, blame), message});
    return false;
  }

  bool settle_frame(const Parameters& p) {
    const Vector3 eye = p.perspective ? difference(p.vrp, p.cop) : scaled(p.dop, -1);
    const ViewKey projection = p.perspective ? ViewKey::cop : ViewKey::dop;
    if (largest(eye) == 0) {
      return fail(projection, p.perspective ? "cop is at vrp, so the view has no direction; move one of them"
                                            : "dop is the zero vector; give the direction to the eye");
    }
    const Vector3 normal = p.vpn ? *p.vpn : eye;
    if (largest(normal) == 0) return fail(ViewKey::vpn, "vpn is the zero vector; give it a direction");
    if (largest(p.vup) == 0) return fail(ViewKey::vup, "vup is the zero vector; give it a direction");
    view_.into = unit(normal);
    const Vector3 right = cross(unit(p.vup), view_.into);
    if (largest(right) < parallel_sine) {
      const char* inferred = p.vpn ? "" : p.perspective ? " (the direction from cop to vrp)" : " (the opposite of dop)";
      return fail(ViewKey::vup, "vup is parallel to vpn" + std::string(inferred) +
                                    ", so no direction of the page is up; turn vup or vpn to another direction");
    }
    view_.right = unit(right);
    view_.down = cross(view_.right, view_.into);
    return true;
  }

  bool settle_projection(const Parameters& p) {
    const Vector3 eye = p.perspective ? difference(p.vrp, p.cop) : scaled(p.dop, -1);
    const Real depth = dot(unit(eye), view_.into);
    if (magnitude(depth) < parallel_sine) {
      return p.perspective ? fail(ViewKey::cop, "cop lies in the view plane through vrp; move cop off it or turn vpn")
                           : fail(ViewKey::dop, "dop is parallel to the view plane; turn dop or vpn");
    }
    if (depth < 0) {
      return fail(ViewKey::vpn, p.perspective ? "vpn points to cop; it points into the scene: write its opposite"
                                              : "vpn points the way of dop, to the eye; it points into the "
                                                "scene: write its opposite");
    }
    if (!p.perspective) view_.ray = scaled(unit(eye), 1 / depth);
    return true;
  }

  bool settle_sizes(const Parameters& p) {
    if (p.half_width && !(*p.half_width > 0)) return fail(ViewKey::whw, "whw is not positive; give a size above 0");
    if (p.half_height && !(*p.half_height > 0)) return fail(ViewKey::whh, "whh is not positive; give a size above 0");
    view_.half_width = p.half_width;
    view_.half_height = p.half_height;
    view_.clipping = p.clipping;
    if (p.clipping && p.clipping->back < p.clipping->front) {
      return fail(ViewKey::fbp, "the front clipping plane of fbp lies behind the back one; exchange them");
    }
    return true;
  }

  const ViewStatement* statement_;
  Diagnostics& diagnostics_;
  View view_;
};

Real depth_of_vrp(const View& view) { return dot(difference(view.vrp, view.cop), view.into); }

}  // namespace

std::optional<View> settle_view(const Scene& scene, const std::string& id, Diagnostics& diagnostics) {
  if (id.empty()) {
    return Settler(scene.views.empty() ? nullptr : &scene.views.back(), diagnostics).settle();
  }
  const auto named =
      std::find_if(scene.views.begin(), scene.views.end(), [&](const ViewStatement& v) { return v.id == id; });
  if (named != scene.views.end()) return Settler(&*named, diagnostics).settle();
  if (id == "default") return Settler(nullptr, diagnostics).settle();
  Diagnostic unknown;
  unknown.message = "no view is named '" + id + "'; there is 'default'";
  for (const ViewStatement& view : scene.views) unknown.message += ", '" + view.id + "'";
  diagnostics.push_back(unknown);
  return std::nullopt;
}

Matrix4 view_to_world(const View& view) {
  const auto row = [](const Vector3& v, Real w) { return Vector4{v[0], v[1], v[2], w}; };
  if (!view.perspective) {
    return {row(view.right, 0), row(view.down, 0), row(view.ray, 0), row(view.vrp, 1)};
  }
  // With w = -f^2 / Z:  p / w = (X right + Y down + vrp - cop) / f - cop Z / f^2,  1 / w = -Z / f^2.
  const Real f = depth_of_vrp(view);
  return {row(scaled(view.right, 1 / f), 0), row(scaled(view.down, 1 / f), 0),
          row(scaled(view.cop, -1 / f / f), -1 / f / f), row(scaled(difference(view.vrp, view.cop), 1 / f), 0)};
}

std::array<Vector4, 3> directions_to_view(const View& view) {
  if (!view.perspective) {
    return {{{1, 0, 0, 0}, {0, 1, 0, 0}, {-dot(view.ray, view.right), -dot(view.ray, view.down), 1, 0}}};
  }
  const Vector3 eye_to_vrp = difference(view.vrp, view.cop);
  const Real f = depth_of_vrp(view);
  return {{{f, 0, 0, 0}, {0, f, 0, 0}, {-dot(eye_to_vrp, view.right), -dot(eye_to_vrp, view.down), 0, 1}}};
}

RealHalfSpace before_plane(const View& view, Real distance) {
  const Real offset = -dot(view.into, view.vrp) - distance;
  const RealHalfSpace world{HalfSpaceKind::plane, {view.into[0], view.into[1], view.into[2], offset}};
  return normalised(transformed(world, view_to_world(view)));
}

}  // namespace halfspace
