#include "firmware/core/arc.hpp"

#include <algorithm>
#include <bit>
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

// Of the dots or lines low .. high from the origin.
constexpr std::uint32_t farthest(std::int32_t low, std::int32_t high, std::int32_t origin) {
  return static_cast<std::uint32_t>(std::max({origin - low, low - origin, origin - high, high - origin}));
}

// Values of 64 bits must not overflow whatever a job claims: the magnitudes of the form on all that the arc may visit, as in
// host/job/limits. Wider ones wrap.
template <class Int>
bool holds(const std::array<Int, 6>& q, const ArcStart& start) {
  if constexpr (std::is_same_v<Int, std::int64_t>) {
    const auto x = static_cast<std::int32_t>(farthest(start.x_min - 1, start.x_max + 2, start.origin_x));
    const auto y = static_cast<std::int32_t>(farthest(start.y, start.y_last + 1, start.origin_y));
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
  void step_y() { form.step_y(); }
};

struct ConicArc {
  SecondOrder<std::int64_t> form;
  Cursor at;
  ArcBranch branch;

  void load(JobReader& in, const ArcStart& start) {
    branch = static_cast<ArcBranch>(in.number_in(0, 2));
    std::array<std::int64_t, 6> q;
    for (std::int64_t& c : q) c = read_coefficient<std::int64_t>(in);
    if (!holds(q, start)) return in.fail();
    form = SecondOrder<std::int64_t>::load(q[0], q[1], q[2], q[3], q[4], q[5], start.x - start.origin_x,
                                           start.y - start.origin_y);
  }
  [[nodiscard]] bool right() const {
    if (branch == ArcBranch::left) return form.r < 0 || is_rising();
    return form.r > 0 && (branch == ArcBranch::single || is_rising());
  }
  void seek() {
    const std::int64_t xx = form.xx;
    switch (branch) {
      case ArcBranch::left:
        return seek([xx](std::int64_t r, std::int64_t x) { return r <= 0 || !is_falling(x, xx); });
      case ArcBranch::right:
        return seek([xx](std::int64_t r, std::int64_t x) { return r >= 0 && !is_falling(x, xx); });
      default:
        return seek([](std::int64_t r, std::int64_t) { return r >= 0; });
    }
  }
  void step_y() { form.step_y(); }

 private:
  // Of 2 A x + B y + D, the mean of the differences to the next dot and from the last, x and x - xx, where A > 0: as a rule both have its sign.
  [[nodiscard]] static bool is_falling(std::int64_t x, std::int64_t xx) { return x < 0 || (x < xx && x + x < xx); }
  [[nodiscard]] bool is_rising() const { return form.x >= form.xx || (form.x >= 0 && form.x + form.x > form.xx); }

  // `is_there`: whether a dot with the value r and the difference x to the next is at or right of the crossing.
  template <class Test>
  void seek(const Test& is_there) {
    const std::int64_t xx = form.xx;
    std::int64_t r = form.r;
    std::int64_t x = form.x;
    std::int32_t dot = at.x;
    if (dot < at.x_end && !is_there(r, x)) {
      do {
        r += x;
        x += xx;
        ++dot;
      } while (dot < at.x_end && !is_there(r, x));
    } else {
      while (dot > at.x_min) {
        const std::int64_t last_x = x - xx;
        const std::int64_t last_r = r - last_x;
        if (!is_there(last_r, last_x)) break;
        x = last_x;
        r = last_r;
        --dot;
      }
    }
    form.r = r;
    form.x = x;
    form.y += form.xy * (dot - at.x);
    at.x = static_cast<std::int16_t>(dot);
  }
};

// One of 128 or 256 bits: its signs come from registers of the form's leading 64 bits, and where these cannot tell from the form itself.
// The registers are a form whose six coefficients were rounded down where the walk began. So dx dots and dy lines from there its value
// is off by less than 1 + dx + dy + (dx + dy)^2 / 2 + (dx + dy) / 2 < 2^32 and its slope by 2 (1 + dx + dy) + 1 < 2^18, as both are below
// 2^15, of the value's 2^58 units at most.
template <class Int>
struct WideConicArc {
  std::array<Int, 6> q;
  SecondOrder<Wide<64>> form;
  std::int32_t origin_x, y;  // y: the line in the arc's frame
  Cursor at;
  ArcBranch branch;

  void load(JobReader& in, const ArcStart& start) {
    branch = static_cast<ArcBranch>(in.number_in(0, 2));
    for (Int& c : q) c = read_coefficient<Int>(in);
    origin_x = start.origin_x;
    y = start.y - start.origin_y;
    const auto exact = SecondOrder<Int>::load(q[0], q[1], q[2], q[3], q[4], q[5], start.x - start.origin_x, y);
    const int shift = value_bits(start) - largest_bits;
    const auto leading = [shift](const Int& c) { return Wide<64>(scaled(c, shift)); };
    form = {leading(exact.r),  leading(exact.x),  leading(exact.y),
            leading(exact.xx), leading(exact.xy), leading(exact.yy)};
  }
  [[nodiscard]] bool at_or_right() const { return at_or_right(at.x, form.r, form.x); }
  [[nodiscard]] bool right() const {
    if (branch == ArcBranch::left) return value_sign(at.x, form.r) < 0 || slope_sign(at.x, form.x) > 0;
    return value_sign(at.x, form.r) > 0 && (branch == ArcBranch::single || slope_sign(at.x, form.x) > 0);
  }
  bool back() {
    const Wide<64> x = form.x - form.xx;
    const Wide<64> r = form.r - x;
    if (!at_or_right(at.x - 1, r, x)) return false;
    form.x = x;
    form.r = r;
    form.y -= form.xy;
    return true;
  }
  void step_y() {
    form.step_y();
    ++y;
  }

 private:
  static constexpr int largest_bits = 58;
  static constexpr std::int64_t value_error = std::int64_t{1} << 32;
  static constexpr std::int64_t slope_error = 1 << 18;

  // Bits of a bound of the form on all that the arc may visit: of six terms.
  [[nodiscard]] int value_bits(const ArcStart& start) const {
    const int x = static_cast<int>(std::bit_width(farthest(start.x_min - 1, start.x_max + 2, start.origin_x)));
    const int down = static_cast<int>(std::bit_width(farthest(start.y, start.y_last + 1, start.origin_y)));
    return 3 + std::max({q[0].bit_length() + 2 * x, q[1].bit_length() + x + down, q[2].bit_length() + 2 * down,
                         q[3].bit_length() + x, q[4].bit_length() + down, q[5].bit_length()});
  }
  // Of page dot x with the registers' value there and its difference to the next dot's.
  [[nodiscard]] bool at_or_right(std::int32_t x, const Wide<64>& value, const Wide<64>& rise) const {
    if (branch == ArcBranch::left) return value_sign(x, value) <= 0 || slope_sign(x, rise) >= 0;
    return value_sign(x, value) >= 0 && (branch == ArcBranch::single || slope_sign(x, rise) >= 0);
  }
  [[nodiscard]] int value_sign(std::int32_t x, const Wide<64>& value) const {
    const std::int64_t v = value.low64();
    if (v >= value_error) return 1;
    return v <= -value_error ? -1 : exact_value_sign(x - origin_x);
  }
  // Of 2 A x + B y + D.
  [[nodiscard]] int slope_sign(std::int32_t x, const Wide<64>& rise) const {
    const std::int64_t v = (rise + rise - form.xx).low64();
    if (v >= slope_error) return 1;
    return v <= -slope_error ? -1 : exact_slope_sign(x - origin_x);
  }
  [[nodiscard, gnu::noinline]] int exact_value_sign(std::int32_t x) const {
    return ((q[0].times(x) + q[1].times(y) + q[3]).times(x) + (q[2].times(y) + q[4]).times(y) + q[5]).sign();
  }
  [[nodiscard, gnu::noinline]] int exact_slope_sign(std::int32_t x) const {
    return (q[0].times(2 * x) + q[1].times(y) + q[3]).sign();
  }
};

// Moves the registers to the first dot of [x_min, x_end] at or right of the crossing.
template <class Arc>
std::int16_t seek(Arc& arc) {
  Cursor& at = arc.at;
  if constexpr (std::is_same_v<Arc, ConicArc>) {
    arc.seek();
  } else if (at.x < at.x_end && !arc.at_or_right()) {
    do {
      arc.form.step_x();
      ++at.x;
    } while (at.x < at.x_end && !arc.at_or_right());
  } else {
    while (at.x > at.x_min && arc.back()) --at.x;
  }
  return at.x;
}

template <class Arc>
ArcCrossing settle(Arc& arc) {
  const std::int16_t x = seek(arc);
  ArcCrossing crossing{x, x};
  if (x < arc.at.x_end && !arc.right()) ++crossing.right;
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
          arc.step_y();
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
    CrossingsAhead ahead{};
    for (std::size_t i = 0; i < 2; ++i) {
      arc.form.jump_y(lines / 2);
      ahead[i] = seek(arc);
    }
    if (lines % 2 != 0) arc.step_y();
    ahead[2] = lines % 2 != 0 ? seek(arc) : ahead[1];
    return ahead;
  };
  return module;
}();

}  // namespace

const ArcModule line_arc_64 = module_that_rests<LineArc<std::int64_t>>;
const ArcModule line_arc_128 = module_of<LineArc<Wide<128>>>;
const ArcModule line_arc_256 = module_of<LineArc<Wide<256>>>;
const ArcModule conic_arc_64 = module_that_rests<ConicArc>;
const ArcModule conic_arc_128 = module_of<WideConicArc<Wide<128>>>;
const ArcModule conic_arc_256 = module_of<WideConicArc<Wide<256>>>;

}  // namespace halfspace
