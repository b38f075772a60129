#include "tests/oracle/random_bodies.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace halfspace::oracle {
namespace {

std::int64_t dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

std::int64_t value_at(const RandomHalfSpace& h, const Point& p) {
  const auto& c = h.c;
  const auto [x, y, z] = p;
  if (!h.quadric) return c[0] * x + c[1] * y + c[2] * z + c[3];
  return c[0] * x * x + c[1] * y * y + c[2] * z * z + 2 * (c[3] * x * y + c[4] * y * z + c[5] * x * z) +
         2 * (c[6] * x + c[7] * y + c[8] * z) + c[9];
}

// Mostly so that the half-space contains the point, whichever way its coefficients are written.
void face_towards(Dice& dice, RandomHalfSpace& h, const Point& inside, bool surely) {
  if (dice.chance(30)) {
    for (std::int64_t& c : h.c) c = -c;
  }
  h.complement = value_at(h, inside) > 0;
  if (!surely && dice.chance(10)) h.complement = !h.complement;
}

// --- Planes.

Point random_normal(Dice& dice) {
  if (dice.chance(40)) {
    Point axis{};
    axis[dice.below(3)] = dice.one_of({1, -1, 2});
    return axis;
  }
  Point n{};
  while (n == Point{}) n = {dice.between(-3, 3), dice.between(-3, 3), dice.between(-3, 3)};
  return n;
}

RandomHalfSpace plane_through(const Point& normal, const Point& p, std::int64_t offset = 0) {
  RandomHalfSpace plane;
  plane.c = {normal[0], normal[1], normal[2], -dot(normal, p) - offset};
  return plane;
}

// Normals of whole length: their tangent planes to a sphere of whole radius have whole coefficients.
RandomHalfSpace tangent_plane(Dice& dice, const BodyWish& wish, std::int64_t radius) {
  struct Direction {
    Point normal;
    std::int64_t length;
  };
  static constexpr Direction directions[] = {{{1, 0, 0}, 1},  {{0, 1, 0}, 1},  {{0, 0, -1}, 1}, {{1, 2, 2}, 3},
                                             {{2, -1, 2}, 3}, {{0, 3, -4}, 5}, {{-3, 4, 0}, 5}, {{2, 3, 6}, 7}};
  const Direction& d = directions[dice.below(std::size(directions))];
  return plane_through(d.normal, wish.centre, d.length * radius);
}

// A plane through the line in which two others meet, or parallel to one, or the same again.
RandomHalfSpace related_plane(Dice& dice, const RandomHalfSpace& a, const RandomHalfSpace& b) {
  const std::int64_t s = dice.between(-2, 2);
  const std::int64_t t = dice.one_of({1, 2, -1});
  RandomHalfSpace plane;
  for (int i = 0; i < 4; ++i) plane.c[i] = s * a.c[i] + t * b.c[i];
  if (dice.chance(15)) plane.c[3] += dice.one_of({1, -1});
  if (plane.c[0] == 0 && plane.c[1] == 0 && plane.c[2] == 0) plane = b;
  plane.complement = plane.transparent = false;
  return plane;
}

RandomHalfSpace random_plane(Dice& dice, const BodyWish& wish, std::int64_t radius,
                             const std::vector<RandomHalfSpace>& planes) {
  const int kind = static_cast<int>(dice.below(100));
  if (kind < 15) return tangent_plane(dice, wish, radius);
  if (kind < 35) return plane_through(random_normal(dice), wish.centre);
  if (kind < 50 && planes.size() >= 2) {
    const RandomHalfSpace& first = planes[dice.below(static_cast<std::int64_t>(planes.size()))];
    const RandomHalfSpace& second = planes[dice.below(static_cast<std::int64_t>(planes.size()))];
    return related_plane(dice, first, second);
  }
  Point p = wish.centre;
  for (std::int64_t& coordinate : p) coordinate += dice.between(-wish.span, wish.span) / 2;
  return plane_through(random_normal(dice), p);
}

void add_box(Dice& dice, const BodyWish& wish, RandomBody& body) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const int side : {-1, 1}) {
      Point normal{};
      normal[axis] = side;
      RandomHalfSpace plane = plane_through(normal, wish.centre, dice.between(1, wish.span));
      face_towards(dice, plane, wish.centre, true);
      body.push_back(plane);
    }
  }
}

// --- Quadrics.

struct Kind {
  std::array<int, 3> signs;  // of the squares
  bool linear;               // minus the third form, once: paraboloids and parabolic cylinders
  int constant;              // its sign
};

