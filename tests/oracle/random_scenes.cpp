#include "tests/oracle/random_scenes.hpp"

#include <array>
#include <cstdlib>
#include <iomanip>
#include <sstream>
#include <vector>

#include "tests/oracle/dice.hpp"
#include "tests/oracle/random_bodies.hpp"

namespace halfspace::oracle {
namespace {

// --- Integer scenes.

IntegerLighting random_lighting(Dice& dice) {
  IntegerLighting lighting;
  const bool plain = dice.chance(50);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      lighting.normal_matrix[row][column] = plain ? (row == column ? 1 : 0) : dice.between(-9, 9);
    }
  }
  while (lighting.light == std::array<std::int64_t, 3>{}) {
    lighting.light = {dice.between(-3, 3), dice.between(-3, 3), dice.between(-3, 3)};
  }
  lighting.unit = dice.one_of({1, 10, 64, 65536});
  lighting.ambient = dice.between(0, lighting.unit) / 2;
  lighting.parallel = dice.between(0, lighting.unit);
  return lighting;
}

IntegerBody integer_body(const RandomBody& body, const std::array<std::int64_t, 3>& origin, int size) {
  IntegerBody result;
  result.origin = origin;
  result.x1 = result.y1 = size - 1;
  for (const RandomHalfSpace& h : body) {
    IntegerHalfSpace& to = result.half_spaces.emplace_back();
    to.kind = h.quadric ? HalfSpaceKind::quadric : HalfSpaceKind::plane;
    to.complement = h.complement;
    to.transparent = h.transparent;
    for (std::size_t i = 0; i < h.c.size(); ++i) to.c[i] = h.c[i];
  }
  return result;
}

// --- Texts.

// A whole number, moved by some billionths.
std::string decimal(std::int64_t whole, std::int64_t billionths = 0) {
  const std::int64_t scaled = whole * 1'000'000'000 + billionths;
  std::ostringstream out;
  out << (scaled < 0 ? "-" : "") << std::abs(scaled) / 1'000'000'000;
  const std::int64_t fraction = std::abs(scaled) % 1'000'000'000;
  if (fraction != 0) out << "." << std::setw(9) << std::setfill('0') << fraction;
  return out.str();
}

std::string thousandths(std::int64_t n) { return decimal(0, n * 1'000'000); }

std::string vector_text(const Point& v) {
  std::ostringstream out;
  out << v[0] << " " << v[1] << " " << v[2];
  return out.str();
}

Point random_direction(Dice& dice) {
  Point v{};
  while (v == Point{}) v = {dice.between(-5, 5), dice.between(-5, 5), dice.between(-5, 5)};
  return v;
}

std::int64_t random_billionths(Dice& dice) {
  const std::int64_t size = dice.one_of({1, 10, 1'000, 100'000, 1'000'000});
  return dice.chance(50) ? size : -size;
}

std::string half_space_text(Dice& dice, const RandomHalfSpace& h, const std::string& id, bool moved) {
  const std::int64_t count = h.quadric ? 10 : 4;
  const std::int64_t place = h.quadric ? 9 : dice.below(count);  // shells whose constants alone move stay apart
  std::ostringstream out;
  out << (h.quadric ? "quadric " : "plane ") << id << " <";
  for (std::int64_t i = 0; i < count; ++i) {
    out << (i > 0 ? " " : "") << decimal(h.c[i], moved && i == place ? random_billionths(dice) : 0);
  }
  out << ">" << (h.transparent ? " =t" : "") << ";\n";
  return out.str();
}

std::string body_text(Dice& dice, const RandomBody& body, const std::string& id) {
  const bool moved = dice.chance(40);
  std::ostringstream surfaces, list;
  for (std::size_t i = 0; i < body.size(); ++i) {
    std::string name = id;
    name.append("_").append(std::to_string(i));
    surfaces << half_space_text(dice, body[i], name, moved && dice.chance(50));
    list << (i > 0 ? " " : "") << (body[i].complement ? "!" : "") << name;
  }
  surfaces << "body " << id << " (" << list.str() << ");\n";
  return surfaces.str();
}

