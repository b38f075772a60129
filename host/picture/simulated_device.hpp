// simulated_device.hpp - a driver with the simulated hardware it drives, and what that hardware received.
// Use     make_simulated_device(device, page, dpi); begin_page, put_band*, end_page on device(); then sheet()
// for the
//         picture, raw_bytes() for a .prn file. One page each.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drivers/device_table.hpp"
#include "sim/sheet.hpp"
#include "sim/simulated_clock.hpp"

namespace halfspace {

struct ReceivedPage {
  std::optional<PaperSheet> sheet;  // width x height of the page, without feeds and margins
  std::string error;                // why there is none: what the hardware objects to, and where in its bytes
};

class SimulatedDevice {
 public:
  SimulatedDevice() = default;
  SimulatedDevice(const SimulatedDevice&) = delete;
  SimulatedDevice& operator=(const SimulatedDevice&) = delete;
  virtual ~SimulatedDevice() = default;

  [[nodiscard]] virtual RasterDevice& device() = 0;
  [[nodiscard]] virtual ReceivedPage sheet() = 0;
  // docs/devices.md says what they are for each device.
  [[nodiscard]] virtual std::vector<std::uint8_t> raw_bytes() = 0;
  [[nodiscard]] Clock& clock() { return clock_; }

 protected:
  SimulatedClock clock_;
};

// page: what will be drawn; the device checks it at begin_page.
[[nodiscard]] std::unique_ptr<SimulatedDevice> make_simulated_device(const KnownDevice& device, const Page& page,
                                                                     std::int32_t dpi);

// Why OUT's name will not do, before anything is drawn: an unknown ending, or .pbm of a gray device.
[[nodiscard]] std::optional<std::string> check_output_name(const std::string& path, const DeviceTraits& traits);

// Does what is written under OUT's name record a density?
[[nodiscard]] bool holds_density(const std::string& path, const KnownDevice& device);

// The finished page under OUT's name: a picture, or for .prn .pwg .txt, "-" and what is not a file the raw
// bytes.
[[nodiscard]] std::optional<std::string> write_output(SimulatedDevice& device, std::int32_t dpi,
                                                      const std::string& path);

}  // namespace halfspace
