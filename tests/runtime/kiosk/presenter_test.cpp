#include <GLES3/gl3.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "platform/gles/panel_pass.h"
#include "platform/gles/renderer.h"
#include "platform/headless/headless_display.h"
#include "runtime/kiosk/exhibition.h"
#include "runtime/scene/shown_list.h"
#include "tests/support/sample_database.h"
#include "tests/support/sanitized.h"

namespace docent::kiosk::presenter_test {
namespace {

constexpr PixelSize small{480, 270};

/// A screen whose buffers take turns, as those of a graphics card do. Each has been filled with
/// nonsense.
class Panel {
 public:
  explicit Panel(const RenderTarget& target) : target_(target), size_(gles::panel_size(target)) {
    glGenFramebuffers(1, &target_.framebuffer);
    glGenRenderbuffers(buffers, pixels_.data());
    for (std::uint32_t i = 0; i < buffers; ++i) {
      glBindRenderbuffer(GL_RENDERBUFFER, pixels_[i]);
      glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, static_cast<GLsizei>(size_.width),
                            static_cast<GLsizei>(size_.height));
      flip();
      glClearColor(1, 0, 1, 1);
      glClear(GL_COLOR_BUFFER_BIT);
    }
    frames_ = 0;
  }
  Panel(const Panel&) = delete;
  Panel& operator=(const Panel&) = delete;
  ~Panel() {
    glDeleteRenderbuffers(buffers, pixels_.data());
    glDeleteFramebuffers(1, &target_.framebuffer);
  }

  const RenderTarget& target() const { return target_; }
  std::uint32_t age() const { return frames_ < buffers ? 0 : buffers; }
  void flip() {
    ++frames_;
    glBindFramebuffer(GL_FRAMEBUFFER, target_.framebuffer);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                              pixels_[frames_ % buffers]);
  }
  std::vector<std::uint8_t> pixels() const {
    std::vector<std::uint8_t> rgba(std::size_t{4} * size_.width * size_.height);
    glBindFramebuffer(GL_FRAMEBUFFER, target_.framebuffer);
    glReadPixels(0, 0, static_cast<GLsizei>(size_.width), static_cast<GLsizei>(size_.height),
                 GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    return rgba;
  }

 private:
  static constexpr std::uint32_t buffers = 3;
  RenderTarget target_;
  PixelSize size_;
  std::array<GLuint, buffers> pixels_{};
  std::uint32_t frames_ = 0;
};

/// A visit whose frames are drawn twice: as far as they differ from the one before, and all of
/// them.
class DrawnTwice {
 public:
  DrawnTwice() {
    auto display = headless::open_headless(small);
    const gles::RendererOptions few_rows{.buffer_bytes = 1};  // 64 at a time
    auto in_parts = gles::make_renderer(few_rows), whole = gles::make_renderer(few_rows);
    auto exhibition = load_exhibition(test::sample_database(), {.is_simulated = true},
                                      {.shape = {.width = small.width, .height = small.height}});
    if (!display || !in_parts || !whole || !exhibition) throw std::runtime_error("cannot draw");
    display_ = std::move(*display);
    in_parts_.emplace(std::move(*in_parts));
    whole_.emplace(std::move(*whole));
    exhibition_ = std::move(*exhibition);
    upload(*exhibition_);
    // A window's framebuffer, which keeps nothing: what was drawn before is the renderer's own.
    target_ = display_->target();
    target_.encoding = Encoding::Plain;
  }

  void run(double seconds) {
    for (int frame = 0; frame < std::lround(60 * seconds); ++frame) {
      exhibition_->planner->wait();
      exhibition_->guide->step(guide::Seconds{1.0F / 60});
      if (apply_pieces(*exhibition_)) shown_.forget();
    }
  }

  /// The exhibit's picture on the glass; None: there is none.
  scene::TextureId picture() const {
    for (const interface::Element& element : exhibition_->guide->view()->elements)
      if (element.quad.fill == scene::QuadFill::Image) return element.quad.texture;
    return scene::TextureId::None;
  }

