#include "runtime/scene/leaf_mesh.h"

#include <gtest/gtest.h>

namespace docent::scene::leaf_mesh_test {
namespace {

const LeafDraw leaf{.hinge = {1, 2}, .along = {0.6, 0.8}, .width = 0.9F, .floor_height = 3};

std::vector<SceneryVertex> room_for(std::size_t leaves) {
  std::vector<SceneryVertex> mesh;
  mesh.reserve(leaves * (vertices_of_a_leaf + vertices_of_its_bars));
  return mesh;
}

TEST(LeafMesh, FacesOutwardsAndStandsOnItsFloor) {
  std::vector<SceneryVertex> mesh = room_for(1);

  const std::size_t bars = make_leaves(std::array{leaf}, mesh);

  EXPECT_EQ(bars, vertices_of_a_leaf);
  ASSERT_EQ(mesh.size(), vertices_of_a_leaf + vertices_of_its_bars);
  for (std::size_t i = 0; i < mesh.size(); i += 3) {
    const Vec3 a = mesh[i].position, b = mesh[i + 1].position, c = mesh[i + 2].position;
    EXPECT_GT(glm::dot(glm::cross(b - a, c - a), mesh[i].normal), 0);
  }
  for (const SceneryVertex& vertex : mesh) {
    EXPECT_GT(vertex.position.y, 3);
    EXPECT_LT(vertex.position.y, 3 + cut_height);
  }
}

TEST(LeafMesh, LeavesOutWhatItHasNoRoomFor) {
  std::vector<SceneryVertex> mesh = room_for(1);
  const std::array leaves{leaf, leaf, leaf};

  make_leaves(leaves, mesh);

  EXPECT_LE(mesh.size(), mesh.capacity());
  EXPECT_EQ(mesh.size(), vertices_of_a_leaf + vertices_of_its_bars);
}

}  // namespace
}  // namespace docent::scene::leaf_mesh_test
