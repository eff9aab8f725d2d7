#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "platform/headless/headless_display.h"
#include "platform/hid/input_devices.h"
#include "platform/x11/window_display.h"
#include "runtime/kiosk/options.h"
#include "runtime/model/result.h"

namespace docent::kiosk {

/// The screen and the glass, whichever they are. `headless` and `window` point into `display` where
/// it is one of those.
struct Edges {
  std::unique_ptr<Display> display;
  headless::HeadlessDisplay* headless = nullptr;
  x11::WindowDisplay* window = nullptr;
  std::optional<hid::InputDevices> devices;
  Rotation rotation = Rotation::None;
};

/// What was asked for, command line before kiosk.toml.
struct EdgeSettings {
  config::DisplayKind kind = config::DisplayKind::Auto;
  PixelSize size;  ///< 0 by 0: what the display prefers.
  Rotation rotation = Rotation::None;
  std::vector<std::string> hid;
};

/// Auto takes KMS on a free console, a window where there is a desktop, else memory. Fails with a
/// sentence where a display or a given device cannot be opened.
Result<Edges> open_edges(const EdgeSettings& settings);

/// Where and how the next frame is drawn: the display's own target, turned.
RenderTarget target_of(const Edges& edges) noexcept;

/// Writes what happened since the last call, in the visitor's screen frame; returns how many.
std::size_t arrived(Edges& edges, std::span<input::InputEvent> out) noexcept;

/// A contact of the panel's frame as the visitor sees it.
input::Contact turned(input::Contact contact, Rotation rotation) noexcept;

}  // namespace docent::kiosk
