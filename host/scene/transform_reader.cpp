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

// Appends a transform whose number is still to be read into what is returned.
Number* append_axis_transform(char kind, Axis axis, std::vector<Transform>& transforms) {
  switch (kind) {
    case 't':
      return &std::get<TranslateTransform>(transforms.emplace_back(TranslateTransform{axis, {}})).distance;
    case 's':
      return &std::get<ScaleTransform>(transforms.emplace_back(ScaleTransform{axis, {}})).factor;
    case 'r':
      return &std::get<RotateTransform>(transforms.emplace_back(RotateTransform{axis, {}})).degrees;
    default:
      return nullptr;
  }
}

Number* append_shear(std::string_view key, std::vector<Transform>& transforms) {
  const std::optional<Axis> along = find_axis(key[1]);
  const std::optional<Axis> moved = find_axis(key[2]);
  if (key[0] != 'v' || !along || !moved || *along == *moved) return nullptr;
  return &std::get<ShearTransform>(transforms.emplace_back(ShearTransform{*along, *moved, {}})).amount;
}

// `option` starts with '='. Null when it names no transform.
Number* append_transform(std::string_view option, std::vector<Transform>& transforms) {
  const std::string_view key = option.substr(1);
  if (key.size() == 3) return append_shear(key, transforms);
  if (key.size() != 2) return nullptr;
  if (const std::optional<Axis> axis = find_axis(key[1])) return append_axis_transform(key[0], *axis, transforms);
  if (key == "ta") {
    return &std::get<TranslateAllTransform>(transforms.emplace_back(TranslateAllTransform{})).distance;
  }
  if (key == "sa") return &std::get<ScaleAllTransform>(transforms.emplace_back(ScaleAllTransform{})).factor;
  return nullptr;
}

bool read_transform(TokenStream& tokens, DiagnosticLog& log, std::vector<Transform>& transforms) {
  if (transforms.empty()) transforms.reserve(4);
  Number* const number = append_transform(tokens.current().text, transforms);
  if (number == nullptr) return tokens.fail_expected(transform_list);
  const std::string_view option = tokens.take().text;
  if (!tokens.at_number()) return tokens.fail_expected("a number after " + quote(option));

  const Token written = tokens.current();
  const int errors_before = log.errors();
  *number = tokens.take_number();
  if (option[1] == 's' && number->value == 0 && log.errors() == errors_before) {
    log.error(tokens.position_of(written),
              "scaling by 0 leaves nothing; write a factor other than 0 after " + quote(option));
  }
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
