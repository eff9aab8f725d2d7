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
#include <string_view>
#include <utility>
#include <vector>

#include "runtime/interface/control.h"
#include "runtime/interface/layout.h"
#include "runtime/interface/phrases.h"
#include "runtime/interface/utterance.h"
#include "tests/runtime/directions/raster.h"
#include "tests/runtime/directions/readers.h"
#include "tests/runtime/directions/some_ways.h"
#include "tests/runtime/interface/boxes.h"
#include "tests/support/sanitized.h"
#include "tests/support/shipped_languages.h"

namespace docent::interface::sentences_test {
namespace {

using directions::Directions;
using directions::DoorStep;
using directions::Side;

using test::Reader;

std::uint32_t index_of(const Museum& museum, std::string_view language) {
  return static_cast<std::uint32_t>(std::ranges::find(museum.languages, language, &Language::tag) -
                                    museum.languages.begin());
}

/// What is said last: after all that is said to come before it, and after all names.
std::string_view last_said(const Reader& reader, std::string_view text) {
  for (const std::string_view mark : {reader.then, reader.close_quote})
    if (const std::size_t at = text.rfind(mark); at != std::string_view::npos)
      text.remove_prefix(at + mark.size());
  return text;
}

/// What is said about a door: its side, and its number where there are several.
void expect_door(const Reader& reader, std::string_view text, const DoorStep& step) {
  if (step.of == 0) return;
  EXPECT_EQ(test::said_first(reader.side, text), static_cast<std::size_t>(step.side)) << text;
  for (std::size_t i = 0; i < reader.nth.size(); ++i) {
    // A door may be all that a sentence is about.
    const bool is_said = text.find(reader.nth[i]) != std::string_view::npos;
    EXPECT_EQ(is_said, step.of > 1 && step.nth == i + 1) << text;
  }
}

/// By what one changes floors, and whether up.
using Rides = std::vector<std::pair<std::size_t, bool>>;

Rides rides_of(const Museum& museum, const path::BuildingWay& way) {
  Rides rides;
  for (const path::Leg& leg : way.legs)
    if (!leg.is_along_floor())
      rides.emplace_back(
          static_cast<std::size_t>(museum.connections[leg.connection].kind),
          museum.floors[leg.to_floor].plan.ordinal > museum.floors[leg.floor].plan.ordinal);
  return rides;
}

Rides rides_in(const Reader& reader, std::string_view text) {
  Rides rides;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(reader.then), text.size());
    const std::string_view phrase = text.substr(0, end);
    const std::size_t kind = test::said_first(reader.ride, phrase);
    const bool up = phrase.find(reader.up) != std::string_view::npos;
    const bool down = phrase.find(reader.down) != std::string_view::npos;
    if (kind < reader.ride.size() && up != down) rides.emplace_back(kind, up);
    text.remove_prefix(std::min(end + reader.then.size(), text.size()));
  }
  return rides;
}

/// Where it stands in its room, and on what.
void expect_goal(const Reader& reader, std::string_view text, const directions::GoalPart& goal) {
  const std::string said = without_names(reader, text);
  const auto says = [&](std::string_view words) { return said.find(words) != std::string::npos; };
  EXPECT_EQ(test::said_first(reader.where, said), static_cast<std::size_t>(goal.where)) << text;
  EXPECT_EQ(says(reader.on_wall), goal.setting == directions::Setting::OnWall) << text;
  EXPECT_EQ(says(reader.in_case), goal.setting == directions::Setting::InCase) << text;
}

/// As any reader would have a sentence, whatever it says.
void expect_sentence(const Reader& reader, const std::string& text) {
  EXPECT_EQ(text.find_first_of("{}_"), std::string::npos) << text;
  EXPECT_TRUE(text.ends_with(reader.stop)) << text;
  if (!reader.stop.empty()) {
    EXPECT_EQ(text.find(reader.stop), text.size() - reader.stop.size()) << "one sentence: " << text;
  }
  for (const std::string_view never : {"  ", " ,", " .", " ،", ", ,", ",,", "，，", "、、"})
    EXPECT_EQ(text.find(never), std::string::npos) << text;
  EXPECT_FALSE(text.starts_with(' ') || text.ends_with(' ')) << text;
  EXPECT_FALSE(test::begins_small(text)) << text;
}

class Sentences : public testing::TestWithParam<std::string_view> {};

TEST_P(Sentences, SayWhatIsSoOnThePlan) {
  const test::SampleHouse& house = test::sample_house();
  const Museum& museum = house.museum;
  const std::uint32_t language = index_of(museum, GetParam());
  const Reader& reader = test::reader_of(GetParam());
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
    for (const std::string& one : {said.way, said.goal, said.figures}) expect_sentence(reader, one);
    const std::string way = test::within_a_sentence(said.way);

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
      expect_door(reader, last_said(reader, way), told.back().steps.back());
    }
    EXPECT_EQ(rides_in(reader, way), rides_of(museum, some.way)) << said.way;

    // The goal's room.
    const std::vector<std::string> rooms = names_in(reader, said.goal);
    const std::uint32_t in =
        told.back().steps.empty() ? told.back().first_room : told.back().steps.back().to;
    ASSERT_EQ(rooms.size(), in == none ? 0U : 1U) << said.goal;
    if (in != none) {
      EXPECT_EQ(rooms.front(), in_language(museum, language, museum.rooms[in].title));
    }
    expect_goal(reader, test::within_a_sentence(said.goal), facts->goal);

    // The figures.
    EXPECT_EQ(number_in(reader, said.figures), std::max(1L, std::lround(some.way.length)));
    const bool has_steps = std::ranges::any_of(some.way.legs, [&](const path::Leg& leg) {
      return !leg.is_along_floor() && !museum.connections[leg.connection].step_free;
    });
    EXPECT_EQ(said.figures.find(reader.free_of_steps) == std::string::npos, has_steps)
        << said.figures;
  }
}

