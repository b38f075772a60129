#include "tests/core/sample_job.hpp"

namespace halfspace::testing {
namespace {

IntegerBody body_of(const char* name, std::array<std::int64_t, 3> origin, HalfSpaceKind kind,
                    const std::array<mpz_class, 10>& c) {
  IntegerBody body;
  body.name = name;
  body.origin = origin;
  IntegerHalfSpace half_space;
  half_space.kind = kind;
  half_space.c = c;
  half_space.name = name;
  body.half_spaces.push_back(half_space);
  return body;
}

IntegerScene sample_scene() {
  IntegerScene scene;
  scene.width = sample_width;
  scene.height = sample_height;
  scene.levels = 65;
  scene.scissor = {2, 1, 67, 58};
  for (int i = 0; i < 3; ++i) scene.lighting.normal_matrix[i][i] = 1 << 14;
  scene.lighting.light = {-3000, 2000, -9000};
  scene.lighting.ambient = 100;
  scene.lighting.parallel = 900;
  scene.lighting.unit = 1000;
  std::array<mpz_class, 10> sphere;
  sphere[0] = sphere[1] = sphere[2] = 1;
  sphere[9] = -625;
  std::array<mpz_class, 10> plane;
  plane[0] = 2, plane[1] = 1, plane[2] = 5, plane[3] = 40;
  std::array<mpz_class, 10> trough;  // x^2 + 200 z = 40 y
  trough[0] = 1, trough[7] = -20, trough[8] = 100;
  scene.bodies = {body_of("sphere", {35, 30, 0}, HalfSpaceKind::quadric, sphere),
                  body_of("plane", {35, 30, 0}, HalfSpaceKind::plane, plane),
                  body_of("trough", {50, 20, 2}, HalfSpaceKind::quadric, trough)};
  return scene;
}

ResolvedScene sample_resolved() {
  ResolvedScene r;
  const Curve limb{{1, 0, 1, 0, 0, -625}};
  r.arcs = {{0, limb, Branch::left, {}, 5, 55},
            {0, limb, Branch::right, {}, 5, 55},
            {1, Curve{{0, 0, 0, 3, 1, 60}}, Branch::single, {}, 10, 50},
            {2, Curve{{0, 0, 0, 2, -1, -1}}, Branch::single, {}, 1, 40}};
  r.faces = {{0, 0, Sheet::front}, {0, 0, Sheet::back}, {1, 0, Sheet::only}, {2, 0, Sheet::only}};
  r.cells = {{0, 0, 1, 5, 55}, {1, 0, 1, 5, 55}, {2, 2, no_arc, 10, 50}, {3, no_arc, 3, 1, 40}};
  r.spans = {{2, 57, 4, 30}};
  return r;
}

// The sphere's limb, left: x^2 + y^2 - 625 = p + r sqrt(d) with r = 2 x - 3 y + 7, sqrt(d) = x + y + 200.
Arc radical_limb() {
  RadicalForm form;
  form.p = {{1 - 2, 1, 1 + 3, -407, 593, -625 - 1400}};
  form.r = {{0, 0, 0, 2, -3, 7}};
  form.d = {{1, 2, 1, 400, 400, 40000}};
  Guide guide{.rising = false, .missing_right = false, .windows = {}};
  guide.windows = {{5, 20, {}, Separator{65536, 0}},
                   {21, 21, Separator{-26 * 65536, -65536}, Separator{-65536, 70000}},
                   {22, 55, Separator{-26 * 65536 - 9, -5}, Separator{65536, 0}}};
  return {0, form, Branch::single, guide, 5, 55};
}

// The same, right, with a second circle about it: (x^2 + y^2 - 625) (x^2 + y^2 - 900).
Arc quartic_limb() {
  const QuarticForm form{{1, 0, 2, 0, 1, 0, 0, 0, 0, -1525, 0, -1525, 0, 0, 562500}};
  Guide guide{.rising = false, .missing_right = false, .windows = {}};
  for (std::int32_t y = 5; y <= 55; ++y) {
    const mpz_class between = sqrt(mpz_class((762 - (y - 30) * (y - 30))) << 32);
    guide.windows.push_back({y, y, Separator{-65536, 0}, Separator{between.get_si(), 0}});
  }
  return {0, form, Branch::single, guide, 5, 55};
}

JobResult job_of(const ResolvedScene& resolved, DotFormat format) {
  JobOptions options;
  options.page = {sample_width, sample_height, format, 65, 64};
  return write_job(sample_scene(), resolved, options);
}

}  // namespace

JobResult sample_job(DotFormat format) { return job_of(sample_resolved(), format); }

JobResult guided_job(DotFormat format) {
  ResolvedScene resolved = sample_resolved();
  resolved.arcs[0] = radical_limb();
  resolved.arcs[1] = quartic_limb();
  return job_of(resolved, format);
}

Drawn draw_job(ByteSource& source, std::size_t memory_bytes, const DrawOptions& options, std::size_t most_bands,
               const Modules& modules) {
  std::vector<std::uint64_t> memory(memory_bytes / 8);
  Collector sink(most_bands);
  Drawn drawn;
  drawn.result = draw(source, sink, std::as_writable_bytes(std::span(memory)), options, modules);
  drawn.bytes = std::move(sink.bytes);
  drawn.bands = std::move(sink.bands);
  return drawn;
}

}  // namespace halfspace::testing
