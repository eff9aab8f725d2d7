#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

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

TEST(ASharedGlass, LooksAsItWasSeenAndApproved) {
  const VisitRun run(
      "0.5 shot quiet.png\n"
      "1 tap 0.06 0.9\n1 tap 0.2 0.9\n1 tap 0.44 0.9\n1 tap 0.56 0.9\n1 tap 0.7 0.9\n"
      "1 tap 0.82 0.9\n1 tap 0.94 0.9\n"
      "2 tap @look:rose seat 1\n2 tap @language:zh seat 2\n2 tap @look:sky seat 2\n"
      "2 tap @look:teal seat 4\n2 tap @look:plum seat 5\n2 tap @language:ar seat 6\n"
      "2 tap @look:saffron seat 6\n2 tap @look:vermilion seat 8\n"
      "5 tap @exhibit:tripod-ding seat 1\n5 tap @exhibit:glass-flask seat 2\n"
      "5 tap @exhibit:clay-letter seat 4\n5 tap @exhibit:jade-disc seat 5\n"
      "5 tap @exhibit:painted-jar seat 6\n5 tap @exhibit:boundary-stone seat 8\n"
      "8 tap @route:offset seat 5\n8 tap @route:skeleton seat 4\n"
      "19 shot visitors.png\n20 quit\n");
  std::ofstream(run.file("kiosk.toml")) << "screen_inches = 55\n";
  const std::filesystem::path here = std::filesystem::current_path();
  std::filesystem::current_path(run.file("a.visit").parent_path());
  const ProgramRun played = run.play("--config kiosk.toml", "1280x720");
  std::filesystem::current_path(here);
  ASSERT_EQ(played.exit_code, 0) << played.err;

  for (const char* name : {"quiet.png", "visitors.png"}) expect_approved(run.file(name), name);
}

}  // namespace
}  // namespace docent::test
