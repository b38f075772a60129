#include "host/scene/view_reader.hpp"

#include <algorithm>

#include "host/scene/keywords.hpp"
#include "host/scene/quote.hpp"

namespace halfspace {
namespace {

class ViewReader {
 public:
  ViewReader(TokenStream& tokens, DiagnosticLog& log, std::vector<ViewParameter>& parameters)
      : tokens_(tokens), log_(log), parameters_(parameters) {}

  bool read_parameter() {
    const std::string_view word = tokens_.at(TokenKind::word) ? tokens_.current().text : "";
    const ViewKeyRule* rule = find_view_key(word);
    if (rule == nullptr) {
      const std::vector<std::string_view> words = view_words();
      return tokens_.fail_expected("a view parameter (" + list(words) + ")", did_you_mean(word, words));
    }

    ViewParameter parameter;
    parameter.key = rule->key;
    parameter.position = tokens_.position();
    tokens_.take();
    const int errors_before = log_.errors();
    std::vector<Number> numbers;
    if (!tokens_.take_numbers(rule->numbers, quote(rule->word), rule->meaning, numbers)) return false;
    std::move(numbers.begin(), numbers.end(), parameter.values.begin());
    if (!read_options(*rule, parameter)) return false;
    if (log_.errors() == errors_before) check(*rule, parameter);
    parameters_.push_back(std::move(parameter));
    return true;
  }

 private:
  // Of repeated options the last one holds, as of repeated parameters.
  bool read_options(const ViewKeyRule& rule, ViewParameter& parameter) {
    for (; tokens_.at(TokenKind::option); tokens_.take()) {
      const std::string_view option = tokens_.current().text;
      if (option.size() != 2 || rule.options.find(option[1]) == std::string_view::npos) {
        return tokens_.fail_expected(options_of(rule));
      }
      parameter.option = option_of(option[1]);
    }
    return true;
  }

  static ViewOption option_of(char letter) {
    switch (letter) {
      case 'v':
        return ViewOption::vector;
      case 'p':
        return ViewOption::point;
      case 'a':
        return ViewOption::absolute;
      default:
        return ViewOption::relative;
    }
  }

  static std::string options_of(const ViewKeyRule& rule) {
    if (rule.options.empty()) return "no option after " + quote(rule.word);
    std::string text;
    for (const char letter : rule.options) text += (text.empty() ? "'=" : " or '=") + std::string(1, letter) + "'";
    return text + " after " + quote(rule.word);
  }

  void check(const ViewKeyRule& rule, const ViewParameter& parameter) {
    switch (rule.key) {
      case ViewKey::vpn:
      case ViewKey::vup:
      case ViewKey::dop:
        return check_vector(rule, parameter);
      case ViewKey::whh:
      case ViewKey::whw:
        return check_size(rule, parameter);
      case ViewKey::fbp:
        return check_planes(parameter);
      case ViewKey::vrp:
      case ViewKey::cop:
        return;
    }
  }

  void check_vector(const ViewKeyRule& rule, const ViewParameter& parameter) {
    const bool is_point = parameter.option == ViewOption::point;
    if (!are_equal(parameter.values, is_point ? reference_point() : std::array<Number, 3>{})) return;
    const char* remedy = is_point ? " is the view reference point; choose a point away from vrp"
                                  : " is the zero vector; it needs a direction";
    log_.error(parameter.position, quote(rule.word) + remedy);
  }

  void check_size(const ViewKeyRule& rule, const ViewParameter& parameter) {
    if (parameter.values[0].value > 0) return;
    log_.error(parameter.position,
               quote(rule.word) + " is " + parameter.values[0].text + "; half the size of a window must be above 0");
  }

  void check_planes(const ViewParameter& parameter) {
    if (parameter.values[0].value < parameter.values[1].value) return;
    log_.error(parameter.position, "'fbp' has its front plane at " + parameter.values[0].text +
                                       " and its back plane at " + parameter.values[1].text +
                                       "; the front must be the smaller");
  }

  // The vrp set so far; by default the origin.
  [[nodiscard]] std::array<Number, 3> reference_point() const {
    const auto last = std::find_if(parameters_.rbegin(), parameters_.rend(),
                                   [](const ViewParameter& p) { return p.key == ViewKey::vrp; });
    return last == parameters_.rend() ? std::array<Number, 3>{} : last->values;
  }

  static bool are_equal(const std::array<Number, 3>& a, const std::array<Number, 3>& b) {
    return std::equal(a.begin(), a.end(), b.begin(),
                      [](const Number& m, const Number& n) { return m.value == n.value; });
  }

  TokenStream& tokens_;
  DiagnosticLog& log_;
  std::vector<ViewParameter>& parameters_;
};

}  // namespace

bool read_view_parameters(TokenStream& tokens, DiagnosticLog& log, std::vector<ViewParameter>& parameters) {
  ViewReader reader(tokens, log, parameters);
  do {
    if (!reader.read_parameter()) return false;
  } while (!tokens.at_symbol(';') && !tokens.at(TokenKind::end) && !tokens.at_statement_word());
  return true;
}

}  // namespace halfspace
