#include "tests/hard/mutate.hpp"

#include <array>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <vector>

namespace halfspace::testing {
namespace {

using oracle::Dice;

template <typename Items>
auto& one_of(Items& items, Dice& dice) {
  return items[static_cast<std::size_t>(dice.below(static_cast<std::int64_t>(items.size())))];
}

std::string written(double n) {
  std::ostringstream out;
  out << std::setprecision(17) << n;
  return out.str();
}

// --- Texts.

std::string without_comments(const std::string& text) {
  std::string kept;
  int depth = 0;
  for (const char c : text) {
    depth += c == '{' ? 1 : 0;
    if (depth == 0) kept += c;
    depth -= c == '}' ? 1 : 0;
  }
  return kept;
}

std::vector<std::string> statements_of(const std::string& text) {
  std::vector<std::string> statements;
  std::istringstream in(without_comments(text));
  for (std::string statement; std::getline(in, statement, ';');) {
    const std::size_t start = statement.find_first_not_of(" \n");
    if (start != std::string::npos) statements.push_back(statement.substr(start));
  }
  return statements;
}

bool is_half_space(const std::string& statement) {
  return statement.starts_with("plane") || statement.starts_with("quadric");
}

double nudged(double n, Dice& dice) {
  static constexpr std::array sizes = {1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5,
                                       1e-4,  .001,  .01,   .1,   1.,   10.,  100., 1e3};
  const double by = one_of(sizes, dice) * (dice.chance(50) ? 1 : -1);
  switch (dice.below(5)) {
    case 0:
      return 0;
    case 1:
      return -n;
    case 2:
      return 2 * n;
    case 3:
      return n * (1 + by / 1000);
    default:
      return n + by;
  }
}

// One number of a half-space, between < and >.
void nudge_number(std::string& statement, Dice& dice) {
  const std::size_t open = statement.find('<');
  std::istringstream in(statement.substr(open + 1, statement.find('>') - open - 1));
  std::vector<double> numbers;
  for (double n = 0; in >> n;) numbers.push_back(n);
  double& number = one_of(numbers, dice);
  number = nudged(number, dice);
  std::string changed = statement.substr(0, open + 1);
  for (const double n : numbers) changed += written(n) + " ";
  statement = changed + ">";
}

std::string id_of(const std::string& statement) {
  std::istringstream in(statement);
  std::string word, id;
  in >> word >> id;
  return id;
}

std::string random_vector(Dice& dice) {
  std::array<std::int64_t, 3> v{};
  while (v == std::array<std::int64_t, 3>{}) v = {dice.between(-4, 4), dice.between(-4, 4), dice.between(-4, 4)};
  std::ostringstream out;
  out << ' ' << v[0] << ' ' << v[1] << ' ' << v[2];
  return out.str();
}

std::string random_transforms(Dice& dice) {
  static constexpr std::array turns = {"=rx ", "=ry ", "=rz "};
  static constexpr std::array angles = {"90", "30", "45", "-17.3", "180", ".0001", "1e-9"};
  static constexpr std::array moves = {"=tx ", "=ty ", "=tz "};
  static constexpr std::array distances = {".1", "-.5", "1", "1e-6", "-2.25", "1000"};
  static constexpr std::array scales = {"=sx ", "=sy ", "=sz ", "=sa ", "=vxy ", "=vzx "};
  static constexpr std::array factors = {"2", ".5", "-1", "1.000001", ".01", "30"};
  const auto of = [&dice](const auto& list) { return std::string(one_of(list, dice)); };
  std::string transforms;
  for (std::int64_t i = dice.below(4); i > 0; --i) {
    const std::int64_t kind = dice.below(10);
    transforms += ' ';
    if (kind < 5) transforms += of(turns) + of(angles);
    if (kind >= 5 && kind < 8) transforms += of(moves) + of(distances);
    if (kind >= 8) transforms += of(scales) + of(factors);
  }
  return transforms;
}

std::string random_view(Dice& dice) {
  std::string view = "view mutated vup .01 1 .02 ";
  if (dice.chance(20)) view += "vpn" + random_vector(dice) + " ";  // oblique, where it does not point to the eye
  view += dice.chance(40) ? "cop" : "dop";
  return view + random_vector(dice) + " whw " + written(std::ldexp(1, static_cast<int>(dice.between(-3, 3)))) +
         " whh 3";
}

// --- Integers.

void nudge(mpz_class& n, Dice& dice) {
  switch (dice.below(6)) {
    case 0:
      n = 0;
      break;
    case 1:
      n = -n;
      break;
    case 2:
      n *= 2;
      break;
    case 3:
      n += dice.chance(50) ? 1 : -1;
      break;
    case 4:
      n += static_cast<long>(dice.between(-1000, 1000));
      break;
    default:
      n *= static_cast<long>(dice.one_of({10, 1000, 1'000'000}));
      break;
  }
}

void mutate_light(IntegerLighting& lighting, Dice& dice) {
  do {
    for (std::int64_t& n : lighting.light) n = dice.between(-9, 9) * (dice.chance(20) ? 1000 : 1);
  } while (lighting.light == std::array<std::int64_t, 3>{});
  lighting.unit = dice.one_of({1, 10, 255, 65536});
  lighting.ambient = dice.between(0, lighting.unit);
  lighting.parallel = dice.between(0, lighting.unit);
}

}  // namespace

std::string mutated_text(const std::string& text, Dice& dice) {
  std::string bodies, rest;
  std::vector<std::string> ids;  // of the half-spaces so far
  for (std::string statement : statements_of(text)) {
    if (is_half_space(statement)) ids.push_back(id_of(statement));
    if (is_half_space(statement) && dice.chance(15)) nudge_number(statement, dice);
    if (statement.starts_with("body") && dice.chance(20)) {
      statement.insert(statement.find(')'), (dice.chance(50) ? " !" : " ") + one_of(ids, dice));
    }
    const bool placed = is_half_space(statement) || statement.starts_with("body");
    (placed ? bodies : rest) += statement + ";\n";
  }
  std::string mutated =
      "definition all;\n" + bodies + "enddef;\ninstance (all" + random_transforms(dice) + ");\n" + rest;
  if (dice.chance(30)) mutated += "light mutated .75" + random_vector(dice) + ";\n";
  if (dice.chance(40)) mutated += random_view(dice) + ";\n";
  return mutated;
}

void mutate(IntegerScene& scene, const IntegerScene& donor, Dice& dice) {
  for (std::int64_t i = dice.between(1, 4); i > 0; --i) {
    IntegerBody& body = one_of(scene.bodies, dice);
    IntegerHalfSpace& half_space = one_of(body.half_spaces, dice);
    switch (dice.below(9)) {
      case 0:
        half_space.complement = !half_space.complement;
        break;
      case 1:
        half_space.transparent = !half_space.transparent;
        break;
      case 2:
        one_of(body.origin, dice) += dice.between(-9, 9);
        break;
      case 3:
        mutate_light(scene.lighting, dice);
        break;
      case 4:
        body.half_spaces.push_back(one_of(one_of(donor.bodies, dice).half_spaces, dice));
        break;
      default: {
        const std::int64_t count = half_space.kind == HalfSpaceKind::plane ? 4 : 10;
        nudge(half_space.c[static_cast<std::size_t>(dice.below(count))], dice);
      }
    }
  }
}

}  // namespace halfspace::testing
