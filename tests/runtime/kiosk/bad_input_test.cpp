#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>

#include "tests/support/kiosk_run.h"
#include "tests/support/started_program.h"

namespace docent::test::bad_input_test {
namespace {

using testing::HasSubstr;

class ADatabase : public testing::Test {
 protected:
  /// Runs the kiosk on the sample museum's bytes after a change to them.
  template <typename Change>
  ProgramRun run_changed(Change change) {
    std::string bytes = text_of(sample_database());
    change(bytes);
    const std::filesystem::path file = folder_.path() / "changed.db";
    std::ofstream(file, std::ios::binary) << bytes;
    return run_program(
        "docent", "--display headless --size 64x64 --seconds 1 --content '" + file.string() + "'");
  }

  TemporaryFolder folder_;
};

TEST_F(ADatabase, WithAFlippedByteIsRefusedWithOneSentence) {
  const ProgramRun run = run_changed([](std::string& bytes) { bytes[bytes.size() / 3] ^= 0x10; });

  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr("changed.db"));
}

TEST_F(ADatabase, OfAnotherVersionAsksForRecompiledContent) {
  constexpr std::size_t user_version =
      63;  // SQLite's file format, section 1.3: bytes 60 to 63, big-endian
  const ProgramRun run = run_changed([](std::string& bytes) { bytes[user_version] = 99; });

  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr("ompile"));
}

TEST_F(ADatabase, CanBeCheckedBeforeItIsTakenUp) {
  const ProgramRun good = run_program("docent", "check '" + sample_database().string() + "'");
  EXPECT_EQ(good.exit_code, 0) << good.err;
  EXPECT_THAT(good.out, HasSubstr("can be shown: '"));

  const std::filesystem::path broken = folder_.path() / "broken.db";
  std::ofstream(broken, std::ios::binary) << text_of(sample_database()).substr(0, 100'000);
  const ProgramRun bad = run_program("docent", "check '" + broken.string() + "'");
  EXPECT_EQ(bad.exit_code, 1);
  EXPECT_EQ(bad.out, "");
  EXPECT_THAT(bad.err, HasSubstr("broken.db: is cut short"));
}

TEST_F(ADatabase, ThatIsAPipeIsRefusedAndNotWaitedFor) {
  const std::filesystem::path pipe = folder_.path() / "pipe.db";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);

  const ProgramRun run =
      run_program("docent", "--display headless --content '" + pipe.string() + "'");

  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr("pipe.db: is a pipe"));
}

TEST_F(ADatabase, ThatIsNotSignedIsRefusedWhereAKeyIsConfigured) {
  const auto file = [&](const char* name) { return (folder_.path() / name).string(); };
  std::filesystem::copy_file(sample_database(), file("museum.db"));
  ASSERT_EQ(run_program("docent-content", "keygen -o " + file("museum")).exit_code, 0);
  std::ofstream(file("kiosk.toml")) << "keys = [\"museum.pub\"]\n";
  const std::string show = "--display headless --size 64x64 --seconds 0.1 --config " +
                           file("kiosk.toml") + " --content " + file("museum.db");
  const std::string check = "check " + file("museum.db") + " --config " + file("kiosk.toml");

  for (const std::string& run : {show, check}) {
    const ProgramRun refused = run_program("docent", run);
    EXPECT_EQ(refused.exit_code, 1) << run;
    EXPECT_THAT(refused.err, HasSubstr("museum.db: is not signed; ")) << run;
  }
  ASSERT_EQ(
      run_program("docent-content", "sign " + file("museum.db") + " --key " + file("museum.key"))
          .exit_code,
      0);
  EXPECT_EQ(run_program("docent", show).exit_code, 0);
  EXPECT_EQ(run_program("docent", check).exit_code, 0);
  std::filesystem::remove(file("museum.pub"));
  const ProgramRun keyless = run_program("docent", show);
  EXPECT_EQ(keyless.exit_code, 3);
  EXPECT_THAT(keyless.err, HasSubstr("museum.pub: there is no such file"));
}

