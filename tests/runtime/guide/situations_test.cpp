// What people on narrow floors have to get out of. Every walk is a real one, 60 frames a second.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <numeric>

#include "runtime/plan/plan.h"
#include "tests/runtime/guide/situations.h"

namespace docent::test::situations_test {
namespace {

struct Named {
  const char* name;
  Situation (*make)();
};

void PrintTo(const Named& situation, std::ostream* out) {
  *out << situation.name;
}

class Situations : public testing::TestWithParam<Named> {};

TEST_P(Situations, EndWithEverybodyWhereTheyWantedAndNobodyTouched) {
  const Situation situation = GetParam().make();

  const Scene scene = play(situation);

  const std::vector<double> alone = seconds_alone(situation);
  const auto count = static_cast<double>(situation.parts.size());
  const double took = std::reduce(scene.arrival.begin(), scene.arrival.end()) / count;
  const double takes = std::reduce(alone.begin(), alone.end()) / count;
  RecordProperty("seconds", std::to_string(took));
  RecordProperty("seconds_alone", std::to_string(takes));
  std::printf("%-10s mean %.1f s, alone %.1f s; overlap %.1f mm, clearance %.3f m, step %.2f ms\n",
              GetParam().name, took, takes, 1e3 * scene.deepest_overlap, scene.least_clearance,
              scene.step_ms);
  if (const char* folder = std::getenv("DOCENT_PICTURES"))
    draw_scene(situation, scene,
               std::filesystem::path(folder) / (GetParam().name + std::string(".svg")));
  EXPECT_TRUE(scene.all_arrived());
  EXPECT_LE(scene.deepest_overlap, 0.005);
  EXPECT_GE(scene.least_clearance, scene.radius - 0.01);
  EXPECT_LE(scene.quickest_change, 0.04);
}

INSTANTIATE_TEST_SUITE_P(
    Of, Situations,
    testing::Values(Named{"corridor", head_on_in_a_corridor},
                    Named{"doorway", head_on_in_a_doorway}, Named{"crossing", four_ways},
                    Named{"twelve", twelve_through_a_doorway}, Named{"overtaking", overtaking},
                    Named{"inTheWay", one_in_the_way}, Named{"ring", ring_of_sixteen}),
    [](const auto& each) { return std::string(each.param.name); });

TEST(OneSpot, IsEnteredByTheSecondWhenTheFirstHasGoneOn) {
  Situation situation = head_on_in_a_corridor();
  situation.parts = {{at(1, 0.7), at(6, 0.7)}, {at(1, 0.7), at(4, 0.7)}};

  const Scene scene = play(situation);

  EXPECT_TRUE(scene.all_arrived());
  EXPECT_GT(scene.arrival[1], seconds_alone(situation)[1] + 0.5);
  EXPECT_GE(glm::distance(scene.track[0].back().position, scene.track[1].back().position),
            2 * scene.radius);
}

TEST(WhoIsHeldUp, GoesOnAsSoonAsTheOneInTheWaySetsOut) {
  Situation situation = head_on_in_a_corridor();
  HallMaker narrow;
  narrow.room({0, 0}, {14, 0.8});
  situation.plan = narrow.plan;
  situation.parts = {{at(1, 0.4), at(9, 0.4)}, {at(4, 0.4), at(4.6, 0.4)}};
  situation.parts[1].rank = 2 * plan::never_yields;
  situation.parts[1].then = {at(12, 0.4)};
  situation.parts[1].rests = 12;

  const Scene scene = play(situation);

  EXPECT_TRUE(scene.all_arrived());
  const auto moves_at = [&](std::size_t who) {
    const auto& track = scene.track[who];
    const auto frame = static_cast<std::size_t>(11.5 * 60);
    for (std::size_t f = frame; f < track.size(); ++f)
      if (glm::distance(track[f].position, track[frame].position) > 0.05)
        return static_cast<double>(f) / 60;
    return 1e9;
  };
  EXPECT_GT(moves_at(0), moves_at(1));
  EXPECT_LT(moves_at(0), moves_at(1) + 2.5);
}

TEST(OneGoal, OfTwoIsHeldByOneAndTheOtherStandsCloseBy) {
  Situation situation = four_ways();
  situation.parts = {{at(1, 5), at(5, 5)}, {at(9, 5, 180), at(5, 5, 180)}};

  const Scene scene = play(situation);

  EXPECT_TRUE(scene.all_arrived());
  EXPECT_LE(scene.deepest_overlap, 0.005);
  for (const auto& track : scene.track)
    EXPECT_LT(glm::distance(track.back().position, Vec2(5, 5)), 2);
}

}  // namespace
}  // namespace docent::test::situations_test
