#include "host/flatten/family.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "host/flatten/asymptote.hpp"
#include "host/flatten/least_scale.hpp"
#include "host/flatten/ranked_squares.hpp"
#include "host/flatten/rational.hpp"

namespace halfspace {
namespace {

constexpr int scale_limit = 100;  // bits; 20 to 40 are common

// The common quadric in a frame in which the world's 1 is 1.
struct CommonSquares {
  RankedSquares form;
  std::vector<Vector3> free;  // directions that no form above depends on: unit normals of a basis's remaining forms
};

Vector3 perpendicular_to(const Vector3& v) {
  std::size_t least = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (magnitude(v[i]) < magnitude(v[least])) least = i;
  }
  Vector3 axis{};
  axis[least] = 1;
  return unit(cross(v, axis));
}

// Makes three of them; they are one at least, and orthogonal or no more than two.
std::vector<Vector3> missing_axes(const std::vector<Vector3>& known) {
  if (known.size() == 3) return {};
  if (known.size() == 2) return {cross(known[0], known[1])};
  const Vector3 second = perpendicular_to(known[0]);
  return {second, cross(known[0], second)};
}

// `z_is_ray`: the frame is the page's.
std::optional<CommonSquares> common_squares(const RealHalfSpace& common, const Kinship& kin, bool z_is_ray) {
  auto form = z_is_ray && is_asymptotic(common) ? squares_along_asymptote(common, kin) : ranked_squares_of(common, kin);
  if (!form) return std::nullopt;
  std::vector<Vector3> axes;
  for (const SquareTerm& term : form->squares) axes.push_back({term.form[0], term.form[1], term.form[2]});
  if (form->rest) axes.push_back(unit(*form->rest));
  return CommonSquares{std::move(*form), missing_axes(axes)};
}

// The columns of the inverse, by elimination; not finite where there is none.
Matrix4 dual_basis(Matrix4 rows) {
  Matrix4 inverse = identity_matrix;
  for (std::size_t column = 0; column < 4; ++column) {
    std::size_t pivot = column;
    for (std::size_t i = column + 1; i < 4; ++i) {
      if (magnitude(rows[i][column]) > magnitude(rows[pivot][column])) pivot = i;
    }
    std::swap(rows[pivot], rows[column]);
    std::swap(inverse[pivot], inverse[column]);
    for (std::size_t i = 0; i < 4; ++i) {
      if (i == column) continue;
      const Real factor = rows[i][column] / rows[column][column];
      for (std::size_t j = 0; j < 4; ++j) {
        rows[i][j] -= factor * rows[column][j];
        inverse[i][j] -= factor * inverse[column][j];
      }
    }
  }
  Matrix4 columns{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) columns[j][i] = inverse[i][j] / rows[i][i];
  }
  return columns;
}

// The world's constant 1 in the box's frame: size * form.
struct WorldOne {
  IntegerLinear form;
  Real size = 1;
};

// Is it 1 on the page too?
bool is_affine(const Matrix4& inverse) { return inverse[0][3] == 0 && inverse[1][3] == 0 && inverse[2][3] == 0; }

WorldOne world_one(const Matrix4& inverse, const LocalBox& box) {
  if (is_affine(inverse)) return {{0, 0, 0, 1}, 1};
  return {{0, 0, 1, round_to_integer(box.centre[2])}, inverse[2][3]};
}

// The same in the box's frame, homogeneous: every form is linear in (x, y, z, 1), also in perspective.
struct PageForms {
  std::vector<SquareTerm> squares;
  std::optional<Vector4> rest;
  Real constant = 0;
  WorldOne one;
  Real eye = 0, zero = 0;  // the value that the eye has, the coefficient of z^2, and what counts as 0 beside it
  Matrix4 dual{};          // points: in the i-th, form i of (squares, rest, free ones, one) is 1 and the others are 0
};

PageForms page_forms(const CommonSquares& common, const RealHalfSpace& here, const Matrix4& to_forms,
                     const WorldOne& one) {
  PageForms page;
  page.one = one;
  page.eye = here.c[2];
  page.zero = zero_beside(here);
  Matrix4 basis{};
  std::size_t count = 0;
  const auto on_page = [&](const Vector4& form) {
    Vector4& moved = basis[count++];
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t k = 0; k < 4; ++k) moved[i] += to_forms[i][k] * form[k];
    }
    return moved;
  };
  for (const SquareTerm& term : common.form.squares) page.squares.push_back({term.weight, on_page(term.form)});
  if (common.form.rest)
    page.rest = on_page({(*common.form.rest)[0], (*common.form.rest)[1], (*common.form.rest)[2], 0});
  for (const Vector3& axis : common.free) on_page({axis[0], axis[1], axis[2], 0});
  page.constant = common.form.constant;
  basis[3] = to_real(page.one.form);
  page.dual = dual_basis(basis);
  return page;
}

