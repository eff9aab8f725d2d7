#include <gmock/gmock.h>

#include <csignal>

#include "tests/support/kiosk_run.h"
#include "tests/support/started_program.h"

namespace docent::test::status_command_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// A kiosk without a screen that anybody of this test may ask.
class ARunningKiosk : public testing::Test {
 protected:
  void SetUp() override {
    unsetenv("RUNTIME_DIRECTORY");
    setenv("XDG_RUNTIME_DIR", folder_.path().c_str(), 1);
  }
  void TearDown() override { unsetenv("XDG_RUNTIME_DIR"); }

  void start() {
    kiosk_.emplace(program("docent"),
                   std::vector<std::string>{"--content", sample_database(), "--display", "headless",
                                            "--size", "64x64", "--seconds", "100000"},
                   folder_.path() / "said");
  }
  /// Asks until frames are made.
  std::string status() {
    ProgramRun asked;
    EXPECT_TRUE(kiosk_->runs_until([&] {
      asked = run_program("docent", "status --json");
      return number_in(asked.out, "frames") > 0;
    })) << text_of(folder_.path() / "said");
    EXPECT_EQ(asked.exit_code, 0) << asked.err;
    return asked.out;
  }

  TemporaryFolder folder_;
  std::optional<StartedProgram> kiosk_;
};

TEST_F(ARunningKiosk, SaysHowItIs) {
  start();
  const std::string json = status();
  const ProgramRun text = run_program("docent", "status");

  EXPECT_THAT(json, AllOf(HasSubstr("\"display\": \"memory, 64 x 64 pixels\""),
                          HasSubstr("\"path\": \"" + sample_database().string() + '"'),
                          HasSubstr("\"museum\": \"Museum of the Three Rivers\""),
                          HasSubstr("\"schema\": "), HasSubstr("\"signature\": \"none\""),
                          HasSubstr("\"last_error\": null")));
  EXPECT_THAT(json, testing::ContainsRegex("\"checksum\": \"[0-9a-f]{64}\""));
  EXPECT_GT(number_in(json, "uptime_s"), 0);
  EXPECT_GT(number_in(json, "free_bytes"), 0);
  EXPECT_EQ(text.exit_code, 0) << text.err;
  EXPECT_THAT(text.out, HasSubstr("shows 'Museum of the Three Rivers', from "));
}

TEST_F(ARunningKiosk, TellsWhyADatabaseWasRefused) {
  const std::filesystem::path database = folder_.path() / "museum.db";
  std::filesystem::copy(sample_database(), database);
  kiosk_.emplace(program("docent"),
                 std::vector<std::string>{"--content", database, "--display", "headless", "--size",
                                          "64x64", "--seconds", "100000"},
                 folder_.path() / "said");
  status();

  std::filesystem::resize_file(database, 100'000);
  kiosk_->signal(SIGHUP);

  EXPECT_TRUE(kiosk_->runs_until(
      [&] { return status().find("museum.db: is cut short") != std::string::npos; }));
}

TEST_F(ARunningKiosk, ThatIsNotThereIsASentence) {
  const ProgramRun asked = run_program("docent", "status --json");

  EXPECT_EQ(asked.exit_code, 1);
  EXPECT_EQ(asked.out, "");
  EXPECT_THAT(asked.err, HasSubstr("docent: no kiosk runs here"));
}

}  // namespace
}  // namespace docent::test::status_command_test
