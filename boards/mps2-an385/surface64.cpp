#include "boards/mps2-an385/surface64.hpp"

#include "boards/mps2-an385/baselines.hpp"
#include "boards/mps2-an385/root32.hpp"
#include "firmware/core/isqrt.hpp"

namespace halfspace::mps2 {
namespace {

Page page_;

Reach reach_of(const ActiveFace& face) {
  return {std::max(face.origin_x, page_.width - face.origin_x), std::max(face.origin_y, page_.height - face.origin_y)};
}

// L, below 2^29, and |N|^2 when s is off by `root`; the rest is the rounding of l, m, r, q and the level's t (level_search.hpp).
Margin margin(const Surface64& s, std::int64_t root) {
  const std::int64_t m = s.m < 0 ? -std::int64_t{s.m} : s.m;
  const std::int64_t light = (m * root >> 32) + 4;
  const std::int64_t square = ((root + 2) << 28) + (std::int64_t{1} << 30) + form_error(s.reach);
  return {light, (light << 30) + light * light + square + (std::int64_t{1} << 31)};
}

}  // namespace

void set_page(const Page& page) { page_ = page; }

// As in root_shade.cpp, but with one scale for the whole face: L^2 and |N|^2 must stay comparable (`balance`).
Surface64 Surface64::of(const ShadeJob& job) {
  const RootSurface& f = job.face.surface;
  Surface64 s;
  s.reach = reach_of(job.face);
  const int root_shift = (form_bits(f.discriminant, s.reach) - 60 + 1) >> 1;
  const int balance = f.square.exponent - 2 * f.light.exponent + 2 * job.table.light_bits;
  const int root_bits = 30 + root_shift;
  const int r_shift = root_shift - f.square_root_fraction();
  const int light_terms = std::max(form_bits(f.light, s.reach), f.light_root.bit_length() + root_bits);
  int square_shift = std::max(form_bits(f.square, s.reach) - 60, form_bits(f.square_root, s.reach) + r_shift + 30 - 58);
  square_shift = std::max(square_shift, 2 * (light_terms - 29) - balance);
  square_shift += (square_shift + balance) & 1;
  const int light_shift = (square_shift + balance) / 2;

  s.d = Quadratic64::of(f.discriminant, 2 * root_shift);
  s.q = Quadratic64::of(f.square, square_shift);
  s.r = Linear32::of(f.square_root, square_shift - r_shift);
  s.l = Linear32::of(f.light, light_shift);
  s.m = static_cast<std::int32_t>(scaled(f.light_root, light_shift - root_shift - 32));
  const std::int64_t error = form_error(s.reach);
  s.deep_from = static_cast<std::int32_t>(error);
  s.deep = margin(s, root32_error + 1);
  s.shallow = margin(s, root32_error + isqrt(static_cast<std::uint64_t>(error)) + 1);
  return s;
}

}  // namespace halfspace::mps2
