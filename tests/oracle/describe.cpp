#include "tests/oracle/describe.hpp"

#include <sstream>

namespace halfspace::oracle {
namespace {

std::size_t coefficients(HalfSpaceKind kind) { return kind == HalfSpaceKind::plane ? 4 : 10; }

// A body or a scissor.
template <typename Box>
void write_box(std::ostream& out, const Box& box) {
  out << ' ' << box.x0 << ' ' << box.y0 << ' ' << box.x1 << ' ' << box.y1 << '\n';
}

template <typename Box>
void read_box(std::istream& in, Box& box) {
  in >> box.x0 >> box.y0 >> box.x1 >> box.y1;
}

void write_half_space(std::ostream& out, const IntegerHalfSpace& h) {
  out << (h.kind == HalfSpaceKind::plane ? "plane" : "quadric") << (h.complement ? "!" : "")
      << (h.transparent ? "t" : "");
  for (std::size_t i = 0; i < coefficients(h.kind); ++i) out << ' ' << h.c[i];
  out << '\n';
}

void read_light(std::istream& in, IntegerLighting& lighting) {
  for (auto& row : lighting.normal_matrix) {
    for (std::int64_t& n : row) in >> n;
  }
  for (std::int64_t& n : lighting.light) in >> n;
  in >> lighting.ambient >> lighting.parallel >> lighting.unit;
}

// The word is "plane" or "quadric" with its marks.
bool read_half_space(std::istream& in, const std::string& word, IntegerHalfSpace& h) {
  const bool plane = word.starts_with("plane");
  if (!plane && !word.starts_with("quadric")) return false;
  const std::string marks = word.substr(plane ? 5 : 7);
  h.kind = plane ? HalfSpaceKind::plane : HalfSpaceKind::quadric;
  h.complement = marks.find('!') != std::string::npos;
  h.transparent = marks.find('t') != std::string::npos;
  for (std::size_t i = 0; i < coefficients(h.kind); ++i) in >> h.c[i];
  return true;
}

}  // namespace

std::string describe(const IntegerScene& scene) {
  std::ostringstream out;
  out << "page " << scene.width << ' ' << scene.height << ' ' << scene.levels;
  write_box(out, scene.scissor);
  out << "light";
  for (const auto& row : scene.lighting.normal_matrix) {
    for (const std::int64_t n : row) out << ' ' << n;
  }
  for (const std::int64_t n : scene.lighting.light) out << ' ' << n;
  out << ' ' << scene.lighting.ambient << ' ' << scene.lighting.parallel << ' ' << scene.lighting.unit << '\n';
  for (const IntegerBody& body : scene.bodies) {
    out << "body " << body.origin[0] << ' ' << body.origin[1] << ' ' << body.origin[2];
    write_box(out, body);
    for (const IntegerHalfSpace& h : body.half_spaces) write_half_space(out, h);
  }
  return out.str();
}

std::optional<IntegerScene> parse_description(const std::string& text) {
  std::istringstream in(text);
  IntegerScene scene;
  std::string word;
  while (in >> word) {
    if (word == "page") {
      in >> scene.width >> scene.height >> scene.levels;
      read_box(in, scene.scissor);
    } else if (word == "light") {
      read_light(in, scene.lighting);
    } else if (word == "body") {
      IntegerBody& body = scene.bodies.emplace_back();
      in >> body.origin[0] >> body.origin[1] >> body.origin[2];
      read_box(in, body);
    } else {
      if (scene.bodies.empty()) return std::nullopt;
      if (!read_half_space(in, word, scene.bodies.back().half_spaces.emplace_back())) return std::nullopt;
    }
    if (in.fail()) return std::nullopt;
  }
  return scene;
}

}  // namespace halfspace::oracle
