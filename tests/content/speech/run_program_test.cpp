#include "content/speech/run_program.h"

#include <gtest/gtest.h>

#include <sys/personality.h>

#include <cstdlib>
#include <string>
#include <vector>

namespace docent::speech::run_program_test {
namespace {

using namespace std::chrono_literals;
using Kind = Outcome::Kind;

TEST(RunProgram, GivesTheInputAndTakesTheOutput) {
  const std::string text(1'000'000, 'x');
  const Outcome outcome = run_program({"cat"}, text, 20s);
  EXPECT_EQ(outcome.kind, Kind::Ended);
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.output, text);
}

TEST(RunProgram, HandsArgumentsOverAsTheyAre) {  // no shell reads them
  EXPECT_EQ(run_program({"echo", "$HOME; `ls` *", "\"two\""}, {}, 20s).output,
            "$HOME; `ls` * \"two\"\n");
}

TEST(RunProgram, TellsStatusAndComplaints) {
  const Outcome outcome = run_program({"sh", "-c", "echo no >&2; exit 7"}, {}, 20s);
  EXPECT_EQ(outcome.status, 7);
  EXPECT_EQ(outcome.errors, "no\n");
  EXPECT_EQ(run_program({"sh", "-c", "kill -9 $$"}, {}, 20s).status, 137);
}

TEST(RunProgram, LaysProgramsWhereTheyLayAndItselfWhereItLies) {
  if (run_program({"setarch", "-R", "true"}, {}, 20s).status != 0)
    GTEST_SKIP() << "this system lets no program choose where it lies";
  const std::vector<std::string> look{"sh", "-c", "cut -d' ' -f1 /proc/self/maps | head -n 1"};
  const std::string first = run_program(look, {}, 20s).output;
  for (int i = 0; i < 8; ++i) EXPECT_EQ(run_program(look, {}, 20s).output, first);
  EXPECT_EQ(::personality(0xffffffff) & ADDR_NO_RANDOMIZE, 0) << "of this program nothing changes";
}

std::string home_of_this_program() {
  const char* const home = std::getenv("HOME");
  return home == nullptr ? "" : home;
}

TEST(RunProgram, LetsAProgramLookForItsLibrariesInOurFolderFirst) {
  const auto said = [](const std::string& libraries) {
    return run_program({"sh", "-c", "echo \"$LD_LIBRARY_PATH $HOME\""}, {}, 20s, most_output,
                       libraries)
        .output;
  };
  const char* const path = std::getenv("LD_LIBRARY_PATH");
  const std::string before = path == nullptr ? "" : path, home = home_of_this_program();
  setenv("LD_LIBRARY_PATH", "/theirs", 1);
  EXPECT_EQ(said("/ours"), "/ours:/theirs " + home + "\n");
  EXPECT_EQ(said({}), "/theirs " + home + "\n");
  unsetenv("LD_LIBRARY_PATH");
  EXPECT_EQ(said("/ours"), "/ours " + home + "\n");
  if (path != nullptr) setenv("LD_LIBRARY_PATH", before.c_str(), 1);
}

TEST(RunProgram, TellsThatAProgramIsMissing) {
  EXPECT_EQ(run_program({"no-such-program-of-docent"}, "text", 20s).kind, Kind::Missing);
}

TEST(RunProgram, EndsWhatTakesTooLongOrSaysTooMuch) {
  EXPECT_EQ(run_program({"sleep", "1000"}, {}, 50ms).kind, Kind::TooSlow);
  EXPECT_EQ(run_program({"sh", "-c", "exec >&- 2>&-; exec sleep 1000"}, {}, 50ms).kind,
            Kind::TooSlow);
  EXPECT_EQ(run_program({"yes"}, {}, 20s, 100'000).kind, Kind::TooMuch);
}

}  // namespace
}  // namespace docent::speech::run_program_test
