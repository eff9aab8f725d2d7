#include "content/avatar/avatar.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>

#include "content/gait/gait.h"
#include "content/gait/gait_skeleton.h"
#include "content/import/motion/bvh.h"
#include "tests/content/avatar/posed_body.h"
#include "tests/support/reference_data.h"
#include "tests/support/sanitized.h"

namespace docent::avatar::avatar_test {
namespace {

const SkinnedMesh& avatar() {
  static const SkinnedMesh mesh = make_avatar(gait::gait_skeleton(), figures[0]);
  return mesh;
}

/// Where the vertices are in a frame of a clip.
std::vector<Vec3> posed(const SkinnedMesh& mesh, const Skeleton& skeleton, const MotionClip& clip,
                        std::size_t frame) {
  test::PosedBody body(mesh, skeleton);
  body.hang(clip, frame);
  return body.places();
}

float lowest(const std::vector<Vec3>& places) {
  return std::ranges::min_element(places, {}, &Vec3::y)->y;
}

/// Share of the edges that are more than twice and a half as long as where the body was modelled.
double torn_share(const SkinnedMesh& mesh, const std::vector<Vec3>& places) {
  std::size_t torn = 0;
  for (std::size_t t = 0; t < mesh.indices.size(); t += 3)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = mesh.indices[t + k];
      const std::uint32_t b = mesh.indices[t + (k + 1) % 3];
      const float before = glm::length(mesh.vertices[a].position - mesh.vertices[b].position);
      torn += glm::length(places[a] - places[b]) > 2.5F * before + 0.002F ? 1 : 0;
    }
  return static_cast<double>(torn) / static_cast<double>(mesh.indices.size());
}

void expect_sound(const SkinnedMesh& mesh, const Skeleton& skeleton) {
  EXPECT_GT(mesh.indices.size() / 3, 8000U);
  EXPECT_LT(mesh.indices.size() / 3, 20000U);
  ASSERT_EQ(mesh.inverse_bind.size(), skeleton.joint.size());
  EXPECT_LE(matrices_of(mesh), most_joints);
  for (const std::uint32_t index : mesh.indices) ASSERT_LT(index, mesh.vertices.size());
  std::set<Material> materials;
  for (const SkinnedVertex& vertex : mesh.vertices) {
    EXPECT_EQ(std::accumulate(vertex.weight.begin(), vertex.weight.end(), 0), 255);
    for (const std::uint8_t joint : vertex.joint) EXPECT_LT(joint, matrices_of(mesh));
    EXPECT_NEAR(glm::length(vertex.normal), 1, 1e-3);
    materials.insert(vertex.material);
  }
  // All but that of a museum's own characters, and perhaps one that no figure happens to wear.
  EXPECT_FALSE(materials.contains(Material::Own));
  EXPECT_GE(materials.size(), static_cast<std::size_t>(Material::Count) - 2);
}

TEST(Avatar, IsASoundMeshOfEveryMaterial) {
  expect_sound(avatar(), gait::gait_skeleton());
}

TEST(Avatar, IsAPersonOfTheSkeletonsStature) {
  float top = 0;
  float chin = 9;
  for (const SkinnedVertex& vertex : avatar().vertices) {
    top = std::max(top, vertex.position.y);
    const bool face = vertex.material == Material::Skin && std::abs(vertex.position.x) < 0.02F &&
                      vertex.position.z > 0.06F && vertex.position.y > 1.4F;
    if (face) chin = std::min(chin, vertex.position.y);
  }
  EXPECT_NEAR(top, 1.71F, 0.02F);
  EXPECT_NEAR(top - chin, 1.7F / 7.5F, 0.03F);
}

TEST(Avatar, LooksWhereItsFeetPoint) {
  Vec3 eyes{0};
  Vec3 hair{0};
  float eye_count = 0;
  float hair_count = 0;
  for (const SkinnedVertex& vertex : avatar().vertices) {
    if (vertex.material == Material::Eye) eyes += vertex.position, eye_count += 1;
    if (vertex.material == Material::Hair) hair += vertex.position, hair_count += 1;
  }
  EXPECT_GT(eyes.z / eye_count, hair.z / hair_count + 0.05F);
}

TEST(Avatar, FacesOutward) {
  std::size_t outward = 0;
  for (std::size_t t = 0; t < avatar().indices.size(); t += 3) {
    const SkinnedVertex& a = avatar().vertices[avatar().indices[t]];
    const SkinnedVertex& b = avatar().vertices[avatar().indices[t + 1]];
    const SkinnedVertex& c = avatar().vertices[avatar().indices[t + 2]];
    const Vec3 face = glm::cross(b.position - a.position, c.position - a.position);
    outward += glm::dot(face, a.normal + b.normal + c.normal) > 0 ? 1 : 0;
  }
  EXPECT_GT(outward * 3, avatar().indices.size() * 99 / 100);
}

TEST(Avatar, IsDarkerUnderItsCoatThanOnItsShoulders) {
  const auto mean = [](Material material, float low, float high) {
    double sum = 0;
    double count = 0;
    for (const SkinnedVertex& vertex : avatar().vertices)
      if (vertex.material == material && vertex.position.y > low && vertex.position.y < high) {
        sum += vertex.occlusion;
        count += 1;
      }
    return sum / count;
  };
  EXPECT_LT(mean(Material::Trousers, 0.56F, 0.62F), 0.7 * mean(Material::Coat, 1.38F, 1.45F));
}

TEST(Avatar, FollowsFromTheSkeletonAlone) {
  const SkinnedMesh again = make_avatar(gait::gait_skeleton(), figures[0]);

  EXPECT_EQ(again.indices, avatar().indices);
  ASSERT_EQ(again.vertices.size(), avatar().vertices.size());
  for (std::size_t v = 0; v < again.vertices.size(); ++v) {
    EXPECT_EQ(again.vertices[v].position, avatar().vertices[v].position);
    EXPECT_EQ(again.vertices[v].weight, avatar().vertices[v].weight);
  }
}

TEST(Avatar, WalksOnItsSolesWithoutTearing) {
  NEEDS_SPEED();
  for (const gait::GaitRecipe& recipe : gait::default_clips()) {
    const MotionClip clip = gait::make_gait_clip(recipe);
    for (std::size_t frame = 0; frame < clip.root.size(); frame += 40) {
      const std::vector<Vec3> places = posed(avatar(), gait::gait_skeleton(), clip, frame);
      EXPECT_GT(lowest(places), -0.015F) << recipe.name << " frame " << frame;
      EXPECT_LT(lowest(places), 0.006F) << recipe.name << " frame " << frame;
      EXPECT_LT(torn_share(avatar(), places), 0.01) << recipe.name << " frame " << frame;
    }
  }
}

/// All guides, each by itself.
const std::vector<SkinnedMesh>& guides() {
  static const std::vector<SkinnedMesh> made = [] {
    std::vector<SkinnedMesh> all;
    for (const Figure& figure : figures) all.push_back(make_avatar(gait::gait_skeleton(), figure));
    return all;
  }();
  return made;
}

TEST(EachGuide, HasAtMostFifteenThousandTriangles) {
  NEEDS_SPEED();
  for (const SkinnedMesh& guide : guides()) {
    EXPECT_LE(guide.indices.size() / 3, 15000U);
    EXPECT_GE(guide.indices.size() / 3, 8000U);
  }
}

/// What of a picture of 1 cm a pixel a body covers, seen along z or x.
std::set<std::pair<int, int>> silhouette(const SkinnedMesh& mesh, glm::length_t across) {
  std::set<std::pair<int, int>> covered;
  for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
    std::array<Vec3, 3> p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = mesh.vertices[mesh.indices[t + k]].position;
    constexpr int parts = 4;
    for (int a = 0; a <= parts; ++a)
      for (int b = 0; a + b <= parts; ++b) {
        const Vec3 q = (static_cast<float>(a) * p[0] + static_cast<float>(b) * p[1] +
                        static_cast<float>(parts - a - b) * p[2]) /
                       static_cast<float>(parts);
        covered.emplace(static_cast<int>(std::floor(q[across] * 100)),
                        static_cast<int>(std::floor(q.y * 100)));
      }
  }
  return covered;
}

