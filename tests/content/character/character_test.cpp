#include "content/character/character.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include <nlohmann/json.hpp>

#include "content/character/find_bones.h"
#include "content/content_error.h"
#include "content/import/gltf/read_model.h"
#include "platform/file/read_file.h"
#include "tests/content/character/made_character.h"
#include "tests/support/reference_data.h"
#include "tests/support/sanitized.h"

namespace docent::character::character_test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

Character made(const test::MadeCharacter& how) {
  return make_character(import::gltf::parse_model(test::make_glb(how), "made.glb", {}), "made.glb");
}

std::string refusal_of(const std::function<void()>& read) {
  try {
    read();
  } catch (const content::ContentError& error) {
    EXPECT_THAT(error.code, ::testing::AnyOf("unreadable-model", "not-humanoid"));
    EXPECT_FALSE(error.file.empty());
    return error.what();
  }
  return {};
}

TEST(Character, OfMixamosNamesHasItsBones) {
  const Character it = made({});

  EXPECT_EQ(it.bone_node[index_of(HumanBone::LeftUpperArm)], "mixamorig:LeftArm");
  EXPECT_EQ(it.bone_node[index_of(HumanBone::RightLowerLeg)], "mixamorig:RightLeg");
  EXPECT_EQ(it.bone_node[index_of(HumanBone::Neck)], "mixamorig:Neck");
  EXPECT_EQ(it.bone_node[index_of(HumanBone::Chest)], "mixamorig:Spine1");
  EXPECT_EQ(it.standing.pose, RestPose::T);
  EXPECT_EQ(it.extent.triangles, it.body.surface.indices.size() / 3);
  EXPECT_NEAR(it.extent.high.y - it.extent.low.y, 1.7, 1e-4);
}

TEST(Character, WithoutNamesIsKnownByItsShape) {
  const Character named = made({}), shape = made({.has_names = false});

  for (const HumanBone bone : required_bones)
    EXPECT_EQ(shape.standing.bones[bone], named.standing.bones[bone]) << bone_names[index_of(bone)];
  EXPECT_EQ(shape.bone_node[index_of(HumanBone::Hips)], "#0");
}

TEST(Character, IsAsLargeAsItsNodesSayWhateverItsSkinsUnit) {
  const Character it = made({.unit = 0.01F});

  EXPECT_NEAR(it.extent.high.y - it.extent.low.y, 1.7, 1e-3);
  EXPECT_NEAR(it.standing.at_bind(HumanBone::Head).y, 1.52, 1e-3);
}

TEST(Character, OfVrmFacesForwardAndKeepsItsExpressions) {
  const Character one = made({.is_vrm1 = true});
  const Character zero = made({.faces_back = true, .is_vrm0 = true});

  EXPECT_THAT(one.expressions, ::testing::ElementsAre("blink", "happy"));
  EXPECT_EQ(one.springs, 1U);
  EXPECT_THAT(zero.expressions, ::testing::ElementsAre("blink"));
  for (const Character* it : {&one, &zero}) {
    EXPECT_GT(it->standing.at_rest(HumanBone::LeftHand).x, 0.5F);
    EXPECT_GT(it->standing.at_rest(HumanBone::LeftToes).z, 0.05F);
  }
}

TEST(Character, TellsAPosesFromAnother) {
  EXPECT_EQ(made({.arm_down = 40}).standing.pose, RestPose::A);
  EXPECT_EQ(made({.arm_down = 80}).standing.pose, RestPose::ArmsDown);
}

/// A model of bare nodes with these names, each on the one before.
import::gltf::Model named(const std::vector<std::string>& names) {
  import::gltf::Model model;
  for (const std::string& name : names) {
    import::gltf::Node node;
    node.name = name;
    node.parent = static_cast<std::int32_t>(model.nodes.size()) - 1;
    model.nodes.push_back(node);
    model.order.push_back(static_cast<std::int32_t>(model.nodes.size()) - 1);
  }
  return model;
}

std::string name_of_bone(const std::vector<std::string>& names, HumanBone bone) {
  const std::int32_t node = bones_by_name(named(names))[bone];
  return node < 0 ? "" : names[static_cast<std::size_t>(node)];
}

/// What is said of a character with a vertex this far up.
std::string refusal_with_a_vertex_at(float height) {
  import::gltf::Model model = import::gltf::parse_model(test::make_glb({}), "made.glb", {});
  model.meshes.at(0).name = "Cloak";
  model.meshes.at(0).primitives.at(0).position.at(5).y = height;
  return refusal_of([&] { make_character(model, "made.glb"); });
}

TEST(Character, WithAPartFarFromItsBodyIsRefusedByThePartsName) {
  EXPECT_EQ(refusal_with_a_vertex_at(4), "");
  for (const float height : {40.0F, -40.0F, 4e20F, 3e38F, std::numeric_limits<float>::infinity(),
                             std::numeric_limits<float>::quiet_NaN()})
    EXPECT_THAT(refusal_with_a_vertex_at(height), HasSubstr("its mesh \"Cloak\" reaches"))
        << height;
}

