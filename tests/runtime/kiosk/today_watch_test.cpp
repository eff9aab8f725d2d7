#include "runtime/kiosk/today_watch.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <mutex>
#include <sstream>
#include <thread>

#include "platform/sqlite/content_reader.h"
#include "runtime/path/building/building_map.h"
#include "tests/support/two_door_hall.h"

namespace docent::kiosk::today_watch_test {
namespace {

using testing::HasSubstr;

constexpr std::string_view south_closed = "[[closed]]\ndoor = \"south\"\n";

class AHallWithTwoDoors : public ::testing::Test {
 protected:
  AHallWithTwoDoors() {
    const test::ProgramRun compiled = hall_.compile();
    EXPECT_EQ(compiled.exit_code, 0) << compiled.err;
    museum_ = sqlite::load_museum(hall_.database()).value_or(Museum{});
  }
  std::filesystem::path today() const { return hall_.database().parent_path() / "today.toml"; }
  void write_today(std::string_view text) const { std::ofstream(today()) << text; }

  test::TwoDoorHall hall_;
  Museum museum_;
};

/// Metres from the kiosk to the vase.
double length(const path::BuildingMap& building, const Museum& museum) {
  const path::BuildingWay way =
      building.route({.way = {.from = museum.kiosk.position,
                              .to = museum.exhibits[0].viewing_point.position,
                              .radius = museum.body_radius}});
  return way.status == path::BuildingStatus::Ok ? way.length : -1;
}

TEST_F(AHallWithTwoDoors, ClosesWithinASecondWhatTodaySays) {
  path::BuildingMap building(museum_, {path::make_floor_map(museum_.floors[0])});
  const double open = length(building, museum_);
  TodayWatch watch(
      museum_, [&](const Closures& closed) { building.close(building.closure(closed)); }, today(),
      false);
  EXPECT_EQ(length(building, museum_), open);

  write_today(south_closed);
  std::this_thread::sleep_for(std::chrono::seconds(1));

  EXPECT_GT(length(building, museum_), open + 1);
  EXPECT_EQ(watch.changes(), 1U);

  write_today("[[closed]]\ndoor = \"soth\"\n# faulty\n");
  std::this_thread::sleep_for(std::chrono::seconds(1));

  EXPECT_GT(length(building, museum_), open + 1) << "the last good one stays";

  write_today("[[closed]]\nroom = \"east\"\n");
  std::this_thread::sleep_for(std::chrono::seconds(1));

  EXPECT_EQ(length(building, museum_), -1);

  std::filesystem::remove(today());
  std::this_thread::sleep_for(std::chrono::seconds(1));

  EXPECT_EQ(length(building, museum_), open);
}

TEST_F(AHallWithTwoDoors, TellsWhichExhibitsAreClosedAndWhyAndThatTheyAreOpenAgain) {
  std::mutex mutex;
  Closures closed;
  TodayWatch watch(
      museum_,
      [&](const Closures& now) {
        const std::lock_guard lock(mutex);
        closed = now;
      },
      today(), false);
  const auto exhibits = [&] {
    const std::lock_guard lock(mutex);
    return closed.exhibits;
  };

  write_today("[[closed]]\nroom = \"east\"\nreason.en = \"Painters\"\n");
  std::this_thread::sleep_for(std::chrono::seconds(1));

  EXPECT_EQ(exhibits(), (std::vector{ClosedExhibit{0, {}, {{"en", "Painters"}}}}));

  std::filesystem::remove(today());
  std::this_thread::sleep_for(std::chrono::seconds(1));

  EXPECT_TRUE(exhibits().empty());
  EXPECT_EQ(watch.changes(), 2U);
}

/// Plays a visit and gives the places of the guide, frame by frame.
std::vector<Vec2> places_of_guide(const test::MuseumFolder& hall, const std::string& visit) {
  hall.write("a.visit", visit);
  const std::filesystem::path file = hall.path() / "states.csv";
  const test::ProgramRun run = test::run_program(
      "docent",
      fmt::format("--content '{}' --display headless --size 160x90 --visit '{}' "
                  "--states '{}' --seconds 16",
                  hall.database().string(), (hall.path() / "a.visit").string(), file.string()));
  EXPECT_EQ(run.exit_code, 0) << run.err;
  std::ifstream states(file);
  std::vector<Vec2> places;
  std::string line;
  std::getline(states, line);
  while (std::getline(states, line)) {
    std::istringstream row(line);
    double time = 0, avatar = 0, x = 0, y = 0;
    char comma = 0;
    row >> time >> comma >> avatar >> comma >> x >> comma >> y;
    places.emplace_back(x, y);
  }
  return places;
}

/// Where it goes through the wall: how far north; negative where it never does.
double passes_wall_at(const std::vector<Vec2>& places) {
  for (std::size_t i = 1; i < places.size(); ++i)
    if ((places[i - 1].x < 8.1) != (places[i].x < 8.1)) return places[i].y;
  return -1;
}

TEST_F(AHallWithTwoDoors, IsCrossedByTheDoorThatIsOpen) {
  hall_.write("closed.toml", south_closed);
  const std::string file = (hall_.path() / "closed.toml").string();

  EXPECT_LT(passes_wall_at(places_of_guide(hall_, "1 tap @exhibit:vase\n")), 2.4);
  EXPECT_GT(passes_wall_at(places_of_guide(
                hall_, fmt::format("0.5 today {}\n", file) + "1 tap @exhibit:vase\n")),
            5.6);
}

TEST_F(AHallWithTwoDoors, TurnsAGuideRoundWhoseDoorCloses) {
  hall_.write("closed.toml", south_closed);

  const std::vector<Vec2> places = places_of_guide(
      hall_,
      fmt::format("1 tap @exhibit:vase\n5.5 today {}\n", (hall_.path() / "closed.toml").string()));

  ASSERT_GT(places.size(), 400U);
  EXPECT_GT(places[320].x, 3) << "it was on its way";
  EXPECT_GT(passes_wall_at(places), 5.6);
  EXPECT_LT(glm::distance(places.back(), Vec2(10.5, 1.7)), 1.1) << "beside its viewing point";
}

TEST_F(AHallWithTwoDoors, StopsAGuideForWhomThereIsNoWayLeft) {
  hall_.write("closed.toml", "[[closed]]\nroom = \"east\"\n");

  const std::vector<Vec2> places = places_of_guide(
      hall_,
      fmt::format("1 tap @exhibit:vase\n4 today {}\n", (hall_.path() / "closed.toml").string()));

  ASSERT_FALSE(places.empty());
  EXPECT_EQ(passes_wall_at(places), -1);
  EXPECT_LT(places.back().x, 7.9);
}

}  // namespace
}  // namespace docent::kiosk::today_watch_test
