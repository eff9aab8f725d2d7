#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace docent {

struct PixelSize {
  std::uint32_t width = 0, height = 0;
  bool operator==(const PixelSize&) const = default;
};

/// How the framebuffer stores colours.
enum class Encoding : std::uint8_t {
  Srgb,   ///< It encodes linear colours itself and blends in linear light.
  Plain,  ///< It keeps what it is given: the window system's own framebuffers.
};

/// How far the panel is turned clockwise as it is mounted.
enum class Rotation : std::uint8_t { None, Quarter, Half, ThreeQuarters };

/// Where the renderer draws a frame. `size` is what the visitor sees, after rotation. A display
/// says how its panel is built in; how it hangs comes on top of that.
struct RenderTarget {
  std::uint32_t framebuffer = 0;  ///< Its OpenGL name; 0 is the window's own.
  PixelSize size;
  Encoding encoding = Encoding::Plain;
  Rotation rotation = Rotation::None;  ///< Only of a Plain target.
  /// Pixels, as the visitor sees it, by which the picture is shifted to the right and down. Only of
  /// a Plain target; the picture's edge fills what is left free.
  std::int32_t shift_x = 0, shift_y = 0;
  bool operator==(const RenderTarget&) const = default;
};

/// Does a display take another frame?
enum class DisplayState : std::uint8_t {
  Open,
  Closed,  ///< Its window was closed by a person.
  Lost,    ///< What it draws on has gone: the X server, the graphics card.
};

/// Where frames go: a screen, a window, or memory. Its OpenGL context is current on the thread that
/// made the display, and only that thread may call the display.
class Display {
 public:
  Display() = default;
  Display(const Display&) = delete;
  Display& operator=(const Display&) = delete;
  virtual ~Display() = default;

  /// Waits until the last frame is shown and the next may be drawn; where none was drawn since, for
  /// the time of the next. While can_show() is false it returns about ten times a second.
  virtual DisplayState wait_for_page_flip() noexcept = 0;
  /// May a frame be drawn now? Not while there is no screen, while it is turned off or while
  /// another program has it.
  virtual bool can_show() const noexcept { return true; }
  /// Has the last frame been lost, so that it has to be drawn again though nothing changed?
  virtual bool wants_frame() const noexcept { return false; }
  /// Did the frame that was presented last get onto the screen? Something else may have happened
  /// since for which it has to be drawn again.
  virtual bool has_shown() const noexcept { return !wants_frame(); }
  /// Where to draw the next frame; ask again each frame, since a window may have been resized.
  virtual RenderTarget target() const noexcept = 0;
  /// What is drawn next is drawn over the picture that was presented so many times ago: 1 is the
  /// last one. 0: over nothing that is known. Ask before anything of it is drawn.
  virtual std::uint32_t age() const noexcept { return 0; }
  /// Shows what was drawn: queues the next page flip.
  virtual void present() noexcept = 0;
  /// Turns the screen on or off, where it can be.
  virtual void light(bool /*is_wanted*/) noexcept {}
  /// As the screen says; none where it says nothing that can be believed.
  virtual std::optional<double> diagonal_inches() const noexcept { return std::nullopt; }

  /// What it is, for the journal: "a window of 1920 x 1080 pixels".
  virtual std::string description() const = 0;
  /// What was lost, as a sentence for the journal.
  virtual std::string_view loss() const noexcept { return {}; }

  // These two are for a thread that watches over the frame thread, while present() waits.
  /// Has what it draws on gone? A driver may then wait without end.
  virtual bool is_lost() const noexcept { return false; }
  /// Gives back what would outlive the program, which ends right afterwards.
  virtual void abandon() noexcept {}
};

}  // namespace docent
