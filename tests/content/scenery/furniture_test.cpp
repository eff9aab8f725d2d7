#include "content/scenery/furniture.h"

#include <gmock/gmock.h>
#include <rapidcheck.h>

#include <cmath>
#include <numbers>

#include "tests/support/halls.h"

namespace docent::scenery::furniture_test {
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

double number(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 1001) / 1000.0;
}

/// The outline goes round it counter-clockwise and is convex.
bool is_within(const Outline& outline, Vec2 p) {
  for (std::size_t i = 0; i < outline.size(); ++i)
    if (cross(outline[(i + 1) % outline.size()] - outline[i], p - outline[i]) < -1e-6) return false;
  return true;
}

TEST(APictureBoard, StaysWithinItsCaseOrPedestalWhereverItStandsThere) {
  EXPECT_TRUE(rc::check("from all sides, of any shape, wherever it is placed", [] {
    const Vec2 size{number(0.5, 4.4), number(0.5, 3)};
    const Outline hole{{0, 0}, {size.x, 0}, size, {0, size.y}};
    const bool in_case = *rc::gen::arbitrary<bool>();
    const ExhibitStand stand{.exhibit = 0,
                             .placement = {{number(0.2, size.x - 0.2), number(0.2, size.y - 0.2)},
                                           number(-std::numbers::pi, std::numbers::pi)},
                             .aspect = static_cast<float>(number(0.3, 3)),
                             .on = in_case ? HoleKind::Case : HoleKind::Pedestal,
                             .hole = &hole};
    MeshBuilder mesh;
    std::vector<Blocker> blockers;
    build_stand(stand, mesh, blockers);

    for (const SceneryVertex& vertex : std::move(mesh).finish().vertices) {
      RC_ASSERT(is_within(hole, to_floor(vertex.position)));
      RC_ASSERT(!in_case || vertex.position.y < 1.5F);
    }
  }));
}

TEST(APictureOnAWall, EndsBelowTheCut) {
  for (const float aspect : {0.2F, 0.7F, 1.0F, 1.6F, 5.0F}) {
    MeshBuilder mesh;
    std::vector<Blocker> blockers;
    build_stand({.exhibit = 0, .placement = {}, .aspect = aspect, .on_wall = true}, mesh, blockers);
    for (const SceneryVertex& vertex : std::move(mesh).finish().vertices)
      EXPECT_LT(vertex.position.y, cut_height) << aspect;
  }
}

TEST(Insetting, MovesEverySideInwardsByTheDistance) {
  const Outline square{{0, 0}, {2, 0}, {2, 2}, {0, 2}};

  const Outline smaller = inset(square, 0.25);

  EXPECT_THAT(smaller,
              ElementsAre(Vec2{0.25, 0.25}, Vec2{1.75, 0.25}, Vec2{1.75, 1.75}, Vec2{0.25, 1.75}));
}

}  // namespace
}  // namespace docent::scenery::furniture_test
