#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "config/display_kind.h"
#include "config/located.h"

namespace docent::config {

/// What an operator may change on a device. The defaults are what a new device ships with.
struct KioskConfig {
  std::filesystem::path content = "/var/lib/docent/museum.db";
  /// At most two files of public keys. Where there are any, only databases signed with one of them
  /// are shown.
  std::vector<std::filesystem::path> keys{};
  std::string kiosk{};   ///< Which of the museum's kiosks it is. Empty: the first, or the only one.
  std::string source{};  ///< Of releases, for docent-update: a URL or a folder. Empty: none.
  std::string group{};   ///< Which releases are for this device, where they are for groups.
  std::chrono::seconds idle_reset{60};  ///< 10 to 600. Back to the welcome screen after this.
  double text_scale = 1.0;  ///< 1 to 2. Larger letters for every visitor, not only on request.
  double screen_inches =
      24;  ///< 5 to 120. The screen's diagonal, so that letters have their size on the glass.
  /// 1 to 8. How many visitors may use the glass at the same time. Not said: 1, or 8 on a screen of
  /// 42 inches and more.
  int visitors = 1;
  int rotate = 0;  ///< Degrees clockwise by which the screen hangs turned: 0, 90, 180, 270.
  DisplayKind display = DisplayKind::Auto;
  int width = 0, height = 0;  ///< Pixels, `size = "1920x1080"`. 0: what the display prefers.
};

/// Reads kiosk.toml. A file that does not exist is a device with the defaults. `content` and
/// `keys` may be relative to the file's folder.
Loaded<KioskConfig> load_kiosk_config(const std::filesystem::path& file);

}  // namespace docent::config
