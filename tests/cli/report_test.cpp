// report_test.cpp - `halfspace report`: folders that are refused.
#include "tests/cli/cli_fixture.hpp"

namespace halfspace::testing {
namespace {

using Report = CommandLine;

TEST_F(Report, FileAsFolder) {
  write("report", "");
  expect_refusal(halfspace({"report", "--quick", "-o", "report"}), 3, {"report: is no folder", "-o"}, {"report"});
}

TEST_F(Report, FolderWithoutPermission) {
  std::filesystem::create_directory(folder_ / "closed");
  std::filesystem::permissions(folder_ / "closed", std::filesystem::perms::none);
  const Outcome outcome =
      run({.arguments = {"report", "--quick", "-o", "closed"}, .folder = folder_ / ".", .obeys_permissions = true});
  std::filesystem::permissions(folder_ / "closed", std::filesystem::perms::owner_all);
  expect_refusal(outcome, 3, {"closed: cannot be written", "-o"}, {"closed"});
}

}  // namespace
}  // namespace halfspace::testing
