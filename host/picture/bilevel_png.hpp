// bilevel_png.hpp - a PNG of one bit a dot. OpenImageIO 2.4 writes every PNG with at least 8 bits, so libpng
// does it.
#pragma once

#include <cstdint>
#include <vector>

#include "host/picture/picture.hpp"

namespace halfspace {

// The file's bytes; empty: libpng refused.
[[nodiscard]] std::vector<std::uint8_t> encode_bilevel_png(const Picture& picture);

}  // namespace halfspace
