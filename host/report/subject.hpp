// subject.hpp - a scene on a page of a certain size: what a report draws again and again.
// Errors  A text that this build refuses is told by `refusal`, and the subject is left out.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host/flatten/integer_scene.hpp"
#include "host/job/job_writer.hpp"
#include "host/report/shader_list.hpp"

namespace halfspace {

struct SceneText {
  std::string suite, name;
  std::string text;
};

struct PageSize {
  std::int32_t width = 0, height = 0, levels = 2;
};

struct Subject {
  SceneText source;
  PageSize size;
  IntegerScene scene;
  JobResult job, empty_job;  // bilevel pages; the second one without bodies
  std::string refusal;
};

[[nodiscard]] Subject make_subject(const SceneText& source, const PageSize& size);

// All that `halfspace render` does before OUT: reading, flattening, resolving, the job and the halftoned page. Returns the
// shaded dots.
std::uint64_t draw_from_text(const SceneText& source, const PageSize& size, const ListedShader& shader);

// The core alone, bands to nowhere. Memory is lent by the caller, who need not pay for it twice.
std::uint64_t draw_job(const JobResult& job, const ListedShader& shader, std::vector<std::uint64_t>& memory);

// FNV-1a, 32 bits, of the page's bytes: what the board prints.
[[nodiscard]] std::uint32_t page_hash(const JobResult& job, const ListedShader& shader);

// The level of every dot, row by row; -1 is background.
[[nodiscard]] std::vector<std::int16_t> drawn_levels(const IntegerScene& scene, const ListedShader& shader);

}  // namespace halfspace
