#include "platform/terminal/colour.h"

#include <gtest/gtest.h>
#include <pty.h>
#include <unistd.h>

#include <cstdlib>
#include <memory>

namespace docent::terminal::colour_test {
namespace {

struct Close {
  void operator()(std::FILE* file) const noexcept { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;

/// The two ends of a terminal that nobody looks at.
class Colours : public testing::Test {
 protected:
  void SetUp() override {
    int outer = -1, inner = -1;
    ASSERT_EQ(openpty(&outer, &inner, nullptr, nullptr, nullptr), 0);
    outer_.reset(fdopen(outer, "r"));
    terminal_.reset(fdopen(inner, "w"));
    ::setenv("TERM", "xterm", 1);
    ::unsetenv("NO_COLOR");
  }
  void TearDown() override { ::unsetenv("NO_COLOR"); }

  File outer_, terminal_;
};

TEST_F(Colours, AreShownOnATerminalOnly) {
  const File file(std::tmpfile());

  EXPECT_EQ(colour_use_of(terminal_.get()), ColourUse::On);
  EXPECT_EQ(colour_use_of(file.get()), ColourUse::Off);
}

TEST_F(Colours, AreNotShownToWhoWantsNone) {
  ::setenv("NO_COLOR", "1", 1);
  EXPECT_EQ(colour_use_of(terminal_.get()), ColourUse::Off);
  ::setenv("NO_COLOR", "", 1);
  EXPECT_EQ(colour_use_of(terminal_.get()), ColourUse::On) << "empty is as if it were not set";
  ::setenv("TERM", "dumb", 1);
  EXPECT_EQ(colour_use_of(terminal_.get()), ColourUse::Off);
}

TEST(Painted, LeavesTextAsItIsWithoutColour) {
  EXPECT_EQ(painted("error", Ink::Error, ColourUse::Off), "error");
  EXPECT_EQ(painted("error", Ink::Error, ColourUse::On), "\x1b[1;31merror\x1b[0m");
}

}  // namespace
}  // namespace docent::terminal::colour_test