/// All times that a reader of the language knows. The longest first: "about 12 minutes" is not also
/// said to be "about 2 minutes".
std::vector<std::string> known_times(const Museum& museum, std::uint32_t language) {
  std::vector<std::string> known{time_in(museum, language, 1), time_in(museum, language, 20)};
  for (int minutes = 60; minutes > 0; --minutes)
    known.push_back(time_in(museum, language, 60 * minutes));
  std::ranges::stable_sort(known, std::greater{}, &std::string::size);
  return known;
}

/// Those of them that a text says.
std::vector<std::string> times_in(const std::vector<std::string>& known, std::string text) {
  std::vector<std::string> all;
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
  const std::uint32_t language = index_of(museum, GetParam());
  std::mt19937 random(11 + language);
  const auto share = [&] { return static_cast<double>(random() % 1000) / 1000; };
  const std::vector<std::string> known = known_times(museum, language);
  PieceCache cache({test::boxes, {}}, 1, 1 << 20);
  int moments = 0, halves = 0;
  for (int n = 0; n < 1000; ++n) {
    const test::SomeWay some = test::some_way(random);
    const auto facts = directions::direct(museum, house.doorways, some.start, some.way, some.goal);
    ASSERT_TRUE(facts);
    const ShownWay way{*facts, museum.kiosk_floor, {}};  // the plan is the same for all
    ViewRequest request;
    request.state.language = language;
    request.state.screen = Screen::Walking;
    request.state.exhibit = some.goal.exhibit.value_or(0);
    const bool is_another = n % 5 == 0;
    request.route_summary = RouteSummary{path::RouteStatus::Ok,
                                         is_another ? 60 * share() : facts->metres + share() - 0.5,
                                         facts->seconds * (0.5 + share()), std::nullopt};
    const auto view = make_view(museum, request, cache, {}, &way);
    std::vector<std::string> said;
    for (const Words& words : view->words)
      for (std::string& time : times_in(known, words.text)) said.push_back(std::move(time));
    ASSERT_FALSE(said.empty());
    const std::string wanted = time_in(museum, language, facts->seconds);
    for (const std::string& time : said) EXPECT_EQ(time, wanted) << facts->metres << " m";
    moments += wanted == time_in(museum, language, 1) ? 1 : 0;
    halves += wanted == time_in(museum, language, 20) ? 1 : 0;
  }
  EXPECT_GT(moments, 5);
  EXPECT_GT(halves, 50);
}

INSTANTIATE_TEST_SUITE_P(InEveryLanguage, Sentences, testing::ValuesIn(test::shipped_languages),
                         [](const auto& language) { return std::string(language.param); });

/// Whatever number it is: the words for 1 and 2, and the form that a language has for the others.
TEST_P(Sentences, SayMinutesAndMetresInTheFormThatTheirNumberTakes) {
  const Museum& museum = test::sample_house().museum;
  const std::uint32_t language = index_of(museum, GetParam());
  const Reader& reader = test::reader_of(GetParam());

  for (long minutes = 1; minutes <= 240; ++minutes)
    EXPECT_EQ(time_in(museum, language, static_cast<double>(60 * minutes)),
              reader.minutes(test::written(reader, minutes), minutes));
  for (long metres = 1; metres <= farthest_spoken; metres += metres < 20     ? 1
                                                             : metres < 100  ? 5
                                                             : metres < 1000 ? 50
                                                                             : 100)
    EXPECT_EQ(spoken_distance(museum, language, static_cast<double>(metres)),
              reader.metres(std::to_string(metres), metres));
}

/// A name is whatever staff wrote, in quotation marks: no word beside it may hang on how it begins
/// or ends, on its gender or its number.
TEST_P(Sentences, TakeAnyName) {
  const Museum& museum = test::sample_house().museum;
  const Reader& reader = test::reader_of(GetParam());

  for (const auto& [key, text] : museum.languages[index_of(museum, GetParam())].words) {
    std::string bare = filled_in(filled_in(text, "rooms", "{room}"), "floor", "{room}");
    for (const std::string_view quote : {reader.open_quote, reader.close_quote})
      for (std::size_t at = bare.find(quote); at != std::string::npos; at = bare.find(quote))
        bare.erase(at, quote.size());
    for (const std::string_view never : reader.never)
      EXPECT_EQ(bare.find(never), std::string::npos) << key << " = " << text;
  }
}

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

  EXPECT_EQ(names_in(test::reader_of("en"), said.way).size(), 3U) << said.way;
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
