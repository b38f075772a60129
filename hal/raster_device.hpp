// raster_device.hpp - the one seam to every raster device: plotter, framebuffer, display, printer language.
// Order   begin_page, put_band*, end_page; bands top to bottom, touching, never overlapping, the last one
// ending with
//         the page. The non-virtual functions check this once, so no driver has to.
// Owner   A page's description is copied. A band's bytes are lent until put_band returns: a driver copies
// what it must
//         keep.
// Errors  Returned, never thrown. busy: nothing was taken, make the same call again. Any other value but ok:
// the page
//         is lost, the driver has been told (do_abort), and only begin_page may follow.
// Time    A driver waits for its device only against a deadline (hal/clock.hpp).
// Memory  No heap. Devices are static objects of a board; nobody deletes through this type.
// To add a device, copy drivers/template_driver.hpp.
#pragma once

#include <cstddef>
#include <cstdint>

#include "firmware/core/page.hpp"
#include "hal/device_status.hpp"

namespace halfspace {

enum class Paper : std::uint8_t { black, white };  // what a dot is where nothing is drawn

struct DeviceTraits {
  const char* name = "";
  std::int32_t width = 0;  // dots of the page it has by default
  std::int32_t height = 0;
  std::int32_t max_width = 0;  // dots it can take, at most 32767
  std::int32_t max_height = 0;
  std::int32_t dots_per_inch = 0;       // along a scan line
  std::int32_t aspect_numerator = 1;    // width of a dot ...
  std::int32_t aspect_denominator = 1;  // ... over its height
  DotFormat format = DotFormat::bilevel;
  std::int32_t levels = 65;  // shading levels by default, 2 .. 256
  Paper paper = Paper::white;
  std::int32_t preferred_band_rows = 16;
};

// The level of an empty dot.
[[nodiscard]] constexpr std::int32_t background_level(Paper paper, std::int32_t levels) {
  return paper == Paper::white ? levels - 1 : 0;
}

[[nodiscard]] constexpr Page default_page(const DeviceTraits& traits) {
  return {traits.width, traits.height, traits.format, traits.levels, background_level(traits.paper, traits.levels)};
}

class RasterDevice {
 public:
  explicit RasterDevice(const DeviceTraits& traits) : traits_(traits) {}

  [[nodiscard]] const DeviceTraits& traits() const { return traits_; }

  DeviceStatus begin_page(const Page& page) {
    if (in_page_) return lose_page(DeviceStatus::out_of_order);
    if (const DeviceStatus status = check(page); status != DeviceStatus::ok) return status;
    const DeviceStatus status = do_begin_page(page);
    if (status == DeviceStatus::ok) {
      page_ = page;
      next_y_ = 0;
      in_page_ = true;
    }
    return status == DeviceStatus::ok ? status : settle(status);
  }

  DeviceStatus put_band(const Band& band) {
    if (!in_page_) return DeviceStatus::out_of_order;
    if (const DeviceStatus status = check(band); status != DeviceStatus::ok) return lose_page(status);
    const DeviceStatus status = do_put_band(band);
    if (status == DeviceStatus::ok) next_y_ += band.rows;
    return settle(status);
  }

  DeviceStatus end_page() {
    if (!in_page_) return DeviceStatus::out_of_order;
    if (next_y_ != page_.height) return lose_page(DeviceStatus::out_of_order);
    const DeviceStatus status = do_end_page();
    if (status == DeviceStatus::ok) in_page_ = false;
    return settle(status);
  }

  // Gives up the page, if there is one.
  void abort() {
    if (in_page_) do_abort();
    in_page_ = false;
  }

 protected:
  ~RasterDevice() = default;
  [[nodiscard]] const Page& page() const { return page_; }  // from the first band to the end of the page

 private:
  // The page is within the traits: a driver need not check it again.
  virtual DeviceStatus do_begin_page(const Page& page) = 0;
  // The band follows the one before it and has rows * row_bytes() bytes.
  virtual DeviceStatus do_put_band(const Band& band) = 0;
  // Every row has been put.
  virtual DeviceStatus do_end_page() = 0;
  // The page is lost, at any moment from do_begin_page on. Leave the device fit for another page, as far as
  // it lets you.
  virtual void do_abort() = 0;

  [[nodiscard]] DeviceStatus check(const Page& page) const {
    if (page.width < 1 || page.height < 1) return DeviceStatus::bad_page;
    if (page.width > traits_.max_width || page.height > traits_.max_height) return DeviceStatus::too_large;
    if (page.format != traits_.format || page.levels < 2 || page.levels > 256) return DeviceStatus::bad_page;
    if (page.background < 0 || page.background >= page.levels) return DeviceStatus::bad_page;
    return DeviceStatus::ok;
  }

  [[nodiscard]] DeviceStatus check(const Band& band) const {
    if (band.y != next_y_ || band.rows < 1 || band.rows > page_.height - next_y_) return DeviceStatus::out_of_order;
    if (band.bytes.size() != static_cast<std::size_t>(band.rows) * page_.row_bytes()) return DeviceStatus::bad_band;
    return DeviceStatus::ok;
  }

  DeviceStatus settle(DeviceStatus status) {
    return status == DeviceStatus::ok || status == DeviceStatus::busy ? status : lose_page(status);
  }

  DeviceStatus lose_page(DeviceStatus status) {
    in_page_ = false;
    do_abort();
    return status;
  }

  DeviceTraits traits_;
  Page page_;
  std::int32_t next_y_ = 0;  // the scan line the next band begins with
  bool in_page_ = false;
};

}  // namespace halfspace
