#include "runtime/interface/phrases.h"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <string>

#include "config/museum_config.h"
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

  EXPECT_EQ(time_in(museum, 0, 6), "just a few steps");
  EXPECT_EQ(time_in(museum, 0, 12), "about half a minute");
  EXPECT_EQ(time_in(museum, 0, 30), "about half a minute");
  EXPECT_EQ(time_in(museum, 0, 55), "about a minute");
  EXPECT_EQ(time_in(museum, 0, 200), "about 3 minutes");
}

namespace chr = std::chrono;

/// A Thursday.
constexpr chr::local_days thursday = chr::local_days(chr::year(2026) / 11 / 26);

/// In English, Chinese and Arabic.
std::array<std::string, 3> said(LocalMinute moment, std::optional<chr::local_days> day = thursday) {
  const Museum museum = test::sample_museum_without_walls();
  return {moment_in(museum, 0, moment, day), moment_in(museum, 1, moment, day),
          moment_in(museum, 2, moment, day)};
}

TEST(Phrases, SayTimesOfDayByTheClockOfTheLanguage) {
  using Said = std::array<std::string, 3>;

  EXPECT_EQ(said(thursday + chr::hours(17)), (Said{"5 p.m.", "下午 5 点", "٥ مساءً"}));
  EXPECT_EQ(said(thursday + chr::hours(9) + chr::minutes(5)),
            (Said{"9:05 a.m.", "上午 9:05", "٩:٠٥ صباحًا"}));
  EXPECT_EQ(said(thursday + chr::hours(12)), (Said{"noon", "中午", "الظهر"}));
  EXPECT_EQ(said(thursday + chr::minutes(30))[0], "12:30 a.m.");
}

TEST(Phrases, SayDaysToComeAsShortAsIsClear) {
  const auto ten_on = [](int days) { return thursday + chr::days(days) + chr::hours(10); };

  EXPECT_EQ(said(ten_on(1))[0], "tomorrow, 10 a.m.");
  EXPECT_EQ(said(ten_on(2))[1], "星期六 上午 10 点");
  EXPECT_EQ(said(ten_on(6))[2], "يوم الأربعاء، ١٠ صباحًا");
  EXPECT_EQ(said(ten_on(7))[0], "3 December") << "another Thursday";
  EXPECT_EQ(said(thursday + chr::days(3))[0], "Sunday") << "from midnight on";
  EXPECT_EQ(said(ten_on(8))[1], "12 月 4 日");
  EXPECT_EQ(said(ten_on(60))[0], "25 January 2027") << "of another year";
  EXPECT_EQ(said(ten_on(0), {})[0], "26 November 2026") << "without a clock";
}

TEST(Phrases, SayTheHoursOfADayAsOneCountsThemThere) {
  Museum museum = test::sample_museum_without_walls();
  museum.languages[0].words["clock"] = "{hour_of_day}.{minute} Uhr";

  EXPECT_EQ(moment_in(museum, 0, thursday + chr::minutes(17 * 60 + 30), thursday), "17.30 Uhr");
}

TEST(Phrases, FillInEveryHole) {
  EXPECT_EQ(filled_in("{n} of {n}", "n", "2"), "2 of 2");
  EXPECT_EQ(filled_in("no hole", "n", "2"), "no hole");
  EXPECT_EQ(filled_in("{n}", "n", "{n}"), "{n}");
}

/// The words that docent ships in a language.
config::LocatedTexts shipped_words(const std::string& tag) {
  const auto loaded =
      config::load_words(test::source_dir() / "config/words" / (tag + ".toml"), tag);
  EXPECT_TRUE(loaded.value.has_value()) << tag;
  return loaded.value ? loaded.value->words.value : config::LocatedTexts{};
}

constexpr std::array shipped_languages{"ar", "de", "en", "es", "fr", "he",
                                       "hi", "ja", "ko", "ru", "th", "zh"};

/// The holes of a text that are filled in, each once. A clock may be that of 12 or of 24 hours.
std::set<std::string> holes_of(const std::string& text) {
  std::set<std::string> holes;
  for (std::size_t at = text.find('{'); at != std::string::npos; at = text.find('{', at + 1))
    holes.insert(text.substr(at, text.find('}', at) - at + 1));
  return holes;
}

TEST(Words, AreThereInEveryLanguage) {
  const config::LocatedTexts english = shipped_words("en");
  for (const char* tag : shipped_languages) {
    const config::LocatedTexts words = shipped_words(tag);
    EXPECT_EQ(words.size(), english.size()) << tag;
    for (const auto& [key, text] : english) {
      ASSERT_TRUE(words.contains(key)) << tag << ": " << key;
      const bool has_its_holes = holes_of(words.at(key).value) == holes_of(text.value);
      // One and two may be said in a word.
      const bool is_free = key.starts_with("clock") || key == "metres_one" || key == "metres_two";
      EXPECT_TRUE(has_its_holes || is_free) << tag << ": " << key;
    }
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
