#include "firmware/core/arc.hpp"

#include <algorithm>
#include <type_traits>

#include "firmware/core/registers.hpp"

namespace halfspace {
namespace {

template <class Int>
Int read_coefficient(JobReader& in) {
  if constexpr (std::is_same_v<Int, std::int64_t>) {
    return in.wide<64>().low64();
  } else {
    return Int(in.wide<256>());
  }
}

// Values of 64 bits must not overflow whatever a job claims: the magnitudes of the form on all that the arc may visit, as in
// host/job/limits. Wider ones wrap.
template <class Int>
bool holds(const std::array<Int, 6>& q, const ArcStart& start) {
  if constexpr (std::is_same_v<Int, std::int64_t>) {
    const auto farthest = [](std::int32_t low, std::int32_t high, std::int32_t origin) {
      return std::max({origin - low, low - origin, origin - high, high - origin});
    };
    const std::int32_t x = farthest(start.x_min - 1, start.x_max + 2, start.origin_x);
    const std::int32_t y = farthest(start.y, start.y_last + 1, start.origin_y);
    const auto size = [&q](int i) { return Wide<128>(q[i]).magnitude(); };
    const Wide<128> value =
        (size(0).times(x) + size(1).times(y) + size(3)).times(x) + (size(2).times(y) + size(4)).times(y) + size(5);
    return value.bit_length() + 4 <= 63;
  } else {
    return true;
  }
}

constexpr bool is_negative(std::int64_t v) { return v < 0; }
constexpr bool is_positive(std::int64_t v) { return v > 0; }
template <int Bits>
constexpr bool is_negative(const Wide<Bits>& v) {
  return v.negative();
}
template <int Bits>
constexpr bool is_positive(const Wide<Bits>& v) {
  return !v.negative() && !v.is_zero();
}

// Where the walk stands: the registers' dot and the dots it may visit.
struct Cursor {
  std::int16_t x = 0;
  std::int16_t x_min = 0, x_end = 0;  // x_end = scissor.x1 + 1: "no dot of the line"
};

template <class Int>
struct LineArc {
  FirstOrder<Int> form;
  Cursor at;

  void load(JobReader& in, const ArcStart& start) {
    form.x = read_coefficient<Int>(in);
    form.y = read_coefficient<Int>(in);
    form.r = read_coefficient<Int>(in);
    if (!holds<Int>({Int(0), Int(0), Int(0), form.x, form.y, form.r}, start)) return in.fail();
    form.jump_x(start.x - start.origin_x);
    form.jump_y(start.y - start.origin_y);
  }
  [[nodiscard]] bool at_or_right() const { return !is_negative(form.r); }
  [[nodiscard]] bool right() const { return is_positive(form.r); }
  // Steps back if the predicate holds there too.
  bool back() {
    const Int r = form.r - form.x;
    if (is_negative(r)) return false;
    form.r = r;
    return true;
  }
};

template <class Int>
struct ConicArc {
  SecondOrder<Int> form;
  Cursor at;
  ArcBranch branch;

  void load(JobReader& in, const ArcStart& start) {
    branch = static_cast<ArcBranch>(in.number_in(0, 2));
    std::array<Int, 6> q;
    for (Int& c : q) c = read_coefficient<Int>(in);
    if (!holds(q, start)) return in.fail();
    form =
        SecondOrder<Int>::load(q[0], q[1], q[2], q[3], q[4], q[5], start.x - start.origin_x, start.y - start.origin_y);
  }
  // Of 2 A x + B y + D, the mean of the differences to the next dot and from the last, x and x - xx, where A > 0: as a rule both have its sign.
  [[nodiscard]] bool is_falling(const Int& x) const {
    if (is_negative(x)) return true;
    return x < form.xx && is_negative(x + x - form.xx);
  }
  [[nodiscard]] bool is_rising() const {
    if (is_negative(form.x)) return false;
    return form.x >= form.xx || is_positive(form.x + form.x - form.xx);
  }
  // Of a dot with the value r and the difference x to the next.
  [[nodiscard]] bool at_or_right(const Int& r, const Int& x) const {
    if (branch == ArcBranch::left) return !is_positive(r) || !is_falling(x);
    return !is_negative(r) && (branch == ArcBranch::single || !is_falling(x));
  }
  [[nodiscard]] bool at_or_right() const { return at_or_right(form.r, form.x); }
  [[nodiscard]] bool right() const {
    if (branch == ArcBranch::left) return is_negative(form.r) || is_rising();
    return is_positive(form.r) && (branch == ArcBranch::single || is_rising());
  }
  bool back() {
    const Int x = form.x - form.xx;
    const Int r = form.r - x;
    if (!at_or_right(r, x)) return false;
    form.x = x;
    form.r = r;
    form.y -= form.xy;
    return true;
  }
};

// Moves the registers to the first dot of [x_min, x_end] at or right of the crossing.
template <class Arc>
ArcCrossing settle(Arc& arc) {
  Cursor& at = arc.at;
  if (at.x < at.x_end && !arc.at_or_right()) {
    do {
      arc.form.step_x();
      ++at.x;
    } while (at.x < at.x_end && !arc.at_or_right());
  } else {
    while (at.x > at.x_min && arc.back()) --at.x;
  }
  ArcCrossing crossing{at.x, at.x};
  if (at.x < at.x_end && !arc.right()) ++crossing.right;
  return crossing;
}

template <class Arc>
void load(JobReader& in, const ArcStart& start, void* state) {
  Arc& arc = *static_cast<Arc*>(state);
  arc = Arc{};
  arc.load(in, start);
  arc.at = {static_cast<std::int16_t>(start.x), static_cast<std::int16_t>(start.x_min),
            static_cast<std::int16_t>(start.x_max + 1)};
}

template <class Arc>
constexpr ArcModule module_of{
    .bytes = static_cast<std::int32_t>(sizeof(Arc)),
    .load = &load<Arc>,
    .settle = [](void* state) { return settle(*static_cast<Arc*>(state)); },
    .next =
        [](void* state) {
          Arc& arc = *static_cast<Arc*>(state);
          arc.form.step_y();
          return settle(arc);
        },
    .enter_window = nullptr,
    .jump_down = nullptr,
    .ahead = nullptr,
};

// No jump between lines of the arc overflows: a product of a difference and the lines is at most twelve times the form's largest value
// there, for which holds() leaves four bits.
template <class Arc>
constexpr ArcModule module_that_rests = [] {
  ArcModule module = module_of<Arc>;
  module.jump_down = [](void* state, std::int32_t lines) { static_cast<Arc*>(state)->form.jump_y(lines); };
  module.ahead = [](const void* state, std::int32_t lines) {
    Arc arc = *static_cast<const Arc*>(state);
    arc.form.jump_y(lines);
    return settle(arc);
  };
  return module;
}();

}  // namespace

const ArcModule line_arc_64 = module_that_rests<LineArc<std::int64_t>>;
const ArcModule line_arc_128 = module_of<LineArc<Wide<128>>>;
const ArcModule line_arc_256 = module_of<LineArc<Wide<256>>>;
const ArcModule conic_arc_64 = module_that_rests<ConicArc<std::int64_t>>;
const ArcModule conic_arc_128 = module_of<ConicArc<Wide<128>>>;
const ArcModule conic_arc_256 = module_of<ConicArc<Wide<256>>>;

}  // namespace halfspace
