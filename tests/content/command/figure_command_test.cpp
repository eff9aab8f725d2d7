#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "platform/image/image.h"
#include "tests/content/character/made_character.h"
#include "tests/support/run_program.h"

namespace docent::command::figure_command_test {
namespace {

using ::testing::HasSubstr;

TEST(TheFigureCommand, SaysWhatACharacterWouldBeAndDrawsIt) {
  const test::TemporaryFolder folder;
  const std::string model = (folder.path() / "figure.vrm").string();
  const std::string sheet = (folder.path() / "sheet.png").string();
  std::ofstream(model, std::ios::binary) << test::make_glb({.is_vrm1 = true});

  const test::ProgramRun run =
      test::run_program("docent-content", "figure " + model + " -o " + sheet + " --json");

  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto facts = nlohmann::json::parse(run.out);
  EXPECT_EQ(facts["triangles_in"], 252);
  EXPECT_EQ(facts["triangles"], 252);
  EXPECT_EQ(facts["joints"], 21);
  EXPECT_NEAR(facts["height"].get<double>(), 1.7, 1e-3);
  EXPECT_EQ(facts["rest_pose"], "T");
  EXPECT_EQ(facts["bones"]["leftUpperArm"], "mixamorig:LeftArm");
  EXPECT_EQ(facts["springs"], 1);
  EXPECT_EQ(facts["expressions"], nlohmann::json::array({"blink", "happy"}));
  const std::string png = test::text_of(sheet);
  const Result<Pixels> size = image::read_image_size(std::as_bytes(std::span(png)));
  ASSERT_TRUE(size);
  EXPECT_EQ(size->width, 1600U);
}

TEST(TheFigureCommand, NamesWhatIsWrongWithAFile) {
  const test::TemporaryFolder folder;
  const std::string model = (folder.path() / "figure.glb").string();
  const std::string glb = test::make_glb({});
  std::ofstream(model, std::ios::binary) << glb.substr(0, glb.size() - 100);

  const test::ProgramRun run = test::run_program("docent-content", "figure " + model);

  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr("figure.glb"));
  EXPECT_THAT(run.err, HasSubstr("cut short"));
}

}  // namespace
}  // namespace docent::command::figure_command_test