  /// Draws some frames that are a twentieth of a second apart. `played`: has another content in
  /// each of them.
  void watch(int frames, const char* what, scene::TextureId played = scene::TextureId::None) {
    for (int frame = 0; frame < frames; ++frame) {
      run(0.05);
      const scene::DrawList& list = exhibition_->guide->draw_list();
      shown_.forget(played);
      const scene::Change change = shown_.change(list, std::numeric_limits<float>::infinity());
      parts_ += change.everything || change.model ? 0 : 1;
      whole_->draw(list, exhibition_->holdings, target_);
      const auto expected = pixels();
      in_parts_->draw(list, exhibition_->holdings, target_, change);
      shown_.keep(list, change);
      EXPECT_EQ(differing(pixels(), expected), 0) << what << ", frame " << frame;
    }
  }

  /// Draws a list coarsely, and then as often as it takes until nothing of it is coarse: how often
  /// that is.
  int refine(const char* what) {
    const scene::DrawList list = exhibition_->guide->draw_list();
    in_parts_->draw(list, exhibition_->holdings, target_, {}, 0.5F);
    shown_.keep(list, {});
    const auto coarse = pixels();
    int frames = 0;
    for (; in_parts_->is_coarse() && frames < 1000; ++frames)
      in_parts_->draw(list, exhibition_->holdings, target_, {.everything = false});
    const auto refined = pixels();
    whole_->draw(list, exhibition_->holdings, target_);
    EXPECT_EQ(differing(refined, pixels()), 0) << what;
    EXPECT_GT(differing(coarse, refined), 1000) << what;
    return frames;
  }

  /// The same while the picture goes on.
  void refine_among_others(int frames, const char* what) {
    run(0.05);
    scene::DrawList list = exhibition_->guide->draw_list();
    in_parts_->draw(list, exhibition_->holdings, target_, {}, 0.75F);
    shown_.keep(list, {});
    for (int frame = 0; frame < frames; ++frame) {
      run(0.05);
      list = exhibition_->guide->draw_list();
      const scene::Change change = shown_.change(list, std::numeric_limits<float>::infinity());
      ASSERT_FALSE(change.everything || change.model) << what << ", frame " << frame;
      in_parts_->draw(list, exhibition_->holdings, target_, change, 0.75F);
      shown_.keep(list, change);
    }
    EXPECT_FALSE(in_parts_->is_coarse()) << what;
    const auto refined = pixels();
    whole_->draw(list, exhibition_->holdings, target_);
    EXPECT_EQ(differing(refined, pixels()), 0) << what;
  }

  void touch(const std::string& name) {
    const interface::Control* at = nullptr;
    for (const interface::Control& control : exhibition_->guide->view()->controls)
      if (control.name == name && control.rect.width > 0) at = &control;
    if (at == nullptr) throw std::runtime_error(name + " is not on the glass");
    const input::Contact finger{1, at->rect.x + at->rect.width / 2,
                                at->rect.y + at->rect.height / 2};
    for (const auto kind : {input::InputEvent::Kind::Down, input::InputEvent::Kind::Up}) {
      exhibition_->guide->touch({.kind = kind, .contact = finger});
      run(1.0 / 60);
    }
  }

  /// Does a recorded picture show nothing of what would be behind it?
  bool is_opaque() {
    whole_->draw(exhibition_->guide->draw_list(), exhibition_->holdings, display_->target());
    Pixels picture;
    display_->read_back(picture);
    for (std::size_t i = 3; i < picture.rgba.size(); i += 4)
      if (picture.rgba[i] != std::byte{255}) return false;
    return !picture.rgba.empty();
  }

