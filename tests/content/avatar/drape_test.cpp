#include "content/avatar/drape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "content/avatar/avatar.h"
#include "content/avatar/layers.h"
#include "content/gait/gait.h"
#include "content/gait/gait_skeleton.h"
#include "tests/content/avatar/posed_body.h"
#include "tests/support/sanitized.h"

namespace docent::avatar::drape_test {
namespace {

/// A guide with its whole legs, those parts too that are never seen.
struct Dressed {
  Skeleton skeleton = gait::gait_skeleton();
  BodyShape shape;
  SkinnedMesh mesh;
  std::vector<SkinnedVertex> leg;

  explicit Dressed(const Figure& figure)
      : shape{body_of(figure, stand_at_ease(skeleton))}, mesh{make_avatar(skeleton, figure)} {
    const SkinWeights weights(skeleton, shape);
    for (const Side side : both_sides) {
      const LimbPoints& limb = shape.limb(side);
      const BodyRegion region = side == Side::Left ? BodyRegion::LeftLeg : BodyRegion::RightLeg;
      for (float y = limb.ankle.y; y < limb.hip.y - 0.06F; y += 0.015F)
        for (int k = 0; k < 24; ++k)
          add(side, weights, region, y, glm::radians(15.0F * static_cast<float>(k)));
    }
  }

  void add(Side side, const SkinWeights& weights, BodyRegion region, float y, float angle) {
    const LimbPoints& limb = shape.limb(side);
    const bool thigh = y > limb.knee.y;
    const Vec3 &upper = thigh ? limb.hip : limb.knee, &lower = thigh ? limb.knee : limb.ankle;
    const Vec3 axis = glm::mix(lower, upper, (y - lower.y) / (upper.y - lower.y));
    const Vec3 outward{std::sin(angle), 0, std::cos(angle)};
    float out = 0.2F;
    for (int step = 0; step < 30; ++step) out -= trouser_leg(shape, axis + out * outward, side);
    const JointShares shares = weights.at(axis + out * outward, region);
    leg.push_back({.position = axis + out * outward,
                   .normal = outward,
                   .joint = shares.joint,
                   .weight = shares.weight});
    axis_.push_back(axis);
  }

  Vec3 axis_of(std::size_t v) const { return axis_[v]; }

 private:
  std::vector<Vec3> axis_;
};

/// Where a segment goes through a triangle, as a share of it; more than 1: nowhere.
float through(Vec3 from, Vec3 to, const std::array<Vec3, 3>& t) {
  const Vec3 along = to - from, a = t[1] - t[0], b = t[2] - t[0];
  const Vec3 p = glm::cross(along, b);
  const float det = glm::dot(a, p);
  if (std::abs(det) < 1e-12F) return 2;
  const Vec3 off = from - t[0];
  const float u = glm::dot(off, p) / det;
  const Vec3 q = glm::cross(off, a);
  const float v = glm::dot(along, q) / det;
  const float share = glm::dot(b, q) / det;
  return u < 0 || v < 0 || u + v > 1 || share < 0 ? 2 : share;
}

/// The outside of a skirt, as it hangs: triangles by their height.
class Skirt {
 public:
  explicit Skirt(const Dressed& guide) : guide_{guide} {
    const auto is_outside = [&](std::uint32_t v) {
      const SkinnedVertex& vertex = guide.mesh.vertices[v];
      return vertex.material == Material::Coat && vertex.position.y < guide.shape.hip_height &&
             std::abs(coat_trunk(guide.shape, vertex.position, 0)) < 0.012F;
    };
    for (std::size_t t = 0; t < guide.mesh.indices.size(); t += 3) {
      const auto corners = std::span(guide.mesh.indices).subspan(t, 3);
      if (std::ranges::all_of(corners, is_outside))
        indices_.push_back({corners[0], corners[1], corners[2]});
    }
  }

