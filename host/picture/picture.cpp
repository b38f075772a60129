#include "host/picture/picture.hpp"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string_view>

#include "host/picture/bilevel_png.hpp"
#include "host/picture/write_bytes.hpp"

namespace halfspace {
namespace {

constexpr std::array<std::string_view, 6> picture_endings{".png", ".tif", ".tiff", ".pbm", ".pgm", ".exr"};

std::string ending(const std::string& path) {
  std::string text = std::filesystem::path(path).extension().string();
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(c >= 'A' && c <= 'Z' ? c + 32 : c); });
  return text;
}

// One row as 8 bits a dot.
void expand_row(const Picture& picture, std::int32_t y, std::vector<std::uint8_t>& gray) {
  const std::uint8_t* const row = picture.dots.data() + static_cast<std::size_t>(y) * picture.row_bytes();
  for (std::size_t x = 0; x < gray.size(); ++x) {
    gray[x] = picture.bits == 8 ? row[x] : (row[x / 8] >> (7 - x % 8) & 1) != 0 ? 0 : 255;
  }
}

// A binary PBM is a header and the dots as they lie. OpenImageIO 2.4 writes its bits inverted.
std::vector<std::uint8_t> encode_pbm(const Picture& picture) {
  const std::string header = "P4\n" + std::to_string(picture.width) + " " + std::to_string(picture.height) + "\n";
  std::vector<std::uint8_t> file(header.begin(), header.end());
  file.insert(file.end(), picture.dots.begin(), picture.dots.end());
  return file;
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

}  // namespace

Picture to_picture(const PaperSheet& sheet, std::int32_t dpi) {
  const bool gray = sheet.format == DotFormat::gray;
  Picture picture{.width = sheet.width, .height = sheet.height, .bits = gray ? 8 : 1, .dots = sheet.dots, .dpi = dpi};
  if (!gray) return picture;
  const int steps = sheet.levels - 1;
  for (std::uint8_t& dot : picture.dots) dot = static_cast<std::uint8_t>((2 * 255 * dot + steps) / (2 * steps));
  return picture;
}

bool is_picture_name(const std::string& path) {
  return std::find(picture_endings.begin(), picture_endings.end(), ending(path)) != picture_endings.end();
}

std::optional<std::string> write_picture(const Picture& picture, const std::string& path) {
  const std::string format = ending(path);
  if (!is_picture_name(path)) {
    return "cannot write " + path + ": not a picture's name: use .png .tif .pbm .pgm or .exr";
  }
  if (format == ".pbm" && picture.bits != 1) {
    return "cannot write " + path + ": .pbm holds black and white only: use .pgm for a gray device";
  }
  std::string error = "libpng refused the picture";
  const std::vector<std::uint8_t> file = format == ".pbm"                        ? encode_pbm(picture)
                                         : format == ".png" && picture.bits == 1 ? encode_bilevel_png(picture)
                                                                                 : encode(picture, format, error);
  if (file.empty()) return "cannot write " + path + ": " + error + ": use another ending or a smaller page";
  return write_bytes(path, file);
}

std::optional<Picture> read_picture(const std::string& path) {
  const auto in = OIIO::ImageInput::open(path);
  if (!in || in->spec().nchannels != 1) return std::nullopt;
  const OIIO::ImageSpec& spec = in->spec();
  Picture picture{.width = spec.width, .height = spec.height, .bits = 8};
  picture.dpi = static_cast<std::int32_t>(std::lround(spec.get_float_attribute("XResolution")));
  picture.dots.resize(static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height));
  if (!in->read_image(0, 0, 0, 1, OIIO::TypeDesc::UINT8, picture.dots.data())) return std::nullopt;
  return picture;
}

}  // namespace halfspace
