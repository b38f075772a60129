#include "host/flatten/quantise.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "host/flatten/family.hpp"
#include "host/flatten/least_scale.hpp"
#include "host/flatten/rational.hpp"
#include "host/flatten/spectrum.hpp"

namespace halfspace {
namespace {

constexpr int scale_limit = 400;      // bits; a needle of 1 : 10^6 needs about 60
constexpr int small_plane_bits = 30;  // exact proportions up to here are taken as they are

Real quadric_reach(const std::array<Real, 10>& c, const LocalBox& box) {
  const Vector4 h{box.half[0], box.half[1], box.half[2], 1};
  Real total = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) total += magnitude(c[quadric_index[i][j]]) * h[i] * h[j];
  }
  return total;
}

// How far the plane form / most, nearly h, is from h in the box.
Real plane_moved(const IntegerForm& form, Real most, const RealHalfSpace& h, const LocalBox& box) {
  Vector4 apart{};
  for (std::size_t i = 0; i < 4; ++i) apart[i] = to_real(form.c[i]) / most - h.c[i];
  return reach(apart, box) / length({h.c[0], h.c[1], h.c[2]});
}

// Both on the local frame, `h` normalised. The proportions of h where these are small integers.
std::optional<Quantised> take_exactly(const RealHalfSpace& h, const LocalBox& box) {
  const std::size_t count = coefficient_count(h.kind);
  const bool is_plane = h.kind == HalfSpaceKind::plane;
  const auto integers =
      small_proportions(std::span(h.c).first(count), is_plane ? small_plane_bits : small_quadric_bits);
  if (!integers) return std::nullopt;
  Quantised result{{h.kind, {}}, 0};
  Real most = 0;
  for (std::size_t i = 0; i < count; ++i) {
    result.form.c[i] = (*integers)[i];
    most = larger(most, magnitude(to_real((*integers)[i])));
  }
  bool is_exact = true;
  for (std::size_t i = 0; i < count; ++i) is_exact = is_exact && to_real(result.form.c[i]) == h.c[i] * most;
  if (!is_exact) result.bound = is_plane ? plane_moved(result.form, most, h, box) : dropped_part(box);
  if (result.bound > box.target) return std::nullopt;
  return result;
}

// The least scale, a power of two, that `holds` of in Real. Trials that `certain(bits)` tells of do not ask it.
template <class Certain, class Holds>
std::optional<Real> least_scale(Certain certain, Holds holds) {
  return with_least_bits(0, scale_limit, [&](int bits) {
    const Real scale = power_of_two(bits);
    const std::optional<bool> known = certain(bits);
    return (known ? *known : holds(scale)) ? std::optional(scale) : std::nullopt;
  });
}

// Whether coefficients that are rounded at a scale are off by no more than a limit, each with its weight: in doubles,
//   sum weight_i |rounding of c_i scale| <= limit scale,
// where a rounding is off by 2^-53, the limit by 2^-53 of it, and what is left, weights and a sum of sixteen, by 2^-47 of the sum.
class RoundingLimit {
 public:
  explicit RoundingLimit(Real limit) : limit_(static_cast<double>(limit)) {}

  void add(Real c, double weight) {
    terms_[count_++] = {c, weight};
    weights_ += weight;
  }

  [[nodiscard]] std::optional<bool> holds(int bits) const {
    constexpr double most = 0x1p400;  // far from where doubles end
    if (!(limit_ > 1 / most && limit_ < most && weights_ < most)) return std::nullopt;
    const double most_sum = std::ldexp(limit_, bits);
    const double slack = weights_ * 0x1p-52 + most_sum * 0x1p-44;
    double sum = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      sum += terms_[i].weight * std::abs(rounding_of(terms_[i].c, bits));
      if (sum > most_sum + slack) return false;
    }
    if (sum < most_sum - slack) return true;
    return std::nullopt;
  }

 private:
  struct Term {
    Real c;
    double weight = 0;
  };
  std::array<Term, 10> terms_{};
  std::size_t count_ = 0;
  double limit_, weights_ = 0;
};

