#pragma once

#include "runtime/model/route_kind.h"
#include "runtime/scene/light.h"

namespace docent::scene {

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
  Colour shade = srgb(0x1E1C1A);       ///< Of what lies above something.
  float least_way = 0;                 ///< Ways are at least so bright.
};

/// The museum after dark: ink and paper change places, and what is coloured shines.
inline constexpr float least_way_at_night = 0.30F;
inline Theme night_theme() noexcept {
  Theme theme;
  theme.paper = srgb(0x1C1A18);
  theme.plaster = srgb(0x3B3732);
  theme.ink = srgb(0xF0E8DA);
  theme.quiet_ink = srgb(0xC6BCAD);
  theme.invitation = lifted(theme.invitation, least_way_at_night);
  theme.focus = lifted(theme.focus, 0.36F);
  theme.shade = srgb(0x000000);
  theme.least_way = least_way_at_night;
  return theme;
}

/// For who sees little: black on white, and deeper colours.
inline Theme high_contrast_theme() noexcept {
  Theme theme;
  theme.paper = srgb(0xFFFFFF);
  theme.plaster = srgb(0xDDDDDD);
  theme.ink = theme.quiet_ink = theme.shade = srgb(0x000000);
  theme.invitation = srgb(0xA3200A);
  theme.focus = srgb(0x00423F);
  return theme;
}
inline Theme high_contrast_night_theme() noexcept {
  Theme theme = night_theme();
  theme.paper = srgb(0x000000);
  theme.plaster = srgb(0x333333);
  theme.ink = theme.quiet_ink = srgb(0xFFFFFF);
  theme.invitation = lifted(theme.invitation, 0.40F);
  theme.focus = lifted(theme.focus, 0.60F);
  return theme;
}
inline const Theme& theme_of(bool has_high_contrast, bool is_night) noexcept {
  static const Theme usual, high = high_contrast_theme(), night = night_theme(),
                            high_at_night = high_contrast_night_theme();
  if (is_night) return has_high_contrast ? high_at_night : night;
  return has_high_contrast ? high : usual;
}

/// The light of the model: late afternoon, or a house at night, where exhibits have lamps of their
/// own and the floors are so dark that every way is told from them.
inline const Light& light_of(bool is_night) noexcept {
  static const Light day, night{.sun = {0.058F, 0.060F, 0.071F, 0},
                                .sky = {0.050F, 0.054F, 0.069F, 0},
                                .bounce = {0.105F, 0.086F, 0.064F, 0},
                                .paper = night_theme().paper,
                                .lamp = {0.62F, 0.57F, 0.50F, 0},
                                .least_way = least_way_at_night};
  return is_night ? night : day;
}

inline Colour route_colour(RouteKind kind) noexcept {
  return srgb(info_of(kind).colour);
}

}  // namespace docent::scene
