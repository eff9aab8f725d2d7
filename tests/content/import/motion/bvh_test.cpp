#include "content/import/motion/bvh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "content/content_error.h"
#include "content/import/motion/bvh_write.h"
#include "tests/content/import/motion/sample_body.h"

namespace docent::test::bvh_test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

std::vector<SampleFrame> random_frames(const std::vector<SampleJoint>& body, int least_degrees,
                                       int most_degrees) {
  std::vector<SampleFrame> frames;
  for (int f = 0; f < *rc::gen::inRange(1, 4); ++f) {
    SampleFrame frame = standing_frame(body);
    frame.hips = {*rc::gen::inRange(-500, 500) / 100.0, 0.9, *rc::gen::inRange(-500, 500) / 100.0};
    for (auto& angles : frame.zyx)
      for (double& angle : angles)
        angle = *rc::gen::inRange(100 * least_degrees, 100 * most_degrees) / 100.0;
    frames.push_back(frame);
  }
  return frames;
}

/// Largest distance between the importer's joints and the oracle's, metres.
double error_of(const import::RecordedMotion& motion, const std::vector<SampleJoint>& body,
                const std::vector<SampleFrame>& frames, const std::string& order) {
  double worst = motion.skeleton.joint.size() == body.size() ? 0 : 1e9;
  std::vector<Vec3> places;
  for (std::size_t f = 0; f < frames.size() && worst < 1e9; ++f) {
    import::place_joints(motion.skeleton, motion.clip, f, places);
    const std::vector<glm::dvec3> expected = places_in(body, frames[f], order);
    for (std::size_t j = 0; j < body.size(); ++j)
      worst = std::max(worst, glm::distance(glm::dvec3(places[j]), expected[j]));
  }
  return worst;
}

TEST(Bvh, PutsEveryJointWhereTheChannelsSayInAnyOrder) {
  EXPECT_TRUE(rc::check([] {
    const auto body = sample_body();
    const auto frames = random_frames(body, -170, 170);
    std::string order = "XYZ";
    for (int swaps = *rc::gen::inRange(0, 6); swaps > 0; --swaps)
      std::ranges::next_permutation(order);

    const auto motion =
        import::parse_bvh(bvh_text(body, frames, {.rotation_order = order}), "a.bvh", 1.0);

    RC_ASSERT(error_of(motion, body, frames, order) < 5e-6);
  }));
}

TEST(Bvh, ReadsTheSameBodyInEveryUnitAndStyle) {
  const auto body = sample_body();
  SampleFrame frame = standing_frame(body);
  frame.zyx[2] = {10, 20, 30};
  const double cmu = 0.0254 / 0.45;
  for (const BvhStyle& style : {
           BvhStyle{},
           BvhStyle{.metres_per_unit = 0.01},
           BvhStyle{.metres_per_unit = 0.001},
           BvhStyle{.metres_per_unit = 0.0254, .line_end = "\r\n"},
           BvhStyle{.line_end = "\r", .comment = "# recorded on a Tuesday"},
           BvhStyle{.metres_per_unit = cmu, .after_channels = " \t", .frame_time = ".0083333"},
           BvhStyle{.comment = "# recorded on a Tuesday"},
           BvhStyle{.comment = "// recorded on a Tuesday"},
           BvhStyle{.positions_everywhere = true},
           BvhStyle{.metres_per_unit = 0.01, .positions_everywhere = true, .dummy_root = true},
       }) {
    const auto motion = import::parse_bvh(bvh_text(body, {frame, frame}, style), "a.bvh");

    EXPECT_NEAR(motion.scale.metres_per_unit, style.metres_per_unit, 1e-9);
    EXPECT_LT(error_of(motion, body, {frame, frame}, "ZYX"), 1e-5);
    EXPECT_EQ(motion.clip.frame_rate, 120);
    EXPECT_EQ(motion.skeleton.joint[0].name, "Hips");
    EXPECT_THAT(motion.notes, IsEmpty());
  }
}

TEST(Bvh, ReadsNumbersThatFollowTheirLabelsWithoutABlank) {
  std::string text = bvh_text(sample_body(), {standing_frame(sample_body())});
  for (const std::string_view label : {"Frames: ", "Frame Time: "})
    text.erase(text.find(label) + label.size() - 1, 1);

  const auto motion = import::parse_bvh(text, "a.bvh", 1.0);

  EXPECT_EQ(frame_count(motion.clip), 1U);
  EXPECT_EQ(motion.clip.frame_rate, 120);
}

TEST(Bvh, CountsLinesThatEndInAnyWayToBlameOne) {
  const auto line_in = [](const char* line_end) {
    std::string text = bvh_text(sample_body(), {standing_frame(sample_body())},
                                {.line_end = line_end, .comment = "# recorded on a Tuesday"});
    text.replace(text.find("Time:"), 5, "Rhyme");
    try {
      import::parse_bvh(text, "a.bvh", 1.0);
    } catch (const content::ContentError& error) {
      return std::pair(error.line, error.column);
    }
    return std::pair(0U, 0U);
  };
  EXPECT_EQ(line_in("\r"), line_in("\n"));
  EXPECT_EQ(line_in("\r\n"), line_in("\n"));
}

