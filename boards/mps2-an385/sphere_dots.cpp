#include <algorithm>

#include "boards/mps2-an385/any_quadric_dots.hpp"
#include "boards/mps2-an385/baselines.hpp"
#include "boards/mps2-an385/surface64.hpp"
#include "firmware/core/isqrt.hpp"
#include "firmware/core/reaches_level.hpp"
#include "firmware/core/root_surface.hpp"

namespace halfspace::mps2 {
namespace {

constexpr std::int32_t always = -(1 << 30), never = 0x5fffffff;  // of T_k: |l| < 2^29

struct Sphere {
  bool is_one = false;  // with the light before it
  Quadratic64 g;        // m^2 D
  Linear32 l;
  std::int32_t t[257] = {};  // T_k, rounded down

  static Sphere of(const ShadeJob& job);
};

bool is_constant(const RootSurface& f) {
  for (int i = 0; i < 5; ++i) {
    if (!f.square.q[static_cast<std::size_t>(i)].is_zero()) return false;
  }
  const int fraction = f.square_root_fraction();
  return std::all_of(f.square_root.q.begin(), f.square_root.q.end(),
                     [&](const Wide<128>& c) { return (c >> fraction).is_zero(); });
}

Sphere Sphere::of(const ShadeJob& job) {
  const Surface64 s = Surface64::of(job);
  const LevelTable& table = job.table;
  Sphere sphere;
  sphere.is_one = is_constant(job.face.surface) && s.m > 0;
  sphere.l = s.l;
  for (int i = 0; i < 6; ++i) {
    sphere.g.q[i] = scaled(Wide<192>(s.d.q[i]) * Wide<192>(product(s.m, s.m)), 64);
  }
  for (std::int32_t k = 0; k <= table.levels; ++k) {
    const bool between = k > table.ambient_level && k <= table.top_level;
    sphere.t[k] = k <= table.ambient_level ? always : never;
    if (!between) continue;
    const std::int64_t square = scale_by(table.squares[static_cast<std::size_t>(k)], s.q.q[5]);
    sphere.t[k] = static_cast<std::int32_t>(isqrt(static_cast<std::uint64_t>(square)));
  }
  return sphere;
}

LastFace<Sphere> last_;

void enter(ActiveFace& face, const Lighting& lighting) {
  any_quadric_dots.enter(face, lighting);  // which forgets its last face too
  last_.forget();
}

// T_k - l is off by less than 4: 1 each for T_k, for the word of l and for its coefficients. Its square, below 2^62, is off
// by less than 2^34, and G by less than 2^24 on a page of 2048 dots: comparisons of upper words are sure beyond 5.
constexpr std::int32_t distance_error = 4, upper_error = 5;

// Whether L >= T, t = T - l: 1 yes, 0 no, -1 not sure.
inline int reaches(std::int32_t t, std::int64_t g) {
  if (t <= -distance_error) return 1;
  const std::int32_t difference = upper(g - product(t, t));
  if (difference > upper_error) return 1;
  return difference < -upper_error && t > distance_error ? 0 : -1;
}

void shade(const ShadeJob& job, Shader shader, std::int32_t y, std::int32_t x0, std::int32_t x1) {
  const Sphere& s = last_.of(job);
  if (!s.is_one) return shade_any_quadric(job, shader, y, x0, x1);
  LineRegisters g = s.g.at(x0 - job.face.origin_x, y - job.face.origin_y);
  std::int64_t l = s.l.at(x0 - job.face.origin_x, y - job.face.origin_y);
  std::int32_t level = -1, low = always, high = always;  // T of the level and of the next
  std::int32_t from = x0;
  for (std::int32_t x = x0; x <= x1; ++x, g.step(), l += s.l.q[0]) {
    if (reaches(low - upper(l), g.v) == 1 && reaches(high - upper(l), g.v) == 0) continue;
    const std::int32_t k = search_level(job.table, level, [&](std::int32_t candidate) {
      const int answer = reaches(s.t[candidate] - upper(l), g.v);
      return answer < 0 ? reaches_level(job, x, y, candidate) : answer == 1;
    });
    if (k == level) continue;
    if (level >= 0) job.painter.fill(from, x - 1, level);
    from = x;
    level = k;
    low = s.t[k];
    high = s.t[k + 1];
  }
  job.painter.fill(from, x1, level);
}

}  // namespace

const FaceModule sphere_dots{&enter, &shade};

}  // namespace halfspace::mps2
