#include "content/compile/compile_places.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "platform/sqlite/content_reader.h"
#include "tests/support/house_folder.h"

namespace docent::compile::compile_places_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::SizeIs;

constexpr std::string_view two_places =
    "[[place]]\n"
    "id = \"wc-ground\"\n"
    "kind = \"accessible_toilets\"\n"
    "position = [12.5, 1]\n"
    "title.en = \"Toilets by the lift\"\n"
    "[[place]]\n"
    "id = \"bench\"\n"
    "kind = \"seat\"\n"
    "floor = \"upper\"\n"
    "position = [3, 3]\n";

class House : public test::HouseFolder {
 public:
  explicit House(std::string_view places) {
    replace("museum.toml", "[[connection]]\nid = \"stairs\"",
            std::string(places) + "[[connection]]\nid = \"stairs\"");
  }
};

TEST(Places, AreKeptWithWhereOneStandsToUseThem) {
  const House house(two_places);
  ASSERT_EQ(house.compile().exit_code, 0) << house.compile().err;

  const Museum museum = sqlite::load_museum(house.database()).value_or(Museum{});

  ASSERT_THAT(museum.places, SizeIs(2));
  EXPECT_EQ(museum.places[0].id, "wc-ground");
  EXPECT_EQ(museum.places[0].kind, PlaceKind::AccessibleToilets);
  EXPECT_EQ(museum.places[0].position, Vec2(12.5, 1));
  EXPECT_NEAR(museum.places[0].standing.x, 11.7, 0.011) << "before the wall that it is behind";
  EXPECT_NEAR(museum.places[0].standing.y, 1, 0.011);
  EXPECT_EQ(museum.places[0].title.at("en"), "Toilets by the lift");
  EXPECT_EQ(museum.places[1].floor, 1U);
  EXPECT_EQ(museum.places[1].standing, Vec2(3, 3));
}

TEST(Places, AreToldOfByInfo) {
  const House house(two_places);
  ASSERT_EQ(house.compile().exit_code, 0);

  const test::ProgramRun run =
      test::run_program("docent-content", "info --json '" + house.database().string() + "'");

  EXPECT_THAT(run.out, AllOf(HasSubstr(R"("places":2)"),
                             HasSubstr(R"("place_kinds":{"accessible_toilets":1,"seat":1})")));
}

TEST(Places, AreNotFarFromEverybody) {
  House house(two_places);
  house.replace("museum.toml", "position = [12.5, 1]", "position = [19, 1]");

  EXPECT_THAT(house.compile().err,
              AllOf(HasSubstr("error[place-outside-floor]"), HasSubstr("place 'wc-ground'"),
                    HasSubstr("7.00 m from the floor of 'ground'"), HasSubstr("[11.70, 1.00]")));
}

TEST(Places, CanBeReachedFromTheKiosk) {
  House house(two_places);
  house.replace("museum.toml", "{floor = \"ground\", position = [1, 4], facing = 180}",
                "{floor = \"ground\", position = [1, 4]}");
  house.write("hall.geojson",
              R"({"type": "MultiPolygon", "coordinates": [
                  [[[0, 0], [12, 0], [12, 8], [0, 8], [0, 0]]],
                  [[[20, 0], [24, 0], [24, 8], [20, 8], [20, 0]]]]})");
  house.replace("museum.toml", "position = [3, 3]", "position = [22, 3]");

  EXPECT_THAT(house.compile().err, AllOf(HasSubstr("error[place-unreachable]"),
                                         HasSubstr("get from the kiosk to place 'bench'")));
}

TEST(Places, AreOfAKindThatThereIs) {
  House house(two_places);
  house.replace("museum.toml", "\"seat\"", "\"sofa\"");

  EXPECT_THAT(house.compile().err,
              AllOf(HasSubstr("error[bad-value]"), HasSubstr("'kind' cannot")));
}

TEST(Places, HaveAnIdOfTheirOwn) {
  House house(two_places);
  house.replace("museum.toml", "\"bench\"", "\"wc-ground\"");

  EXPECT_THAT(house.compile().err, HasSubstr("there are two places with the id 'wc-ground'"));
}

}  // namespace
}  // namespace docent::compile::compile_places_test
