#include "content/compile/compile_tours.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "platform/sqlite/content_reader.h"
#include "tests/support/house_folder.h"

namespace docent::compile::compile_tours_test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::Pair;

/// The house with a third exhibit, and with a tour of such lines.
class HouseWithTour : public test::HouseFolder {
 public:
  explicit HouseWithTour(const std::string& lines) {
    replace("exhibits/hall.toml", "[[exhibit]]\nid = \"vase\"",
            "[[exhibit]]\nid = \"coin\"\nposition = [10, 7]\nview = [10, 4]\nfacing = 270\n"
            "title.en = \"Coin\"\nweight = 5\nlooking_seconds = 20\n"
            "[[exhibit]]\nid = \"vase\"");
    replace("museum.toml", "[kiosk]",
            "[[tour]]\nid = \"all\"\ntitle.en = \"All of it\"\n" + lines + "[kiosk]");
  }
};
std::string complaint(const test::HouseFolder& house) {
  return house.compile().err;
}
Museum compiled(const test::HouseFolder& house) {
  const test::ProgramRun run = house.compile();
  EXPECT_EQ(run.exit_code, 0) << run.err;
  return sqlite::load_museum(house.database()).value_or(Museum{});
}
std::vector<std::string> ids(const Museum& museum, const Tour& tour) {
  std::vector<std::string> ids;
  for (const std::uint32_t i : tour.exhibits) ids.push_back(museum.exhibits[i].id);
  return ids;
}

TEST(Tours, GoTheShortestWayFromTheKiosk) {
  const Museum museum = compiled(HouseWithTour("exhibits = [\"sword\", \"vase\", \"coin\"]\n"));

  ASSERT_FALSE(museum.tours.empty());
  const Tour& tour = museum.tours.front();
  EXPECT_EQ(tour.title.at("en"), "All of it");
  EXPECT_THAT(ids(museum, tour), ElementsAre("coin", "vase", "sword"))
      << "the lift is waited for, so the stairs, in the west, come last";
  ASSERT_EQ(tour.arrives.size(), 3U);
  EXPECT_NEAR(tour.arrives[1], tour.arrives[0] + 20 + 4, 1e-9) << "a look of 20 s, 4 m";
  EXPECT_NEAR(tour.arrives[2], tour.arrives[1] + 60 + 5 + 20 + 5, 1e-9) << "stairs of 20 s";
  EXPECT_NEAR(tour.seconds, tour.arrives[2] + 60, 1e-9);
}

TEST(Tours, KeepTheOrderThatStaffFixed) {
  const Museum museum =
      compiled(HouseWithTour("exhibits = [\"sword\", \"vase\", \"coin\"]\nfixed = true\n"));

  EXPECT_THAT(ids(museum, museum.tours.front()), ElementsAre("sword", "vase", "coin"));
  EXPECT_TRUE(museum.tours.front().fixed);
}

TEST(Tours, AreTheBestThatThereIsTimeForWhereOnlyMinutesAreSaid) {
  const Museum museum = compiled(HouseWithTour("minutes = 1\n"));

  EXPECT_THAT(ids(museum, museum.tours.front()), ElementsAre("coin")) << "it weighs five";
  EXPECT_LE(museum.tours.front().seconds, 60);
}

TEST(Tours, ThatTakeLongerThanTheySayAreTold) {
  const HouseWithTour house("exhibits = [\"sword\", \"vase\"]\nminutes = 2\n");

  EXPECT_THAT(
      complaint(house),
      AllOf(HasSubstr("warning[tour-too-long]: tour 'all' takes 3 minutes, more than the 2"),
            HasSubstr("write minutes = 3")));
}

TEST(Tours, NameExhibitsThatThereAreAndEachOnce) {
  EXPECT_THAT(complaint(HouseWithTour("exhibits = [\"vase\", \"swords\"]\n")),
              AllOf(HasSubstr("error[unknown-exhibit]: tour 'all' names an exhibit that is not "
                              "there: 'swords'"),
                    HasSubstr("did you mean 'sword'?")));
  EXPECT_THAT(complaint(HouseWithTour("exhibits = [\"vase\", \"vase\"]\n")),
              HasSubstr("tour 'all' names exhibit 'vase' twice"));
}

