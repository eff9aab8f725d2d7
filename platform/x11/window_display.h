#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "platform/display.h"
#include "runtime/input/contact.h"
#include "runtime/model/result.h"

namespace docent::x11 {

/// A window on an X11 desktop, for development: the mouse stands in for a finger, the keyboard for
/// the keypad.
class WindowDisplay : public Display {
 public:
  /// Writes what mouse and keyboard did since the last call, oldest first, and returns how many.
  /// Screen frame of the window. Does not allocate.
  virtual std::size_t arrived(std::span<input::InputEvent> out) noexcept = 0;
};

/// Opens a window of this size on $DISPLAY and makes its OpenGL context current on this thread.
/// Fails with a sentence where there is no X server, or none that EGL can draw to.
Result<std::unique_ptr<WindowDisplay>> open_window(PixelSize size);

}  // namespace docent::x11
