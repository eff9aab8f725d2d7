#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "platform/file/file_stamp.h"
#include "platform/gles/renderer.h"
#include "runtime/interface/text.h"
#include "runtime/kiosk/edges.h"
#include "runtime/kiosk/exhibition.h"
#include "runtime/kiosk/service_notice.h"
#include "runtime/model/result.h"
#include "runtime/scene/draw_list.h"

namespace docent::kiosk {

/// What a kiosk shows that has no museum: why, and what to do. For whoever sets it up, in English.
class SetupScreen {
 public:
  /// Sets its texts for a screen of this size and carries them into texture memory. `why`: the
  /// sentence about the database that cannot be shown. Docent's own colours, by night its dark
  /// ones.
  SetupScreen(const interface::SetText& set_text, PixelSize size, std::string_view why,
              bool is_night);

  void draw(gles::Renderer& renderer, const RenderTarget& target) const noexcept {
    renderer.draw(list_, holdings_, target);
  }

 private:
  gles::Holdings holdings_;
  scene::DrawList list_;
};

/// Notices that a file was put in place, replaced or changed since it was last asked.
class FileWatch {
 public:
  explicit FileWatch(std::filesystem::path file)
      : file_(std::move(file)), known_(file::stamp_of(file_)) {}
  bool has_changed() noexcept {
    const file::FileStamp now = file::stamp_of(file_);
    return std::exchange(known_, now) != now;
  }

 private:
  std::filesystem::path file_;
  file::FileStamp known_;
};

/// Shows the setup screen until the database can be shown, which is looked for twice a second, or
/// until the program is told to end, with nothing then. `why`: why it cannot be shown yet; each new
/// reason is told the journal once. `is_night`: is it to be dark just now? For the service manager
/// this is a kiosk that works. Fails where the display is lost.
Result<std::unique_ptr<Exhibition>> wait_for_content(
    Edges& edges, gles::Renderer& renderer, ServiceNotice& notice,
    const std::filesystem::path& database, Error why, const std::function<bool()>& is_night,
    const std::function<Result<std::unique_ptr<Exhibition>>()>& load);

}  // namespace docent::kiosk
