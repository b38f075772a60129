#include "tests/oracle/true_scene.hpp"

#include <algorithm>
#include <map>
#include <variant>

namespace halfspace::oracle {
namespace {

Real real(const Number& n) { return Real::parse(n.text); }

Vector3 vector(const std::array<Number, 3>& n) { return {real(n[0]), real(n[1]), real(n[2])}; }

Real dot(const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector3 operator-(const Vector3& a, const Vector3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

Vector3 operator+(const Vector3& a, const Vector3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

Vector3 negated(const Vector3& a) { return {-a[0], -a[1], -a[2]}; }

Vector3 unit(const Vector3& a, const char* what) {
  const Real length = sqrt(dot(a, a));
  if (!(length > Real(0x1p-200))) throw MeaninglessScene(std::string(what) + " has no direction");
  return {a[0] / length, a[1] / length, a[2] / length};
}

Matrix4 identity() {
  Matrix4 m;
  for (int i = 0; i < 4; ++i) m[i][i] = 1;
  return m;
}

Matrix4 operator*(const Matrix4& a, const Matrix4& b) {
  Matrix4 m;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      for (int k = 0; k < 4; ++k) m[i][j] += a[i][k] * b[k][j];
    }
  }
  return m;
}

Matrix4 transposed(const Matrix4& a) {
  Matrix4 m;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) m[i][j] = a[j][i];
  }
  return m;
}

// --- Placement: the way back from the world into a definition's coordinates.

Real reciprocal(const Number& factor) {
  const Real f = real(factor);
  if (f == Real(0)) throw MeaninglessScene("a scale is zero");
  return Real(1) / f;
}

struct Inverse {
  Matrix4 operator()(const TranslateTransform& t) const {
    Matrix4 m = identity();
    m[3][static_cast<int>(t.axis)] = -real(t.distance);
    return m;
  }
  Matrix4 operator()(const TranslateAllTransform& t) const {
    Matrix4 m = identity();
    for (int i = 0; i < 3; ++i) m[3][i] = -real(t.distance);
    return m;
  }
  Matrix4 operator()(const ScaleTransform& t) const {
    Matrix4 m = identity();
    m[static_cast<int>(t.axis)][static_cast<int>(t.axis)] = reciprocal(t.factor);
    return m;
  }
  Matrix4 operator()(const ScaleAllTransform& t) const {
    Matrix4 m = identity();
    for (int i = 0; i < 3; ++i) m[i][i] = reciprocal(t.factor);
    return m;
  }
  // By -a in the plane of the two axes that follow: (p, q) -> (p cos a + q sin a, q cos a - p sin a).
  Matrix4 operator()(const RotateTransform& t) const {
    const int p = (static_cast<int>(t.axis) + 1) % 3;
    const int q = (p + 1) % 3;
    const Real degrees = real(t.degrees);
    Matrix4 m = identity();
    m[p][p] = m[q][q] = Real::cos_degrees(degrees);
    m[q][p] = Real::sin_degrees(degrees);
    m[p][q] = -m[q][p];
    return m;
  }
  Matrix4 operator()(const ShearTransform& t) const {
    Matrix4 m = identity();
    m[static_cast<int>(t.along)][static_cast<int>(t.moved)] = -real(t.amount);
    return m;
  }
};

Matrix4 inverse_of(const std::vector<Transform>& transforms) {
  Matrix4 m = identity();
  for (const Transform& t : transforms) m = std::visit(Inverse{}, t) * m;
  return m;
}

TrueHalfSpace placed(const PlaneStatement& statement, const Matrix4& inverse) {
  TrueHalfSpace h;
  h.transparent = statement.transparent;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) h.plane[i] += inverse[i][j] * real(statement.coefficients[j]);
  }
  return h;
}

TrueHalfSpace placed(const QuadricStatement& statement, const Matrix4& inverse) {
  static constexpr int order[4][4] = {{0, 3, 5, 6}, {3, 1, 4, 7}, {5, 4, 2, 8}, {6, 7, 8, 9}};  // A D F G ...
  Matrix4 local;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) local[i][j] = real(statement.coefficients[order[i][j]]);
  }
  TrueHalfSpace h;
  h.is_quadric = true;
  h.transparent = statement.transparent;
  h.quadric = inverse * local * transposed(inverse);
  return h;
}

class Flattening {
 public:
  Flattening(const Scene& scene, std::vector<TrueBody>& bodies) : bodies_(bodies) {
    for (const Group& group : scene.definitions) definitions_[group.id] = &group;
  }

  void place(const Group& group, const Matrix4& inverse) {
    for (const Placement& placement : group.placements) {
      std::visit([&](const auto& statement) { place(group, statement, inverse); }, placement);
    }
  }

 private:
  void place(const Group& group, const BodyStatement& body, const Matrix4& inverse) {
    TrueBody& to = bodies_.emplace_back();
    for (const HalfSpaceReference& reference : body.half_spaces) {
      to.push_back(find(group, reference.id, inverse));
      to.back().complement = reference.complement;
    }
  }

  void place(const Group& /*group*/, const InstanceStatement& instance, const Matrix4& inverse) {
    place(*definitions_.at(instance.definition), inverse * inverse_of(instance.transforms));
  }

