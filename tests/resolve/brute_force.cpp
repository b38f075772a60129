#include "tests/resolve/brute_force.hpp"

#include <algorithm>
#include <map>
#include <tuple>

namespace halfspace::test {
namespace {

// A half-space on the ray of one dot: a z^2 + b z + c.
struct OnRay {
  mpz_class a, b, c;
};

OnRay on_ray(const IntegerHalfSpace& h, const mpz_class& x, const mpz_class& y) {
  const auto& c = h.c;
  if (h.kind == HalfSpaceKind::plane) return {0, c[2], c[0] * x + c[1] * y + c[3]};
  return {c[2], 2 * (c[5] * x + c[4] * y + c[8]),
          c[0] * x * x + c[1] * y * y + 2 * c[3] * x * y + 2 * c[6] * x + 2 * c[7] * y + c[9]};
}

// z = (u + t sqrt(d)) / w
struct Depth {
  mpz_class u, d, w;
  int t = 0;
};

std::optional<Depth> depth_of(const OnRay& f, Sheet sheet) {
  if (f.a == 0) {
    if (f.b == 0 || sheet != Sheet::only) return std::nullopt;
    return Depth{-f.c, 0, f.b, 0};
  }
  if (sheet == Sheet::only) return std::nullopt;
  const mpz_class d = f.b * f.b - 4 * f.a * f.c;
  if (d < 0) return std::nullopt;
  const bool plus = (sheet == Sheet::back) == (f.a > 0);
  return Depth{-f.b, d, 2 * f.a, plus ? 1 : -1};
}

// The sign of g at the depth: of rational + irrational * sqrt(d).
int sign_at(const OnRay& g, const Depth& z) {
  const mpz_class rational = g.a * (z.u * z.u + z.d) + g.b * z.u * z.w + g.c * z.w * z.w;
  const mpz_class irrational = z.t * (2 * g.a * z.u + g.b * z.w);
  const int s = sgn(rational);
  const int r = sgn(irrational) * sgn(z.d);
  if (s == 0 || r == 0 || s == r) return s != 0 ? s : r;
  const mpz_class difference = rational * rational - irrational * irrational * z.d;
  return s * sgn(difference);
}

mpz_class value(const Curve& k, const mpz_class& x, const mpz_class& y) {
  return k.q[0] * x * x + k.q[1] * x * y + k.q[2] * y * y + k.q[3] * x + k.q[4] * y + k.q[5];
}

// The derivative in x.
mpz_class slope(const Curve& k, const mpz_class& x, const mpz_class& y) { return 2 * k.q[0] * x + k.q[1] * y + k.q[3]; }

// On which side of an arc a dot lies: -1 left, 0 on it, 1 right.
int side_of(const Curve& k, Branch branch, const mpz_class& x, const mpz_class& y) {
  const int v = sgn(value(k, x, y));
  const int s = sgn(slope(k, x, y));
  switch (branch) {
    case Branch::single:
      return v;
    case Branch::left:
      return v < 0 || s > 0 ? 1 : v == 0 ? 0 : -1;
    case Branch::right:
      return v < 0 || s < 0 ? -1 : v == 0 ? 0 : 1;
  }
  return 0;
}

// p + r sqrt(d); nothing where d < 0.
std::optional<int> sign_of(const RadicalForm& form, const mpz_class& x, const mpz_class& y) {
  const mpz_class d = value(form.d, x, y);
  if (d < 0) return std::nullopt;
  const mpz_class p = value(form.p, x, y);
  const mpz_class r = value(form.r, x, y);
  const int s = sgn(p);
  const int t = sgn(r) * sgn(d);
  if (s == 0 || t == 0 || s == t) return s != 0 ? s : t;
  const mpz_class difference = p * p - r * r * d;
  return s * sgn(difference);
}

std::optional<int> sign_of(const QuarticForm& form, const mpz_class& x, const mpz_class& y) {
  mpz_class sum = 0;
  std::size_t next = 0;
  for (unsigned degree = 5; degree-- > 0;) {
    for (unsigned j = 0; j <= degree; ++j) {
      mpz_class term = form.q[next++];
      for (unsigned k = 0; k < degree - j; ++k) term *= x;
      for (unsigned k = 0; k < j; ++k) term *= y;
      sum += term;
    }
  }
  return sgn(sum);
}

mpz_class scaled_place(const Separator& separator, const Window& window, std::int64_t line) {
  return mpz_class(static_cast<long>(separator.at)) +
         mpz_class(static_cast<long>(separator.step)) * static_cast<long>(line - window.y0);
}

template <typename Form>
int guided_side(const Form& form, const Guide& guide, const mpz_class& x, const mpz_class& y, std::int64_t line) {
  const auto window = std::find_if(guide.windows.begin(), guide.windows.end(),
                                   [line](const Window& w) { return w.y0 <= line && line <= w.y1; });
  const mpz_class place = x << 16;
  if (window->left && place <= scaled_place(*window->left, *window, line)) return -1;
  if (window->right && place >= scaled_place(*window->right, *window, line)) return 1;
  const auto sign = sign_of(form, x, y);
  if (!sign) return guide.missing_right ? 1 : -1;
  return guide.rising ? *sign : -*sign;
}

int side_of(const Arc& arc, const mpz_class& x, const mpz_class& y, std::int64_t line) {
  if (const auto* curve = std::get_if<Curve>(&arc.form)) return side_of(*curve, arc.branch, x, y);
  if (const auto* form = std::get_if<RadicalForm>(&arc.form)) return guided_side(*form, arc.guide, x, y, line);
  return guided_side(std::get<QuarticForm>(arc.form), arc.guide, x, y, line);
}

bool arc_exists(const Arc& arc, const mpz_class& y) {
  if (!std::holds_alternative<Curve>(arc.form)) return true;
  const auto& q = std::get<Curve>(arc.form).q;
  const mpz_class linear = q[1] * y + q[3];
  if (arc.branch == Branch::single) return q[0] == 0 && linear > 0;
  const mpz_class constant = q[2] * y * y + q[4] * y + q[5];
  return q[0] > 0 && linear * linear >= 4 * q[0] * constant;
}

// Are the lines of a guided arc those of its windows, in order?
bool has_whole_guide(const Arc& arc) {
  if (std::holds_alternative<Curve>(arc.form)) return arc.guide.windows.empty();
  std::int64_t next = arc.y0;
  for (const Window& window : arc.guide.windows) {
    if (window.y0 != next || window.y1 < window.y0) return false;
    next = std::int64_t{window.y1} + 1;
  }
  return next == std::int64_t{arc.y1} + 1;
}

using FaceKey = std::tuple<std::uint32_t, std::uint32_t, Sheet>;

// Does the sheet exist on this ray, with every other half-space of the body holding there?
bool shows(const IntegerBody& body, const std::vector<OnRay>& rays, std::uint32_t half_space, Sheet sheet) {
  if (body.half_spaces[half_space].transparent) return false;
  const auto z = depth_of(rays[half_space], sheet);
  if (!z) return false;
  for (std::uint32_t k = 0; k < rays.size(); ++k) {
    if (k == half_space) continue;
    const int sign = sign_at(rays[k], *z);
    if (body.half_spaces[k].complement ? sign < 0 : sign > 0) return false;
  }
  return true;
}

std::vector<OnRay> rays_at(const IntegerBody& body, int i, int j) {
  std::vector<OnRay> rays;
  const mpz_class x = i - body.origin[0];
  const mpz_class y = j - body.origin[1];
  for (const IntegerHalfSpace& h : body.half_spaces) rays.push_back(on_ray(h, x, y));
  return rays;
}

bool in_cell(const IntegerScene& scene, const ResolvedScene& resolved, const Cell& cell, int i, int j) {
  const IntegerBody& body = scene.bodies[resolved.faces[cell.face].body];
  const mpz_class x = i - body.origin[0];
  const mpz_class y = j - body.origin[1];
  return (cell.left == no_arc || side_of(resolved.arcs[cell.left], x, y, j) >= 0) &&
         (cell.right == no_arc || side_of(resolved.arcs[cell.right], x, y, j) <= 0);
}

// In how many cells and spans of its face each dot of the page is; one vector a face.
std::vector<std::vector<int>> coverage(const IntegerScene& scene, const ResolvedScene& resolved) {
  const auto width = static_cast<std::size_t>(scene.width);
  const auto dots = width * static_cast<std::size_t>(scene.height);
  std::vector<std::vector<int>> cover(resolved.faces.size(), std::vector<int>(dots));
  const auto at = [width](int i, int j) { return static_cast<std::size_t>(j) * width + static_cast<std::size_t>(i); };
  for (const Cell& cell : resolved.cells) {
    for (int j = cell.y0; j <= cell.y1; ++j) {
      for (int i = scene.scissor.x0; i <= scene.scissor.x1; ++i) {
        cover[cell.face][at(i, j)] += in_cell(scene, resolved, cell, i, j) ? 1 : 0;
      }
    }
  }
  for (const LineSpan& span : resolved.spans) {
    for (int i = span.x0; i <= span.x1; ++i) ++cover[span.face].at(at(i, span.y));
  }
  return cover;
}

}  // namespace

std::optional<std::string> broken_structure(const IntegerScene& scene, const ResolvedScene& resolved) {
  for (std::size_t a = 0; a < resolved.arcs.size(); ++a) {
    const Arc& arc = resolved.arcs[a];
    if (arc.y0 > arc.y1) return "arc " + std::to_string(a) + " has no line";
    if (!has_whole_guide(arc)) return "the windows of arc " + std::to_string(a) + " are not its lines";
    for (int y = arc.y0; y <= arc.y1; ++y) {
      if (!arc_exists(arc, y - scene.bodies[arc.body].origin[1])) {
        return "arc " + std::to_string(a) + " does not exist on line " + std::to_string(y);
      }
    }
  }
  for (std::size_t c = 0; c < resolved.cells.size(); ++c) {
    const Cell& cell = resolved.cells[c];
    const std::string name = "cell " + std::to_string(c);
    if (cell.y0 > cell.y1 || cell.y0 < scene.scissor.y0 || cell.y1 > scene.scissor.y1) return name + ": bad lines";
    for (const std::uint32_t side : {cell.left, cell.right}) {
      if (side == no_arc) continue;
      const Arc& arc = resolved.arcs.at(side);
      if (cell.y0 < arc.y0 || cell.y1 > arc.y1) return name + " leaves the lines of its arc";
      if (arc.body != resolved.faces.at(cell.face).body) return name + " has an arc of another body";
    }
  }
  for (std::size_t f = 1; f < resolved.faces.size(); ++f) {
    const auto key = [&](std::size_t i) {
      return FaceKey{resolved.faces[i].body, resolved.faces[i].half_space, resolved.faces[i].sheet};
    };
    if (!(key(f - 1) < key(f))) return "faces out of order";
  }
  return std::nullopt;
}

std::optional<std::string> wrong_dot(const IntegerScene& scene, const ResolvedScene& resolved) {
  std::map<FaceKey, std::uint32_t> index;
  for (std::uint32_t f = 0; f < resolved.faces.size(); ++f) {
    index[{resolved.faces[f].body, resolved.faces[f].half_space, resolved.faces[f].sheet}] = f;
  }
  const std::vector<std::vector<int>> cover = coverage(scene, resolved);
  const auto wrong_on = [&](std::uint32_t b, int i, int j) -> std::optional<std::string> {
    const IntegerBody& body = scene.bodies[b];
    const std::vector<OnRay> rays = rays_at(body, i, j);
    for (std::uint32_t h = 0; h < rays.size(); ++h) {
      for (const Sheet sheet : {Sheet::only, Sheet::front, Sheet::back}) {
        const auto face = index.find({b, h, sheet});
        const auto dot =
            static_cast<std::size_t>(j) * static_cast<std::size_t>(scene.width) + static_cast<std::size_t>(i);
        const int have = face == index.end() ? 0 : cover[face->second][dot];
        if (have == (shows(body, rays, h, sheet) ? 1 : 0)) continue;
        return "body " + std::to_string(b) + " half-space " + std::to_string(h) + " sheet " +
               std::to_string(static_cast<int>(sheet)) + " dot (" + std::to_string(i) + ", " + std::to_string(j) +
               "): in " + std::to_string(have) + " cells";
      }
    }
    return std::nullopt;
  };
  for (std::uint32_t b = 0; b < scene.bodies.size(); ++b) {
    for (int j = scene.scissor.y0; j <= scene.scissor.y1; ++j) {
      for (int i = scene.scissor.x0; i <= scene.scissor.x1; ++i) {
        if (auto wrong = wrong_on(b, i, j)) return wrong;
      }
    }
  }
  return std::nullopt;
}

}  // namespace halfspace::test
