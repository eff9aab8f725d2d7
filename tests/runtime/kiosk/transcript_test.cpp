#include "runtime/kiosk/transcript.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/kiosk_run.h"

namespace docent::kiosk {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(Transcript, IsCsvWhateverIsSaid) {
  const interface::Utterance said{.language = "de",
                                  .pieces = {{.text = "ein \"Pferd\", bronzen", .pause = true}}};

  EXPECT_EQ(transcript_line(1.5, {.utterance = &said, .control = "exhibit:horse"}),
            "1.500,exhibit:horse,de,\"ein \"\"Pferd\"\", bronzen.\"\n");
  EXPECT_EQ(transcript_line(1.5, {}), "");
}

TEST(Transcript, IsWrittenOfAVisitWithHeadphonesAndAFrameAllocatesNothing) {
  const test::VisitRun run(
      "1 headphones in\n3 key ENTER\n5 key DOWN\n6 key VOLUME_UP\n7 key ENTER\n"
      "9 key HELP\n40 headphones out\n42 quit\n");

  const test::ProgramRun played = run.play("--speech '" + run.file("said.csv").string() +
                                           "' --stats '" + run.file("stats.json").string() + "'");

  ASSERT_EQ(played.exit_code, 0) << played.err;
  const std::string said = test::text_of(run.file("said.csv"));
  EXPECT_THAT(said, StartsWith(transcript_heading));
  EXPECT_THAT(said, HasSubstr(",en,What would you like to see?"));
  EXPECT_THAT(said, HasSubstr(",en,Volume 6."));
  EXPECT_THAT(said, HasSubstr("Follow me to. Mosaic of Fishes."));
  EXPECT_THAT(said, HasSubstr(",en,Reading aloud is off."));
  EXPECT_EQ(test::number_in(test::text_of(run.file("stats.json")), "allocations_in_frames"), 0);
}

TEST(Transcript, IsEmptyWhereNobodyWantsToHear) {
  const test::VisitRun run("1 key ENTER\n2 key DOWN\n3 quit\n");

  const test::ProgramRun played = run.play("--speech '" + run.file("said.csv").string() + "'");

  ASSERT_EQ(played.exit_code, 0) << played.err;
  EXPECT_EQ(test::text_of(run.file("said.csv")), transcript_heading);
}

TEST(Transcript, IsOfAVisitorWhoTouchesSpeak) {
  const test::VisitRun run("1 tap @speak\n3 quit\n");

  const test::ProgramRun played = run.play("--speech '" + run.file("said.csv").string() + "'");

  ASSERT_EQ(played.exit_code, 0) << played.err;
  EXPECT_THAT(test::text_of(run.file("said.csv")), HasSubstr("Press the Enter key"));
}

}  // namespace
}  // namespace docent::kiosk
