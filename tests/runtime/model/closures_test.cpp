#include "runtime/model/closures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/model/none.h"

namespace docent::closures_test {
namespace {

namespace chr = std::chrono;
using testing::ElementsAre;
using testing::Field;
using testing::IsEmpty;

/// Two rooms side by side with a door between them and one to the outside in the east; a vase in
/// the eastern one. The museum is open from ten to six, but for the lift, which always is.
Museum two_rooms() {
  Museum museum;
  museum.floors.emplace_back().plan.doors = {
      {.name = "between", .a = {4.1, 1}, .b = {4.1, 2}},
      {.name = "outside", .a = {8.3, 1}, .b = {8.3, 2}, .hours = "10:00-18:00"}};
  museum.rooms.resize(2);
  museum.rooms[0].id = "west";
  museum.rooms[0].outline = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  museum.rooms[1].id = "east";
  museum.rooms[1].outline = {{4.2, 0}, {8.2, 0}, {8.2, 4}, {4.2, 4}};
  museum.exhibits.resize(1);
  museum.exhibits[0].id = "vase";
  museum.exhibits[0].room = 1;
  museum.connections.resize(1);
  museum.connections[0].id = "lift";
  return museum;
}

LocalMinute at(int hour) {
  return chr::local_days(chr::year(2026) / 11 / 23) + chr::hours(hour);
}

Today closing(Closable what, std::string id, std::optional<LocalMinute> until = {}) {
  return {.closed = {{.what = what, .id = std::move(id), .until = until}}};
}

TEST(Closures, AreThoseOfTheHours) {
  const Museum museum = two_rooms();
  const ClosureRules rules(museum);

  EXPECT_THAT(rules.at(at(12), {}).doors[0], IsEmpty());
  EXPECT_THAT(rules.at(at(18), {}).doors[0], ElementsAre(1));
  EXPECT_THAT(rules.at({}, {}).doors[0], IsEmpty()) << "no time, no hours";
}

TEST(Closures, OfARoomCloseItsDoorsAndWhatIsInIt) {
  const Museum museum = two_rooms();
  const ClosureRules rules(museum);

  const Closures east = rules.at(at(12), closing(Closable::Room, "east"));
  EXPECT_THAT(east.rooms, ElementsAre(1));
  EXPECT_THAT(east.doors[0], ElementsAre(0, 1));
  EXPECT_THAT(east.exhibits, ElementsAre(Field(&ClosedExhibit::exhibit, 0)));
  const Closures west = rules.at(at(12), closing(Closable::Room, "west"));
  EXPECT_THAT(west.doors[0], ElementsAre(0));
  EXPECT_THAT(west.exhibits, IsEmpty());
}

TEST(Closures, LiveEndWhenTheySay) {
  const Museum museum = two_rooms();
  const ClosureRules rules(museum);
  const Today today = closing(Closable::Connection, "lift", at(15));

  EXPECT_THAT(rules.at(at(14), today).connections, ElementsAre(0));
  EXPECT_THAT(rules.at(at(15), today).connections, IsEmpty());
  EXPECT_THAT(rules.at({}, today).connections, ElementsAre(0));
}

TEST(Closures, ForGoodLeaveOutDoorsThatAreWallsAlready) {
  Museum museum = two_rooms();
  museum.floors[0].plan.doors[0].closed = true;
  museum.exhibits[0].closed = true;
  const ClosureRules rules(museum);

  EXPECT_THAT(rules.at(at(12), {}).doors[0], IsEmpty());
  EXPECT_THAT(rules.at({}, {}).exhibits, ElementsAre(ClosedExhibit{0}));
  EXPECT_EQ(rules.exhibit(0, at(12), {})->until, std::nullopt);
}

TEST(Closures, OfAnExhibitSayUntilWhenAndWhy) {
  Museum museum = two_rooms();
  museum.exhibits[0].hours = "10:00-18:00";
  const ClosureRules rules(museum);
  Today today = closing(Closable::Exhibit, "vase", at(20));
  today.closed[0].reason["en"] = "It is cleaned";

  EXPECT_FALSE(rules.exhibit(0, at(12), {}).has_value());
  EXPECT_EQ(rules.exhibit(0, at(19), {})->until, at(34)) << "tomorrow at ten";
  EXPECT_EQ(rules.exhibit(0, at(12), closing(Closable::Exhibit, "vase", at(15)))->until, at(15));
  const auto closed = rules.exhibit(0, at(12), today);
  EXPECT_EQ(closed->until, at(34)) << "at eight in the evening its hours are over";
  EXPECT_EQ(closed->reason->at("en"), "It is cleaned");
  EXPECT_EQ(rules.exhibit(0, at(12), closing(Closable::Room, "east", at(16)))->until, at(16));
}

TEST(Closures, SayOfEachExhibitUntilWhenAndWhyAndOnWhichDayThatIsSaid) {
  const Museum museum = two_rooms();
  const ClosureRules rules(museum);
  Today today = closing(Closable::Room, "east", at(15));
  today.closed[0].reason["en"] = "The floor is mended";

  const Closures closed = rules.at(at(12), today);

  EXPECT_THAT(closed.exhibits,
              ElementsAre(ClosedExhibit{0, at(15), {{"en", "The floor is mended"}}}));
  EXPECT_EQ(closed.day, chr::floor<chr::days>(at(12)));
  EXPECT_EQ(closed_exhibit(closed, 0), closed.exhibits.data());
  EXPECT_EQ(closed_exhibit(rules.at(at(15), today), 0), nullptr);
  EXPECT_EQ(rules.at({}, today).day, std::nullopt) << "without a clock";
}

TEST(RoomsBeside, AreThoseThatADoorLeadsTo) {
  const Museum museum = two_rooms();
  const auto between = rooms_beside(museum, 0, museum.floors[0].plan.doors[0]);
  const auto outside = rooms_beside(museum, 0, museum.floors[0].plan.doors[1]);

  EXPECT_THAT(between.room, testing::UnorderedElementsAre(0, 1));
  EXPECT_THAT(outside.room, testing::UnorderedElementsAre(1, none));
}

}  // namespace
}  // namespace docent::closures_test
