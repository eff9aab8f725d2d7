#include "content/import/motion/motion_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "content/content_error.h"
#include "tests/content/import/motion/sample_body.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wide_text.h"

namespace docent::test::motion_folder_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

void write(const TemporaryFolder& folder, const std::string& name, const std::string& text) {
  std::ofstream(folder.path() / name, std::ios::binary) << text;
}

std::string good_bvh(double metres_per_unit = 1) {
  const auto body = sample_body();
  return bvh_text(body, {standing_frame(body)}, {.metres_per_unit = metres_per_unit});
}

/// The error that reading ends with; its code is empty where there is none.
content::ContentError error_of(const TemporaryFolder& folder, std::vector<Diagnostic>& problems) {
  try {
    import::read_motion_folder(folder.path(), problems);
  } catch (const content::ContentError& error) {
    return error;
  }
  return {"", 0, 0, "", ""};
}

std::vector<std::string> codes(const std::vector<Diagnostic>& problems) {
  std::vector<std::string> result;
  for (const Diagnostic& problem : problems) result.push_back(problem.code);
  return result;
}

TEST(MotionFolder, ReadsFilesInTheOrderOfTheirNames) {
  const TemporaryFolder folder;
  write(folder, "b.bvh", good_bvh());
  write(folder, "a.BVH", good_bvh(0.01));
  write(folder, "notes.txt", "not motion");
  std::vector<Diagnostic> problems;

  const auto motions = import::read_motion_folder(folder.path(), problems);

  ASSERT_EQ(motions.size(), 2U);
  EXPECT_EQ(motions[0].motion.clip.name, "a");
  EXPECT_EQ(motions[1].motion.clip.name, "b");
  EXPECT_THAT(problems, IsEmpty());
}

TEST(MotionFolder, WithoutMotionIsAnError) {
  const TemporaryFolder folder;
  std::vector<Diagnostic> problems;

  const content::ContentError error = error_of(folder, problems);

  EXPECT_EQ(error.code, "no-clips");
  EXPECT_STREQ(error.what(), "this folder holds no motion");
  EXPECT_EQ(error.kind, Errc::InvalidInput);
}

TEST(MotionFolder, ThatIsMissingIsAnErrorOfItsOwn) {
  std::vector<Diagnostic> problems;

  EXPECT_THROW(import::read_motion_folder("/nonexistent/clips", problems), content::ContentError);
}

TEST(MotionFolder, ReportsEveryBrokenFile) {
  const TemporaryFolder folder;
  write(folder, "a.bvh", "HIERARCHY\nROOT\n");
  write(folder, "b.bvh", good_bvh());
  write(folder, "c.bvh", good_bvh().substr(0, 300));
  write(folder, "d.amc", "1\nroot 0 0 0\n");
  std::vector<Diagnostic> problems;

  const content::ContentError error = error_of(folder, problems);

  EXPECT_THAT(codes(problems), ElementsAre("nameless-joint", "unexpected-word"));
  EXPECT_THAT(problems[1].file, HasSubstr("c.bvh"));
  EXPECT_EQ(error.code, "no-skeleton");
  EXPECT_THAT(error.file, HasSubstr("d.amc"));
}

TEST(MotionFolder, TakesUnitsAndRolesFromClipsToml) {
  const TemporaryFolder folder;
  write(folder, "a.bvh", good_bvh());
  write(folder, "b.bvh", good_bvh());
  write(folder, "clips.toml",
        "metres_per_unit = 2\n[clip.a]\nrole = \"turn-left\"\n"
        "[clip.\"b.bvh\"]\nmetres_per_unit = 1\nclass = \"stroll\"\n[clip.c]\nrole = \"walk\"\n");
  std::vector<Diagnostic> problems;

  const auto motions = import::read_motion_folder(folder.path(), problems);

  ASSERT_EQ(motions.size(), 2U);
  EXPECT_NEAR(motions[0].motion.clip.root[0].y, 1.9, 1e-6);
  EXPECT_EQ(motions[0].role, ClipRole::TurnLeft);
  EXPECT_NEAR(motions[1].motion.clip.root[0].y, 0.95, 1e-6);
  EXPECT_EQ(motions[1].role, std::nullopt);
  EXPECT_EQ(motions[1].motion_class, "stroll");
  ASSERT_THAT(codes(problems), ElementsAre("unknown-clip"));
  EXPECT_EQ(problems[0].message, "no file here is called 'c'");
}

struct BadToml {
  std::string name, text, code, sentence;
};

class BadClipsToml : public testing::TestWithParam<BadToml> {};

TEST_P(BadClipsToml, IsToldInASentenceWithItsLine) {
  const TemporaryFolder folder;
  write(folder, "a.bvh", good_bvh());
  write(folder, "clips.toml", "\n" + GetParam().text);
  std::vector<Diagnostic> problems;

  const content::ContentError error = error_of(folder, problems);

  EXPECT_EQ(error.code, GetParam().code);
  EXPECT_THAT(error.what(), HasSubstr(GetParam().sentence));
  EXPECT_THAT(error.file, HasSubstr("clips.toml"));
  EXPECT_EQ(error.line, 2U);
}

TEST(MotionFolder, SaysWhichEncodingItCannotRead) {
  const TemporaryFolder folder;
  write(folder, "a.bvh", good_bvh());
  write(folder, "clips.toml", wide(U"\uFEFFrole = 'walk'\n", 2, ByteOrder::Little));
  std::vector<Diagnostic> problems;

  EXPECT_THAT(error_of(folder, problems).what(), HasSubstr("is UTF-16 (little endian)"));
}

INSTANTIATE_TEST_SUITE_P(
    Every, BadClipsToml,
    testing::Values(
        BadToml{"NotToml", "metres = = 2", "not-toml", ""},
        BadToml{"UnknownKey", "meters_per_unit = 2", "unknown-key",
                "'meters_per_unit' is not known here"},
        BadToml{"Zero", "metres_per_unit = 0", "out-of-range",
                "'metres_per_unit' should be a number from 1e-06 to 1000"},
        BadToml{"Text", "frames_per_second = \"fast\"", "out-of-range", "'frames_per_second'"},
        BadToml{"UnknownRole", "clip.a.role = \"dance\"", "unknown-role", "'dance' is no role"},
        BadToml{"NoTable", "clip = 3", "wrong-type", "'clip' should be tables"}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace docent::test::motion_folder_test
