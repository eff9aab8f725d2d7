#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "platform/display.h"

/// Which screens are driven, and how: plain values and functions, without a graphics card. What the
/// card says is read by `graphics_card.h`.
namespace docent::kms {

/// A mode that a connector offers.
struct Mode {
  PixelSize size;
  std::uint32_t refresh_mhz = 0;
  bool is_preferred = false, is_interlaced = false;
  bool operator==(const Mode&) const = default;
};

/// A socket of the card, and the screen in it.
struct Connector {
  std::uint32_t id = 0;
  std::string name;  ///< As on the device: "HDMI-A-1".
  bool is_connected = false;
  std::uint32_t crtcs = 0;  ///< A bit for each CRTC of the card that can feed it, by place.
  std::uint32_t width_mm = 0, height_mm = 0;  ///< Of the picture, as the screen's EDID says.
  Rotation panel = Rotation::None;            ///< How the panel is built in.
  std::vector<Mode> modes;
};

/// A plane that can hold a whole picture.
struct PrimaryPlane {
  std::uint32_t id = 0;
  std::uint32_t crtcs = 0;  ///< As of a connector.
};

/// What a card has at one moment.
struct CardState {
  std::vector<Connector> connectors;
  std::vector<std::uint32_t> crtcs;  ///< Identifiers.
  std::vector<PrimaryPlane> planes;
};

/// What an operator asked for.
struct WantedOutput {
  std::string connector{};       ///< Empty: the first connected one.
  bool mirror = false;           ///< The same picture on every connected one.
  PixelSize size{};              ///< 0 by 0: what the screen prefers.
  std::uint32_t refresh_hz = 0;  ///< 0: what the screen prefers.
};

struct PixelRect {
  std::uint32_t x = 0, y = 0, width = 0, height = 0;
  bool operator==(const PixelRect&) const = default;
};

/// How the picture gets to one screen. Indices into a CardState.
struct Route {
  std::size_t connector = 0, mode = 0, crtc = 0, plane = 0;
  PixelRect place{};  ///< Where on the screen the picture is.
  bool operator==(const Route&) const = default;
};

/// One picture and the screens that it goes to; empty where there is none.
struct OutputPlan {
  PixelSize picture{};
  std::vector<Route> routes;
  bool operator==(const OutputPlan&) const = default;
};

/// The mode to use: that nearest in size to `size`, or to what the screen prefers where that is 0
/// by 0; among those the one nearest to `refresh_hz`, then one that is not interlaced, then the
/// preferred one, then the quickest. `modes` is not empty.
std::size_t best_mode(std::span<const Mode> modes, PixelSize size,
                      std::uint32_t refresh_hz) noexcept;

/// What could be driven, best first; a driver may refuse the first ones. Empty where no screen is
/// connected, or not the one that was asked for. Every plan gives each screen a CRTC and a plane of
/// its own. Mirrored: at first each screen in a mode of the picture's size, or else in its best
/// mode with the picture scaled into it; then all in one mode that all have; then one screen alone.
std::vector<OutputPlan> output_plans(const CardState& card, const WantedOutput& wanted);

/// Why there is no plan, as a sentence for the journal.
std::string why_none(const CardState& card, const WantedOutput& wanted);

/// The largest place for a picture on a screen, in the middle, with the picture's proportions.
PixelRect letterbox(PixelSize picture, PixelSize screen) noexcept;

/// The screen's diagonal in inches; none where what its EDID says cannot be: nothing at all, the
/// proportions instead of the size (16 by 9 centimetres, as televisions say), other proportions
/// than the mode's, or a size that no kiosk has.
std::optional<double> diagonal_inches(std::uint32_t width_mm, std::uint32_t height_mm,
                                      PixelSize mode) noexcept;

}  // namespace docent::kms
