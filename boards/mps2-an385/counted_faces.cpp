#include "boards/mps2-an385/counted_faces.hpp"

namespace halfspace::mps2 {
namespace {

const cortex_m::TickClock* clock_ = nullptr;
const FaceModule *root_ = nullptr, *rational_ = nullptr;
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

constexpr FaceModule counted_root{&enter<root_>, &shade<root_>};
constexpr FaceModule counted_rational{&enter<rational_>, &shade<rational_>};

}  // namespace

Modules counted(const Modules& of, const cortex_m::TickClock& clock) {
  clock_ = &clock;
  root_ = of.root;
  rational_ = of.rational;
  counts_ = {};
  overhead_ = 0;
  std::uint64_t empty = 0;
  count(empty, [] {});
  overhead_ = empty;
  Modules modules = of;
  modules.root = &counted_root;
  modules.rational = &counted_rational;
  return modules;
}

FaceCounts face_counts() { return counts_; }

}  // namespace halfspace::mps2
