#include "runtime/model/place_kind.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

namespace docent::place_kind_test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<PlaceKind> kinds_of(const std::map<std::string_view, std::string_view>& tags) {
  return place_kinds_of_osm([&](std::string_view key) {
    const auto tag = tags.find(key);
    return tag == tags.end() ? std::string_view() : tag->second;
  });
}

TEST(PlaceKind, HasARowAndANameOfItsOwnForEveryKind) {
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < place_kind_count; ++i) {
    EXPECT_EQ(place_kinds[i].kind, static_cast<PlaceKind>(i));
    names.insert(place_kinds[i].name);
    EXPECT_EQ(place_kind_named(place_kinds[i].name), place_kinds[i].kind);
  }
  EXPECT_EQ(names.size(), place_kind_count);
  EXPECT_EQ(place_kind_named("toilet"), std::nullopt);
}

TEST(PlaceKind, GivesEachCategoryOfImdfToOneKindAlone) {
  std::set<std::string_view> categories;
  std::size_t count = 0;
  for (const PlaceKindInfo& info : place_kinds)
    for (const std::string_view category : info.imdf)
      if (!category.empty()) {
        categories.insert(category);
        ++count;
      }
  EXPECT_EQ(categories.size(), count);
}

TEST(PlaceKind, OfAnImdfCategoryWithAnUnknownPartIsThatOfTheRest) {
  EXPECT_EQ(place_kind_of_imdf("restroom"), PlaceKind::Toilets);
  EXPECT_EQ(place_kind_of_imdf("restroom.wheelchair"), PlaceKind::AccessibleToilets);
  EXPECT_EQ(place_kind_of_imdf("restroom.female.left"), PlaceKind::WomensToilets);
  EXPECT_EQ(place_kind_of_imdf("information.bag"), PlaceKind::Information);
  EXPECT_EQ(place_kind_of_imdf("fieldofplay"), std::nullopt);
  EXPECT_EQ(place_kind_of_imdf(""), std::nullopt);
}

TEST(PlaceKind, OfAToiletForWheelsAnswersWhoAsksForToilets) {
  EXPECT_TRUE(answers(PlaceKind::AccessibleToilets, PlaceKind::Toilets));
  EXPECT_FALSE(answers(PlaceKind::Toilets, PlaceKind::AccessibleToilets));
  EXPECT_FALSE(answers(PlaceKind::EmergencyExit, PlaceKind::Exit));
}

TEST(PlaceKind, IsReadFromAllTagsOfOpenStreetMapThatMeanOne) {
  EXPECT_THAT(kinds_of({{"amenity", "toilets"}, {"wheelchair", "yes"}, {"changing_table", "yes"}}),
              ElementsAre(PlaceKind::AccessibleToilets, PlaceKind::BabyChange));
  EXPECT_THAT(kinds_of({{"amenity", "toilets"}, {"wheelchair", "no"}}),
              ElementsAre(PlaceKind::Toilets));
  EXPECT_THAT(kinds_of({{"shop", "ticket"}}), ElementsAre(PlaceKind::Tickets));
  EXPECT_THAT(kinds_of({{"shop", "books"}}), ElementsAre(PlaceKind::Shop));
  EXPECT_THAT(kinds_of({{"shop", "no"}}), IsEmpty());
  EXPECT_THAT(kinds_of({{"indoor", "room"}}), IsEmpty());
}

}  // namespace
}  // namespace docent::place_kind_test
