// tokeniser.hpp - cuts UniQuadrix text into tokens, skipping white space and nested comments.
// Cost     Linear in the text; no heap; comments nest by a counter, so any depth is safe.
// Errors   None here: what cannot be a token comes out as `stray` or `open_comment`, for the reader to name.
// Source   Ressler 1985, 2.1.1 (ids, white space) and 2.1.8 (comments).
#pragma once

#include <cstdint>
#include <string_view>

namespace halfspace {

enum class TokenKind : std::uint8_t {
  end,           // of the text
  word,          // an id or a keyword: letters, digits, '#', '_'; no digit first
  number,        // starts like a number; read_number() judges the rest
  option,        // '=' and letters, or '=0'; a number may follow at once: "=tx2" is "=tx" and "2"
  symbol,        // one of ; ( ) < > !
  stray,         // bytes that mean nothing here
  open_comment,  // a comment that the text does not close; it reaches to the end
};

struct Token {
  TokenKind kind = TokenKind::end;
  std::string_view text;  // into the text given to the tokeniser
  int line = 1;           // of its first byte, from 1
  int column = 1;         // in bytes, from 1
};

class Tokeniser {
 public:
  // The text must outlive the tokeniser and its tokens.
  explicit Tokeniser(std::string_view text);
  Token next();

 private:
  const char* at_;
  const char* end_;
  int line_ = 1;
  int column_ = 1;
};

}  // namespace halfspace
