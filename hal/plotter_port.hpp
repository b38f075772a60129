// plotter_port.hpp - an electrostatic plotter as UNIX saw it: modes, remote functions, and bytes without
// framing. Modes   What the next bytes are: text, or dots. The mode set stays until the next set_mode. Lines
// In plot mode the plotter counts bytes: a scan line is full after its fixed number of bytes, whatever the
//         boundaries between writes. The most significant bit is the leftmost dot, 1 = ink.
// Limits  One write is one transfer of at most transfer_limit bytes (the DMA cap of the UNIX drivers), which
// may take
//         only the first of them. A Varian transfers words: bytes come and are taken in even numbers.
// Errors  busy: nothing was taken, make the same call again.
// Source  4.2BSD vcmd.h, vp(4), va(4): VSETSTATE sets a mode or a function; docs/devices.md has the details.
#pragma once

#include "hal/byte_sink.hpp"

namespace halfspace {

enum class PlotterMode : std::uint8_t { print, plot, print_plot };

enum class PlotterFunction : std::uint8_t {
  reset,                // Versatec: stop, forget mode and buffer
  clear,                // Versatec: empty the line buffer; follows a reset
  end_of_transmission,  // Versatec: feed the end of the picture past the toner
  form_feed,            // Versatec: feed to the top of the next form
  terminate,            // Versatec: print the line begun, the rest blank
  auto_step             // Varian: step the paper after each full line; must follow set_mode(plot)
};

class PlotterPort : public ByteSink {
 public:
  static constexpr std::size_t transfer_limit = 16384;  // bytes

  virtual DeviceStatus set_mode(PlotterMode mode) = 0;
  virtual DeviceStatus function(PlotterFunction function) = 0;

 protected:
  ~PlotterPort() = default;
};

}  // namespace halfspace