std::optional<Quantised> quantise_plane(const RealHalfSpace& h, const LocalBox& box) {
  const Vector3 normal{h.c[0], h.c[1], h.c[2]};
  const Real most = largest(normal);
  if (most == 0) {  // everything or nothing: there is no surface
    Quantised result{{h.kind, {}}, 0};
    result.form.c[3] = h.c[3] < 0 ? -1 : (h.c[3] > 0 ? 1 : 0);
    return result;
  }
  const Vector4 form{h.c[0] / most, h.c[1] / most, h.c[2] / most, h.c[3] / most};
  const Real size = length({form[0], form[1], form[2]});
  const auto bound = [&](Real scale) { return reach(residual_of(form, scale), box) / (scale * size); };
  RoundingLimit limit(box.target * size);
  for (std::size_t i = 0; i < 4; ++i) limit.add(form[i], i < 3 ? static_cast<double>(box.half[i]) : 1);
  const auto scale =
      least_scale([&](int bits) { return limit.holds(bits); }, [&](Real s) { return bound(s) <= box.target; });
  if (!scale) return std::nullopt;
  Quantised result{{h.kind, {}}, bound(*scale)};
  for (std::size_t i = 0; i < 4; ++i) result.form.c[i] = round_to_integer(form[i] * *scale);
  return result;
}

// A sphere and what becomes of it: an integer centre in 1/scale dot and an integer squared radius, |scale x - m|^2 = r2. The scale is a power
// of two, so a rounding alone is what is off, which doubles hold to 2^-50 of it.
class RoundedSphere {
 public:
  RoundedSphere(const Vector3& centre, Real square, Real target)
      : centre_(centre),
        square_(square),
        near_square_(static_cast<double>(square)),
        near_radius_(near_square_ > 0 ? std::sqrt(near_square_) : 0),
        near_target_(static_cast<double>(target)) {}

  [[nodiscard]] bool holds(int bits) const {
    const double centre_off = centre_off_by(bits);
    return std::isfinite(centre_off) && keeps_sign(bits) && centre_off + radius_off_by(bits) <= near_target_;
  }

  // 2^-40 of it is for the doubles, the rest for fractions that they leave out.
  [[nodiscard]] Real bound(int bits) const {
    return (centre_off_by(bits) + radius_off_by(bits)) * (1 + 0x1p-40) + double_power_of_two(-60 - bits);
  }

  void write(int bits, IntegerForm& form) const {
    if (writes_words(bits, form)) return;
    const auto shift = static_cast<mp_bitcnt_t>(bits);
    mpz_class& constant = form.c[9];
    constant = round_to_integer(-times_power_of_two(square_, 2 * bits));
    for (std::size_t i = 0; i < 3; ++i) {
      const mpz_class m = round_to_integer(-times_power_of_two(centre_[i], bits));
      mpz_setbit(form.c[i].get_mpz_t(), 2 * shift);
      mpz_mul_2exp(form.c[6 + i].get_mpz_t(), m.get_mpz_t(), shift);
      mpz_addmul(constant.get_mpz_t(), m.get_mpz_t(), m.get_mpz_t());
    }
  }

