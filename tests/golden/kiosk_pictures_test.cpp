#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "runtime/scene/theme.h"
#include "tests/golden/pictures.h"
#include "tests/support/kiosk_run.h"
#include "tests/support/sanitized.h"

namespace docent::test::kiosk_pictures_test {
namespace {

TEST(TheKiosk, LooksAsItWasSeenAndApproved) {
  const VisitRun run("0.5 shot " + std::string("welcome.png") +
                     "\n1 key ENTER\n2.5 shot choosing.png\n3 tap @exhibit:tripod-ding\n"
                     "12 shot walking.png\n45 shot arrived.png\n46 tap @language:ar\n"
                     "47.5 shot arabic.png\n48 quit\n");
  const std::filesystem::path here = std::filesystem::current_path();
  std::filesystem::current_path(run.file("a.visit").parent_path());
  const ProgramRun played = run.play("", "960x540");
  std::filesystem::current_path(here);
  ASSERT_EQ(played.exit_code, 0) << played.err;

  for (const char* name :
       {"welcome.png", "choosing.png", "walking.png", "arrived.png", "arabic.png"})
    expect_approved(run.file(name), name);
}

/// Plays a visit in its folder, so that its pictures lie there.
void play_in_folder(const VisitRun& run, const char* size, const char* more = "") {
  const std::filesystem::path here = std::filesystem::current_path();
  std::filesystem::current_path(run.file("a.visit").parent_path());
  const ProgramRun played = run.play(more, size);
  std::filesystem::current_path(here);
  ASSERT_EQ(played.exit_code, 0) << played.err;
}

TEST(TheFocus, OutlinesWhatItIsAboutAndTheQuestionWhoIsStillThereHasItsRing) {
  const VisitRun run(
      "1 key ENTER\n2 key DOWN\n2.2 key DOWN\n3 shot focus.png\n"
      "50 shot still-here.png\n51 quit\n");
  play_in_folder(run, "960x540");

  for (const char* name : {"focus.png", "still-here.png"}) expect_approved(run.file(name), name);
}

TEST(TheSearch, ShowsItsKeysAndWhatIsFoundInLettersFromLeftAndFromRight) {
  const VisitRun run(
      "0.5 tap @search\n1 tap @key:b\n1.5 tap @key:r\n2 tap @key:o\n3 shot search.png\n"
      "3.1 tap @key:clear\n3.5 tap @language:ar\n4.5 tap @key:ب\n6 shot search-ar.png\n7 quit\n");
  play_in_folder(run, "960x540");

  for (const char* name : {"search.png", "search-ar.png"}) expect_approved(run.file(name), name);
}

/// The relative luminance of a pixel (WCAG 2.2).
double luminance(const Pixels& picture, std::uint32_t x, std::uint32_t y) {
  const std::size_t at = 4 * (std::size_t{y} * picture.width + x);
  const auto linear = [&](std::size_t channel) {
    return static_cast<double>(scene::linear_light(
        static_cast<float>(std::to_integer<int>(picture.rgba[at + channel])) / 255));
  };
  return 0.2126 * linear(0) + 0.7152 * linear(1) + 0.0722 * linear(2);
}

double contrast(double a, double b) {
  return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05);
}

/// Neither plaster, nor stone, nor oak is as yellow, nor the light in a doorway as deep.
bool is_ochre(const Pixels& picture, std::uint32_t x, std::uint32_t y) {
  const std::size_t at = 4 * (std::size_t{y} * picture.width + x);
  const auto level = [&](std::size_t c) { return std::to_integer<int>(picture.rgba[at + c]); };
  return level(2) < 60 && level(0) - level(2) > 100 && level(0) - level(1) > 20 &&
         level(0) - level(1) < 80;
}

TEST(TheWayAlongTheWalls, IsToldFromStoneInLightAndInShade) {
  const VisitRun run(
      "1 key ENTER\n2.2 tap @route:offset\n3 tap @exhibit:tripod-ding\n"
      "8 shot ochre.png\n8.1 quit\n");
  play_in_folder(run, "960x540");
  const Pixels seen = picture(run.file("ochre.png"));
  ASSERT_EQ(seen.width, 960U);
  int dots = 0, told = 0;
  for (std::uint32_t y = 100; y < 440; ++y)
    for (std::uint32_t x = 400; x + 20 < 940; ++x) {
      if (is_ochre(seen, x - 1, y) || !is_ochre(seen, x, y) || !is_ochre(seen, x + 4, y)) continue;
      double casing = 1;  // of the few pixels before the dot
      for (std::uint32_t i = 1; i <= 5; ++i) casing = std::min(casing, luminance(seen, x - i, y));
      ++dots;
      if (contrast(casing, luminance(seen, x - 9, y)) >= 3) ++told;
    }

  ASSERT_GT(dots, 60);
  EXPECT_GT(told, dots * 9 / 10) << "of " << dots;
}

TEST(AGallery, IsToldFromThoseBesideItByItsFloor) {
  const VisitRun run("0.5 shot welcome.png\n0.6 quit\n");
  play_in_folder(run, "960x540");
  const Pixels seen = picture(run.file("welcome.png"));
  ASSERT_EQ(seen.width, 960U);
  // A patch of bare floor in each: The First Letters, The Long Roads, Gold and Jade, Bronze,
  // Journeys After Life, First Farmers, Down to the Sea.
  const std::array<std::array<std::uint32_t, 2>, 7> patch{
      {{452, 142}, {632, 120}, {858, 138}, {505, 252}, {868, 250}, {445, 360}, {865, 368}}};
  std::array<std::array<double, 3>, patch.size()> floor{};
  for (std::size_t i = 0; i < patch.size(); ++i)
    for (std::uint32_t k = 0; k < 64; ++k) {
      const auto [x, y] = patch[i];
      const std::size_t at = 4 * (std::size_t{y + k / 8} * seen.width + x + k % 8);
      for (std::size_t c = 0; c < 3; ++c)
        floor[i][c] += std::to_integer<int>(seen.rgba[at + c]) / 64.0;
    }

  for (const auto& [a, b] : {std::pair{0, 1}, {1, 2}, {0, 3}, {2, 4}, {3, 5}, {4, 6}}) {
    const auto hue = [&](int room) {  // however light it is there
      const auto& [red, green, blue] = floor[static_cast<std::size_t>(room)];
      return std::array{red / green, blue / green};
    };
    const double differs =
        std::max(std::abs(hue(a)[0] - hue(b)[0]), std::abs(hue(a)[1] - hue(b)[1]));
    EXPECT_GT(differs, 0.05) << a << " and " << b;
  }
}

TEST(TheMuseumAtNight, LooksAsItWasSeenAndApproved) {
  const VisitRun run(
      "0.5 shot night-welcome.png\n1 key ENTER\n3 tap @exhibit:tripod-ding\n"
      "12 shot night-walking.png\n12.5 quit\n");
  std::ofstream(run.file("kiosk.toml")) << "theme = \"night\"\n";
  play_in_folder(run, "960x540", "--config kiosk.toml");

  for (const char* name : {"night-welcome.png", "night-walking.png"})
    expect_approved(run.file(name), name);
}

TEST(AMuseumAlone, LeavesNothingBrightWhereItIsForAMinute) {
  NEEDS_SPEED();
  constexpr int first = 63, last = 123, step = 4;
  std::string visit;
  for (int second = first; second <= last; second += step)
    visit += fmt::format("{0} shot {0}.png\n", second);
  const VisitRun run(visit + "69 shot attract.png\n124 quit\n");
  play_in_folder(run, "640x360");
  constexpr double bright = 0.25;  // of full white, in light: half of it to the eye
  std::vector<double> least, most;
  for (int second = first; second <= last; second += step) {
    const Pixels seen = picture(run.file(fmt::format("{}.png", second).c_str()));
    ASSERT_EQ(seen.width, 640U);
    least.resize(std::size_t{seen.width} * seen.height, 1);
    most.resize(least.size(), 0);
    for (std::uint32_t y = 0; y < seen.height; ++y)
      for (std::uint32_t x = 0; x < seen.width; ++x) {
        const std::size_t at = std::size_t{y} * seen.width + x;
        least[at] = std::min(least[at], luminance(seen, x, y));
        most[at] = std::max(most[at], luminance(seen, x, y));
      }
  }
  int still = 0;
  for (std::size_t i = 0; i < least.size(); ++i)
    if (least[i] > bright && most[i] < 1.2 * least[i]) ++still;

  EXPECT_EQ(still, 0) << "of " << least.size() << " pixels";
  expect_approved(run.file("attract.png"), "attract.png");
}

TEST(ASharedGlass, LooksAsItWasSeenAndApproved) {
  const VisitRun run(
      "0.5 shot quiet.png\n"
      "1 tap 0.06 0.9\n1 tap 0.2 0.9\n1 tap 0.44 0.9\n1 tap 0.56 0.9\n1 tap 0.7 0.9\n"
      "1 tap 0.82 0.9\n1 tap 0.94 0.9\n"
      "2 tap @look:rose seat 1\n2 tap @language:zh seat 2\n2 tap @look:sky seat 2\n"
      "2 tap @look:teal seat 4\n2 tap @look:plum seat 5\n2 tap @language:ar seat 6\n"
      "2 tap @look:saffron seat 6\n2 tap @look:vermilion seat 8\n"
      "5 tap @exhibit:tripod-ding seat 1\n5 tap @exhibit:glass-flask seat 2\n"
      "5 tap @exhibit:clay-letter seat 4\n5 tap @exhibit:jade-disc seat 5\n"
      "5 tap @exhibit:painted-jar seat 6\n5 tap @exhibit:boundary-stone seat 8\n"
      "8 tap @route:offset seat 5\n8 tap @route:skeleton seat 4\n"
      "19 shot visitors.png\n20 quit\n");
  std::ofstream(run.file("kiosk.toml")) << "screen_inches = 55\n";
  const std::filesystem::path here = std::filesystem::current_path();
  std::filesystem::current_path(run.file("a.visit").parent_path());
  const ProgramRun played = run.play("--config kiosk.toml", "1280x720");
  std::filesystem::current_path(here);
  ASSERT_EQ(played.exit_code, 0) << played.err;

  for (const char* name : {"quiet.png", "visitors.png"}) expect_approved(run.file(name), name);
}

/// Four visitors search, each with the keyboard of their language on their own card.
TEST(ASharedGlass, IsSearchedOnEachCard) {
  const VisitRun run(
      "1 tap 0.12 0.9\n1 tap 0.38 0.9\n1 tap 0.62 0.9\n1 tap 0.88 0.9\n"
      "2 tap @look:rose seat 1\n2 tap @language:zh seat 2\n2 tap @look:sky seat 2\n"
      "2 tap @look:teal seat 3\n2 tap @language:ar seat 4\n2 tap @look:plum seat 4\n"
      "3 tap @search seat 1\n3 tap @search seat 2\n3 tap @search seat 3\n3 tap @search seat 4\n"
      "3.5 tap @key:j seat 1\n3.7 tap @key:a seat 1\n3.9 tap @key:d seat 1\n"
      "3.5 tap @key:q seat 2\n3.7 tap @key:i seat 2\n"
      "6 shot search-cards.png\n7 quit\n");
  std::ofstream(run.file("kiosk.toml")) << "screen_inches = 55\nvisitors = 4\n";
  const std::filesystem::path here = std::filesystem::current_path();
  std::filesystem::current_path(run.file("a.visit").parent_path());
  const ProgramRun played = run.play("--config kiosk.toml", "1280x720");
  std::filesystem::current_path(here);
  ASSERT_EQ(played.exit_code, 0) << played.err;

  expect_approved(run.file("search-cards.png"), "search-cards.png");
}

}  // namespace
}  // namespace docent::test::kiosk_pictures_test
