#include "content/object/decimate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include <glm/geometric.hpp>

#include "content/object/surface.h"
#include "tests/support/sanitized.h"

namespace docent::object::decimate_test {
namespace {

using Height = std::function<float(float x, float z)>;

/// A sheet of 1 by 1, of squares of two triangles, but for the squares that `is_open` leaves out.
Shape sheet(
    int squares, const Height& height,
    const std::function<bool(int x, int z)>& is_open = [](int, int) { return false; }) {
  Shape shape;
  for (int z = 0; z <= squares; ++z)
    for (int x = 0; x <= squares; ++x) {
      const float across = static_cast<float>(x) / static_cast<float>(squares),
                  along = static_cast<float>(z) / static_cast<float>(squares);
      shape.vertices.emplace_back().position = {across, height(across, along), along};
    }
  for (int z = 0; z < squares; ++z)
    for (int x = 0; x < squares; ++x) {
      if (is_open(x, z)) continue;
      const auto a = static_cast<std::uint32_t>(z * (squares + 1) + x), b = a + 1,
                 c = a + static_cast<std::uint32_t>(squares) + 1, d = c + 1;
      shape.indices.insert(shape.indices.end(), {a, c, b, b, c, d});
    }
  return shape;
}

float flat(float, float) {
  return 0;
}
float wavy(float x, float z) {
  return 0.05F * std::sin(9 * x) * std::cos(7 * z);
}

std::vector<Corners> triangles_of(const Shape& shape) {
  std::vector<Corners> all;
  for (std::size_t k = 0; k + 2 < shape.indices.size(); k += 3)
    all.push_back({shape.vertices[shape.indices[k]].position,
                   shape.vertices[shape.indices[k + 1]].position,
                   shape.vertices[shape.indices[k + 2]].position});
  return all;
}

/// How far the corners and middles of one's triangles are from the other at most.
float farthest(const Shape& one, const Shape& other) {
  Surface surface(triangles_of(other));
  float most = 0;
  for (const auto& [a, b, c] : triangles_of(one))
    for (const Vec3 place : {a, b, c, (a + b) / 2.0F, (b + c) / 2.0F, (a + b + c) / 3.0F})
      most = std::max(most, surface.squared_distance_from(place, 0, 1e9F));
  return std::sqrt(most);
}

std::size_t triangles_in(const Shape& shape) {
  return shape.indices.size() / 3;
}

TEST(Decimate, SpendsNoTriangleOnWhatIsFlat) {
  Shape shape = sheet(40, flat);
  const Shape before = shape;

  EXPECT_LE(decimate(shape, 2), 0.0002F) << "it is asked no closer than a fifth of a pixel";
  EXPECT_LE(triangles_in(shape), 4U);
  EXPECT_LT(farthest(before, shape), 1e-6F);
}

TEST(Decimate, SaysHowFarTheSurfaceIsOffAtMost) {
  NEEDS_SPEED();
  Shape shape = sheet(60, wavy);
  const Shape before = shape;
  const float off = decimate(shape, 600);

  EXPECT_LE(triangles_in(shape), 600U);
  EXPECT_GT(off, 0.0001F);
  EXPECT_LE(off, 0.004F);
  EXPECT_LE(farthest(before, shape), 1.05F * off);
  EXPECT_LE(farthest(shape, before), 1.5F * off) << "there it is asked at fewer places";
}

TEST(Decimate, FillsNoGap) {
  // A comb: gaps one square wide between teeth of three.
  Shape shape = sheet(41, flat, [](int x, int z) { return x % 4 == 3 && z < 30; });
  const Shape before = shape;
  decimate(shape, 2);

  EXPECT_LT(triangles_in(shape), triangles_in(before) / 10);
  EXPECT_LT(farthest(before, shape), 0.0101F);
  Surface comb(triangles_of(shape));
  for (int gap = 0; gap < 10; ++gap) {
    const Vec3 middle{(static_cast<float>(4 * gap) + 3.5F) / 41, 0, 0.3F};
    EXPECT_GT(comb.squared_distance_from(middle, 0, 1), 0) << "gap " << gap;
  }
}

TEST(Decimate, KeepsABladeWhoseCornersAllLieOnOtherThings) {
  // Two rough slabs, and between them a blade of two triangles from edge to edge.
  Shape shape = sheet(40, wavy, [](int x, int) { return x >= 10 && x < 30; });
  const auto corner = [](int x, int z) { return static_cast<std::uint32_t>(z * 41 + x); };
  const std::uint32_t a = corner(10, 20), b = corner(10, 21), c = corner(30, 20),
                      d = corner(30, 21);
  shape.indices.insert(shape.indices.end(), {a, b, c, c, b, d});
  const Shape before = shape;
  decimate(shape, 200);

  EXPECT_LT(farthest(before, shape), 0.0101F);
}

TEST(Decimate, MovesCornersOfRoundThingsOutToWhereTheirFacesAreAsFarOffAsThey) {
  NEEDS_SPEED();
  const auto dome = [](float x, float z) {
    return std::sqrt(1 - (x - 0.5F) * (x - 0.5F) - (z - 0.5F) * (z - 0.5F));
  };
  Shape shape = sheet(60, dome);
  const float off = decimate(shape, 400);

  float outside = 0, inside = 0;
  for (const auto& [a, b, c] : triangles_of(shape)) {
    const Vec3 centre{0.5F, 0, 0.5F}, middle = (a + b + c) / 3.0F;
    for (const Vec3 place : {a, b, c})
      outside = std::max(outside, glm::distance(place, centre) - 1);
    inside = std::max(inside, 1 - glm::distance(middle, centre));
  }
  EXPECT_GT(outside, 0.25F * off);
  EXPECT_GT(inside, 0.25F * off);
  EXPECT_LT(std::max(outside, inside), off);
}

/// A rod of 1 m whose ends, four rings of corners within 3 mm each, are rough; nothing between
/// them.
Shape rod_with_rough_ends() {
  Shape shape;
  std::mt19937 chance(7);
  constexpr std::uint32_t columns = 200, rings = 8;
  constexpr std::array<float, rings> at{0, 0.0008F, 0.0016F, 0.0024F, 0.9976F, 0.9984F, 0.9992F, 1};
  for (const float x : at)
    for (std::uint32_t c = 0; c < columns; ++c) {
      const float turn = 6.2831853F * static_cast<float>(c) / columns,
                  radius = 0.02F + 0.0015F * static_cast<float>(chance() % 2048) / 2048;
      shape.vertices.emplace_back().position = {x, radius * std::cos(turn),
                                                radius * std::sin(turn)};
    }
  for (std::uint32_t ring = 0; ring + 1 < rings; ++ring)
    for (std::uint32_t c = 0; c < columns; ++c) {
      const std::uint32_t a = ring * columns + c, b = ring * columns + (c + 1) % columns;
      shape.indices.insert(shape.indices.end(), {a, a + columns, b, b, a + columns, b + columns});
    }
  return shape;
}

TEST(Decimate, MovesNoCornerFurtherOffThanTheSurfaceIs) {
  for (const std::size_t triangles : {600, 1000}) {
    SCOPED_TRACE(triangles);
    Shape shape = rod_with_rough_ends();
    Surface before(triangles_of(shape));
    const float off = decimate(shape, triangles);

    float most = 0;
    for (const Corners& triangle : triangles_of(shape))
      for (const Vec3 corner : triangle)
        most = std::max(most, before.squared_distance_from(corner, 0, 1e9F));
    EXPECT_LE(triangles_in(shape), triangles);
    EXPECT_GT(most, 0) << "none moved";
    EXPECT_LE(std::sqrt(most), 1.001F * off);
  }
}

TEST(Decimate, OfAHundredThousandSplintersIsMadeInTime) {
  NEEDS_SPEED();
  // A tube of 1 m: a sample every six pixels of each would be fourteen million.
  Shape shape;
  constexpr std::uint32_t columns = 50'000;
  for (std::uint32_t c = 0; c < columns; ++c) {
    const float turn = 6.2831853F * static_cast<float>(c) / columns;
    shape.vertices.emplace_back().position = {0.2F * std::cos(turn), 0, 0.2F * std::sin(turn)};
    shape.vertices.emplace_back().position = {0.2F * std::cos(turn), 1, 0.2F * std::sin(turn)};
    const std::uint32_t a = 2 * c, b = 2 * ((c + 1) % columns);
    shape.indices.insert(shape.indices.end(), {a, a + 1, b, b, a + 1, b + 1});
  }
  const auto start = std::chrono::steady_clock::now();
  EXPECT_LE(decimate(shape, 1000), 0.01F);
  EXPECT_LE(triangles_in(shape), 5000U);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::minutes(2)) << "it takes 2 s";
}

TEST(Decimate, LeavesMoreTrianglesRatherThanWhatIsFarOff) {
  NEEDS_SPEED();
  Shape shape = sheet(60, wavy);
  const Shape before = shape;
  const float off = decimate(shape, 2);

  EXPECT_GT(triangles_in(shape), 20U);
  EXPECT_LE(off, 0.01F);
  EXPECT_LE(farthest(before, shape), 0.0101F);
}

/// The right half of the sheet lies elsewhere in its picture.
TEST(Decimate, KeepsSeamsOfPictures) {
  NEEDS_SPEED();
  Shape shape = sheet(40, wavy);
  const auto uv_at = [](Vec3 p, bool is_right) {
    return glm::vec2(is_right ? 1 - p.z : p.x, is_right ? 1 - p.x : p.z);
  };
  std::vector<ShapeVertex> right = shape.vertices;
  const auto left_count = static_cast<std::uint32_t>(shape.vertices.size());
  for (ShapeVertex& v : shape.vertices) v.uv = uv_at(v.position, false);
  for (ShapeVertex& v : right) v.uv = uv_at(v.position, true);
  shape.vertices.insert(shape.vertices.end(), right.begin(), right.end());
  const std::vector<Corners> triangles = triangles_of(shape);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (std::ranges::any_of(triangles[t], [](Vec3 p) { return p.x > 0.51F; }))
      for (std::size_t c = 0; c < 3; ++c) shape.indices[3 * t + c] += left_count;
  const float off = decimate(shape, 300);

  EXPECT_LE(triangles_in(shape), 300U);
  std::size_t on_the_right = 0;
  for (std::size_t k = 0; k < shape.indices.size(); k += 3) {
    const bool is_right = shape.indices[k] >= left_count;
    on_the_right += is_right ? 1 : 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const ShapeVertex& v = shape.vertices[shape.indices[k + c]];
      EXPECT_EQ(shape.indices[k + c] >= left_count, is_right) << "a triangle of both";
      EXPECT_LT(glm::distance(v.uv, uv_at(v.position, is_right)), off);
      EXPECT_TRUE(is_right ? v.position.x > 0.5F - off : v.position.x < 0.5F + off);
    }
  }
  EXPECT_GT(on_the_right, 50U);
}

TEST(Decimate, MakesTwoSheetsThatTouchNotOne) {
  NEEDS_SPEED();
  // Front and back of a leaf, facing away from one another.
  Shape shape = sheet(30, wavy);
  const std::vector<std::uint32_t> front = shape.indices;
  for (std::size_t k = 0; k < front.size(); k += 3)
    shape.indices.insert(shape.indices.end(), {front[k], front[k + 2], front[k + 1]});
  const Shape before = shape;
  const float off = decimate(shape, 400);

  EXPECT_LE(triangles_in(shape), 400U);
  EXPECT_LE(farthest(before, shape), 1.05F * off);
  const auto facing_up = std::ranges::count_if(triangles_of(shape), [](const Corners& t) {
    return glm::cross(t[1] - t[0], t[2] - t[0]).y > 0;
  });
  EXPECT_EQ(2 * static_cast<std::size_t>(facing_up), triangles_in(shape));
}

}  // namespace
}  // namespace docent::object::decimate_test
