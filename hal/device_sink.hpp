// device_sink.hpp - lets the core feed a raster device: the core's bands go straight to put_band.
// Errors  put_band returns false and status() says why; the device has lost its page.
#pragma once

#include "hal/clock.hpp"
#include "hal/raster_device.hpp"

namespace halfspace {

class DeviceSink final : public BandSink {
 public:
  DeviceSink(RasterDevice& device, Clock& clock, std::uint32_t patience_ms)
      : device_(device), clock_(clock), patience_ms_(patience_ms) {}

  [[nodiscard]] DeviceStatus status() const { return status_; }

  bool put_band(const Band& band) override {
    status_ = retry_while_busy(clock_, patience_ms_, [&] { return device_.put_band(band); });
    if (status_ == DeviceStatus::timeout) device_.abort();
    return status_ == DeviceStatus::ok;
  }

 private:
  RasterDevice& device_;
  Clock& clock_;
  std::uint32_t patience_ms_;
  DeviceStatus status_ = DeviceStatus::ok;
};

}  // namespace halfspace
