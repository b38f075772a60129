#include "firmware/core/boundary_tracks.hpp"

namespace halfspace {
namespace {

constexpr std::uint32_t rest = 4, rests = 1;      // strips that pass before what failed is tried again
constexpr int most_tries = 4;                     // of a fit
constexpr std::int32_t largest_error = 31 << 10;  // of a path kept, 2^-16 dot

// Of a path, on the page in 2^-16 dot: on the lines up to the next strip's it moves by less than 4096 dots, and fits.
constexpr std::int64_t farthest = std::int64_t{(1 << 15) - 4096} << 16;

std::int32_t size(std::int32_t v) { return v < 0 ? -v : v; }

}  // namespace

BoundaryTracks::BoundaryTracks(GeneralContours& face, std::span<std::uint32_t> block, std::int32_t y)
    : face_(face), words_(block.data()), levels_(static_cast<std::int32_t>(block.size() / (2 * slot_words))) {
  if (levels_ == 0) return;
  if (!face.strip.holds(y)) start_strip(y);
  v_ = y - face.strip.middle;
  middle_ = face.forms.middle * (1 << 16);
  lines_left_ = face.strip.end - y;
}

// What was fresh is old, unless its strip is far; what failed rests.
void BoundaryTracks::start_strip(std::int32_t y) {
  TrackStrip& strip = face_.strip;
  const std::int32_t before = strip.middle;
  const std::int32_t half_before = strip.half;
  strip.cover(face_.forms, y);
  strip.way = strip.middle - before;
  const bool near = half_before != 0 && strip.way <= 2 * (half_before + strip.half);
  for (std::int32_t i = 0; i < 2 * levels_ * slot_words; i += slot_words) {
    std::uint32_t& place = words_[i];
    const std::uint32_t state = place & state_mask;
    if (near && state == fresh) {
      place = place - fresh + old;
    } else if (near && state == failed && place > failed) {
      place -= rest;
    } else {
      place = empty;
    }
  }
}

bool BoundaryTracks::renew(Slot slot, std::int32_t k, bool rising) {
  const TrackStrip& strip = face_.strip;
  const std::int32_t dx = static_cast<std::int32_t>(slot[1]) >> 12;
  const std::int32_t ddx = static_cast<std::int16_t>(slot[1]);
  return fit(slot, k, rising,
             {x_of(slot[0], slot[1], strip.way) - middle_, strip.half * (dx + 2 * strip.way * ddx),
              strip.half * strip.half * ddx});
}

void BoundaryTracks::seek(Slot slot, std::int32_t k, bool rising, std::int32_t at) {
  const TrackStrip& strip = face_.strip;
  const TrackStrip::Shape& last = strip.last[rising ? 1 : 0];
  (void)fit(slot, k, rising,
            {at - v_ * (last.dx + v_ * last.ddx), strip.half * last.dx, strip.half * strip.half * last.ddx});
}

bool BoundaryTracks::fit(Slot slot, std::int32_t k, bool rising, TrackCurve guess) {
  for (int i = 0; i < most_tries; ++i) {
    const FittedTrack fitted =
        fit_track(face_.forms, face_.strip, face_.bars.at(k), face_.bars.error, rising ? 1 : -1, guess);
    if (fitted.state == FittedTrack::State::failed) break;
    if (fitted.state == FittedTrack::State::sure) {
      if (keep(slot, rising, fitted.curve, fitted.error)) return true;
      break;
    }
    guess = fitted.curve;
  }
  slot[0] = failed + rests * rest;
  return false;
}

bool BoundaryTracks::keep(Slot slot, bool rising, const TrackCurve& curve, std::int32_t error) {
  TrackStrip& strip = face_.strip;
  const std::int64_t x = std::int64_t{curve.x} + middle_;
  const std::int32_t ddx = curve.bend / (strip.half * strip.half);
  const std::int32_t dx = curve.slope / strip.half;
  if (x >= farthest || ddx != static_cast<std::int16_t>(ddx) || size(dx) >= 1 << 19) return false;
  const std::uint32_t shape =
      (static_cast<std::uint32_t>(dx) << 12 & 0xffff0000U) | (static_cast<std::uint32_t>(ddx) & 0xffffU);
  const std::int32_t all = error + 128 + size(curve.slope - strip.half * (static_cast<std::int32_t>(shape) >> 12)) +
                           size(curve.bend - strip.half * strip.half * ddx);
  if (all > largest_error) return false;
  slot[0] = (static_cast<std::uint32_t>(x) & ~127U) | static_cast<std::uint32_t>(all + 1023) >> 10 << 2 | fresh;
  slot[1] = shape;
  strip.last[rising ? 1 : 0] = {dx, ddx};
  return true;
}

}  // namespace halfspace
