#include "content/avatar/drape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "content/avatar/avatar.h"
#include "content/avatar/hair.h"
#include "content/avatar/head.h"
#include "content/avatar/headwear.h"
#include "content/avatar/layers.h"
#include "content/gait/gait.h"
#include "content/gait/gait_skeleton.h"
#include "tests/content/avatar/hanging_surface.h"
#include "tests/content/avatar/posed_body.h"
#include "tests/support/sanitized.h"

namespace docent::avatar::drape_test {
namespace {

/// The outside of a solid, from `start` outwards.
template <typename Solid>
Vec3 outside_of(Solid solid, Vec3 start, Vec3 outward) {
  float out = 0.3F;
  for (int step = 0; step < 60; ++step) out -= solid(start + out * outward);
  return start + std::max(out, 0.0F) * outward;
}

/// What something that hangs covers of a body, those parts too that are never seen.
struct Covering {
  std::vector<test::CoveredPlace> places;
  test::HangingSurface surface;
};

/// A guide, and what covers what of it.
struct Dressed {
  Skeleton skeleton = gait::gait_skeleton();
  BodyShape shape;
  SkinnedMesh mesh;
  SkinWeights weights;

  explicit Dressed(const Figure& figure)
      : shape{body_of(figure, stand_at_ease(skeleton))},
        mesh{make_avatar(skeleton, figure)},
        weights{skeleton, shape} {}

