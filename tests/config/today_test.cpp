#include "config/today.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace docent::config::today_test {
namespace {

namespace chr = std::chrono;
using testing::HasSubstr;
using testing::SizeIs;

Museum museum() {
  Museum museum;
  museum.floors.emplace_back().plan.doors = {{.name = "east-gate", .a = {}, .b = {}},
                                             {.name = "west-gate", .a = {}, .b = {}}};
  museum.rooms.resize(1);
  museum.rooms[0].id = "hall";
  museum.exhibits.resize(1);
  museum.exhibits[0].id = "vase";
  museum.connections.resize(1);
  museum.connections[0].id = "lift";
  return museum;
}

LocalMinute minute(unsigned day, int hour, int minutes) {
  return chr::local_days(chr::year(2026) / 12 / chr::day(day)) + chr::hours(hour) +
         chr::minutes(minutes);
}

TEST(Today, NamesWhatIsClosedUntilWhenAndWhy) {
  const auto today = parse_today(
      "[[closed]]\n"
      "door = \"east-gate\"\n"
      "until = 2026-12-24T18:00:00\n"
      "reason.en = \"A filming\"\n"
      "[[closed]]\n"
      "room = \"hall\"\n"
      "until = 2026-12-24\n"
      "[[closed]]\n"
      "connection = \"lift\"\n"
      "[[closed]]\n"
      "exhibit = \"vase\"\n",
      "today.toml", museum());

  ASSERT_TRUE(today.value.has_value()) << today.diagnostics.front().message;
  ASSERT_THAT(today.value->closed, SizeIs(4));
  EXPECT_EQ(today.value->closed[0],
            (TodayClosure{Closable::Door, "east-gate", minute(24, 18, 0), {{"en", "A filming"}}}));
  EXPECT_EQ(today.value->closed[1].until, minute(25, 0, 0)) << "to the end of the day";
  EXPECT_EQ(today.value->closed[2].what, Closable::Connection);
  EXPECT_EQ(today.value->closed[3].until, std::nullopt);
}

TEST(Today, MayCloseNothing) {
  EXPECT_EQ(parse_today("# all open\n", "today.toml", museum()).value, Today{});
}

TEST(Today, IsRefusedWithASentenceWhereAnythingIsWrong) {
  struct Mistake {
    std::string_view text, message;
    std::uint32_t line;
  };
  for (const auto& [text, message, line] : std::vector<Mistake>{
           {"[[closed]]\ndoor = \"east-gat\"\n", "the museum has no door 'east-gat'", 2},
           {"[[closed]]\ndoor = 3\n", "'door' should be a text", 2},
           {"[[closed]]\nuntil = 2026-12-24\n", "[[closed]] names nothing", 1},
           {"[[closed]]\ndoor = \"east-gate\"\nroom = \"hall\"\n", "names several things", 1},
           {"[[closed]]\ndoor = \"east-gate\"\nuntil = \"six\"\n", "'until' should be a day", 3},
           {"[[closed]]\ndoor = \"east-gate\"\nuntil = 2026-12-24T18:00:00Z\n", "'until' should",
            3},
           {"[[closed]]\ndoor = \"east-gate\"\nuntil = 18:00:00\n", "'until' should be a day", 3},
           {"[[closed]]\ndoor = \"east-gate\"\nreason = \"x\"\n", "given by language", 3},
           {"[[closed]]\ndor = \"east-gate\"\n", "[[closed]] has no 'dor'", 2},
           {"[closed]\ndoor = \"east-gate\"\n", "should be written [[closed]]", 1},
           {"[[open]]\ndoor = \"east-gate\"\n", "today.toml has no 'open'", 1},
           {"closed = [3]\n", "should hold tables", 1},
           {"[[closed]\n", "is no heading", 1}}) {
    const auto today = parse_today(text, "today.toml", museum());
    EXPECT_FALSE(today.value.has_value()) << text;
    ASSERT_FALSE(today.diagnostics.empty()) << text;
    EXPECT_THAT(today.diagnostics[0].message, HasSubstr(std::string(message)));
    EXPECT_EQ(today.diagnostics[0].line, line) << text;
  }
}

}  // namespace
}  // namespace docent::config::today_test