TEST(Bvh, KeepsRatesThatAreNoWholeNumbers) {
  EXPECT_EQ(import::frame_rate_of(0.0333333), 30);
  EXPECT_EQ(import::frame_rate_of(0.00833), 120);
  EXPECT_NEAR(import::frame_rate_of(1001.0 / 30000), 29.97, 0.001);
}

TEST(Bvh, LeavesOutATPoseBeforeTheRecordingAndSaysSo) {
  const auto body = sample_body();
  const SampleFrame straight = standing_frame(body);
  SampleFrame moving = straight;
  for (auto& angles : moving.zyx) angles = {12.3456, -7.8912, 3.1415};

  const auto motion = import::parse_bvh(bvh_text(body, {straight, moving, moving}), "a.bvh");

  EXPECT_EQ(frame_count(motion.clip), 2U);
  ASSERT_EQ(motion.notes.size(), 1U);
  EXPECT_EQ(motion.notes[0].code, "rest-pose-dropped");
}

TEST(Bvh, KeepsAStraightFirstFrameThatTheRecordingGoesOnFrom) {
  const auto body = sample_body();
  std::vector<SampleFrame> frames(3, standing_frame(body));
  frames[1].zyx[1] = {0.1234, 0, 0};

  EXPECT_EQ(frame_count(import::parse_bvh(bvh_text(body, frames), "a.bvh").clip), 3U);
}

TEST(Bvh, TakesTheMeanOfABoneThatStretchesAndSaysSo) {
  const auto body = sample_body();
  auto stretched = body;
  stretched[2].offset.y -= 0.04;
  const std::vector<SampleFrame> frame{standing_frame(body)};
  const BvhStyle style{.positions_everywhere = true};
  std::string text = bvh_text(body, frame, style);
  const std::string other = bvh_text(stretched, frame, style);
  text.replace(text.find("Frames: 1"), 9, "Frames: 2");
  text += other.substr(other.find("Frame Time: 0.0083333\n") + 22);

  const auto motion = import::parse_bvh(text, "a.bvh", 1.0);

  EXPECT_NEAR(motion.skeleton.joint[2].offset.y, -0.43, 1e-6);
  ASSERT_EQ(motion.notes.size(), 1U);
  EXPECT_EQ(motion.notes[0].message, "the bone to 'LeftLeg' changes by 2.0 cm; its mean is used");
}

struct BadText {
  std::string name;      ///< Of the test.
  std::string from, to;  ///< What is changed in a good text; an empty `from` cuts after `to`.
  std::string code, sentence;
};

class BadBvh : public testing::TestWithParam<BadText> {};

