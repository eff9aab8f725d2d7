#include "runtime/interface/sentences.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <random>
#include <string>

#include "runtime/interface/control.h"
#include "runtime/interface/layout.h"
#include "runtime/interface/phrases.h"
#include "tests/runtime/directions/raster.h"
#include "tests/runtime/directions/some_ways.h"
#include "tests/runtime/interface/boxes.h"
#include "tests/support/sanitized.h"

namespace docent::interface::sentences_test {
namespace {

using directions::Directions;
using directions::DoorStep;
using directions::Side;

/// What a reader of each language understands by left, right, ahead and behind, and by numbers.
/// Written down here once more: a word in the wrong line of a language's file is found. A word that
/// may begin a sentence lacks its first letter, which is a capital there.
struct Reader {
  std::array<std::string, 6> side;
  std::array<std::string, 6> nth;
  std::string open_quote, close_quote, stop, free_of_steps;
  std::array<std::string, 10> digit;
};
const std::array<Reader, 3>& readers() {
  static const std::array<Reader, 3> all{{
      {{"traight ahead", "on the left", "on the right", "behind you", "behind you on the left",
        "behind you on the right"},
       {"first", "second", "third", "fourth", "fifth", "sixth"},
       "“",
       "”",
       ".",
       "step-free",
       {"0", "1", "2", "3", "4", "5", "6", "7", "8", "9"}},
      {{"正前方", "左手边", "右手边", "您身后", "左后方", "右后方"},
       {"第一", "第二", "第三", "第四", "第五", "第六"},
       "“",
       "”",
       "。",
       "无台阶",
       {"0", "1", "2", "3", "4", "5", "6", "7", "8", "9"}},
      {{"أمامك", "على اليسار", "على اليمين", "خلفك", "خلفك على اليسار", "خلفك على اليمين"},
       {"الأول", "الثاني", "الثالث", "الرابع", "الخامس", "السادس"},
       "«",
       "»",
       ".",
       "بلا درج",
       {"٠", "١", "٢", "٣", "٤", "٥", "٦", "٧", "٨", "٩"}},
  }};
  return all;
}

std::vector<std::string> names_in(const Reader& reader, const std::string& text) {
  std::vector<std::string> names;
  for (std::size_t at = text.find(reader.open_quote); at != std::string::npos;
       at = text.find(reader.open_quote, at + 1)) {
    const std::size_t begin = at + reader.open_quote.size();
    names.push_back(text.substr(begin, text.find(reader.close_quote, begin) - begin));
  }
  return names;
}

long number_in(const Reader& reader, const std::string& text) {
  long number = 0;
  for (std::size_t at = 0; at < text.size();) {
    const auto digit = std::ranges::find_if(
        reader.digit, [&](const std::string& d) { return text.compare(at, d.size(), d) == 0; });
    if (digit == reader.digit.end()) return number;
    number = number * 10 + (digit - reader.digit.begin());
    at += digit->size();
  }
  return number;
}

/// What is said about a door: its side, and its number where there are several.
void expect_door(const Reader& reader, const std::string& text, const DoorStep& step) {
  if (step.of == 0) return;
  EXPECT_NE(text.find(reader.side[static_cast<std::size_t>(step.side)]), std::string::npos) << text;
  for (std::size_t i = 0; i < reader.nth.size(); ++i) {
    EXPECT_EQ(text.find(reader.nth[i]) != std::string::npos, step.of > 1 && step.nth == i + 1)
        << text;
  }
}

class Sentences : public testing::TestWithParam<std::uint32_t> {};

TEST_P(Sentences, SayWhatIsSoOnThePlan) {
  const test::SampleHouse& house = test::sample_house();
  const Museum& museum = house.museum;
  const std::uint32_t language = GetParam();
  const Reader& reader = readers()[language];
  std::vector<test::Raster> raster;
  for (std::uint32_t floor = 0; floor < museum.floors.size(); ++floor)
    raster.emplace_back(museum, floor);
  std::mt19937 random(7 + language);
  for (int n = 0; n < 1000; ++n) {
    const test::SomeWay some = test::some_way(random);
    const auto facts = directions::direct(museum, house.doorways, some.start, some.way, some.goal);
    ASSERT_TRUE(facts);
    const WaySentences said = sentences_in(museum, language, *facts);
    if (std::getenv("DOCENT_TELL") != nullptr && n < 25)
      std::cout << said.way << " " << said.goal << " " << said.figures << "\n";
    const std::string all = said.way + said.goal + said.figures;
    EXPECT_EQ(all.find_first_of("{}_"), std::string::npos) << all;
    for (const std::string& one : {said.way, said.goal, said.figures}) {
      EXPECT_TRUE(one.ends_with(reader.stop)) << one;
      EXPECT_EQ(one.find(reader.stop), one.size() - reader.stop.size()) << "one sentence: " << one;
    }

    // The plan, read from the raster.
    std::vector<test::Raster::Told> told;
    std::vector<std::string> real;  // names in the order in which one comes to them
    double degrees = some.start.heading * 180 / 3.14159265358979;
    for (const path::Leg& leg : some.way.legs) {
      if (leg.is_along_floor()) {
        told.push_back(raster[leg.floor].tell(leg.points, degrees));
        for (const DoorStep& step : told.back().steps)
          real.emplace_back(in_language(museum, language, museum.rooms[step.to].title));
      } else {
        real.emplace_back(in_language(museum, language, museum.floors[leg.to_floor].title));
        for (const ConnectionStop& stop : museum.connections[leg.connection].stops)
          if (stop.floor == leg.to_floor)
            degrees = stop.placement.heading * 180 / 3.14159265358979 + 180;
      }
    }
    // All that is named is come to, in that order.
    std::size_t at = 0;
    for (const std::string& name : names_in(reader, said.way)) {
      while (at < real.size() && real[at] != name) ++at;
      EXPECT_LT(at++, real.size()) << name << " is not on the way, or not there: " << said.way;
    }
    EXPECT_LE(names_in(reader, said.way).size(), 9U) << said.way;

    // The last door, which comes last in the sentence.
    if (!told.back().steps.empty() && !told.back().is_borderline) {
      const std::string tail =
          said.way.substr(std::min(said.way.size(), said.way.rfind(reader.close_quote) + 1));
      expect_door(reader, tail, told.back().steps.back());
    }
    // Each change of floors.
    EXPECT_EQ(static_cast<std::size_t>(std::ranges::count_if(
                  some.way.legs, [](const path::Leg& leg) { return !leg.is_along_floor(); })),
              facts->parts.size() - 1);

    // The goal's room.
    const std::vector<std::string> rooms = names_in(reader, said.goal);
    const std::uint32_t in =
        told.back().steps.empty() ? told.back().first_room : told.back().steps.back().to;
    ASSERT_EQ(rooms.size(), in == none ? 0U : 1U) << said.goal;
    if (in != none) {
      EXPECT_EQ(rooms.front(), in_language(museum, language, museum.rooms[in].title));
    }

    // The figures.
    EXPECT_EQ(number_in(reader, said.figures), std::max(1L, std::lround(some.way.length)));
    const bool has_steps = std::ranges::any_of(some.way.legs, [&](const path::Leg& leg) {
      return !leg.is_along_floor() && !museum.connections[leg.connection].step_free;
    });
    EXPECT_EQ(said.figures.find(reader.free_of_steps) == std::string::npos, has_steps)
        << said.figures;
  }
}

/// All times that a text says, of those that a reader of the language knows.
std::vector<std::string> times_in(const Museum& museum, std::uint32_t language, std::string text) {
  std::vector<std::string> all;
  // The longest first: "about 12 minutes" is not also said to be "about 2 minutes".
  std::vector<std::string> known{time_in(museum, language, 1), time_in(museum, language, 20)};
  for (int minutes = 60; minutes > 0; --minutes)
    known.push_back(time_in(museum, language, 60 * minutes));
  std::ranges::stable_sort(known, std::greater{}, &std::string::size);
  for (const std::string& time : known)
    for (std::size_t at = text.find(time); at != std::string::npos; at = text.find(time)) {
      all.push_back(time);
      text.erase(at, time.size());
    }
  return all;
}

/// Whatever the guide makes of the way: it may take longer or be quicker, or be on another way.
TEST_P(Sentences, AndTheLineAboveThemSayOneTimeOfAWay) {
  NEEDS_SPEED();
  const test::SampleHouse& house = test::sample_house();
  const Museum& museum = house.museum;
  const std::uint32_t language = GetParam();
  std::mt19937 random(11 + language);
  const auto share = [&] { return static_cast<double>(random() % 1000) / 1000; };
  int moments = 0, halves = 0;
  for (int n = 0; n < 1000; ++n) {
    const test::SomeWay some = test::some_way(random);
    const auto facts = directions::direct(museum, house.doorways, some.start, some.way, some.goal);
    ASSERT_TRUE(facts);
    const ShownWay way{*facts, museum.kiosk_floor, some.way.legs.front().points};
    ViewRequest request;
    request.state.language = language;
    request.state.screen = Screen::Walking;
    request.state.exhibit = some.goal.exhibit.value_or(0);
    const bool is_another = n % 5 == 0;
    request.route_summary = RouteSummary{path::RouteStatus::Ok,
                                         is_another ? 60 * share() : facts->metres + share() - 0.5,
                                         facts->seconds * (0.5 + share()), std::nullopt};
    PieceCache cache({test::boxes, {}}, 1, 1 << 20);
    const auto view = make_view(museum, request, cache, {}, &way);
    std::vector<std::string> said;
    for (const Words& words : view->words)
      for (std::string& time : times_in(museum, language, words.text))
        said.push_back(std::move(time));
    ASSERT_FALSE(said.empty());
    const std::string wanted = time_in(museum, language, facts->seconds);
    for (const std::string& time : said) EXPECT_EQ(time, wanted) << facts->metres << " m";
    moments += wanted == time_in(museum, language, 1) ? 1 : 0;
    halves += wanted == time_in(museum, language, 20) ? 1 : 0;
  }
  EXPECT_GT(moments, 5);
  EXPECT_GT(halves, 50);
}

INSTANTIATE_TEST_SUITE_P(InEveryLanguage, Sentences, testing::Values(0U, 1U, 2U));

TEST(SentencesOf, AShortWayAreAsPeopleSayThem) {
  const Museum& museum = test::sample_house().museum;
  const auto room = [&](std::string_view id) {
    return static_cast<std::uint32_t>(std::ranges::find(museum.rooms, id, &Room::id) -
                                      museum.rooms.begin());
  };
  Directions facts;
  facts.parts = {{.room = room("foyer"),
                  .doors = {{room("foyer"), room("court"), Side::Ahead, 1, 1},
                            {room("court"), room("bronze"), Side::Left, 2, 2}},
                  .turns = {}}};
  facts.goal = {.room = room("bronze"),
                .setting = directions::Setting::InCase,
                .where = directions::Where::Left};
  facts.metres = 32;
  facts.seconds = 32;

  EXPECT_EQ(sentences_in(museum, 0, facts),
            (WaySentences{"Through “Garden Court”, then the second door on the left.",
                          "In “Bronze”, in a glass case on your left.",
                          "32 m, about half a minute, step-free."}));
  EXPECT_EQ(sentences_in(museum, 1, facts),
            (WaySentences{"穿过“中庭”，然后走左手边第二道门。", "在“青铜”，左手边的展柜里。",
                          "32 米，大约半分钟，无台阶。"}));
  EXPECT_EQ(
      sentences_in(museum, 2, facts),
      (WaySentences{"عبر «فناء الحديقة»، ثم الباب الثاني على اليسار.",
                    "في «البرونز»، في خزانة زجاجية عن يسارك.", "٣٢ م، نحو نصف دقيقة، بلا درج."}));
}

TEST(SentencesOf, ALongWayNameThreeRooms) {
  const Museum& museum = test::sample_house().museum;
  Directions facts;
  facts.parts.emplace_back().room = 0;
  for (std::uint32_t i = 0; i < 8; ++i)
    facts.parts[0].doors.push_back({i, i + 1, Side::Ahead, 1, 1});

  const WaySentences said = sentences_in(museum, 0, facts);

  EXPECT_EQ(names_in(readers()[0], said.way).size(), 3U) << said.way;
}

TEST(Capitalised, KnowsTheLettersThatHaveCapitals) {
  EXPECT_EQ(capitalised("the door"), "The door");
  EXPECT_EQ(capitalised("à gauche"), "À gauche");
  EXPECT_EQ(capitalised("через зал"), "Через зал");
  EXPECT_EQ(capitalised("ё"), "Ё");
  EXPECT_EQ(capitalised("αίθουσα"), "Αίθουσα");
  EXPECT_EQ(capitalised("šatna"), "Šatna");
  EXPECT_EQ(capitalised("“A”"), "“A”");
  EXPECT_EQ(capitalised("穿过"), "穿过");
  EXPECT_EQ(capitalised(""), "");
}

}  // namespace
}  // namespace docent::interface::sentences_test
