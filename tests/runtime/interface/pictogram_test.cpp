#include "runtime/interface/pictogram.h"

#include <gtest/gtest.h>

#include <numeric>
#include <set>

namespace docent::interface::pictogram_test {
namespace {

/// The share of the square that is covered.
double covered(const TextBitmap& bitmap) {
  const double sum = std::accumulate(bitmap.coverage.begin(), bitmap.coverage.end(), 0.0);
  return sum / 255 / static_cast<double>(bitmap.coverage.size());
}

TEST(Pictograms, AreThereForEveryKindOfPlaceAndOneIsNotLikeAnother) {
  std::set<std::vector<std::uint8_t>> seen;
  for (std::size_t i = 0; i < pictogram_count; ++i) {
    const TextBitmap drawn = draw_pictogram(static_cast<Pictogram>(i), 48);
    ASSERT_EQ(drawn.coverage.size(), 48U * 48U);
    EXPECT_GT(covered(drawn), 0.08) << i;
    EXPECT_LT(covered(drawn), 0.7) << i;
    seen.insert(drawn.coverage);
  }
  // The wheelchair stands for two things.
  EXPECT_EQ(seen.size(), pictogram_count - 1);
}

TEST(Pictograms, LookTheSameInEverySize) {
  for (std::size_t i = 0; i < pictogram_count; ++i) {
    const auto what = static_cast<Pictogram>(i);
    EXPECT_NEAR(covered(draw_pictogram(what, 24)), covered(draw_pictogram(what, 240)), 0.02) << i;
  }
}

TEST(Pictograms, KeepOffTheEdgeOfTheirSquare) {
  for (std::size_t i = 0; i < pictogram_count; ++i) {
    const TextBitmap drawn = draw_pictogram(static_cast<Pictogram>(i), 96);
    for (std::size_t at = 0; at < 96; ++at)
      for (const std::size_t pixel : {at, 95 * 96 + at, at * 96, at * 96 + 95})
        EXPECT_EQ(drawn.coverage[pixel], 0) << i;
  }
}

TEST(Pictograms, OfNoSizeAreOnePixel) {
  EXPECT_EQ(draw_pictogram(Pictogram::Places, 0).coverage.size(), 1U);
}

}  // namespace
}  // namespace docent::interface::pictogram_test