  void hang(const test::PosedBody& body) {
    for (auto& row : row_) row.clear();
    for (const auto& corners : indices_) {
      std::array<Vec3, 3> t;
      for (std::size_t k = 0; k < 3; ++k) t[k] = body.place_of(guide_.mesh.vertices[corners[k]]);
      const auto [low, high] = std::minmax({t[0].y, t[1].y, t[2].y});
      for (std::size_t row = row_of(low); row <= row_of(high); ++row) row_[row].push_back(t);
    }
  }

  /// Where a way first goes through it, as a share of the way; more than 1: nowhere.
  float first_on(Vec3 from, Vec3 to) const {
    float first = 2;
    const auto [low, high] = std::minmax({from.y, to.y});
    for (std::size_t row = row_of(low); row <= row_of(high); ++row)
      for (const auto& triangle : row_[row]) first = std::min(first, through(from, to, triangle));
    return first;
  }

 private:
  std::size_t row_of(float y) const {
    return static_cast<std::size_t>(std::clamp(y * 60, 0.0F, static_cast<float>(row_.size() - 1)));
  }

  const Dressed& guide_;
  std::vector<std::array<std::uint32_t, 3>> indices_;
  std::array<std::vector<std::array<Vec3, 3>>, 90> row_;
};

/// How far legs are outside the cloth that covers them: on the way from a leg's axis to its skin,
/// where it goes through the outside of the cloth. What is at a hem is not covered.
float depth_outside(const Dressed& guide, const test::PosedBody& body, Skirt& skirt) {
  skirt.hang(body);
  float furthest = 0;
  const float lowest = guide.shape.hem + 0.03F * guide.shape.scale;
  for (std::size_t v = 0; v < guide.leg.size(); ++v) {
    if (guide.leg[v].position.y < lowest) continue;
    SkinnedVertex axis = guide.leg[v];
    axis.position = guide.axis_of(v);
    const Vec3 from = body.place_of(axis), to = body.place_of(guide.leg[v]);
    const float first = skirt.first_on(from, to);
    if (first <= 1) furthest = std::max(furthest, (1 - first) * glm::length(to - from));
  }
  return furthest;
}

const std::vector<Dressed>& guides() {
  static const std::vector<Dressed> made(figures.begin(), figures.end());
  return made;
}

TEST(EachGarment, HangsAsItWasModelled) {
  NEEDS_SPEED();
  for (const Dressed& guide : guides()) {
    const Cloth& cloth = guide.mesh.cloth;
    std::vector<Mat4> palette(matrices_of(guide.mesh), Mat4(1));
    motion::ClothMotion motion = motion::make_cloth_motion(cloth.node.size());

    motion::hang({cloth.node, cloth.collider}, palette, motion);

    for (std::size_t n = 0; n < cloth.node.size(); ++n)
      EXPECT_LT(glm::length(motion.place[n] - cloth.node[n].place), 0.001F)
          << guide.shape.figure.name << " node " << n;
  }
}

/// How far a guide's legs are at most outside of its garment in a clip: metres.
float furthest_outside(const Dressed& guide, const gait::GaitRecipe& recipe) {
  const MotionClip clip = gait::make_gait_clip(recipe);
  Skirt skirt(guide);
  float furthest = 0;
  test::PosedBody body(guide.mesh, guide.skeleton);
  for (std::size_t frame = 0; frame < clip.root.size(); ++frame) {
    body.swing(clip, frame, 1 / clip.frame_rate);
    if (frame % 12 == 0) furthest = std::max(furthest, depth_outside(guide, body, skirt));
  }
  return furthest;
}

TEST(EachGarment, CoversItsLegsInEveryShippedClip) {
  NEEDS_SPEED();
  for (const Dressed& guide : guides())
    for (const gait::GaitRecipe& recipe : gait::default_clips())
      EXPECT_LE(furthest_outside(guide, recipe), 0.005F)
          << guide.shape.figure.name << " in " << recipe.name;
}

}  // namespace
}  // namespace docent::avatar::drape_test
