// Arcs of p + r sqrt(d): another quadric changes sign on a sheet of a quadric with z^2 (docs/meeting.md).
#include "firmware/core/guided_arc.hpp"
#include "firmware/core/radical_sign.hpp"
#include "firmware/core/registers.hpp"

namespace halfspace {
namespace {

template <int Bits>
struct Radical {
  using Int = Wide<Bits>;
  SecondOrder<Int> p, d;
  FirstOrder<Int> r;

  void load(JobReader& in, std::int32_t x, std::int32_t y) {
    p = read_conic(in, x, y);
    r.x = in.wide<Bits>();
    r.y = in.wide<Bits>();
    r.r = in.wide<Bits>();
    r.jump_x(x);
    r.jump_y(y);
    d = read_conic(in, x, y);
  }
  static SecondOrder<Int> read_conic(JobReader& in, std::int32_t x, std::int32_t y) {
    std::array<Int, 6> q;
    for (Int& c : q) c = in.wide<Bits>();
    return SecondOrder<Int>::load(q[0], q[1], q[2], q[3], q[4], q[5], x, y);
  }
  [[nodiscard]] int sign(int missing) const {
    return d.r.negative() ? missing : sign_of_radical<3 * Bits>(p.r, r.r, d.r);
  }
  void step_x() {
    p.step_x();
    r.step_x();
    d.step_x();
  }
  void back_x() {
    p.back_x();
    r.back_x();
    d.back_x();
  }
  void step_y() {
    p.step_y();
    r.step_y();
    d.step_y();
  }
  void jump_x(std::int32_t n) {
    p.jump_x(n);
    r.jump_x(n);
    d.jump_x(n);
  }
};

}  // namespace

const ArcModule radical_arc_128 = guided_module<Radical<128>>;
const ArcModule radical_arc_256 = guided_module<Radical<256>>;
const ArcModule radical_arc_384 = guided_module<Radical<384>>;

}  // namespace halfspace
