#include "boards/mps2-an385/any_quadric_dots.hpp"

#include "boards/mps2-an385/baselines.hpp"
#include "boards/mps2-an385/root32.hpp"
#include "boards/mps2-an385/surface64.hpp"
#include "firmware/core/reaches_level.hpp"
#include "firmware/core/root_surface.hpp"

namespace halfspace::mps2 {
namespace {

LastFace<Surface64> last_;

void enter(ActiveFace& face, const Lighting& lighting) {
  make_root_surface(face, lighting);
  last_.forget();
}

struct Walk {
  LineRegisters d, q;
  std::int64_t l, l1, r, r1;

  Walk(const Surface64& s, std::int32_t x, std::int32_t y)
      : d(s.d.at(x, y)), q(s.q.at(x, y)), l(s.l.at(x, y)), l1(s.l.q[0]), r(s.r.at(x, y)), r1(s.r.q[0]) {}

  void step() {
    d.step();
    q.step();
    l += l1;
    r += r1;
  }
};

}  // namespace

void shade_any_quadric(const ShadeJob& job, Shader, std::int32_t y, std::int32_t x0, std::int32_t x1) {
  const Surface64& s = last_.of(job);
  Walk at(s, x0 - job.face.origin_x, y - job.face.origin_y);
  LevelWindow window;
  std::int32_t level = -1;
  std::int32_t from = x0;
  for (std::int32_t x = x0; x <= x1; ++x, at.step()) {
    const auto root = at.d.v > 0 ? static_cast<std::int32_t>(root32(static_cast<std::uint64_t>(at.d.v))) : 0;
    const std::int64_t square = at.q.v + product(upper(at.r), root);
    const Light light{upper(at.l) + upper(product(s.m, root)), std::max<std::int64_t>(square, 0)};
    const Margin& sure = root >= s.deep_from ? s.deep : s.shallow;
    if (level >= 0 && window.holds(light, sure)) continue;
    const std::int32_t k = search_level(job.table, level, [&](std::int32_t candidate) {
      const Answer answer = compare(light, sure, job.table.squares[static_cast<std::size_t>(candidate)]);
      return answer == Answer::unsure ? reaches_level(job, x, y, candidate) : answer == Answer::yes;
    });
    if (k == level) continue;
    if (level >= 0) job.painter.fill(from, x - 1, level);
    from = x;
    level = k;
    window = LevelWindow::of(job.table, level);
  }
  job.painter.fill(from, x1, level);
}

const FaceModule any_quadric_dots{&enter, &shade_any_quadric};

}  // namespace halfspace::mps2
