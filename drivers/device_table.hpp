// device_table.hpp - every device a command knows, by its name and its synonyms.
#pragma once

#include <array>
#include <string_view>

#include "drivers/ascii.hpp"
#include "drivers/braille.hpp"
#include "drivers/gray.hpp"
#include "drivers/pwg.hpp"
#include "drivers/ssd1306.hpp"
#include "drivers/varian.hpp"
#include "drivers/versatec.hpp"

namespace halfspace {

enum class DeviceKind : std::uint8_t { versatec, varian, gray, ascii, braille, ssd1306, pwg };

struct KnownDevice {
  DeviceKind kind;
  DeviceTraits traits;
  std::array<std::string_view, 4> synonyms;  // unused ones are empty
};

inline constexpr std::array<KnownDevice, 7> known_devices{{
    {DeviceKind::versatec, versatec_traits, {"w", "vp", "ver", "versatek"}},
    {DeviceKind::varian, varian_traits, {"v", "va", "var"}},
    {DeviceKind::gray, gray_traits, {"x", "vx", "vectrix"}},
    {DeviceKind::ascii, ascii_traits, {"a", "file"}},
    {DeviceKind::braille, braille_traits, {}},
    {DeviceKind::ssd1306, ssd1306_traits, {}},
    {DeviceKind::pwg, pwg_traits, {}},
}};

// nullptr: no such device; the caller names those of known_devices.
[[nodiscard]] constexpr const KnownDevice* find_device(std::string_view name) {
  for (const KnownDevice& device : known_devices) {
    if (name == device.traits.name) return &device;
    for (const std::string_view synonym : device.synonyms) {
      if (!synonym.empty() && name == synonym) return &device;
    }
  }
  return nullptr;
}

}  // namespace halfspace
