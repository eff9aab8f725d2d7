#include "runtime/kiosk/control_list.h"

#include <span>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/kiosk_run.h"

namespace docent::kiosk::control_list_test {
namespace {

using testing::HasSubstr;

TEST(ControlList, IsJsonWhateverALabelSays) {
  const std::vector<interface::OnGlass> items{{.name = "home",
                                               .role = "button",
                                               .label = "a \"b\"\n",
                                               .state = "normal",
                                               .rect = {0.25F, 0.5F, 0.125F, 0.0625F},
                                               .text_mm = 7,
                                               .spoken = "a",
                                               .has_focus = true}};

  EXPECT_EQ(to_json(items),
            "[\n {\"name\": \"home\", \"role\": \"button\", \"label\": \"a \\\"b\\\"\\u000a\", "
            "\"state\": \"normal\", \"rect\": [0.25000, 0.50000, 0.12500, 0.06250], "
            "\"text_mm\": 7.00, \"spoken\": \"a\", \"focus\": true}\n]\n");
  EXPECT_EQ(to_json(std::span<const interface::OnGlass>{}), "[\n]\n");
}

TEST(ControlList, IsWrittenInAVisit) {
  const test::VisitRun run("1 key ENTER\n2.5 key DOWN\n3 controls on.json\n3.1 quit\n");
  const std::filesystem::path here = std::filesystem::current_path();
  std::filesystem::current_path(run.file("a.visit").parent_path());
  const test::ProgramRun played = run.play();
  std::filesystem::current_path(here);
  ASSERT_EQ(played.exit_code, 0) << played.err;

  const std::string json = test::text_of(run.file("on.json"));

  EXPECT_THAT(json, HasSubstr(R"("name": "exhibit:boundary-stone", "role": "spot")"));
  EXPECT_THAT(json, HasSubstr(R"("role": "text", "label": "Garden Court")"));
  EXPECT_THAT(json, HasSubstr(R"("spoken": "Step-free. button.")"));
  EXPECT_THAT(json, HasSubstr(R"("focus": true)"));
}

}  // namespace
}  // namespace docent::kiosk::control_list_test