// What `value` times the common forms of a family become.
struct CommonIntegers {
  Real value = 1;
  IntegerForm form{HalfSpaceKind::quadric, {}};
  Vector3 moved{};  // by the squares' residuals, in dots
  Vector4 rest_residual{};
};

// A form that is off by `residual` at most moves every point towards the point where it alone is not 0.
void add_move(Vector3& moved, const Vector4& towards, Real residual, const LocalBox& box) {
  for (std::size_t i = 0; i < 3; ++i) {
    moved[i] += residual * (magnitude(towards[i]) + box.half[i] * magnitude(towards[3]));
  }
}

CommonIntegers round_common(const PageForms& page, Real value, const LocalBox& box) {
  CommonIntegers common;
  common.value = value;
  for (std::size_t i = 0; i < page.squares.size(); ++i) {
    const auto& [weight, form] = page.squares[i];
    const Real scale = square_root(value * magnitude(weight));
    const RoundedLinear r = rounded(form, scale);
    add_square(common.form, weight < 0 ? -1 : 1, r.integers);
    add_move(common.moved, page.dual[i], reach(r.residual, box) / scale, box);
  }
  if (page.rest) {
    const RoundedLinear r = rounded(*page.rest, value * page.one.size);
    add_twice_product(common.form, page.one.form, r.integers);
    common.rest_residual = r.residual;
  }
  return common;
}

struct Member {
  mpz_class multiple;  // of the unit's square
  Quantised quantised;
};

// A multiple that is off moves the rest's form, or else draws all points to the centre or away from it.
std::optional<Member> round_member(const PageForms& page, const CommonIntegers& common, const Kinship& kin,
                                   const LocalBox& box) {
  const bool is_zero = kin.rank == page.squares.size();
  const Real unit_value = common.value * page.one.size * page.one.size;
  const Real exact = is_zero ? 0 : unit_value * (page.constant + kin.constant);
  // An eye on the surface stays on it: no z^2 is left.
  const bool meets_eye = !is_zero && page.one.form[2] == 1 &&
                         magnitude(page.eye + page.one.size * page.one.size * kin.constant) <= page.zero;
  Member member{meets_eye ? mpz_class(-common.form.c[2]) : round_to_integer(exact), {common.form, 0}};
  const Real multiple = to_real(member.multiple);
  const Vector4 unit = to_real(page.one.form);
  Vector3 moved = common.moved;
  if (page.rest) {
    Vector4 residual = common.rest_residual;
    for (std::size_t i = 0; i < 4; ++i) residual[i] += (multiple - exact) / 2 * unit[i];
    const Real scale = magnitude(common.value * page.one.size);
    add_move(moved, page.dual[page.squares.size()], reach(residual, box) / scale, box);
  } else if (!is_zero) {
    if (!(multiple / exact > 0)) return std::nullopt;
    const Real stretch = square_root(multiple / exact) - 1;
    add_move(moved, page.dual[3], magnitude(stretch) * reach(unit, box), box);
  }
  member.quantised.bound = length(moved) + dropped_part(box);
  if (!(member.quantised.bound <= box.target)) return std::nullopt;
  add_square(member.quantised.form, member.multiple, page.one.form);
  return member;
}

// None where one moves too far, or two fall together.
std::optional<std::vector<Quantised>> round_all(std::span<const FamilyMember> members, const PageForms& page,
                                                Real value, const LocalBox& box) {
  const CommonIntegers common = round_common(page, value, box);
  std::map<mpz_class, Real> constants;
  std::vector<Quantised> all;
  for (const FamilyMember& member : members) {
    const auto rounded_one = round_member(page, common, member.kin, box);
    if (!rounded_one) return std::nullopt;
    const auto known = constants.emplace(rounded_one->multiple, member.kin.constant);
    if (known.first->second != member.kin.constant) return std::nullopt;
    all.push_back(rounded_one->quantised);
  }
  return all;
}

