#include "host/job/limits.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>

#include "host/algebra/truncated.hpp"
#include "host/flatten/matrix.hpp"
#include "host/job/job_bytes.hpp"

namespace halfspace {
namespace {

int bits_of_int(std::int64_t value) {
  return static_cast<int>(std::bit_width(static_cast<std::uint64_t>(std::abs(value))));
}

// The farthest local coordinate that a dot of the scissor, or one beside it, can have.
struct Extent {
  long x, y;
};

Extent extent_of(const Scissor& s, const std::array<std::int64_t, 3>& origin) {
  const auto far = [](std::int64_t low, std::int64_t high, std::int64_t o) {
    return static_cast<long>(std::max(std::abs(low - 1 - o), std::abs(high + 2 - o)));
  };
  return {far(s.x0, s.x1, origin[0]), far(s.y0, s.y1, origin[1])};
}

int largest_origin_bits(const IntegerScene& scene) {
  int bits = 0;
  for (const IntegerBody& body : scene.bodies) bits = std::max(bits, bits_of_int(body.origin[2]));
  return bits;
}

}  // namespace

bool FaceBits::covers(const FaceBits& other) const {
  return p >= other.p && q >= other.q && d >= other.d && normal >= other.normal && linear >= other.linear;
}

void FaceBits::extend(const FaceBits& other) {
  p = std::max(p, other.p);
  q = std::max(q, other.q);
  d = std::max(d, other.d);
  normal = std::max(normal, other.normal);
  linear = std::max(linear, other.linear);
}

namespace {

// Magnitudes as they are.
struct Exact {
  using Number = mpz_class;
  static Number magnitude(const mpz_class& v) { return abs(v); }
  static int bits(const Number& v) { return bits_of(v); }
};

// Magnitudes in doubles, and bits for 2^-40 more: no term is negative, and fewer than a hundred roundings make one number.
struct Above {
  using Number = double;
  static Number magnitude(const mpz_class& v) { return std::abs(truncated(v)); }
  static int bits(Number v) {
    if (v == 0) return 0;
    return std::isfinite(v) ? std::ilogb(v * (1 + 0x1p-40)) + 1 : 1 << 20;
  }
};

template <class Way>
FaceBits face_bits_by(const IntegerScene& scene, const IntegerBody& body, const IntegerHalfSpace& half_space) {
  using Number = typename Way::Number;
  const Extent e = extent_of(scene.scissor, body.origin);
  std::array<Number, 10> c;
  for (std::size_t i = 0; i < 10; ++i) c[i] = Way::magnitude(half_space.c[i]);
  FaceBits bits;
  if (half_space.kind == HalfSpaceKind::plane) {
    bits.p = Way::bits(c[0] * e.x + c[1] * e.y + c[3]);
    bits.d = Way::bits(c[2]);
    bits.linear = bits.p;
    return bits;
  }
  const Number b = c[5] * e.x + c[4] * e.y + c[8];
  const Number rest =
      c[0] * e.x * e.x + 2 * c[3] * e.x * e.y + c[1] * e.y * e.y + 2 * c[6] * e.x + 2 * c[7] * e.y + c[9];
  const bool root = half_space.c[2] != 0;
  const Number p = root ? b : rest;
  const Number d = root ? c[2] : Number(2 * b);
  const Number q = root ? Number(b * b + c[2] * rest) : Number(0);
  bits.p = Way::bits(p);
  bits.q = Way::bits(q);
  bits.d = Way::bits(d);
  bits.linear = root ? bits.p : 0;
  std::array<Number, 3> gradient;
  Number far = 0;  // what the gradient's last component adds, by the matrix's last column
  for (std::size_t j = 0; j < 4; ++j) {
    const auto& row = quadric_index[j];
    const Number g = (c[row[0]] * e.x + c[row[1]] * e.y + c[row[3]]) * d + c[row[2]] * p;
    if (j < 3) gradient[j] = g;
    far += g * (j < 3 ? static_cast<long>(std::abs(body.origin[j])) : 1L);
  }
  for (const auto& row : scene.lighting.normal_matrix) {
    Number sum = far * static_cast<long>(std::abs(row[3]));
    for (std::size_t j = 0; j < 3; ++j) sum += gradient[j] * static_cast<long>(std::abs(row[j]));
    bits.normal = std::max(bits.normal, Way::bits(sum));
  }
  return bits;
}

}  // namespace

FaceBits face_bits(const IntegerScene& scene, const IntegerBody& body, const IntegerHalfSpace& half_space) {
  return face_bits_by<Exact>(scene, body, half_space);
}

FaceBits face_bits_above(const IntegerScene& scene, const IntegerBody& body, const IntegerHalfSpace& half_space) {
  return face_bits_by<Above>(scene, body, half_space);
}

std::optional<std::string> check_face(const FaceBits& f) {
  if (f.linear > 125) return "its depth needs more than 126 bits";
  // root_surface.cpp: |N|^2 in 512 bits; rational_shade.cpp: a component, with its partial sums, in 256.
  if (f.q + 4 > 255 || f.normal + 20 > 255 || f.p > 250) return "its shading needs more than 256 bits";
  return std::nullopt;
}

int level_bits(const IntegerScene& scene, const FaceBits& f) {
  // reaches_level: P = scale^2 (l . N)^2 + t^2 l2 |N|^2, and its square where there is a root.
  const int light = 18 + f.normal + 2;
  const int scale = bits_of_int(scene.levels - 1) + bits_of_int(scene.lighting.parallel);
  const int threshold = bits_of_int(scene.levels) + bits_of_int(scene.lighting.unit);
  const int p = 3 + std::max(2 * scale + 2 * light, 2 * threshold + 2 * 17 + 2 * f.normal + 3);
  return 1 + (f.q == 0 ? p : 2 * p + 2);
}

int depth_bits(const IntegerScene& scene, const FaceBits& roots, const FaceBits& all) {
  // compare_depth: A + B sqrt(q1) + C sqrt(q2). One root asks for A^2 - B^2 q; two for the square of A^2 - ...
  const auto first = [&scene](const FaceBits& f) {
    return 2 + std::max(largest_origin_bits(scene) + 1 + 2 * f.d, f.p + f.d);
  };
  const int one_root = std::max(2 * first(all), 2 * all.d + all.q) + 2;
  const int p = 2 + std::max(2 * first(roots), 2 * roots.d + roots.q + 1);
  const int two_roots = std::max(2 * p, 2 * (2 * roots.d + 1) + 2 * roots.q) + 2;
  return 1 + std::max(one_root, two_roots);
}

namespace {

// The narrowest of three kinds, given the widths that they hold, sign included.
std::optional<ArcKind> narrowest(int bits, const std::array<int, 3>& widths, ArcKind first) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (bits <= widths[i]) return static_cast<ArcKind>(static_cast<std::size_t>(first) + i);
  }
  return std::nullopt;
}

