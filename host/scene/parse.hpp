// parse.hpp - UniQuadrix text in, a Scene out, with everything that is wrong with the text at once.
// Limits   A file is at most 64 MB; after 100 errors the rest is not read. docs/language.md is the reference.
// Cost     Linear in the text. The stack does not grow with the text.
#pragma once

#include <span>
#include <string>

#include "host/scene/diagnostic.hpp"
#include "host/scene/scene.hpp"

namespace halfspace {

struct SourceText {
  std::string name;  // as messages show it
  std::string text;
};

struct ParseResult {
  Scene scene;              // keeps scene.hpp's promises when has_errors(diagnostics) is false
  Diagnostics diagnostics;  // in the order of the files and their text
};

// Several files make one scene: an id of one may be used in another. A definition ends in its file.
[[nodiscard]] ParseResult parse_uniquadrix(std::span<const SourceText> files);

}  // namespace halfspace
