#include "config/colour.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fmt/format.h>
#include <string>

namespace docent::config::colour_test {
namespace {

TEST(AColour, IsReadAsTheWebWritesIt) {
  EXPECT_EQ(parse_colour("#D2452D"), 0xD2452DU);
  EXPECT_EQ(parse_colour("#00539b"), 0x00539BU);
  for (const char* text : {"", "#", "D2452D", "#D2452", "#D2452D0", "#D24G2D", "#-12345", "red"})
    EXPECT_FALSE(parse_colour(text)) << text;
}

TEST(AColour, ThatIsWrittenOtherwiseIsUnderstoodWhereItIsClear) {
  EXPECT_EQ(colour_meant("d2452d"), "#D2452D");
  EXPECT_EQ(colour_meant(" #d24 "), "#DD2244");
  EXPECT_EQ(colour_meant("0xD2452D"), "#D2452D");
  EXPECT_EQ(colour_meant("rgb(210, 69, 45)"), "#D2452D");
  EXPECT_EQ(colour_meant("210,69,45"), "#D2452D");
  for (const char* text : {"", "tomato", "rgb(210, 69)", "rgb(210, 69, 45, 1)", "300,0,0", ",,"})
    EXPECT_EQ(colour_meant(text), "") << text;
}

RC_GTEST_PROP(AColour, ThatIsUnderstoodCanBeRead, (const std::string& text)) {
  const std::string meant = colour_meant(text);
  RC_ASSERT(meant.empty() || parse_colour(meant));
  const auto hex = *rc::gen::inRange<std::uint32_t>(0, 0x1000000);
  RC_ASSERT(parse_colour(fmt::format("#{:06X}", hex)) == hex);
}

}  // namespace
}  // namespace docent::config::colour_test
