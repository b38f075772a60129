// A boundary's path over a strip of scan lines, against the boundary's place on each of them by bisection.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "firmware/core/boundary_tracks.hpp"

namespace halfspace {
namespace {

constexpr double unit = 0x1p29;  // of s and |N|, whose largest it is about
constexpr double radius = 400;   // dots

using Vector = std::array<double, 3>;

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// An ellipsoid whose outline is an ellipse about the block's middle: s^2 = D and N = (a t + b v + c s, ...), both of any direction.
struct Solid {
  SectionForms forms;
  double dxx, dxy, dyy;
  Vector across, down, out, light;

  explicit Solid(std::mt19937& random) {
    std::uniform_real_distribution<double> any(-1, 1);
    const double slant = 0.5 * any(random);
    dxx = -1 / (radius * radius);
    dyy = -(0.4 + 0.5 * std::abs(any(random))) / (radius * radius);
    dxy = slant * std::sqrt(dxx * dyy);
    const double part = 0.2 / radius;
    for (int i = 0; i < 3; ++i) {
      across[i] = part * any(random);
      down[i] = part * any(random);
      out[i] = 0.2 * any(random);
      light[i] = any(random);
    }
    out[2] += 0.5;
    light[2] += 1.2;
    const double length = std::sqrt(dot(light, light));
    for (double& l : light) l /= length;
    forms.half = 420;
    forms.half_bits = 9;
    forms.line = 0;
    forms.y0 = -16;
    forms.y1 = 16;
    const auto whole = [](double v, double scale) { return static_cast<std::int64_t>(std::floor(v * scale)); };
    constexpr double square = unit * unit;
    forms.d = {whole(0.9, square), 0, 0, whole(0.9 * dxx, square), whole(0.9 * dxy, square), whole(0.9 * dyy, square)};
    // |N|^2 = u.u + out.out D + 2 u.out s, with u = across t + down v
    const double outer = dot(out, out) * 0.9;
    forms.q = {whole(outer, square),
               0,
               0,
               whole(dot(across, across) + outer * dxx, square),
               whole(2 * dot(across, down) + outer * dxy, square),
               whole(dot(down, down) + outer * dyy, square)};
    forms.r = {0, whole(2 * dot(across, out) * unit, 0x1p32), whole(2 * dot(down, out) * unit, 0x1p32)};
    forms.l = {0, whole(dot(across, light) * unit, 0x1p28), whole(dot(down, light) * unit, 0x1p28)};
    forms.m = static_cast<std::int32_t>(whole(dot(out, light), 0x1p30));
    forms.m_size = 1;
  }

  // I - T at dot t of line v.
  [[nodiscard]] double lead(double t, double v, double bar) const {
    const double d = 0.9 * (1 + dxx * t * t + dxy * t * v + dyy * v * v);
    if (d <= 0) return std::nan("");
    Vector n;
    for (std::size_t i = 0; i < 3; ++i) n[i] = across[i] * t + down[i] * v + out[i] * std::sqrt(d);
    return dot(n, light) / std::sqrt(dot(n, n)) - bar;
  }
};

// Errors promised are kept on every line, whatever the guess; and most boundaries away from a limb have a path.
TEST(TrackFit, PathsAreWithinTheirErrors) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0.1, 0.95);
  std::uniform_int_distribution<int> off(-40000, 40000);
  int sought = 0;
  int found = 0;
  std::int64_t sum = 0;
  for (int scene = 0; scene < 2000; ++scene) {
    const Solid solid(random);
    TrackStrip strip;
    strip.cover(solid.forms, scene % 2 == 0 ? -16 : 0);
    const double bar = share(random);
    const double middle = strip.middle;
    for (int t = -300; t < 300; t += 1) {
      const double left = solid.lead(t, middle, bar);
      const double right = solid.lead(t + 1, middle, bar);
      if (!(left * right < 0)) continue;
      ++sought;
      const int sign = left < 0 ? 1 : -1;
      TrackCurve guess{t * 65536 + off(random), 0, 0};
      FittedTrack track{};
      for (int i = 0; i < 5; ++i) {
        track = fit_track(solid.forms, strip, static_cast<std::uint32_t>(bar * 0x1p31), 8, sign, guess);
        if (track.state != FittedTrack::State::guess) break;
        guess = track.curve;
      }
      if (track.state != FittedTrack::State::sure) continue;
      ++found;
      sum += track.error;
      const double error = track.error / 65536.0;
      for (std::int32_t y = strip.first; y < strip.end; ++y) {
        const double w = static_cast<double>(y - strip.middle) / strip.half;
        const double x = (track.curve.x + w * (track.curve.slope + w * track.curve.bend)) / 65536;
        EXPECT_LT(sign * solid.lead(x - error, y, bar), 0) << "scene " << scene << " line " << y << " error " << error;
        EXPECT_GT(sign * solid.lead(x + error, y, bar), 0) << "scene " << scene << " line " << y << " error " << error;
      }
    }
  }
  EXPECT_GT(sought, 400);
  EXPECT_GT(found, sought * 2 / 3) << sought;
  EXPECT_LT(sum / found, 65536 / 8);  // an eighth of a dot
}

// Kept in words and followed over two strips, at every level that rises or falls on the first line.
TEST(TrackFit, KeptPathsAreWithinTheirErrors) {
  constexpr std::int32_t levels = 32;
  std::mt19937 random(11);
  int followed = 0;
  double sum = 0;
  for (int scene = 0; scene < 300; ++scene) {
    const Solid solid(random);
    GeneralContours face;
    face.forms = solid.forms;
    face.bars = {31U << 26, 1U << 26, 31, 8};
    std::array<std::uint32_t, 2 * levels> block{};
    for (std::int32_t y = -16; y < 16; ++y) {
      BoundaryTracks tracks(face, block, y);
      for (std::int32_t k = 1; k < levels; ++k) {
        const double bar = k / 32.0;
        for (const bool rising : {true, false}) {
          const auto lead = [&](double t) { return (rising ? 1 : -1) * solid.lead(t, y, bar); };
          if (y == -16) {
            for (int t = -300; t < 300; ++t) {
              if (lead(t) < 0 && lead(t + 1) > 0) tracks.begin(k, rising, t * 65536 + 32768);
            }
          }
          const std::uint32_t path = *tracks.slot_of(k, rising);
          if (!BoundaryTracks::is_path(path)) continue;
          const double x = tracks.line().x_of(path) / 65536.0;
          const double error = BoundaryTracks::error_of(path) / 65536.0;
          EXPECT_LT(lead(x - error), 0) << "scene " << scene << " line " << y << " level " << k;
          EXPECT_GT(lead(x + error), 0) << "scene " << scene << " line " << y << " level " << k;
          ++followed;
          sum += error;
        }
      }
    }
  }
  EXPECT_GT(followed, 20000);
  EXPECT_LT(sum / followed, 1 / 8.0);  // dots
}

}  // namespace
}  // namespace halfspace
