#include <gtest/gtest.h>

#include "tests/golden/pictures.h"
#include "tests/support/kiosk_run.h"

namespace docent::test {
namespace {

TEST(TheKiosk, LooksAsItWasSeenAndApproved) {
  const VisitRun run("0.5 shot " + std::string("welcome.png") +
                     "\n1 key ENTER\n2.5 shot choosing.png\n3 tap @exhibit:tripod-ding\n"
                     "12 shot walking.png\n45 shot arrived.png\n46 tap @language:ar\n"
                     "47.5 shot arabic.png\n48 quit\n");
  const std::filesystem::path here = std::filesystem::current_path();
  std::filesystem::current_path(run.file("a.visit").parent_path());
  const ProgramRun played = run.play("", "960x540");
  std::filesystem::current_path(here);
  ASSERT_EQ(played.exit_code, 0) << played.err;

  for (const char* name :
       {"welcome.png", "choosing.png", "walking.png", "arrived.png", "arabic.png"})
    expect_approved(run.file(name), name);
}

}  // namespace
}  // namespace docent::test
