#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "content/content_error.h"
#include "content/import/motion/amc.h"

namespace docent::test::amc_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Two legs in tenths of an inch. The left knee's axis is turned by 90 degrees about z, so that its
/// "x" is the world's y.
const std::string two_legs = R"(# made up
:version 1.10
:name twolegs
:units
  mass 1.0
  length 10
  angle deg
:documentation
   begin is no keyword here
:root
   order TX TY TZ RX RY RZ
   axis XYZ
   position 0 0 0
   orientation 0 0 0
:bonedata
  begin
     id 1
     name lfemur
     direction 0 -1 0
     length 160
     axis 0 0 0 XYZ
     dof rx ry rz
     limits (-160.0 20.0)
            (-70.0 70.0)
            (-60.0 70.0)
  end
  begin
     id 2
     name ltibia
     direction 0 -1 0
     length 160
     axis 0 0 90 XYZ
     dof rx
     limits (-10.0 170.0)
  end
  begin
     id 3
     name rfemur
     direction 0 -1 0
     length 160
     axis 0 0 0 XYZ
  end
:hierarchy
  begin
    root lfemur rfemur
    lfemur ltibia
  end
)";

const std::string two_frames = R"(#!OML:ASF made up
:FULLY-SPECIFIED
:DEGREES
1
root 1 350 2 0 0 0
lfemur 0 0 0
ltibia 0
2
root 1 350 3 0 90 0
lfemur 90 0 0
ltibia 8.59744e-015
)";

std::vector<Vec3> places(const import::RecordedMotion& motion, std::size_t frame) {
  std::vector<Vec3> result;
  import::place_joints(motion.skeleton, motion.clip, frame, result);
  return result;
}

void expect_near(Vec3 actual, Vec3 expected) {
  EXPECT_LT(glm::distance(actual, expected), 1e-5f)
      << actual.x << " " << actual.y << " " << actual.z;
}

constexpr float inch_tenth = 0.00254f;

TEST(Acclaim, PutsJointsWhereBonesBegin) {
  const import::RecordedMotion motion =
      import::parse_amc(two_frames, "walk.amc", import::parse_asf(two_legs, "legs.asf"));

  std::vector<std::string> names;
  for (const Joint& joint : motion.skeleton.joint) names.push_back(joint.name);
  EXPECT_THAT(names, ElementsAre("root", "lfemur", "ltibia", "ltibia end", "rfemur", "rfemur end"));
  EXPECT_EQ(frame_count(motion.clip), 2U);
  EXPECT_EQ(motion.clip.frame_rate, 120);
  EXPECT_DOUBLE_EQ(motion.scale.metres_per_unit, 0.00254);
  const std::vector<Vec3> straight = places(motion, 0);
  expect_near(straight[1], inch_tenth * Vec3{1, 350, 2});
  expect_near(straight[2], inch_tenth * Vec3{1, 190, 2});
  expect_near(straight[3], inch_tenth * Vec3{1, 30, 2});
}

TEST(Acclaim, TurnsBonesAboutTheAxesOfTheirParents) {
  const import::RecordedMotion motion =
      import::parse_amc(two_frames, "walk.amc", import::parse_asf(two_legs, "legs.asf"));

  // 90 degrees about x turns "down" to "back" (-z), the root's 90 about y turns that to -x.
  expect_near(places(motion, 1)[2], inch_tenth * Vec3{1 - 160, 350, 3});
}

TEST(Acclaim, TurnsABoneAboutItsOwnAxis) {
  std::string bent = two_frames;
  bent.replace(bent.find("ltibia 0"), 8, "ltibia 90");

  const import::RecordedMotion motion =
      import::parse_amc(bent, "walk.amc", import::parse_asf(two_legs, "legs.asf"));

  // About the world's y, a bone that hangs down does not move.
  expect_near(places(motion, 0)[3], inch_tenth * Vec3{1, 30, 2});
}

