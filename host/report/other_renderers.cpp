#include "host/report/other_renderers.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host/picture/read_samples.hpp"
#include "host/report/child.hpp"
#include "host/report/files.hpp"
#include "host/report/processor_time.hpp"

namespace halfspace {
namespace {

using Words = std::vector<std::string>;

template <class Intensity>
std::vector<std::int16_t> levels_of(const Samples& samples, std::int32_t levels, Intensity intensity) {
  std::vector<std::int16_t> result;
  for (const std::uint16_t value : samples.values) {
    const double scaled = (levels - 1) * intensity(static_cast<double>(value));
    result.push_back(value == 0 ? std::int16_t{-1} : static_cast<std::int16_t>(std::min<double>(levels - 1, scaled)));
  }
  return result;
}

// Of several runs; nothing: it failed, and `why` has its words.
std::optional<double> seconds_of(const Words& words, const std::string& input, int runs, std::string& why,
                                 const std::string& output = "") {
  std::vector<double> times;
  for (int i = 0; i < runs; ++i) {
    const ChildResult child = run_child(words, input, output);
    if (!child.ok()) {
      why = fmt::format("{} failed, and its rows are left out: {}", words[0], child.output.substr(0, 300));
      return std::nullopt;
    }
    times.push_back(child.seconds);
  }
  return median(std::move(times));
}

// Its programs named by `packages`; false: one is missing, which `why` tells.
bool are_there(const Words& programs, const std::string& packages, std::string& why) {
  for (const std::string& program : programs) {
    if (has_program(program)) continue;
    why = fmt::format("{} is missing, and its rows are left out: apt-get install {}", program, packages);
    return false;
  }
  return true;
}

// --- POV-Ray

constexpr const char* empty_pov =
    "#version 3.7;\nglobal_settings { assumed_gamma 1 }\nbackground { rgb 0 }\n"
    "camera { orthographic location <0,0,-9> right 4*x up 3*y direction z }\n";

Words povray(const std::string& scene, const OtherRequest& request) {
  return {"povray", "+I" + scene, fmt::format("+W{}", request.width), fmt::format("+H{}", request.height), "+WT1", "-A",
          "-D",     "-GA"};
}

Words with(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

bool write_pov(const std::string& scene, const std::string& pov, const OtherRequest& request, std::string& why) {
  const std::string twin = std::string(HALFSPACE_SOURCE_DIR) + "/tools/uq_to_pov.py";
  const Words words{"python3", twin, "--bound", scene, std::to_string(request.width), std::to_string(request.height)};
  if (run_child(words, "", pov).ok()) return true;
  why = twin + " cannot write " + scene + " for POV-Ray, and its rows are left out";
  return false;
}

// --- Raster3D

// It reads no scene without objects: the page without bodies has a small one outside the window.
const Molecule& nothing() {
  static const Molecule molecule{{{{5, 5, 0}, 0.001}}, {}};
  return molecule;
}

}  // namespace

std::optional<OtherPicture> draw_by_povray(const std::string& scene_path, const OtherRequest& request,
                                           std::string& why) {
  if (!are_there({"povray", "python3"}, "povray python3", why)) return std::nullopt;
  const ReportScratch scratch;
  const std::string pov = scratch / "scene.pov", empty = scratch / "empty.pov", picture = scratch / "scene.png";
  write_file(empty, empty_pov);
  if (!write_pov(scene_path, pov, request, why)) return std::nullopt;
  const auto of_empty = seconds_of(with(povray(empty, request), {"-F"}), "", request.runs, why);
  const auto whole = seconds_of(with(povray(pov, request), {"-F"}), "", request.runs, why);
  const Words drawn{"+O" + picture, "+FN16", "File_Gamma=1", "Dither=off"};
  if (!of_empty || !whole || !seconds_of(with(povray(pov, request), drawn), "", 1, why)) return std::nullopt;
  const Samples samples = read_samples(picture);
  return OtherPicture{"POV-Ray", *whole - *of_empty,
                      levels_of(samples, request.levels, [](double value) { return (value + 0.5) / 65535; })};
}

std::optional<OtherPicture> draw_by_raster3d(const Molecule& molecule, const OtherRequest& request, Raster3dFile file,
                                             std::string& why) {
  if (!are_there({"render"}, "raster3d", why)) return std::nullopt;
  const ReportScratch scratch;
  const std::string scene = scratch / "scene.r3d", empty = scratch / "empty.r3d", picture = scratch / "scene.png";
  write_file(scene, as_raster3d(molecule, request.width));
  write_file(empty, as_raster3d(nothing(), request.width));
  const bool png = file == Raster3dFile::png;
  const auto timed = [&](const std::string& input) {
    return seconds_of({"render", png ? "-png" : "-avs"}, input, request.runs, why, "/dev/null");
  };
  const auto of_empty = timed(empty), whole = timed(scene);
  if (!of_empty || !whole || !seconds_of({"render", "-png", picture}, scene, 1, why)) return std::nullopt;
  const auto intensity = [](double value) { return (value + 0.5) * (value + 0.5) / (256.0 * 256.0); };
  return OtherPicture{png ? "Raster3D PNG" : "Raster3D", *whole - *of_empty,
                      levels_of(read_samples(picture), request.levels, intensity)};
}

}  // namespace halfspace
