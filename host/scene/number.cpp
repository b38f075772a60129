#include "host/scene/number.hpp"

#include <charconv>
#include <cmath>

#include "host/scene/quote.hpp"

namespace halfspace {
namespace {

constexpr std::size_t longest_text = 400;
constexpr double smallest = 1e-308;
constexpr double largest = 1e308;

bool all_digits_zero(std::string_view text) {
  const std::string_view mantissa = text.substr(0, text.find_first_of("eE"));
  return mantissa.find_first_of("123456789") == std::string_view::npos;
}

bool is_hexadecimal(std::string_view text) {
  if (text.starts_with('-')) text.remove_prefix(1);
  return text.starts_with("0x") || text.starts_with("0X");
}

// std::from_chars also reads "nan" and "inf".
bool starts_as_decimal(std::string_view text) {
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  return !text.empty() && (text[0] == '.' || (text[0] >= '0' && text[0] <= '9'));
}

std::string not_a_decimal(std::string_view text) {
  if (is_hexadecimal(text)) return quote(text) + " is hexadecimal; write a decimal such as 31";
  return quote(text) + " is not a number; write a finite decimal such as -1.5 or 2e3";
}

}  // namespace

std::variant<Number, std::string> read_number(std::string_view text) {
  const std::string_view written = text;
  if (!starts_as_decimal(text)) return not_a_decimal(written);
  if (text.starts_with('+')) text.remove_prefix(1);
  if (text.size() > longest_text) return quote(written) + " is too long; a number has at most 400 characters";

  double value = 0;
  const auto [rest, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status == std::errc::invalid_argument || rest != text.data() + text.size()) return not_a_decimal(written);
  if (value == 0 && all_digits_zero(text)) return Number{"0", 0.0};
  const double magnitude = std::abs(value);
  if (status == std::errc::result_out_of_range || magnitude < smallest || magnitude > largest) {
    return quote(written) + " is out of range; write 0, or a magnitude from 1e-308 to 1e308";
  }
  return Number{std::string(text), value};
}

}  // namespace halfspace