constexpr Kind kinds[] = {
    {{1, 1, 1}, false, -1},  {{1, 1, 1}, false, -1}, {{-1, -1, -1}, false, 1},  // ellipsoids
    {{1, 1, 0}, false, -1},  {{1, 1, 0}, false, -1},                            // cylinders
    {{1, 1, -1}, false, 0},  {{1, 1, -1}, false, 0},                            // cones
    {{1, 1, -1}, false, -1}, {{1, 1, -1}, false, 1},                            // hyperboloids, one and two sheets
    {{1, 1, 0}, true, 0},    {{1, -1, 0}, true, 0},  {{1, 0, 0}, true, 0},      // paraboloids, parabolic cylinder
    {{1, -1, 0}, false, -1}, {{1, -1, 0}, false, 0}, {{1, 0, 0}, false, -1},    // hyperbolic cylinder, two planes
    {{1, 1, 1}, false, 0},   {{1, 1, 0}, false, 0},  {{1, 0, 0}, false, 0}      // a point, a line, a double plane
};
constexpr std::int64_t solid_kinds = std::size(kinds) - 3;

std::array<Point, 3> random_forms(Dice& dice) {
  static constexpr std::array<Point, 3> bases[] = {
      {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},  {{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}},
      {{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}},  {{{1, 1, 0}, {1, -1, 0}, {0, 0, 1}}},
      {{{1, 0, 0}, {0, 1, 1}, {0, -1, 1}}}, {{{1, 2, 2}, {2, 1, -2}, {2, -2, 1}}}};
  if (dice.chance(80)) return bases[dice.below(std::size(bases))];
  std::array<Point, 3> forms{};
  for (;;) {
    for (Point& form : forms) form = {dice.between(-2, 2), dice.between(-2, 2), dice.between(-2, 2)};
    const auto& [f, g, h] = forms;
    if (dot(f, {g[1] * h[2] - g[2] * h[1], g[2] * h[0] - g[0] * h[2], g[0] * h[1] - g[1] * h[0]}) != 0) return forms;
  }
}

// Adds weight * (form . (p - centre))^2.
void add_square(RandomHalfSpace& q, std::int64_t weight, const Point& form, const Point& centre) {
  const auto [a, b, c] = form;
  const std::int64_t m = -dot(form, centre);
  const std::int64_t terms[10] = {a * a, b * b, c * c, a * b, b * c, a * c, a * m, b * m, c * m, m * m};
  for (int i = 0; i < 10; ++i) q.c[i] += weight * terms[i];
}

// Adds 2 * weight * (form . (p - centre)).
void add_linear(RandomHalfSpace& q, std::int64_t weight, const Point& form, const Point& centre) {
  for (int i = 0; i < 3; ++i) q.c[6 + i] += weight * form[i];
  q.c[9] -= 2 * weight * dot(form, centre);
}

RandomHalfSpace random_quadric(Dice& dice, const BodyWish& wish, std::int64_t radius, bool ellipsoid) {
  const Kind& kind = kinds[ellipsoid ? 0 : dice.below(wish.bounded ? solid_kinds : std::size(kinds))];
  const std::array<Point, 3> forms = random_forms(dice);
  const bool round = dice.chance(50);
  RandomHalfSpace q;
  q.quadric = true;
  std::int64_t size = 1;  // the squared length of a form, so that the radius is in units
  for (int i = 0; i < 3; ++i) {
    if (kind.signs[i] == 0) continue;
    const std::int64_t weight = round ? 1 : dice.one_of({1, 2, 4});
    add_square(q, kind.signs[i] * weight, forms[i], wish.centre);
    size = weight * dot(forms[i], forms[i]);
  }
  if (kind.linear) add_linear(q, -radius, forms[2], wish.centre);
  q.c[9] += kind.constant * radius * radius * size;
  return q;
}

// --- Bodies.

// Level surfaces of one function do not meet.
void add_shells(Dice& dice, const BodyWish& wish, std::int64_t radius, RandomBody& body) {
  RandomHalfSpace q = random_quadric(dice, wish, radius, wish.bounded);
  face_towards(dice, q, wish.centre, false);
  body.push_back(q);
  for (std::int64_t more = dice.between(1, 2); more > 0; --more) {
    q.c[9] += (q.c[9] >= 0 ? -1 : 1) * dice.between(1, radius * radius);
    const bool met = q.c[9] == body.front().c[9] || q.c[9] == body.back().c[9];
    if (met) q.c[9] += 3 * radius * radius + 1;
    q.complement = dice.chance(50);
    body.push_back(q);
  }
}

RandomHalfSpace sphere(const Point& centre, std::int64_t radius) {
  RandomHalfSpace q;
  q.quadric = true;
  for (int i = 0; i < 3; ++i) {
    Point form{};
    form[i] = 1;
    add_square(q, 1, form, centre);
  }
  q.c[9] -= radius * radius;
  return q;
}