TEST_F(ADatabase, WithoutTheKioskThatThisOneIsSaidToBeIsRefused) {
  std::ofstream(folder_.path() / "kiosk.toml") << "kiosk = \"cafe\"\n";

  const ProgramRun run =
      run_program("docent", "check '" + sample_database().string() + "' --config '" +
                                (folder_.path() / "kiosk.toml").string() + "'");

  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr("has no kiosk 'cafe', which kiosk.toml says that this one is"));
}

TEST(ADisplay, ThatCannotBeOpenedIsAnEnvironmentFault) {
  const std::string content = "--content '" + sample_database().string() + "' --seconds 1 ";
  const ProgramRun window = run_program("docent", content + "--display window </dev/null");
  const bool has_desktop = std::getenv("DISPLAY") != nullptr;
  if (!has_desktop) {
    EXPECT_EQ(window.exit_code, 3);
    EXPECT_THAT(window.err, HasSubstr("X server"));
  }
  if (!std::filesystem::exists("/dev/dri")) {
    const ProgramRun kms = run_program("docent", content + "--display kms");
    EXPECT_EQ(kms.exit_code, 3);
    EXPECT_THAT(kms.err, HasSubstr("/dev/dri"));
  }
  if (has_desktop && std::filesystem::exists("/dev/dri"))
    GTEST_SKIP() << "this machine can open every display";
}

TEST(AFolder, InPlaceOfAFileIsAFaultWithASentence) {
  const TemporaryFolder folder;
  const std::string name = "'" + folder.path().string() + "'";
  const std::string content = "--content '" + sample_database().string() + "' --display headless ";

  const ProgramRun config = run_program("docent", content + "--config " + name);
  EXPECT_EQ(config.exit_code, 1);
  EXPECT_THAT(config.err, HasSubstr("is a folder; name a file"));

  const ProgramRun visit = run_program("docent", content + "--visit " + name);
  EXPECT_EQ(visit.exit_code, 1);
  EXPECT_THAT(visit.err, HasSubstr("is a folder; name a file"));

  const ProgramRun recording = run_program("docent", "hid decode " + name);
  EXPECT_EQ(recording.exit_code, 1);
  EXPECT_THAT(recording.err, HasSubstr("is a folder; name a file"));

  const ProgramRun database = run_program("docent", "--display headless --content " + name);
  EXPECT_EQ(database.exit_code, 1);
  EXPECT_THAT(database.err, HasSubstr("is a folder"));
}

// The console hangs up as soon as another program takes it, which may be while this one still reads
// its settings: here out of a pipe, so that the test knows when that is.
TEST(AHangUp, WhileTheSettingsAreReadDoesNotEndTheProgram) {
  const TemporaryFolder folder;
  const std::string pipe = (folder.path() / "kiosk.toml").string();
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  StartedProgram run(program("docent"),
                     {"--content", sample_database().string(), "--display", "headless", "--size",
                      "64x64", "--seconds", "0.1", "--config", pipe});

  const int settings = open(pipe.c_str(), O_WRONLY | O_CLOEXEC);  // waits until it is being read
  ASSERT_GE(settings, 0);
  run.signal(SIGHUP);
  close(settings);

  EXPECT_EQ(run.wait(), 0);
}

TEST(HidCommands, SayWhatIsWrongWithARecording) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "empty.hid") << "nothing\n";

  const ProgramRun decoded =
      run_program("docent", "hid decode '" + (folder.path() / "empty.hid").string() + "'");
  EXPECT_EQ(decoded.exit_code, 1);
  EXPECT_THAT(decoded.err, HasSubstr("empty.hid"));
  EXPECT_EQ(run_program("docent", "hid decode /nonexistent.hid").exit_code, 3);
  EXPECT_EQ(run_program("docent", "hid dance").exit_code, 2);
  EXPECT_EQ(run_program("docent", "hid list").exit_code, 0);
}

TEST(HidCommands, AgreeWithTheKernelOnRecordedScreens) {
  NEEDS_REFERENCE_DATA("acceptance/hid_check.py");
  const std::string check = (reference_data() / "acceptance/hid_check.py").string();
  const std::string screens = (reference_data() / "hid/mt").string();

  const std::string command =
      "python3 '" + check + "' '" + program("docent").string() + "' '" + screens + "'";
  EXPECT_EQ(std::system(command.c_str()), 0);  // NOLINT(bugprone-command-processor)
}

}  // namespace
}  // namespace docent::test::bad_input_test
