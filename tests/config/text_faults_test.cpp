#include "config/text_faults.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace docent::config::text_faults_test {
namespace {

TEST(TextFaults, NameTheLetterThatNoFontHolds) {
  EXPECT_EQ(unshown_letter("a 🎉")->name, "the emoji U+1F389");
  EXPECT_EQ(unshown_letter("a\uFFFD")->name, "the mark of a lost letter, U+FFFD");
  EXPECT_EQ(unshown_letter("the bronze 𪜀")->name, "the letter U+2A700");
  EXPECT_EQ(unshown_letter("\u0378")->name, "the letter U+0378") << "that is no letter at all";
  EXPECT_FALSE(unshown_letter("the bronze 𪜀", Fonts::Own).has_value());
  EXPECT_TRUE(unshown_letter("a 🎉", Fonts::Own).has_value());
  EXPECT_FALSE(unshown_letter("Bronze 青铜 متحف – “é”\n").has_value());
}

TEST(TextFaults, FindWhatIsFilledIn) {
  EXPECT_THAT(placeholders_of("{n} of {total} {not one} {"),
              testing::ElementsAre("{n}", "{total}"));
}

std::vector<std::string> codes(std::string_view text) {
  std::vector<std::string> found;
  for (const TextFault& fault : faults_of(text, Fonts::Kiosk)) found.push_back(fault.code);
  return found;
}

TEST(TextFaults, MarkupOfWebPagesIsFound) {
  EXPECT_THAT(codes("<b>Bronze</b>"), testing::ElementsAre("markup"));
  EXPECT_EQ(faults_of("gold &amp; jade", Fonts::Kiosk)[0].what, "holds '&amp;'");
  EXPECT_THAT(codes("</i>"), testing::ElementsAre("markup"));
  for (const char* plain : {"3 < 4 and 5 > 4", "gold & jade; silver", "a <- b", "<3"})
    EXPECT_THAT(codes(plain), testing::IsEmpty()) << plain;
}

TEST(TextFaults, LettersOfAWrongEncodingAreReadAsTheyWere) {
  EXPECT_EQ(before_wrong_encoding("CafÃ©"), "Café");
  EXPECT_EQ(before_wrong_encoding("Ø§Ù„Ù…"), "الم");
  EXPECT_EQ(before_wrong_encoding("itâ€™s"), "it’s");
}

TEST(TextFaults, WordsOfEuropeAreNoWrongEncoding) {
  for (const char* word :
       {"Café", "déjà vu", "« déjà\u00A0»", "«\u00A0MUSÉE DE L'ÉTÉ»", "ÅÄÖ", "São Paulo", "naïve",
        "Ægir’s ‘þing’", "10 €", "– 5°", "青铜", "متحف", "Ä", "NÃO"})
    EXPECT_EQ(before_wrong_encoding(word), "") << word;
}

TEST(TextFaults, QuestionMarksInPlaceOfLettersAreFound) {
  EXPECT_THAT(codes("?????? ????"), testing::ElementsAre("lost-letters"));
  EXPECT_THAT(codes("What is it???"), testing::IsEmpty());
}

TEST(TextFaults, AChineseLetterTakesTheRoomOfTwo) {
  EXPECT_EQ(room_of("abc"), 3U);
  EXPECT_EQ(room_of("青铜"), 4U);
  EXPECT_EQ(room_of("a\u0301"), 1U);
}

TEST(TextFaults, ManyShortLinesTakeTheRoomOfLongOnes) {
  EXPECT_EQ(room_of("a\nb\nc"), 81U);
}

TEST(TextFaults, WhatTakesMoreThanItsRoomIsFound) {
  EXPECT_EQ(faults_of("four", Fonts::Kiosk, 3)[0].code, "text-does-not-fit");
  EXPECT_THAT(faults_of("four", Fonts::Kiosk, 4), testing::IsEmpty());
}

RC_GTEST_PROP(TextFaults, AnyBytesAreSafe, (const std::string& text)) {
  RC_ASSERT(room_of(text) <= 40 * (text.size() + 1));
  (void)unshown_letter(text);
  (void)faults_of(text, Fonts::Kiosk);
  (void)before_wrong_encoding(text);
  for (const std::string& name : placeholders_of(text)) RC_ASSERT(text.find(name) != text.npos);
}

}  // namespace
}  // namespace docent::config::text_faults_test
