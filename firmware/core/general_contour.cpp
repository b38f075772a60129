#include "firmware/core/contour.hpp"
namespace halfspace {
bool straight_contour(const ShadeJob&, std::int32_t, std::int32_t, std::int32_t) { return false; }
bool general_contour(const ShadeJob&, std::int32_t, std::int32_t, std::int32_t) { return false; }
}  // namespace halfspace
