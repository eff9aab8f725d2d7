#include "runtime/interface/phrases.h"

#include <gtest/gtest.h>

#include "tests/support/sample_museum.h"

namespace docent::interface {
namespace {

TEST(Phrases, SayDistancesInTheDigitsOfTheLanguage) {
  const Museum museum = test::sample_museum_without_walls();

  EXPECT_EQ(distance_in(museum, 0, 42.4), "42 m");
  EXPECT_EQ(distance_in(museum, 1, 42.4), "42 米");
  EXPECT_EQ(distance_in(museum, 2, 42.4), "٤٢ م");
  EXPECT_EQ(distance_in(museum, 0, 0.1), "1 m");
}

TEST(Phrases, UseThePluralFormsOfArabic) {
  const Museum museum = test::sample_museum_without_walls();

  EXPECT_EQ(time_in(museum, 2, 60), "نحو دقيقة");
  EXPECT_EQ(time_in(museum, 2, 120), "نحو دقيقتين");
  EXPECT_EQ(time_in(museum, 2, 180), "نحو ٣ دقائق");
  EXPECT_EQ(time_in(museum, 2, 11 * 60), "نحو ١١ دقيقة");
}

TEST(Phrases, RoundTimesAsPeopleSayThem) {
  const Museum museum = test::sample_museum_without_walls();

  EXPECT_EQ(time_in(museum, 0, 8), "just a few steps");
  EXPECT_EQ(time_in(museum, 0, 30), "about half a minute");
  EXPECT_EQ(time_in(museum, 0, 55), "about a minute");
  EXPECT_EQ(time_in(museum, 0, 200), "about 3 minutes");
}

TEST(Phrases, FillInEveryHole) {
  EXPECT_EQ(filled_in("{n} of {n}", "n", "2"), "2 of 2");
  EXPECT_EQ(filled_in("no hole", "n", "2"), "no hole");
  EXPECT_EQ(filled_in("{n}", "n", "{n}"), "{n}");
}

TEST(Words, AreThereInEveryLanguage) {
  const Museum museum = test::sample_museum_without_walls();
  for (const Language& language : museum.languages) {
    EXPECT_EQ(language.words.size(), museum.languages[0].words.size()) << language.tag;
    for (const auto& [key, text] : museum.languages[0].words)
      EXPECT_TRUE(language.words.contains(key)) << language.tag << ": " << key;
  }
}

TEST(Words, NameEveryKindOfPlaceInEveryLanguage) {
  const Museum museum = test::sample_museum_without_walls();
  for (const Language& language : museum.languages)
    for (const PlaceKindInfo& info : place_kinds)
      EXPECT_TRUE(language.words.contains("place_" + std::string(info.name)))
          << language.tag << ": " << info.name;
}

}  // namespace
}  // namespace docent::interface
