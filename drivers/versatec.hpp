// versatec.hpp - Versatec electrostatic plotter, 36 inches: 7040 dots of 1/200 inch, 880 bytes a line.
//   page: reset, clear, mode plot, lines, mode print, 5 new lines and NUL, end of transmission
// The new lines bring the last lines past the toner, as the UNIX filters did; end of transmission then feeds
// the picture out, as the UNIX driver did on close. NUL makes the count even for plotters that transfer
// words. A fault leaves nothing behind: reset and clear empty the line begun.
#pragma once

#include "drivers/plotter_driver.hpp"

namespace halfspace {

inline constexpr DeviceTraits versatec_traits{.name = "versatec",
                                              .width = 7040,
                                              .height = 2200,
                                              .max_width = 7040,
                                              .max_height = 32767,
                                              .dots_per_inch = 200,
                                              .preferred_band_rows = 16};
inline constexpr std::size_t versatec_line_bytes = 880;

class VersatecDriver final : public PlotterDriver {
 public:
  VersatecDriver(PlotterPort& port, Clock& clock) : PlotterDriver(versatec_traits, versatec_line_bytes, port, clock) {}

 private:
  DeviceStatus start() override;
  DeviceStatus finish() override;
  DeviceStatus recover() override;
};

}  // namespace halfspace
