#include "tests/oracle/exact_root.hpp"

namespace halfspace::oracle {
namespace {

// The sign of u + v sqrt(disc), disc >= 0.
int sign_of_surd(const mpz_class& u, const mpz_class& v, const mpz_class& disc) {
  const int su = sgn(u);
  const int sv = sgn(disc) == 0 ? 0 : sgn(v);
  if (sv == 0 || su == sv) return su;
  if (su == 0) return sv;
  const int larger = cmp(u * u, v * v * disc);
  return larger == 0 ? 0 : (larger > 0 ? su : sv);
}

// The sign of u + v sqrt(d1) + w sqrt(d2).
int sign_of_two_surds(const mpz_class& u, const mpz_class& v, const mpz_class& d1, const mpz_class& w,
                      const mpz_class& d2) {
  const int left = sign_of_surd(u, v, d1);
  const int right = sgn(d2) == 0 ? 0 : sgn(w);
  if (right == 0 || left == right) return left;
  if (left == 0) return right;
  const mpz_class rational = u * u + v * v * d1 - w * w * d2;
  const int larger = sign_of_surd(rational, 2 * u * v, d1);
  return larger == 0 ? 0 : (larger > 0 ? left : right);
}

// at0 + slope * z: a component of the gradient along the ray.
struct Linear {
  mpz_class at0, slope;
};

std::array<Linear, 4> local_gradient(const IntegerHalfSpace& h, std::int64_t x, std::int64_t y) {
  const auto& c = h.c;
  if (h.kind == HalfSpaceKind::plane) {
    return {Linear{c[0], 0}, Linear{c[1], 0}, Linear{c[2], 0}, Linear{c[3], 0}};
  }
  return {Linear{c[0] * x + c[3] * y + c[6], c[5]}, Linear{c[3] * x + c[1] * y + c[7], c[4]},
          Linear{c[5] * x + c[4] * y + c[8], c[2]}, Linear{c[6] * x + c[7] * y + c[9], c[8]}};
}

// P + R sqrt(D): a number of the root's field.
struct Surd {
  mpz_class p, r;
};

Surd square(const Surd& s, const mpz_class& disc) { return {s.p * s.p + s.r * s.r * disc, 2 * s.p * s.r}; }

// N times the root's positive denominator.
std::array<Surd, 3> normal_at(const IntegerScene& scene, const IntegerBody& body, const IntegerHalfSpace& h,
                              std::int64_t x, std::int64_t y, const ExactRoot& root) {
  std::array<Linear, 4> g = local_gradient(h, x, y);
  for (int i = 0; i < 3; ++i) {
    g[3].at0 -= body.origin[i] * g[i].at0;
    g[3].slope -= body.origin[i] * g[i].slope;
  }
  std::array<Surd, 3> normal;
  for (int row = 0; row < 3; ++row) {
    Linear n{0, 0};
    for (int column = 0; column < 4; ++column) {
      n.at0 += scene.lighting.normal_matrix[row][column] * g[column].at0;
      n.slope += scene.lighting.normal_matrix[row][column] * g[column].slope;
    }
    normal[row] = {n.at0 * root.d + n.slope * root.p, n.slope * root.r};
  }
  return normal;
}

}  // namespace

ExactForm restrict_to_ray(const IntegerHalfSpace& half_space, std::int64_t x, std::int64_t y) {
  const auto& c = half_space.c;
  if (half_space.kind == HalfSpaceKind::plane) return {0, c[2], 2 * (c[0] * x + c[1] * y + c[3])};
  return {c[2], c[4] * y + c[5] * x + c[8],
          (c[0] * x + 2 * c[3] * y + 2 * c[6]) * x + (c[1] * y + 2 * c[7]) * y + c[9]};
}

mpz_class discriminant(const ExactForm& form) { return form.b * form.b - form.a * form.c; }

ExactRoot root_of(const ExactForm& form, int sheet) {
  if (sgn(form.a) == 0) {
    const int s = sgn(form.b);
    return {-form.c * s, 2 * form.b * s, 0, 0};
  }
  const int s = sgn(form.a);
  return {-form.b * s, form.a * s, discriminant(form), sheet == 0 ? -1 : 1};
}

int sign_at(const ExactForm& form, const ExactRoot& root) {
  const auto& [p, d, disc, r] = root;
  const mpz_class rational = form.a * (p * p + r * r * disc) + 2 * form.b * d * p + form.c * d * d;
  const mpz_class irrational = 2 * r * (form.a * p + form.b * d);
  return sign_of_surd(rational, irrational, disc);
}

int compare_depths(const ExactRoot& z1, std::int64_t origin1, const ExactRoot& z2, std::int64_t origin2) {
  const mpz_class rational = (z1.p + origin1 * z1.d) * z2.d - (z2.p + origin2 * z2.d) * z1.d;
  return sign_of_two_surds(rational, z1.r * z2.d, z1.disc, -z2.r * z1.d, z2.disc);
}

bool reaches_level(const IntegerScene& scene, const IntegerBody& body, const IntegerHalfSpace& half_space,
                   std::int64_t x, std::int64_t y, const ExactRoot& root, int k) {
  const IntegerLighting& lighting = scene.lighting;
  const mpz_class wanted = mpz_class(k) * lighting.unit - mpz_class(scene.levels - 1) * lighting.ambient;
  if (sgn(wanted) <= 0) return true;

  const std::array<Surd, 3> normal = normal_at(scene, body, half_space, x, y, root);
  Surd along{0, 0};   // s (light . N)
  Surd length{0, 0};  // N . N
  mpz_class light_length = 0;
  const int s = half_space.complement ? -1 : 1;
  for (int i = 0; i < 3; ++i) {
    along.p += s * lighting.light[i] * normal[i].p;
    along.r += s * lighting.light[i] * normal[i].r;
    const Surd squared = square(normal[i], root.disc);
    length.p += squared.p;
    length.r += squared.r;
    light_length += mpz_class(lighting.light[i]) * lighting.light[i];
  }
  if (sign_of_surd(along.p, along.r, root.disc) <= 0) return false;

  const mpz_class gain = mpz_class(scene.levels - 1) * lighting.parallel;
  const Surd lit = square(along, root.disc);
  const mpz_class scale = wanted * wanted * light_length;
  const mpz_class rational = gain * gain * lit.p - scale * length.p;
  const mpz_class irrational = gain * gain * lit.r - scale * length.r;
  return sign_of_surd(rational, irrational, root.disc) >= 0;
}

}  // namespace halfspace::oracle
