#include "content/import/drawing/code_page.h"

#include <gtest/gtest.h>

#include "content/import/drawing/dxf_text.h"

namespace docent::test::code_page_test {
namespace {

TEST(CodePage, ReadsWhatTheDrawingStates) {
  EXPECT_EQ(import::to_utf8("\xf1\xf2\xe5\xed\xe0", "ANSI_1251"), "стена");
  EXPECT_EQ(import::to_utf8("\xc7\xbd", "ANSI_936"), "墙");
  EXPECT_EQ(import::to_utf8("T\xfcr", "ANSI_1252"), "Tür");
}

TEST(CodePage, GuessesJapaneseWhereNothingIsStated) {
  EXPECT_EQ(import::to_utf8("\x95\xc7", ""), "壁");
}

TEST(CodePage, LeavesUtf8AsItIs) {
  EXPECT_EQ(import::to_utf8("Fællesrum", "ANSI_1252"), "Fællesrum");
}

TEST(CodePage, ShowsWhatItCannotReadInsteadOfFailing) {
  EXPECT_FALSE(import::to_utf8("\xff\xfe\xff", "ANSI_99999").empty());
  EXPECT_FALSE(import::to_utf8("\x81", "ANSI_936").empty());
}

TEST(DxfText, LosesItsCodesAndKeepsItsWords) {
  EXPECT_EQ(import::without_formatting("{\\fArial|b1;A002}\\P71.25 m{\\H0.7x;\\S2^;}"),
            "A002\n71.25 m2");
  EXPECT_EQ(import::without_controls("90%%d caf\\U+00e9"), "90° café");
  EXPECT_EQ(import::without_formatting("a\\\\b\\{c\\}\\~d"), "a\\b{c} d");
  EXPECT_EQ(import::without_formatting("\\f"), "");
}

}  // namespace
}  // namespace docent::test::code_page_test
