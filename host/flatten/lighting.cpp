#include "host/flatten/lighting.hpp"

#include <span>
#include <vector>

#include "host/flatten/rational.hpp"

namespace halfspace {
namespace {

constexpr int entry_bits = 15;  // of the matrix and of the light
constexpr long decimal_unit = 10000;
constexpr long binary_unit = 1L << 16;

std::int64_t to_int(Real v) { return round_to_integer(v).get_si(); }

// Small integers in the same proportions, or the nearest with the largest entry at 2^15.
std::vector<std::int64_t> scale_to_entries(std::span<const Real> values) {
  std::vector<std::int64_t> result;
  if (const auto exact = small_proportions(values, entry_bits)) {
    for (const mpz_class& v : *exact) result.push_back(v.get_si());
    return result;
  }
  Real most = 0;
  for (const Real v : values) most = larger(most, magnitude(v));
  for (const Real v : values) result.push_back(to_int(v / most * power_of_two(entry_bits)));
  return result;
}

// A perspective view is narrow where its eye is more than 2^24 dots off. There w z stays what it is at vrp to within
// 2^-10, and the last column, which would not fit, turns into the third.
bool is_narrow(const View& view, const std::array<Vector4, 3>& rows) {
  return view.perspective && larger(rows[0][0], rows[1][1]) > power_of_two(24);
}

std::array<Vector4, 3> narrow_rows(const View& view, const PageMap& page) {
  std::array<Vector4, 3> rows = directions_to_view(view);
  const Real depth = rows[0][0];
  rows[2] = {rows[2][0], rows[2][1], depth, 0};
  for (Vector4& row : rows) row = {row[0] * page.scale_x, row[1] * page.scale_y, row[2] * page.scale_y, 0};
  return rows;
}

// The last column of a perspective view is (0, 0, 1), so its factor is an integer, and even where there is room: that
// keeps the page's middle exact. Entries have 15 bits, or 24 where the eye is so near to the view plane for the page's size that its
// distance, the first entry and the sixth, would have fewer than 9: then half a unit turns normals by less than half a level.
// None where that does not do either.
constexpr int least_distance_bits = 9;
constexpr int wide_entry_bits = 24;

std::optional<std::vector<std::int64_t>> perspective_entries(const std::vector<Real>& entries) {
  Real most = 1;
  for (const Real v : entries) most = larger(most, magnitude(v));
  const auto factor_for = [most](int bits) { return larger(1, 2 * floor_of(power_of_two(bits - 1) / most)); };
  const auto has_distance = [&entries](Real factor) {
    return smaller(entries[0], entries[5]) * factor >= power_of_two(least_distance_bits);
  };
  Real factor = factor_for(entry_bits);
  if (!has_distance(factor)) factor = factor_for(wide_entry_bits);
  if (!has_distance(factor)) return std::nullopt;
  std::vector<std::int64_t> result;
  result.reserve(entries.size());
  for (const Real v : entries) result.push_back(to_int(v * factor));
  return result;
}

// False: the eye is too near to the view plane.
bool set_normal_matrix(const View& view, const PageMap& page, IntegerLighting& lighting) {
  std::array<Vector4, 3> rows = normal_rows(view, page);
  const bool narrow = is_narrow(view, rows);
  if (narrow) rows = narrow_rows(view, page);
  std::vector<Real> entries;
  for (const Vector4& row : rows) entries.insert(entries.end(), row.begin(), row.end());
  const auto integers =
      view.perspective && !narrow ? perspective_entries(entries) : std::optional(scale_to_entries(entries));
  if (!integers) return false;
  for (std::size_t i = 0; i < 12; ++i) lighting.normal_matrix[i / 4][i % 4] = (*integers)[i];
  return true;
}

// The parser has warned of intensities outside [0, 1].
mpq_class clamped_intensity(const LightStatement& light) {
  const mpq_class intensity = decimal_to_rational(light.intensity.text);
  if (intensity < 0) return 0;
  return intensity > 1 ? mpq_class(1) : intensity;
}

bool has_four_decimals(const mpq_class& v) { return mpq_class(v * decimal_unit).get_den() == 1; }

std::int64_t nearest_multiple(const mpq_class& v, long unit) {
  const mpq_class scaled = v * unit + mpq_class(1, 2);
  return mpz_class(scaled.get_num() / scaled.get_den()).get_si();
}

void set_intensities(const mpq_class& ambient, const mpq_class& parallel, IntegerLighting& lighting) {
  const bool is_decimal = has_four_decimals(ambient) && has_four_decimals(parallel);
  const long unit = is_decimal ? decimal_unit : binary_unit;
  const std::int64_t a = nearest_multiple(ambient, unit);
  const std::int64_t p = nearest_multiple(parallel, unit);
  const mpz_class common = gcd(gcd(mpz_class(a), mpz_class(p)), mpz_class(unit));
  const long divisor = common.get_si();
  lighting.ambient = a / divisor;
  lighting.parallel = p / divisor;
  lighting.unit = unit / divisor;
}

}  // namespace

std::array<Vector4, 3> normal_rows(const View& view, const PageMap& page) {
  const Real half = Real(1) / 2;
  std::array<Vector4, 3> rows = directions_to_view(view);
  for (Vector4& row : rows) {
    row = {row[0] * page.scale_x + row[3] * (page.offset_x - half),
           row[1] * page.scale_y + row[3] * (page.offset_y - half), row[2] * page.scale_y, row[3]};
  }
  return rows;
}

std::optional<IntegerLighting> light_scene(const Scene& scene, const View& view, const PageMap& page,
                                           Diagnostics& diagnostics) {
  mpq_class ambient = 0;
  mpq_class parallel = 1;  // the automatic light: 1 0 0 -1
  Vector3 direction{0, 0, -1};
  for (const LightStatement& light : scene.lights) {
    const mpq_class intensity = clamped_intensity(light);
    if (!light.direction) {
      ambient += intensity;
      continue;
    }
    parallel = intensity;
    for (std::size_t i = 0; i < 3; ++i) direction[i] = decimal_to_real((*light.direction)[i].text);
    if (largest(direction) == 0) {
      diagnostics.push_back({Severity::error, light.position,
                             "light '" + light.id + "' points nowhere; give a direction other than 0 0 0"});
      return std::nullopt;
    }
  }
  if (ambient > 1) {
    diagnostics.push_back(
        {Severity::warning, scene.lights.back().position, "the ambient lights add up to more than 1; 1 is used"});
    ambient = 1;
  }
  IntegerLighting lighting;
  set_intensities(ambient, parallel, lighting);
  const Vector3 towards = unit(direction);
  const Vector3 light{dot(towards, view.right), dot(towards, view.down), dot(towards, view.into)};
  const auto entries = scale_to_entries(light);
  for (std::size_t i = 0; i < 3; ++i) lighting.light[i] = entries[i];
  if (!set_normal_matrix(view, page, lighting)) {
    diagnostics.push_back(
        {Severity::limit, view.position,
         "the eye is too near to the view plane for so wide a window; move cop away from vrp, or make the "
         "window or what it is fitted to smaller"});
    return std::nullopt;
  }
  return lighting;
}

}  // namespace halfspace
