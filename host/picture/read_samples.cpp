#include "host/picture/read_samples.hpp"

#include <stdexcept>

#include "host/picture/image_codec.hpp"

namespace halfspace {

Samples read_samples(const std::string& path) {
  std::string error;
  const ImageCodec* const codec = image_codec(error);
  const auto samples = codec == nullptr ? std::nullopt : codec->read_samples(path, error);
  if (!samples) throw std::runtime_error(path + ": cannot be read as a picture: " + error);
  return *samples;
}

}  // namespace halfspace
