// token_stream.hpp - one file's tokens with one token in hand: expect, report, recover.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host/scene/diagnostic_log.hpp"
#include "host/scene/scene.hpp"
#include "host/scene/tokeniser.hpp"

namespace halfspace {

class TokenStream {
 public:
  // The log, the file's name and the text must outlive the stream.
  TokenStream(const std::string& file, std::string_view text, DiagnosticLog& log);

  [[nodiscard]] const Token& current() const { return current_; }
  [[nodiscard]] bool at(TokenKind kind) const { return current_.kind == kind; }
  [[nodiscard]] bool at_symbol(char symbol) const;
  [[nodiscard]] bool at_statement_word() const;
  // At a statement word that starts a line: what came before was not ended.
  [[nodiscard]] bool at_next_statement() const { return at_line_start() && at_statement_word(); }
  [[nodiscard]] bool at_number() const;  // also at "nan" and the like, which take_number() refuses
  [[nodiscard]] SourcePosition position_of(const Token& token) const { return {file_, token.line, token.column}; }
  [[nodiscard]] SourcePosition position() const { return position_of(current_); }
  const Token& take();  // which stays until the next

  // True when the text ends in an open comment: what should have followed is unknown, and not an error.
  [[nodiscard]] bool truncated() const { return truncated_; }

  // Reports "expected WHAT, found ...REMEDY" at the token in hand; always false.
  bool fail_expected(std::string_view what, std::string_view remedy = "");

  // An id, if there is one; `id` stays empty otherwise. False after an error.
  [[nodiscard]] bool take_optional_id(std::string& id);
  // An id that must be there; `what` is what it names.
  [[nodiscard]] bool take_id(std::string_view what, std::string& id);

  // A wrong number is reported and counts as 0, so that the rest of the statement is still read.
  Number take_number();
  // Exactly `count` numbers; `owner` and `meaning` name them in the error. False if their count is wrong.
  [[nodiscard]] bool take_numbers(std::size_t count, std::string_view owner, std::string_view meaning,
                                  std::vector<Number>& numbers);

  // '<' or '(': gives the symbol that closes it, or 0 after an error.
  [[nodiscard]] char take_opening();
  [[nodiscard]] bool take_closing(char symbol, std::string_view otherwise);

  // The ';' of a statement. Where it is missing, goes to the next statement.
  void end_statement();
  // After an error: past the next ';', or to a statement word that starts a line.
  void skip_statement();

 private:
  void advance();
  bool fail(const std::string& message);
  [[nodiscard]] bool at_line_start() const { return current_.line > previous_.line; }

  const std::string& file_;
  DiagnosticLog& log_;
  Tokeniser tokeniser_;
  Token previous_;
  Token current_;
  bool truncated_ = false;
};

}  // namespace halfspace