 private:
  // The same without its common factor, 2^twos, where all fit in words: m and scale in 30 bits, r2 in 61.
  [[nodiscard]] bool writes_words(int bits, IntegerForm& form) const {
    constexpr int most_bits = 30;
    if (bits > most_bits || largest(centre_) >= power_of_two(most_bits - bits) ||
        magnitude(square_) >= power_of_two(2 * (most_bits - bits) + 1)) {
      return false;
    }
    std::array<std::int64_t, 3> linear{};
    std::int64_t constant = -nearest_word(times_power_of_two(square_, 2 * bits));
    int twos = 2 * bits;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int64_t m = -nearest_word(times_power_of_two(centre_[i], bits));
      linear[i] = m * (std::int64_t{1} << bits);
      constant += m * m;
      twos = std::min(twos, std::countr_zero(static_cast<std::uint64_t>(linear[i])));
    }
    twos = std::min(twos, std::countr_zero(static_cast<std::uint64_t>(constant)));
    for (std::size_t i = 0; i < 3; ++i) {
      form.c[i] = std::int64_t{1} << (2 * bits - twos);
      if (linear[i] != 0) form.c[6 + i] = linear[i] >> twos;
    }
    if (constant != 0) form.c[9] = constant >> twos;
    return true;
  }

  // Infinite where it is above the target.
  [[nodiscard]] double centre_off_by(int bits) const {
    const double most = near_target_ * double_power_of_two(bits);
    double sum_of_squares = 0;
    for (const Real c : centre_) {
      const double off = rounding_of(c, bits);
      sum_of_squares += off * off;
      if (sum_of_squares > most * most) return std::numeric_limits<double>::infinity();
    }
    return std::sqrt(sum_of_squares) * double_power_of_two(-bits);
  }

  // Of two radii by their squares: a - b = (a^2 - b^2) / (a + b).
  [[nodiscard]] double radius_off_by(int bits) const {
    if (near_radius_ == 0) return 0;
    const double off = rounding_of(square_, 2 * bits) * double_power_of_two(-2 * bits);
    return std::abs(off) / (std::sqrt(near_square_ + off) + near_radius_);
  }

  // r2 is 0 only where the square is.
  [[nodiscard]] bool keeps_sign(int bits) const {
    return is_zero(square_) || magnitude(square_) >= power_of_two(-2 * bits - 1);
  }

  Vector3 centre_;
  Real square_;
  double near_square_, near_radius_, near_target_;
};

std::optional<Quantised> quantise_sphere(const ReducedQuadric& reduced, const LocalBox& box) {
  const Real weight = reduced.squares[0].weight;
  Vector3 centre{};
  for (const SquareTerm& term : reduced.squares) {
    for (std::size_t i = 0; i < 3; ++i) add_product(centre[i], term.form[i], -term.form[3]);
  }
  const RoundedSphere sphere(centre, -reduced.constant() / weight, box.target);
  const auto bits = with_least_bits(
      0, scale_limit, [&](int trial) { return sphere.holds(trial) ? std::optional(trial) : std::nullopt; });
  std::optional<Quantised> result;
  if (bits) {
    result.emplace();
    result->form.kind = HalfSpaceKind::quadric;
    result->bound = sphere.bound(*bits);
    sphere.write(*bits, result->form);
    if (weight < 0) negate(result->form);
  }
  return result;
}

// The least of |gradient / 2|^2 on a central quadric sum w l^2 = -constant is |constant| times the least weight of
// the sign that can balance the constant; 0 where there is none, and no surface either.
Real least_gradient(const ReducedQuadric& reduced) {
  Real least = 0;
  for (std::size_t i = 0; i < reduced.count; ++i) {
    const Real weight = reduced.squares[i].weight;
    if ((weight < 0) == (reduced.constant() < 0)) continue;
    least = least == 0 ? magnitude(weight) : smaller(least, magnitude(weight));
  }
  return square_root(least * magnitude(reduced.constant()));
}

// What quantise_central asks of a scale.
class CentralLimits {
 public:
  CentralLimits(const RealHalfSpace& h, const ReducedQuadric& reduced, Real bending, Real gradient, const LocalBox& box)
      : bending_(bending), value_(most_value(reduced, gradient, box)) {
    std::array<double, 4> half{0, 0, 0, 1};
    std::transform(box.half.begin(), box.half.end(), half.begin(), [](Real v) { return static_cast<double>(v); });
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = i; j < 4; ++j) {
        const Real c = h.c[quadric_index[i][j]];
        const double times = i == j ? 1 : 2;
        value_.add(c, times * half[i] * half[j]);
        if (j < 3) bending_.add(c, times);
      }
    }
  }

  [[nodiscard]] std::optional<bool> hold(int bits) const {
    const std::optional<bool> bending = bending_.holds(bits);
    if (!bending.value_or(true)) return false;
    const std::optional<bool> value = value_.holds(bits);
    if (!value.value_or(true)) return false;
    return bending && value ? std::optional(true) : std::nullopt;
  }

 private:
  static Real most_value(const ReducedQuadric& reduced, Real gradient, const LocalBox& box) {
    const Real most = magnitude(reduced.constant()) / 4;
    return gradient == 0 ? most : smaller(most, box.target * 2 * gradient);
  }

  RoundingLimit bending_, value_;
};

