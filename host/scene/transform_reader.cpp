#include "host/scene/transform_reader.hpp"

#include <optional>
#include <utility>

#include "host/scene/quote.hpp"

namespace halfspace {
namespace {

constexpr std::string_view transform_list =
    "a transform (=tx =ty =tz =ta =sx =sy =sz =sa =rx =ry =rz =vxy =vxz =vyx =vyz =vzx =vzy)";

std::optional<Axis> find_axis(char letter) {
  if (letter < 'x' || letter > 'z') return std::nullopt;
  return static_cast<Axis>(letter - 'x');
}

std::optional<Transform> make_axis_transform(std::string_view key, Number&& number) {
  const std::optional<Axis> axis = find_axis(key[1]);
  if (!axis) return std::nullopt;
  switch (key[0]) {
    case 't':
      return TranslateTransform{*axis, std::move(number)};
    case 's':
      return ScaleTransform{*axis, std::move(number)};
    case 'r':
      return RotateTransform{*axis, std::move(number)};
    default:
      return std::nullopt;
  }
}

std::optional<Transform> make_shear(std::string_view key, Number&& number) {
  const std::optional<Axis> along = find_axis(key[1]);
  const std::optional<Axis> moved = find_axis(key[2]);
  if (key[0] != 'v' || !along || !moved || *along == *moved) return std::nullopt;
  return ShearTransform{*along, *moved, std::move(number)};
}

// `option` starts with '='. Empty when it names no transform.
std::optional<Transform> make_transform(std::string_view option, Number&& number) {
  const std::string_view key = option.substr(1);
  if (key == "ta") return TranslateAllTransform{std::move(number)};
  if (key == "sa") return ScaleAllTransform{std::move(number)};
  if (key.size() == 2) return make_axis_transform(key, std::move(number));
  if (key.size() == 3) return make_shear(key, std::move(number));
  return std::nullopt;
}

bool read_transform(TokenStream& tokens, DiagnosticLog& log, std::vector<Transform>& transforms) {
  if (!make_transform(tokens.current().text, {})) return tokens.fail_expected(transform_list);
  const std::string_view option = tokens.take().text;
  if (!tokens.at_number()) return tokens.fail_expected("a number after " + quote(option));

  const Token written = tokens.current();
  const int errors_before = log.errors();
  Number number = tokens.take_number();
  if (option[1] == 's' && number.value == 0 && log.errors() == errors_before) {
    log.error(tokens.position_of(written),
              "scaling by 0 leaves nothing; write a factor other than 0 after " + quote(option));
  }
  if (transforms.empty()) transforms.reserve(4);
  transforms.push_back(*make_transform(option, std::move(number)));
  return true;
}

}  // namespace

bool read_transforms(TokenStream& tokens, DiagnosticLog& log, std::vector<Transform>& transforms) {
  while (tokens.at(TokenKind::option)) {
    if (!read_transform(tokens, log, transforms)) return false;
  }
  return true;
}

}  // namespace halfspace
