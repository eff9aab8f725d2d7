#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "config/kiosk_config.h"
#include "platform/headless/headless_display.h"
#include "platform/hid/input_devices.h"
#include "platform/kms/kms_display.h"
#include "platform/x11/window_display.h"
#include "runtime/kiosk/options.h"
#include "runtime/kiosk/pixel_shift.h"
#include "runtime/model/result.h"

namespace docent::kiosk {

/// The screen and the input devices. `headless` or `window` points to `display` where it is one of
/// those.
struct Edges {
  std::unique_ptr<Display> display;
  headless::HeadlessDisplay* headless = nullptr;
  x11::WindowDisplay* window = nullptr;
  std::optional<hid::InputDevices> devices;
  Rotation rotation = Rotation::None;
  PixelOffset shift;  ///< Of the picture, as the visitor sees it.

  /// Is it neither memory nor a window among others?
  bool is_own_screen() const noexcept { return headless == nullptr && window == nullptr; }
};

/// What was asked for; the command line overrides kiosk.toml.
struct EdgeSettings {
  config::DisplayKind kind = config::DisplayKind::Auto;
  PixelSize size;                ///< 0 by 0: what the display prefers.
  std::uint32_t refresh_hz = 0;  ///< 0: what the display prefers.
  std::string output;            ///< The connector to draw on; empty: the first connected.
  bool mirror = false;
  Rotation rotation = Rotation::None;
  std::vector<std::string> hid;
  std::vector<input::NamedKeypad> keypads;  ///< Those that staff have named.
  /// A picture of this size to show until the first frame; for a screen of the kiosk's own.
  kms::FindPoster find_poster;
};

/// The command line over kiosk.toml.
EdgeSettings edge_settings(const Options& options, const config::KioskConfig& config);

/// Auto takes KMS on a free console, a window where there is a desktop, else memory. Fails with a
/// sentence where a display or a given device cannot be opened.
Result<Edges> open_edges(const EdgeSettings& settings);

/// Where and how the next frame is drawn: the display's own target, turned and shifted.
RenderTarget target_of(const Edges& edges) noexcept;

/// Writes the events since the last call, in the visitor's screen frame; returns how many.
std::size_t arrived(Edges& edges, std::span<input::InputEvent> out) noexcept;

/// A contact in the frame of the display as it is mounted, turned to the visitor's screen frame.
input::Contact turned(input::Contact contact, Rotation rotation) noexcept;
/// A contact on the glass, in the frame of the picture that is shifted on it.
input::Contact shifted_back(input::Contact contact, const RenderTarget& target) noexcept;

}  // namespace docent::kiosk
