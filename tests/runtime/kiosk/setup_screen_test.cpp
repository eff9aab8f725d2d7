#include "runtime/kiosk/setup_screen.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "platform/gles/renderer.h"
#include "platform/headless/headless_display.h"
#include "platform/pango/text_setter.h"
#include "tests/support/temporary_folder.h"

namespace docent::kiosk::setup_screen_test {
namespace {

/// The screen as a picture; kept where DOCENT_KEEP_PICTURES names a folder.
Pixels setup_screen(PixelSize size, bool is_night = false) {
  const auto display = headless::open_headless(size).value();
  gles::Renderer renderer = gles::make_renderer().value();
  const SetupScreen screen(pango::make_text_setter().value(), size,
                           "/var/lib/docent/museum.db: there is no such database; make it with "
                           "'docent-content compile'",
                           is_night);
  screen.draw(renderer, display->target());
  Pixels picture;
  display->read_back(picture);
  if (const char* folder = std::getenv("DOCENT_KEEP_PICTURES")) {
    EXPECT_TRUE(image::write_png(
        std::filesystem::path(folder) /
            fmt::format("setup-{}x{}{}.png", size.width, size.height, is_night ? "-night" : ""),
        picture));
  }
  return picture;
}

/// How many rows of the part of a picture have letters, which are dark on paper.
std::size_t rows_with_ink(const Pixels& picture, double from, double to) {
  std::size_t rows = 0;
  for (auto y = static_cast<std::size_t>(from * picture.height);
       y < static_cast<std::size_t>(to * picture.height); ++y) {
    bool has_ink = false;
    for (std::size_t x = 0; x < picture.width; ++x)
      has_ink |= picture.rgba[4 * (y * picture.width + x)] < std::byte{0x80};
    rows += has_ink ? 1 : 0;
  }
  return rows;
}

TEST(TheSetupScreen, SaysWhatToDoOnScreensOfEveryShape) {
  for (const PixelSize size : {PixelSize{1280, 720}, PixelSize{720, 1280}, PixelSize{800, 600}}) {
    const Pixels picture = setup_screen(size);

    EXPECT_GT(rows_with_ink(picture, 0, 1), size.height / 6) << size.width;
    EXPECT_EQ(rows_with_ink(picture, 0, 0.05), 0U) << size.width;
    EXPECT_EQ(rows_with_ink(picture, 0.96, 1), 0U) << "it does not all fit " << size.width;
  }
}

/// The mean of all channels, of 255.
double brightness(const Pixels& picture) {
  double sum = 0;
  for (const std::byte part : picture.rgba) sum += std::to_integer<int>(part);
  const auto pixels = static_cast<double>(picture.rgba.size() / 4);
  return (sum / pixels - 255) / 3;  // opacity is whole
}

TEST(TheSetupScreen, IsDarkInHallsThatAre) {
  const Pixels day = setup_screen({1280, 720}), night = setup_screen({1280, 720}, true);

  EXPECT_GT(brightness(day), 200);
  EXPECT_LT(brightness(night), 60);
}

TEST(AFileWatch, NoticesWhatIsPutInPlaceReplacedAndTakenAway) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "museum.db";
  FileWatch watch(file);
  EXPECT_FALSE(watch.has_changed());

  std::ofstream(file) << "one";
  EXPECT_TRUE(watch.has_changed());
  EXPECT_FALSE(watch.has_changed());
  std::ofstream(folder.path() / "other") << "two";
  std::filesystem::rename(folder.path() / "other", file);
  EXPECT_TRUE(watch.has_changed());
  std::filesystem::remove(file);
  EXPECT_TRUE(watch.has_changed());
}

}  // namespace
}  // namespace docent::kiosk::setup_screen_test
