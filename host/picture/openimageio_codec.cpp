// openimageio_codec.cpp - the module behind image_codec.hpp.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cmath>

#include "host/picture/image_codec.hpp"

namespace halfspace {
namespace {

// One row as 8 bits a dot.
void expand_row(const Picture& picture, std::int32_t y, std::vector<std::uint8_t>& gray) {
  const std::uint8_t* const row = picture.dots.data() + static_cast<std::size_t>(y) * picture.row_bytes();
  for (std::size_t x = 0; x < gray.size(); ++x) {
    gray[x] = picture.bits == 8 ? row[x] : (row[x / 8] >> (7 - x % 8) & 1) != 0 ? 0 : 255;
  }
}

OIIO::ImageSpec describe(const Picture& picture, const std::string& format) {
  const auto type = format == ".exr" ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::UINT8;
  OIIO::ImageSpec spec(picture.width, picture.height, 1, type);
  if (picture.bits == 1 && format.starts_with(".tif")) spec.attribute("oiio:BitsPerSample", 1);
  spec.attribute("XResolution", static_cast<float>(picture.dpi));
  spec.attribute("YResolution", static_cast<float>(picture.dpi));
  spec.attribute("ResolutionUnit", "in");
  spec.attribute("DateTime", "    :  :     :  :  ");  // Exif's "unknown": the same page is the same file tomorrow
  return spec;
}

// The file's bytes; on failure none, and the reason.
std::vector<std::uint8_t> encode(const Picture& picture, const std::string& format, std::string& error) {
  std::vector<unsigned char> file;
  OIIO::Filesystem::IOVecOutput into(file);
  const std::string name = "picture" + format;
  const auto out = OIIO::ImageOutput::create(name, &into);
  bool written = out && out->open(name, describe(picture, format));
  std::vector<std::uint8_t> gray(static_cast<std::size_t>(picture.width));
  for (std::int32_t y = 0; written && y < picture.height; ++y) {
    expand_row(picture, y, gray);
    written = out->write_scanline(y, 0, OIIO::TypeDesc::UINT8, gray.data());
  }
  if (written) written = out->close();
  if (!written) error = out ? out->geterror() : OIIO::geterror();
  if (!written) file.clear();
  return file;
}

std::optional<Picture> read_dots(const std::string& path) {
  const auto in = OIIO::ImageInput::open(path);
  if (!in || in->spec().nchannels != 1) return std::nullopt;
  const OIIO::ImageSpec& spec = in->spec();
  Picture picture{.width = spec.width, .height = spec.height, .bits = 8};
  picture.dpi = static_cast<std::int32_t>(std::lround(spec.get_float_attribute("XResolution")));
  picture.dots.resize(static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height));
  if (!in->read_image(0, 0, 0, 1, OIIO::TypeDesc::UINT8, picture.dots.data())) return std::nullopt;
  return picture;
}

// Read as 16 bits: those of 8 come widened, by 257.
std::optional<Samples> read_channel(const std::string& path, std::string& error) {
  const auto in = OIIO::ImageInput::open(path);
  if (!in) {
    error = OIIO::geterror();
    return std::nullopt;
  }
  const OIIO::ImageSpec& spec = in->spec();
  const auto channels = static_cast<std::size_t>(spec.nchannels);
  std::vector<std::uint16_t> all(spec.image_pixels() * channels);
  if (!in->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UINT16, all.data())) {
    error = in->geterror();
    return std::nullopt;
  }
  const bool widened = spec.format == OIIO::TypeDesc::UINT8;
  Samples samples{spec.width, spec.height, static_cast<std::uint16_t>(widened ? 255 : 65535), {}};
  for (std::size_t i = 0; i < all.size(); i += channels) {
    samples.values.push_back(static_cast<std::uint16_t>(widened ? all[i] / 257 : all[i]));
  }
  return samples;
}

}  // namespace

extern "C" const ImageCodec halfspace_image_codec;
extern "C" const ImageCodec halfspace_image_codec{&encode, &read_dots, &read_channel};

}  // namespace halfspace