TEST(Character, WithABoneFarFromTheOthersIsRefusedByTheBonesName) {
  for (const float out : {30.0F, 1e11F}) {
    import::gltf::Model moved = import::gltf::parse_model(test::make_glb({}), "made.glb", {});
    import::gltf::Model bound = moved;
    for (const std::int32_t n : moved.order)
      if (moved.nodes[import::gltf::entry(n)].name == "mixamorig:LeftHand") {
        moved.nodes[import::gltf::entry(n)].local[3].x = out;
        for (std::size_t j = 0; j < bound.skins.at(0).joints.size(); ++j)
          if (bound.skins[0].joints[j] == n) bound.skins[0].inverse_bind[j][3].x = out;
      }
    EXPECT_THAT(refusal_of([&] { make_character(moved, "made.glb"); }),
                HasSubstr("leftHand lies more than 10 times as far"))
        << out;
    EXPECT_THAT(refusal_of([&] { make_character(bound, "made.glb"); }),
                HasSubstr("as its skin was bound"))
        << out;
  }
}

TEST(BoneNames, AreThoseOfManyPrograms) {
  using enum HumanBone;
  EXPECT_EQ(name_of_bone({"Bip001 L UpperArm", "Bip001 L Forearm"}, LeftLowerArm),
            "Bip001 L Forearm");
  EXPECT_EQ(name_of_bone({"ValveBiped.Bip01_R_Thigh", "ValveBiped.Bip01_R_Calf"}, RightUpperLeg),
            "ValveBiped.Bip01_R_Thigh");
  EXPECT_EQ(
      name_of_bone({"DEF-upper_arm.L", "DEF-upper_arm.L.001", "upper_arm_fk.L"}, LeftUpperArm),
      "DEF-upper_arm.L");
  EXPECT_EQ(name_of_bone({"upperleg01.R", "upperleg02.R"}, RightUpperLeg), "upperleg01.R");
  EXPECT_EQ(name_of_bone({"lThighBend", "lThighTwist", "lShin"}, LeftUpperLeg), "lThighBend");
  EXPECT_EQ(name_of_bone({"J_Bip_C_Hips", "J_Bip_L_Foot"}, Hips), "J_Bip_C_Hips");
  EXPECT_EQ(name_of_bone({"Left leg", "Left knee", "Left ankle"}, LeftUpperLeg), "Left leg");
  EXPECT_EQ(name_of_bone({"Left leg", "Left knee", "Left ankle"}, LeftLowerLeg), "Left knee");
  EXPECT_EQ(name_of_bone({"LeftShoulder", "LeftElbow", "LeftWrist"}, LeftUpperArm), "LeftShoulder");
  EXPECT_EQ(name_of_bone({"lfemur", "ltibia", "lfoot"}, LeftLowerLeg), "ltibia");
  EXPECT_EQ(name_of_bone({"左腕", "左ひじ", "左手首"}, LeftHand), "左手首");
  EXPECT_EQ(name_of_bone({"upperarm_twist_01_l", "upperarm_l", "ik_hand_l", "hand_l"}, LeftHand),
            "hand_l");
  EXPECT_EQ(name_of_bone({"Armature|mixamorig1:RightToeBase"}, RightToes),
            "Armature|mixamorig1:RightToeBase");
}

/// The characters of the reference data are read as was measured by hand.
TEST(Character, OfTheReferenceDataIsWhatItsFactsSay) {
  NEEDS_SPEED();
  NEEDS_REFERENCE_DATA("models/characters");
  const std::filesystem::path folder = test::reference_data() / "models/characters";
  const auto facts = nlohmann::json::parse(*file::read_file(folder / "characters.facts.json"));
  for (const auto& [name, fact] : facts.items()) {
    SCOPED_TRACE(name);
    const auto humanoid = fact.find("humanoid");
    if (humanoid == fact.end() || !humanoid->contains("rest_pose")) {
      EXPECT_NE(refusal_of([&] { read_character(folder / name); }), "");
      continue;
    }
    const Character it = read_character(folder / name);
    EXPECT_EQ(it.extent.triangles, fact["triangles"]);
    EXPECT_LE(it.body.surface.indices.size() / 3, most_triangles);
    EXPECT_NEAR(it.extent.high.y - it.extent.low.y, fact["bounding_box"]["size"][1].get<double>(),
                0.01);
    EXPECT_EQ(name_of(it.standing.pose), (*humanoid)["rest_pose"].get<std::string>());
    for (const auto& [bone, node] : (*humanoid)["bones"].items()) {
      if (bone.find("Thumb") != std::string::npos) continue;  // VRM 1.0 moved their names
      const auto found = std::ranges::find(bone_names, bone);
      ASSERT_NE(found, bone_names.end()) << bone;
      EXPECT_EQ(it.bone_node[static_cast<std::size_t>(found - bone_names.begin())],
                node.get<std::string>())
          << bone;
    }
  }
}

TEST(Character, ThatIsBrokenIsRefusedWithASentence) {
  NEEDS_REFERENCE_DATA("models/broken");
  std::size_t count = 0;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(test::reference_data() / "models/broken")) {
    const std::string kind = entry.path().extension();
    if (kind != ".gltf" && kind != ".glb" && kind != ".vrm" && kind != ".stl" && kind != ".obj" &&
        kind != ".ply")
      continue;
    ++count;
    EXPECT_NE(refusal_of([&] { read_character(entry.path()); }), "") << entry.path();
  }
  EXPECT_GT(count, 90U);
}

}  // namespace
}  // namespace docent::character::character_test