char random_axis(Dice& dice) { return "xyz"[dice.below(3)]; }

void write_transform(Dice& dice, std::ostream& out) {
  const std::int64_t kind = dice.below(100);
  if (kind < 45) {
    const std::int64_t any = dice.between(-180, 180);
    out << " =r" << random_axis(dice) << " " << dice.one_of({30, 45, 90, 180, -90, 60, any, any});
  } else if (kind < 65) {
    const std::int64_t any = dice.between(-1500, 1500);
    out << " =t" << random_axis(dice) << " " << thousandths(dice.one_of({-1000, 500, 1000, any}));
  } else if (kind < 80) {
    const std::int64_t any = dice.between(300, 1900);
    out << " =s" << random_axis(dice) << " " << thousandths(dice.one_of({-1000, 500, 2000, any}));
  } else if (kind < 90) {
    const std::int64_t any = dice.between(400, 1600);
    out << " =sa " << thousandths(dice.one_of({500, 1500, any}));
  } else {
    static constexpr const char* pairs[] = {"xy", "xz", "yx", "yz", "zx", "zy"};
    out << " =v" << pairs[dice.below(6)] << " " << thousandths(dice.between(-800, 800));
  }
}

std::string random_transforms(Dice& dice) {
  std::ostringstream out;
  for (std::int64_t n = dice.between(0, 3); n > 0; --n) write_transform(dice, out);
  return out.str();
}

// The body as it stands, or by an instance or (when it is the only one) an array of its definition.
std::string placed(Dice& dice, const std::string& body, const std::string& id, bool alone) {
  if (dice.chance(25)) return body;
  std::ostringstream out;
  out << "definition d" << id << ";\n" << body << "enddef;\n";
  if (alone && dice.chance(25)) {
    out << "array (d" << id << random_transforms(dice) << ") " << dice.between(2, 3) << " =t" << random_axis(dice)
        << " 1.5 =rz " << dice.one_of({0, 20, 120}) << ";\n";
  } else {
    out << "instance (d" << id << random_transforms(dice) << ");\n";
  }
  return out.str();
}

std::string random_lights(Dice& dice) {
  std::ostringstream out;
  if (dice.chance(60)) out << "light ." << dice.between(0, 6) << ";\n";
  if (dice.chance(20)) out << "light .05;\n";
  for (std::int64_t n = dice.one_of({0, 1, 1, 1, 2}); n > 0; --n) {
    out << "light " << thousandths(dice.between(1, 1000)) << " " << vector_text(random_direction(dice)) << ";\n";
  }
  return out.str();
}

bool along_y(const Point& v) { return v[0] == 0 && v[2] == 0; }

// Numerators of the view's normal: the direction to the eye turned round, and a little aside.
Point tilted(Dice& dice, const Point& to_eye, std::int64_t most) {
  Point result;
  for (int i = 0; i < 3; ++i) result[i] = -4 * to_eye[i] + dice.between(-most, most);
  return result;
}

// Along an axis, in any direction, oblique (up to some 45 degrees) or in perspective.
void write_projection(Dice& dice, std::ostream& out) {
  Point to_eye{};
  if (dice.chance(40)) {
    to_eye[dice.below(3)] = dice.chance(50) ? 1 : -1;
  } else {
    to_eye = random_direction(dice);
  }
  Point normal = tilted(dice, to_eye, 0);
  const std::int64_t kind = dice.below(100);
  if (kind < 45) {
    out << " dop " << vector_text(to_eye);
  } else if (kind < 65) {
    normal = tilted(dice, to_eye, 2);
    out << " dop " << vector_text(to_eye) << " vpn " << vector_text(normal);
  } else {
    const std::int64_t far = dice.one_of({1, 2, 4, 8});
    out << " cop " << vector_text({far * to_eye[0], far * to_eye[1], far * to_eye[2]});
    if (dice.chance(30)) {
      normal = tilted(dice, to_eye, 1);
      out << " vpn " << vector_text(normal);
    }
  }
  if (along_y(normal)) {
    out << " vup 1 0 0";
  } else if (dice.chance(20)) {
    out << " vup " << -normal[2] << " " << dice.between(-3, 3) << " " << normal[0];
  }
}

