#include "firmware/core/boundary_tracks.hpp"

#include <algorithm>

namespace halfspace {
namespace {

constexpr int most_tries = 4;  // of a fit
// A block's middle, on the page: paths keep within 4096 dots of it on the lines up to the next strip's, and 2^-16 dot fit a word.
constexpr std::int32_t farthest = (1 << 15) - 4096;

std::int32_t size(std::int32_t v) { return v < 0 ? -v : v; }
std::int32_t rounded(std::int32_t v, std::int32_t unit) { return (v < 0 ? v - unit / 2 : v + unit / 2) / unit; }

}  // namespace

BoundaryTracks::BoundaryTracks(GeneralContours& face, std::span<std::uint32_t> block, std::int32_t y)
    : face_(face),
      words_(block.data()),
      levels_(face.forms.middle < farthest ? static_cast<std::int32_t>(block.size() / 2) : 0) {
  if (levels_ == 0) return;
  if (!face.strip.holds(y)) start_strip(y);
  v_ = y - face.strip.middle;
  lines_left_ = face.strip.end - y;
  line_ = PathLine(face.strip.unit, face.strip.from * (1 << 16), v_);
}

// Paths of the last strip are renewed where they enter the block, unless it is far; what failed rests.
void BoundaryTracks::start_strip(std::int32_t y) {
  TrackStrip& strip = face_.strip;
  const TrackUnits unit = strip.unit;
  const std::int32_t from = strip.from;
  const std::int32_t before = strip.middle;
  const std::int32_t half_before = strip.half;
  strip.cover(face_.forms, y);
  const std::int32_t way = strip.middle - before;
  const std::int32_t aside = from - strip.from;
  if (half_before == 0 || way > 2 * (half_before + strip.half) || size(aside) > longest_half) {
    std::fill_n(words_, 2 * levels_, empty);
    return;
  }
  const PathLine ahead(unit, aside * (1 << 16), way);
  for (std::int32_t i = 0; i < 2 * levels_; ++i) {
    const std::uint32_t word = words_[i];
    if (word == empty) continue;
    if (is_path(word)) {
      const std::int32_t ddx = unit.ddx * PathLine::ddx_part(word);
      const std::int32_t dx = unit.dx * PathLine::dx_part(word) + 2 * way * ddx;
      const bool rising = i < levels_;
      renew(words_ + i, rising ? i : i - levels_, rising,
            {ahead.x_of(word), strip.half * dx, strip.half * strip.half * ddx});
    } else {
      words_[i] = word - 1;
    }
  }
}

void BoundaryTracks::renew(Slot slot, std::int32_t k, bool rising, const TrackCurve& ahead) {
  if (size(ahead.x - ahead.slope + ahead.bend) > face_.forms.half * (1 << 16)) {
    *slot = empty;
    return;
  }
  TrackCurve& turn = face_.strip.last[rising ? 1 : 0].turn;
  TrackCurve curve{ahead.x + turn.x, ahead.slope + turn.slope, ahead.bend + turn.bend};
  if (!fit(slot, k, rising, curve)) return;
  turn = {curve.x - ahead.x, curve.slope - ahead.slope, curve.bend - ahead.bend};
}

void BoundaryTracks::seek(Slot slot, std::int32_t k, bool rising, std::int32_t at) {
  const TrackStrip& strip = face_.strip;
  const TrackStrip::Shape& last = strip.last[rising ? 1 : 0];
  TrackCurve curve{at - v_ * (last.dx + v_ * last.ddx), strip.half * last.dx, strip.half * strip.half * last.ddx};
  (void)fit(slot, k, rising, curve);
}

bool BoundaryTracks::fit(Slot slot, std::int32_t k, bool rising, TrackCurve& curve) {
  for (int i = 0; i < most_tries; ++i) {
    const FittedTrack fitted =
        fit_track(face_.forms, face_.strip, face_.bars.at(k), face_.bars.error, rising ? 1 : -1, curve);
    if (fitted.state == FittedTrack::State::failed) break;
    curve = fitted.curve;
    if (fitted.state == FittedTrack::State::sure) {
      if (keep(slot, rising, curve, fitted.error)) return true;
      break;
    }
  }
  *slot = empty + rests;
  return false;
}

bool BoundaryTracks::keep(Slot slot, bool rising, const TrackCurve& curve, std::int32_t error) {
  TrackStrip& strip = face_.strip;
  const std::int32_t half = strip.half;
  TrackStrip::Shape& last = strip.last[rising ? 1 : 0];
  last.dx = curve.slope / half;
  last.ddx = curve.bend / (half * half);
  strip.meet(last.dx, last.ddx);
  const std::int32_t unit_slope = half * strip.unit.dx;
  const std::int32_t unit_bend = half * half * strip.unit.ddx;
  const std::int32_t dx = std::clamp<std::int32_t>(rounded(curve.slope, unit_slope), -511, 511);
  const std::int32_t ddx = std::clamp<std::int32_t>(rounded(curve.bend, unit_bend), -15, 15);
  // What the rest of the bend makes goes from 0 to all of it: half of it to within a half.
  const std::int32_t half_bend = (curve.bend - ddx * unit_bend) / 2;
  const std::int32_t x = rounded(curve.x + half_bend, strip.unit.x);
  if (size(x) >= 1 << 13) return false;
  const std::int32_t all =
      error + size(curve.x + half_bend - x * strip.unit.x) + size(curve.slope - dx * unit_slope) + size(half_bend) + 1;
  std::uint32_t grade = 0;
  while (grade < 8 && all > error_of(grade)) ++grade;
  if (grade == 8) return false;
  *slot = static_cast<std::uint32_t>(ddx) << 27 | (static_cast<std::uint32_t>(dx) << 22 >> 5) |
          (static_cast<std::uint32_t>(x) << 18 >> 15) | grade;
  return true;
}

}  // namespace halfspace