// Bits of the largest value.
template <class Way>
int largest_value(const Curve& curve, const Extent& e) {
  std::array<typename Way::Number, 6> q;
  for (std::size_t i = 0; i < 6; ++i) q[i] = Way::magnitude(curve.q[i]);
  return Way::bits((q[0] * e.x + q[1] * e.y + q[3]) * e.x + (q[2] * e.y + q[4]) * e.y + q[5]);
}

struct KindOfForm {
  const Extent& e;

  std::optional<ArcKind> operator()(const Curve& curve) const {
    // A difference is at most twice the value, the slope test and a step beyond twice that again.
    const auto kind_of = [&curve](int bits) {
      return narrowest(bits + 5, {64, 128, 256}, is_line(curve) ? ArcKind::line64 : ArcKind::conic64);
    };
    const int above = largest_value<Above>(curve, e);  // by a bit too many, if any
    const auto kind = kind_of(above);
    return kind == kind_of(above - 1) ? kind : kind_of(largest_value<Exact>(curve, e));
  }
  // These are always wide and wrap: a difference may be lost, the values whose signs are asked are not (registers.hpp). The
  // predicate's products have three times the width, so they need no proof of their own.
  std::optional<ArcKind> operator()(const RadicalForm& form) const {
    const int bits =
        std::max({largest_value<Exact>(form.p, e), largest_value<Exact>(form.r, e), largest_value<Exact>(form.d, e)});
    return narrowest(bits + 1, {128, 256, 384}, ArcKind::radical128);
  }
  std::optional<ArcKind> operator()(const QuarticForm& form) const {
    mpz_class value;
    mpz_class y_power = 1;
    // Highest degree first: the sum over j of y^j times a polynomial in x, by Horner in x from degree 4 - j.
    for (int j = 0; j <= 4; ++j) {
      mpz_class in_x;
      for (int degree = 4; degree >= j; --degree) {
        static constexpr int first[5] = {14, 12, 9, 5, 0};  // where the terms of a degree begin
        in_x = in_x * e.x + abs(form.q[static_cast<std::size_t>(first[degree] + j)]);
      }
      value += in_x * y_power;
      y_power *= e.y;
    }
    return narrowest(bits_of(value) + 1, {128, 256, 384}, ArcKind::quartic128);
  }
};

}  // namespace

std::optional<ArcKind> arc_kind(const IntegerScene& scene, const Arc& arc) {
  const Extent e = extent_of(scene.scissor, scene.bodies[arc.body].origin);
  return std::visit(KindOfForm{e}, arc.form);
}

bool separators_fit(const Arc& arc) {
  const auto fits = [](const std::optional<Separator>& s) {
    return !s || (std::abs(s->at) <= largest_separator && std::abs(s->step) <= largest_separator);
  };
  return std::all_of(arc.guide.windows.begin(), arc.guide.windows.end(),
                     [fits](const Window& w) { return fits(w.left) && fits(w.right); });
}

}  // namespace halfspace
