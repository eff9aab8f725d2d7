#include "runtime/kiosk/options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/run_program.h"

namespace docent::kiosk::options_test {
namespace {

using test::ProgramRun;
using test::run_program;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

/// Runs what a command line asks for; its exit code, or nothing where it is wrong.
std::optional<int> run(Options& options, std::vector<const char*> words) {
  const auto asked = terminal::parse(program(options, [] { return 42; }), words);
  return asked ? std::optional((*asked)()) : std::nullopt;
}

TEST(Options, HoldWhatTheCommandLineSays) {
  Options options;

  EXPECT_EQ(run(options, {"--content", "a.db", "--display", "headless", "--size", "640x480",
                          "--rotate", "90", "--seconds", "2.5", "--hid", "a", "--hid", "b"}),
            42);
  EXPECT_EQ(options.content, "a.db");
  EXPECT_EQ(options.display, config::DisplayKind::Headless);
  EXPECT_EQ(options.size->width, 640U);
  EXPECT_EQ(static_cast<int>(*options.rotation), 1);
  EXPECT_EQ(options.seconds, 2.5);
  EXPECT_THAT(options.hid, ElementsAre("a", "b"));
  EXPECT_FALSE(options.config.has_value());
}

TEST(Options, KnowEveryDisplayByItsName) {
  for (const auto& [name, kind] : config::display_kinds) {
    Options options;
    EXPECT_EQ(run(options, {"--display", name.data()}), 42);
    EXPECT_EQ(options.display, kind);
  }
}

TEST(Options, OfNonsenseAreRefused) {
  for (const auto& [name, value] : {std::pair{"--seconds", "nan"},
                                    {"--seconds", "-1"},
                                    {"--size", "10x10"},
                                    {"--size", "640"},
                                    {"--rotate", "45"},
                                    {"--display", "wayland"}}) {
    Options options;
    EXPECT_EQ(run(options, {name, value}), std::nullopt) << name << ' ' << value;
  }
}

TEST(Help, TellsDefaultPathsSignalsAndExitCodes) {
  const ProgramRun help = run_program("docent", "--help");

  EXPECT_EQ(help.exit_code, 0);
  EXPECT_THAT(help.out,
              AllOf(HasSubstr("/etc/docent/kiosk.toml\n"), HasSubstr("/var/lib/docent/museum.db"),
                    HasSubstr("SIGTERM, SIGINT"), HasSubstr("SIGHUP"), HasSubstr("exit codes:")));
  EXPECT_EQ(run_program("docent", "--version").out,
            "docent " + std::string(terminal::version()) + "\n");
}

TEST(CommandLine, ThatIsWrongIsToldWithWhatWasMeant) {
  const ProgramRun option = run_program("docent", "--contnet a.db");
  EXPECT_EQ(option.exit_code, 2);
  EXPECT_THAT(option.err, HasSubstr("did you mean '--content'?"));

  const ProgramRun hid = run_program("docent", "hid lsit");
  EXPECT_EQ(hid.exit_code, 2);
  EXPECT_THAT(hid.err, HasSubstr("did you mean 'list'?"));
  EXPECT_EQ(run_program("docent", "hid list twice").exit_code, 2);
  EXPECT_EQ(run_program("docent", "hid decode --help").exit_code, 0);
}

}  // namespace
}  // namespace docent::kiosk::options_test
