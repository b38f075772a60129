#include "host/resolve/hidden_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>

#include "host/resolve/depth_bounds.hpp"

namespace halfspace {
namespace {

constexpr std::int32_t least_side = 8;  // dots, of the smallest squares
constexpr std::size_t squares_a_body = 16;
constexpr std::size_t most_squares = 256;  // a body
constexpr std::size_t least_squares = 32;

// A square of the pyramid: level 0 is the whole window.
struct Square {
  std::int32_t level = 0;
  std::int32_t column = 0, row = 0;
};

// For each square, the depth beyond which all is hidden on every dot of it.
class DepthPyramid {
 public:
  DepthPyramid(const Scissor& window, std::size_t bodies) : window_(window) {
    const std::int32_t side = std::max(window.x1 - window.x0, window.y1 - window.y0) + 1;
    while ((side >> (levels_ - 1)) > least_side && std::size_t{1} << 2 * (levels_ - 1) < squares_a_body * bodies) {
      ++levels_;
    }
    side_ = ((side - 1) >> (levels_ - 1)) + 1;
    std::size_t count = 0;
    for (std::int32_t level = 0; level < levels_; ++level) count += std::size_t{1} << 2 * level;
    depths_.resize(count, no_bound);
  }

  [[nodiscard]] std::int32_t side(int level) const { return side_ << (levels_ - 1 - level); }
  [[nodiscard]] const Scissor& window() const { return window_; }
  [[nodiscard]] bool is_smallest(const Square& s) const { return s.level == levels_ - 1; }
  // Not all of a square need lie in the window.
  [[nodiscard]] bool meets(const Square& s, const Scissor& box) const {
    const std::int32_t size = side(s.level), x = x0(s), y = y0(s);
    return x <= box.x1 && y <= box.y1 && x + size > box.x0 && y + size > box.y0;
  }
  [[nodiscard]] double depth(const Square& s) const { return depths_[index(s)]; }
  // By what is known of the squares around it, too.
  [[nodiscard]] double depth_around(Square s) const {
    double least = depth(s);
    for (; s.level > 0; least = std::min(least, depth(s))) s = around(s);
    return least;
  }

  void hide_beyond(const Square& s, double depth) { depths_[index(s)] = std::min(depths_[index(s)], depth); }
  // Once its quarters have changed; false: that changes nothing.
  bool gather(const Square& s) {
    double deepest = -no_bound;
    for (int quarter = 0; quarter < 4; ++quarter) {
      if (const Square q = quarter_of(s, quarter); meets(q, window_)) deepest = std::max(deepest, depth(q));
    }
    const bool is_new = deepest < depth(s);
    if (is_new) hide_beyond(s, deepest);
    return is_new;
  }

  // The smallest that are not smaller than a box in the window: the first and the last of at most four that hold it.
  [[nodiscard]] std::array<Square, 2> squares_around(const Scissor& box) const {
    const std::int32_t size = std::max(box.x1 - box.x0, box.y1 - box.y0) + 1;
    int level = levels_ - 1;
    while (level > 0 && side(level) < size) --level;
    const auto place = [&](std::int32_t x, std::int32_t y) {
      return Square{level, (x - window_.x0) / side(level), (y - window_.y0) / side(level)};
    };
    return {place(box.x0, box.y0), place(box.x1, box.y1)};
  }

  [[nodiscard]] static Square around(const Square& s) { return {s.level - 1, s.column / 2, s.row / 2}; }
  [[nodiscard]] static Square quarter_of(const Square& s, int quarter) {
    return {s.level + 1, 2 * s.column + (quarter & 1), 2 * s.row + (quarter >> 1)};
  }

  // Seen from a body's origin.
  [[nodiscard]] DotRectangle dots(const Square& s, const std::array<std::int64_t, 3>& origin) const {
    const std::int64_t x1 = std::min(x0(s) + side(s.level) - 1, window_.x1);
    const std::int64_t y1 = std::min(y0(s) + side(s.level) - 1, window_.y1);
    const auto half = [](std::int64_t twice) { return static_cast<double>(twice) / 2; };
    return {half(x0(s) + x1 - 2 * origin[0]), half(y0(s) + y1 - 2 * origin[1]), half(x1 - x0(s)), half(y1 - y0(s))};
  }

