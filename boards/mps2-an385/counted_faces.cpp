#include "boards/mps2-an385/counted_faces.hpp"

namespace halfspace::mps2 {
namespace {

const cortex_m::TickClock* clock_ = nullptr;
const FaceModule *root_ = nullptr, *rational_ = nullptr;
const ContourModule* contours_ = nullptr;
std::uint64_t overhead_ = 0;  // ticks of an interval that holds nothing
FaceCounts counts_;

template <class Call>
void count(std::uint64_t& ticks, Call call) {
  const std::uint64_t start = clock_->ticks();
  call();
  ticks += clock_->ticks() - start - overhead_;
}

template <const FaceModule*& module>
void enter(ActiveFace& face, const Lighting& lighting) {
  count(counts_.enter_ticks, [&] { module->enter(face, lighting); });
}

template <const FaceModule*& module>
void shade(const ShadeJob& job, Shader shader, std::int32_t y, std::int32_t x0, std::int32_t x1) {
  count(counts_.shade_ticks, [&] { module->shade(job, shader, y, x0, x1); });
  counts_.dots += static_cast<std::uint32_t>(x1 - x0 + 1);
}

// A face that declines contours goes on to its own shader, which counts its dots.
bool shade_by_contours(const ShadeJob& job, Shader shader, std::int32_t y, std::int32_t x0, std::int32_t x1) {
  bool done = false;
  count(counts_.shade_ticks, [&] { done = contours_->shade(job, shader, y, x0, x1); });
  if (done) counts_.dots += static_cast<std::uint32_t>(x1 - x0 + 1);
  return done;
}

constexpr FaceModule counted_root{&enter<root_>, &shade<root_>};
constexpr FaceModule counted_rational{&enter<rational_>, &shade<rational_>};
constexpr ContourModule counted_contours{&shade_by_contours};

}  // namespace

Modules counted(const Modules& of, const cortex_m::TickClock& clock) {
  clock_ = &clock;
  root_ = of.root;
  rational_ = of.rational;
  contours_ = of.contours;
  counts_ = {};
  overhead_ = 0;
  std::uint64_t empty = 0;
  count(empty, [] {});
  overhead_ = empty;
  Modules modules = of;
  modules.root = &counted_root;
  modules.rational = &counted_rational;
  modules.contours = &counted_contours;
  return modules;
}

FaceCounts face_counts() { return counts_; }

}  // namespace halfspace::mps2