TEST_P(BadBvh, IsToldInASentenceWithItsLine) {
  const auto body = sample_body();
  std::string text = bvh_text(body, std::vector(2, standing_frame(body)));
  const auto at = text.find(GetParam().from);
  ASSERT_NE(at, text.npos);
  text.replace(at, GetParam().from.size(), GetParam().to);
  const auto line =
      1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');

  try {
    import::parse_bvh(text, "walk.bvh");
    FAIL() << "no error";
  } catch (const content::ContentError& error) {
    EXPECT_EQ(error.code, GetParam().code);
    EXPECT_THAT(error.what(), HasSubstr(GetParam().sentence));
    EXPECT_EQ(error.file, "walk.bvh");
    EXPECT_NEAR(error.line, static_cast<double>(line), 1);
    EXPECT_GE(error.column, 1U);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Every, BadBvh,
    testing::Values(
        BadText{"NoHierarchy", "HIERARCHY", "MOTION", "unexpected-word",
                "expected 'HIERARCHY' here, but found 'MOTION'"},
        BadText{"NoRoot", "ROOT", "JOINT", "unexpected-word", "expected 'ROOT'"},
        BadText{"NoBrace", "ROOT Hips\n{", "ROOT Hips\nOFFSET", "unexpected-word", "expected '{'"},
        BadText{"NoName", "JOINT LeftLeg\n", "JOINT \n", "nameless-joint", "a joint has no name"},
        BadText{"WordForNumber", "OFFSET 0.090000000", "OFFSET wide", "bad-number",
                "the joint's OFFSET should be a number, but is 'wide'"},
        BadText{"Infinity", "OFFSET 0.090000000", "OFFSET 1e400", "bad-number",
                "which no recording holds"},
        BadText{"UnknownChannel", "Zrotation Yrotation Xrotation\nJOINT LeftLeg",
                "Zrotation Yrotation Wrotation\nJOINT LeftLeg", "unknown-channel",
                "'Wrotation' is not a channel"},
        BadText{"TooManyChannels", "CHANNELS 3", "CHANNELS 9", "bad-count",
                "the number of CHANNELS should be a whole number from 0 to 6"},
        BadText{"WrongChannelCount", "CHANNELS 3", "CHANNELS 2", "unexpected-word",
                "but found 'Xrotation'"},
        BadText{"NoMotion", "MOTION", "ROOT", "second-root", "the file holds a second body"},
        BadText{"NegativeFrames", "Frames: 2", "Frames: -2", "bad-count", "number of frames"},
        BadText{"NoFrames", "Frames: 2", "Frames: two", "bad-number",
                "the number of frames should be a number, but is 'two'"},
        BadText{"BadFrameTime", "Frame Time: 0.0083333", "Frame Time: 120", "bad-frame-time",
                "is not between 0.1 ms and 1 s"},
        BadText{"MissingFrames", "Frames: 2", "Frames: 3", "missing-frames",
                "3 frames are declared, but 2 are there"},
        BadText{"SurplusFrames", "Frames: 2", "Frames: 1", "surplus-frames",
                "1 frames are declared, but 2 are there"},
        BadText{"ShortFrame", "Time: 0.0083333\n0.000000000", "Time: 0.0083333\n", "wrong-count",
                "this frame has 65 numbers, but the joints have 66 channels"},
        BadText{"NotANumberInAFrame", "Time: 0.0083333\n0.000000000", "Time: 0.0083333\nnan",
                "bad-number", "is 'nan', which no recording holds"}),
    [](const auto& test) { return test.param.name; });

TEST(Bvh, CutAnywhereIsAnErrorAndNeverAShorterMotion) {
  const auto body = sample_body();
  std::vector<SampleFrame> frames(3, standing_frame(body));
  std::string text = bvh_text(body, frames);
  while (text.back() == '\n' || text.back() == ' ' || text.back() == '0') text.pop_back();
  EXPECT_TRUE(rc::check([&] {
    const auto length = *rc::gen::inRange<std::size_t>(0, text.size() - 1);

    RC_ASSERT_THROWS_AS(import::parse_bvh(text.substr(0, length), "cut.bvh"),
                        content::ContentError);
  }));
}

TEST(Bvh, WithoutLegsAsksForItsUnit) {
  const std::vector<SampleJoint> tail{
      {"Hips", -1, {}}, {"Tail", 0, {0, 0, -1}}, {"", 1, {0, 0, -1}, true}};
  const std::string text = bvh_text(tail, {standing_frame(tail)});

  try {
    import::parse_bvh(text, "tail.bvh");
    FAIL() << "no error";
  } catch (const content::ContentError& error) {
    EXPECT_EQ(error.code, "unknown-unit");
    EXPECT_THAT(error.hint, HasSubstr("clips.toml"));
  }
  EXPECT_NO_THROW(import::parse_bvh(text, "tail.bvh", 1.0));
}

TEST(BvhWriter, WritesWhatTheReaderReads) {
  EXPECT_TRUE(rc::check([] {
    const auto body = sample_body();
    const auto frames = random_frames(body, -180, 180);
    const auto motion = import::parse_bvh(bvh_text(body, frames), "a.bvh", 1.0);

    const std::string text = import::to_bvh(
        motion.skeleton, {motion.clip.frame_rate, motion.clip.root, motion.clip.rotation});

    RC_ASSERT(error_of(import::parse_bvh(text, "b.bvh", 1.0), body, frames, "ZYX") < 1e-5);
  }));
}

TEST(BvhWriter, TurnsOnThroughFullCirclesWithoutLeaps) {
  const auto body = sample_body();
  std::vector<SampleFrame> frames(100, standing_frame(body));
  for (std::size_t f = 0; f < frames.size(); ++f)
    frames[f].zyx[0] = {0, 8.0 * static_cast<double>(f), 0};  // past 90 degrees, and twice round
  const auto motion = import::parse_bvh(bvh_text(body, frames), "a.bvh", 1.0);

  const std::string text =
      import::to_bvh(motion.skeleton, {120, motion.clip.root, motion.clip.rotation});

  std::istringstream lines(text.substr(text.find("Frame Time")));
  std::string line;
  std::getline(lines, line);
  std::array<double, 6> before{};
  for (std::size_t f = 0; std::getline(lines, line); ++f) {
    std::istringstream words(line);
    std::array<double, 6> now{};
    for (double& value : now) words >> value;
    for (std::size_t i = 3; f > 0 && i < 6; ++i) EXPECT_LT(std::abs(now[i] - before[i]), 30) << f;
    before = now;
  }
}

TEST(BvhWriter, SaysWhereItCannotWrite) {
  const auto body = sample_body();
  const auto motion = import::parse_bvh(bvh_text(body, {standing_frame(body)}), "a.bvh", 1.0);

  try {
    import::write_bvh(motion.skeleton, {120, motion.clip.root, motion.clip.rotation},
                      "/nonexistent/folder/walk.bvh");
    FAIL() << "no error";
  } catch (const content::ContentError& error) {
    EXPECT_EQ(error.kind, Errc::Environment);
    EXPECT_EQ(error.file, "/nonexistent/folder/walk.bvh");
  }
}

}  // namespace
}  // namespace docent::test::bvh_test