TEST(Tours, HaveExhibitsOrMinutes) {
  EXPECT_THAT(complaint(HouseWithTour("")),
              HasSubstr("tour 'all' has neither exhibits nor minutes"));
  EXPECT_THAT(complaint(HouseWithTour("exhibits = []\n")),
              HasSubstr("tour 'all' has neither exhibits nor minutes"));
}

TEST(Tours, CannotGoBackUpAnEscalatorThatRunsDown) {
  HouseWithTour house("exhibits = [\"sword\", \"vase\"]\nfixed = true\n");
  house.replace("museum.toml", "kind = \"stairs\"", "kind = \"escalator\"\ndirection = \"up\"");
  house.replace("museum.toml", "kind = \"lift\"", "kind = \"escalator\"\ndirection = \"up\"");

  EXPECT_THAT(complaint(house),
              AllOf(HasSubstr("error[tour-without-way]: tour 'all' cannot be walked: there is no "
                              "way to exhibit 'vase'"),
                    HasSubstr("leave fixed = true away")));
  house.replace("museum.toml", "fixed = true", "");
  EXPECT_THAT(complaint(house), Not(HasSubstr("tour-without-way"))) << "first the vase";
}

/// How many exhibits there are, and the minutes, of the tours for who has so much time.
std::vector<std::pair<double, std::size_t>> for_time(const Museum& museum) {
  std::vector<std::pair<double, std::size_t>> all;
  for (const Tour& tour : museum.tours)
    if (is_for_time(tour)) {
      EXPECT_LE(tour.seconds, 60 * tour.minutes);
      all.emplace_back(tour.minutes, tour.exhibits.size());
    }
  return all;
}

TEST(ToursByTime, AreMadeWithoutBeingAskedForAsFarAsMoreTimeShowsMore) {
  const Museum museum = compiled(HouseWithTour("exhibits = [\"vase\"]\n"));

  EXPECT_THAT(for_time(museum), ElementsAre(Pair(15, 3))) << "the house has no more to show";
  EXPECT_EQ(museum.tours.back().id, "minutes-15") << "behind those of staff";
}

TEST(ToursByTime, AreThoseThatStaffAskFor) {
  HouseWithTour house("exhibits = [\"vase\"]\n");
  const auto with = [&](const std::string& minutes) {
    house.replace("museum.toml", "[museum]\n", "[museum]\nminutes = " + minutes + "\n");
    const Museum museum = compiled(house);
    house.replace("museum.toml", "minutes = " + minutes + "\n", "");
    return for_time(museum);
  };
  for (const char* id : {"vase", "sword"})
    house.replace("exhibits/hall.toml", std::string("id = \"") + id + "\"",
                  std::string("id = \"") + id + "\"\nlooking_seconds = 400");

  EXPECT_THAT(with("[20, 10, 8]"), ElementsAre(Pair(8, 2), Pair(20, 3)))
      << "in 10 minutes one sees no more than in 8";
  EXPECT_THAT(with("[]"), testing::IsEmpty());
}

TEST(ToursByTime, AreToldOfMinutesThatAreNoTime) {
  const auto told = [](const std::string& minutes) {
    HouseWithTour house("exhibits = [\"vase\"]\n");
    house.replace("museum.toml", "[museum]\n", "[museum]\nminutes = " + minutes + "\n");
    return complaint(house);
  };

  EXPECT_THAT(told("30"), HasSubstr("'minutes' should be a list of numbers: [15, 30]"));
  EXPECT_THAT(told("[\"30\"]"), HasSubstr("'minutes' should be a list of numbers: [15, 30]"));
  EXPECT_THAT(told("[30, 1]"), HasSubstr("'minutes'"));
  EXPECT_THAT(told("[nan]"), HasSubstr("'minutes'"));
  EXPECT_THAT(told("[1e9]"), HasSubstr("'minutes'"));
}

TEST(Tours, NeedTitlesInEveryLanguage) {
  HouseWithTour house("exhibits = [\"vase\"]\ntitle.zh = \"全部\"\n");

  EXPECT_THAT(complaint(house), HasSubstr("the title of tour 'all' is given in 'zh', which the "
                                          "museum does not speak"));
}

}  // namespace
}  // namespace docent::compile::compile_tours_test
