// image_codec.hpp - what OpenImageIO does for us. It brings some 250 libraries, which take a fifth of a second to link: so
// it is in a module of its own, loaded when a picture first needs it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/picture/picture.hpp"
#include "host/picture/read_samples.hpp"

namespace halfspace {

struct ImageCodec {
  // The file's bytes, `format` its ending; on failure none, and the reason.
  std::vector<std::uint8_t> (*encode)(const Picture& picture, const std::string& format, std::string& error);
  std::optional<Picture> (*read_picture)(const std::string& path);
  std::optional<Samples> (*read_samples)(const std::string& path, std::string& error);
};

// nullptr: the module cannot be loaded, and why.
[[nodiscard]] const ImageCodec* image_codec(std::string& error);

}  // namespace halfspace
