#include "host/report/instructions.hpp"

#include <valgrind/callgrind.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "firmware/core/memory_source.hpp"
#include "host/report/child.hpp"
#include "host/report/files.hpp"

namespace halfspace {
namespace {

std::string write_jobs(const std::vector<CountedJob>& jobs, const ReportScratch& scratch) {
  std::ostringstream list;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    const auto& bytes = jobs[i].job->bytes;
    const std::string path = scratch / ("job" + std::to_string(i));
    write_file(path, {bytes.begin(), bytes.end()});
    list << jobs[i].shader - listed_shaders.data() << ' ' << path << '\n';
  }
  std::string path = scratch / "list";
  write_file(path, list.str());
  return path;
}

// Of a dump: the line "totals: N".
std::uint64_t total_of(const std::string& path) {
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("totals: ")) return std::stoull(line.substr(8));
  }
  throw std::runtime_error(path + ": callgrind wrote no total");
}

JobResult read_job(const std::string& path) {
  JobResult job;
  const std::string bytes = read_file(path);
  job.bytes.assign(bytes.begin(), bytes.end());
  MemorySource source(job.bytes);
  JobReader reader(source);
  if (!read_header(reader, job.header)) throw std::runtime_error(path + ": is no job");
  return job;
}

}  // namespace

std::vector<std::uint64_t> count_instructions(const std::vector<CountedJob>& jobs, std::string& why) {
  if (!has_program("valgrind")) {
    why = "valgrind is missing, so no instructions were counted on this machine: apt-get install valgrind";
    return {};
  }
  const ReportScratch scratch;
  const std::string list = write_jobs(jobs, scratch);
  const std::string self = std::filesystem::read_symlink("/proc/self/exe").string();
  const std::string out = scratch / "out";
  const ChildResult child = run_child({"valgrind", "--tool=callgrind", "--instr-atstart=no", "--collect-atstart=no",
                                       "--callgrind-out-file=" + out, self, "report", "--probe", list});
  if (!child.ok()) {
    why = "valgrind failed, so no instructions were counted: " + child.output.substr(0, 300);
    return {};
  }
  std::vector<std::uint64_t> counts;
  for (std::size_t i = 1; i <= jobs.size(); ++i) counts.push_back(total_of(out + "." + std::to_string(i)));
  return counts;
}

void draw_probes(const std::string& list) {
  std::istringstream lines(read_file(list));
  std::vector<std::uint64_t> memory;
  std::size_t shader = 0;
  CALLGRIND_START_INSTRUMENTATION;  // not before: loading the program's libraries would take most of the time
  for (std::string path; lines >> shader >> path;) {
    draw_job(read_job(path), listed_shaders.at(shader), memory);
    CALLGRIND_DUMP_STATS;
  }
}

}  // namespace halfspace
