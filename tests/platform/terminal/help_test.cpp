#include "platform/terminal/help.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/platform/terminal/kitchen.h"

namespace docent::terminal::help_test {
namespace {

using testing::AllOf;
using testing::Each;
using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;

TEST(Help, TellsHowAnOptionIsWrittenAndWhatHoldsWithoutIt) {
  Kitchen kitchen;
  const std::string page =
      help(kitchen.program().commands[0], "kitchen boil", false, ColourUse::Off);

  EXPECT_THAT(
      page, AllOf(HasSubstr("kitchen boil: boils what is in pots.\n"),
                  HasSubstr("usage: kitchen boil POT... -o DISH [--minutes M]"),
                  HasSubstr("[--salt G]..."),
                  HasSubstr("  --minutes M              How long; default until it is done\n"),
                  HasSubstr("  -o, --output DISH        Where it goes (needed)\n"),
                  HasSubstr("  --hot, --no-hot          Serve it hot\n"), HasSubstr("-h, --help")));
}

TEST(Help, IsPlainTextInLinesThatFitATerminal) {
  Kitchen kitchen;
  const std::string page = help(kitchen.program(), "kitchen", true, ColourUse::Off);

  EXPECT_EQ(page.find('\0'), std::string::npos);
  EXPECT_EQ(page.find('\x1b'), std::string::npos);
  EXPECT_THAT(split(page, '\n'), Each(SizeIs(testing::Le(80U))));
  EXPECT_THAT(page, AllOf(HasSubstr("  rinse                    rinses\n"), HasSubstr("--version"),
                          HasSubstr("exit codes:\n")));
}

TEST(Help, HasBoldHeadingsWhereThereIsColour) {
  Kitchen kitchen;

  EXPECT_THAT(help(kitchen.program(), "kitchen", true, ColourUse::On),
              HasSubstr("\x1b[1mcommands\x1b[0m:\n"));
}

}  // namespace
}  // namespace docent::terminal::help_test
