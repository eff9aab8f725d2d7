// The pages of deploy/man say what the tables say: options, fields, columns, commands of visits.

#include "tests/deploy/manual.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "content/command/commands.h"
#include "runtime/kiosk/options.h"
#include "runtime/schema/schema.h"
#include "runtime/update/options.h"
#include "tests/deploy/catalog.h"
#include "tests/deploy/made_file.h"
#include "tests/support/run_program.h"

namespace docent::test::manual_test {
namespace {

using testing::HasSubstr;

constexpr const char* pages[] = {"docent.1",         "docent-content.1", "docent-update.1",
                                 "docent-visit.5",   "kiosk.toml.5",     "museum.toml.5",
                                 "docent-database.5"};

std::filesystem::path page_file(const char* page) {
  return source_dir() / "deploy/man" / page;
}

std::string_view program_of(std::string_view page) {
  return page.substr(0, page.find('.'));
}

/// What each page takes from a table.
std::vector<std::pair<std::string_view, std::string>> parts_of(std::string_view page) {
  kiosk::Options options;
  const terminal::Command docent = kiosk::program(options, [] { return 0; });
  const terminal::Command content = command::program();
  update::Options update_options;
  const terminal::Command update = update::program(update_options, [] { return 0; });
  const terminal::Command& program = program_of(page) == "docent"          ? docent
                                     : program_of(page) == "docent-update" ? update
                                                                           : content;
  return {{"VERSION", std::string(terminal::version())},
          {"SYNOPSIS", mdoc_synopsis(program)},
          {"OPTIONS", mdoc_options(program)},
          {"COMMANDS", mdoc_commands(program)},
          {"FILES", mdoc_section(program, "files")},
          {"SIGNALS", mdoc_section(program, "signals")},
          {"EXIT", mdoc_section(program, "exit codes")},
          {"JOURNAL", mdoc_messages()},
          {"VISIT", mdoc_visit()},
          {"MUSEUM", mdoc_fields(config::museum_manual())},
          {"EXHIBITS", mdoc_fields(config::exhibit_manual())},
          {"WORDS", mdoc_fields(config::words_manual())},
          {"KIOSK", mdoc_fields(config::kiosk_manual())},
          {"SCHEMA", std::to_string(schema::version)},
          {"TABLES", mdoc_tables(text_of(source_dir() / "runtime/schema/schema.sql"))}};
}

TEST(ManualPages, SayWhatTheTablesSay) {
  for (const char* page : pages) {
    const std::string by_hand = text_of(page_file(page).string() + ".in");
    ASSERT_FALSE(by_hand.empty()) << page;

    const std::string text = filled(by_hand, parts_of(page));

    EXPECT_THAT(text, testing::Not(testing::ContainsRegex("@[A-Z]+@")))
        << page << ": a part that there is not";
    expect_made(page_file(page), text);
  }
}

TEST(ManualPages, AreCleanMdoc) {
  if (std::system("command -v mandoc >/dev/null") != 0)  // NOLINT(bugprone-command-processor)
    GTEST_SKIP() << "mandoc is not installed";
  for (const char* page : pages) {
    const std::string command =
        fmt::format("mandoc -T lint -W warning '{}'", page_file(page).string());
    EXPECT_EQ(std::system(command.c_str()), 0) << page;  // NOLINT(bugprone-command-processor)
  }
}

TEST(ManualPages, TellEveryOptionOfEveryCommand) {
  const std::string page = text_of(page_file("docent-content.1"));

  for (const terminal::Command& command : command::program().commands) {
    EXPECT_THAT(page, HasSubstr(fmt::format(".Ss {}\n", command.name)));
    for (const terminal::Option& option : command.options) {
      if (terminal::is_positional(option)) continue;
      EXPECT_THAT(page, HasSubstr(fmt::format("Fl {}", terminal::names_of(option)[0].substr(1))));
    }
  }
}

TEST(Mdoc, TakesATableFromItsSqlWithWhatStandsBesideIt) {
  EXPECT_EQ(mdoc_tables("CREATE TABLE door (  -- a doorway\n  id INTEGER PRIMARY KEY,\n"
                        "  ring BLOB NOT NULL,   -- Ring\n  PRIMARY KEY (id)\n);\n"),
            ".Ss door\nA doorway.\n.Bl -tag -width 24n -compact\n.It Va id Vt INTEGER\n"
            ".It Va ring Vt BLOB\nRing\n.El\n");
}

TEST(Mdoc, MakesWhatWouldBeAMacroHarmless) {
  EXPECT_EQ(mdoc_text(".toml files"), "\\&.toml files");
  EXPECT_EQ(mdoc_text("a\\b"), "a\\eb");
}

}  // namespace
}  // namespace docent::test::manual_test
