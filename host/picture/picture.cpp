#include "host/picture/picture.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

#include "host/picture/bilevel_png.hpp"
#include "host/picture/image_codec.hpp"
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

// A binary PBM is a header and the dots as they lie. OpenImageIO 2.4 writes its bits inverted.
std::vector<std::uint8_t> encode_pbm(const Picture& picture) {
  const std::string header = "P4\n" + std::to_string(picture.width) + " " + std::to_string(picture.height) + "\n";
  std::vector<std::uint8_t> file(header.begin(), header.end());
  file.insert(file.end(), picture.dots.begin(), picture.dots.end());
  return file;
}

// The file's bytes; on failure none, and the reason with a remedy.
std::vector<std::uint8_t> encode(const Picture& picture, const std::string& format, std::string& error) {
  if (format == ".pbm") return encode_pbm(picture);
  std::vector<std::uint8_t> file;
  if (format == ".png" && picture.bits == 1) {
    error = "libpng refused the picture";
    file = encode_bilevel_png(picture);
  } else {
    const ImageCodec* const codec = image_codec(error);
    if (codec == nullptr) return file;
    file = codec->encode(picture, format, error);
  }
  error += ": use another ending or a smaller page";
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
  std::string error;
  const std::vector<std::uint8_t> file = encode(picture, format, error);
  if (file.empty()) return "cannot write " + path + ": " + error;
  return write_bytes(path, file);
}

std::optional<Picture> read_picture(const std::string& path) {
  std::string error;
  const ImageCodec* const codec = image_codec(error);
  return codec == nullptr ? std::nullopt : codec->read_picture(path);
}

}  // namespace halfspace
