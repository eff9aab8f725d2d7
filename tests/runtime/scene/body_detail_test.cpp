#include "runtime/scene/body_detail.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace docent::scene::body_detail_test {
namespace {

/// A sphere of 20 cm, of as many triangles as a head.
SkinnedMesh ball(Material material) {
  constexpr std::uint32_t rings = 40, sides = 60;
  constexpr float radius = 0.1F, pi = 3.14159265F;
  SkinnedMesh mesh;
  for (std::uint32_t ring = 0; ring <= rings; ++ring)
    for (std::uint32_t side = 0; side < sides; ++side) {
      const float polar = pi * static_cast<float>(ring) / rings;
      const float turn = 2 * pi * static_cast<float>(side) / sides;
      SkinnedVertex vertex;
      vertex.normal = {std::sin(polar) * std::cos(turn), std::cos(polar),
                       std::sin(polar) * std::sin(turn)};
      vertex.position = radius * vertex.normal;
      vertex.material = material;
      mesh.vertices.push_back(vertex);
    }
  for (std::uint32_t ring = 0; ring < rings; ++ring)
    for (std::uint32_t side = 0; side < sides; ++side) {
      const std::uint32_t a = ring * sides + side;
      const std::uint32_t b = ring * sides + (side + 1) % sides;
      for (const std::uint32_t corner : {a, b, b + sides, a, b + sides, a + sides})
        mesh.indices.push_back(corner);
    }
  return mesh;
}

double volume(const SkinnedMesh& mesh, const std::vector<std::uint32_t>& indices) {
  double six = 0;
  for (std::size_t k = 0; k < indices.size(); k += 3) {
    const Vec3 a = mesh.vertices[indices[k]].position;
    const Vec3 b = mesh.vertices[indices[k + 1]].position;
    const Vec3 c = mesh.vertices[indices[k + 2]].position;
    six += glm::dot(a, glm::cross(b, c));
  }
  return std::abs(six) / 6;
}

TEST(ACoarserBody, HasFewerTrianglesTheLargerItsCellsAre) {
  const SkinnedMesh mesh = ball(Material::Skin);

  std::size_t before = mesh.indices.size();
  for (const float cell : {0.02F, 0.04F, 0.08F}) {
    const std::size_t count = coarser(mesh, cell).size();
    EXPECT_LT(count, before) << cell;
    EXPECT_GT(count, 0U) << cell;
    before = count;
  }
}

TEST(ACoarserBody, FillsAboutTheSameRoom) {
  const SkinnedMesh mesh = ball(Material::Skin);

  EXPECT_NEAR(volume(mesh, coarser(mesh, 0.02F)) / volume(mesh, mesh.indices), 1, 0.06);
  EXPECT_NEAR(volume(mesh, coarser(mesh, 0.04F)) / volume(mesh, mesh.indices), 1, 0.2);
}

TEST(ACoarserBody, HasNoTriangleWithoutAnAreaAndNoneTwice) {
  const SkinnedMesh mesh = ball(Material::Skin);

  const std::vector<std::uint32_t> indices = coarser(mesh, 0.03F);

  std::set<std::array<std::uint32_t, 3>> triangles;
  for (std::size_t k = 0; k < indices.size(); k += 3) {
    std::array t{indices[k], indices[k + 1], indices[k + 2]};
    EXPECT_TRUE(t[0] != t[1] && t[1] != t[2] && t[2] != t[0]);
    EXPECT_TRUE(triangles.insert(t).second);
  }
}

TEST(ACoarserBody, KeepsEveryMaterial) {
  SkinnedMesh mesh = ball(Material::Skin);
  for (SkinnedVertex& vertex : mesh.vertices)
    if (vertex.position.y > 0) vertex.material = Material::Hair;
  std::set<Material> materials;

  for (const std::uint32_t v : coarser(mesh, 0.03F)) materials.insert(mesh.vertices[v].material);

  EXPECT_EQ(materials.size(), 2U);
}

TEST(ACoarserBody, OfNothingIsNothing) {
  EXPECT_TRUE(coarser({}, 0.02F).empty());
}

}  // namespace
}  // namespace docent::scene::body_detail_test
