// deploy/completions offers what the tables hold.

#include "tests/deploy/completions.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "content/command/commands.h"
#include "runtime/kiosk/options.h"
#include "runtime/update/options.h"
#include "tests/deploy/made_file.h"
#include "tests/support/run_program.h"

namespace docent::test::completions_test {
namespace {

using testing::HasSubstr;
using testing::Not;

std::filesystem::path completion(const char* file) {
  return source_dir() / "deploy/completions" / file;
}

TEST(Completions, SayWhatTheTablesSay) {
  kiosk::Options options;
  const terminal::Command docent = kiosk::program(options, [] { return 0; });

  expect_made(completion("docent.bash"), bash_completion(docent));
  expect_made(completion("docent-content.bash"), bash_completion(command::program()));
  update::Options update_options;
  const terminal::Command update = update::program(update_options, [] { return 0; });
  expect_made(completion("docent-update.bash"), bash_completion(update));
  expect_made(completion("_docent-update"), zsh_completion(update));
  expect_made(completion("_docent"), zsh_completion(docent));
  expect_made(completion("_docent-content"), zsh_completion(command::program()));
}

/// What bash offers after some words, with a blank between.
std::string offered(const std::string& program, const std::string& function,
                    const std::string& words) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "offered").string();
  const std::string script = fmt::format(
      "compopt() {{ :; }}; . '{}'; COMP_WORDS=({} {}); "
      "COMP_CWORD=$((${{#COMP_WORDS[@]}} - 1)); {}; echo \"${{COMPREPLY[@]}}\"",
      completion((program + ".bash").c_str()).string(), program, words, function);
  std::ofstream(folder.path() / "script") << script;
  const std::string command =
      fmt::format("bash '{}' >'{}' 2>&1", (folder.path() / "script").string(), out);
  EXPECT_EQ(std::system(command.c_str()), 0);  // NOLINT(bugprone-command-processor)
  return text_of(out);
}

TEST(Completions, OfBashOfferCommandsOptionsAndValues) {
  const auto content = [](const std::string& words) {
    return offered("docent-content", "_docent_content", words);
  };
  const auto docent = [](const std::string& words) { return offered("docent", "_docent", words); };

  EXPECT_EQ(content("com"), "compile\n");
  EXPECT_EQ(content("route a.db --kind s"), "shortest skeleton\n");
  EXPECT_THAT(content("compile --j"), HasSubstr("--jobs --json"));
  EXPECT_THAT(content("compile --"), Not(HasSubstr("--kind")));
  EXPECT_EQ(docent("hid ''"), "list decode\n");
  EXPECT_EQ(docent("--rotate 9"), "90\n");
}

TEST(Completions, OfZshAreUnderstoodByIt) {
  if (std::system("command -v zsh >/dev/null") != 0)  // NOLINT(bugprone-command-processor)
    GTEST_SKIP() << "zsh is not installed";
  for (const char* file : {"_docent", "_docent-content"}) {
    const std::string command = fmt::format("zsh -n '{}'", completion(file).string());
    EXPECT_EQ(std::system(command.c_str()), 0) << file;  // NOLINT(bugprone-command-processor)
  }
}

}  // namespace
}  // namespace docent::test::completions_test
