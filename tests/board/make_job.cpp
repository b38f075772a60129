// make_job SCENE WIDTHxHEIGHT LEVELS SHADER NAME - compiles a scene for a board: NAME.cpp, the job as a constant with
// the arc modules it names, and NAME.bin, the dots that the same core draws here.
#include <array>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <iterator>
#include <set>
#include <string>

#include "firmware/core/engine.hpp"
#include "firmware/core/memory_source.hpp"
#include "host/flatten/flatten.hpp"
#include "host/job/job_writer.hpp"
#include "host/job/limits.hpp"
#include "host/resolve/resolve.hpp"
#include "host/scene/parse.hpp"

namespace halfspace {
namespace {

struct Request {
  std::string scene, name;
  std::int32_t width = 0, height = 0, levels = 0;
  Shader shader = Shader::isqrt;
};

struct Compiled {
  JobResult job;
  std::set<ArcKind> kinds;
  bool roots = false, rationals = false;  // quadrics with and without z^2 among the faces
};

// Prints what is wrong; true when nothing is worse than a warning.
bool accepted(const Diagnostics& diagnostics) {
  for (const Diagnostic& d : diagnostics) std::cerr << format(d) << '\n';
  return !has_errors(diagnostics);
}

bool compile(const Request& request, Compiled& compiled) {
  std::ifstream file(request.scene);
  if (!file) {
    std::cerr << request.scene << ": error: cannot be read; name a scene file\n";
    return false;
  }
  const std::array<SourceText, 1> texts{{{request.scene, {std::istreambuf_iterator<char>(file), {}}}}};
  const ParseResult parsed = parse_uniquadrix(texts);
  if (!accepted(parsed.diagnostics)) return false;
  FlattenOptions flat_options;
  flat_options.width = request.width;
  flat_options.height = request.height;
  flat_options.levels = request.levels;
  const FlattenResult flat = flatten(parsed.scene, flat_options);
  if (!accepted(flat.diagnostics)) return false;
  const Page page{request.width, request.height, DotFormat::bilevel, request.levels, request.levels - 1};
  const ResolvedScene resolved = resolve(flat.scene);
  compiled.job = write_job(flat.scene, resolved, {.page = page});
  if (!accepted(compiled.job.diagnostics)) return false;
  if (compiled.job.header.needs.exact_bits > exact_768.bits) {
    std::cerr << request.scene << ": error: needs exact arithmetic of " << compiled.job.header.needs.exact_bits
              << " bits, and the board's stack holds 768; draw it smaller or with fewer levels\n";
    return false;
  }
  for (const Arc& arc : resolved.arcs) compiled.kinds.insert(arc_kind(flat.scene, arc).value());
  for (const Face& face : resolved.faces) {
    const IntegerHalfSpace& h = flat.scene.bodies[face.body].half_spaces[face.half_space];
    if (h.kind == HalfSpaceKind::plane) continue;
    (h.c[2] != 0 ? compiled.roots : compiled.rationals) = true;
  }
  return true;
}

class FileSink final : public BandSink {
 public:
  explicit FileSink(const std::string& name) : file_(name, std::ios::binary) {}
  bool put_band(const Band& band) override {
    file_.write(reinterpret_cast<const char*>(band.bytes.data()), static_cast<std::streamsize>(band.bytes.size()));
    return file_.good();
  }

 private:
  std::ofstream file_;
};

bool draw_here(const Request& request, const JobResult& job) {
  MemorySource source(job.bytes);
  FileSink sink(request.name + ".bin");
  std::vector<std::uint64_t> memory(memory_needed(job.header, 1) / 8 + 1);
  const DrawResult drawn = draw(source, sink, std::as_writable_bytes(std::span(memory)),
                                {.shader = request.shader, .band_rows = 1, .measure = false}, all_modules);
  if (drawn.status == DrawStatus::ok) return true;
  std::cerr << "error: the core drew " << request.scene << " with status " << static_cast<int>(drawn.status) << '\n';
  return false;
}

// The narrowest width that the job can do with. The board's stack holds no wider one than 768 bits (docs/boards.md).
const char* exact_module(std::int32_t bits) { return bits <= exact_384.bits ? "exact_384" : "exact_768"; }

bool write_source(const Request& request, const Compiled& compiled) {
  static constexpr const char* names[arc_kinds] = {
      "line_arc_64",     "line_arc_128",    "line_arc_256",    "conic_arc_64",    "conic_arc_128",   "conic_arc_256",
      "radical_arc_128", "radical_arc_256", "radical_arc_384", "quartic_arc_128", "quartic_arc_256", "quartic_arc_384"};
  std::ofstream out(request.name + ".cpp");
  out << "#include \"firmware/app/embedded_job.hpp\"\n\nnamespace halfspace {\n\nstatic constexpr std::uint8_t bytes[] "
         "= {";
  for (const std::uint8_t byte : compiled.job.bytes) out << static_cast<int>(byte) << ',';
  out << "};\nconstinit const EmbeddedJob embedded_job{bytes, {{";
  for (int i = 0; i < arc_kinds; ++i) {
    if (compiled.kinds.contains(static_cast<ArcKind>(i))) {
      out << '&' << names[i] << ',';
    } else {
      out << "nullptr,";
    }
  }
  out << "}, {&" << exact_module(compiled.job.header.needs.exact_bits) << "}, "
      << (compiled.roots ? "&root_faces, " : "nullptr, ") << (compiled.rationals ? "&rational_faces" : "nullptr")
      << "}, Shader::" << (request.shader == Shader::jordan ? "jordan" : "isqrt")
      << "};\n\n}  // namespace halfspace\n";
  out.flush();
  if (!out)
    std::cerr << "error: cannot write " << request.name << ".cpp; choose a NAME in a folder that can be written\n";
  return out.good();
}

bool read_arguments(int count, char** words, Request& request) {
  if (count != 6) return false;
  request.scene = words[1];
  request.name = words[5];
  const std::string shader = words[4];
  request.shader = shader == "jordan" ? Shader::jordan : Shader::isqrt;
  char end = 0;
  return std::sscanf(words[2], "%dx%d%c", &request.width, &request.height, &end) == 2 &&
         std::sscanf(words[3], "%d%c", &request.levels, &end) == 1 && (shader == "jordan" || shader == "isqrt");
}

}  // namespace
}  // namespace halfspace

int main(int count, char** words) {
  halfspace::Request request;
  if (!halfspace::read_arguments(count, words, request)) {
    std::cerr << "usage: make_job SCENE WIDTHxHEIGHT LEVELS isqrt|jordan NAME\n";
    return 2;
  }
  halfspace::Compiled compiled;
  const bool made = halfspace::compile(request, compiled) && halfspace::draw_here(request, compiled.job) &&
                    halfspace::write_source(request, compiled);
  return made ? 0 : 1;
}
