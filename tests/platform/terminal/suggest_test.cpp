#include "platform/terminal/suggest.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <string>

namespace docent::terminal::suggest_test {
namespace {

TEST(EditDistance, CountsSlipsOfTheFinger) {
  EXPECT_EQ(edit_distance("facing", "facing"), 0U);
  EXPECT_EQ(edit_distance("facng", "facing"), 1U);
  EXPECT_EQ(edit_distance("faccing", "facing"), 1U);
  EXPECT_EQ(edit_distance("fasing", "facing"), 1U);
  EXPECT_EQ(edit_distance("faicng", "facing"), 1U) << "neighbours swapped are one slip";
  EXPECT_EQ(edit_distance("", "facing"), 6U);
}

TEST(EditDistance, IsTheSameBothWaysAndAtMostTheLongerWord) {
  EXPECT_TRUE(rc::check("symmetric and bounded", [](const std::string& a, const std::string& b) {
    RC_ASSERT(edit_distance(a, b) == edit_distance(b, a));
    RC_ASSERT(edit_distance(a, b) <= std::max(a.size(), b.size()));
    RC_ASSERT((edit_distance(a, b) == 0) == (a == b));
  }));
}

TEST(Suggestion, IsTheNearestKnownWordAndNothingWhereNoneIsNear) {
  EXPECT_EQ(closest("positon", {"facing", "position", "view"}), "position");
  EXPECT_EQ(closest("colour", {"facing", "position", "view"}), "");
}

}  // namespace
}  // namespace docent::terminal::suggest_test
