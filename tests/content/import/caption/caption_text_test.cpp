#include "content/import/caption/caption_text.h"

#include <gtest/gtest.h>

namespace docent::import::caption_text_test {
namespace {

TEST(CaptionText, IsWithoutTags) {
  EXPECT_EQ(caption_text("<v.loud Ada Lovelace>I <b>see</b></v> <00:01.500>it."), "I see it.");
  EXPECT_EQ(caption_text("<lang en>Hello</lang>"), "Hello");
}

TEST(CaptionText, KeepsWhatIsNoTag) {
  EXPECT_EQ(caption_text("1 < 2 and 3 > 2"), "1 < 2 and 3 > 2");
  EXPECT_EQ(caption_text("a <b and <i>c</i>"), "a <b and c");
  EXPECT_EQ(caption_text("<"), "<");
}

TEST(CaptionText, HasEntitiesAsTheirLetters) {
  EXPECT_EQ(caption_text("R&amp;D &lt;3 &#233;&#xe9; &copy; &"), "R&D <3 éé &copy; &");
  EXPECT_EQ(caption_text("&#0; &#xD800; &#1114112;"), "&#0; &#xD800; &#1114112;");
}

TEST(CaptionText, HasTheBaseOfRubyAndNotItsReading) {
  EXPECT_EQ(caption_text("<ruby>漢<rt>かん</rt>字<rt>じ</rt></ruby>です"), "漢字です");
}

TEST(CaptionText, JoinsLinesButWhereSomebodyElseSpeaks) {
  EXPECT_EQ(caption_text("One  line\n and\tits end \n"), "One line and its end");
  EXPECT_EQ(caption_text("- Who is it?\n- It is I."), "- Who is it?\n- It is I.");
  EXPECT_EQ(caption_text("这是第一行\n第二行"), "这是第一行第二行");
  EXPECT_EQ(caption_text("첫째 줄\n둘째 줄"), "첫째 줄 둘째 줄");
}

TEST(CaptionText, IsEmptyWhereNothingIsWritten) {
  EXPECT_EQ(caption_text(" \n\t\n<i></i>"), "");
}

}  // namespace
}  // namespace docent::import::caption_text_test
