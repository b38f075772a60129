// bad_job_test.cpp - files that are no job, or one no longer: refused with the reason, and no picture left.
#include <sys/stat.h>

#include <functional>
#include <random>

#include "tests/cli/cli_fixture.hpp"
#include "tests/sanitized.hpp"

namespace halfspace::testing {
namespace {

using Arguments = std::vector<std::string>;

const std::string crossing = HALFSPACE_SOURCE_DIR "/scenes/crossing.uq";

class BadJobs : public CommandLine {
 protected:
  // The bytes of a whole job, of which no file is left.
  [[nodiscard]] std::string compiled(const std::string& scene) const {
    const Outcome outcome = halfspace({"compile", scene, "--size", "64x48", "-o", "-"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome.out;
  }

  void expect_refused_job(const std::string& path, const Arguments& said, const Arguments& before) const {
    expect_refusal(halfspace({"run", path, "-o", "out.png"}), 3, said, before);
    expect_refusal(halfspace({"info", path}), 3, said, before);
  }
};

struct BadJob {
  const char* name;
  std::function<std::string(const std::string&)> damage;
  std::vector<std::string> said;
};
void PrintTo(const BadJob& job, std::ostream* out) { *out << job.name; }

std::string with_version(std::string job, char version) {
  job[3] = version;
  return job;
}

std::vector<BadJob> bad_jobs() {
  return {
      {"Empty", [](const std::string&) { return std::string(); }, {"is empty", "compile"}},
      {"Scene", [](const std::string&) { return ball + view_and_light; }, {"is not a job", "halfspace compile"}},
      {"Start", [](const std::string& job) { return job.substr(0, 3); }, {"is not a job"}},
      {"MagicAlone", [](const std::string& job) { return job.substr(0, 4); }, {"ends within its header"}},
      {"HalfAHeader", [](const std::string& job) { return job.substr(0, 20); }, {"ends within its header"}},
      {"WrongHeader",
       [](const std::string& job) { return job.substr(0, 4) + std::string(400, '\x7f'); },
       {"header is damaged"}},
      {"OlderVersion", [](const std::string& job) { return with_version(job, '2'); }, {"version 2", "draws version 3"}},
      {"NewerVersion", [](const std::string& job) { return with_version(job, '4'); }, {"version 4", "draws version 3"}},
      {"NoVersion",
       [](const std::string& job) { return with_version(job, '\n'); },
       {"version 0x0a", "draws version 3"}},
      {"HalfAJob", [](const std::string& job) { return job.substr(0, job.size() / 2); }, {"ends early", "scan line"}},
      {"WithoutItsEnd", [](const std::string& job) { return job.substr(0, job.size() - 1); }, {"ends early"}},
      {"TrailingByte", [](const std::string& job) { return job + '\0'; }, {"bytes follow the job's end"}},
      {"TwoJobs", [](const std::string& job) { return job + job; }, {"bytes follow the job's end"}},
      {"UnknownRecord",
       [](const std::string& job) { return job.substr(0, job.size() - 1) + "\x63\x01\x01"; },
       {"the job is damaged", "scan line"}},
  };
}

class BadJobTest : public BadJobs, public ::testing::WithParamInterface<BadJob> {};

TEST_P(BadJobTest, IsRefusedAndKeepsAnOlderPicture) {
  write("a.hsj", GetParam().damage(compiled(crossing)));
  write("out.png", "precious");
  Arguments said = GetParam().said;
  said.emplace_back("a.hsj: error: ");
  expect_refused_job("a.hsj", said, {"a.hsj", "out.png"});
  EXPECT_EQ(folder_.read("out.png").size(), 8U);
}

INSTANTIATE_TEST_SUITE_P(Table, BadJobTest, ::testing::ValuesIn(bad_jobs()),
                         [](const auto& table) { return std::string(table.param.name); });

TEST_F(BadJobs, CannotBeRead) {
  expect_refused_job("none.hsj", {"none.hsj: error: ", "No such file", "check its name"}, {});
  expect_refusal(halfspace({"run", "/proc/self/mem", "-o", "out.png"}), 3, {"/proc/self/mem: error: "}, {});
  expect_refusal(halfspace({"run", "/dev/zero", "-o", "out.png"}), 3, {"/dev/zero: error: is not a job"}, {});
  std::filesystem::create_directory(folder_ / "a.hsj");
  expect_refused_job("a.hsj", {"a.hsj: error: is a folder", "name a job file"}, {"a.hsj"});
}

TEST_F(BadJobs, WithoutPermission) {
  write("a.hsj", compiled(tube));
  ASSERT_EQ(::chmod((folder_ / "a.hsj").c_str(), 0), 0);
  for (const Arguments& command : {Arguments{"run", "a.hsj", "-o", "out.png"}, Arguments{"info", "a.hsj"}}) {
    expect_refusal(run({.arguments = command, .folder = folder_ / ".", .obeys_permissions = true}), 3,
                   {"a.hsj: error: ", "Permission denied"}, {"a.hsj"});
  }
}

TEST_F(BadJobs, FromStandardInput) {
  const Outcome outcome = run({.arguments = {"run", "-", "-o", "out.png"}, .folder = folder_ / "."});
  expect_refusal(outcome, 3, {"<standard input>: error: is empty"}, {});
}

// A child takes a fifth of a second to start; tests/core damages jobs by the thousand.
constexpr int samples = testing::sanitized ? 8 : 16;

TEST_F(BadJobs, CutAnywhereAreRefused) {
  const std::string job = compiled(crossing);
  std::mt19937_64 random(1);
  for (int i = 0; i < samples; ++i) {
    const std::size_t kept = random() % job.size();
    SCOPED_TRACE(kept);
    write("a.hsj", job.substr(0, kept));
    expect_refusal(halfspace({"run", "a.hsj", "-o", "out.png"}), 3, {"a.hsj: error: "}, {"a.hsj"});
  }
}

// A changed byte may leave a job, of another picture; never a crash, and a picture only where all went well.
TEST_F(BadJobs, ChangedAnywhereAreDrawnOrRefused) {
  const std::string job = compiled(crossing);
  std::mt19937_64 random(2);
  int refused = 0;
  for (int i = 0; i < 2 * samples; ++i) {
    std::string changed = job;
    const std::size_t at = random() % job.size();
    const char value = changed[at] = static_cast<char>(random());
    SCOPED_TRACE("byte " + std::to_string(at) + " is " + std::to_string(value));
    write("a.hsj", changed);
    const Outcome outcome = halfspace({"run", "a.hsj", "-o", "out.prn"});
    EXPECT_EQ(outcome.signal, 0);
    EXPECT_TRUE(outcome.status == 0 || outcome.status == 2 || outcome.status == 3 || outcome.status == 4)
        << outcome.status << outcome.err;
    EXPECT_EQ(outcome.status == 0, outcome.err.empty()) << outcome.err;
    EXPECT_EQ(std::filesystem::exists(folder_ / "out.prn"), outcome.status == 0);
    EXPECT_EQ(std::filesystem::remove(folder_ / "out.prn"), outcome.status == 0);
    refused += outcome.status == 0 ? 0 : 1;
  }
  EXPECT_GT(refused, samples / 8);
}

}  // namespace
}  // namespace halfspace::testing
