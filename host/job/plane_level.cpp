#include "host/job/plane_level.hpp"

#include <algorithm>

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
  // Level k is reached where (levels - 1) (ambient + parallel cos) >= k unit, or, with t = k unit - (levels - 1) ambient, where
  // t |l| |N| <= (levels - 1) parallel (l . N): t is 0 or less, or its square no more than the quotient of these squares.
  const mpz_class most = scene.levels - 1;
  mpz_class t = 0;
  if (along > 0) {
    const mpz_class reach = most * static_cast<long>(lighting.parallel) * along;
    t = sqrt(mpz_class(reach * reach / (l2 * n2)));
  }
  const mpz_class level = (t + most * static_cast<long>(lighting.ambient)) / static_cast<long>(lighting.unit);
  return static_cast<int>(std::min(level, most).get_si());
}

}  // namespace halfspace
