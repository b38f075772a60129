// varian.hpp - Benson-Varian electrostatic plotter: 2112 dots of 1/200 inch, 264 bytes a line.
//   page: mode plot, auto step, lines, mode print, form feed and NUL
// Auto step must follow the mode: setting the mode forgets it, and without it the paper stands still. NUL
// fills the word that carries the form feed: an odd last byte would be lost. This plotter has no reset: after
// a fault the line begun is filled with blank dots, then the form is fed.
#pragma once

#include "drivers/plotter_driver.hpp"

namespace halfspace {

inline constexpr DeviceTraits varian_traits{.name = "varian",
                                            .width = 2112,
                                            .height = 2200,
                                            .max_width = 2112,
                                            .max_height = 32767,
                                            .dots_per_inch = 200,
                                            .preferred_band_rows = 32};
inline constexpr std::size_t varian_line_bytes = 264;

class VarianDriver final : public PlotterDriver {
 public:
  VarianDriver(PlotterPort& port, Clock& clock) : PlotterDriver(varian_traits, varian_line_bytes, port, clock) {}

 private:
  DeviceStatus start() override;
  DeviceStatus finish() override;
  DeviceStatus recover() override;
};

}  // namespace halfspace
