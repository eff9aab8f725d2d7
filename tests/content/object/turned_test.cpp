#include "content/object/turned.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>

#include "content/object/make_object.h"
#include "content/object/shape.h"
#include "content/object/surface.h"
#include "runtime/schema/object_blob.h"
#include "tests/content/object/silhouette.h"
#include "tests/content/object/solid.h"
#include "tests/support/sanitized.h"

namespace docent::object::turned_test {
namespace {

using test::corner;
using test::is_closed;
using test::volume_of;

using Points = std::vector<Vec2>;

/// A jar with a foot, a shoulder and a neck, hollow.
const Points jar{{0.10, 0},    {0.13, 0.10}, {0.24, 0.28}, {0.19, 0.44}, {0.11, 0.50}, {0.13, 0.55},
                 {0.12, 0.55}, {0.10, 0.50}, {0.17, 0.43}, {0.21, 0.28}, {0.11, 0.10}, {0, 0.04}};
const Points cylinder{{0.2, 0}, {0.2, 0.5}};
const Points cone{{0.3, 0}, {0, 0.9}};
const Points dome{{0.3, 0}, {0.29, 0.12}, {0.2, 0.25}, {0, 0.32}};

Shape shape_of(const Points& profile, const Pixels& wrapped = {}) {
  std::vector<std::string> notes;
  Shape shape = object::shape_of(turn({profile, Vec3{1}, wrapped}).model, "turned", notes);
  EXPECT_TRUE(notes.empty());
  return shape;
}

Pixels picture() {
  return {.width = 4, .height = 2, .rgba = std::vector<std::byte>(32, std::byte{200})};
}

/// Pappus: the area of the section times the way of its centroid about the axis.
double volume_by_pappus(const Points& profile) {
  Points section = profile_of(profile, 1e-7).points;
  section.insert(section.begin(), Vec2{0, section.front().y});
  section.emplace_back(0, section.back().y);
  double area = 0, moment = 0;
  for (std::size_t i = 0; i < section.size(); ++i) {
    const Vec2 a = section[i], b = section[(i + 1) % section.size()];
    area += cross(a, b) / 2;
    moment += cross(a, b) * (a.x + b.x) / 6;
  }
  return 2 * std::numbers::pi * (moment / area) * area;
}

/// Outlines that staff may bring: upwards in steps, here and there wide or narrow.
Points any_profile(std::mt19937& random) {
  const auto within = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  Points profile;
  const auto count = std::uniform_int_distribution<int>(2, 14)(random);
  double height = 0;
  for (int i = 0; i < count; ++i, height += within(0.02, 0.2))
    profile.emplace_back(within(0.03, 0.3), height);
  if (random() % 3 == 0) profile.back().x = 0;
  if (random() % 3 == 0) profile.insert(profile.begin(), Vec2{0, 0});
  return profile;
}

TEST(Turned, OfAnyOutlineIsClosedAndLooksOutwardsAndHoldsWhatPappusSays) {
  std::mt19937 random(7);
  int turned = 0;
  for (int i = 0; i < 200; ++i) {
    const Points profile = any_profile(random);
    if (fault_of(profile)) continue;  // a narrow place may be rounded into itself
    ++turned;
    const Shape shape = shape_of(profile, i % 2 == 0 ? Pixels{} : picture());
    SCOPED_TRACE(::testing::PrintToString(profile.size()) + " points, profile " +
                 std::to_string(i));

    EXPECT_TRUE(is_closed(shape));
    const double volume = volume_by_pappus(profile);
    EXPECT_NEAR(volume_of(shape), volume, 0.006 * volume);
    EXPECT_LE(shape.indices.size() / 3, ObjectDetail::most_triangles);
  }
  EXPECT_GT(turned, 150);
}

TEST(Turned, HasEachPointOfItsOutlineOnItsSurface) {
  for (const Points& profile : {jar, cylinder, cone, dome}) {
    const Shape shape = shape_of(profile);
    std::vector<Corners> triangles;
    for (std::size_t k = 0; k + 2 < shape.indices.size(); k += 3)
      triangles.push_back({corner(shape, k), corner(shape, k + 1), corner(shape, k + 2)});
    Surface surface(std::move(triangles));
    for (const Vec2 p : profile)
      for (const Vec3 at : {Vec3{0, p.y, p.x}, Vec3{0, p.y, -p.x}, Vec3{p.x, p.y, 0}})
        EXPECT_LT(surface.squared_distance_from(at, 0, 1), 1e-12F) << p.x << ", " << p.y;
  }
}

TEST(Turned, OfStraightSidesIsACylinderOrACone) {
  const double pi = std::numbers::pi;
  EXPECT_NEAR(volume_of(shape_of(cylinder)), pi * 0.2 * 0.2 * 0.5, 0.002 * pi * 0.02);
  EXPECT_NEAR(volume_of(shape_of(cone)), pi * 0.3 * 0.3 * 0.9 / 3, 0.002 * pi * 0.027);
}

TEST(Turned, IsHollowWhereItsOutlineTurnsBackInwards) {
  const Points outside(jar.begin(), jar.begin() + 6);

  EXPECT_LT(volume_of(shape_of(jar)), 0.5 * volume_of(shape_of(outside)));
}

TEST(Turned, FromEitherEndIsTheSame) {
  Points upside(jar);
  std::ranges::reverse(upside);

  EXPECT_EQ(shape_of(jar).vertices, shape_of(upside).vertices);
}

TEST(Turned, KeepsItsOutlineWithinAPixel) {
  NEEDS_SPEED();
  for (const Points& profile : {jar, dome}) {
    // The same, with ten times as many points on its curve as a screen can tell.
    Shape fine;
    const Points points = profile_of(profile, 1e-5).points;
    constexpr std::uint32_t columns = 360;
    for (const Vec2 p : points)
      for (std::uint32_t k = 0; k < columns; ++k) {
        const double turn = 2 * std::numbers::pi * k / columns;
        fine.vertices.emplace_back().position = {static_cast<float>(p.x * std::sin(turn)),
                                                 static_cast<float>(p.y),
                                                 static_cast<float>(p.x * std::cos(turn))};
      }
    for (std::uint32_t i = 0; i + 1 < points.size(); ++i)
      for (std::uint32_t k = 0; k < columns; ++k) {
        const std::uint32_t a = i * columns + k, b = i * columns + (k + 1) % columns;
        for (const std::uint32_t v : {a, b, b + columns, a, b + columns, a + columns})
          fine.indices.push_back(v);
      }

    EXPECT_LE(test::silhouette_error(fine, shape_of(profile), 4), 1);
  }
}

TEST(Turned, IsMadeWithinTheBudgetAndSmoothWhereItIsRound) {
  const MadeObject it = make_object(turn({jar, Vec3{0.4F, 0.2F, 0.1F}, picture()}), "jar", {});
  ObjectDetail detail;
  ASSERT_TRUE(schema::decode(it.object.detail, detail));

  EXPECT_NEAR(it.object.size.y, 0.55, 1e-4);
  EXPECT_NEAR(it.object.size.x, 0.48, 0.002);
  EXPECT_LE(detail.mesh.triangles.size() / 3, ObjectDetail::most_triangles);
  EXPECT_LE(it.object.detail.size(), ExhibitObject::most_bytes);
  EXPECT_EQ(detail.parts.size(), 2U) << "with its picture, and without";
  // Edges double vertices: those of foot and rim alone.
  EXPECT_LT(detail.mesh.vertices.size(),
            0.6 * static_cast<double>(detail.mesh.triangles.size()) / 3);
}

TEST(Turned, BearsItsPictureUpright) {
  Pixels halves{.width = 2, .height = 2, .rgba = {}};
  for (const int red : {255, 0})  // the upper half is white, the lower black
    for (int i = 0; i < 2; ++i)
      for (const int channel : {red, red, red, 255})
        halves.rgba.push_back(static_cast<std::byte>(channel));
  const Shape shape = shape_of(cylinder, halves);
  for (const ShapeVertex& v : shape.vertices) {
    if (v.material != 1) continue;
    EXPECT_NEAR(v.uv.y, 1 - v.position.y / 0.5, 1e-5);
    if (v.uv.x > 0.26F && v.uv.x < 0.49F) {
      EXPECT_LT(v.position.x, 0) << "what is left on the picture is left in front";
      EXPECT_GT(v.position.z, 0);
    }
  }
}

struct Bad {
  const char* name;
  Points profile;
  const char* told;
  std::size_t point;
};
void PrintTo(const Bad& bad, std::ostream* out) {
  *out << bad.name;
}

class BadProfile : public ::testing::TestWithParam<Bad> {};

TEST_P(BadProfile, IsRefusedWithASentence) {
  const auto fault = fault_of(GetParam().profile);

  ASSERT_TRUE(fault.has_value());
  EXPECT_THAT(fault->what, ::testing::HasSubstr(GetParam().told));
  EXPECT_EQ(fault->point, GetParam().point);
  EXPECT_NE(fault->hint, "");
}

INSTANTIATE_TEST_SUITE_P(
    Profiles, BadProfile,
    ::testing::Values(
        Bad{"nothing", {}, "one point", 0}, Bad{"a point", {{0.1, 0}}, "one point", 0},
        Bad{"a point twice", {{0.1, 0}, {0.1, 0}}, "one point", 0},
        Bad{"flat", {{0, 0.2}, {0.3, 0.2}}, "flat", 0},
        Bad{"a needle", {{0, 0}, {1e-5, 0.4}}, "next to nothing", 0},
        Bad{"through the axis", {{0.1, 0}, {0.1, 0.1}, {0, 0.2}, {0.1, 0.3}}, "axis", 2},
        Bad{"an eight", {{0.1, 0}, {0.3, 0.3}, {0.1, 0.3}, {0.3, 0}}, "crosses itself", 3},
        Bad{"through its foot", {{0.2, 0.1}, {0.3, 0.4}, {0.1, 0.4}, {0.05, 0}}, "crosses", 2},
        Bad{"a ring", {{0.2, 0}, {0.3, 0.1}, {0.2, 0.2}, {0.1, 0.1}, {0.2, 0}}, "itself", 3},
        Bad{"too many", Points(101, {0.1, 0}), "one point", 0}));

TEST(Profile, OfTooManyPointsIsRefused) {
  Points many;
  for (int i = 0; i < 4000; ++i) many.emplace_back(0.1 + 1e-5 * i, 1e-4 * i);

  EXPECT_THAT(fault_of(many)->what, ::testing::HasSubstr("it has 4000 points"));
}

TEST(Profile, OfFewPointsIsRoundBetweenThem) {
  const Points bulge{{0.1, 0}, {0.2, 0.2}, {0.1, 0.4}};
  const Points points = profile_of(bulge, 1e-5).points;

  EXPECT_GT(points.size(), 12U);
  for (const Vec2 p : points)
    EXPECT_GE(p.x + 1e-9, 0.1 + 0.1 * (1 - std::abs(p.y - 0.2) / 0.2)) << "at height " << p.y;
}

TEST(Profile, KeepsACornerThatIsSharp) {
  const Points drum{{0.3, 0}, {0.3, 0.5}, {0.2, 0.5}, {0.2, 0.6}};

  EXPECT_EQ(profile_of(drum, 1e-6).points, drum);
}

}  // namespace
}  // namespace docent::object::turned_test
