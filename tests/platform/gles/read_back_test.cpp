#include "platform/gles/read_back.h"

#include <GLES3/gl3.h>
#include <gmock/gmock.h>

#include "platform/headless/headless_display.h"

namespace docent::gles::read_back_test {
namespace {

constexpr PixelSize size{8, 4};

/// The lower half red, the upper half blue.
void draw_two_halves(std::uint32_t framebuffer) {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glEnable(GL_SCISSOR_TEST);
  glScissor(0, 0, 8, 2);
  glClearColor(1, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glScissor(0, 2, 8, 2);
  glClearColor(0, 0, 1, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glDisable(GL_SCISSOR_TEST);
}

TEST(ReadBack, HasNothingBeforeItIsAskedAndNothingAfterItsEnd) {
  auto display = headless::open_headless(size);
  ASSERT_TRUE(display.has_value()) << display.error().what;
  ReadBack frame;

  EXPECT_TRUE(frame.take().empty());
  frame.begin((*display)->target().framebuffer, size);
  EXPECT_TRUE(frame.is_begun());
  frame.end();
  EXPECT_FALSE(frame.is_begun());
  EXPECT_TRUE(frame.take().empty());
}

TEST(ReadBack, GivesTheFrameOfItsMomentAndNoneThatWasDrawnLater) {
  auto display = headless::open_headless(size);
  ASSERT_TRUE(display.has_value()) << display.error().what;
  const std::uint32_t framebuffer = (*display)->target().framebuffer;
  ReadBack frame;
  draw_two_halves(framebuffer);
  frame.begin(framebuffer, size);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glClearColor(0, 1, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glFinish();

  const auto pixels = frame.take();

  ASSERT_EQ(pixels.size(), 4U * 8 * 4);
  EXPECT_EQ(pixels.front(), std::byte{255});  // red below
  EXPECT_EQ(pixels[2], std::byte{0});
  EXPECT_EQ(pixels[4 * 8 * 3 + 2], std::byte{255});  // blue above
  EXPECT_EQ(frame.take().data(), pixels.data());
}

}  // namespace
}  // namespace docent::gles::read_back_test