  // Copy k stands at initial * delta^k * parent: the way back starts at the parent.
  void place(const Group& /*group*/, const ArrayStatement& array, const Matrix4& inverse) {
    const Matrix4 initial = inverse_of(array.initial);
    const Matrix4 delta = inverse_of(array.delta);
    Matrix4 back = inverse;
    for (std::uint32_t k = 0; k < array.count; ++k) {
      place(*definitions_.at(array.definition), back * initial);
      back = back * delta;
    }
  }

  static TrueHalfSpace find(const Group& group, const std::string& id, const Matrix4& inverse) {
    const auto named = [&](const auto& statement) { return statement.id == id; };
    const auto plane = std::find_if(group.planes.begin(), group.planes.end(), named);
    if (plane != group.planes.end()) return placed(*plane, inverse);
    const auto quadric = std::find_if(group.quadrics.begin(), group.quadrics.end(), named);
    if (quadric != group.quadrics.end()) return placed(*quadric, inverse);
    throw MeaninglessScene("no half-space " + id);
  }

  std::vector<TrueBody>& bodies_;
  std::map<std::string, const Group*> definitions_;
};

// --- Light and view.

Real clamped(const Real& x) { return x < Real(0) ? Real(0) : (x > Real(1) ? Real(1) : x); }

TrueLight true_light(const Scene& scene) {
  TrueLight light{0, 1, {0, 0, -1}};
  for (const LightStatement& statement : scene.lights) {
    const Real intensity = clamped(real(statement.intensity));
    if (statement.direction) {
      light.parallel = intensity;
      light.direction = unit(vector(*statement.direction), "a light");
    } else {
      light.ambient += intensity;
    }
  }
  return light;
}

const ViewStatement* chosen_view(const Scene& scene, const std::string& id) {
  if (id.empty()) return scene.views.empty() ? nullptr : &scene.views.back();
  const auto named = [&](const ViewStatement& view) { return view.id == id; };
  const auto found = std::find_if(scene.views.rbegin(), scene.views.rend(), named);
  if (found == scene.views.rend()) throw MeaninglessScene("no view " + id);
  return &*found;
}

// The parameters as set from left to right.
struct ViewParameters {
  Vector3 vrp, vup{0, 1, 0}, dop{Real::parse(".3"), Real::parse(".3"), -1};
  std::optional<Vector3> vpn, eye;
  std::optional<Real> half_width, half_height;
  std::optional<std::array<Real, 2>> clipping;

  void set(const ViewParameter& parameter) {
    const Vector3 v = vector_of(parameter);
    const Vector3 direction = parameter.option == ViewOption::point ? v - vrp : v;
    switch (parameter.key) {
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
        eye.reset();
        break;
      case ViewKey::cop:
        eye = parameter.option == ViewOption::relative ? v + vrp : v;
        break;
      case ViewKey::whh:
        half_height = v[0];
        break;
      case ViewKey::whw:
        half_width = v[0];
        break;
      case ViewKey::fbp:
        clipping = {v[0], v[1]};
        break;
    }
  }

 private:
  // The values that the key has; the others are empty.
  static Vector3 vector_of(const ViewParameter& parameter) {
    Vector3 v;
    for (int i = 0; i < 3; ++i) {
      if (!parameter.values[i].text.empty()) v[i] = real(parameter.values[i]);
    }
    return v;
  }
};

TrueView true_view(const ViewParameters& parameters) {
  TrueView view;
  view.vrp = parameters.vrp;
  view.perspective = parameters.eye.has_value();
  if (view.perspective) view.eye = *parameters.eye;
  view.ray = negated(parameters.dop);
  const Vector3 ahead = view.perspective ? view.vrp - view.eye : view.ray;
  view.normal = unit(parameters.vpn.value_or(ahead), "the view's normal");
  view.right = unit(cross(parameters.vup, view.normal), "vup beside vpn");
  view.up = cross(view.normal, view.right);
  if (!(dot(view.normal, ahead) > Real(0))) throw MeaninglessScene("the view plane does not face the eye");
  view.half_width = parameters.half_width;
  view.half_height = parameters.half_height;
  return view;
}

// d1 <= normal . (X - vrp) <= d2.
void clip(TrueScene& scene, const std::array<Real, 2>& distances) {
  const Vector3& n = scene.view.normal;
  const Real at_vrp = dot(n, scene.view.vrp);
  TrueHalfSpace front, back;
  front.plane = {-n[0], -n[1], -n[2], at_vrp + distances[0]};
  back.plane = {n[0], n[1], n[2], -at_vrp - distances[1]};
  for (TrueBody& body : scene.bodies) {
    body.push_back(front);
    body.push_back(back);
  }
  scene.clipping_planes = 2;
}

}  // namespace

TrueScene true_scene(const Scene& scene, const std::string& view_id) {
  TrueScene result;
  Flattening(scene, result.bodies).place(scene.top, identity());
  result.light = true_light(scene);
  ViewParameters parameters;
  if (const ViewStatement* view = chosen_view(scene, view_id)) {
    for (const ViewParameter& parameter : view->parameters) parameters.set(parameter);
  }
  result.view = true_view(parameters);
  if (parameters.clipping) clip(result, *parameters.clipping);
  return result;
}

}  // namespace halfspace::oracle
