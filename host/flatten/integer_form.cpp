#include "host/flatten/integer_form.hpp"

#include "host/algebra/content.hpp"

namespace halfspace {

void copy_seen_from(const IntegerForm& form, const IntegerPoint& origin, std::array<mpz_class, 10>& c) {
  for (std::size_t i = 0; i < 10; ++i) {
    if (sgn(c[i]) != 0 || sgn(form.c[i]) != 0) c[i] = form.c[i];
  }
  if (origin == form.origin) return;
  const IntegerPoint shift{origin[0] - form.origin[0], origin[1] - form.origin[1], origin[2] - form.origin[2]};
  const auto add = [](mpz_class& sum, const mpz_class& a, const mpz_class& b) {
    mpz_addmul(sum.get_mpz_t(), a.get_mpz_t(), b.get_mpz_t());
  };
  if (form.kind == HalfSpaceKind::plane) {
    for (std::size_t i = 0; i < 3; ++i) add(c[3], form.c[i], shift[i]);
    return;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) add(c[6 + i], form.c[quadric_index[i][j]], shift[j]);
  }
  // value(shift) = sum over i of (linear_i(0) + linear_i(shift)) shift_i + K
  for (std::size_t i = 0; i < 3; ++i) {
    add(c[9], form.c[6 + i], shift[i]);
    add(c[9], c[6 + i], shift[i]);
  }
}

IntegerForm seen_from(const IntegerForm& form, const IntegerPoint& origin) {
  IntegerForm result{form.kind, {}, origin};
  copy_seen_from(form, origin, result.c);
  return result;
}

void make_primitive(IntegerForm& form) { divide_by_content(form.c); }

void negate(IntegerForm& form) {
  for (mpz_class& v : form.c) mpz_neg(v.get_mpz_t(), v.get_mpz_t());
}

void add_square(IntegerForm& quadric, const mpz_class& factor, const IntegerLinear& linear) {
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i; j < 4; ++j) quadric.c[quadric_index[i][j]] += factor * linear[i] * linear[j];
  }
}

void add_twice_product(IntegerForm& quadric, const IntegerLinear& a, const IntegerLinear& b) {
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i; j < 4; ++j) quadric.c[quadric_index[i][j]] += a[i] * b[j] + a[j] * b[i];
  }
}

RealHalfSpace to_real(HalfSpaceKind kind, const std::array<mpz_class, 10>& c) {
  RealHalfSpace result{kind, {}};
  for (std::size_t i = 0; i < coefficient_count(kind); ++i) result.c[i] = to_real(c[i]);
  return result;
}

RealHalfSpace to_real(const IntegerForm& form) { return to_real(form.kind, form.c); }

Vector4 to_real(const IntegerLinear& form) {
  return {to_real(form[0]), to_real(form[1]), to_real(form[2]), to_real(form[3])};
}

IntegerPoint round_to_integers(const Vector3& v) {
  return {round_to_integer(v[0]), round_to_integer(v[1]), round_to_integer(v[2])};
}

}  // namespace halfspace
