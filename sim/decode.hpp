// decode.hpp - reads back the byte streams that drivers write, strictly: one page, every byte accounted for.
// Errors  A stream that is not exactly what the format says gives no sheet, and the violation with its byte
// offset.
#pragma once

#include <optional>
#include <span>

#include "sim/sheet.hpp"
#include "sim/violation.hpp"

namespace halfspace {

struct Decoded {
  std::optional<PaperSheet> sheet;
  Violation violation;  // when there is no sheet
};

// Binary PGM, P5, maxval at most 255; the levels are maxval + 1.
[[nodiscard]] Decoded decode_pgm(std::span<const std::uint8_t> bytes);

// The spans of drivers/ascii.hpp.
[[nodiscard]] Decoded decode_spans(std::span<const std::uint8_t> bytes);

// Lines of braille cells. The text does not say how many dots of its last column and line belong to the page:
// the caller does, and dots beyond it must not be raised. A raised dot is light: ink bit 0.
[[nodiscard]] Decoded decode_braille(std::span<const std::uint8_t> bytes, std::int32_t width, std::int32_t height);

// PWG Raster, one page of 1-bit black.
[[nodiscard]] Decoded decode_pwg(std::span<const std::uint8_t> bytes);

}  // namespace halfspace
