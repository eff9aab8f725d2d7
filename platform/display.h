#pragma once

#include <cstdint>
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

/// Where the renderer draws a frame. `size` is what the visitor sees, after rotation.
struct RenderTarget {
  std::uint32_t framebuffer = 0;  ///< Its OpenGL name; 0 is the window's own.
  PixelSize size;
  Encoding encoding = Encoding::Plain;
  Rotation rotation = Rotation::None;  ///< Only of a Plain target.
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

  /// Waits until the last frame is shown and the next may be drawn.
  virtual DisplayState wait_for_page_flip() noexcept = 0;
  /// Where to draw the next frame; ask again each frame, since a window may have been resized.
  virtual RenderTarget target() const noexcept = 0;
  /// Shows what was drawn: queues the next page flip.
  virtual void present() noexcept = 0;

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