  bool has_arrived() const { return exhibition_->guide->state().arrived; }
  /// The same on a screen that is turned and shifted, and whose buffers are of three frames ago:
  /// each is copied what it lacks.
  void watch_on_panel(int frames, Rotation rotation, int shift_x, int shift_y, const char* what) {
    RenderTarget target = target_;
    target.rotation = rotation;
    target.shift_x = shift_x;
    target.shift_y = shift_y;
    Panel panel(target), as_a_whole(target);
    shown_ = {};
    for (int frame = 0; frame < frames; ++frame) {
      run(0.05);
      const scene::DrawList& list = exhibition_->guide->draw_list();
      const scene::Change change = shown_.change(list, std::numeric_limits<float>::infinity());
      whole_->draw(list, exhibition_->holdings, as_a_whole.target());
      in_parts_->draw(list, exhibition_->holdings, panel.target(), change, 1, panel.age());
      shown_.keep(list, change);
      EXPECT_EQ(differing(panel.pixels(), as_a_whole.pixels()), 0) << what << ", frame " << frame;
      panel.flip();
    }
  }

  /// Of twelve frames four are drawn coarsely, seven while nothing moves, one as finely as ever.
  /// What a screen shows is what the picture would be in memory.
  void watch_coarsely(int frames, Rotation rotation, int shift_x, int shift_y, const char* what) {
    RenderTarget target = target_;
    target.rotation = rotation;
    target.shift_x = shift_x;
    target.shift_y = shift_y;
    Panel panel(target);
    for (int frame = 0; frame < frames; ++frame) {
      const int of_twelve = frame % 12;
      if (of_twelve < 4 || of_twelve > 10) run(0.05);
      const scene::DrawList& list = exhibition_->guide->draw_list();
      scene::Change change = shown_.change(list, std::numeric_limits<float>::infinity());
      if (frame == 0) change = {};
      const float fineness = of_twelve == 11 ? 1 : 0.4F;
      whole_->draw(list, exhibition_->holdings, display_->target(), change, fineness);
      glBindFramebuffer(GL_FRAMEBUFFER, display_->target().framebuffer);
      const auto expected = pixels();
      in_parts_->draw(list, exhibition_->holdings, panel.target(), change, fineness, panel.age());
      shown_.keep(list, change);
      EXPECT_EQ(in_parts_->is_coarse(), whole_->is_coarse());
      EXPECT_EQ(differing(panel.pixels(), panel.target(), expected), 0)
          << what << ", frame " << frame;
      panel.flip();
    }
  }

  int parts() const { return parts_; }

