// local_box.hpp - the box that a surface is rounded in, about an integer origin, and the error of linear forms there.
#pragma once

#include <optional>

#include "host/flatten/extent.hpp"
#include "host/flatten/integer_form.hpp"

namespace halfspace {

// Every coordinate of the box is within `half` of 0.
struct LocalBox {
  IntegerPoint origin;  // in the dot frame
  Vector3 half{};
  Real radius = 0;  // of the largest coordinate
  Real target = 0;  // dots: what a surface may move by (quantise.hpp)
};

[[nodiscard]] LocalBox local_box(const Box& box);

// The dot frame's `inverse`, from the box's own frame. None where the box lies so far away for its size (2^36 times)
// that 113 bits say nothing about it.
[[nodiscard]] std::optional<Matrix4> inverse_from(const LocalBox& box, const Matrix4& inverse);

// The largest value of a linear form in the box.
[[nodiscard]] Real reach(const Vector4& form, const LocalBox& box);

struct RoundedLinear {
  IntegerLinear integers;
  Vector4 residual{};  // integers - what they stand for
};

[[nodiscard]] RoundedLinear rounded(const Vector4& form, Real scale);

// A part that counts as 0 although it was there (spectrum.hpp, zero_bits), and a proportion that was taken for exact
// (rational.hpp), move a surface by no more than this, even at a double root.
[[nodiscard]] Real dropped_part(const LocalBox& box);

}  // namespace halfspace
