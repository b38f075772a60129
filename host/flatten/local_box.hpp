// local_box.hpp - where a surface is rounded for, and how well; its box about an integer origin, and the error of linear
// forms there.
// Target   2^-14 dot for bodies up to 1024 dots across on the page, growing with the square of the size: 2^-10 at 4096
//          dots, 1/16 at 32767.
#pragma once

#include <optional>

#include "host/flatten/extent.hpp"
#include "host/flatten/integer_form.hpp"

namespace halfspace {

struct Region {
  Box box;          // dot frame
  Real target = 0;  // dots: what a surface may move by in it
};

// Of a body with this box, on a page whose larger side is `page` dots: no more of it can show, wherever it lies.
[[nodiscard]] Region region_of(const Box& box, Real page);

// The box of both, and what the body that asks for more asks for.
[[nodiscard]] Region around(const Region& a, const Region& b);

// Every coordinate of the box is within `half` of its centre, which is the origin of its frame.
struct LocalBox {
  Vector3 centre{};  // whole, in the dot frame
  Vector3 half{};
  Real radius = 0;  // of the largest coordinate
  Real target = 0;
};

[[nodiscard]] LocalBox local_box(const Region& region);

// The dot frame's `inverse`, from the box's own frame. None where the box lies so far away for its size (2^36 times)
// that 113 bits say nothing about it.
[[nodiscard]] std::optional<Matrix4> inverse_from(const LocalBox& box, const Matrix4& inverse);

// The largest value of a linear form in the box.
[[nodiscard]] Real reach(const Vector4& form, const LocalBox& box);

struct RoundedLinear {
  IntegerLinear integers;
  Vector4 residual{};  // integers - what they stand for
};

[[nodiscard]] Vector4 residual_of(const Vector4& form, Real scale);
[[nodiscard]] RoundedLinear rounded(const Vector4& form, Real scale);

// A part that counts as 0 although it was there (spectrum.hpp, zero_bits), and a proportion that was taken for exact
// (rational.hpp), move a surface by no more than this, even at a double root.
[[nodiscard]] Real dropped_part(const LocalBox& box);

}  // namespace halfspace
