#include "content/scenery/object_stand.h"

#include <gtest/gtest.h>

#include <cmath>

#include "runtime/model/geometry/polygon.h"

namespace docent::scenery::object_stand_test {
namespace {

const Outline square{{0, 0}, {1.2, 0}, {1.2, 1.2}, {0, 1.2}};

ExhibitStand in(HoleKind kind, Vec2 at) {
  return {.exhibit = 0, .placement = {at, 0.3}, .on = kind, .hole = &square};
}

/// Nothing of it sticks out, whichever way it is turned.
void expect_within(const PlacedObject& placed, Vec3 size, double margin) {
  const double reach = placed.stand.scale * std::hypot(size.x, size.z) / 2;
  for (int i = 0; i < 36; ++i) {
    const double angle = i * 0.1745;
    const Vec2 edge = placed.stand.position + reach * Vec2{std::cos(angle), std::sin(angle)};
    EXPECT_TRUE(contains(inset(square, margin - 1e-6), edge));
  }
}

TEST(PlaceObject, KeepsASmallThingInItsCaseAsLargeAsItIs) {
  const PlacedObject placed = place_object(in(HoleKind::Case, {0.6, 0.6}), {0.04F, 0.06F, 0.03F});

  EXPECT_EQ(placed.stand.scale, 1);
  EXPECT_EQ(placed.stand.position, Vec2(0.6, 0.6));
  EXPECT_NEAR(placed.stand.base, top_of(HoleKind::Case, square), 0.01);
  EXPECT_TRUE(placed.plinth.empty());
}

TEST(PlaceObject, MakesALargeThingAsSmallAsItsGlass) {
  const Vec3 tall{0.8F, 1.6F, 0.6F}, wide{3, 0.2F, 0.5F};
  for (const Vec3 size : {tall, wide}) {
    const PlacedObject placed = place_object(in(HoleKind::Case, {0.6, 0.6}), size);

    EXPECT_LT(placed.stand.scale, 1);
    EXPECT_LE(placed.stand.base + placed.stand.scale * size.y, glass_top);
    expect_within(placed, size, 0.08);
  }
}

TEST(PlaceObject, MovesItTowardsTheMiddleWhereItStandsAtTheEdge) {
  const Vec3 size{0.5F, 0.3F, 0.5F};
  const PlacedObject placed = place_object(in(HoleKind::Pedestal, {0.15, 0.6}), size);

  EXPECT_GT(placed.stand.position.x, 0.15);
  EXPECT_NEAR(placed.stand.scale, 1, 0.02);
  expect_within(placed, size, 0.02);
}

TEST(PlaceObject, LiftsASmallThingOnTheFloorAndLeavesAStatueThere) {
  ExhibitStand stand{.exhibit = 0, .placement = {{5, 5}, 0}, .taken = {0.8, 0.8}};
  const PlacedObject small = place_object(stand, {0.1F, 0.1F, 0.1F});
  const PlacedObject statue = place_object(stand, {0.5F, 1.7F, 0.4F});

  EXPECT_GT(small.plinth_height, 0.8);
  EXPECT_LT(statue.plinth_height, 0.1);
  EXPECT_EQ(statue.stand.scale, 1);
  EXPECT_EQ(statue.plinth.size(), 4U);
}

TEST(PlaceObject, StaysBelowWhatCamerasLookOver) {
  ExhibitStand stand{.exhibit = 0, .placement = {{5, 5}, 0}, .taken = {2, 2}};
  const PlacedObject placed = place_object(stand, {0.5F, 6, 0.5F});

  EXPECT_LE(placed.stand.base + placed.stand.scale * 6, 2.31);
}

}  // namespace
}  // namespace docent::scenery::object_stand_test
