// docent-content film.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>

#include "platform/image/image.h"
#include "tests/support/run_program.h"
#include "tests/support/sample_database.h"
#include "tests/support/temporary_folder.h"

namespace docent::command::film_command_test {
namespace {

using test::ProgramRun;
using testing::AllOf;
using testing::HasSubstr;

/// A path before the sample museum's kiosk, and a place for the film of it.
class FilmCommand : public testing::Test {
 protected:
  FilmCommand() { std::ofstream(path()) << "x,y\n20,2.6\n20,5.6\n21,7\n"; }

  ProgramRun film(const std::filesystem::path& output, const std::string& options) const {
    return test::run_program(
        "docent-content",
        fmt::format("film '{}' --path '{}' -o '{}' {}", test::sample_database().string(),
                    path().string(), output.string(), options));
  }
  Pixels picture(const std::filesystem::path& file) const {
    const std::string bytes = test::text_of(file);
    return image::decode_image(std::as_bytes(std::span(bytes))).value_or(Pixels{});
  }
  std::filesystem::path path() const { return folder_.path() / "path.csv"; }
  std::filesystem::path sheet() const { return folder_.path() / "sheet.png"; }
  std::filesystem::path moving() const { return folder_.path() / "film.webp"; }

 private:
  test::TemporaryFolder folder_;
};

/// Pixels that are nearly of the vermilion guide's coat: much redder than anything in the model.
int vermilion_pixels(const Pixels& picture) {
  int count = 0;
  for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
    const auto red = std::to_integer<int>(picture.rgba[i]);
    const auto green = std::to_integer<int>(picture.rgba[i + 1]);
    const auto blue = std::to_integer<int>(picture.rgba[i + 2]);
    if (red > 120 && green < red / 2 && blue < red / 2) ++count;
  }
  return count;
}

TEST_F(FilmCommand, MakesASheetOnWhichTheGuideIsSeenFromEverySide) {
  for (const char* view : {"front", "side", "back", "above", "kiosk"}) {
    const ProgramRun run =
        film(sheet(), fmt::format("--view {} --look vermilion --at 1,3 --frames 3", view));
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const Pixels seen = picture(sheet());
    EXPECT_EQ(seen.width, 960U) << view;
    EXPECT_EQ(seen.height, 320U) << view;
    EXPECT_GT(vermilion_pixels(seen), 600) << view;
  }
}

/// Pixels of bronze: of nothing else in the model.
int green_pixels(const Pixels& picture) {
  int count = 0;
  for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
    const auto red = std::to_integer<int>(picture.rgba[i]);
    const auto green = std::to_integer<int>(picture.rgba[i + 1]);
    const auto blue = std::to_integer<int>(picture.rgba[i + 2]);
    if (green > red + 12 && green > blue + 8) ++count;
  }
  return count;
}

TEST_F(FilmCommand, ShowsWhatStandsOnItsPlinth) {
  std::ofstream(path()) << "x,y\n9.6,16\n9.6,14\n";  // towards the owl of bronze
  const ProgramRun run = film(sheet(), "--view kiosk --look vermilion --at 0,1 --frames 2");

  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_GT(green_pixels(picture(sheet())), 60);
}

TEST_F(FilmCommand, MakesAMovingPictureOfTheSameBytesEachTime) {
  ASSERT_EQ(film(moving(), "--at 0,0.4").exit_code, 0);
  const std::string bytes = test::text_of(moving());
  ASSERT_EQ(bytes.substr(0, 4), "RIFF");
  EXPECT_EQ(bytes.substr(8, 8), "WEBPVP8X");
  EXPECT_THAT(bytes, HasSubstr("ANIM"));
  EXPECT_EQ(bytes[24], '\xdf');  // 480 - 1, in the header's three bytes of width
  EXPECT_EQ(bytes[25], '\x01');

  ASSERT_EQ(film(moving(), "--at 0,0.4").exit_code, 0);
  EXPECT_EQ(test::text_of(moving()), bytes);
}

TEST_F(FilmCommand, SaysWhatIsWrongWithWhatItWasAsked) {
  const ProgramRun look = film(sheet(), "--look tela");
  EXPECT_EQ(look.exit_code, 2);
  EXPECT_THAT(look.err, AllOf(HasSubstr("tela"), HasSubstr("did you mean 'teal'")));

  const ProgramRun times = film(sheet(), "--at 3,1");
  EXPECT_EQ(times.exit_code, 2);
  EXPECT_THAT(times.err, HasSubstr("S1 not before S0"));

  const ProgramRun format = film(sheet().replace_extension(".gif"), "");
  EXPECT_EQ(format.exit_code, 2);
  EXPECT_THAT(format.err, HasSubstr(".png is a sheet"));

  const ProgramRun hours = film(moving(), "--at 0,3600");
  EXPECT_EQ(hours.exit_code, 2);
  EXPECT_THAT(hours.err, HasSubstr("has at most 600"));

  std::ofstream(path()) << "x,y\n20,2.6\n20,2.6\n";
  const ProgramRun nowhere = film(sheet(), "");
  EXPECT_EQ(nowhere.exit_code, 1);
  EXPECT_THAT(nowhere.err, HasSubstr("two different points"));

  std::ofstream(path()) << "x,y\n20,2.6\n20,far\n";
  const ProgramRun word = film(sheet(), "");
  EXPECT_EQ(word.exit_code, 1);
  EXPECT_THAT(word.err, HasSubstr("path.csv:3:4"));
  EXPECT_FALSE(std::filesystem::exists(sheet()));
}

TEST_F(FilmCommand, SaysWithExitCodeThreeThatNothingHereCanDraw) {
  ::setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/dev/null", 1);  // libglvnd: no driver at all
  const ProgramRun run = film(sheet(), "--frames 1");
  ::unsetenv("__EGL_VENDOR_LIBRARY_FILENAMES");

  EXPECT_EQ(run.exit_code, 3);
  EXPECT_THAT(run.err, HasSubstr("OpenGL ES 3"));
  EXPECT_FALSE(std::filesystem::exists(sheet()));
}

}  // namespace
}  // namespace docent::command::film_command_test
