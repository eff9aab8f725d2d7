#include "content/import/building/level_list.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace docent::test::level_list_test {
namespace {

using import::parse_levels;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Optional;

TEST(LevelList, ReadsNumbersListsRangesAndBlanks) {
  EXPECT_THAT(parse_levels("0"), Optional(ElementsAre(0)));
  EXPECT_THAT(parse_levels(" 1 "), Optional(ElementsAre(1)));
  EXPECT_THAT(parse_levels("-1;"), Optional(ElementsAre(-1)));
  EXPECT_THAT(parse_levels("0;1"), Optional(ElementsAre(0, 1)));
  EXPECT_THAT(parse_levels("-4;-3; -2"), Optional(ElementsAre(-4, -3, -2)));
  EXPECT_THAT(parse_levels("0;-1;-2"), Optional(ElementsAre(-2, -1, 0)));
  EXPECT_THAT(parse_levels("-1-2"), Optional(ElementsAre(-1, 0, 1, 2)));
  EXPECT_THAT(parse_levels("0-3"), Optional(ElementsAre(0, 1, 2, 3)));
  EXPECT_THAT(parse_levels("-3--1"), Optional(ElementsAre(-3, -2, -1)));
  EXPECT_THAT(parse_levels("0.5"), Optional(ElementsAre(0.5)));
  EXPECT_THAT(parse_levels("-2;0"), Optional(ElementsAre(-2, 0)));
  EXPECT_THAT(parse_levels("ground; Basement"), Optional(ElementsAre(-1, 0)));
  EXPECT_THAT(parse_levels(""), Optional(IsEmpty()));
}

TEST(LevelList, RefusesWhatNamesNoLevel) {
  for (const char* text : {"roof", "1a", "0-", "1e9", "nan", "0-400", "--1"})
    EXPECT_EQ(parse_levels(text), std::nullopt) << text;
}

RC_GTEST_PROP(LevelList, ReadsBackAnyRangeThatIsWritten, ()) {
  const int low = *rc::gen::inRange(-50, 50), count = *rc::gen::inRange(0, 20);

  const auto levels = parse_levels(import::level_name(low) + "-" + import::level_name(low + count));

  RC_ASSERT(levels.has_value());
  RC_ASSERT(levels->size() == static_cast<std::size_t>(count) + 1);
  RC_ASSERT(levels->front() == low && levels->back() == low + count);
}

}  // namespace
}  // namespace docent::test::level_list_test
