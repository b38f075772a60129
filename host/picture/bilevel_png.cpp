#include "host/picture/bilevel_png.hpp"

#include <png.h>

namespace halfspace {
namespace {

void append(png_structp png, png_bytep bytes, png_size_t count) {
  auto* const file = static_cast<std::vector<std::uint8_t>*>(png_get_io_ptr(png));
  file->insert(file->end(), bytes, bytes + count);
}

void flush(png_structp) {}

void be_silent(png_structp, png_const_charp) {}

// No object here has a destructor: libpng leaves this function by longjmp when it fails.
bool write_png(png_structp png, png_infop info, const Picture& picture) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  const auto dots_per_metre = static_cast<png_uint_32>((picture.dpi * 10000LL + 127) / 254);
  png_set_IHDR(png, info, static_cast<png_uint_32>(picture.width), static_cast<png_uint_32>(picture.height), 1,
               PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_pHYs(png, info, dots_per_metre, dots_per_metre, PNG_RESOLUTION_METER);
  png_write_info(png, info);
  png_set_invert_mono(png);  // in a PNG 0 is black, here 1 is ink
  for (std::int32_t y = 0; y < picture.height; ++y) {
    png_write_row(png, picture.dots.data() + static_cast<std::size_t>(y) * picture.row_bytes());
  }
  png_write_end(png, info);
  return true;
}

}  // namespace

std::vector<std::uint8_t> encode_bilevel_png(const Picture& picture) {
  std::vector<std::uint8_t> file;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, be_silent);
  png_infop info = png == nullptr ? nullptr : png_create_info_struct(png);
  bool written = false;
  if (info != nullptr) {
    png_set_write_fn(png, &file, append, flush);
    written = write_png(png, info, picture);
  }
  png_destroy_write_struct(&png, &info);
  if (!written) file.clear();
  return file;
}

}  // namespace halfspace