TEST(Acclaim, ReadsRadiansWhereTheFileSaysSo) {
  std::string radians = two_frames;
  radians.replace(radians.find(":DEGREES"), 8, ":RADIANS");
  radians.replace(radians.find("0 90 0"), 6, "0 1.5707963268 0");
  radians.replace(radians.find("lfemur 90"), 9, "lfemur 1.5707963268");

  const import::RecordedMotion motion =
      import::parse_amc(radians, "walk.amc", import::parse_asf(two_legs, "legs.asf"));

  expect_near(places(motion, 1)[2], inch_tenth * Vec3{1 - 160, 350, 3});
}

struct BadText {
  std::string name, from, to, code, sentence;
};

void expect_error(const BadText& bad, const std::string& good,
                  const std::function<void(const std::string&)>& parse) {
  std::string text = good;
  const auto at = text.find(bad.from);
  ASSERT_NE(at, text.npos);
  text.replace(at, bad.from.size(), bad.to);
  try {
    parse(text);
    FAIL() << "no error";
  } catch (const content::ContentError& error) {
    EXPECT_EQ(error.code, bad.code);
    EXPECT_THAT(error.what(), HasSubstr(bad.sentence));
    EXPECT_GT(error.line, 0U);
  }
}

class BadAsf : public testing::TestWithParam<BadText> {};

TEST_P(BadAsf, IsToldInASentence) {
  expect_error(GetParam(), two_legs,
               [](const std::string& text) { import::parse_asf(text, "legs.asf"); });
}

INSTANTIATE_TEST_SUITE_P(
    Every, BadAsf,
    testing::Values(
        BadText{"Empty", two_legs, "", "no-hierarchy", "no :hierarchy"},
        BadText{"NoSections", ":version", "version", "unexpected-word", "begins with ':'"},
        BadText{"UnknownProperty", "dof rx\n", "mood rx\n", "unexpected-word",
                "'mood' is no property of a bone"},
        BadText{"WordForNumber", "length 160", "length long", "bad-number",
                "the bone's length should be a number, but is 'long'"},
        BadText{"BadOrder", "90 XYZ", "90 XYW", "bad-axis-order", "an axis is x, y or z"},
        BadText{"ShortOrder", "90 XYZ", "90 XY", "bad-axis-order", "'XY' is no order of axes"},
        BadText{"NoName", "     name lfemur\n", "", "nameless-joint", "a bone has no name"},
        BadText{"UnknownBone", "    lfemur ltibia\n", "    lfemur tail\n", "unknown-bone",
                "no bone is called 'tail'"},
        BadText{"TwoParents", "lfemur ltibia\n", "lfemur ltibia\n rfemur ltibia\n", "two-parents",
                "'ltibia' hangs on two bones"},
        BadText{"NoUnit", "length 10", "length 0", "bad-unit", "must be more than zero"}),
    [](const auto& test) { return test.param.name; });

class BadAmc : public testing::TestWithParam<BadText> {};

TEST_P(BadAmc, IsToldInASentence) {
  const import::AcclaimSkeleton skeleton = import::parse_asf(two_legs, "legs.asf");
  expect_error(GetParam(), two_frames,
               [&](const std::string& text) { import::parse_amc(text, "walk.amc", skeleton); });
}

INSTANTIATE_TEST_SUITE_P(
    Every, BadAmc,
    testing::Values(BadText{"Empty", two_frames, "", "no-frames", "the file has no frames"},
                    BadText{"MissingFrame", "\n2\n", "\n3\n", "missing-frames",
                            "frame 2 follows here, but it says 3"},
                    BadText{"CutInAFrame", "ltibia 8.59744e-015\n", "", "missing-frames",
                            "frame 2 does not say bone 'ltibia'"},
                    BadText{"CutInALine", "lfemur 90 0 0\n", "lfemur 90\n", "wrong-count",
                            "bone 'lfemur' has 3 freedoms, but this line is shorter"},
                    BadText{"LongLine", "lfemur 90 0 0\n", "lfemur 90 0 0 0\n", "wrong-count",
                            "bone 'lfemur' has 3 freedoms, but this line is longer"},
                    BadText{"OtherSkeleton", "lfemur 90", "tail 90", "unknown-bone",
                            "the skeleton has no bone 'tail'"},
                    BadText{"WordForNumber", "lfemur 90", "lfemur x", "bad-number",
                            "should be a number, but is 'x'"}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace docent::test::amc_test
