#include "tests/core/faces.hpp"

#include <algorithm>

#include "firmware/core/depth.hpp"
#include "firmware/core/engine.hpp"
#include "firmware/core/root_surface.hpp"
#include "host/job/limits.hpp"

namespace halfspace::testing {
namespace {

mpz_class integer(std::int64_t v) { return static_cast<long>(v); }

struct Local {
  mpz_class x, y;
};
Local local_dot(const TestFace& f, std::int32_t x, std::int32_t y) {
  return {integer(std::int64_t{x} - f.active.origin_x), integer(std::int64_t{y} - f.active.origin_y)};
}

mpz_class half_linear(const TestFace& f, const Local& at) { return f.c[5] * at.x + f.c[4] * at.y + f.c[8]; }
mpz_class constant(const TestFace& f, const Local& at) {
  return f.c[0] * at.x * at.x + 2 * f.c[3] * at.x * at.y + f.c[1] * at.y * at.y + 2 * f.c[6] * at.x +
         2 * f.c[7] * at.y + f.c[9];
}
mpz_class discriminant(const TestFace& f, const Local& at) {
  const mpz_class b = half_linear(f, at);
  return b * b - f.c[2] * constant(f, at);
}

// What one run may not contain a change of: +1 or -1 where the face is, 0 where it is not.
int presence(const TestFace& f, const Local& at) {
  switch (f.active.kind) {
    case FaceKind::root:
      return discriminant(f, at) >= 0 ? 1 : 0;
    case FaceKind::rational:
      return sgn(half_linear(f, at));
    default:
      return 1;
  }
}

// u + v sqrt(q)
struct Radical {
  mpz_class u, v;
};

}  // namespace

TestFace make_face(FaceKind kind, const std::array<mpz_class, 10>& c, std::array<std::int64_t, 3> origin, int sheet,
                   int light_sign, std::uint32_t order, const Lighting& lighting) {
  TestFace face;
  face.c = c;
  ActiveFace& a = face.active;
  for (int i = 0; i < 10; ++i) a.c[i] = to_wide<128>(c[i]);
  a.origin_x = static_cast<std::int32_t>(origin[0]);
  a.origin_y = static_cast<std::int32_t>(origin[1]);
  a.origin_z = origin[2];
  a.order = order;
  a.kind = kind;
  a.sheet = static_cast<std::int8_t>(kind == FaceKind::root ? sheet : 0);
  a.light_sign = static_cast<std::int8_t>(light_sign);
  a.last_line = largest_side - 1;
  make_depth(a);
  if (kind == FaceKind::root) make_root_surface(a, lighting);
  if (kind == FaceKind::rational) rational_faces.enter(a, lighting);
  return face;
}

TestFace random_face(Dice& dice, FaceKind kind, int coefficient_bits, const Lighting& lighting) {
  std::array<mpz_class, 10> c;
  for (mpz_class& k : c) k = random_bits(dice, coefficient_bits);
  c[2] = kind == FaceKind::rational ? mpz_class(0) : mpz_class(abs(c[2]) + 1);
  if (kind == FaceKind::plane) std::fill(c.begin() + 4, c.end(), 0);
  const auto origin = [&dice] { return between(dice, -40, 120); };
  return make_face(kind, c, {origin(), origin(), origin()}, dice() % 2 == 0 ? -1 : 1, dice() % 2 == 0 ? -1 : 1,
                   static_cast<std::uint32_t>(dice() % 1000), lighting);
}

TestFace solid_face(Dice& dice, std::int64_t x, std::int64_t y, std::int64_t radius, const Lighting& lighting) {
  std::array<mpz_class, 10> c;
  const auto shape = between(dice, 0, 3);
  // A sum of squares of integer linear forms: ellipsoid; cone or hyperboloid; cylinder; sphere.
  for (int term = 0; term < 3; ++term) {
    std::array<mpz_class, 3> l;
    for (int i = 0; i < 3; ++i) l[i] = shape == 3 ? integer(i == term ? 1 : 0) : integer(between(dice, -30, 30));
    const int sign = term == 2 ? (shape == 1 ? -1 : shape == 2 ? 0 : 1) : 1;
    c[0] += sign * l[0] * l[0];
    c[1] += sign * l[1] * l[1];
    c[2] += sign * l[2] * l[2];
    c[3] += sign * l[0] * l[1];
    c[4] += sign * l[1] * l[2];
    c[5] += sign * l[0] * l[2];
  }
  const bool apex = shape == 1 && dice() % 2 == 0;
  const mpz_class scale = abs(c[2]) + 1;
  c[9] = apex ? mpz_class(0) : mpz_class(-scale * integer(radius) * integer(radius));
  int light_sign = dice() % 2 == 0 ? 1 : -1;
  if (c[2] < 0) {
    for (mpz_class& k : c) k = -k;
    light_sign = -light_sign;
  }
  const FaceKind kind = c[2] == 0 ? FaceKind::rational : FaceKind::root;
  return make_face(kind, c, {x, y, between(dice, -50, 50)}, dice() % 2 == 0 ? -1 : 1, light_sign,
                   static_cast<std::uint32_t>(dice() % 1000), lighting);
}

Lighting random_lighting(Dice& dice) {
  Lighting l;
  const bool perspective = dice() % 4 == 0;
  for (auto& row : l.matrix) {
    for (int j = 0; j < 4; ++j) {
      row[j] = static_cast<std::int32_t>(between(dice, -(1 << 15), 1 << 15));
      if (j == 3) row[j] = perspective ? static_cast<std::int32_t>(random_bits(dice, 12).get_si()) : 0;
    }
  }
  for (auto& c : l.light) c = static_cast<std::int32_t>(between(dice, -(1 << 15), 1 << 15));
  l.unit = static_cast<std::int32_t>(between(dice, 1, 1 << 16));
  l.ambient = static_cast<std::int32_t>(between(dice, 0, l.unit));
  l.parallel = static_cast<std::int32_t>(between(dice, 0, l.unit));
  if (dice() % 3 == 0) l.ambient = 0, l.parallel = l.unit;
  return l;
}

std::optional<ExactDepth> depth_at(const TestFace& face, std::int32_t x, std::int32_t y) {
  const Local at = local_dot(face, x, y);
  ExactDepth z;
  switch (face.active.kind) {
    case FaceKind::plane:
      z.p = -(face.c[0] * at.x + face.c[1] * at.y + face.c[3]);
      z.d = face.c[2];
      break;
    case FaceKind::root:
      z.q = discriminant(face, at);
      if (z.q < 0) return std::nullopt;
      z.p = -half_linear(face, at);
      z.d = face.c[2];
      z.s = face.active.sheet;
      break;
    case FaceKind::rational:
      z.p = -constant(face, at);
      z.d = 2 * half_linear(face, at);
      if (z.d == 0) return std::nullopt;
      if (z.d < 0) z.p = -z.p, z.d = -z.d;
  }
  z.p += integer(face.active.origin_z) * z.d;
  return z;
}

int compare(const ExactDepth& f, const ExactDepth& g) {
  return sign_of_sum(f.p * g.d - g.p * f.d, g.d * f.s, f.q, f.d * -g.s, g.q);
}

bool reaches(const TestFace& face, const Lighting& lighting, std::int32_t levels, std::int32_t k, std::int32_t x,
             std::int32_t y) {
  // (levels - 1) (ambient + parallel max(0, cos)) >= k unit
  const mpz_class t = integer(k) * lighting.unit - integer(levels - 1) * lighting.ambient;
  if (t <= 0) return true;
  const ExactDepth page = *depth_at(face, x, y);
  const Local at = local_dot(face, x, y);
  const mpz_class zp = page.p - integer(face.active.origin_z) * page.d;
  // d times the homogeneous gradient, local, then its page frame's last component.
  static constexpr int form[4][4] = {{0, 3, 5, 6}, {3, 1, 4, 7}, {5, 4, 2, 8}, {6, 7, 8, 9}};
  std::array<Radical, 4> g;
  for (int j = 0; j < 4; ++j) {
    const auto& row = form[j];
    g[j].u = (face.c[row[0]] * at.x + face.c[row[1]] * at.y + face.c[row[3]]) * page.d + face.c[row[2]] * zp;
    g[j].v = face.c[row[2]] * page.s;
  }
  const std::array<mpz_class, 3> o{integer(face.active.origin_x), integer(face.active.origin_y),
                                   integer(face.active.origin_z)};
  for (int j = 0; j < 3; ++j) g[3].u -= o[j] * g[j].u, g[3].v -= o[j] * g[j].v;
  Radical light, square;
  mpz_class l2;
  for (int i = 0; i < 3; ++i) {
    Radical n;
    for (int j = 0; j < 4; ++j) n.u += lighting.matrix[i][j] * g[j].u, n.v += lighting.matrix[i][j] * g[j].v;
    const mpz_class l = integer(lighting.light[i]) * face.active.light_sign;
    light.u += l * n.u, light.v += l * n.v;
    square.u += n.u * n.u + n.v * n.v * page.q;
    square.v += 2 * n.u * n.v;
    l2 += l * l;
  }
  if (sign_of_sum(light.u, light.v, page.q) <= 0) return false;
  const mpz_class most = integer(levels - 1) * lighting.parallel;
  const mpz_class u = most * most * (light.u * light.u + light.v * light.v * page.q) - t * t * l2 * square.u;
  return sign_of_sum(u, most * most * 2 * light.u * light.v - t * t * l2 * square.v, page.q) >= 0;
}

std::int32_t level_at(const TestFace& face, const Lighting& lighting, std::int32_t levels, std::int32_t x,
                      std::int32_t y) {
  std::int32_t low = 0;
  std::int32_t high = levels;
  while (high - low > 1) {
    const std::int32_t middle = (low + high) / 2;
    (reaches(face, lighting, levels, middle, x, y) ? low : high) = middle;
  }
  return low;
}

const ExactModule* exact_for(std::initializer_list<const TestFace*> faces, const Lighting& lighting,
                             std::int32_t levels, std::int32_t side) {
  IntegerScene scene;
  scene.width = scene.height = side;
  scene.levels = levels;
  scene.scissor = {0, 0, side - 1, side - 1};
  for (int i = 0; i < 3; ++i) {
    std::copy(lighting.matrix[i].begin(), lighting.matrix[i].end(), scene.lighting.normal_matrix[i].begin());
    scene.lighting.light[i] = lighting.light[i];
  }
  scene.lighting.ambient = lighting.ambient;
  scene.lighting.parallel = lighting.parallel;
  scene.lighting.unit = lighting.unit;
  for (const TestFace* face : faces) {
    IntegerBody body;
    body.origin = {face->active.origin_x, face->active.origin_y, face->active.origin_z};
    scene.bodies.push_back(body);
  }
  FaceBits roots, all;
  int bits = 0;
  const IntegerBody* body = scene.bodies.data();
  for (const TestFace* face : faces) {
    IntegerHalfSpace half_space;
    half_space.kind = face->active.kind == FaceKind::plane ? HalfSpaceKind::plane : HalfSpaceKind::quadric;
    half_space.c = face->c;
    const FaceBits face_s = face_bits(scene, *body++, half_space);
    if (check_face(face_s)) return nullptr;
    bits = std::max(bits, level_bits(scene, face_s));
    all.extend(face_s);
    if (face_s.q != 0) roots.extend(face_s);
  }
  bits = std::max(bits, depth_bits(scene, roots, all));
  for (const ExactModule* module : all_modules.exact) {
    if (module->bits >= bits) return module;
  }
  return nullptr;
}

std::vector<DotRun> runs_of(const TestFace& face, std::int32_t y, std::int32_t width) {
  std::vector<DotRun> runs;
  int before = 0;
  for (std::int32_t x = 0; x < width; ++x) {
    const int here = presence(face, local_dot(face, x, y));
    if (here != 0 && here == before) {
      runs.back().x1 = x;
    } else if (here != 0) {
      runs.push_back({x, x});
    }
    before = here;
  }
  return runs;
}

}  // namespace halfspace::testing
