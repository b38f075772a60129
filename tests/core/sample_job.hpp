// sample_job.hpp - a small scene made by hand: a sphere, a tilted plane through it, a trough without z^2, and a span.
#pragma once

#include <vector>

#include "firmware/core/engine.hpp"
#include "host/job/job_writer.hpp"

namespace halfspace::testing {

inline constexpr std::int32_t sample_width = 70, sample_height = 60;

[[nodiscard]] JobResult sample_job(DotFormat format);

// The same page, with the sphere's limb as a radical and a quartic arc in several windows.
[[nodiscard]] JobResult guided_job(DotFormat format);

// What a page came to.
struct Drawn {
  DrawResult result;
  std::vector<std::uint8_t> bytes;
  std::vector<Band> bands;  // their bytes are gone
};

class Collector final : public BandSink {
 public:
  explicit Collector(std::size_t most_bands = SIZE_MAX) : most_bands_(most_bands) {}
  bool put_band(const Band& band) override {
    if (bands.size() == most_bands_) return false;
    bands.push_back({band.y, band.rows, {}});
    bytes.insert(bytes.end(), band.bytes.begin(), band.bytes.end());
    return true;
  }
  std::vector<Band> bands;
  std::vector<std::uint8_t> bytes;

 private:
  std::size_t most_bands_;
};

[[nodiscard]] Drawn draw_job(ByteSource& source, std::size_t memory_bytes, const DrawOptions& options = {},
                             std::size_t most_bands = SIZE_MAX, const Modules& modules = all_modules);

}  // namespace halfspace::testing
