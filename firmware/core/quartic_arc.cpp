// Arcs of a polynomial of fourth degree: another quadric changes sign on the sheet of a quadric without z^2.
#include "firmware/core/guided_arc.hpp"
#include "firmware/core/registers.hpp"

namespace halfspace {
namespace {

template <int Bits>
struct Quartic {
  FourthOrder<Wide<Bits>> form;

  // Coefficients come highest degree first; the registers want the constant first.
  void load(JobReader& in, std::int32_t x, std::int32_t y) {
    for (int n = 4; n >= 0; --n) {
      for (int j = 0; j <= n; ++j) form.at[form.first(n) + j] = in.wide<Bits>();
    }
    form.begin(x, y);
  }
  [[nodiscard]] int sign(int) const { return form.r().sign(); }
  void step_x() { form.step_x(); }
  void back_x() { form.back_x(); }
  void step_y() { form.step_y(); }
  void jump_x(std::int32_t n) { form.jump_x(n); }
};

}  // namespace

const ArcModule quartic_arc_128 = guided_module<Quartic<128>>;
const ArcModule quartic_arc_256 = guided_module<Quartic<256>>;
const ArcModule quartic_arc_384 = guided_module<Quartic<384>>;

}  // namespace halfspace