// The square of the least of the forms M_i for the value 1, by its directions: parallel quadrics have the same.
Real least_square(const PageForms& page) {
  const auto size = [](const Vector4& form) { return largest({form[0], form[1], form[2]}); };
  if (page.squares.empty()) return magnitude(page.one.size) * size(*page.rest);
  std::optional<Real> least;
  for (const auto& [weight, form] : page.squares) {
    const Real square = magnitude(weight) * size(form) * size(form);
    least = least ? smaller(*least, square) : square;
  }
  return *least;
}

// F of kinship.hpp.
RealHalfSpace common_part(const FamilyMember& member) {
  RealHalfSpace common{HalfSpaceKind::quadric, {}};
  for (std::size_t i = 0; i < 9; ++i) common.c[i] = member.shape.c[i] / member.kin.ratio;
  return common;
}

// Small proportions of all of them at once: the common form and each member's multiple.
std::optional<std::vector<Quantised>> take_exactly(std::span<const FamilyMember> members, const RealHalfSpace& common,
                                                   const WorldOne& one, const LocalBox& box) {
  std::vector<Real> values(common.c.begin(), common.c.end());
  for (const FamilyMember& member : members) values.push_back(one.size * one.size * member.kin.constant);
  const auto integers = small_proportions(values, small_quadric_bits);
  if (!integers || dropped_part(box) > box.target) return std::nullopt;
  std::vector<Quantised> all(members.size(), {{HalfSpaceKind::quadric, {}}, dropped_part(box)});
  for (std::size_t i = 0; i < members.size(); ++i) {
    std::copy(integers->begin(), integers->begin() + 10, all[i].form.c.begin());
    add_square(all[i].form, (*integers)[10 + i], one.form);
  }
  return all;
}

std::optional<std::vector<Quantised>> round_forms(std::span<const FamilyMember> members, const PageForms& page,
                                                  const LocalBox& box, int least_bits) {
  const Real least = least_square(page);
  return with_least_bits(least_bits, scale_limit, [&](int bits) {
    auto all = round_all(members, page, power_of_two(2 * bits) / least, box);
    if (all) {
      for (Quantised& one : *all) one.bits = bits;
    }
    return all;
  });
}

// In the box's frame.
std::optional<std::vector<Quantised>> quantise_locally(std::span<const FamilyMember> members, const Matrix4& inverse,
                                                       const LocalBox& box, int least_bits) {
  const RealHalfSpace own = common_part(members.front());
  const RealHalfSpace here = transformed(own, inverse);
  if (!finite(inverse) || !finite(here)) return std::nullopt;
  const WorldOne one = world_one(inverse, box);
  if (auto all = take_exactly(members, here, one, box)) return all;
  // Where the world's 1 is 1 on the page, the page's frame serves as well as the group's own, and there the squares are
  // orthonormal: a sphere is one.
  const bool affine = is_affine(inverse);
  const auto common = common_squares(affine ? here : own, members.front().kin, affine);
  if (!common) return std::nullopt;
  return round_forms(members, page_forms(*common, here, affine ? identity_matrix : inverse, one), box, least_bits);
}

}  // namespace

std::optional<Quantised> quantise_squares(const RealHalfSpace& here, const Kinship& kin, const LocalBox& box,
                                          int least_bits) {
  const auto common = common_squares(here, kin, true);
  if (!common) return std::nullopt;
  const FamilyMember alone{here, kin};
  auto rounded =
      round_forms({&alone, 1}, page_forms(*common, here, identity_matrix, {{0, 0, 0, 1}, 1}), box, least_bits);
  if (!rounded) return std::nullopt;
  return rounded->front();
}

std::optional<std::vector<Quantised>> quantise_family(std::span<const FamilyMember> members, const Matrix4& inverse,
                                                      const Region& region, int least_bits) {
  const LocalBox local = local_box(region);
  const auto here = inverse_from(local, inverse);
  if (!here) return std::nullopt;
  auto all = quantise_locally(members, *here, local, least_bits);
  if (!all) return std::nullopt;
  const IntegerPoint origin = round_to_integers(local.centre);
  for (std::size_t i = 0; i < members.size(); ++i) {
    IntegerForm& form = (*all)[i].form;
    make_primitive(form);
    if (members[i].kin.ratio < 0) negate(form);
    form.origin = origin;
  }
  return all;
}

}  // namespace halfspace
