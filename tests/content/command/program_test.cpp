// What docent-content says of itself, and of command lines that it does not understand.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "content/command/commands.h"
#include "tests/support/run_program.h"
#include "tests/support/terminal_run.h"

namespace docent::command::program_test {
namespace {

using test::ProgramRun;
using test::run_program;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

TEST(Program, TellsItsVersion) {
  const ProgramRun run = run_program("docent-content", "--version");

  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.out, "docent-content " + std::string(terminal::version()) + "\n");
}

TEST(Program, TellsItsCommandsAndTheirOptionsAsPlainText) {
  const std::string all = run_program("docent-content", "--help").out;
  for (const terminal::Command& command : program().commands) {
    EXPECT_THAT(all, HasSubstr("\n  " + std::string(command.name) + " "));
    const ProgramRun help = run_program("docent-content", std::string(command.name) + " --help");
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_EQ(help.out.find('\0'), std::string::npos) << command.name;
    EXPECT_THAT(help.out, HasSubstr("usage: docent-content " + std::string(command.name)));
  }
}

TEST(Program, SaysWhatWasProbablyMeant) {
  const ProgramRun command = run_program("docent-content", "compil museum -o museum.db");
  EXPECT_EQ(command.exit_code, 2);
  EXPECT_THAT(command.err, AllOf(HasSubstr("compil: error[unknown-command]"),
                                 HasSubstr("did you mean 'compile'?")));

  const ProgramRun option = run_program("docent-content", "check museum --quite");
  EXPECT_EQ(option.exit_code, 2);
  EXPECT_THAT(option.err, HasSubstr("did you mean '--quiet'?"));
}

TEST(Program, SaysWhichArgumentIsOneTooMany) {
  const ProgramRun run = run_program("docent-content", "info museum.db /tmp");

  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, HasSubstr("/tmp: error[extra-argument]: docent-content info does not expect "
                                 "this argument\n"));
}

TEST(Program, RefusesNumbersThatAreNoneWithASentenceOfOneLine) {
  for (const char* line :
       {"compile a -o b --radius nan", "compile a -o b --jobs 0", "compile a -o b --jobs 1.5",
        "near a.db --from 1,1 --speed inf", "near a.db --from nan,1", "offset a.db --distance nan",
        "route a.db --kind shortest --from 1,1 --to 2,2 --radius nan",
        "walk a.db --path p.csv -o w.bvh --start 0,0,nan"}) {
    const ProgramRun run = run_program("docent-content", line);
    EXPECT_EQ(run.exit_code, 2) << line;
    EXPECT_THAT(run.err, HasSubstr("error[bad-value]: '")) << line;
    EXPECT_EQ(std::ranges::count(run.err, '\n'), 1) << run.err;
  }
}

TEST(Program, SaysWhatIsWrongAsJsonWhereThatIsAskedFor) {
  const ProgramRun run = run_program("docent-content", "info museum.db --json --flor x");

  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, AllOf(testing::StartsWith("{\"file\":\"--flor\""),
                             HasSubstr("\"code\":\"unknown-option\"")));
}

TEST(Program, IsColouredOnATerminalUnlessThatIsNotWanted) {
  EXPECT_THAT(test::shown_on_a_terminal("docent-content", {"frobnicate"}), HasSubstr("\x1b[1;31m"));
  EXPECT_THAT(test::shown_on_a_terminal("docent-content", {"frobnicate"}, "1"),
              AllOf(HasSubstr("error[unknown-command]"), Not(HasSubstr("\x1b["))));
  EXPECT_THAT(run_program("docent-content", "frobnicate").err, Not(HasSubstr("\x1b[")));
}

}  // namespace
}  // namespace docent::command::program_test
