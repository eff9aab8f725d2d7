// Staff's screens, as a scripted visit opens them.

#include "runtime/kiosk/staff.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>

#include "platform/image/image.h"
#include "platform/pin/pin.h"
#include "runtime/input/calibration.h"
#include "runtime/kiosk/kiosk.h"
#include "tests/support/kiosk_run.h"

namespace docent::kiosk::staff_test {
namespace {

using testing::HasSubstr;

constexpr const char* pin = "471199";
constexpr std::uint32_t width = 640, height = 360;

/// A kiosk with a PIN and a folder for its calibration, in which a visit is played.
class StaffVisit {
 public:
  explicit StaffVisit(const std::string& with_pin = pin) {
    std::ofstream(folder_.path() / "kiosk.toml")
        << "staff_pin = \"" << *docent::pin::hash(with_pin) << "\"\n";
    std::filesystem::create_directory(folder_.path() / "glass");
  }

  test::ProgramRun play(const std::string& visit) const {
    std::ofstream(folder_.path() / "a.visit") << visit;
    setenv("STATE_DIRECTORY", (folder_.path() / "glass").c_str(), 1);
    test::ProgramRun run = test::run_program(
        "docent",
        fmt::format("--content '{}' --display headless --size {}x{} --config '{}' --visit "
                    "'{}' --stats '{}'",
                    test::sample_database().string(), width, height,
                    (folder_.path() / "kiosk.toml").string(), (folder_.path() / "a.visit").string(),
                    path("stats.json")));
    unsetenv("STATE_DIRECTORY");
    return run;
  }
  std::string path(const char* name) const { return (folder_.path() / name).string(); }
  std::string calibration() const {
    return std::filesystem::exists(path("glass/glass.calibration"))
               ? test::text_of(path("glass/glass.calibration"))
               : std::string();
  }

