#include "drivers/device_table.hpp"

#include <gtest/gtest.h>

#include <set>

namespace halfspace {
namespace {

TEST(DeviceTable, KnowsNamesAndSynonyms) {
  const std::pair<const char*, const char*> cases[] = {
      {"versatec", "versatec"}, {"w", "versatec"},      {"vp", "versatec"}, {"ver", "versatec"},
      {"versatek", "versatec"}, {"varian", "varian"},   {"v", "varian"},    {"va", "varian"},
      {"var", "varian"},        {"gray", "gray"},       {"x", "gray"},      {"vx", "gray"},
      {"vectrix", "gray"},      {"ascii", "ascii"},     {"a", "ascii"},     {"file", "ascii"},
      {"braille", "braille"},   {"ssd1306", "ssd1306"}, {"pwg", "pwg"},
  };
  for (const auto& [name, device] : cases) {
    ASSERT_NE(find_device(name), nullptr) << name;
    EXPECT_STREQ(find_device(name)->traits.name, device);
  }
  for (const char* const unknown : {"", "Versatec", "vers", "v "}) EXPECT_EQ(find_device(unknown), nullptr) << unknown;
}

TEST(DeviceTable, StatesTraitsThatADeviceTakes) {
  std::set<std::string_view> names;
  for (const KnownDevice& device : known_devices) {
    EXPECT_TRUE(names.insert(device.traits.name).second);
    const Page page = default_page(device.traits);
    EXPECT_TRUE(page.width >= 1 && page.width <= device.traits.max_width && device.traits.max_width <= 32767);
    EXPECT_TRUE(page.height >= 1 && page.height <= device.traits.max_height && device.traits.max_height <= 32767);
    EXPECT_TRUE(page.background >= 0 && page.background < page.levels);
    EXPECT_EQ(page.levels, page.format == DotFormat::gray ? 256 : 65);
    EXPECT_GT(device.traits.dots_per_inch, 0);
    EXPECT_GT(device.traits.preferred_band_rows, 0);
  }
}

}  // namespace
}  // namespace halfspace
