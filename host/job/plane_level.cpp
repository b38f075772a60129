#include "host/job/plane_level.hpp"

namespace halfspace {

int plane_level(const IntegerScene& scene, const IntegerBody& body, const IntegerHalfSpace& plane) {
  const IntegerLighting& lighting = scene.lighting;
  mpz_class gw = plane.c[3];
  for (int j = 0; j < 3; ++j) gw -= mpz_class(static_cast<long>(body.origin[j])) * plane.c[j];
  mpz_class n2;
  mpz_class along;  // s (light . N)
  mpz_class l2;
  for (int i = 0; i < 3; ++i) {
    mpz_class n = mpz_class(static_cast<long>(lighting.normal_matrix[i][3])) * gw;
    for (int j = 0; j < 3; ++j) n += mpz_class(static_cast<long>(lighting.normal_matrix[i][j])) * plane.c[j];
    const mpz_class l = static_cast<long>(lighting.light[i]);
    n2 += n * n;
    along += l * n;
    l2 += l * l;
  }
  if (plane.complement) along = -along;
  const long most = scene.levels - 1;
  const mpz_class reach = most * static_cast<long>(lighting.parallel) * along;
  const auto reaches = [&](long k) {
    // (levels - 1) (ambient + parallel cos) >= k unit  <=>  t |l| |N| <= (levels - 1) parallel (l . N)
    const mpz_class t = k * static_cast<long>(lighting.unit) - most * static_cast<long>(lighting.ambient);
    return t <= 0 || (along > 0 && reach * reach >= t * t * l2 * n2);
  };
  long low = 0;
  long high = most + 1;
  while (high - low > 1) {
    const long middle = (low + high) / 2;
    (reaches(middle) ? low : high) = middle;
  }
  return static_cast<int>(low);
}

}  // namespace halfspace
