#include "runtime/interface/phrases.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "config/museum_config.h"
#include "tests/support/sample_museum.h"

namespace docent::interface::phrases_test {
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

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  for_each_line(text, [&](std::string_view line) { lines.emplace_back(line); });
  return lines;
}

std::string times(std::size_t count, std::string_view text) {
  std::string all;
  for (; count > 0; --count) all += text;
  return all;
}

TEST(Lines, OfOrdinaryLengthAreWhole) {
  EXPECT_THAT(lines_of("It was buried.\n\nIt was found. Why?"),
              testing::ElementsAre("It was buried.", "It was found. Why?"));
}

TEST(Lines, ThatAreLongAreTakenApartWhereASentenceEnds) {
  const std::string english = "It is 2.5 m high (\"a wonder!\") and old.";
  const std::string whole_sentences = times(25, english + " ");
  EXPECT_THAT(lines_of(times(30, english + " ")),
              testing::ElementsAre(whole_sentences.substr(0, whole_sentences.size() - 1),
                                   times(5, english + " ")));

  const std::string chinese = "他说：「这是玉璧。」";  // 30 bytes
  EXPECT_THAT(lines_of(times(40, chinese)),
              testing::ElementsAre(times(33, chinese), times(7, chinese)));
}

TEST(Lines, WithoutSentencesAreTakenApartAtABlank) {
  const std::string thai = "พระพุทธรูปสำริด ";
  for (const std::string& line : lines_of(times(60, thai))) {
    EXPECT_TRUE(line.starts_with("พระ")) << line;
    EXPECT_GT(line.size(), longest_line / 2 - thai.size());
  }
}

RC_GTEST_PROP(LinesProperty, AreShortAndLoseBlanksAlone, ()) {
  const std::vector<std::string> letters{"a", "b", " ", ". ", "。", "玉", "ส", "\n", "𓀀", "\x80"};
  std::string text;
  for (const std::size_t run : *rc::gen::container<std::vector<std::size_t>>(
           rc::gen::inRange<std::size_t>(0, letters.size() * 600)))
    text += times(run / letters.size(), letters[run % letters.size()]);

  std::string taken;
  for (const std::string& line : lines_of(text)) {
    RC_ASSERT(!line.empty());
    RC_ASSERT(line.size() <= longest_line);
    taken += line;
  }

  const auto blank = [](char c) { return c == ' ' || c == '\n'; };
  std::erase_if(taken, blank);
  std::erase_if(text, blank);
  RC_ASSERT(taken == text);
}

RC_GTEST_PROP(LinesProperty, NeverEndInsideALetter, ()) {
  std::string text;
  for (const char* letter : *rc::gen::container<std::vector<const char*>>(
           1500, rc::gen::element("a", "é", "玉", "ส", "𓀀")))
    text += letter;

  const auto is_inside = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; };
  for (const std::string& line : lines_of(text)) RC_ASSERT(!is_inside(line.front()));
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
      const bool is_free =
          key.starts_with("clock") || key.ends_with("s_one") || key.ends_with("s_two");
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
}  // namespace docent::interface::phrases_test
