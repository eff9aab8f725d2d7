#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "config/display_kind.h"
#include "config/located.h"
#include "config/weekly_hours.h"

namespace docent::config {

/// An edge of the glass, as the picture is seen that stands upright.
enum class GlassEdge : std::uint8_t { Bottom, Left, Top, Right };

/// A keypad that is listened to: `[[keypad]]`.
struct KeypadSection {
  Located<std::string> device;      ///< "04e7:0022".
  Located<std::string> descriptor;  ///< Sixteen hexadecimal figures, or nothing.
  /// By the name of a key that it sends, the name of the one that it means (input::KeyName).
  Located<LocatedTexts> keys;
  Place place;
};

/// What speech is heard from: `[sound]`.
struct SoundSection {
  Located<std::string> device;  ///< An ALSA name, "file:NAME", or "none".
  Located<double> volume;       ///< 0 to 1: the loudest that a visitor can make it.
};

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
  /// 5 to 120. The screen's diagonal, so that letters have their size on the glass. Not said: what
  /// the screen itself says, or else 24.
  std::optional<double> screen_inches;
  /// 100 to 2000. Millimetres from the floor to the lower edge of the glass. Not said: 0, and
  /// nobody can have what is touched within reach of who sits.
  int mount_height = 0;
  /// 1 to 8. How many visitors may use the glass at the same time. Not said: 1, or 8 on a screen of
  /// 42 inches and more.
  std::optional<int> visitors;
  /// At which edges of a shared glass visitors stand, as a table's: each once. Not said: below it.
  std::vector<GlassEdge> sides{};
  int rotate = 0;  ///< Degrees clockwise by which the screen hangs turned: 0, 90, 180, 270.
  DisplayKind display = DisplayKind::Auto;
  std::vector<KeypadSection> keypads;  ///< `[[keypad]]`; none: those without letters.
  /// What ALSA calls it; "file:NAME" writes a WAV file; "none" is silence. Not said: ALSA's own
  /// choice, and on a display without a screen silence.
  std::optional<std::string> sound_device;
  double sound_volume = 1;    ///< 0 to 1. The loudest that a visitor can make it.
  std::string staff_pin;      ///< What `docent pin` printed; empty: there is no staff mode.
  int width = 0, height = 0;  ///< Pixels, `size = "1920x1080"`. 0: what the display prefers.
  int refresh = 0;            ///< Hertz, `size = "1920x1080@50"`. 0: what the display prefers.
  std::string output;   ///< The connector to draw on, "HDMI-A-1". Empty: the first connected one.
  bool mirror = false;  ///< The same picture on every connected screen.
  bool reduced_motion = false;  ///< Nothing moves but the guide on its way.
  double same_key_delay = 0;    ///< 0 to 2. Seconds during which the same key does nothing.
  bool pixel_shift = false;     ///< The picture wanders by a few pixels, against burning in.
  std::optional<WeeklyHours> screen_on;  ///< When the screen is lit. Not said: always.
  bool is_night = false;                 ///< `theme = "night"`: light letters on dark paper.
  std::optional<WeeklyHours> night;      ///< When the theme is "night" whatever it is otherwise.
};

/// The diagonal in inches, given what the screen says of itself.
double screen_inches(const KioskConfig& config, std::optional<double> said_by_screen) noexcept;
/// How many visitors may use a glass of this diagonal.
int visitors(const KioskConfig& config, double inches) noexcept;

/// Reads kiosk.toml. A file that does not exist is a device with the defaults. `content` and
/// `keys` may be relative to the file's folder.
Loaded<KioskConfig> load_kiosk_config(const std::filesystem::path& file);

}  // namespace docent::config
