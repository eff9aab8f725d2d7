#include "runtime/search/fold.h"

#include <gtest/gtest.h>

#include <array>

namespace docent::search::fold_test {
namespace {

TEST(Fold, LeavesOutAccentsCaseAndWidth) {
  EXPECT_EQ(folded("Émile GALLÉ"), u"emile galle");
  EXPECT_EQ(folded("Ångström, Łódź; Đặng Thái"), u"angstrom lodz dang thai");
  EXPECT_EQ(folded("e\u0301tude"), u"etude") << "accents of their own are accents";
  EXPECT_EQ(folded("Straße, œuvre, Æsir, þing"), u"strasse oeuvre aesir thing");
  EXPECT_EQ(folded("ＡＢＣ１２"), u"abc12");
  EXPECT_EQ(folded("Ἀθηνᾶ ΣΟΦΟΣ"), u"αθηνα σοφοσ");
}

TEST(Fold, TakesDigitsOfEveryScriptForTheSame) {
  EXPECT_EQ(folded("١٢٣ ۱۲۳ १२३ ๑๒๓ １２３"), u"123 123 123 123 123");
}

TEST(Fold, KeepsOneSpaceBetweenWords) {
  EXPECT_EQ(folded("  “Bronze-tripod”, (c. 900)  "), u"bronze tripod c 900");
  EXPECT_EQ(folded("L’Annonciation"), u"lannonciation");
}

TEST(Fold, TellsNoFormsOfArabicLettersApart) {
  EXPECT_EQ(folded("أَحْمَد إبراهيم آدم"), u"احمد ابراهيم ادم");
  EXPECT_EQ(folded("مَدِينَة مصطفى قـــوس"), u"مدينه مصطفي قوس");
}

TEST(Fold, LeavesOutHebrewPointsAndFinalForms) {
  EXPECT_EQ(folded("שָׁלוֹם"), folded("שלומ"));
  EXPECT_EQ(folded("כֶּסֶף"), u"כספ");
}

TEST(Fold, TakesKatakanaSmallAndVoicedKanaForPlainHiragana) {
  EXPECT_EQ(folded("ガラス"), u"からす");
  EXPECT_EQ(folded("ｶﾞﾗｽ"), u"からす");
  EXPECT_EQ(folded("きょうと"), folded("きようと"));
  EXPECT_EQ(folded("コーヒー"), u"こひ");
  EXPECT_EQ(folded("パピルス"), u"はひるす");
}

TEST(Fold, TakesHangulApartIntoTheKeysThatOnePresses) {
  EXPECT_EQ(folded("청동"), u"ㅊㅓㅇㄷㅗㅇ");
  EXPECT_EQ(folded("왕관"), u"ㅇㅗㅏㅇㄱㅗㅏㄴ");
  EXPECT_EQ(folded("까치 읽"), u"ㄱㄱㅏㅊㅣ ㅇㅣㄹㄱ");
  EXPECT_EQ(folded("ㄲㅘ"), u"ㄱㄱㅗㅏ");
}

TEST(Fold, TakesSignsOfDevanagariForTheirVowelsAndLongOnesForShort) {
  EXPECT_EQ(folded("मूर्ति"), u"मउरतइ");
  EXPECT_EQ(folded("मुर्ती"), folded("मूर्ति"));
  EXPECT_EQ(folded("ज़री"), u"जरइ");
}

TEST(Fold, LeavesOutThaiTonesAndTakesCyrillicYoForYe) {
  EXPECT_EQ(folded("น้ำ"), folded("นำ"));
  EXPECT_EQ(folded("Чёрный Йод"), u"черныи иод");
}

TEST(Fold, ChangesNothingThatIsFolded) {
  for (const char* text : {"Straße œuvre", "أَحْمَد", "ガラス", "읽기 왕관", "मूर्ति", "น้ำ", "Чёрный",
                           "青铜鼎", "כֶּסֶף", "Ἀθηνᾶ"}) {
    const std::u16string once = folded(text);
    EXPECT_EQ(folded(std::u16string_view(once)), once) << text;
  }
}

TEST(Fold, ReadsBytesThatAreNoTextWithoutHarm) {
  EXPECT_EQ(folded("\xC3"), u"");
  EXPECT_EQ(folded("a\xFF\x80z"), u"a z");
}

}  // namespace
}  // namespace docent::search::fold_test
