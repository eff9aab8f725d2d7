#include "runtime/search/compose.h"

#include <gtest/gtest.h>

#include "runtime/search/fold.h"

namespace docent::search::compose_test {
namespace {

TEST(WhatIsTyped, IsReadAsSyllablesOfHangulKeyByKey) {
  EXPECT_EQ(composed(u"ㅊ"), "ㅊ");
  EXPECT_EQ(composed(u"ㅊㅓ"), "처");
  EXPECT_EQ(composed(u"ㅊㅓㅇ"), "청");
  EXPECT_EQ(composed(u"ㅊㅓㅇㄷ"), "청ㄷ");
  EXPECT_EQ(composed(u"ㅊㅓㅇㄷㅗㅇ"), "청동");
  EXPECT_EQ(composed(u"ㄱㅗㅏㄴ"), "관");
  EXPECT_EQ(composed(u"ㄷㅏㄹㄱㅇㅣ"), "닭이");
  EXPECT_EQ(composed(u"ㄱㄱㅗㅊ"), "꽃");
  EXPECT_EQ(composed(u"ㅎㅏㄴㄱㅡㄹ ㄱㅏ"), "한글 가");
  EXPECT_EQ(composed(u"ㄱㅏㅂㅅㅣ"), "갑시");
  EXPECT_EQ(composed(u"ㅏㅏ"), "ㅏㅏ");
}

TEST(WhatIsTyped, HasSignsOfDevanagariAfterConsonants) {
  EXPECT_EQ(composed(u"मऊरतइ"), "मूरति");
  EXPECT_EQ(composed(u"आ"), "आ");
  EXPECT_EQ(composed(u"कआ"), "का");
}

TEST(WhatIsTyped, HasVoicedKana) {
  EXPECT_EQ(composed(u"か゛らす"), "がらす");
  EXPECT_EQ(composed(u"は゜ひ゜るす"), "ぱぴるす");
  EXPECT_EQ(composed(u"あ゛"), "あ゛");
}

TEST(WhatIsTyped, IsComparedByTheSameLettersAsWhatIsRead) {
  for (const std::u16string_view typed :
       {u"ㄷㅏㄹㄱㅇㅣ", u"ㄱㅗㅏㄴ", u"मऊरतइ", u"か゛らす", u"vase 12", u"حمراء"})
    EXPECT_EQ(folded(composed(typed)), folded(typed)) << composed(typed);
}

}  // namespace
}  // namespace docent::search::compose_test
