// write_all.hpp - sends bytes to a sink that takes them piece by piece, never waiting without a deadline.
// Errors  As byte_sink.hpp; timeout once the sink has taken nothing for patience_ms. count is right in every
// case:
//         it says how many bytes went out before the error.
#pragma once

#include <algorithm>

#include "hal/byte_sink.hpp"
#include "hal/clock.hpp"

namespace halfspace {

// A plotter that feeds a whole form, the slowest honest wait, is done in well under this time.
inline constexpr std::uint32_t driver_patience_ms = 10'000;

inline Accepted write_all(ByteSink& sink, Clock& clock, std::span<const std::uint8_t> bytes,
                          std::size_t most_at_once = SIZE_MAX) {
  std::size_t sent = 0;
  while (sent < bytes.size()) {
    const auto piece = bytes.subspan(sent, std::min(bytes.size() - sent, most_at_once));
    const DeviceStatus status = retry_while_busy(clock, driver_patience_ms, [&] {
      const Accepted taken = sink.write(piece);
      sent += taken.count;
      return taken.status == DeviceStatus::ok && taken.count == 0 ? DeviceStatus::busy : taken.status;
    });
    if (status != DeviceStatus::ok) return {status, sent};
  }
  return {DeviceStatus::ok, sent};
}

}  // namespace halfspace