TEST(EachGuide, HasASilhouetteOfItsOwn) {
  NEEDS_SPEED();
  for (std::size_t i = 0; i < guides().size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      double common = 0, all = 0;
      for (const glm::length_t across : {0, 2}) {
        const auto a = silhouette(guides()[i], across);
        const auto b = silhouette(guides()[j], across);
        const auto both = std::ranges::count_if(a, [&](const auto& at) { return b.contains(at); });
        common += static_cast<double>(both);
        all += static_cast<double>(a.size() + b.size()) - static_cast<double>(both);
      }
      EXPECT_GT(1 - common / all, 0.06) << figures[i].name << " and " << figures[j].name;
    }
}

TEST(Avatar, FitsTheRecordedSkeletonToo) {
  NEEDS_REFERENCE_DATA("mocap/cmu-walk/16_15-walk-forward.bvh");
  const import::RecordedMotion recorded =
      import::read_bvh(test::reference_data() / "mocap/cmu-walk/16_15-walk-forward.bvh");
  const SkinnedMesh mesh = make_avatar(recorded.skeleton, figures[0]);

  expect_sound(mesh, recorded.skeleton);
  for (std::size_t frame = 20; frame < recorded.clip.root.size(); frame += 50) {
    const std::vector<Vec3> places = posed(mesh, recorded.skeleton, recorded.clip, frame);
    EXPECT_NEAR(lowest(places), 0, 0.04F) << frame;
    EXPECT_LT(torn_share(mesh, places), 0.01) << frame;
  }
}

}  // namespace
}  // namespace docent::avatar::avatar_test
