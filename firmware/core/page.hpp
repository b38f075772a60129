// page.hpp - the words shared by core, hal and drivers: what a page is, what a band is, and the two seams of
// the core. Page   [0, width) x [0, height) dots, (0, 0) the top left one, x right, y down, scan lines in
// output order. Band   Whole scan lines, top to bottom. Bilevel (levels == 2 dots): one bit a dot, leftmost
// dot in the most
//        significant bit, 1 = ink, rows of (width + 7) / 8 bytes, spare bits 0. Gray: one byte a dot, the
//        level 0 (black) .. levels - 1 (white).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace halfspace {

enum class DotFormat : std::uint8_t { bilevel, gray };

inline constexpr std::int32_t largest_side = 32767;

struct Page {
  std::int32_t width = 0;   // dots, 1 .. largest_side
  std::int32_t height = 0;  // dots, 1 .. largest_side
  DotFormat format = DotFormat::bilevel;
  std::int32_t levels = 65;      // shading levels, 2 .. 256
  std::int32_t background = 64;  // level of dots that show no face

  // Bytes of one scan line in a band. Range: 1 .. 32767.
  [[nodiscard]] constexpr std::size_t row_bytes() const {
    return format == DotFormat::bilevel ? (static_cast<std::size_t>(width) + 7) / 8 : static_cast<std::size_t>(width);
  }
};

struct Band {
  std::int32_t y = 0;                   // its first scan line
  std::int32_t rows = 0;                // at least 1
  std::span<const std::uint8_t> bytes;  // rows * row_bytes, lent until the call returns
};

// Where the job's bytes come from: a flash array, a file, a socket.
// Order  Called in sequence, from the core's loop only.
// Errors Returns the bytes delivered, 1 .. into.size(); 0: no more bytes will come (the core reports a short
// job).
class ByteSource {
 public:
  virtual std::size_t read(std::span<std::uint8_t> into) = 0;

 protected:
  ~ByteSource() = default;
};

// Where finished bands go. Returns false to stop the page (the sink has the reason).
class BandSink {
 public:
  virtual bool put_band(const Band& band) = 0;

 protected:
  ~BandSink() = default;
};

}  // namespace halfspace
