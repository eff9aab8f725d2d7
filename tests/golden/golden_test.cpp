#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "platform/png/image.h"
#include "tests/support/sample_database.h"
#include "tests/support/temporary_folder.h"

namespace docent {
namespace {

/// How far a picture may be from the golden one. Software drivers of different versions and
/// processors round shading and blending differently: one or two steps of 255 nearly everywhere,
/// and more only along edges, where a sample falls to the other side. Any change of layout, text,
/// colour or pose moves far more pixels than these.
constexpr double most_mean_difference = 2.0;  ///< Steps of 255, over all channels.
constexpr int visible_difference = 32;        ///< Steps of 255 of one channel.
constexpr double most_visible_share = 0.015;  ///< Of the pixels: edges.

struct Difference {
  double mean = 0;           ///< Steps of 255.
  double visible_share = 0;  ///< Of the pixels.
};

Difference difference(const Pixels& a, const Pixels& b) {
  std::uint64_t sum = 0, visible = 0;
  const std::size_t pixels = a.rgba.size() / 4;
  for (std::size_t i = 0; i < pixels; ++i) {
    int worst = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const int off = std::abs(std::to_integer<int>(a.rgba[4 * i + c]) -
                               std::to_integer<int>(b.rgba[4 * i + c]));
      sum += static_cast<std::uint64_t>(off);
      worst = std::max(worst, off);
    }
    visible += worst > visible_difference ? 1 : 0;
  }
  return {static_cast<double>(sum) / static_cast<double>(3 * pixels),
          static_cast<double>(visible) / static_cast<double>(pixels)};
}

Pixels read_picture(const std::filesystem::path& file) {
  const std::string bytes = test::text_of(file);
  Result<Pixels> picture = decode_image(std::as_bytes(std::span(bytes)));
  EXPECT_TRUE(picture.has_value()) << file << ": " << (picture ? "" : picture.error().what);
  return picture.value_or(Pixels{});
}

TEST(HeadlessDisplay, ShowsTheGoldenPictures) {
  const test::TemporaryFolder folder;
  const std::filesystem::path golden = test::source_dir() / "tests/golden";
  std::ofstream visit(folder.path() / "golden.visit");
  std::ifstream script(golden / "golden.visit");
  for (std::string line; std::getline(script, line);) {
    const std::size_t shot = line.find("shot ");  // pictures go into this test's folder
    if (shot != std::string::npos) line.insert(shot + 5, folder.path().string() + "/");
    visit << line << '\n';
  }
  visit.close();

  const auto run = test::run_program("docent", "--display headless --size 480x270 --content '" +
                                                   test::sample_database().string() +
                                                   "' --config none.toml --visit '" +
                                                   (folder.path() / "golden.visit").string() + "'");

  ASSERT_EQ(run.exit_code, 0) << run.err;
  for (const char* name : {"welcome.png", "choosing.png", "walking.png", "arrived.png"}) {
    const Pixels wanted = read_picture(golden / name), drawn = read_picture(folder.path() / name);
    ASSERT_EQ(drawn.width, wanted.width) << name;
    ASSERT_EQ(drawn.height, wanted.height) << name;
    const Difference off = difference(drawn, wanted);
    EXPECT_LE(off.mean, most_mean_difference) << name;
    EXPECT_LE(off.visible_share, most_visible_share) << name;
  }
}

TEST(Difference, IsLargeWhereAPanelMoved) {
  const Pixels choosing = read_picture(test::source_dir() / "tests/golden/choosing.png");
  const Pixels welcome = read_picture(test::source_dir() / "tests/golden/welcome.png");

  EXPECT_GT(difference(choosing, welcome).visible_share, 3 * most_visible_share);
}

}  // namespace
}  // namespace docent
