#include "content/import/collection/plain_text.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace docent::import::plain_text_test {
namespace {

TEST(PlainText, KeepsWordsAndLosesTags) {
  EXPECT_EQ(plain_text("<p>A <b>bold</b> vase.</p><p>Second&nbsp;part</p>"),
            "A bold vase.\nSecond part");
  EXPECT_EQ(plain_text("a<br/>b<br>c"), "a\nb\nc");
}

TEST(PlainText, DropsScriptsAndRemarks) {
  EXPECT_EQ(plain_text("a<script>alert('<b>')</script>b<!-- c -->d"), "abd");
  EXPECT_EQ(plain_text("a<script>never closed"), "a");
}

TEST(PlainText, ReadsEntities) {
  EXPECT_EQ(plain_text("&eacute;&#233;&#xE9; &amp;lt; &unknown; &#x110000;"), "ééé &lt; &unknown;");
}

TEST(PlainText, LeavesWhatIsNoHtml) {
  EXPECT_EQ(plain_text("5 < 6 and 7 > 3"), "5 < 6 and 7 > 3");
  EXPECT_EQ(plain_text("two  blanks\n\nand lines"), "two  blanks\n\nand lines");
}

RC_GTEST_PROP(PlainText, IsNeverLongerThanWhatItWasMadeOf, (const std::string& text)) {
  RC_ASSERT(plain_text(text).size() <= text.size());
}

}  // namespace
}  // namespace docent::import::plain_text_test
