#include "runtime/kiosk/transcript.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/kiosk_run.h"

namespace docent::kiosk::transcript_test {
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
      "1 headphones in\n3 key ENTER\n5 key DOWN\n5.5 key DOWN\n6 key VOLUME_UP\n7 key ENTER\n"
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

TEST(Transcript, HasASoundInBracketsWhereAVisitorListensToIt) {
  Museum museum;
  museum.languages.emplace_back().tag = "en";
  museum.exhibits.resize(1);
  museum.sounds = {{.exhibit = 0, .title = {{"en", "A lute"}}, .description = {}},
                   {.exhibit = 0, .title = {{"en", "The bell, struck"}}, .description = {}}};

  EXPECT_EQ(transcript_line(2, {.sound = 1}, museum, 0),
            "2.000,sound:2,en,\"[The bell, struck]\"\n");
}

TEST(Transcript, IsOfAVisitorWhoLeafsThroughPicturesAndReadsMoreByKeysAlone) {
  const test::VisitRun run(
      "0.5 tap @exhibit:owl-vessel\n60 headphones in\n61 key DOWN\n62 key ENTER\n66 key ENTER\n"
      "70 tap @more\n75 key HELP\n80 tap @less\n82 quit\n");

  const test::ProgramRun played = run.play("--speech '" + run.file("said.csv").string() +
                                           "' --stats '" + run.file("stats.json").string() + "'");

  ASSERT_EQ(played.exit_code, 0) << played.err;
  const std::string said = test::text_of(run.file("said.csv"));
  std::size_t at = 0;
  for (const char* next :
       {"picture:next,en,Next picture. button.", "Picture 2 of 4. The head lifts off",
        "Picture 3 of 4. Each wing is a coiled snake.", "Owl Wine Vessel. The owl was cast",
        "The guide has arrived.", "Owl Wine Vessel. Picture 1 of 4."}) {
    const std::size_t found = said.find(next, at);
    ASSERT_NE(found, std::string::npos) << next << " in\n" << said;
    at = found;
  }
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
}  // namespace docent::kiosk::transcript_test
