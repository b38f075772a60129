// promise_oracle.hpp - whether an integer picture keeps the promise made to the scene's text.
// Promise  design.md, section 3.1: the level of a dot is that of a true-scene point within the scene's bound (taken
//          as no less than 1/256 dot and no more than 1/16), give or take half a level. Surfaces may lie anywhere within the bound, so a face
//          thinner than that may be lost or seen, and of two faces closer in depth either may win.
// Method   The true scene (true_scene.hpp) at the dot's centre, in doubles; where it disagrees, at 256 bits at the
//          centre and on two rings of eight points within the bound. Only then is the promise broken.
// Cost     About 1 us for a dot and body; a searched dot some ms.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/flatten/integer_scene.hpp"
#include "host/scene/scene.hpp"
#include "tests/oracle/ray_caster.hpp"

namespace halfspace::oracle {

struct PromiseOptions {
  int stride = 1;           // every dot whose x and y it divides
  std::string view;         // empty: the last
  double slack = 0.0;       // dots added to the bound
  std::size_t enough = 20;  // broken dots after which the search ends
};

struct BrokenDot {
  int x = 0, y = 0;
  int level = 0;      // drawn; -1: background
  double truth = -1;  // highest level * intensity at the true scene's centre of the dot; -1: background
};

struct PromiseReport {
  std::uint64_t dots = 0;      // 0: no window, and no solid to fit one to
  std::uint64_t searched = 0;  // the centre alone did not settle
  std::vector<BrokenDot> broken;
  bool wrong_extent = false;  // a half-size was missing, and what it was fitted to is not the solids' extent
};

inline constexpr double least_bound = 1.0 / 256;  // dots
inline constexpr double most_bound = 1.0 / 16;

// `levels`: the whole page as draw() gives it. Throws MeaninglessScene where the text has no picture.
PromiseReport check_promise(const Scene& scene, const IntegerScene& integers, const std::vector<std::int16_t>& levels,
                            const PromiseOptions& options = {});

// Dots for a unit and the middle of the page, from the window or, where it is not given, from the extent that the integers
// name. Nothing if they name none.
std::optional<Fit> fit_to_page(const TrueScene& scene, const IntegerScene& integers);

}  // namespace halfspace::oracle