std::string random_view_parameters(Dice& dice, bool fitted) {
  std::ostringstream out;
  if (dice.chance(92)) write_projection(dice, out);
  if (!fitted) {
    out << " whw " << thousandths(dice.between(1500, 7000)) << " whh " << thousandths(dice.between(1500, 7000));
    if (dice.chance(15)) {
      out << " fbp " << thousandths(dice.between(-2500, 500)) << " " << thousandths(dice.between(600, 3000));
    }
  }
  return out.str();
}

}  // namespace

std::string random_scene(std::uint64_t seed) {
  Dice dice(seed);
  const bool fitted = dice.chance(10);
  const std::int64_t bodies = dice.between(1, 3);
  std::ostringstream out;
  BodyWish wish{{}, 4, fitted};
  RandomBody body;
  for (std::int64_t n = 0; n < bodies; ++n) {
    if (!dice.chance(40)) wish.centre = {dice.between(-2, 2), dice.between(-2, 2), dice.between(-2, 2)};
    const bool mates = !fitted && n > 0 && dice.chance(20);
    body = mates ? mate_of(dice, body) : random_body(dice, wish);
    std::string id = std::to_string(n);
    id.insert(id.begin(), 'b');
    const std::string text = body_text(dice, body, id);
    out << (mates ? text : placed(dice, text, id, bodies == 1));
  }
  out << random_lights(dice);
  const std::string view = random_view_parameters(dice, fitted);
  if (!view.empty()) out << "view v" << view << ";\n";
  return out.str();
}

std::string random_meeting_scene(std::uint64_t seed) {
  Dice dice(seed);
  std::ostringstream out;
  const std::int64_t bodies = dice.between(1, 2);
  for (std::int64_t n = 0; n < bodies; ++n) {
    const BodyWish wish{{dice.between(-2, 2), dice.between(-2, 2), dice.between(-2, 2)}, 4, true};
    const std::string id = n == 0 ? "a" : "b";
    out << placed(dice, body_text(dice, random_meeting_body(dice, wish), id), id, bodies == 1);
  }
  out << random_lights(dice);
  const std::string view = random_view_parameters(dice, true);
  if (!view.empty()) out << "view v" << view << ";\n";
  return out.str();
}

IntegerScene random_integer_scene(std::uint64_t seed, int size) {
  Dice dice(seed);
  IntegerScene scene;
  scene.width = scene.height = size;
  scene.levels = static_cast<std::int32_t>(dice.one_of({2, 3, 65, 65, 256}));
  scene.scissor = {0, 0, size - 1, size - 1};
  if (dice.chance(10)) scene.scissor = {size / 8, 0, size - 1, size - size / 4};
  scene.lighting = random_lighting(dice);

  std::array<std::int64_t, 3> origin{};
  BodyWish wish{{}, size / 2, false};
  RandomBody body;
  for (std::int64_t n = 0, bodies = dice.between(1, 3); n < bodies; ++n) {
    if (n == 0 || dice.chance(50)) {
      origin = {size / 2 + dice.between(-size, size) / 6, size / 2 + dice.between(-size, size) / 6,
                dice.between(-size, size) / 4};
    }
    if (dice.chance(50)) wish.centre = {dice.between(-3, 3), dice.between(-3, 3), dice.between(-3, 3)};
    body = n > 0 && dice.chance(25) ? mate_of(dice, body) : random_body(dice, wish);
    scene.bodies.push_back(integer_body(body, origin, size));
  }
  return scene;
}

}  // namespace halfspace::oracle
