#include "host/scene/token_stream.hpp"

#include <algorithm>
#include <cctype>
#include <variant>

#include "host/scene/keywords.hpp"
#include "host/scene/number.hpp"
#include "host/scene/quote.hpp"

namespace halfspace {
namespace {

bool is_not_finite(std::string_view word) {
  std::string lower(word.substr(0, 9));
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower == "nan" || lower == "inf" || lower == "infinity";
}

std::string describe(const Token& token) {
  return token.kind == TokenKind::end ? "the end of the file" : quote(token.text);
}

// What people write by habit from other languages.
std::string hint(const Token& token) {
  if (token.kind != TokenKind::stray) return "";
  switch (token.text.front()) {
    case ',':
      return "; white space separates here, not a comma";
    case '}':
      return "; no comment is open here";
    case '=':
      return "; an option is '=' and its letters, with nothing between";
    default:
      return "";
  }
}

}  // namespace

TokenStream::TokenStream(const std::string& file, std::string_view text, DiagnosticLog& log)
    : file_(file), log_(log), tokeniser_(text) {
  advance();
}

bool TokenStream::at_symbol(char symbol) const { return at(TokenKind::symbol) && current_.text.front() == symbol; }

bool TokenStream::at_number() const {
  return at(TokenKind::number) || (at(TokenKind::word) && is_not_finite(current_.text));
}

bool TokenStream::at_statement_word() const { return at(TokenKind::word) && find_statement(current_.text).has_value(); }

void TokenStream::advance() {
  previous_ = current_;
  current_ = tokeniser_.next();
  if (!at(TokenKind::open_comment)) return;
  truncated_ = true;
  log_.error(position(), "this comment is not closed; each '{' in it needs a '}'");
  current_.kind = TokenKind::end;
}

const Token& TokenStream::take() {
  advance();
  return previous_;
}

bool TokenStream::fail_expected(std::string_view what, std::string_view remedy) {
  return fail("expected " + std::string(what) + ", found " + describe(current_) + std::string(remedy));
}

bool TokenStream::fail(const std::string& message) {
  if (truncated_ && at(TokenKind::end)) return false;
  log_.error(position(), message + hint(current_));
  return false;
}

bool TokenStream::take_optional_id(std::string& id) {
  if (at(TokenKind::number)) return fail_expected("an id, which starts with a letter, '#' or '_'");
  return !at(TokenKind::word) || take_id("the rest of the statement", id);
}

bool TokenStream::take_id(std::string_view what, std::string& id) {
  if (!at(TokenKind::word) || at_next_statement()) return fail_expected(what);
  if (is_reserved(current_.text)) {
    log_.error(position(), quote(current_.text) + " is a word of the language; choose another id");
    take();  // else recovery could take it for the next statement
    return false;
  }
  id = take().text;
  return true;
}

Number TokenStream::take_number() {
  const Token& token = take();
  std::variant<Number, std::string> reading = read_number(token.text);
  if (auto* number = std::get_if<Number>(&reading)) return std::move(*number);
  log_.error(position_of(token), std::get<std::string>(reading));
  return {"0", 0.0};
}

bool TokenStream::take_numbers(std::size_t count, std::string_view owner, std::string_view meaning,
                               std::vector<Number>& numbers) {
  while (at_number() && numbers.size() < count) numbers.push_back(take_number());
  if (numbers.size() == count && !at_number()) return true;
  const std::string takes = std::string(owner) + " takes " + std::to_string(count) +
                            (count == 1 ? " number (" : " numbers (") + std::string(meaning) + "), found ";
  if (at_number()) return fail(takes + describe(current_) + " as one more");
  return fail(takes + describe(current_) + " after " + std::to_string(numbers.size()));
}

char TokenStream::take_opening() {
  if (at_symbol('<') || at_symbol('(')) return take().text.front() == '<' ? '>' : ')';
  fail_expected("'<' or '('");
  return 0;
}

bool TokenStream::take_closing(char symbol, std::string_view otherwise) {
  if (!at_symbol(symbol)) return fail_expected(std::string(otherwise) + "'" + symbol + "'");
  take();
  return true;
}

void TokenStream::end_statement() {
  if (at_symbol(';')) {
    take();
  } else if (at_statement_word() || at(TokenKind::end) || at_line_start()) {
    // The place to mend is behind the last token, not where the next statement begins.
    if (truncated_ && at(TokenKind::end)) return;
    const int behind = previous_.column + static_cast<int>(previous_.text.size());
    log_.error({file_, previous_.line, behind}, "the statement has no ';'; write one after " + quote(previous_.text));
    if (!at_statement_word()) skip_statement();
  } else {
    fail_expected("';'");
    skip_statement();
  }
}

void TokenStream::skip_statement() {
  while (!at(TokenKind::end)) {
    if (at_next_statement()) return;
    if (take().text == ";") return;
  }
}

}  // namespace halfspace
