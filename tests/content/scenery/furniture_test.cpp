#include "content/scenery/furniture.h"

#include <gmock/gmock.h>

#include "tests/support/halls.h"

namespace docent::scenery {
namespace {

using ::testing::ElementsAre;

Exhibit in_case_at(Vec2 position) {
  Exhibit exhibit;
  exhibit.placement.position = position;
  exhibit.place = ExhibitPlace::InCase;
  return exhibit;
}

test::HallMaker hall() {
  return test::HallMaker().room({0, 0}, {20, 20});
}

std::vector<HoleKind> kinds(const test::HallMaker& maker, std::span<const Exhibit> exhibits = {}) {
  return hole_kinds(maker.plan, exhibits);
}

TEST(Holes, AreColumnsWhereRoundAndSlim) {
  EXPECT_THAT(kinds(hall().column({5, 5}, 0.3)), ElementsAre(HoleKind::Wall, HoleKind::Column));
}

TEST(Holes, AreColumnsWhereSquareAndSmall) {
  EXPECT_THAT(kinds(hall().block({5, 5}, {5.6, 5.6})),
              ElementsAre(HoleKind::Wall, HoleKind::Column));
}

TEST(Holes, AreCasesAtTheSizeOfACase) {
  EXPECT_THAT(kinds(hall().block({5, 5}, {6.6, 5.9})), ElementsAre(HoleKind::Wall, HoleKind::Case));
}

TEST(Holes, ArePartitionsWhereThin) {
  EXPECT_THAT(kinds(hall().block({5, 5}, {5.35, 9})), ElementsAre(HoleKind::Wall, HoleKind::Wall));
}

TEST(Holes, ArePartitionsWhereBent) {
  const Vec2 ell[] = {{5, 5}, {5, 8}, {5.35, 8}, {5.35, 5.35}, {8, 5.35}, {8, 5}};
  EXPECT_THAT(kinds(hall().ring(ell)), ElementsAre(HoleKind::Wall, HoleKind::Wall));
}

TEST(Holes, ArePartOfTheBuildingWhereLarge) {
  EXPECT_THAT(kinds(hall().block({5, 5}, {11, 12})), ElementsAre(HoleKind::Wall, HoleKind::Wall));
}

TEST(Holes, ArePedestalsWhereSmallOrRoundAndSomethingStandsOnThem) {
  const Exhibit exhibits[] = {in_case_at({5.4, 5.4}), in_case_at({12, 12})};
  EXPECT_THAT(kinds(hall().block({5, 5}, {5.8, 5.8}).column({12, 12}, 1.5), exhibits),
              ElementsAre(HoleKind::Wall, HoleKind::Pedestal, HoleKind::Pedestal));
}

TEST(Holes, AreLargeCasesWhereSomethingStandsInThem) {
  const Exhibit exhibits[] = {in_case_at({6, 5.5})};
  EXPECT_THAT(kinds(hall().block({5, 5}, {8.5, 6.5}), exhibits),
              ElementsAre(HoleKind::Wall, HoleKind::Case));
}

TEST(Insetting, MovesEverySideInwardsByTheDistance) {
  const Outline square{{0, 0}, {2, 0}, {2, 2}, {0, 2}};

  const Outline smaller = inset(square, 0.25);

  EXPECT_THAT(smaller,
              ElementsAre(Vec2{0.25, 0.25}, Vec2{1.75, 0.25}, Vec2{1.75, 1.75}, Vec2{0.25, 1.75}));
}

}  // namespace
}  // namespace docent::scenery