// Ellipsoids and hyperboloids: ten rounded coefficients. The kind survives, since an error of the second-order part
// below its least weight keeps the signs of all weights (Weyl), and one that is a fraction of the constant keeps its
// sign.
std::optional<Quantised> quantise_central(const RealHalfSpace& h, const ReducedQuadric& reduced, const LocalBox& box) {
  const Real gradient = least_gradient(reduced);
  const auto& [first, second, third] = reduced.squares;
  const Real least_weight =
      smaller(magnitude(first.weight), smaller(magnitude(second.weight), magnitude(third.weight)));
  const auto bound = [&](Real scale) -> std::optional<Real> {
    std::array<Real, 10> residual{};
    for (std::size_t i = 0; i < 10; ++i) residual[i] = nearest_whole(h.c[i] * scale) - h.c[i] * scale;
    Real bending = 0;
    for (std::size_t i = 0; i < 6; ++i) bending += (i < 3 ? 1 : 2) * magnitude(residual[i]);
    const Real error = quadric_reach(residual, box) / scale;
    if (bending / scale > least_weight / 4 || error > magnitude(reduced.constant()) / 4) return std::nullopt;
    const Real moved = gradient == 0 ? 0 : error / (2 * gradient);
    return moved <= box.target ? std::optional(moved) : std::nullopt;
  };
  const CentralLimits limits(h, reduced, least_weight / 4, gradient, box);
  const auto scale =
      least_scale([&](int bits) { return limits.hold(bits); }, [&](Real s) { return bound(s).has_value(); });
  if (!scale) return std::nullopt;
  Quantised result{{h.kind, {}}, *bound(*scale)};
  for (std::size_t i = 0; i < 10; ++i) result.form.c[i] = round_to_integer(h.c[i] * *scale);
  return result;
}

bool is_sphere(const ReducedQuadric& reduced) {
  if (reduced.count < 3) return false;
  const auto& [a, b, c] = reduced.squares;
  return agree(a.weight, b.weight) && agree(a.weight, c.weight);
}

// No second-order part: 2 (Gx + Hy + Jz) + K, of which the plane is (G, H, J, K/2).
std::optional<Quantised> quantise_plane_like(const ReducedQuadric& reduced, const LocalBox& box) {
  const Vector4& rest = reduced.rest;
  auto plane = quantise_plane({HalfSpaceKind::plane, {rest[0], rest[1], rest[2], rest[3]}}, box);
  if (!plane) return std::nullopt;
  Quantised result{{HalfSpaceKind::quadric, {}}, plane->bound};
  for (std::size_t i = 0; i < 3; ++i) result.form.c[6 + i] = plane->form.c[i];
  result.form.c[9] = 2 * plane->form.c[3];
  return result;
}

std::optional<Quantised> quantise_quadric(const RealHalfSpace& h, const LocalBox& box, int least_bits) {
  const ReducedQuadric reduced = reduce(h, box.radius);
  if (reduced.count == 0) return quantise_plane_like(reduced, box);
  if (is_sphere(reduced)) return quantise_sphere(reduced, box);
  if (reduced.count == 3 && reduced.constant() != 0) return quantise_central(h, reduced, box);
  Kinship alone;
  alone.squares = reduced.count;
  alone.rank = reduced.count + (reduced.linear ? 2 : reduced.constant() != 0 ? 1 : 0);
  return quantise_squares(h, alone, box, least_bits);
}

bool is_zero(const RealHalfSpace& h) {
  return std::all_of(h.c.begin(), h.c.end(), [](Real v) { return is_zero(v); });
}

// In the box's frame.
std::optional<Quantised> quantise_locally(const RealHalfSpace& h, const LocalBox& box, int least_bits) {
  if (is_zero(h)) return Quantised{{h.kind, {}}, 0};
  if (auto exact = take_exactly(h, box)) return exact;
  return h.kind == HalfSpaceKind::plane ? quantise_plane(h, box) : quantise_quadric(h, box, least_bits);
}

