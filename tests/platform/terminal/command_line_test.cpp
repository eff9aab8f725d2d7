#include "platform/terminal/command_line.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "tests/platform/terminal/kitchen.h"

namespace docent::terminal::command_line_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::expected<std::function<int()>, Diagnostic> parse(Kitchen& kitchen,
                                                      const std::vector<std::string>& words) {
  std::vector<const char*> arguments;
  for (const std::string& word : words) arguments.push_back(word.c_str());
  return terminal::parse(kitchen.program(), arguments);
}

/// What is said of a wrong line.
Diagnostic mistake_in(const std::vector<std::string>& words) {
  Kitchen kitchen;
  const auto parsed = parse(kitchen, words);
  EXPECT_FALSE(parsed.has_value());
  return parsed ? Diagnostic{} : parsed.error();
}

TEST(CommandLine, StoresWhatItSaysAndRunsTheCommand) {
  Kitchen kitchen;

  const auto run = parse(kitchen, {"boil", "a", "--salt", "1", "b", "--minutes=2.5", "-o", "out",
                                   "--salt", "2", "--hot", "--cooks", "3"});

  ASSERT_TRUE(run.has_value()) << run.error().message;
  EXPECT_EQ((*run)(), 41);
  EXPECT_THAT(kitchen.pots, ElementsAre("a", "b"));
  EXPECT_THAT(kitchen.salt, ElementsAre(1, 2));
  EXPECT_EQ(kitchen.minutes, 2.5);
  EXPECT_EQ(kitchen.cooks, 3U);
  EXPECT_EQ(kitchen.dish, "out");
  EXPECT_TRUE(kitchen.hot);
  EXPECT_FALSE(kitchen.loud);
}

TEST(CommandLine, TakesANegativeNumberForAValueAndTheLastOfAFlagAndItsContrary) {
  Kitchen kitchen;
  EXPECT_EQ(mistake_in({"boil", "a", "-o", "out", "--minutes", "-1"}).message,
            "'-1' is not a number of more than 0");

  ASSERT_TRUE(parse(kitchen, {"boil", "a", "-o", "out", "--hot", "--no-hot"}).has_value());
  EXPECT_FALSE(kitchen.hot);
}

TEST(CommandLine, SuggestsTheCommandOrOptionThatWasMeant) {
  EXPECT_EQ(mistake_in({"biol", "a"}).code, "unknown-command");
  EXPECT_EQ(mistake_in({"biol", "a"}).hint, "did you mean 'boil'?");
  EXPECT_EQ(mistake_in({"fry"}).hint, "it has boil, rinse");
  const Diagnostic option = mistake_in({"boil", "a", "-o", "b", "--minuets=3"});
  EXPECT_EQ(option.file, "--minuets");
  EXPECT_EQ(option.code, "unknown-option");
  EXPECT_EQ(option.hint, "did you mean '--minutes'?");
  EXPECT_EQ(mistake_in({"--hepl"}).hint, "did you mean '--help'?");
}

TEST(CommandLine, SaysWhichArgumentIsOneTooMany) {
  const Diagnostic extra = mistake_in({"rinse", "twice"});

  EXPECT_EQ(extra.file, "twice");
  EXPECT_EQ(extra.code, "extra-argument");
  EXPECT_EQ(extra.message, "kitchen rinse does not expect this argument");
}

TEST(CommandLine, SaysWhatIsMissing) {
  EXPECT_EQ(mistake_in({}).code, "missing-command");
  EXPECT_EQ(mistake_in({"boil", "a"}).message, "kitchen boil needs -o, --output DISH");
  EXPECT_EQ(mistake_in({"boil", "-o", "out"}).message, "kitchen boil needs POT");
  const Diagnostic value = mistake_in({"boil", "a", "-o"});
  EXPECT_EQ(value.code, "missing-value");
  EXPECT_THAT(value.file, HasSubstr("output"));
}

TEST(CommandLine, RefusesANumberThatIsNoneAndOneOutsideInASentenceOfOneLine) {
  const auto with = [](const char* name, const char* value) {
    return mistake_in({"boil", "a", "-o", "out", name, value}).message;
  };

  EXPECT_EQ(with("--minutes", "nan"), "'nan' is not a number of more than 0");
  EXPECT_EQ(with("--minutes", "inf"), "'inf' is not a number of more than 0");
  EXPECT_EQ(with("--salt", "11"), "'11' is not a number between 0 and 10");
  EXPECT_EQ(with("--cooks", "0"), "'0' is not a whole number between 1 and 8");
  EXPECT_EQ(with("--cooks", "1.5"), "'1.5' is not a whole number between 1 and 8");
  EXPECT_EQ(mistake_in({"boil", "a", "-o", "b", "-o", "c"}).message,
            "this is given 2 times; say it once");
}

TEST(CommandLine, AskedForHelpOrTheVersionDoesNothingElse) {
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"--help"}, {"boil", "-h"}, {"--version"}}) {
    Kitchen kitchen;

    const auto run = parse(kitchen, words);

    ASSERT_TRUE(run.has_value());
    testing::internal::CaptureStdout();
    EXPECT_EQ((*run)(), 0);
    const std::string said = testing::internal::GetCapturedStdout();
    EXPECT_THAT(said, HasSubstr(words[0] == "--version" ? "kitchen " + std::string(version())
                                                        : "usage: kitchen"));
    EXPECT_EQ(kitchen.ran, 0);
  }
}

TEST(CommandLine, OfAnyWordsIsTakenOrRefused) {
  EXPECT_TRUE(rc::check("any words", [](const std::vector<std::string>& words) {
    Kitchen kitchen;
    std::vector<std::string> c_words;
    for (const std::string& word : words) c_words.emplace_back(word.c_str());
    const auto run = parse(kitchen, c_words);
    RC_ASSERT(run.has_value() || !run.error().message.empty());
  }));
}

}  // namespace
}  // namespace docent::terminal::command_line_test
