// What only staff and who sets a kiosk up get to see.

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <utility>

#include "config/museum_config.h"
#include "platform/gles/holdings.h"
#include "platform/gles/renderer.h"
#include "platform/headless/headless_display.h"
#include "platform/pango/text_setter.h"
#include "runtime/kiosk/setup_screen.h"
#include "runtime/kiosk/staff_facts.h"
#include "runtime/kiosk/staff_page.h"
#include "tests/golden/pictures.h"
#include "tests/support/reference_data.h"
#include "tests/support/temporary_folder.h"

namespace docent::test::staff_pictures_test {
namespace {

using kiosk::StaffScreen;
using kiosk::StaffWord;

constexpr PixelSize size{960, 540};

/// A museum that speaks the shipped languages.
Museum speaking_museum() {
  Museum museum;
  for (const char* tag : {"en", "zh", "ar"}) {
    const auto file =
        config::load_words(source_dir() / "config/words" / (std::string(tag) + ".toml"), tag);
    Language& language = museum.languages.emplace_back();
    language.tag = tag;
    language.right_to_left = file.value->direction.value == "right-to-left";
    for (const auto& [key, word] : file.value->words.value) language.words[key] = word.value;
  }
  museum.title = {
      {"en", "Museum of the Three Rivers"}, {"zh", "三河博物馆"}, {"ar", "متحف الأنهار الثلاثة"}};
  museum.floors.resize(2);
  museum.exhibits.resize(38);
  return museum;
}

/// A screen in memory that is drawn to.
class StaffPictures : public testing::Test {
 protected:
  void SetUp() override {
    auto display = headless::open_headless(size);
    ASSERT_TRUE(display.has_value()) << display.error().what;
    display_ = std::move(*display);
    auto renderer = gles::make_renderer();
    ASSERT_TRUE(renderer.has_value()) << renderer.error().what;
    renderer_.emplace(std::move(*renderer));
    auto set_text = pango::make_text_setter();
    ASSERT_TRUE(set_text.has_value()) << set_text.error().what;
    set_text_ = std::move(*set_text);
  }
  void TearDown() override { renderer_.reset(); }

  RenderTarget target() const { return display_->target(); }

  void expect(const std::string& name) {
    display_->present();
    Pixels picture;
    display_->read_back(picture);
    const std::filesystem::path file = folder_.path() / name;
    ASSERT_TRUE(image::write_png(file, picture).has_value());
    expect_approved(file, name.c_str());
  }

  void expect_page(const kiosk::StaffPageRequest& request, const std::string& name) {
    const kiosk::StaffPage page = kiosk::make_staff_page(request, set_text_);
    gles::Holdings holdings;
    for (const auto& [texture, text, picture] : page.uploads)
      holdings.add_text(texture, text.width, text.height, text.coverage);
    scene::DrawList list;
    list.quads = page.quads;
    renderer_->draw(list, holdings, target());
    expect(name);
  }

  std::unique_ptr<headless::HeadlessDisplay> display_;
  std::optional<gles::Renderer> renderer_;
  interface::SetText set_text_;
  TemporaryFolder folder_;
};

TEST_F(StaffPictures, LookAsTheyWereSeenAndApproved) {
  const Museum museum = speaking_museum();
  kiosk::Statistics statistics;
  statistics.frames = 183'402;
  statistics.dropped_frames = 17;
  for (std::uint32_t language = 0; language < museum.languages.size(); ++language) {
    kiosk::StaffPageRequest request;
    request.shape = {.width = size.width, .height = size.height, .diagonal_inches = 24};
    request.words = kiosk::staff_words(museum, language);
    request.first_texture = 1;
    const std::string tag = museum.languages[language].tag;
    const auto expect_screen = [&](StaffScreen screen, std::string message, const char* name) {
      request.screen = screen;
      request.message = std::move(message);
      expect_page(request, std::string("staff-") + name + "-" + tag + ".png");
    };
    expect_screen(StaffScreen::Pad, request.words.filled(StaffWord::Wrong, {{"n", "4"}}), "pad");
    expect_screen(StaffScreen::Menu, std::string(request.words[StaffWord::Kept]), "menu");
    request.mark = 2;
    expect_screen(StaffScreen::Calibrate, request.words.one_of(3, 4), "calibrate");
    expect_screen(StaffScreen::Confirm,
                  request.words.filled(StaffWord::Moved, {{"n", "4.2"}, {"seconds", "15"}}),
                  "confirm");
    request.facts = facts_of({.museum = museum,
                              .statistics = statistics,
                              .database = "/var/lib/docent/museum.db",
                              .screen = "HDMI-A-1, 1920 x 1080 pixels at 60 Hz of /dev/dri/card0",
                              .touches = 951},
                             request.words);
    request.facts[0].value = "1.0";  // of the program
    request.facts.push_back({.label = std::string(request.words[StaffWord::TouchScreen]),
                             .value = "04e7:0022 Elo touch screen",
                             .is_of_machine = true});
    expect_screen(StaffScreen::Diagnose, std::string(request.words[StaffWord::Felt]), "diagnose");
  }
}

TEST_F(StaffPictures, AreDarkInHallsThatAre) {
  kiosk::StaffPageRequest request;
  request.shape = {.width = size.width, .height = size.height, .diagonal_inches = 24};
  request.shape.is_night = true;
  request.words = kiosk::staff_words(speaking_museum(), 0);
  request.first_texture = 1;
  request.screen = StaffScreen::Menu;
  expect_page(request, "staff-menu-night.png");
}

TEST_F(StaffPictures, OfAKioskWithoutAMuseumSayWhatToDo) {
  for (const bool is_night : {false, true}) {
    const kiosk::SetupScreen screen(set_text_, size,
                                    "/var/lib/docent/museum.db: there is no such file", is_night);
    screen.draw(*renderer_, target());
    expect(is_night ? "setup-night.png" : "setup.png");
  }
}

}  // namespace
}  // namespace docent::test::staff_pictures_test
