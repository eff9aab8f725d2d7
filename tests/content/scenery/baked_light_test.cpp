#include "content/scenery/baked_light.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace docent::scenery::baked_light_test {
namespace {

constexpr double wall_height = 1.5;

/// A wall along the y axis, half a metre thick and so long that its ends are out of sight.
HeightField field_with_wall() {
  HeightField field({-4, -8}, {4, 8}, 0.02);
  const std::array<Vec2, 4> wall{Vec2{-0.5, -8}, {0, -8}, {0, 8}, {-0.5, 8}};
  field.raise(wall, wall_height);
  return field;
}

constexpr Sun sun_in_the_west{.azimuth = std::numbers::pi, .elevation = 0.7, .radius = 0.05};

struct Share {
  double sky = 0, sun = 0, shade = 0;  // shade in metres
};

Share floor_share(const Scenery& scenery, Vec2 at) {
  const Vec2 texel = (scenery.lightmap_max - scenery.lightmap_min) /
                     Vec2(scenery.lightmap_width, scenery.lightmap_height);
  const Vec2 cell = (at - scenery.lightmap_min) / texel;
  const std::size_t index =
      static_cast<std::size_t>(cell.y) * scenery.lightmap_width + static_cast<std::size_t>(cell.x);
  const auto channel = [&](std::size_t c) {
    return std::to_integer<int>(scenery.lightmap[index * Scenery::lightmap_channels + c]) / 255.0;
  };
  return {channel(0), channel(1), channel(2) * Scenery::shade_range};
}

Scenery baked(const HeightField& field) {
  Scenery scenery;
  bake_lightmap(field, sun_in_the_west, scenery);
  return scenery;
}

// From the foot of an endless wall that rises to an elevation a, the floor sees (1 + cos a) / 2 of
// the sky: the form factor of a half-plane (Howell, Menguc, Daun, Siegel 2020, configuration B-2).
TEST(BakedLight, OfTheSkyAgreesWithTheFormFactorOfAnEndlessWall) {
  const Scenery scenery = baked(field_with_wall());

  for (const double distance : {0.1, 0.3, 0.7, 1.5}) {
    const double expected = (1 + std::cos(std::atan2(wall_height, distance))) / 2;
    EXPECT_NEAR(floor_share(scenery, {distance, 0}).sky, expected, 0.07) << distance << " m";
  }
}

TEST(BakedLight, HidesHalfTheSunWhereTheWallsEdgeStandsBeforeItsMiddle) {
  const Scenery scenery = baked(field_with_wall());
  const double edge = wall_height / std::tan(sun_in_the_west.elevation);

  EXPECT_NEAR(floor_share(scenery, {edge, 0}).sun, 0.5, 0.12);
  EXPECT_EQ(floor_share(scenery, {edge * 0.8, 0}).sun, 0);
  EXPECT_EQ(floor_share(scenery, {edge * 1.25, 0}).sun, 1);
}

TEST(BakedLight, FallsFullyOnTheSideOfTheSun) {
  const Scenery scenery = baked(field_with_wall());

  EXPECT_EQ(floor_share(scenery, {-1, 0}).sun, 1);
  EXPECT_EQ(floor_share(scenery, {-1, 0}).shade, 0);
}

TEST(BakedLight, LowersTheShadeByTheSunsSlopeAwayFromTheWall) {
  const Scenery scenery = baked(field_with_wall());

  for (const double distance : {0.2, 0.6, 1.0, 1.4}) {
    const double expected = wall_height - distance * std::tan(sun_in_the_west.elevation);
    EXPECT_NEAR(floor_share(scenery, {distance, 0}).shade, expected, 0.04) << distance << " m";
  }
}

TEST(BakedLight, OfAFaceAboveTheWallIsWhole) {
  const HeightField field = field_with_wall();

  const Light light = light_at(field, sun_in_the_west, {0.3, 0}, 2.4, {0, 1, 0});
  EXPECT_EQ(light.sun, 1);
  EXPECT_FLOAT_EQ(light.sky, 1);
}

TEST(BakedLight, OfAnOpenFieldIsWholeEverywhere) {
  const Scenery scenery = baked(HeightField({0, 0}, {3, 2}, 0.1));

  for (const double x : {0.05, 1.5, 2.95})
    for (const double y : {0.05, 1.0, 1.95}) {
      EXPECT_EQ(floor_share(scenery, {x, y}).sky, 1);
      EXPECT_EQ(floor_share(scenery, {x, y}).sun, 1);
    }
}

}  // namespace
}  // namespace docent::scenery::baked_light_test
