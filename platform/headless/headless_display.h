#pragma once

#include <memory>
#include <span>
#include <vector>

#include "platform/display.h"
#include "platform/image/image.h"
#include "runtime/model/result.h"

namespace docent::headless {

/// A display in memory: nothing is shown, frames can be read back. It never waits.
class HeadlessDisplay : public Display {
 public:
  /// The last frame drawn, rows from the top.
  virtual void read_back(Pixels& picture) const = 0;
};

/// Opens EGL without any surface and makes its context current on this thread. Fails with a
/// sentence where there is no such EGL, or where no framebuffer of this size can be made.
Result<std::unique_ptr<HeadlessDisplay>> open_headless(PixelSize size);

}  // namespace docent::headless