// Two spherical hollows side by side.
void add_hollows(Dice& dice, const BodyWish& wish, RandomBody& body) {
  const std::int64_t radius = dice.between(1, (wish.span + 2) / 3);
  Point other = wish.centre;
  const std::int64_t apart = 2 * radius + dice.between(1, wish.span / 2);
  const std::int64_t axis = dice.below(3);
  other[axis] += dice.chance(50) ? apart : -apart;
  for (const Point& centre : {wish.centre, other}) {
    RandomHalfSpace q = sphere(centre, radius);
    q.complement = true;
    body.push_back(q);
  }
}

void shuffle(Dice& dice, RandomBody& body) {
  for (std::size_t i = body.size(); i > 1; --i) std::swap(body[i - 1], body[dice.below(static_cast<std::int64_t>(i))]);
}

// Is a point of the lattice of halves inside, and on no surface?
bool has_room(const RandomBody& body, const BodyWish& wish) {
  RandomBody doubled = body;
  for (RandomHalfSpace& h : doubled) {
    const std::size_t first = h.quadric ? 6 : 3;
    for (std::size_t i = first; i < (h.quadric ? 9 : 4); ++i) h.c[i] *= 2;
    if (h.quadric) h.c[9] *= 4;
  }
  const auto holds = [&doubled](const Point& p) {
    return std::all_of(doubled.begin(), doubled.end(), [&p](const RandomHalfSpace& h) {
      return h.complement ? value_at(h, p) > 0 : value_at(h, p) < 0;
    });
  };
  const std::int64_t reach = 2 * wish.span;
  for (std::int64_t x = -reach; x <= reach; ++x) {
    for (std::int64_t y = -reach; y <= reach; ++y) {
      for (std::int64_t z = -reach; z <= reach; ++z) {
        if (holds({2 * wish.centre[0] + x, 2 * wish.centre[1] + y, 2 * wish.centre[2] + z})) return true;
      }
    }
  }
  return false;
}

}  // namespace

RandomBody random_body(Dice& dice, const BodyWish& wish) {
  constexpr std::int64_t most = 8;
  const std::int64_t radius = dice.between(1, (3 * wish.span + 3) / 4);
  RandomBody body;
  const int style = static_cast<int>(dice.below(100));
  if (style < 55) {
    body.push_back(random_quadric(dice, wish, radius, false));
    face_towards(dice, body.back(), wish.centre, false);
  } else if (style < 75) {
    add_shells(dice, wish, radius, body);
  } else if (style < 85) {
    add_hollows(dice, wish, body);
  }
  const bool box = (wish.bounded || dice.chance(15)) && body.size() <= 2;
  if (box) add_box(dice, wish, body);

  std::vector<RandomHalfSpace> planes;
  const std::int64_t fewest = body.empty() ? 1 : 0;
  for (std::int64_t n = dice.between(fewest, most - static_cast<std::int64_t>(body.size())); n > 0; --n) {
    planes.push_back(random_plane(dice, wish, radius, planes));
    const bool thin = wish.bounded && value_at(planes.back(), wish.centre) == 0;  // a body may become a line
    if (thin) continue;
    body.push_back(planes.back());
    face_towards(dice, body.back(), wish.centre, wish.bounded);
  }
  for (RandomHalfSpace& h : body) h.transparent = !wish.bounded && dice.chance(8);
  shuffle(dice, body);
  return body;
}

RandomBody meeting_body_of_any_size(Dice& dice, const BodyWish& wish) {
  RandomBody body;
  for (std::int64_t n = dice.between(2, 4); n > 0; --n) {
    BodyWish aside = wish;
    for (std::int64_t& coordinate : aside.centre) coordinate += dice.between(-1, 1);
    const bool ends = body.empty() && dice.chance(85);
    body.push_back(random_quadric(dice, aside, dice.between(1, wish.span - 1), ends));
    if (ends || dice.chance(60)) face_towards(dice, body.back(), aside.centre, false);
  }
  for (std::int64_t n = dice.between(0, 2); n > 0; --n) {
    body.push_back(random_plane(dice, wish, wish.span / 2, {}));
    face_towards(dice, body.back(), wish.centre, false);
  }
  shuffle(dice, body);
  return body;
}

RandomBody random_meeting_body(Dice& dice, const BodyWish& wish) {
  for (;;) {
    RandomBody body = meeting_body_of_any_size(dice, wish);
    if (!wish.bounded || has_room(body, wish)) return body;
  }
}

RandomBody mate_of(Dice& dice, RandomBody body) {
  RandomHalfSpace& seam = body[dice.below(static_cast<std::int64_t>(body.size()))];
  seam.complement = !seam.complement;
  return body;
}

}  // namespace halfspace::oracle
