#include "host/scene/quote.hpp"

#include <algorithm>
#include <numeric>

namespace halfspace {
namespace {

constexpr std::size_t longest_shown = 40;
constexpr std::size_t most_candidates = 1000;

std::string escape(char c) {
  constexpr std::string_view digits = "0123456789abcdef";
  const auto byte = static_cast<unsigned char>(c);
  if (byte >= 0x20 && byte < 0x7f) return std::string(1, c);
  return std::string("\\x") + digits[byte >> 4] + digits[byte & 15];
}

// Levenshtein's distance: letters to insert, delete or replace.
std::size_t letters_off(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
    }
  }
  return row[b.size()];
}

}  // namespace

std::string quote(std::string_view text) {
  std::string shown = "'";
  for (const char c : text.substr(0, longest_shown)) shown += escape(c);
  return shown + (text.size() > longest_shown ? "...'" : "'");
}

std::string list(const std::vector<std::string_view>& words) {
  std::string text;
  for (const std::string_view word : words) {
    if (!text.empty()) text += ", ";
    text += word;
  }
  return text;
}

std::string did_you_mean(std::string_view written, const std::vector<std::string_view>& candidates) {
  if (written.size() > longest_shown || candidates.size() > most_candidates) return "";
  std::size_t nearest = std::min<std::size_t>(3, written.size());  // a name that shares no letter is no guess
  std::string_view found;
  for (const std::string_view candidate : candidates) {
    if (candidate.size() > longest_shown) continue;
    const std::size_t distance = letters_off(written, candidate);
    const bool first_of_equals = distance == nearest && !found.empty() && candidate < found;
    if (distance < nearest || first_of_equals) {
      nearest = distance;
      found = candidate;
    }
  }
  return found.empty() ? "" : "; did you mean " + quote(found) + "?";
}

}  // namespace halfspace
