// statement_reader.hpp - reads the statements of one file into the scene draft.
// Errors   Each is reported where it lies and reading goes on at the next statement, so that one run finds all.
// Source   Ressler 1985, 2.1.
#pragma once

#include <string>
#include <string_view>

#include "host/scene/diagnostic_log.hpp"
#include "host/scene/names.hpp"

namespace halfspace {

void read_statements(const std::string& file, std::string_view text, SceneDraft& draft, DiagnosticLog& log);

}  // namespace halfspace
