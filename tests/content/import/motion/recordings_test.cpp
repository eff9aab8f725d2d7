#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "content/content_error.h"
#include "content/import/motion/amc.h"
#include "content/import/motion/bvh.h"
#include "content/import/motion/bvh_write.h"
#include "tests/support/reference_data.h"

namespace docent::test::recordings_test {
namespace {

std::vector<std::filesystem::path> recordings(const std::string& extension) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(reference_data() / "mocap"))
    if (entry.path().extension() == extension) files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

/// Largest distance between two recordings' joints, where their bodies have the same part.
double largest_distance(const import::RecordedMotion& a, const import::RecordedMotion& b) {
  std::vector<Vec3> in_a, in_b;
  double worst = a.clip.root.size() == b.clip.root.size() ? 0 : 1e9;
  for (std::size_t f = 0; f < std::min(a.clip.root.size(), b.clip.root.size()); ++f) {
    import::place_joints(a.skeleton, a.clip, f, in_a);
    import::place_joints(b.skeleton, b.clip, f, in_b);
    for (std::size_t p = 0; p < a.skeleton.part.size(); ++p) {
      const JointIndex ja = a.skeleton.part[p], jb = b.skeleton.part[p];
      if ((ja == JointIndex::None) != (jb == JointIndex::None)) return 1e9;
      if (ja == JointIndex::None) continue;
      worst = std::max<double>(worst, glm::distance(in_a[index_of(ja)], in_b[index_of(jb)]));
    }
  }
  return worst;
}

TEST(Recordings, AllComeInAsAnAdultWithAllParts) {
  NEEDS_REFERENCE_DATA("mocap");
  for (const auto& file : recordings(".bvh")) {
    SCOPED_TRACE(file);
    import::RecordedMotion motion;
    ASSERT_NO_THROW(motion = import::read_bvh(file));

    for (std::size_t part = 0; part < motion.skeleton.part.size(); ++part)
      EXPECT_NE(motion.skeleton.part[part], JointIndex::None) << part;
    std::vector<Vec3> places;
    std::vector<float> heights;
    for (std::size_t f = 0; f < motion.clip.root.size(); ++f) {
      import::place_joints(motion.skeleton, motion.clip, f, places);
      heights.push_back(places[index_of(motion.skeleton[BodyPart::HeadTop])].y);
    }
    EXPECT_GT(std::ranges::max(heights), 1.3f);
    EXPECT_LT(std::ranges::max(heights), 2.3f);
    EXPECT_TRUE(motion.clip.frame_rate == 120 || motion.clip.frame_rate == 30);
  }
}

TEST(Recordings, LoseTheTPoseOfTheCgspeedRelease) {
  NEEDS_REFERENCE_DATA("mocap");
  const auto folder = reference_data() / "mocap/cmu-varied/cgspeed-bvh";

  EXPECT_EQ(frame_count(import::read_bvh(folder / "05_03.bvh").clip), 434U);
  EXPECT_EQ(frame_count(import::read_bvh(folder / "06_09.bvh").clip), 301U);
}

TEST(Recordings, StayWhereTheyAreWhenWrittenAndReadAgain) {
  NEEDS_REFERENCE_DATA("mocap");
  for (const char* file : {"cmu-walk/16_20-turn-right-90.bvh", "cmu-varied/49_06-cartwheel.bvh",
                           "cmu-varied/bandai-namco-cc-by-nc/dataset-1_walk_normal_001.bvh"}) {
    const import::RecordedMotion motion = import::read_bvh(reference_data() / "mocap" / file);

    const std::string text = import::to_bvh(
        motion.skeleton, {motion.clip.frame_rate, motion.clip.root, motion.clip.rotation});

    EXPECT_LT(largest_distance(motion, import::parse_bvh(text, "again.bvh", 1.0)), 1e-5) << file;
  }
}

TEST(Recordings, AreTheSameFromBvhAndFromAcclaimFiles) {
  NEEDS_REFERENCE_DATA("mocap");
  const std::vector<std::filesystem::path> bvhs = recordings(".bvh");
  std::size_t compared = 0;
  for (const auto& amc : recordings(".amc")) {
    SCOPED_TRACE(amc);
    const std::string name = amc.stem().string();
    const auto bvh = std::ranges::find_if(bvhs, [&](const std::filesystem::path& file) {
      return file.stem().string().starts_with(name + "-");
    });
    ASSERT_NE(bvh, bvhs.end());
    const auto asf = amc.parent_path() / (name.substr(0, name.find('_')) + ".asf");

    const import::RecordedMotion from_amc = import::read_amc(amc, import::read_asf(asf));

    EXPECT_LT(largest_distance(from_amc, import::read_bvh(*bvh)), 0.05e-3);
    ++compared;
  }
  EXPECT_EQ(compared, 18U);
}

}  // namespace
}  // namespace docent::test::recordings_test
