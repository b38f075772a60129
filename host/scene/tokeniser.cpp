#include "host/scene/tokeniser.hpp"

#include <tao/pegtl.hpp>

namespace halfspace {
namespace {

namespace pegtl = tao::pegtl;

// Comments nest without limit, so the depth is counted: a recursive rule would use up the stack.
struct comment {
  template <typename ParseInput>
  static bool match(ParseInput& in) {
    if (in.empty() || in.peek_char() != '{') return false;
    const std::size_t size = in.size(0);
    std::size_t depth = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const char c = in.peek_char(i);
      if (c == '{') ++depth;
      if (c == '}' && --depth == 0) {
        in.bump(i + 1);
        return true;
      }
    }
    return false;
  }
};

struct gap : pegtl::star<pegtl::sor<pegtl::plus<pegtl::space>, comment>> {};

struct sharp : pegtl::one<'#', '_'> {};
struct word : pegtl::seq<pegtl::sor<pegtl::alpha, sharp>, pegtl::star<pegtl::sor<pegtl::alnum, sharp>>> {};

// Greedy on purpose: "1-2", "0x1f" and "3mm" are one wrong number each rather than two odd tokens.
struct number : pegtl::seq<pegtl::sor<pegtl::digit, pegtl::one<'+', '-', '.'>>,
                           pegtl::star<pegtl::sor<pegtl::alnum, sharp, pegtl::one<'+', '-', '.'>>>> {};

struct option : pegtl::seq<pegtl::one<'='>, pegtl::sor<pegtl::one<'0'>, pegtl::plus<pegtl::alpha>>> {};
struct symbol : pegtl::one<';', '(', ')', '<', '>', '!'> {};
struct open_comment : pegtl::seq<pegtl::one<'{'>, pegtl::star<pegtl::any>> {};

struct meaningful : pegtl::sor<pegtl::space, word, number, option, symbol, pegtl::one<'{', '='>> {};
struct stray : pegtl::sor<pegtl::one<'='>, pegtl::plus<pegtl::not_at<meaningful>, pegtl::any>> {};

struct token : pegtl::sor<word, number, option, symbol, open_comment, stray> {};

template <TokenKind kind>
struct Makes {
  template <typename ActionInput>
  static void apply(const ActionInput& in, Token& made) {
    made.kind = kind;
    made.text = in.string_view();
  }
};

template <typename Rule>
struct Make : pegtl::nothing<Rule> {};
template <>
struct Make<word> : Makes<TokenKind::word> {};
template <>
struct Make<number> : Makes<TokenKind::number> {};
template <>
struct Make<option> : Makes<TokenKind::option> {};
template <>
struct Make<symbol> : Makes<TokenKind::symbol> {};
template <>
struct Make<open_comment> : Makes<TokenKind::open_comment> {};
template <>
struct Make<stray> : Makes<TokenKind::stray> {};

std::string_view without_byte_order_mark(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  return text;
}

}  // namespace

Tokeniser::Tokeniser(std::string_view text)
    : at_(without_byte_order_mark(text).data()), end_(text.data() + text.size()) {}

Token Tokeniser::next() {
  pegtl::memory_input<> in(at_, end_, "", 0, static_cast<std::size_t>(line_), static_cast<std::size_t>(column_));
  pegtl::parse<gap>(in);
  Token made;
  made.line = static_cast<int>(in.line());
  made.column = static_cast<int>(in.column());
  pegtl::parse<token, Make>(in, made);
  at_ = in.current();
  line_ = static_cast<int>(in.line());
  column_ = static_cast<int>(in.column());
  return made;
}

}  // namespace halfspace
