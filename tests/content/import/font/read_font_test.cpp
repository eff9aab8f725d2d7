#include "content/import/font/read_font.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <span>
#include <string>

#include "content/content_error.h"
#include "tests/support/made_font.h"

namespace docent::import::read_font_test {
namespace {

using testing::HasSubstr;

std::span<const std::byte> bytes_of(const std::string& text) {
  return std::as_bytes(std::span(text));
}

std::string fault_of(const std::string& bytes) {
  try {
    read_font(bytes_of(bytes));
    return {};
  } catch (const content::ContentError& error) {
    EXPECT_EQ(error.code, "unreadable-font");
    EXPECT_FALSE(error.hint.empty());
    return error.what();
  }
}

TEST(AFont, TellsItsFamilyAndItsLetters) {
  const Font font = read_font(bytes_of(test::make_font({.family = "House", .letters = U"AZé鼎"})));

  EXPECT_EQ(font.family, "House");
  EXPECT_THAT(font.letters, testing::ElementsAre(U'A', U'Z', U'é', U'鼎'));
  EXPECT_FALSE(font.forbids_embedding);
}

TEST(AFont, TellsThatItMustNotBePassedOn) {
  constexpr std::uint16_t restricted = 2, editable = 8;
  const auto of = [](std::uint16_t embedding) {
    return read_font(bytes_of(test::make_font({.letters = U"A", .embedding = embedding})));
  };
  EXPECT_TRUE(of(restricted).forbids_embedding);
  EXPECT_FALSE(of(editable).forbids_embedding);
  EXPECT_FALSE(of(restricted | editable).forbids_embedding) << "the most permissive one holds";
}

TEST(AFont, ThatIsNoneOrHasNoNameIsRefusedWithASentence) {
  EXPECT_THAT(fault_of(""), HasSubstr("no font"));
  EXPECT_THAT(fault_of("wOFF and nothing more"), HasSubstr("no font"));
  EXPECT_THAT(fault_of(test::make_font({.family = "", .letters = U"A"})), HasSubstr("no name"));
  EXPECT_THAT(fault_of(test::make_font({.family = "A, B", .letters = U"A"})), HasSubstr("comma"));
}

TEST(AFont, WithADamagedOutlineIsRefusedWithItsLetter) {
  std::string font = test::make_font({.letters = U"AB"});
  const std::size_t glyphs = font.find(std::string("\0\1\0\x14", 4));  // the box of no letter
  ASSERT_NE(glyphs, std::string::npos);
  const std::size_t third = font.find(std::string("\0\1\0\x14", 4), glyphs + 50);
  ASSERT_NE(third, std::string::npos);
  font[third + 11] = '\x7F';  // more points than there are bytes

  EXPECT_THAT(fault_of(font), HasSubstr("U+0042"));
}

RC_GTEST_PROP(AFont, OfAnyBytesIsReadOrRefused, ()) {
  std::string font = test::make_font({.letters = test::latin_letters()});
  for (int i = *rc::gen::inRange(1, 20); i > 0; --i)
    font[*rc::gen::inRange<std::size_t>(0, font.size())] = *rc::gen::arbitrary<char>();
  font.resize(*rc::gen::inRange<std::size_t>(0, font.size() + 1));
  try {
    RC_ASSERT(!read_font(bytes_of(font)).family.empty());
  } catch (const content::ContentError& error) {
    RC_ASSERT(error.code == "unreadable-font");
  }
}

}  // namespace
}  // namespace docent::import::read_font_test
