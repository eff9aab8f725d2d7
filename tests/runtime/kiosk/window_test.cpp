#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include "tests/support/kiosk_run.h"
#include "tests/support/started_program.h"

namespace docent::test::window_test {
namespace {

bool is_installed(const char* program) {
  return std::system(("command -v " + std::string(program) + " >/dev/null").c_str()) ==
         0;  // NOLINT(bugprone-command-processor)
}

/// A virtual X server of this test's own, on which the mouse is moved and pressed as a person
/// would.
class VirtualDesktop {
 public:
  VirtualDesktop() {
    int ends[2];
    if (pipe(ends) != 0) return;
    // It stays when xdotool, perhaps its only client, leaves.
    server_.emplace("Xvfb", std::vector<std::string>{
                                "-noreset", "-displayfd", std::to_string(ends[1]), "-screen", "0",
                                "640x360x24", "-nolisten", "tcp", "-fbdir", folder_.path()});
    close(ends[1]);
    char digit = 0;  // the server says its number when it is ready, and then a new line
    while (read(ends[0], &digit, 1) == 1 && digit != '\n') number_ += digit;
    close(ends[0]);
    setenv("DISPLAY", fmt::format(":{}", number_).c_str(), 1);
    unsetenv("WAYLAND_DISPLAY");
  }

  VirtualDesktop(const VirtualDesktop&) = delete;
  VirtualDesktop& operator=(const VirtualDesktop&) = delete;
  ~VirtualDesktop() { end(); }

  /// The server goes, and whatever is on it.
  void end() {
    if (!server_) return;
    server_->signal(SIGCONT);
    server_->signal(SIGTERM);  // so that it takes its lock away
    server_->wait();
    server_.reset();
  }
  /// The server answers nobody any more.
  void freeze() const { server_->halt(); }

  bool is_there() const { return !number_.empty(); }
  bool xdotool(const std::string& what) const {
    return std::system(("xdotool " + what + " >'" + (folder_.path() / "answer").string() + "' 2>&1")
                           .c_str()) == 0;  // NOLINT(bugprone-command-processor)
  }
  /// What is on its screen.
  std::string picture() const { return text_of(folder_.path() / "Xvfb_screen0"); }

 private:
  TemporaryFolder folder_;
  std::optional<StartedProgram> server_;
  std::string number_;
};

/// Waits until the picture has changed so often: a frame after the first has seen all that came
/// before.
bool shows_pictures(const StartedProgram& kiosk, const VirtualDesktop& desktop, int count) {
  for (; count > 0; --count)
    if (!kiosk.runs_until([&, before = desktop.picture()] { return desktop.picture() != before; }))
      return false;
  return true;
}

/// docent in a window of a desktop, as soon as it has shown some pictures.
class KioskInAWindow {
 public:
  bool is_shown() {
    return desktop_.is_there() && kiosk_->runs_until([&] {
      return desktop_.xdotool("search --onlyvisible --name '^docent$'");
    }) && shows_pictures(3);
  }
  bool shows_pictures(int count) const {
    return window_test::shows_pictures(*kiosk_, desktop_, count);
  }
  VirtualDesktop& desktop() { return desktop_; }
  StartedProgram& kiosk() { return *kiosk_; }
  std::string stats() const { return text_of(folder_.path() / "stats.json"); }
  std::string said() const { return text_of(folder_.path() / "said"); }

 private:
  TemporaryFolder folder_;
  VirtualDesktop desktop_;
  std::optional<StartedProgram> kiosk_{
      std::in_place, program("docent"),
      std::vector<std::string>{"--content", sample_database(), "--display", "window", "--size",
                               "640x360", "--stats", folder_.path() / "stats.json"},
      folder_.path() / "said"};
};

class AWindow : public testing::Test {
 protected:
  void SetUp() override {
    if (!is_installed("Xvfb") || !is_installed("xdotool"))
      GTEST_SKIP() << "needs the packages xvfb and xdotool";
  }
};

TEST_F(AWindow, WithoutAMuseumSaysWhatToDoAndShowsItAsSoonAsItIsThere) {
  const TemporaryFolder folder;
  const VirtualDesktop desktop;
  ASSERT_TRUE(desktop.is_there());
  const auto file = [&](const char* name) { return (folder.path() / name).string(); };
  std::ofstream(file("kiosk.toml")) << "content = \"museum.db\"\n";
  const std::string empty = desktop.picture();
  StartedProgram kiosk(program("docent"),
                       {"--config", file("kiosk.toml"), "--display", "window", "--size", "640x360"},
                       file("said"));
  ASSERT_TRUE(kiosk.runs_until([&] { return desktop.picture() != empty; }));
  EXPECT_TRUE(kiosk.runs_until(
      [&] { return text_of(file("said")).contains("museum.db: there is no such database"); }));

  std::ofstream(file("museum.part")) << "half a museum";
  std::filesystem::rename(file("museum.part"), file("museum.db"));
  EXPECT_TRUE(kiosk.runs_until(
      [&] { return text_of(file("said")).contains("museum.db: is not a docent database"); }));
  std::filesystem::copy_file(sample_database(), file("museum.part"));
  std::filesystem::rename(file("museum.part"), file("museum.db"));

  EXPECT_TRUE(kiosk.runs_until([&] { return text_of(file("said")).contains("docent: shows '"); }));
  EXPECT_TRUE(shows_pictures(kiosk, desktop, 3));
  kiosk.signal(SIGTERM);
  EXPECT_EQ(kiosk.wait(), 0);
}

TEST_F(AWindow, OnAVirtualDesktopTakesTheMouseForAFinger) {
  KioskInAWindow window;
  ASSERT_TRUE(window.is_shown());

  for (int touch = 0; touch < 3; ++touch) {
    EXPECT_TRUE(window.desktop().xdotool("mousemove 320 180 mousedown 1"));
    EXPECT_TRUE(window.shows_pictures(5));
    EXPECT_TRUE(window.desktop().xdotool("mouseup 1"));
    EXPECT_TRUE(window.shows_pictures(5));
  }
  EXPECT_TRUE(window.desktop().xdotool("key Down"));
  EXPECT_TRUE(window.shows_pictures(5));
  window.kiosk().signal(SIGTERM);

  EXPECT_EQ(window.kiosk().wait(), 0);
  EXPECT_GT(number_in(window.stats(), "frames"), 20);
  EXPECT_EQ(number_in(window.stats(), "touches"), 3);
  EXPECT_THAT(window.said(), testing::AllOf(testing::HasSubstr("on a window of 640 x 360 pixels"),
                                            testing::HasSubstr("docent: shows '")));
}

TEST_F(AWindow, WhoseServerGoesEndsTheProgramWithASentence) {
  KioskInAWindow window;
  ASSERT_TRUE(window.is_shown());

  window.desktop().end();

  EXPECT_EQ(window.kiosk().wait(), 3);
  EXPECT_THAT(window.said(), testing::HasSubstr("docent: the X server has gone"));
}

TEST_F(AWindow, WhoseServerAnswersNobodyDoesNotKeepTheProgramFromEnding) {
  KioskInAWindow window;
  ASSERT_TRUE(window.is_shown());
  window.desktop().freeze();

  window.kiosk().signal(SIGTERM);

  EXPECT_EQ(window.kiosk().wait(), 0);
}

}  // namespace
}  // namespace docent::test::window_test
