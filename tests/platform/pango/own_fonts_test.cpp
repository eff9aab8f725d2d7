#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>

#include "platform/pango/text_setter.h"
#include "tests/support/made_font.h"

/// A museum's own letters are black boxes here (tests/support/made_font.h), so that they are known
/// by their ink.
namespace docent::pango::own_fonts_test {
namespace {

FontFile file(const test::FontSketch& sketch) {
  const std::string bytes = test::make_font(sketch);
  const auto all = std::as_bytes(std::span(bytes));
  return {.name = sketch.family + ".ttf", .bytes = {all.begin(), all.end()}};
}

/// Whose titles are set in boxes, in its first language only.
Museum museum_with(const std::string& family) {
  Museum museum;
  museum.languages = {{.tag = "en", .name = "English", .right_to_left = false, .words = {}},
                      {.tag = "fr", .name = "Français", .right_to_left = false, .words = {}}};
  museum.livery.titles = {.family = family, .languages = {0}};
  museum.fonts = {file({.family = family, .letters = test::latin_letters()})};
  return museum;
}

/// How much of the text's place is covered, of 1.
double ink(const interface::SetText& set_text, std::string_view language,
           interface::Family family = interface::Family::Serif, std::string_view text = "museum") {
  interface::TextStyle style;
  style.family = family;
  style.language = language;
  style.size = 40;
  style.line_height = 1;
  const interface::TextBitmap bitmap = set_text(style, text, 0);
  double sum = 0;
  for (const std::uint8_t coverage : bitmap.coverage) sum += coverage / 255.0;
  return sum / std::max<double>(1, static_cast<double>(bitmap.coverage.size()));
}

constexpr double of_boxes = 0.9, of_letters = 0.5;

TEST(AMuseumsLetters, AreSetWhereTheyLeadAndNowhereElse) {
  const Museum museum = museum_with("House");
  const auto set_text = make_text_setter(&museum);
  ASSERT_TRUE(set_text);

  EXPECT_GT(ink(*set_text, "en"), of_boxes);
  EXPECT_LT(ink(*set_text, "fr"), of_letters);
  EXPECT_LT(ink(*set_text, "en", interface::Family::Sans), of_letters) << "titles only";
  EXPECT_LT(ink(*set_text, "en", interface::Family::Serif, "é"), of_letters) << "it has none";
}

TEST(AMuseumsLetters, StayWhenWhatWasLearntOfFontsIsForgotten) {
  const Museum museum = museum_with("House");
  const auto set_text = make_text_setter(&museum);
  ASSERT_TRUE(set_text);
  for (int text = 0; text < 60; ++text) {
    ASSERT_GT(ink(*set_text, "en", interface::Family::Serif, std::to_string(text)), of_boxes);
    if (text % 30 == 29) forget_letters();
  }
}

TEST(AMuseumsLetters, StayWhileTheNextMuseumWaitsToBeShown) {
  const auto of = [](const std::string& family) {
    const Museum museum = museum_with(family);
    return make_text_setter(&museum).value();
  };
  const auto first = of("House"), second = of("Manor");
  EXPECT_GT(ink(first, "en"), of_boxes);
  EXPECT_GT(ink(second, "en"), of_boxes);
  const auto third = of("Abbey");
  EXPECT_LT(ink(first, "en"), of_letters) << "nobody sees that museum any more";
  EXPECT_GT(ink(second, "en"), of_boxes);
  EXPECT_GT(ink(third, "en"), of_boxes);

  const auto plain = make_text_setter();
  ASSERT_TRUE(plain);
  EXPECT_LT(ink(*plain, "en"), of_letters);
}

TEST(AMuseumsLetters, InAFileThatIsNoFontAreThoseOfTheHouse) {
  Museum museum = museum_with("House");
  museum.fonts[0].bytes.resize(100);
  const auto set_text = make_text_setter(&museum);
  ASSERT_TRUE(set_text);
  const double covered = ink(*set_text, "en");
  EXPECT_GT(covered, 0.05);
  EXPECT_LT(covered, of_letters);
}

}  // namespace
}  // namespace docent::pango::own_fonts_test
