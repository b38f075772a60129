#include "firmware/core/stipple.hpp"

#include <algorithm>
#include <array>

namespace halfspace {
namespace {

// Two spots a cell, at (2, 2) and (6, 6), grown in turn by the cosine spot function; whites close last at (6,
// 2), (2, 6).
constexpr std::uint8_t clustered_rank[64] = {
    24, 10, 12, 26, 39, 53, 51, 33, 8,  0,  2,  14, 47, 63, 57, 41, 22, 6,  4,  16, 49, 59,
    61, 55, 30, 20, 18, 28, 35, 43, 45, 37, 38, 52, 50, 32, 25, 11, 13, 27, 46, 62, 56, 40,
    9,  1,  3,  15, 48, 58, 60, 54, 23, 7,  5,  17, 34, 42, 44, 36, 31, 21, 19, 29,
};

// Void and cluster on a torus of 16 x 16, Gaussian of standard deviation 1.5 [Ulichney 93].
constexpr std::uint8_t blue_noise_rank[cell_dots] = {
    223, 8,   83,  208, 119, 171, 237, 43,  158, 58,  29,  88,  226, 134, 176, 76,  55,  131, 155, 63,  21,  146,
    71,  220, 105, 242, 212, 149, 49,  4,   236, 148, 183, 244, 35,  189, 250, 99,  179, 7,   135, 75,  15,  181,
    252, 116, 38,  94,  18,  115, 89,  217, 124, 47,  206, 34,  194, 167, 122, 92,  64,  198, 161, 207, 229, 52,
    165, 6,   77,  153, 238, 117, 57,  231, 42,  221, 145, 12,  78,  129, 70,  192, 136, 235, 178, 23,  69,  163,
    91,  142, 19,  186, 109, 173, 247, 36,  157, 107, 27,  202, 104, 132, 216, 1,   245, 204, 74,  240, 53,  26,
    96,  218, 3,   239, 87,  59,  37,  253, 81,  184, 114, 32,  101, 156, 127, 210, 187, 141, 45,  170, 219, 126,
    188, 159, 22,  147, 48,  172, 197, 5,   233, 84,  62,  118, 196, 73,  150, 9,   213, 106, 66,  201, 228, 130,
    61,  139, 40,  168, 17,  254, 133, 24,  243, 90,  50,  140, 241, 98,  10,  82,  249, 205, 93,  224, 152, 100,
    174, 60,  111, 177, 222, 14,  166, 44,  123, 180, 25,  112, 185, 67,  33,  209, 0,   227, 200, 31,  125, 79,
    193, 230, 154, 211, 54,  160, 11,  121, 234, 85,  128, 151, 72,  162, 248, 56,  110, 30,  68,  102, 225, 80,
    246, 144, 190, 51,  251, 41,  103, 16,  137, 214, 182, 143, 255, 2,   138, 39,  203, 20,  97,  164, 113, 195,
    175, 232, 46,  95,  13,  86,  199, 120, 191, 169, 108, 65,  215, 28,
};

// Each step of an 8 x 8 rank is split among the four 8 x 8 quarters of the cell, diagonal ones first.
constexpr std::uint8_t quarter_rank(std::int32_t x, std::int32_t y) {
  constexpr std::uint8_t order[4] = {0, 2, 3, 1};
  return order[(y / 8 % 2) * 2 + x / 8 % 2];
}

// Bayer's recursive matrix: interleave the bits of x ^ y and y, least significant first.
constexpr std::uint8_t bayer_rank(std::int32_t x, std::int32_t y) {
  unsigned rank = 0;
  for (int bit = 0; bit < 4; ++bit) {
    const unsigned xor_bit = static_cast<unsigned>(x ^ y) >> bit & 1U;
    const unsigned y_bit = static_cast<unsigned>(y) >> bit & 1U;
    rank = rank << 2 | xor_bit << 1 | y_bit;
  }
  return static_cast<std::uint8_t>(rank);
}

}  // namespace

std::uint8_t screen_rank(Screen screen, std::int32_t x, std::int32_t y) {
  switch (screen) {
    case Screen::bayer:
      return bayer_rank(x % cell_side, y % cell_side);
    case Screen::blue_noise:
      return blue_noise_rank[y % cell_side * cell_side + x % cell_side];
    default:
      return static_cast<std::uint8_t>(4 * clustered_rank[y % 8 * 8 + x % 8] + quarter_rank(x, y));
  }
}

void make_patterns(Screen screen, std::int32_t levels, std::span<PatternRow> rows) {
  for (std::int32_t y = 0; y < cell_side; ++y) {
    std::array<std::uint8_t, cell_side> ranks;
    for (std::int32_t x = 0; x < cell_side; ++x) ranks[static_cast<std::size_t>(x)] = screen_rank(screen, x, y);
    for (std::int32_t k = 0; k < levels; ++k) {
      const std::int32_t inked = inked_dots(k, levels);
      unsigned row = 0;
      for (const std::uint8_t rank : ranks) row = row << 1 | (rank < inked ? 1U : 0U);
      rows[static_cast<std::size_t>(y * levels + k)] = static_cast<PatternRow>(row);
    }
  }
}

void find_edges(std::int32_t levels, std::span<const PatternRow> rows, std::span<std::uint32_t> edges) {
  std::fill(edges.begin(), edges.end(), 0U);
  const PatternRow* row = rows.data();
  std::uint32_t* words = edges.data();
  for (std::int32_t y = 0; y < cell_side; ++y) {
    for (std::int32_t k = 0; k <= levels; ++k) {
      if (k == 0 || k == levels || row[k] != row[k - 1]) words[k / 32] |= 1U << k % 32;
    }
    row += levels;
    words += edge_words(levels);
  }
}

}  // namespace halfspace
