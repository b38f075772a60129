// SHADER STRIDE JOB - draws a job file by the shader of that number (firmware/core/job_format.hpp), or by a baseline (A2, A4), and
// prints what it took: instructions under QEMU's -icount shift=6, and a hash of the page's bytes.
// Exit status  0 drawn, 2 the words are wrong, 4 the job was refused (the numbers of the command line).
#include <charconv>

#include "boards/cortex_m/memory_map.hpp"
#include "boards/cortex_m/semihosting.hpp"
#include "boards/mps2-an385/baselines.hpp"
#include "boards/mps2-an385/counted_faces.hpp"
#include "firmware/app/draw_page.hpp"

namespace halfspace::mps2 {
namespace {

constexpr std::int32_t band_rows = 16;

struct Request {
  Shader shader = Shader::isqrt;
  std::int32_t stride = 1;
  const FaceModule* root = all_modules.root;
  const char* job = nullptr;
};

bool read_number(std::string_view word, std::int32_t& value) {
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size();
}

// The next word of a line that ends in a zero.
std::string_view next_word(const char*& at) {
  while (*at == ' ') ++at;
  const char* const from = at;
  while (*at != ' ' && *at != '\0') ++at;
  return {from, static_cast<std::size_t>(at - from)};
}

bool read_request(const char* line, Request& request) {
  const std::string_view shader = next_word(line);
  std::int32_t number = 0;
  if (shader == "A2") {
    request.root = &any_quadric_dots;
  } else if (shader == "A4") {
    request.root = &sphere_dots;
  } else if (read_number(shader, number)) {
    request.shader = static_cast<Shader>(number);
  } else {
    return false;
  }
  if (!read_number(next_word(line), request.stride)) return false;
  request.job = next_word(line).data();  // the last one
  return *request.job != '\0';
}

// What becomes of a band costs the page nothing: its ticks are taken off. FNV-1a, 32 bits.
class HashSink final : public BandSink {
 public:
  explicit HashSink(const cortex_m::TickClock& clock) : clock_(clock) {}

  bool put_band(const Band& band) override {
    const std::uint64_t start = clock_.ticks();
    for (const std::uint8_t byte : band.bytes) hash_ = (hash_ ^ byte) * 16777619U;
    ticks_ += clock_.ticks() - start;
    return true;
  }
  [[nodiscard]] std::uint32_t hash() const { return hash_; }
  [[nodiscard]] std::uint64_t ticks() const { return ticks_; }

 private:
  const cortex_m::TickClock& clock_;
  std::uint32_t hash_ = 2166136261U;
  std::uint64_t ticks_ = 0;
};

// A tick is 40 ns, an instruction 64.
std::int64_t instructions(std::uint64_t ticks) { return static_cast<std::int64_t>(ticks * 5 / 8); }

int run() {
  std::array<char, 512> line{};  // zeros follow the words
  Request request;
  cortex_m::HostFile console(cortex_m::console_name);
  if (cortex_m::command_line(line).empty() || !read_request(line.data(), request)) return 2;

  const cortex_m::TickClock clock(25'000);
  HashSink sink(clock);
  cortex_m::HostInput file(request.job);
  JobReader job(file);
  JobHeader header;
  if (!read_header(job, header)) return 4;
  if (header.page.width > largest_page || header.page.height > largest_page) return 4;
  set_page(header.page);
  Modules modules = all_modules;
  modules.root = request.root;
  modules = counted(modules, clock);

  const std::uint64_t start = clock.ticks();
  const DrawResult result = draw(job, header, sink, cortex_m::arena(),
                                 {.shader = request.shader, .stride = request.stride, .band_rows = band_rows}, modules);
  const std::uint64_t ticks = clock.ticks() - start - sink.ticks();
  const FaceCounts faces = face_counts();

  write_figure(console, "status", static_cast<std::int64_t>(result.status));
  write_figure(console, "dots", static_cast<std::int64_t>(faces.dots));
  write_figure(console, "enter", instructions(faces.enter_ticks));
  write_figure(console, "shade", instructions(faces.shade_ticks));
  write_figure(console, "draw", instructions(ticks));
  write_figure(console, "hash", sink.hash());
  write_figure(console, "exact_levels", result.counters.exact_levels);
  return result.status == DrawStatus::ok ? 0 : 4;
}

}  // namespace
}  // namespace halfspace::mps2

int main() { return halfspace::mps2::run(); }
