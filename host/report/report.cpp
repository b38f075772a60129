#include "host/report/report.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "host/report/board_summary.hpp"
#include "host/report/environment.hpp"
#include "host/report/files.hpp"
#include "host/report/findings.hpp"
#include "host/report/measure.hpp"
#include "host/report/other_renderers.hpp"
#include "host/report/page_floor.hpp"
#include "host/report/plots.hpp"
#include "host/report/summary.hpp"

namespace halfspace {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t most_judged_dots = 4 << 20;  // by the oracle, of a page

const fs::path tree = HALFSPACE_SOURCE_DIR;

class Reporter {
 public:
  explicit Reporter(const Plan& plan) : plan_(plan) {}

  Findings run() {
    found_.environment = read_environment();
    suite("gallery", tree / "scenes", plan_.gallery);
    suite("hard", tree / "tests/hard/scenes", plan_.hard);
    resolution("clover_knot");
    resolution("gear");
    beside_povray("clover_knot");
    beside_povray("gear");
    beside_raster3d("30 balls and rods", balls_and_sticks());
    beside_raster3d(fmt::format("{} atoms", plan_.atoms), space_filling(plan_.atoms));
    found_.floor_ns = page_floor_ns(plan_.povray_page, plan_.runs);
    resolver();
    if (plan_.board) beside_baselines();
    tell("counting instructions");
    gap(add_instructions(subjects_, ours_));
    found_.rows = ours_;
    found_.rows.insert(found_.rows.end(), others_.begin(), others_.end());
    tell("");
    return std::move(found_);
  }

 private:
  // On a terminal, what is being done.
  static void tell(const std::string& what) {
    if (isatty(STDERR_FILENO) != 0) fmt::print(stderr, "\r\x1b[K{}", what);
  }

  void gap(const std::string& why) {
    if (why.empty() || std::find(found_.gaps.begin(), found_.gaps.end(), why) != found_.gaps.end()) return;
    found_.gaps.push_back(why);
    fmt::print(stderr, "warning: {}\n", why);
  }

  // Our rows; of a `whole` scene from its text, too. Returns the truth, for others' rows beside them.
  Truth add(const SceneText& source, const PageSize& size, bool whole) {
    tell(fmt::format("{} on {} x {}, {} levels", source.name, size.width, size.height, size.levels));
    Subject subject = make_subject(source, size);
    if (!subject.refusal.empty()) {
      gap(source.name + " is left out: " + subject.refusal);
      return {};
    }
    Truth truth = true_levels(subject.scene, most_judged_dots, source.suite != "hard");
    const Rows rows = measure(subject, truth, {.runs = whole ? plan_.whole_runs : plan_.runs, .from_text = whole});
    ours_.insert(ours_.end(), rows.begin(), rows.end());
    subjects_.push_back(std::move(subject));
    return truth;
  }

  void suite(const std::string& name, const fs::path& folder, const std::vector<PageSize>& sizes) {
    std::vector<fs::path> paths;
    for (const auto& entry : fs::directory_iterator(folder)) {
      if (entry.path().extension() == ".uq") paths.push_back(entry.path());
    }
    std::sort(paths.begin(), paths.end());
    paths.resize(std::min(paths.size(), plan_.most_scenes));
    for (const fs::path& path : paths) {
      for (const PageSize& size : sizes) add({name, path.stem().string(), read_file(path.string())}, size, false);
    }
  }

  [[nodiscard]] static fs::path scene_path(const std::string& name) { return tree / "scenes" / (name + ".uq"); }

  void resolution(const std::string& name) {
    const std::string text = read_file(scene_path(name).string());
    for (const int dpi : plan_.dots_per_inch) {
      const int side = dpi * plan_.side_inches;
      add({"resolution", name, text}, {side, side, 65}, false);
    }
  }

  void add_other(const std::optional<OtherPicture>& picture, const Truth& truth, const std::string& why) {
    gap(why);
    if (!picture || truth.lines.empty()) return;
    Row row = ours_.back();  // of the same scene on the same page
    row.renderer = picture->renderer;
    row.shader = "";
    row.ns = 1e9 * picture->seconds / static_cast<double>(row.shaded);
    row.text_ns = row.ns;
    row.error = picture_error(pick_lines(picture->levels, truth, row.size.width), truth.levels, row.size.width);
    others_.push_back(row);
  }

  [[nodiscard]] OtherRequest asked(const PageSize& size) const {
    return {size.width, size.height, size.levels, plan_.whole_runs};
  }

  void beside_povray(const std::string& name) {
    const std::string path = scene_path(name).string();
    const Truth truth = add({"whole", name, read_file(path)}, plan_.povray_page, true);
    std::string why;
    tell(name + " by POV-Ray");
    const auto picture = draw_by_povray(path, asked(plan_.povray_page), why);
    add_other(picture, truth, why);
  }

  void beside_raster3d(const std::string& name, const Molecule& molecule) {
    for (const PageSize& size : plan_.raster3d_pages) {
      const Truth truth = add({"whole", name, as_uniquadrix(molecule)}, size, true);
      std::string why;
      tell(name + " by Raster3D");
      for (const Raster3dFile file : {Raster3dFile::samples, Raster3dFile::png}) {
        const auto picture = draw_by_raster3d(molecule, asked(size), file, why);
        add_other(picture, truth, why);
      }
    }
  }

  void resolver() {
    tell("the resolver");
    const auto add_row = [this](const std::string& name, const std::string& text) {
      found_.resolver.push_back(measure_resolver({"resolver", name, text}, plan_.povray_page, plan_.runs));
    };
    for (const char* name : {"clover_knot", "gear"}) add_row(name, read_file(scene_path(name).string()));
    for (const char* name : {"steinmetz_2", "viviani", "steinmetz_3", "eight_quadrics"}) {
      add_row(name, read_file((tree / "tests/hard/scenes" / (std::string(name) + ".uq")).string()));
    }
    for (const int atoms : plan_.resolver_atoms) {
      add_row(fmt::format("{} atoms", atoms), as_uniquadrix(space_filling(atoms)));
    }
  }

  void beside_baselines() {
    tell("faces on a Cortex-M3");
    BoardFindings board = measure_board(plan_);
    for (const std::string& why : board.gaps) gap(why);
    found_.board = std::move(board.rows);
  }

  const Plan& plan_;
  std::vector<Subject> subjects_;
  Rows ours_, others_;
  Findings found_;
};

void check_sources() {
  if (fs::is_directory(tree / "scenes")) return;
  throw std::runtime_error(
      tree.string() + ": the sources of this program, which the report draws, are not there; build it where they are");
}

void make_folder(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error || !fs::is_directory(folder)) {
    throw std::runtime_error(folder + ": is no folder and cannot be made one (" + error.message() +
                             "); name another with -o");
  }
  if (access(folder.c_str(), W_OK) != 0) {
    throw std::runtime_error(folder + ": cannot be written to; change its permissions or name another with -o");
  }
}

}  // namespace

void write_report(const Plan& plan, const std::string& folder) {
  check_sources();
  make_folder(folder);  // before the long work
  Findings found = Reporter(plan).run();
  write_file(folder + "/results.csv", as_csv(found.rows));
  if (!found.board.empty()) write_file(folder + "/cortex-m3.csv", as_csv(found.board));
  if (const std::string why = write_plots(found.rows, folder); !why.empty()) {
    found.gaps.push_back(why);
    fmt::print(stderr, "warning: {}\n", why);
  }
  write_file(folder + "/README.md", summary(found));
}

}  // namespace halfspace
