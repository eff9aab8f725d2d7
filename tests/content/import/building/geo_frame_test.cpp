#include "content/import/building/geo_frame.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "content/content_error.h"

namespace docent::test::geo_frame_test {
namespace {

using import::MapNumbers;

/// A house of 20 by 10 m in degrees, turned by an angle.
std::vector<Vec2> house(Vec2 corner, double angle) {
  const double metres_per_degree = 111'195, c = std::cos(angle), s = std::sin(angle);
  std::vector<Vec2> ring;
  for (const Vec2 p : {Vec2{0, 0}, Vec2{20, 0}, Vec2{20, 10}, Vec2{0, 10}, Vec2{0, 0}})
    ring.push_back({corner.x + (c * p.x - s * p.y) / metres_per_degree /
                                   std::cos(corner.y * std::numbers::pi / 180),
                    corner.y + (s * p.x + c * p.y) / metres_per_degree});
  return ring;
}

std::vector<Vec2> swapped(std::vector<Vec2> ring) {
  for (Vec2& point : ring) point = {point.y, point.x};
  return ring;
}

import::GeoFrame frame_of(std::vector<Vec2> ring, import::ImportOptions options = {},
                          std::string crs = {}, bool degrees = false) {
  return import::find_frame(
      {.file = "plan", .crs = crs, .always_degrees = degrees, .rings = {ring}}, options);
}

TEST(GeoFrame, TakesSmallNumbersForDegreesAndLargeOnesForMetres) {
  EXPECT_EQ(frame_of(house({16.36, 48.2}, 0.1)).numbers, MapNumbers::Degrees);
  EXPECT_EQ(frame_of({{0, 0}, {20, 0}, {20, 10}}).numbers, MapNumbers::Lengths);
}

TEST(GeoFrame, SeesThatLatitudeAndLongitudeAreSwappedByTheWallsThatAreNotSquare) {
  const auto frame = frame_of(swapped(house({16.36, 48.2}, 0.4)));

  EXPECT_EQ(frame.numbers, MapNumbers::SwappedDegrees);
  EXPECT_FALSE(frame.sure);
  EXPECT_NEAR(glm::distance(frame.to_floor({48.2, 16.36}), frame.to_floor({48.2001, 16.36})), 11.12,
              0.05);
}

TEST(GeoFrame, ReadsWebMercatorWithItsTrueLengths) {
  constexpr double radius = 6378137;
  const auto mercator = [](Vec2 degrees) {
    const double degree = std::numbers::pi / 180;
    return Vec2{radius * degrees.x * degree,
                radius * std::log(std::tan(std::numbers::pi / 4 + degrees.y * degree / 2))};
  };
  std::vector<Vec2> ring = house({16.36, 48.2}, 0);
  for (Vec2& point : ring) point = mercator(point);

  for (const char* crs : {"", "urn:ogc:def:crs:EPSG::3857"}) {
    const auto frame = frame_of(ring, {}, crs);
    EXPECT_EQ(frame.numbers, MapNumbers::WebMercator);
    EXPECT_EQ(frame.sure, *crs != 0);
    EXPECT_NEAR(glm::distance(frame.to_floor(ring[0]), frame.to_floor(ring[1])), 20, 0.1);
  }
}

TEST(GeoFrame, RefusesPixelsThatAreCalledLatitudeAndLongitude) {
  try {
    frame_of({{129.5, 17.7}, {170.9, 17.7}, {170.9, 74.9}}, {}, {}, true);
    FAIL() << "taken";
  } catch (const content::ContentError& error) {
    EXPECT_EQ(error.code, "unknown-frame");
    EXPECT_NE(error.hint.find("--unit"), std::string::npos);
  }
}

TEST(GeoFrame, TakesPixelsWhereAUnitIsGiven) {
  const auto frame =
      frame_of({{129.5, 17.7}, {170.9, 17.7}, {170.9, 74.9}}, {.unit = "cm"}, {}, true);

  EXPECT_EQ(frame.numbers, MapNumbers::Lengths);
  EXPECT_DOUBLE_EQ(frame.unit, 0.01);
}

TEST(GeoFrame, KeepsTheMuseumsOriginForALaterPlan) {
  const import::ImportOptions options{.origin = Vec2{16.36, 48.2}};
  const auto frame = frame_of(house({16.361, 48.2}, 0), options);

  EXPECT_EQ(frame.origin, (Vec2{16.36, 48.2}));
  EXPECT_NEAR(frame.to_floor({16.36, 48.2}).x, 0, 1e-9);
}

TEST(GeoFrame, RefusesAPlanFarFromTheMuseumsOrigin) {
  EXPECT_THROW(frame_of(house({2.37, 48.84}, 0), {.origin = Vec2{16.36, 48.2}}, {}, true),
               content::ContentError);
}

}  // namespace
}  // namespace docent::test::geo_frame_test
