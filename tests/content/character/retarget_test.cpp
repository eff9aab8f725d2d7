#include "content/character/retarget.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

#include "content/import/gltf/read_model.h"
#include "content/import/motion/motion_folder.h"
#include "content/motion/foot_plants.h"
#include "tests/content/character/made_character.h"
#include "tests/support/reference_data.h"
#include "tests/support/sanitized.h"

namespace docent::character::retarget_test {
namespace {

namespace off = motion::offline;

/// The clips that docent ships, on the ground and with their plants.
struct Recording {
  Skeleton skeleton;
  std::vector<MotionClip> clips;
  float toe_rest = 0;
};

const Recording& recording() {
  static const Recording made = [] {
    Recording recording;
    std::vector<Diagnostic> problems;
    for (import::FolderMotion& read :
         import::read_motion_folder(test::source_dir() / "content/clips", problems)) {
      recording.skeleton = read.motion.skeleton;
      recording.clips.push_back(std::move(read.motion.clip));
    }
    std::vector<double> heights;
    for (MotionClip& clip : recording.clips) {
      const off::JointPositions track = off::joint_positions(recording.skeleton, clip);
      off::find_foot_plants(recording.skeleton, track, clip);
      heights.push_back(off::planted_height(recording.skeleton, track, clip));
    }
    const double rest = off::rest_height(recording.skeleton, heights);
    for (std::size_t c = 0; c < heights.size(); ++c)
      off::level_ground(rest - heights[c], recording.clips[c]);
    recording.toe_rest = static_cast<float>(rest);
    return recording;
  }();
  return made;
}

struct Limb {
  BodyPart from, to;
};
constexpr std::array limbs{Limb{BodyPart::LeftHip, BodyPart::LeftKnee},
                           Limb{BodyPart::LeftKnee, BodyPart::LeftAnkle},
                           Limb{BodyPart::RightHip, BodyPart::RightKnee},
                           Limb{BodyPart::RightKnee, BodyPart::RightAnkle},
                           Limb{BodyPart::LeftShoulder, BodyPart::LeftElbow},
                           Limb{BodyPart::LeftElbow, BodyPart::LeftWrist},
                           Limb{BodyPart::RightShoulder, BodyPart::RightElbow},
                           Limb{BodyPart::RightElbow, BodyPart::RightWrist}};

Vec3 direction(const off::JointPositions& track, const Skeleton& skeleton, std::size_t frame,
               Limb limb) {
  return glm::normalize(track.at(frame, docent::index_of(skeleton[limb.to])) -
                        track.at(frame, docent::index_of(skeleton[limb.from])));
}

/// What a retargeted recording is judged by.
struct Judged {
  double limb_degrees = 0;  ///< The largest angle between a limb and the recorded one.
  double drift = 0;         ///< Metres: the farthest that a planted toe lies from its plant's mean.
  double sunk = 0;          ///< Metres that a toe joint is below where it rests.
  double in_trunk = -1;     ///< Metres that an arm is inside the trunk.
  double spread = 0;        ///< Degrees that arms are held further out.
};

double drift_of(const MotionClip& clip, const off::JointPositions& track, std::size_t toe,
                bool FootPlants::* foot) {
  double worst = 0;
  for (std::size_t f = 0; f < clip.plants.size();) {
    std::size_t end = f;
    Vec3 sum{0};
    while (end < clip.plants.size() && clip.plants[end].*foot) sum += track.at(end++, toe);
    for (std::size_t g = f; g < end; ++g)
      worst = std::max(worst, static_cast<double>(glm::distance(
                                  track.at(g, toe), sum / static_cast<float>(end - f))));
    f = std::max(end, f + 1);
  }
  return worst;
}

Judged judge(const Character& character) {
  const Recording& from = recording();
  const Measures measures = measure(character);
  const Fit fit = fit_skeleton(from.skeleton, measures, from.toe_rest);
  const SkinnedMesh body = bind_body(character, measures, fit);
  std::vector<const MotionClip*> clips;
  for (const MotionClip& clip : from.clips) clips.push_back(&clip);
  const float spread = spread_for(fit, body, clips);
  Judged judged{.spread = spread * 180 / std::numbers::pi};
  for (const MotionClip& clip : from.clips) {
    const MotionClip own = retarget(fit, clip, spread);
    const off::JointPositions old_track = off::joint_positions(from.skeleton, clip);
    const off::JointPositions track = off::joint_positions(fit.skeleton, own);
    for (std::size_t f = 0; f < own.root.size(); ++f) {
      for (const Limb& limb : limbs) {
        const bool is_arm = limb.from >= BodyPart::LeftClavicle;
        if (is_arm && spread > 0) continue;
        const float cosine = glm::dot(direction(track, fit.skeleton, f, limb),
                                      direction(old_track, from.skeleton, f, limb));
        judged.limb_degrees = std::max(judged.limb_degrees,
                                       std::acos(std::min(cosine, 1.0F)) * 180 / std::numbers::pi);
      }
      for (const BodyPart toe : {BodyPart::LeftToe, BodyPart::RightToe})
        judged.sunk = std::max<double>(
            judged.sunk, fit.toe_rest - track.at(f, docent::index_of(fit.skeleton[toe])).y);
    }
    const auto toe = [&](BodyPart part) { return docent::index_of(fit.skeleton[part]); };
    judged.drift =
        std::max({judged.drift, drift_of(own, track, toe(BodyPart::LeftToe), &FootPlants::left),
                  drift_of(own, track, toe(BodyPart::RightToe), &FootPlants::right)});
    judged.in_trunk = std::max<double>(judged.in_trunk, depth_in_trunk(fit.skeleton, body, own));
  }
  return judged;
}

void expect_good(const Judged& judged, double limb_degrees = 2) {
  EXPECT_LE(judged.limb_degrees, limb_degrees);
  EXPECT_LE(judged.drift, 0.005);
  EXPECT_LE(judged.sunk, 0.015);
  EXPECT_LE(judged.in_trunk, 0);
}

Character made(const test::MadeCharacter& how) {
  return make_character(import::gltf::parse_model(test::make_glb(how), "made.glb", {}), "made.glb");
}

TEST(Retarget, KeepsFeetAndLimbsOfWhoeverIsMade) {
  expect_good(judge(made({})));
  expect_good(judge(made({.legs = 0.6F, .arm_down = 45})));
  expect_good(judge(made({.legs = 1.1F, .unit = 0.01F})));
}

TEST(Retarget, HoldsArmsOutOfAWideTrunk) {
  const Judged wide = judge(made({.girth = 1.6F}));

  EXPECT_GT(wide.spread, 0);
  expect_good(wide);
}

TEST(Retarget, KeepsFeetAndLimbsOfTheReferenceCharacters) {
  NEEDS_SPEED();
  NEEDS_REFERENCE_DATA("models/characters");
  for (const char* name :
       {"cesium_man.glb", "gdbot.glb", "godette_vrm0.vrm", "kaykit_knight.glb",
        "mesh_convertibles_vrm0.vrm", "mpfb_mixamo_names_tpose_cm.glb",
        "mpfb_unreal_names_apose.glb", "mpfb_vrm1_tpose.vrm", "quaternius_knight.glb",
        "quaternius_man_suit.glb", "quaternius_man_worker.glb", "quaternius_woman_formal.glb",
        "rigged_figure.glb", "smoke_spring_vrm1.vrm", "sphere_vrm0.vrm"}) {
    SCOPED_TRACE(name);
    // Two have a third of an adult's legs, or an ankle joint on the ground.
    const std::string_view which = name;
    const bool is_odd = which == "kaykit_knight.glb" || which == "quaternius_knight.glb";
    expect_good(judge(read_character(test::reference_data() / "models/characters" / name)),
                is_odd ? 5 : 2);
  }
}

RC_GTEST_PROP(ASpringOfAnyStrength, IsBoundWithinWhatTheKioskTakes, ()) {
  static const Character with_plait = make_character(
      import::gltf::parse_model(
          test::make_glb({.is_vrm1 = true,
                          .hair = 4,
                          .springs = R"({"springs":[{"joints":[{"node":21},{"node":22},{"node":23},
                                        {"node":24}]}]})"}),
          "made.vrm", {}),
      "made.vrm");
  Character character = with_plait;
  const auto strength = [] {
    return std::pow(10.0F, static_cast<float>(*rc::gen::inRange(-2000, 38000)) / 1000);
  };
  for (SpringBone& bone : character.swinging.bone) {
    bone.pull = strength();
    bone.gravity = strength() * Vec3{0.48F, -0.8F, 0.36F};
  }
  const Measures measures = measure(character);

  const SkinnedMesh body = bind_body(
      character, measures, fit_skeleton(recording().skeleton, measures, recording().toe_rest));

  RC_ASSERT(body.cloth.node.size() == 3U);
  for (const ClothNode& node : body.cloth.node) {
    RC_ASSERT(node.stiffness >= 0 && node.stiffness <= most_cloth_pull);
    RC_ASSERT(glm::dot(node.gravity, node.gravity) <= most_cloth_gravity * most_cloth_gravity);
  }
}

}  // namespace
}  // namespace docent::character::retarget_test