 private:
  [[nodiscard]] std::int32_t x0(const Square& s) const { return window_.x0 + s.column * side(s.level); }
  [[nodiscard]] std::int32_t y0(const Square& s) const { return window_.y0 + s.row * side(s.level); }
  // After 1 + 4 + 16 + ... of the levels before.
  [[nodiscard]] static std::size_t index(const Square& s) {
    const std::size_t before = ((std::size_t{1} << 2 * s.level) - 1) / 3;
    return before + (static_cast<std::size_t>(s.row) << s.level) + static_cast<std::size_t>(s.column);
  }

  Scissor window_;
  int levels_ = 1;
  std::int32_t side_ = 1;  // dots, of the smallest squares
  std::vector<double> depths_;
};

// What is known of a body on a square, in depths of the page.
struct BodyDepths {
  bool is_absent = false;
  double begin = -no_bound;  // it is not in front of this
  double shown = no_bound;   // on every dot it has shown a face by here
};

class BodyForm {
 public:
  // For squares in the window.
  void set(const IntegerBody& body, const Scissor& window) {
    origin_ = body.origin;
    box_ = window;
    forms_.clear();
    const auto largest = [](std::int64_t first, std::int64_t last) {
      return static_cast<double>(std::max(std::abs(first), std::abs(last)));
    };
    const double largest_x = largest(window.x0 - origin_[0], window.x1 - origin_[0]);
    const double largest_y = largest(window.y0 - origin_[1], window.y1 - origin_[1]);
    for (const IntegerHalfSpace& h : body.half_spaces) {
      forms_.push_back({DepthForm(h, largest_x, largest_y), h.transparent});
      const DotRectangle dots = forms_.back().form.silhouette();
      shrink(box_.x0, box_.x1, dots.x + static_cast<double>(origin_[0]), dots.half_x);
      shrink(box_.y0, box_.y1, dots.y + static_cast<double>(origin_[1]), dots.half_y);
    }
  }

  [[nodiscard]] const std::array<std::int64_t, 3>& origin() const { return origin_; }
  // The dots of the window outside which the body is not.
  [[nodiscard]] const Scissor& box() const { return box_; }

  [[nodiscard]] BodyDepths over(const DotRectangle& dots) {
    DepthInterval may, must;
    double clear = no_bound;  // all transparent half-spaces, which show no face, hold from the eye to here
    holes_.clear();
    for (const Form& form : forms_) {
      const HoldingDepths bounds = form.form.over(dots);
      may = meet(may, bounds.may);
      if (may.empty()) return {.is_absent = true};
      must = meet(must, bounds.must);
      if (!bounds.hole.empty()) holes_.push_back(bounds.hole);
      if (form.is_transparent) clear = std::min(clear, clear_depth(bounds));
    }
    while (leave_hole(must)) {
    }
    // A ray that is outside first and in the body there has met a face.
    const bool enters = !must.empty() && must.low != -no_bound && must.low <= clear;
    return {false, below(may.low), enters ? above(must.low) : no_bound};
  }

 private:
  struct Form {
    DepthForm form;
    bool is_transparent = false;
  };

  static void shrink(std::int32_t& first, std::int32_t& last, double middle, double half) {
    const double reach = half + 0x1p-50 * std::abs(middle);
    if (middle - reach > first) first = static_cast<std::int32_t>(std::min(std::ceil(middle - reach), last + 1.0));
    if (middle + reach < last) last = static_cast<std::int32_t>(std::max(std::floor(middle + reach), first - 1.0));
  }
  // How far a half-space holds all the way from the eye.
  static double clear_depth(const HoldingDepths& bounds) {
    if (bounds.must.low != -no_bound || !bounds.hole.empty()) return -no_bound;
    return bounds.must.high;
  }
  static DepthInterval meet(const DepthInterval& a, const DepthInterval& b) {
    return {std::max(a.low, b.low), std::min(a.high, b.high)};
  }
  // Moves the interval's near end beyond a hole that it is in; false: it is in none.
  [[nodiscard]] bool leave_hole(DepthInterval& must) const {
    for (const DepthInterval& hole : holes_) {
      if (hole.low > must.low || must.low >= hole.high) continue;
      must.low = hole.high;
      return true;
    }
    return false;
  }
  // Of a local depth, in the page's frame.
  [[nodiscard]] double margin(double depth) const {
    return 0x1p-50 * (std::abs(depth) + std::abs(static_cast<double>(origin_[2])));
  }
  [[nodiscard]] double below(double depth) const {
    return depth == -no_bound ? depth : depth + static_cast<double>(origin_[2]) - margin(depth);
  }
  [[nodiscard]] double above(double depth) const { return depth + static_cast<double>(origin_[2]) + margin(depth); }

