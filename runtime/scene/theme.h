#pragma once

#include <cmath>
#include <cstdint>

#include "runtime/model/route_kind.h"
#include "runtime/scene/draw_list.h"

namespace docent::scene {

/// One channel of sRGB, [0, 1], as linear light (IEC 61966-2-1).
inline float linear_light(float channel) noexcept {
  return channel <= 0.04045F ? channel / 12.92F : std::pow((channel + 0.055F) / 1.055F, 2.4F);
}

/// The linear colour of 0xRRGGBB.
inline Colour srgb(std::uint32_t hex, float opacity = 1) noexcept {
  const auto channel = [hex](unsigned shift) {
    return linear_light(static_cast<float>(hex >> shift & 0xFFU) / 255.0F);
  };
  return {channel(16), channel(8), channel(0), opacity};
}

/// The colours that the model and the interface share. Linear light.
struct Theme {
  Colour paper = srgb(0xF5F1E8);
  Colour plaster = srgb(0xE9E3D7);
  Colour cut_face = srgb(0x8C8479);
  Colour oak = srgb(0xB98F62);
  Colour stone = srgb(0xBDB6A8);
  Colour ink = srgb(0x1E1C1A);
  Colour quiet_ink = srgb(0x544D46);
  Colour invitation = srgb(0xD2452D);  ///< Vermilion: what invites to touch.
  Colour focus = srgb(0x1D7874);       ///< Teal: what the keypad would press.
};

/// For who sees little: black on white, and deeper colours.
inline Theme high_contrast_theme() noexcept {
  Theme theme;
  theme.paper = srgb(0xFFFFFF);
  theme.plaster = srgb(0xDDDDDD);
  theme.ink = theme.quiet_ink = srgb(0x000000);
  theme.invitation = srgb(0xA3200A);
  theme.focus = srgb(0x00423F);
  return theme;
}
inline const Theme& theme_of(bool has_high_contrast) noexcept {
  static const Theme usual, high = high_contrast_theme();
  return has_high_contrast ? high : usual;
}

inline Colour route_colour(RouteKind kind) noexcept {
  return srgb(info_of(kind).colour);
}

inline Colour with_opacity(Colour colour, float opacity) noexcept {
  colour.a *= opacity;
  return colour;
}

}  // namespace docent::scene
