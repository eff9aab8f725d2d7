#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include "tests/support/kiosk_run.h"

namespace docent::test {
namespace {

bool is_installed(const char* program) {
  return std::system(("command -v " + std::string(program) + " >/dev/null").c_str()) ==
         0;  // NOLINT(bugprone-command-processor)
}

/// A virtual X server of this test's own; the mouse is moved and pressed as a person would, the
/// window closed by its manager's message.
TEST(AWindow, OnAVirtualDesktopTakesTheMouseForAFinger) {
  if (!is_installed("Xvfb") || !is_installed("xdotool"))
    GTEST_SKIP() << "needs the packages xvfb and xdotool";
  const TemporaryFolder folder;
  const std::string stats = (folder.path() / "stats.json").string();
  std::ofstream(folder.path() / "desktop.sh")
      << "set -u\nexec 6>'" << (folder.path() / "display").string() << "'\n"
      << "Xvfb -displayfd 6 -screen 0 800x600x24 -nolisten tcp 2>/dev/null &\nserver=$!\n"
      << "for i in $(seq 100); do [ -s '" << (folder.path() / "display").string()
      << "' ] && break; sleep 0.1; done\n"
      << "export DISPLAY=:$(cat '" << (folder.path() / "display").string() << "')\n"
      << "unset WAYLAND_DISPLAY\n'" << program("docent").string() << "' --content '"
      << sample_database().string() << "' --display window --size 640x360 --stats '" << stats
      << "' &\nkiosk=$!\n"
      << "for i in $(seq 200); do xdotool search --name '^docent$' >/dev/null 2>&1 && break; sleep "
         "0.1; done\n"
      << "sleep 3\nfor i in 1 2 3; do xdotool mousemove 320 180 mousedown 1; sleep 0.3; xdotool "
         "mouseup 1; "
         "sleep 0.7; done\nxdotool key Down\nsleep 1\nkill -TERM $kiosk\nwait $kiosk\ncode=$?\n"
      << "kill $server\nwait $server 2>/dev/null\nexit $code\n";

  const std::string command = "bash '" + (folder.path() / "desktop.sh").string() + "'";
  EXPECT_EQ(std::system(command.c_str()), 0);  // NOLINT(bugprone-command-processor)
  const std::string written = text_of(stats);
  EXPECT_GT(number_in(written, "frames"), 20);
  EXPECT_GE(number_in(written, "touches"), 3);
}

}  // namespace
}  // namespace docent::test
