// plotter_driver.hpp - what Versatec and Varian have in common: lines of a fixed number of bytes, sent in
// transfers as large as the port allows, so that the paper need not stop (a starved plotter leaves visible
// gaps). A line may begin in one transfer and end in the next. Range   A page narrower than the plotter is
// padded with blank dots on the right; docs/devices.md. Faults  A lost page is cleared from the plotter at
// once if it answers, otherwise before the next page. Memory  One transfer: 16 KiB. No heap.
#pragma once

#include <array>

#include "drivers/write_all.hpp"
#include "hal/plotter_port.hpp"
#include "hal/raster_device.hpp"

namespace halfspace {

class PlotterDriver : public RasterDevice {
 protected:
  PlotterDriver(const DeviceTraits& traits, std::size_t line_bytes, PlotterPort& port, Clock& clock)
      : RasterDevice(traits), port_(port), clock_(clock), line_bytes_(line_bytes) {}
  ~PlotterDriver() = default;

  DeviceStatus set_mode(PlotterMode mode);
  DeviceStatus function(PlotterFunction function);
  DeviceStatus send_text(std::span<const std::uint8_t> bytes);
  DeviceStatus fill_line();  // with blank dots, if the plotter is within one

 private:
  virtual DeviceStatus start() = 0;    // from whatever state to the first dot
  virtual DeviceStatus finish() = 0;   // after the last line: feed the picture out
  virtual DeviceStatus recover() = 0;  // after a fault, within a line: get rid of the page

  DeviceStatus do_begin_page(const Page& page) final;
  DeviceStatus do_put_band(const Band& band) final;
  DeviceStatus do_end_page() final;
  void do_abort() final;

  DeviceStatus send_dots(std::span<const std::uint8_t> bytes);
  DeviceStatus stage(std::span<const std::uint8_t> bytes);
  DeviceStatus stage_blank(std::size_t count);
  DeviceStatus flush();

  PlotterPort& port_;
  Clock& clock_;
  std::size_t line_bytes_;
  std::size_t line_phase_ = 0;  // bytes of the current line that the plotter has taken
  std::size_t staged_ = 0;
  bool dirty_ = false;  // the plotter holds a page that was not finished
  std::array<std::uint8_t, PlotterPort::transfer_limit> buffer_{};
};

}  // namespace halfspace
