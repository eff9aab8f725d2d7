#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "content/avatar/simplify.h"
#include "content/avatar/surface_nets.h"

namespace docent::avatar::surface_nets_test {
namespace {

/// Every edge is used once each way: the surface has no hole and no seam.
bool is_closed(const TriangleSurface& surface) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (std::size_t t = 0; t < surface.indices.size(); t += 3)
    for (std::size_t k = 0; k < 3; ++k)
      ++edges[{surface.indices[t + k], surface.indices[t + (k + 1) % 3]}];
  for (const auto& [edge, uses] : edges) {
    const auto back = edges.find({edge.second, edge.first});
    if (back == edges.end() || back->second != uses) return false;
  }
  return true;
}

/// Positive when triangles are counter-clockwise seen from outside.
double volume(const TriangleSurface& surface) {
  double sum = 0;
  for (std::size_t t = 0; t < surface.indices.size(); t += 3) {
    const glm::dvec3 a(surface.position[surface.indices[t]]);
    const glm::dvec3 b(surface.position[surface.indices[t + 1]]);
    const glm::dvec3 c(surface.position[surface.indices[t + 2]]);
    sum += glm::dot(a, glm::cross(b, c)) / 6;
  }
  return sum;
}

constexpr Box3 cube{{-0.5F, -0.5F, -0.5F}, {0.5F, 0.5F, 0.5F}};

TriangleSurface ball(float radius, float cell) {
  return polygonise([radius](Vec3 p) { return sphere(p, {}, radius); }, cube, cell);
}

TEST(SurfaceNets, GiveABallItsVolume) {
  const TriangleSurface surface = ball(0.3F, 0.02F);

  EXPECT_TRUE(is_closed(surface));
  EXPECT_NEAR(volume(surface), 4.0 / 3 * std::numbers::pi * 0.027, 0.001);
  for (const Vec3& p : surface.position) EXPECT_NEAR(glm::length(p), 0.3F, 1e-4F);
}

RC_GTEST_PROP(SurfaceNets, CloseRoundAnyUnionOfLimbs, ()) {
  struct Limb {
    Vec3 a, b;
    float radius_a, radius_b;
  };
  const auto coordinate = [] { return 0.01F * static_cast<float>(*rc::gen::inRange(-35, 35)); };
  const auto radius = [] { return 0.01F * static_cast<float>(*rc::gen::inRange(4, 12)); };
  std::vector<Limb> limbs{{{-0.2F, 0, 0}, {0.2F, 0, 0}, 0.08F, 0.06F}};
  const int count = *rc::gen::inRange(0, 4);
  for (int k = 0; k < count; ++k) {
    const Vec3 a{coordinate(), coordinate(), coordinate()};
    const Vec3 b{coordinate(), coordinate(), coordinate()};
    // A limb that is shorter than its balls differ is one ball.
    if (glm::length(b - a) > 0.1F) limbs.push_back({a, b, radius(), radius()});
  }
  const DistanceField field = [&](Vec3 p) {
    float d = 1;
    for (const Limb& limb : limbs)
      d = join(d, tapered_capsule(p, limb.a, limb.b, limb.radius_a, limb.radius_b), 0.03F);
    return d;
  };

  const TriangleSurface surface = polygonise(field, cube, 0.03F);

  RC_ASSERT(is_closed(surface));
  RC_ASSERT(volume(surface) > 0);
  for (const Vec3& p : surface.position) RC_ASSERT(std::abs(field(p)) < 0.015F);
}

TEST(Simplify, KeepsABallABallWithFewerTriangles) {
  const TriangleSurface fine = ball(0.3F, 0.02F);
  TriangleSurface coarse = fine;
  simplify(coarse, {.triangles = 100, .error = 0.004F});

  EXPECT_LT(coarse.indices.size(), fine.indices.size() / 3);
  EXPECT_TRUE(is_closed(coarse));
  EXPECT_NEAR(volume(coarse), volume(fine), 0.03 * volume(fine));
  for (const Vec3& p : coarse.position) EXPECT_NEAR(glm::length(p), 0.3F, 0.004F);
}

TEST(Simplify, DividesAStraightLimbWhereItMayBend) {
  const DistanceField limb = [](Vec3 p) {
    return tapered_capsule(p, {0, -0.3F, 0}, {0, 0.3F, 0}, 0.08F, 0.08F);
  };
  const auto longest_upright = [&](std::function<Vec3(Vec3)> lens) {
    TriangleSurface surface = polygonise(limb, cube, 0.02F);
    simplify(surface, {.triangles = 100, .error = 0.002F, .lens = std::move(lens)});
    float longest = 0;
    for (std::size_t k = 0; k < surface.indices.size(); k += 3)
      longest = std::max(longest, std::abs(surface.position[surface.indices[k]].y -
                                           surface.position[surface.indices[k + 1]].y));
    return longest;
  };

  EXPECT_LT(longest_upright(wavy(0.05F, 0.002F)), 0.5F * longest_upright({}));
}

TEST(Simplify, KeepsTheCornersOfABox) {
  const DistanceField box = [](Vec3 p) {
    return rounded_box(p, {}, glm::mat3(1.0F), {0.2F, 0.25F, 0.3F}, 0.01F);
  };
  TriangleSurface surface = polygonise(box, cube, 0.02F);
  const std::size_t before = surface.indices.size();
  simplify(surface, {.triangles = 100, .error = 0.002F});

  EXPECT_LT(surface.indices.size(), before / 3);
  EXPECT_TRUE(is_closed(surface));
  EXPECT_NEAR(volume(surface), 0.4 * 0.5 * 0.6, 0.003);
}

}  // namespace
}  // namespace docent::avatar::surface_nets_test
