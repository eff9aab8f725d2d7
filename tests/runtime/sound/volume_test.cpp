#include "runtime/sound/volume.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace docent::sound::volume_test {
namespace {

TEST(Volume, GrowsEvenlyToTheEar) {
  EXPECT_EQ(gain_of(0), 0);
  EXPECT_EQ(gain_of(-1), 0);
  EXPECT_EQ(gain_of(NAN), 0);
  EXPECT_EQ(gain_of(1), 1);
  EXPECT_EQ(gain_of(2), 1);
  for (int tenth = 1; tenth < 10; ++tenth) {
    const float step =
        gain_of(static_cast<float>(tenth + 1) / 10) / gain_of(static_cast<float>(tenth) / 10);
    EXPECT_NEAR(20 * std::log10(step), 4, 0.01);
  }
}

TEST(Volume, ChangesWithoutAClick) {
  std::array<float, 480> samples{};
  samples.fill(1);
  std::array<std::int16_t, 960> out{};
  to_device(samples, 0, 1, out);
  for (std::size_t i = 2; i < out.size(); i += 2) {
    EXPECT_EQ(out[i], out[i + 1]);
    EXPECT_LE(out[i] - out[i - 2], 70);
  }
  EXPECT_EQ(out.back(), 32767);
}

TEST(Volume, ClipsWhatIsTooLoud) {
  const std::array<float, 2> samples{3, -3};
  std::array<std::int16_t, 4> out{};
  to_device(samples, 1, 1, out);
  EXPECT_EQ(out, (std::array<std::int16_t, 4>{32767, 32767, -32767, -32767}));
}

}  // namespace
}  // namespace docent::sound::volume_test
