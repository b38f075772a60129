// turning_points.hpp - where the section of a body by the plane u = c can change its structure as c grows.
// Method   A surface turns, two surfaces touch, the curve in which two meet turns or runs to infinity, three meet in a point. Each is a
//          zero of a polynomial in u, from resultants and discriminants in w and then in v; zeros too many do no harm. Curves that lie
//          before themselves or each other along w come together on a surface's limb, which is then asked as well.
// Source   Collins 1975, whose projection this is, with only the pairs and triples that are asked for.
// Cost     FLINT's: a fraction of a millisecond for a pair, more for a triple.
#pragma once

#include <map>
#include <memory>
#include <span>
#include <vector>

#include "host/algebra/polynomial.hpp"
#include "host/flatten/slice.hpp"

namespace halfspace {

class TurningPoints {
 public:
  // The forms must outlive this.
  explicit TurningPoints(std::span<const SliceForm> forms);
  ~TurningPoints();

  // One, two or three forms, by their numbers in ascending order.
  [[nodiscard]] const std::vector<Polynomial>& of(const std::vector<std::uint32_t>& meeting);

 private:
  class SpacePolynomial;
  const SpacePolynomial& form(std::uint32_t i);
  const SpacePolynomial& shadow(std::uint32_t i, std::uint32_t j);

  std::span<const SliceForm> forms_;
  std::map<std::uint32_t, SpacePolynomial> read_;
  std::map<std::vector<std::uint32_t>, SpacePolynomial> shadows_;
  std::map<std::vector<std::uint32_t>, std::vector<Polynomial>> known_;
};

}  // namespace halfspace
