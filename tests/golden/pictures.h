#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <span>
#include <string>

#include "platform/image/image.h"
#include "tests/support/run_program.h"

namespace docent::test {

inline Pixels picture(const std::filesystem::path& file) {
  const std::string bytes = text_of(file);
  const auto decoded = image::decode_image(std::as_bytes(std::span(bytes)));
  return decoded ? *decoded : Pixels{};
}

struct Difference {
  double mean = 0;     ///< Of all channels, of 255.
  double far_off = 0;  ///< Share of the channels that differ by more than a tenth of the range.
};

inline Difference compare(const Pixels& a, const Pixels& b) {
  Difference difference;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) {
    const int apart = std::abs(std::to_integer<int>(a.rgba[i]) - std::to_integer<int>(b.rgba[i]));
    difference.mean += apart;
    difference.far_off += apart > 25 ? 1 : 0;
  }
  const auto count = static_cast<double>(std::max<std::size_t>(a.rgba.size(), 1));
  difference.mean /= count;
  difference.far_off /= count;
  return difference;
}

/// Is the picture the one of that name that people have looked at? DOCENT_UPDATE_GOLDEN=1 writes it
/// anew. Drivers and processors round differently, and a font of another release moves edges of
/// letters: one level in the mean and one channel in a hundred far off allow for that, while a
/// panel that moved, a guide elsewhere or another light do not pass (a guide one step ahead changes
/// more).
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
}

}  // namespace docent::test