 private:
  test::TemporaryFolder folder_;
};

constexpr const char* two_corners = "1 down 1 0.02 0.03\n1 down 2 0.98 0.97\n6.5 up 1\n6.5 up 2\n";

std::string typed(std::string_view figures, double time) {
  std::string visit;
  for (const char figure : figures) visit += fmt::format("{} key {}\n", time, figure);
  return visit + fmt::format("{} key ENTER\n", time);
}

/// Where a button of a page lies; layouts do not depend on what their letters look like.
std::pair<float, float> middle_of(StaffScreen screen, StaffAction action) {
  const interface::SetText no_letters = [](const interface::TextStyle&, std::string_view,
                                           std::uint32_t) { return interface::TextBitmap{}; };
  StaffPageRequest request;
  request.screen = screen;
  request.shape.width = width;
  request.shape.height = height;
  const StaffPage page = make_staff_page(request, no_letters);
  for (const StaffPage::Button& button : page.buttons)
    if (button.action == action)
      return {button.rect.x + button.rect.width / 2, button.rect.y + button.rect.height / 2};
  return {-1, -1};
}

std::string tap(double time, StaffScreen screen, StaffAction action) {
  const auto [x, y] = middle_of(screen, action);
  return fmt::format("{} tap {} {}\n", time, x, y);
}

TEST(Staff, EndTheProgramBehindGestureAndPin) {
  const StaffVisit visit;
  const auto run = visit.play(two_corners + typed(pin, 7) +
                              tap(8, StaffScreen::Menu, StaffAction::Exit) + "20 quit\n");

  EXPECT_EQ(run.exit_code, ended_by_staff) << run.err;
}

TEST(Staff, TypeTheirPinOnTheGlassToo) {
  const StaffVisit visit;
  std::string taps;
  double time = 7;
  for (const char figure : std::string_view(pin))
    taps += tap(time += 0.3, StaffScreen::Pad, static_cast<StaffAction>(figure - '0'));
  const auto run = visit.play(two_corners + taps + tap(10, StaffScreen::Pad, StaffAction::Enter) +
                              tap(11, StaffScreen::Menu, StaffAction::Exit) + "20 quit\n");

  EXPECT_EQ(run.exit_code, ended_by_staff) << run.err;
}

TEST(Staff, AreSpokenToInTheLanguageOnTheGlass) {
  const StaffVisit visit;
  const auto pad_in = [&](const char* language) {
    const std::string file = visit.path(fmt::format("pad-{}.png", language).c_str());
    const auto run = visit.play(
        fmt::format("0.2 tap @language:{}\n{}8 shot {}\n9 quit\n", language, two_corners, file));
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return test::text_of(file);
  };
  const std::string english = pad_in("en"), arabic = pad_in("ar");

  EXPECT_NE(english, arabic);
  EXPECT_EQ(arabic, pad_in("ar"));
}

TEST(Staff, AreNotThoseWithAnotherPin) {
  const StaffVisit visit;
  const auto run =
      visit.play(two_corners + typed("471198", 7) + tap(8, StaffScreen::Menu, StaffAction::Exit) +
                 typed(pin, 8.2) +  // within the pause
                 tap(8.6, StaffScreen::Menu, StaffAction::Exit) + "20 quit\n");

  EXPECT_EQ(run.exit_code, 0) << run.err;
}

TEST(Staff, WithoutTheGestureAreVisitors) {
  const StaffVisit visit;
  const auto run =
      visit.play(typed(pin, 7) + tap(8, StaffScreen::Menu, StaffAction::Exit) + "20 quit\n");

  EXPECT_EQ(run.exit_code, 0) << run.err;
}

TEST(Staff, LeaveTheGlassToTheVisitorsAgain) {
  const StaffVisit visit;
  const auto run = visit.play(two_corners + tap(8, StaffScreen::Pad, StaffAction::Close) +
                              "9 tap @exhibit:tripod-ding\n40 quit\n");

  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_GT(test::number_in(test::text_of(visit.path("stats.json")), "routes"), 0);
}

/// The four marks, touched where a glass that is off by 4 % to the right feels them.
std::string touched_marks(double time, double off) {
  std::string visit;
  for (const auto& [x, y] : input::calibration_marks)
    visit += fmt::format("{} tap {} {}\n", time += 0.5, x + off, y);
  return visit;
}

TEST(Staff, CalibrateAGlassThatIsOffAndProveItByATouch) {
  const StaffVisit visit;
  const auto [x, y] = middle_of(StaffScreen::Confirm, StaffAction::Keep);
  const auto run =
      visit.play(two_corners + typed(pin, 7) + tap(8, StaffScreen::Menu, StaffAction::Calibrate) +
                 touched_marks(9, 0.04) + fmt::format("13 tap {} {}\n", x + 0.04, y) + "15 quit\n");

  EXPECT_EQ(run.exit_code, 0) << run.err;
  const auto kept = input::parse_calibration(visit.calibration(), "glass");
  ASSERT_TRUE(kept.has_value()) << kept.error().what;
  EXPECT_NEAR(kept->c, -0.04, 0.001);
  EXPECT_NEAR(kept->a, 1, 0.001);
}

TEST(Staff, GetTheOldCalibrationBackWhereNobodyConfirmsTheNew) {
  const StaffVisit visit;
  const auto run =
      visit.play(two_corners + typed(pin, 7) + tap(8, StaffScreen::Menu, StaffAction::Calibrate) +
                 touched_marks(9, 0.04) + "13 key DOWN\n13 key ENTER\n" +
                 // 15 s later the menu is where it was, by the old calibration
                 tap(28, StaffScreen::Menu, StaffAction::Exit) + "40 quit\n");

  EXPECT_EQ(run.exit_code, ended_by_staff) << run.err;
  EXPECT_EQ(visit.calibration(), "");
}

TEST(Staff, AreToldThatABrokenCalibrationIsNotUsed) {
  const StaffVisit visit;
  std::ofstream(visit.path("glass/glass.calibration")) << "nonsense";
  const auto run = visit.play("1 quit\n");

  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.err, HasSubstr("is no calibration"));
}

TEST(StaffPage, HasTargetsOfFifteenMillimetresThatDoNotOverlap) {
  const interface::SetText no_letters = [](const interface::TextStyle&, std::string_view,
                                           std::uint32_t) { return interface::TextBitmap{}; };
  for (const auto& [w, h, inches] : {std::tuple{1920U, 1080U, 24.F}, std::tuple{1080U, 1920U, 43.F},
                                     std::tuple{1280U, 800U, 10.F}}) {
    for (const StaffScreen screen :
         {StaffScreen::Pad, StaffScreen::Menu, StaffScreen::Confirm, StaffScreen::Diagnose}) {
      StaffPageRequest request;
      request.screen = screen;
      request.shape = {.width = w, .height = h, .diagonal_inches = inches};
      request.facts.assign(12, {"a", "b"});
      const StaffPage page = make_staff_page(request, no_letters);
      const interface::Measures m = interface::measures_of(request.shape);
      for (std::size_t i = 0; i < page.buttons.size(); ++i) {
        const scene::Rect& a = page.buttons[i].rect;
        EXPECT_GE(a.height * static_cast<float>(h), 0.99F * 15 * m.mm) << static_cast<int>(screen);
        EXPECT_TRUE(a.x >= 0 && a.y >= 0 && a.x + a.width <= 1 && a.y + a.height <= 1);
        for (std::size_t k = 0; k < i; ++k) {
          const scene::Rect& b = page.buttons[k].rect;
          EXPECT_TRUE(a.x >= b.x + b.width || b.x >= a.x + a.width || a.y >= b.y + b.height ||
                      b.y >= a.y + a.height);
        }
      }
    }
  }
}

TEST(StaffPage, WearsTheMuseumsColoursWhereItCanBeReadInThem) {
  Livery navy;
  navy.paper = 0xE9F0F1;
  navy.ink = 0x0B2A3B;
  Livery pale = navy;
  pale.ink = 0x7A8A93;
  Livery hidden = navy;
  hidden.focus = 0xDDE6E8;
  for (const bool is_night : {false, true}) {
    EXPECT_EQ(staff_theme({}, is_night), scene::theme_of({}, false, is_night));
    EXPECT_EQ(staff_theme(navy, is_night), scene::theme_of(navy, false, is_night));
  }
  EXPECT_EQ(staff_theme(pale, false), scene::theme_of({}, false, false)) << "nobody could read it";
  EXPECT_EQ(staff_theme(hidden, false), scene::theme_of({}, false, false)) << "nor see the focus";

  StaffPageRequest request;
  request.shape.width = width;
  request.shape.height = height;
  request.livery = navy;
  const StaffPage page =
      make_staff_page(request, [](const interface::TextStyle&, std::string_view, std::uint32_t) {
        return interface::TextBitmap{};
      });
  EXPECT_EQ(page.quads.front().colour, scene::srgb(navy.paper));
}

TEST(StaffFolder, IsTheOneOfTheGlassWhereAUnitHasSeveral) {
  setenv("STATE_DIRECTORY", "/var/lib/a:/var/lib/docent-glass:/var/lib/b", 1);
  EXPECT_EQ(staff_folder(), "/var/lib/docent-glass");
  setenv("STATE_DIRECTORY", "/var/lib/a", 1);
  EXPECT_EQ(staff_folder(), "/var/lib/a");
  unsetenv("STATE_DIRECTORY");
  EXPECT_EQ(staff_folder(), "");
}

TEST(PinCommand, PrintsALineForTheSettings) {
  const test::TemporaryFolder folder;
  const std::string out = (folder.path() / "out").string();
  const std::string command =
      "echo 471199 | '" + test::program("docent").string() + "' pin >'" + out + "'";
  ASSERT_EQ(std::system(command.c_str()), 0);  // NOLINT(bugprone-command-processor)

  EXPECT_THAT(test::text_of(out), testing::StartsWith("staff_pin = \"$argon2id$"));
}

}  // namespace
}  // namespace docent::kiosk::staff_test