  test::CoveredPlace covered(Vec3 skin, Vec3 axis, BodyRegion region) const {
    const JointShares shares = weights.at(skin, region);
    return {{.position = skin, .joint = shares.joint, .weight = shares.weight},
            {.position = axis, .joint = shares.joint, .weight = shares.weight}};
  }
};

constexpr int directions = 24;
Vec3 direction(int k) {
  const float angle = glm::radians(15.0F * static_cast<float>(k));
  return {std::sin(angle), 0, std::cos(angle)};
}

/// Legs under a garment. What is at a hem is not covered.
Covering legs_of(const Dressed& guide) {
  const BodyShape& shape = guide.shape;
  std::vector<test::CoveredPlace> places;
  for (const Side side : both_sides) {
    const LimbPoints& limb = shape.limb(side);
    const BodyRegion region = side == Side::Left ? BodyRegion::LeftLeg : BodyRegion::RightLeg;
    for (float y = limb.ankle.y; y < limb.hip.y - 0.06F; y += 0.015F)
      for (int k = 0; k < directions && y >= shape.hem + 0.03F * shape.scale; ++k) {
        const bool thigh = y > limb.knee.y;
        const Vec3 &upper = thigh ? limb.hip : limb.knee, &lower = thigh ? limb.knee : limb.ankle;
        const Vec3 axis = glm::mix(lower, upper, (y - lower.y) / (upper.y - lower.y));
        const Vec3 skin =
            outside_of([&](Vec3 p) { return trouser_leg(shape, p, side); }, axis, direction(k));
        places.push_back(guide.covered(skin, axis, region));
      }
  }
  return {places, test::HangingSurface(guide.mesh, [&](const SkinnedVertex& vertex) {
            return vertex.material == Material::Coat && vertex.position.y < shape.hip_height &&
                   std::abs(coat_trunk(shape, vertex.position, 0)) < 0.012F;
          })};
}

/// Something that is worn on a solid of the body, or grows there, round an upright axis.
template <typename Worn, typename Under>
Covering covering(const Dressed& guide, Vec3 axis, float low, float high, BodyRegion region,
                  Worn worn, Under under) {
  constexpr float lies_on = 0.004F;  // metres: what is nearer is its inside
  std::vector<test::CoveredPlace> places;
  for (float y = low; y < high; y += 0.008F)
    for (int k = 0; k < directions; ++k) {
      const Vec3 from{axis.x, y, axis.z};
      if (under(from) > -0.02F) continue;
      const Vec3 skin = outside_of(under, from, direction(k));
      if (worn(skin + lies_on * direction(k)) < -0.002F)
        places.push_back(guide.covered(skin, from, region));
    }
  return {places, test::HangingSurface(guide.mesh, [&](const SkinnedVertex& vertex) {
            return std::abs(worn(vertex.position)) < 0.004F && under(vertex.position) > lies_on;
          })};
}

/// What hangs or stands off a guide's head over that and its coat.
std::vector<Covering> worn_on_head(const Dressed& guide) {
  const BodyShape& shape = guide.shape;
  const float s = shape.scale;
  const auto skin = [&](Vec3 p) { return head_and_neck(shape, p); };
  std::vector<Covering> all;
  if (shape.figure.headwear == Headwear::Scarf)
    all.push_back(covering(
        guide, shape.neck_base, shape.skull.y - 0.46F * s, shape.neck_base.y, BodyRegion::Coat,
        [&](Vec3 p) { return headwear(shape, p); },
        [&](Vec3 p) { return coat_trunk(shape, p, 0); }));
  if (shape.figure.face.beard > 0)
    all.push_back(covering(
        guide, shape.skull, shape.skull.y - 0.16F * s, shape.skull.y, BodyRegion::Head,
        [&](Vec3 p) { return beard(shape, p); }, skin));
  if (shape.figure.hair == Hair::Curls)
    all.push_back(covering(
        guide, shape.skull, shape.skull.y - 0.1F * s, shape.skull.y + 0.14F * s, BodyRegion::Head,
        [&](Vec3 p) { return hair(shape, p); }, skin));
  return all;
}

const std::vector<Dressed>& guides() {
  static const std::vector<Dressed> made = [] {
    std::vector<Dressed> all;
    all.reserve(figures.size());  // each is referred to by what is made from it
    for (const Figure& figure : figures) all.emplace_back(figure);
    return all;
  }();
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

/// How far what is covered comes out at most in a clip: metres.
float furthest_outside(const Dressed& guide, std::vector<Covering>& coverings,
                       const gait::GaitRecipe& recipe) {
  const MotionClip clip = gait::make_gait_clip(recipe);
  float furthest = 0;
  test::PosedBody body(guide.mesh, guide.skeleton);
  for (std::size_t frame = 0; frame < clip.root.size(); ++frame) {
    body.swing(clip, frame, 1 / clip.frame_rate);
    if (frame % 12 != 0) continue;
    for (Covering& covering : coverings) {
      covering.surface.hang(body);
      furthest = std::max(furthest, test::depth_outside(covering.places, body, covering.surface));
    }
  }
  return furthest;
}

TEST(EachGarment, CoversItsLegsInEveryShippedClip) {
  NEEDS_SPEED();
  for (const Dressed& guide : guides()) {
    std::vector<Covering> legs;
    legs.push_back(legs_of(guide));
    for (const gait::GaitRecipe& recipe : gait::default_clips())
      EXPECT_LE(furthest_outside(guide, legs, recipe), 0.005F)
          << guide.shape.figure.name << " in " << recipe.name;
  }
}

TEST(ScarfBeardAndCurls, LieOverTheBodyInEveryShippedClip) {
  NEEDS_SPEED();
  std::size_t worn = 0;
  for (const Dressed& guide : guides()) {
    std::vector<Covering> coverings = worn_on_head(guide);
    worn += coverings.size();
    for (const Covering& covering : coverings) {
      EXPECT_GT(covering.places.size(), 50U) << guide.shape.figure.name;
      EXPECT_GT(covering.surface.size(), 100U) << guide.shape.figure.name;
    }
    if (coverings.empty()) continue;
    for (const gait::GaitRecipe& recipe : gait::default_clips())
      EXPECT_LE(furthest_outside(guide, coverings, recipe), 0.005F)
          << guide.shape.figure.name << " in " << recipe.name;
  }
  EXPECT_EQ(worn, 4U);
}

/// A part of the drapery of one guide, and how far its nodes swing at most, in metres, ...
struct Swinging {
  std::string_view name;
  float least, most;
};

/// ... from where they are carried, while a clip goes on and then while its last frame lasts.
struct Swung {
  float walking = 0, standing = 0;
};

template <typename Part>
Swung swung(const Dressed& guide, const Part& part, const MotionClip& clip, std::size_t stride) {
  test::PosedBody body(guide.mesh, guide.skeleton);
  const double seconds = static_cast<double>(stride) / clip.frame_rate;
  Swung swung;
  const auto furthest = [&] {
    float most = 0;
    for (std::size_t n = part.first; n < part.first + part.size(); ++n)
      most = std::max(most, glm::distance(body.cloth().place[n], body.cloth().carried[n]));
    return most;
  };
  for (std::size_t frame = 0; frame < clip.root.size(); frame += stride) {
    body.swing(clip, frame, seconds);
    swung.walking = std::max(swung.walking, furthest());
  }
  for (double stood = 0; stood < 2.5; stood += seconds)
    body.swing(clip, clip.root.size() - 1, seconds);
  swung.standing = furthest();
  return swung;
}

template <typename Part>
void expect_swinging(const Dressed& guide, const Part& part, const Swinging& expected) {
  ASSERT_GT(part.size(), 0U);
  const MotionClip clip = gait::make_gait_clip(gait::default_clips()[1]);
  const Swung smooth = swung(guide, part, clip, 1);
  EXPECT_GT(smooth.walking, expected.least) << expected.name;
  EXPECT_LT(smooth.walking, expected.most) << expected.name;
  EXPECT_LT(smooth.standing, 0.001F) << expected.name;
  for (const std::size_t stride : {2U, 4U})
    EXPECT_NEAR(swung(guide, part, clip, stride).walking, smooth.walking, 0.3F * smooth.walking)
        << expected.name << ", every " << stride << " frames";
}

TEST(ScarfBeardAndCurls, LagWhileTheirGuideWalksAndSettleWhereItStands) {
  NEEDS_SPEED();
  for (const Dressed& guide : guides()) {
    const Drapery drapery = drapery_of(guide.shape);
    ASSERT_EQ(guide.mesh.cloth.node.size(), drapery.size()) << guide.shape.figure.name;
    if (guide.shape.figure.headwear == Headwear::Scarf) {
      expect_swinging(guide, drapery.behind, {"scarf, behind", 0.006F, 0.08F});
      expect_swinging(guide, drapery.before, {"scarf, before", 0.002F, 0.03F});
    }
    if (guide.shape.figure.face.beard > 0)
      expect_swinging(guide, drapery.beard, {"beard", 0.001F, 0.008F});
    if (guide.shape.figure.hair == Hair::Curls)
      expect_swinging(guide, drapery.curls, {"curls", 0.002F, 0.012F});
  }
}

}  // namespace
}  // namespace docent::avatar::drape_test
