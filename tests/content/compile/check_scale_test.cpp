#include "content/compile/check_scale.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace docent::compile::check_scale_test {
namespace {

using testing::HasSubstr;

std::vector<Vec2> box(Vec2 low, Vec2 high) {
  return {low, {high.x, low.y}, high, {low.x, high.y}};
}

/// Two rooms that fill a house of 40 by 30 metres.
std::vector<Vec2> rooms() {
  std::vector<Vec2> both = box({0, 0}, {20, 30});
  const std::vector<Vec2> second = box({20, 0}, {40, 30});
  both.insert(both.end(), second.begin(), second.end());
  return both;
}

TEST(CheckScale, FindsNothingWrongWithAPlanThatFits) {
  EXPECT_FALSE(scale_doubt(box({0, 0}, {40, 30}), rooms()).has_value());
  EXPECT_FALSE(scale_doubt(box({-5, -5}, {60, 40}), rooms()).has_value());
}

TEST(CheckScale, NamesTheUnitOfAPlanThatIsTooLarge) {
  struct Row {
    double in_a_metre;
    const char* name;
  };
  for (const Row& row : {Row{1000, "millimetres"}, Row{100, "centimetres"}, Row{39.37, "inches"},
                         Row{3.2808, "feet"}}) {
    const auto doubt =
        scale_doubt(box({0, 0}, {40 * row.in_a_metre, 30 * row.in_a_metre}), rooms());

    ASSERT_TRUE(doubt.has_value()) << row.name;
    EXPECT_THAT(doubt->message, HasSubstr(row.name));
    EXPECT_THAT(doubt->hint, HasSubstr("divide its numbers by"));
  }
}

TEST(CheckScale, SaysHowFarAPlanIsToBeMoved) {
  const auto doubt = scale_doubt(box({500000, 5500000}, {500040, 5500030}), rooms());

  ASSERT_TRUE(doubt.has_value());
  EXPECT_EQ(doubt->hint, "move the plan by [-500000, -5500000]");
}

TEST(CheckScale, KnowsSwappedAxes) {
  EXPECT_THAT(scale_doubt(box({0, 0}, {30, 40}), rooms())->message, HasSubstr("swapped"));
}

TEST(CheckScale, DoubtsNothingWhereTooLittleIsSaid) {
  EXPECT_FALSE(scale_doubt(box({0, 0}, {4000, 3000}), {{1, 1}, {2, 2}}).has_value());
  EXPECT_FALSE(scale_doubt({}, rooms()).has_value());
}

}  // namespace
}  // namespace docent::compile::check_scale_test
