#include "runtime/kiosk/poster.h"

#include <GLES3/gl3.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <thread>

#include "platform/headless/headless_display.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace docent::kiosk::poster_test {
namespace {

constexpr PixelSize size{8, 6};

/// A screen in memory whose upper half is blue and lower half red.
std::unique_ptr<headless::HeadlessDisplay> drawn_screen() {
  auto display = headless::open_headless(size);
  if (!display) return nullptr;
  glBindFramebuffer(GL_FRAMEBUFFER, (*display)->target().framebuffer);
  glEnable(GL_SCISSOR_TEST);
  glScissor(0, 0, 8, 3);
  glClearColor(1, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glScissor(0, 3, 8, 3);
  glClearColor(0, 0, 1, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glDisable(GL_SCISSOR_TEST);
  return std::move(*display);
}

/// Keeps what is drawn as the frames of a second would.
void keep(const PosterFile& file, const headless::HeadlessDisplay& screen, bool is_welcome) {
  PosterKeeper keeper(file, false);
  for (int frame = 0; frame < 60; ++frame) {
    keeper.drawn(is_welcome, screen.target());
    glFinish();
    keeper.step();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

TEST(APoster, IsThePictureThatWasDrawn) {
  const test::TemporaryFolder folder;
  const PosterFile file{folder.path(), "a key"};
  const auto screen = drawn_screen();
  ASSERT_NE(screen, nullptr);

  keep(file, *screen, true);
  const auto picture = load_poster(file, size);

  ASSERT_TRUE(picture.has_value());
  EXPECT_EQ(picture->rgba[2], std::byte{255});              // blue above
  EXPECT_EQ(picture->rgba[4 * 8 * 5 + 0], std::byte{255});  // red below
  EXPECT_EQ(picture->rgba[3], std::byte{255});
}

TEST(APoster, IsNoneOfSomebodysVisit) {
  const test::TemporaryFolder folder;
  const PosterFile file{folder.path(), "a key"};
  const auto screen = drawn_screen();
  ASSERT_NE(screen, nullptr);

  keep(file, *screen, false);

  EXPECT_FALSE(load_poster(file, size).has_value());
}

TEST(APoster, IsNoneForAnotherScreenOrOfAnotherMuseum) {
  const test::TemporaryFolder folder;
  const PosterFile file{folder.path(), "a key"};
  const auto screen = drawn_screen();
  ASSERT_NE(screen, nullptr);
  keep(file, *screen, true);

  EXPECT_FALSE(load_poster(file, {8, 7}).has_value());
  EXPECT_FALSE(load_poster({folder.path(), "another key"}, size).has_value());
  EXPECT_FALSE(load_poster({folder.path(), "a ke"}, size).has_value());
  EXPECT_FALSE(load_poster({}, size).has_value());
  EXPECT_TRUE(load_poster(file, size).has_value());
}

TEST(APoster, ThatIsCutShortIsNoneUnlessAllItsPixelsAreThere) {
  const test::TemporaryFolder folder;
  const PosterFile file{folder.path(), "a key"};
  const auto screen = drawn_screen();
  ASSERT_NE(screen, nullptr);
  keep(file, *screen, true);
  const auto path = folder.path() / "welcome.poster";
  const std::string whole = test::text_of(path);
  const auto picture = load_poster(file, size);
  ASSERT_TRUE(picture.has_value());

  for (std::size_t bytes = 0; bytes < whole.size(); ++bytes) {
    std::ofstream(path, std::ios::binary) << whole.substr(0, bytes);
    const auto cut = load_poster(file, size);
    EXPECT_TRUE(!cut || cut->rgba == picture->rgba) << bytes;
    EXPECT_FALSE(cut && bytes < whole.size() / 2) << bytes;
  }
}

TEST(APoster, ThatIsKeptIsNotDrawnAgain) {
  const test::TemporaryFolder folder;
  const PosterFile file{folder.path(), "a key"};
  const auto screen = drawn_screen();
  ASSERT_NE(screen, nullptr);
  {
    PosterKeeper keeper(file, true);
    keeper.drawn(true, screen->target());
    keeper.step();
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(APosterFile, HasAnotherKeyOnceContentOrSettingsAreOthers) {
  const test::TemporaryFolder folder;
  const auto database = folder.path() / "museum.db", settings = folder.path() / "kiosk.toml";
  unsetenv("CACHE_DIRECTORY");
  std::ofstream(database) << "content";
  EXPECT_TRUE(poster_file(database, settings, Rotation::None).folder.empty());
  setenv("CACHE_DIRECTORY", folder.path().c_str(), 1);

  const PosterFile first = poster_file(database, settings, Rotation::None);
  EXPECT_EQ(first.folder, folder.path());
  EXPECT_EQ(poster_file(database, settings, Rotation::None).key, first.key);
  EXPECT_NE(poster_file(database, settings, Rotation::Half).key, first.key);
  std::ofstream(settings) << "rotate = 90\n";
  const PosterFile second = poster_file(database, settings, Rotation::None);
  EXPECT_NE(second.key, first.key);
  std::ofstream(database) << "new content";
  EXPECT_NE(poster_file(database, settings, Rotation::None).key, second.key);
  EXPECT_TRUE(poster_file(folder.path() / "none.db", settings, Rotation::None).folder.empty());
  unsetenv("CACHE_DIRECTORY");
}

}  // namespace
}  // namespace docent::kiosk::poster_test