 private:
  static std::vector<std::uint8_t> pixels() {
    std::vector<std::uint8_t> rgba(std::size_t{4} * small.width * small.height);
    glReadPixels(0, 0, small.width, small.height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    return rgba;
  }

  /// How many bytes differ.
  static int differing(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    int count = 0;
    for (std::size_t i = 0; i < a.size(); ++i) count += a[i] != b[i] ? 1 : 0;
    return count;
  }

  /// How many pixels of a panel are not those of the picture; what a shift draws out of its edge
  /// does not count.
  static int differing(const std::vector<std::uint8_t>& panel, const RenderTarget& target,
                       const std::vector<std::uint8_t>& picture) {
    const PixelSize size = gles::panel_size(target);
    int count = 0;
    for (std::uint32_t y = 0; y < size.height; ++y)
      for (std::uint32_t x = 0; x < size.width; ++x) {
        Vec2 p{(x + 0.5) / size.width - 0.5, (y + 0.5) / size.height - 0.5};
        for (int turn = 0; turn < static_cast<int>(target.rotation); ++turn) p = {p.y, -p.x};
        const int left = static_cast<int>((p.x + 0.5) * target.size.width) - target.shift_x;
        const int low = static_cast<int>((p.y + 0.5) * target.size.height) + target.shift_y;
        const int width = static_cast<int>(target.size.width);
        if (left < 0 || left >= width || low < 0 || low >= static_cast<int>(target.size.height))
          continue;
        const auto* from = &picture[std::size_t{4} * static_cast<std::size_t>(low * width + left)];
        const auto* to = &panel[std::size_t{4} * (std::size_t{y} * size.width + x)];
        count += std::equal(from, from + 3, to) ? 0 : 1;
      }
    return count;
  }

  std::unique_ptr<headless::HeadlessDisplay> display_;
  std::optional<gles::Renderer> in_parts_, whole_;
  std::unique_ptr<Exhibition> exhibition_;
  RenderTarget target_;
  scene::ShownList shown_;
  int parts_ = 0;
};

/// What is drawn coarsely while the camera moves is as fine as ever soon after.
TEST(ACoarsePicture, BecomesTheOneThatIsDrawnWholeAFewRowsAtATime) {
  DrawnTwice visit;

  visit.run(1);
  EXPECT_EQ(visit.refine("welcome"), 5) << "of 270 rows";
  visit.touch("begin");
  visit.run(3);
  visit.touch("exhibit:standing-king");  // a board: things sway, and are drawn anew
  visit.run(1.5);
  visit.refine("the whole way");
  for (int second = 0; second < 120 && !visit.has_arrived(); ++second) visit.run(1);
  visit.run(4);
  visit.refine_among_others(12, "arrived");
}

/// A screen that is turned; the pixels move now and then so that none burns in.
TEST(AScreenWhoseBuffersTakeTurns, IsGivenWhatItsBufferLacks) {
  NEEDS_SPEED();
  DrawnTwice visit;

  visit.run(1);
  visit.watch_on_panel(8, Rotation::None, 0, 0, "welcome");
  visit.watch_on_panel(8, Rotation::Quarter, 2, -1, "welcome, turned");
  visit.touch("begin");
  visit.run(3);
  visit.watch_on_panel(8, Rotation::Half, -2, 2, "choosing, upside down");
  visit.touch("exhibit:fish-mosaic");
  visit.run(1.5);
  visit.watch_on_panel(12, Rotation::ThreeQuarters, 0, 3, "the whole way, turned back");
  visit.touch("walk");
  visit.watch_on_panel(8, Rotation::None, 3, 3, "walking, shifted");
}

/// Where the model is enlarged straight onto the screen, and the picture behind it lacks it.
TEST(AScreenWhoseBuffersTakeTurns, ShowsACoarsePictureAsMemoryDoes) {
  NEEDS_SPEED();
  DrawnTwice visit;

  visit.run(1);
  visit.touch("begin");
  visit.run(3);
  visit.touch("exhibit:painted-jar");
  visit.run(1.5);
  visit.touch("walk");
  visit.run(1);
  visit.watch_coarsely(28, Rotation::None, 0, 0, "walking");
  visit.watch_coarsely(14, Rotation::Quarter, 2, -1, "walking, turned");
  visit.watch_coarsely(14, Rotation::Half, -2, 2, "walking, upside down");
  visit.watch_coarsely(14, Rotation::ThreeQuarters, 0, 3, "walking, turned back");
  for (int second = 0; second < 120 && !visit.has_arrived(); ++second) visit.run(1);
  ASSERT_TRUE(visit.has_arrived());
  visit.watch_coarsely(28, Rotation::None, 0, 0, "arrived");
}

TEST(APicture, IsOpaqueWhereTheInterfaceCoversTheModel) {
  DrawnTwice visit;

  visit.run(1);

  EXPECT_TRUE(visit.is_opaque());
}

TEST(APartDrawnAnew, LeavesThePictureThatIsDrawnWhole) {
  NEEDS_SPEED();
  DrawnTwice visit;

  visit.run(1);
  visit.watch(8, "welcome");
  visit.touch("begin");
  visit.run(3);
  visit.watch(8, "choosing");
  visit.touch("exhibit:fish-mosaic");
  visit.run(1.5);
  visit.watch(20, "the whole way");
  visit.touch("walk");
  visit.watch(8, "walking");
  for (int second = 0; second < 120 && !visit.has_arrived(); ++second) visit.run(1);
  ASSERT_TRUE(visit.has_arrived());
  visit.run(4);
  visit.watch(20, "arrived");
  ASSERT_NE(visit.picture(), scene::TextureId::None);
  visit.watch(20, "beside a guide who breathes, a picture plays", visit.picture());

  EXPECT_GT(visit.parts(), 60);
}

}  // namespace
}  // namespace docent::kiosk::presenter_test
