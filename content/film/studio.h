#pragma once

#include <memory>

#include "platform/gles/holdings.h"
#include "platform/gles/renderer.h"
#include "platform/headless/headless_display.h"
#include "runtime/model/museum.h"
#include "runtime/model/pixels.h"
#include "runtime/model/result.h"
#include "runtime/scene/draw_list.h"

namespace docent::film {

/// Where pictures of a museum's model are taken: a display in memory, the kiosk's renderer, and the
/// museum's buildings and bodies in texture memory. Used and destroyed on the thread that opened
/// it.
class Studio {
 public:
  /// Draws a list and gives what it shows.
  [[nodiscard]] Pixels take(const scene::DrawList& list);
  [[nodiscard]] float aspect() const noexcept;

 private:
  friend Result<Studio> open_studio(const Museum& museum, PixelSize size);
  Studio(std::unique_ptr<headless::HeadlessDisplay> display, gles::Renderer renderer);
  void furnish(const Museum& museum);

  std::unique_ptr<headless::HeadlessDisplay> display_;  // first: its context outlives the others
  gles::Renderer renderer_;
  gles::Holdings holdings_;
};

/// Opens a studio for pictures of such a size. Fails with a sentence where this machine has nothing
/// to draw with.
Result<Studio> open_studio(const Museum& museum, PixelSize size);

}  // namespace docent::film
