// instructions.hpp - instructions that the core executes for a job, counted by callgrind.
// Counted Everything inside halfspace::draw, from the job's header to the last scan line; not what becomes of its bands.
// Method  One valgrind runs this very program again (`halfspace report --probe LIST`), which draws each job of the list between
//         marks (callgrind_toggle.hpp) and dumps the count after each.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host/report/subject.hpp"

namespace halfspace {

struct CountedJob {
  const JobResult* job = nullptr;
  const ListedShader* shader = nullptr;
};

// One count a job; empty where valgrind is missing or fails, which `why` then tells.
[[nodiscard]] std::vector<std::uint64_t> count_instructions(const std::vector<CountedJob>& jobs, std::string& why);

// The other end: what the counted program does.
void draw_probes(const std::string& list);

}  // namespace halfspace
