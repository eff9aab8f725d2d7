#include "content/compile/own_figure.h"

#include <gtest/gtest.h>

#include <fstream>

#include "content/compile/shipped_files.h"
#include "content/content_error.h"
#include "content/motion/compile_motion.h"
#include "tests/content/character/made_character.h"
#include "tests/support/temporary_folder.h"

namespace docent::compile::own_figure_test {
namespace {

std::filesystem::path write(const test::TemporaryFolder& folder, const std::string& bytes) {
  const std::filesystem::path file = folder.path() / "figure.glb";
  std::ofstream(file, std::ios::binary) << bytes;
  return file;
}

TEST(OwnFigure, WalksWithTheClipsAtItsOwnMeasure) {
  const test::TemporaryFolder folder;
  std::vector<Diagnostic> problems;
  OwnFigure figure(write(folder, test::make_glb({.legs = 0.7F})), problems);
  motion::offline::MotionOptions options;
  options.give_to_other = [&](Skeleton& skeleton, auto& clips) {
    return figure.take(skeleton, clips, 1);
  };

  const MotionGraph graph = motion::offline::compile_motion(shipped_clips(), options, problems);
  const SkinnedMesh mesh = figure.among_others(graph.skeleton, 1);

  EXPECT_FALSE(graph.transitions.empty());
  const Joint& knee = graph.skeleton.joint[index_of(graph.skeleton[BodyPart::LeftKnee])];
  EXPECT_NEAR(glm::length(knee.offset), 0.7F * 0.42F, 0.02F);
  ASSERT_TRUE(has_own_body(mesh));
  EXPECT_EQ(joints_of(mesh), graph.skeleton.joint.size());
  EXPECT_EQ(mesh.vertices.back().material, Material::Own);
  EXPECT_EQ(mesh.inverse_bind.size(), mesh.figure_end.size() * joints_of(mesh));
}

/// A plait of 60 joints: as much of it swings as a frame has time for and a body has matrices.
TEST(OwnFigure, WearsWhatSwingsAsFarAsThereIsRoom) {
  const test::TemporaryFolder folder;
  std::vector<Diagnostic> problems;
  OwnFigure figure(write(folder, test::make_glb({.is_vrm0 = true,
                                                 .hair = 60,
                                                 .springs = R"({"boneGroups":[{"bones":[21]}]})"})),
                   problems);
  motion::offline::MotionOptions options;
  options.give_to_other = [&](Skeleton& skeleton, auto& clips) {
    return figure.take(skeleton, clips, 1);
  };

  const MotionGraph graph = motion::offline::compile_motion(shipped_clips(), options, problems);
  const SkinnedMesh mesh = figure.among_others(graph.skeleton, 1);

  const std::size_t own = mesh.figure_end.size() - 1;
  const std::span<const ClothNode> nodes = of_figure(mesh.cloth.node, own);
  EXPECT_EQ(nodes.size(),
            std::min(character::most_bones_of_a_guide, most_joints - joints_of(mesh)));
  EXPECT_LE(matrices_of(mesh), most_joints);
  EXPECT_TRUE(
      std::ranges::all_of(nodes, [](const ClothNode& n) { return n.kind == ClothKind::Bone; }));
  std::size_t swinging = 0;
  for (const SkinnedVertex& v : mesh.vertices)
    if (v.material == Material::Own) swinging += v.joint[0] >= joints_of(mesh) ? 1 : 0;
  EXPECT_GT(swinging, 100U);
  EXPECT_TRUE(std::ranges::any_of(problems, [](const Diagnostic& d) {
    return d.message.find("bones that swing") != std::string::npos;
  }));
}

TEST(OwnFigure, ThatIsNobodyIsRefusedByName) {
  const test::TemporaryFolder folder;
  std::vector<Diagnostic> problems;
  const std::filesystem::path file = write(folder, "glTF");

  try {
    const OwnFigure figure(file, problems);
    FAIL() << "it was taken";
  } catch (const content::ContentError& error) {
    EXPECT_EQ(error.file, file.string());
    EXPECT_EQ(error.code, "unreadable-model");
  }
}

TEST(OwnFigure, IsDrawnFromAllSidesAndWalking) {
  const test::TemporaryFolder folder;

  const Pixels sheet =
      draw_own_figure(character::read_character(write(folder, test::make_glb({}))));

  EXPECT_EQ(sheet.width, 1600U);
  EXPECT_EQ(sheet.height, 1240U);
  std::size_t blue = 0;  // as the made character is
  for (std::size_t i = 0; i < sheet.rgba.size(); i += 4)
    blue += sheet.rgba[i + 2] > sheet.rgba[i] ? 1 : 0;
  EXPECT_GT(blue, 50'000U);
}

}  // namespace
}  // namespace docent::compile::own_figure_test
