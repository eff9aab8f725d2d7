#include "content/character/springs.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "content/character/character.h"
#include "content/import/gltf/read_model.h"
#include "tests/content/character/made_character.h"
#include "tests/support/reference_data.h"

namespace docent::character::springs_test {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Character made(const test::MadeCharacter& how) {
  return make_character(import::gltf::parse_model(test::make_glb(how), "made.vrm", {}), "made.vrm");
}

/// A character of VRM 1.0 with a plait of four joints.
Character with_springs(const std::string& springs) {
  return made({.is_vrm1 = true, .hair = 4, .springs = springs});
}
Character with_old_springs(const std::string& springs) {
  return made({.faces_back = true, .is_vrm0 = true, .hair = 4, .springs = springs});
}

const std::string ball = R"({"node":4,"shape":{"sphere":{"offset":[0,0.1,0],"radius":0.12}}})";
std::string plait_of(const std::string& joint) {
  std::string joints;
  for (const int node : {21, 22, 23, 24})
    joints += fmt::format(R"({}{{"node":{}{}}})", joints.empty() ? "" : ",", node, joint);
  return fmt::format(R"({{"joints":[{}],"colliderGroups":[0]}})", joints);
}
std::string all_of(const std::string& spring) {
  return fmt::format(
      R"({{"colliders":[{}],"colliderGroups":[{{"colliders":[0]}}],"springs":[{}]}})", ball,
      spring);
}

TEST(Springs, OfVrmAreTheBonesBetweenTheirJoints) {
  const Character it = with_springs(
      all_of(plait_of(R"(,"stiffness":2,"gravityPower":0.5,"dragForce":0.5,"hitRadius":0.03)")));

  const Springs& springs = it.swinging;
  ASSERT_EQ(springs.bone.size(), 3U);  // the last joint is the end of the third
  for (std::size_t b = 0; b < 3; ++b) {
    const SpringBone& bone = springs.bone[b];
    EXPECT_EQ(bone.body, HumanBone::Head);
    EXPECT_EQ(bone.above, static_cast<std::int32_t>(b) - 1);
    EXPECT_NEAR(bone.root.y - bone.end.y, 0.11, 1e-4);
    EXPECT_FLOAT_EQ(bone.pull, 120);
    EXPECT_NEAR(bone.gravity.y, -30, 1e-4);
    EXPECT_NEAR(bone.drag, 60 * std::log(2), 1e-3);
    EXPECT_NEAR(bone.radius, 0.03, 1e-4);
    EXPECT_THAT(bone.colliders, ::testing::ElementsAre(0));
  }
  EXPECT_EQ(springs.bone_of_node[22], 1);
  EXPECT_EQ(it.springs, 1U);
  EXPECT_THAT(it.notes, Contains(HasSubstr("1 spring chains swing, by 3 bones")));
  // Its boxes go with the bones, the last one with the third.
  std::array<int, 3> bound{};
  for (const SurfaceVertex& v : it.body.surface.vertices)
    if (v.shares.bone[0] >= bone_count) ++bound[v.shares.bone[0] - bone_count];
  EXPECT_GT(bound[0], 0);
  EXPECT_GT(bound[2], bound[0]);
}

TEST(Springs, OfOldVrmAreAllThatHangsOnTheirJoints) {
  const Character it = with_old_springs(
      R"({"boneGroups":[{"stiffiness":1,"gravityPower":0.2,"gravityDir":{"x":0,"y":-1,"z":0},)"
      R"("dragForce":0.4,"hitRadius":0.02,"bones":[21],"colliderGroups":[0]}],)"
      R"("colliderGroups":[{"node":4,"colliders":[{"offset":{"x":0,"y":0.1,"z":0.05},)"
      R"("radius":0.1}]}]})");

  const Springs& springs = it.swinging;
  ASSERT_EQ(springs.bone.size(), 4U);
  EXPECT_NEAR(springs.bone[3].root.y - springs.bone[3].end.y, 0.07, 1e-4);
  EXPECT_NEAR(springs.bone[0].gravity.y, -12, 1e-3);
  EXPECT_NEAR(springs.bone[0].root.z, -0.12, 1e-4);  // it faced back, and was turned
  ASSERT_EQ(springs.ball.size(), 1U);
  // Its z was the other way round: in the file 5 cm towards -z, where the face is.
  EXPECT_NEAR(springs.ball[0].from.z, it.standing.at_bind(HumanBone::Head).z + 0.05F, 1e-4);
}

struct Broken {
  std::string springs, told;
};

TEST(Springs, ThatAreBrokenAreLeftOutWithASentence) {
  const auto joints = [](const std::string& list) {
    return all_of(fmt::format(R"({{"joints":[{}]}})", list));
  };
  for (const Broken& broken : std::vector<Broken>{
           {joints(R"({"node":21},{"node":99})"), "joints[1].node names node 99"},
           {joints(R"({"node":21},{"stiffness":1})"), "joints[1].node is missing"},
           {joints(R"({"node":21,"stiffness":-1},{"node":22})"), "stiffness must not be negative"},
           {joints(R"({"node":21,"hitRadius":-0.1},{"node":22})"),
            "hitRadius must not be negative"},
           {joints(R"({"node":21,"dragForce":"much"},{"node":22})"), "dragForce must be a number"},
           {joints(R"({"node":21,"gravityPower":1e60},{"node":22})"), "is too large a number"},
           {joints(R"({"node":21,"gravityDir":[0,-1]},{"node":22})"), "must have three numbers"},
           {joints(R"({"node":21,"stiffness":0},{"node":22})"), "neither stiffness nor gravity"},
           {joints(R"({"node":22},{"node":21})"), "joints[1] does not hang on the joint before it"},
           {joints(R"({"node":21},{"node":21})"), "joints[1] does not hang on the joint before it"},
           {joints(R"({"node":0},{"node":1})"), "are bones of the body"},
           {R"({"springs":{"joints":[]}})", "springs must be a list"},
           {R"({"springs":[7]})", "must be an object"},
           {R"([])", "must be an object"}}) {
    const Character it = with_springs(broken.springs);

    EXPECT_THAT(it.swinging.bone, IsEmpty()) << broken.springs;
    EXPECT_THAT(it.notes, Contains(HasSubstr(broken.told))) << broken.springs;
  }
}

TEST(Springs, KeepWhatIsSoundBesideWhatIsBroken) {
  const std::string sound = plait_of("");
  for (const Broken& broken : std::vector<Broken>{
           {fmt::format(R"({{"springs":[{{"joints":[{{"node":-3}}]}},{{"joints":[{{"node":21}},)"
                        R"({{"node":22}}]}}]}})"),
            "must be a whole number"},
           {all_of(sound + "," + sound), "are named twice"},
           {fmt::format(R"({{"colliders":[{{"node":4,"shape":{{"sphere":{{"radius":-1}}}}}}],)"
                        R"("colliderGroups":[{{"colliders":[0]}}],"springs":[{}]}})",
                        sound),
            "a collider is left out"},
           {fmt::format(R"({{"colliders":[{{"node":4,"shape":{{}}}}],)"
                        R"("colliderGroups":[{{"colliders":[0]}}],"springs":[{}]}})",
                        sound),
            "is neither a sphere nor a capsule"},
           {fmt::format(R"({{"colliders":[{{"node":4,"shape":{{"sphere":{{"radius":2}}}}}}],)"
                        R"("colliderGroups":[{{"colliders":[0]}}],"springs":[{}]}})",
                        sound),
            "encloses what should swing"}}) {
    const Character it = with_springs(broken.springs);

    EXPECT_FALSE(it.swinging.bone.empty()) << broken.springs;
    EXPECT_THAT(it.notes, Contains(HasSubstr(broken.told))) << broken.springs;
  }
}

TEST(Springs, OfAnyNumberAreReadAndCutToWhatIsKept) {
  std::string many;
  for (int i = 0; i < 10'000; ++i)
    many += fmt::format("{}{{\"joints\":[{{\"node\":{}}},{{\"node\":22}}]}}", i == 0 ? "" : ",",
                        i % 2 == 0 ? 21 : 700);
  const Character it = with_springs(fmt::format(R"({{"springs":[{}]}})", many));

  EXPECT_EQ(it.swinging.bone.size(), 1U);
  EXPECT_THAT(it.notes, Contains(HasSubstr("it has 10000 springs, and the first 4000 are taken")));
  EXPECT_THAT(it.notes, Contains(HasSubstr("1997 more springs cannot be used")));

  const Character long_hair =
      made({.is_vrm0 = true, .hair = 200, .springs = R"({"boneGroups":[{"bones":[21]}]})"});
  EXPECT_LE(long_hair.swinging.bone.size(), most_spring_bones);
}

/// Whatever hangs on what: fewer bones are still chains from the top down, in one of which each
/// bone's skin is, or with the body.
RC_GTEST_PROP(FewerSprings, AreChainsFromTheTopDown, ()) {
  Springs all;
  const int count = *rc::gen::inRange(0, 40);
  double skin = 0;
  for (int b = 0; b < count; ++b) {
    SpringBone bone{.above = *rc::gen::inRange(-1, b)};
    bone.root = bone.above < 0 ? Vec3{0.1F * static_cast<float>(b), 2, 0}
                               : all.bone[static_cast<std::size_t>(bone.above)].end;
    bone.end = bone.root - Vec3{0, 0.01F * static_cast<float>(*rc::gen::inRange(1, 30)), 0};
    bone.skin = *rc::gen::inRange(0, 100);
    skin += bone.skin;
    all.bone.push_back(bone);
    all.bone_of_node.push_back(b);
  }
  const auto most = static_cast<std::size_t>(*rc::gen::inRange(0, 40));

  std::vector<std::int32_t> became;
  const Springs fewer = with_at_most(most, all, became);

  RC_ASSERT(fewer.bone.size() == std::min(most, all.bone.size()));
  RC_ASSERT(became.size() == all.bone.size());
  double kept = 0, gone = 0;
  for (std::size_t b = 0; b < fewer.bone.size(); ++b) {
    RC_ASSERT(fewer.bone[b].above < static_cast<std::int32_t>(b));
    kept += fewer.bone[b].skin;
  }
  for (std::size_t b = 0; b < became.size(); ++b) {
    RC_ASSERT(became[b] < static_cast<std::int32_t>(fewer.bone.size()));
    RC_ASSERT(fewer.bone_of_node[b] == became[b]);
    if (became[b] < 0) gone += all.bone[b].skin;
    // What went with the bone above it is where that is now.
    if (const std::int32_t above = all.bone[b].above; became[b] < 0 && above >= 0)
      RC_ASSERT(became[static_cast<std::size_t>(above)] < 0);
  }
  RC_ASSERT(std::abs(kept + gone - skin) < 1e-6);
}

TEST(Springs, OfTheReferenceDataSwing) {
  NEEDS_REFERENCE_DATA("models/characters");
  const auto folder = test::reference_data() / "models/characters";
  const Character godette = read_character(folder / "godette_vrm0.vrm");
  EXPECT_EQ(godette.springs, 8U);
  EXPECT_GE(godette.swinging.bone.size(), 5U);
  EXPECT_EQ(godette.swinging.ball.size(), 4U);
  const Character smoke = read_character(folder / "smoke_spring_vrm1.vrm");
  EXPECT_EQ(smoke.swinging.bone.size(), 3U);
}

}  // namespace
}  // namespace docent::character::springs_test
