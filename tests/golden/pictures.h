#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "platform/image/image.h"
#include "tests/support/run_program.h"

namespace docent::test {

inline Pixels picture(const std::filesystem::path& file) {
  const std::string bytes = text_of(file);
  const auto decoded = image::decode_image(std::as_bytes(std::span(bytes)));
  return decoded ? *decoded : Pixels{};
}

struct Difference {
  double mean = 0;        ///< Of all channels, of 255.
  double far_off = 0;     ///< Share of the channels that differ by more than a tenth of the range.
  double worst_tile = 0;  ///< The largest share of pixels that do so in any tile.
};

inline Difference compare(const Pixels& a, const Pixels& b) {
  constexpr std::uint32_t tile = 24;  // pixels: no control is smaller
  const std::uint32_t columns = (a.width + tile - 1) / tile;
  std::vector<std::uint32_t> far_in_tile(std::size_t{columns} * ((a.height + tile - 1) / tile));
  Difference difference;
  for (std::size_t pixel = 0; pixel < a.rgba.size() / 4; ++pixel) {
    bool is_far = false;
    for (std::size_t i = 4 * pixel; i < 4 * pixel + 4; ++i) {
      const int apart = std::abs(std::to_integer<int>(a.rgba[i]) - std::to_integer<int>(b.rgba[i]));
      difference.mean += apart;
      difference.far_off += apart > 25 ? 1 : 0;
      is_far = is_far || apart > 25;
    }
    if (is_far) ++far_in_tile[pixel / a.width / tile * columns + pixel % a.width / tile];
  }
  const auto count = static_cast<double>(std::max<std::size_t>(a.rgba.size(), 1));
  difference.mean /= count;
  difference.far_off /= count;
  for (const std::uint32_t far : far_in_tile)
    difference.worst_tile = std::max(difference.worst_tile, far / double{tile * tile});
  return difference;
}

/// Is the picture the one of that name that people have looked at? DOCENT_UPDATE_GOLDEN=1 writes it
/// anew. Drivers and processors round differently, and a font of another release moves edges of
/// letters: one level in the mean, one channel in a hundred far off and half of any tile allow for
/// that, while a panel that moved, a guide elsewhere, another light or a button more do not pass (a
/// guide one step ahead changes more).
inline void expect_approved(const std::filesystem::path& file, const char* name) {
  const std::filesystem::path golden = source_dir() / "tests/golden" / name;
  if (std::getenv("DOCENT_UPDATE_GOLDEN") != nullptr)
    std::filesystem::copy_file(file, golden, std::filesystem::copy_options::overwrite_existing);
  const Pixels now = picture(file);
  const Pixels approved = picture(golden);
  ASSERT_GT(now.rgba.size(), 0U) << name;
  ASSERT_EQ(now.rgba.size(), approved.rgba.size()) << name;
  const Difference difference = compare(now, approved);
  EXPECT_LT(difference.mean, 1.0) << name;
  EXPECT_LT(difference.far_off, 0.01) << name;
  EXPECT_LT(difference.worst_tile, 0.5) << name;
}

}  // namespace docent::test
