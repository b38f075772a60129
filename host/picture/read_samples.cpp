#include "host/picture/read_samples.hpp"

#include <OpenImageIO/imageio.h>

#include <stdexcept>

namespace halfspace {

// Read as 16 bits: those of 8 come widened, by 257.
Samples read_samples(const std::string& path) {
  const auto in = OIIO::ImageInput::open(path);
  if (!in) throw std::runtime_error(path + ": cannot be read as a picture: " + OIIO::geterror());
  const OIIO::ImageSpec& spec = in->spec();
  const auto channels = static_cast<std::size_t>(spec.nchannels);
  std::vector<std::uint16_t> all(spec.image_pixels() * channels);
  if (!in->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UINT16, all.data())) {
    throw std::runtime_error(path + ": cannot be read as a picture: " + in->geterror());
  }
  const bool widened = spec.format == OIIO::TypeDesc::UINT8;
  Samples samples{spec.width, spec.height, static_cast<std::uint16_t>(widened ? 255 : 65535), {}};
  for (std::size_t i = 0; i < all.size(); i += channels) {
    samples.values.push_back(static_cast<std::uint16_t>(widened ? all[i] / 257 : all[i]));
  }
  return samples;
}

}  // namespace halfspace
