#include "host/report/board.hpp"

#include <fmt/format.h>

#include <map>
#include <optional>
#include <sstream>

#include "host/report/board_faces.hpp"
#include "host/report/child.hpp"
#include "host/report/files.hpp"
#include "host/report/measure.hpp"

namespace halfspace {
namespace {

// What the program is told to draw by: a shader's number, or the name of a baseline, whose picture is the main shader's.
struct BoardShader {
  std::string name, word;
  const ListedShader* same_picture;
};

std::vector<BoardShader> board_shaders() {
  std::vector<BoardShader> all{{"A2", "A2", &main_shader}, {"A4", "A4", &main_shader}};
  for (const ListedShader& shader : listed_shaders) {
    all.push_back({shader.name, std::to_string(static_cast<int>(shader.shader)), &shader});
  }
  return all;
}

using Figures = std::map<std::string, std::int64_t>;

Figures read_figures(const std::string& text) {
  std::istringstream in(text);
  Figures figures;
  std::int64_t value = 0;
  for (std::string name; in >> name >> value;) figures[name] = value;
  return figures;
}

struct Needed {
  const char *program, *packages;
};
constexpr Needed needed_programs[] = {
    {"arm-none-eabi-g++", "gcc-arm-none-eabi libstdc++-arm-none-eabi-dev libnewlib-dev"},
    {"qemu-system-arm", "qemu-system-arm"}};

class Board {
 public:
  explicit Board(BoardFindings& found) : found_(found) {
    for (const Needed& needed : needed_programs) {
      if (has_program(needed.program)) continue;
      gap(fmt::format("{} is missing, and the Cortex-M3's tables are left out: apt-get install {}", needed.program,
                      needed.packages));
      return;
    }
    const ChildResult built = run_child({HALFSPACE_SOURCE_DIR "/boards/mps2-an385/build.sh", scratch_ / "build"});
    ready_ = built.ok();
    if (!ready_) gap("boards/mps2-an385 was not built, and its tables are left out: " + built.output.substr(0, 300));
  }
  [[nodiscard]] bool ready() const { return ready_; }

  void measure(const BoardFace& face, const BoardView& view, std::int32_t radius, std::int32_t levels) {
    const std::int32_t side = 2 * (radius + 3);
    const Subject subject = make_subject({"board", face.name, board_text(face, view, radius)}, {side, side, levels});
    if (!subject.refusal.empty()) return gap(std::string(face.name) + " is left out: " + subject.refusal);
    const Truth truth = true_levels(subject.scene, std::uint64_t{1} << 32, false);
    for (const BoardShader& shader : board_shaders()) {
      if (shader.name == "A4" && std::string(face.name) != "sphere") continue;
      const auto row = drawn(subject, truth, shader);
      if (!row) continue;
      found_.rows.push_back(*row);
      BoardRow& r = found_.rows.back();
      r.face = face.name;
      r.view = view.name;
      r.radius = radius;
      r.levels = levels;
      r.aim = face.aim;
    }
  }

 private:
  void gap(const std::string& why) { found_.gaps.push_back(why); }

  Figures run(const JobResult& job, const BoardShader& shader) {
    const std::string path = scratch_ / "job.hsj";
    write_file(path, {job.bytes.begin(), job.bytes.end()});
    const std::string words = "enable=on,target=native,arg=" + shader.word +
                              ",arg=" + std::to_string(shader.same_picture->stride) + ",arg=" + path;
    const ChildResult child = run_child({"timeout", "600", "qemu-system-arm", "-M", "mps2-an385", "-icount", "shift=6",
                                         "-display", "none", "-monitor", "none", "-serial", "none",
                                         "-semihosting-config", words, "-kernel", scratch_ / "build/mps2-an385.elf"});
    return read_figures(child.ok() ? child.output : "");
  }

  std::optional<BoardRow> drawn(const Subject& subject, const Truth& truth, const BoardShader& shader) {
    Figures empty = run(subject.empty_job, shader), page = run(subject.job, shader);
    if (page["dots"] == 0 || page["hash"] != page_hash(subject.job, *shader.same_picture)) {
      gap(fmt::format("{} by {} on {} x {} dots differs between board and host, and is left out", subject.source.name,
                      shader.name, subject.size.width, subject.size.height));
      return std::nullopt;
    }
    const auto dots = static_cast<double>(page["dots"]);
    BoardRow row;
    row.shader = shader.name;
    row.dots = static_cast<std::uint64_t>(page["dots"]);
    row.face_instructions = static_cast<double>(page["enter"] + page["shade"]) / dots;
    row.draw_instructions = static_cast<double>(page["draw"] - empty["draw"]) / dots;
    row.error = picture_error(drawn_levels(subject.scene, *shader.same_picture), truth.levels, subject.size.width);
    return row;
  }

  BoardFindings& found_;
  const ReportScratch scratch_;
  bool ready_ = false;
};

}  // namespace

BoardFindings measure_board(const Plan& plan) {
  BoardFindings found;
  Board board(found);
  if (!board.ready()) return found;
  for (const BoardFace& face : board_faces) {
    for (const BoardView& view : board_views) board.measure(face, view, plan.board_radius, 65);
  }
  for (const std::size_t i : {0, 1, 3}) {  // a sphere, a cylinder, an ellipsoid
    for (const BoardSize& size : plan.board_sizes) {
      board.measure(board_faces.at(i), board_views[0], size.radius, size.levels);
    }
  }
  return found;
}

}  // namespace halfspace