// None where the box lies too far away for its size, or nothing finite is left.
std::optional<RealHalfSpace> moved_to(const LocalBox& box, const RealHalfSpace& half_space, const Matrix4& inverse) {
  const auto here = inverse_from(box, inverse);
  if (!here) return std::nullopt;
  const RealHalfSpace h = normalised(transformed(half_space, *here));
  return finite(h) ? std::optional(h) : std::nullopt;
}

}  // namespace

std::optional<Quantised> quantise(const RealHalfSpace& half_space, const Matrix4& inverse, const Region& region,
                                  int least_bits) {
  const LocalBox local = local_box(region);
  const auto here = moved_to(local, half_space, inverse);
  std::optional<Quantised> result = here ? quantise_locally(*here, local, least_bits) : std::nullopt;
  if (result) {
    make_primitive(result->form);
    for (std::size_t i = 0; i < 3; ++i) result->form.origin[i] = round_to_integer(local.centre[i]);
  }
  return result;
}

namespace {

// a - t b for the t that takes b's weightiest coefficient in the box to a's.
std::array<Real, 10> least_difference(const RealHalfSpace& a, const RealHalfSpace& b, const LocalBox& box) {
  std::size_t pivot = 0;
  Real most = 0;
  for (std::size_t i = 0; i < 10; ++i) {
    const Real weight = magnitude(b.c[i]) * (i < 9 ? box.radius : 1) * (i < 6 ? box.radius : 1);
    if (weight > most) pivot = i;
    most = larger(most, weight);
  }
  const Real t = b.c[pivot] / a.c[pivot];
  std::array<Real, 10> apart{};
  for (std::size_t i = 0; i < 10; ++i) apart[i] = i == pivot ? 0 : t * a.c[i] - b.c[i];
  return apart;
}

// How far a point with this value, at most, lies from the surface: along its gradient, and where that may vanish along the
// square of the least weight.
Real distance_of_value(Real value, const ReducedQuadric& reduced) {
  if (reduced.linear) return value / length({reduced.rest[0], reduced.rest[1], reduced.rest[2]});
  std::optional<Real> least_weight;
  for (std::size_t i = 0; i < reduced.count; ++i) {
    const Real weight = magnitude(reduced.squares[i].weight);
    least_weight = least_weight ? smaller(*least_weight, weight) : weight;
  }
  if (!least_weight) return 0;  // everything or nothing
  const Real root = square_root(value / *least_weight);
  const Real gradient = least_gradient(reduced);
  if (gradient == 0 || value > magnitude(reduced.constant()) / 4) return root;
  return smaller(root, value / (2 * gradient));
}

}  // namespace

std::optional<Real> quadric_distance(const PlacedShape& a, const PlacedShape& truth, const Region& region) {
  const LocalBox local = local_box(region);
  const auto from_a = inverse_from(local, a.inverse);
  const auto from_truth = inverse_from(local, truth.inverse);
  if (!from_a || !from_truth) return std::nullopt;
  const RealHalfSpace here = normalised(transformed(a.shape, *from_a));
  const RealHalfSpace true_here = normalised(transformed(truth.shape, *from_truth));
  const Real value = quadric_reach(least_difference(here, true_here, local), local);
  if (!finite(value)) return std::nullopt;
  if (value == 0) return 0;
  return distance_of_value(value, reduce(true_here, local.radius));
}

// On the true plane b the value of a is that of a - t b for any t, of which the least is taken.
Real plane_distance(const IntegerForm& plane, const RealHalfSpace& truth, const Region& region) {
  const LocalBox local = local_box(region);
  const RealHalfSpace a = seen_from(to_real(seen_from(plane, IntegerPoint{})), local.centre);
  const RealHalfSpace b = seen_from(truth, local.centre);
  const Real size = length({a.c[0], a.c[1], a.c[2]});
  std::optional<Real> least;
  for (std::size_t pivot = 0; pivot < 4; ++pivot) {
    if (b.c[pivot] == 0) continue;
    const Real t = a.c[pivot] / b.c[pivot];
    Vector4 apart{};
    for (std::size_t i = 0; i < 4; ++i) apart[i] = i == pivot ? 0 : a.c[i] - t * b.c[i];
    const Real value = reach(apart, local);
    least = least ? smaller(*least, value) : value;
  }
  return size == 0 || !least ? 0 : *least / size;
}

}  // namespace halfspace
