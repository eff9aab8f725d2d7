#include "platform/gles/pieces.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vector>

namespace docent::gles::pieces_test {
namespace {

constexpr GLint side = 40;

Region any_region() {
  const auto at = rc::gen::inRange(0, side);
  const auto size = rc::gen::inRange(0, 12);
  const GLint left = *at, low = *at;
  return {left, low, std::min(side, left + *size), std::min(side, low + *size)};
}

/// In how many of the regions a pixel lies.
int count(std::span<const Region> regions, GLint x, GLint y) {
  int sum = 0;
  for (const Region& one : regions) sum += one.overlaps({x, y, x + 1, y + 1}) ? 1 : 0;
  return sum;
}

RC_GTEST_PROP(Pieces, CoverAllThatWasAdded, ()) {
  std::vector<Region> added;
  Pieces pieces;
  for (int i = *rc::gen::inRange(0, 60); i > 0; --i) {
    added.push_back(any_region());
    pieces.add(added.back());
  }

  RC_ASSERT(pieces.regions().size() <= Pieces::most);
  std::int64_t area = 0;
  for (GLint y = 0; y < side; ++y)
    for (GLint x = 0; x < side; ++x) {
      const int times = count(pieces.regions(), x, y);
      RC_ASSERT(times > 0 || count(added, x, y) == 0);
      area += times;
    }
  RC_ASSERT(pieces.area() == area);
}

TEST(Pieces, StayApartWhileThereIsRoomForThem) {
  Pieces pieces;
  for (GLint i = 0; i < static_cast<GLint>(Pieces::most); ++i) pieces.add({3 * i, 0, 3 * i + 2, 2});

  EXPECT_EQ(pieces.area(), 4 * static_cast<std::int64_t>(Pieces::most));
  pieces.add(
      {3 * static_cast<GLint>(Pieces::most), 0, 3 * static_cast<GLint>(Pieces::most) + 2, 2});
  EXPECT_EQ(pieces.area(), 4 * static_cast<std::int64_t>(Pieces::most) + 6) << "joined to the last";
}

TEST(Pieces, AreOneWhereThatTakesNoMorePixels) {
  Pieces pieces;
  pieces.add({0, 0, 10, 10});
  pieces.add({2, 2, 4, 4});
  pieces.add({10, 0, 20, 10});
  pieces.add({0, 10, 20, 20});

  EXPECT_EQ(pieces.regions().size(), 1U);
  EXPECT_EQ(pieces.area(), 400);
}

TEST(Pieces, AreTwoWhereTheyMeetInACornerOfWhatIsMuchLarger) {
  Pieces pieces;
  pieces.add({0, 0, 2, 40});
  pieces.add({1, 0, 40, 2});

  EXPECT_EQ(pieces.regions().size(), 2U);
  EXPECT_EQ(pieces.area(), 80 + 78);
}

RC_GTEST_PROP(WhatLiesBesideARegion, IsTheRestOfTheOtherEachPixelOnce, ()) {
  const Region other = any_region(), region = any_region();
  const auto parts = beside(other, region);

  for (GLint y = 0; y < side; ++y)
    for (GLint x = 0; x < side; ++x) {
      const bool is_rest = count({&region, 1}, x, y) == 1 && count({&other, 1}, x, y) == 0;
      RC_ASSERT(count(parts, x, y) == (is_rest ? 1 : 0));
    }
}

}  // namespace
}  // namespace docent::gles::pieces_test