  std::array<std::int64_t, 3> origin_{};
  Scissor box_;
  std::vector<Form> forms_;
  std::vector<DepthInterval> holes_;  // on the square at hand
};

// Takes bodies down the pyramid, one after the other.
class Descent {
 public:
  Descent(DepthPyramid& pyramid, std::size_t bodies)
      : pyramid_(pyramid), squares_(std::clamp(bodies, least_squares, most_squares)) {}

  // Does anything of it come through? Then it hides what is behind it.
  [[nodiscard]] bool comes_through(const IntegerBody& body) {
    form_.set(body, pyramid_.window());
    const Scissor& box = form_.box();
    if (box.x0 > box.x1 || box.y0 > box.y1) return false;
    entered_.clear();
    const auto [first, last] = pyramid_.squares_around(box);
    for (Square s = first; s.row <= last.row; ++s.row) {
      for (s.column = first.column; s.column <= last.column; ++s.column) visit(s, pyramid_.depth_around(s));
    }
    bool comes_through = false;
    // In order of levels: what is appended belongs to the level below.
    for (std::size_t i = 0; i < entered_.size(); ++i) {
      const Entered at = entered_[i];
      if (at.is_last || entered_.size() + 4 > squares_) {
        comes_through = true;
        continue;
      }
      for (int quarter = 0; quarter < 4; ++quarter) {
        const Square s = DepthPyramid::quarter_of(at.square, quarter);
        if (pyramid_.meets(s, box)) visit(s, std::min(at.hidden, pyramid_.depth(s)));
      }
    }
    if (comes_through) hide(first.level);
    return comes_through;
  }

 private:
  struct Entered {
    Square square;
    double hidden;  // the depth beyond which all is, by what is known of this square and those around it
    double shown;
    bool is_last;  // its quarters would tell little more
  };

  void visit(const Square& square, double hidden) {
    const BodyDepths depths = form_.over(pyramid_.dots(square, form_.origin()));
    if (depths.is_absent || depths.begin > hidden) return;
    const bool is_last = pyramid_.is_smallest(square) || depths.shown - depths.begin < 2 * pyramid_.side(square.level);
    entered_.push_back({square, hidden, depths.shown, is_last});
  }

  void hide(int first_level) {
    for (auto at = entered_.rbegin(); at != entered_.rend(); ++at) {
      pyramid_.hide_beyond(at->square, at->shown);
      if (!at->is_last) pyramid_.gather(at->square);
    }
    for (const Entered& at : entered_) {
      Square s = at.square;
      if (s.level != first_level) break;
      do s = DepthPyramid::around(s);
      while (s.level >= 0 && pyramid_.gather(s));
    }
  }

  DepthPyramid& pyramid_;
  std::size_t squares_;  // that a body may enter
  BodyForm form_;        // of the body at hand
  std::vector<Entered> entered_;
};

}  // namespace

std::vector<bool> hidden_bodies(const IntegerScene& scene) {
  std::vector<bool> hidden(scene.bodies.size(), false);
  const Scissor& window = scene.scissor;
  if (scene.bodies.size() < 2 || window.x0 > window.x1 || window.y0 > window.y1) return hidden;
  std::vector<std::uint32_t> order(scene.bodies.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto depth = [&scene](std::uint32_t body) { return scene.bodies[body].origin[2]; };
  std::stable_sort(order.begin(), order.end(),
                   [&depth](std::uint32_t a, std::uint32_t b) { return depth(a) < depth(b); });
  DepthPyramid pyramid(window, scene.bodies.size());
  Descent descent(pyramid, scene.bodies.size());
  for (const std::uint32_t body : order) hidden[body] = !descent.comes_through(scene.bodies[body]);
  return hidden;
}

}  // namespace halfspace
