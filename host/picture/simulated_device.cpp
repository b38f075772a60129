#include "host/picture/simulated_device.hpp"

#include <algorithm>
#include <filesystem>

#include "host/picture/picture.hpp"
#include "host/picture/write_bytes.hpp"
#include "sim/byte_collector.hpp"
#include "sim/decode.hpp"
#include "sim/plotter.hpp"
#include "sim/ssd1306.hpp"

namespace halfspace {
namespace {

std::string text_of(const Violation& violation) {
  return "the simulated device objects at byte " + std::to_string(violation.offset) + ": " + violation.what;
}

bool all_blank(std::span<const std::uint8_t> bytes, std::uint8_t blank) {
  return std::all_of(bytes.begin(), bytes.end(), [blank](std::uint8_t byte) { return byte == blank; });
}

// The top left part of a larger sheet. Beyond it every dot must be blank (0 or 0xFF a byte), otherwise
// nullopt.
std::optional<PaperSheet> crop(const PaperSheet& large, const Page& page, std::uint8_t blank) {
  PaperSheet sheet{.width = page.width, .height = page.height};
  if (large.width < page.width || large.height < page.height) return std::nullopt;
  const int spare_bits = static_cast<int>(sheet.row_bytes()) * 8 - page.width;
  const auto spare = static_cast<std::uint8_t>((1 << spare_bits) - 1);
  for (std::int32_t y = 0; y < large.height; ++y) {
    const auto row = std::span(large.dots).subspan(static_cast<std::size_t>(y) * large.row_bytes(), large.row_bytes());
    const std::size_t kept = y < page.height ? sheet.row_bytes() : 0;
    if (!all_blank(row.subspan(kept), blank)) return std::nullopt;
    if (kept == 0) continue;
    if ((row[kept - 1] & spare) != (blank & spare)) return std::nullopt;
    sheet.dots.insert(sheet.dots.end(), row.begin(), row.begin() + static_cast<std::ptrdiff_t>(kept));
    sheet.dots.back() &= static_cast<std::uint8_t>(~spare);
  }
  return sheet;
}

ReceivedPage cropped(const PaperSheet& large, const Page& page, std::uint8_t blank) {
  auto sheet = crop(large, page, blank);
  if (!sheet) return {std::nullopt, "the simulated device shows dots outside the page"};
  return {std::move(sheet), {}};
}

template <typename Driver, typename Plotter>
class PlotterOnPaper final : public SimulatedDevice {
 public:
  explicit PlotterOnPaper(const Page& page) : page_(page) {}

  RasterDevice& device() override { return driver_; }

  ReceivedPage sheet() override {
    plotter_.close();
    if (!plotter_.violations().empty()) return {std::nullopt, text_of(plotter_.violations().front())};
    if (plotter_.pages().size() != 1 || plotter_.pages()[0].height != page_.height) {
      return {std::nullopt, "the simulated plotter did not print one whole page"};
    }
    return cropped(plotter_.pages()[0], page_, 0);
  }

  std::vector<std::uint8_t> raw_bytes() override {
    return plotter_.pages().empty() ? std::vector<std::uint8_t>{} : plotter_.pages()[0].dots;
  }

 private:
  Page page_;
  Plotter plotter_;
  Driver driver_{plotter_, clock_};
};

class Oled final : public SimulatedDevice {
 public:
  explicit Oled(const Page& page) : page_(page) {}

  RasterDevice& device() override { return driver_; }

  ReceivedPage sheet() override {
    if (!display_.violations().empty()) return {std::nullopt, text_of(display_.violations().front())};
    if (!display_.is_on()) return {std::nullopt, "the simulated display was not switched on"};
    return cropped(display_.glass(), page_, 0xFF);
  }

  std::vector<std::uint8_t> raw_bytes() override { return {display_.memory().begin(), display_.memory().end()}; }

 private:
  Page page_;
  SimulatedSsd1306 display_;
  Ssd1306Driver driver_{display_, clock_};
};

// Devices that are a stream of bytes: decode(bytes) reads the stream back.
template <typename Driver, typename Decode>
class Stream final : public SimulatedDevice {
 public:
  template <typename... Extra>
  explicit Stream(Decode decode, Extra... extra) : driver_(bytes_, clock_, extra...), decode_(decode) {}

  RasterDevice& device() override { return driver_; }

  ReceivedPage sheet() override {
    Decoded decoded = decode_(bytes_.bytes());
    if (!decoded.sheet) return {std::nullopt, text_of(decoded.violation)};
    return {std::move(decoded.sheet), {}};
  }

  std::vector<std::uint8_t> raw_bytes() override { return bytes_.bytes(); }

 private:
  ByteCollector bytes_;
  Driver driver_;
  Decode decode_;
};

template <typename Driver, typename Decode, typename... Extra>
std::unique_ptr<SimulatedDevice> make_stream(Decode decode, Extra... extra) {
  return std::make_unique<Stream<Driver, Decode>>(decode, extra...);
}

std::string ending(const std::string& path) { return std::filesystem::path(path).extension().string(); }

bool takes_raw_bytes(const std::string& path) {
  if (path == "-" || ending(path) == ".prn" || ending(path) == ".pwg" || ending(path) == ".txt") return true;
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  return std::filesystem::is_other(status);
}

}  // namespace

std::unique_ptr<SimulatedDevice> make_simulated_device(const KnownDevice& device, const Page& page, std::int32_t dpi) {
  switch (device.kind) {
    case DeviceKind::versatec:
      return std::make_unique<PlotterOnPaper<VersatecDriver, SimulatedVersatec>>(page);
    case DeviceKind::varian:
      return std::make_unique<PlotterOnPaper<VarianDriver, SimulatedVarian>>(page);
    case DeviceKind::gray:
      return make_stream<GrayDriver>(decode_pgm);
    case DeviceKind::ascii:
      return make_stream<AsciiDriver>(decode_spans);
    case DeviceKind::braille:
      return make_stream<BrailleDriver>(
          [page](std::span<const std::uint8_t> bytes) { return decode_braille(bytes, page.width, page.height); });
    case DeviceKind::ssd1306:
      return std::make_unique<Oled>(page);
    case DeviceKind::pwg:
      return make_stream<PwgDriver>(decode_pwg, dpi);
  }
  return nullptr;
}

std::optional<std::string> check_output_name(const std::string& path, const DeviceTraits& traits) {
  if (ending(path) == ".pbm" && traits.format == DotFormat::gray) {
    return "cannot write " + path + ": .pbm holds black and white only: use .pgm for a gray device";
  }
  if (is_picture_name(path) || takes_raw_bytes(path)) return std::nullopt;
  return "cannot write " + path +
         ": unknown ending: use .png .tif .pbm .pgm or .exr for a picture, .prn .pwg or .txt for the "
         "device's own "
         "bytes, - for standard output";
}

bool holds_density(const std::string& path, const KnownDevice& device) {
  if (!is_picture_name(path)) return device.kind == DeviceKind::pwg;
  return ending(path) != ".pbm" && ending(path) != ".pgm";
}

std::optional<std::string> write_output(SimulatedDevice& device, std::int32_t dpi, const std::string& path) {
  const ReceivedPage page = device.sheet();
  if (!page.sheet) return page.error;
  if (auto error = check_output_name(path, device.device().traits())) return error;
  return is_picture_name(path) ? write_picture(to_picture(*page.sheet, dpi), path)
                               : write_bytes(path, device.raw_bytes());
}

}  // namespace halfspace
