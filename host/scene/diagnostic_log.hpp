// diagnostic_log.hpp - collects what is wrong with a scene, and says when it has seen enough.
// Bounds   At most 100 errors and 100 warnings are kept: a binary file by mistake must not fill the screen.
#pragma once

#include <string>
#include <type_traits>
#include <utility>

#include "host/scene/diagnostic.hpp"

namespace halfspace {

class DiagnosticLog {
 public:
  static constexpr int most = 100;

  void error(SourcePosition position, std::string message) {
    add_error({Severity::error, std::move(position), std::move(message)});
  }
  void limit(SourcePosition position, std::string message) {
    add_error({Severity::limit, std::move(position), std::move(message)});
  }
  void warning(const SourcePosition& position, std::string message) {
    warning(position, [&] { return std::move(message); });
  }
  // Of many the message is not needed.
  template <class MakeMessage>
  requires std::is_invocable_v<MakeMessage>
  void warning(const SourcePosition& position, MakeMessage make_message) {
    if (++warnings_ <= most) kept_.push_back({Severity::warning, position, make_message()});
  }

  [[nodiscard]] int errors() const { return errors_; }
  [[nodiscard]] int warnings() const { return warnings_; }
  [[nodiscard]] bool full() const { return errors_ >= most; }  // stop looking for more
  [[nodiscard]] const Diagnostics& kept() const { return kept_; }

 private:
  void add_error(Diagnostic diagnostic) {
    if (!full()) kept_.push_back(std::move(diagnostic));
    ++errors_;
  }

  Diagnostics kept_;
  int errors_ = 0;
  int warnings_ = 0;
};

}  // namespace halfspace
