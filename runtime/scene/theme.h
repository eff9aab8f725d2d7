#pragma once

#include "runtime/model/livery.h"
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
  bool operator==(const Theme&) const = default;
};

/// Contrasts that every theme keeps (WCAG 2.2's ratios). Letters of the paper stand on what
/// invites.
inline constexpr float least_of_text = 7, least_of_invitation = 4, least_of_focus = 3;
/// Of the paper by day, as luminance, so that ways and guides are told from it.
inline constexpr float least_paper = 0.7F;
/// How much what lies on paper is told from it, by day and by night.
inline constexpr float of_plaster = 1.13F, of_plaster_at_night = 1.46F;
inline constexpr float least_way_at_night = 0.30F;

/// Of the paper and the ink of a theme, what lies between: a ground for letters, told from paper by
/// so much, and quiet letters.
inline void derive_greys(Theme& theme, float ground) noexcept {
  constexpr float least = 1.01F * least_of_text;  // rounding to eight bits takes nothing from it
  theme.plaster = furthest_mix(theme.paper, theme.ink, [&](const Colour& mix) {
    return contrast(mix, theme.ink) >= least && contrast(mix, theme.paper) <= ground;
  });
  theme.quiet_ink = furthest_mix(theme.ink, theme.paper, [&](const Colour& mix) {
    return contrast(mix, theme.paper) >= least;
  });
}

/// Does it have paper or ink of its own?
inline bool has_own_paper(const Livery& livery) noexcept {
  const Livery house;
  return livery.paper != house.paper || livery.ink != house.ink;
}

inline Theme day_theme(const Livery& livery) noexcept {
  Theme theme;
  theme.paper = srgb(livery.paper);
  theme.ink = srgb(livery.ink);
  theme.invitation = srgb(livery.accent);
  theme.focus = srgb(livery.focus);
  if (has_own_paper(livery)) derive_greys(theme, of_plaster);
  return theme;
}

/// The museum after dark: ink and paper change places, and what is coloured shines.
inline Theme night_theme(const Livery& livery) noexcept {
  Theme theme = day_theme(livery);
  theme.plaster = srgb(0x3B3732);
  theme.quiet_ink = srgb(0xC6BCAD);
  if (has_own_paper(livery)) {
    const Colour dark = theme.ink;
    theme.ink = deepened(theme.paper, luminance(srgb(0xF0E8DA)));
    theme.paper = deepened(dark, luminance(srgb(0x1C1A18)));
    derive_greys(theme, of_plaster_at_night);
  } else {
    theme.paper = srgb(0x1C1A18);
    theme.ink = srgb(0xF0E8DA);
  }
  theme.invitation = lifted(theme.invitation, least_way_at_night);
  theme.focus = lifted(theme.focus, 0.36F);
  theme.shade = srgb(0x000000);
  theme.least_way = least_way_at_night;
  return theme;
}

/// For who sees little: black on white, whatever a museum wears, and deeper colours.
inline Theme high_contrast_theme(const Livery& livery) noexcept {
  constexpr float deep = 1.05F / least_of_text - 0.05F;
  const Livery house;
  Theme theme;
  theme.paper = srgb(0xFFFFFF);
  theme.plaster = srgb(0xDDDDDD);
  theme.ink = theme.quiet_ink = theme.shade = srgb(0x000000);
  theme.invitation =
      livery.accent == house.accent ? srgb(0xA3200A) : deepened(srgb(livery.accent), deep);
  theme.focus = livery.focus == house.focus ? srgb(0x00423F) : deepened(srgb(livery.focus), deep);
  return theme;
}
inline Theme high_contrast_night_theme(const Livery& livery) noexcept {
  Theme theme = night_theme(livery);
  theme.paper = srgb(0x000000);
  theme.plaster = srgb(0x333333);
  theme.ink = theme.quiet_ink = srgb(0xFFFFFF);
  theme.invitation = lifted(theme.invitation, 0.40F);
  theme.focus = lifted(theme.focus, 0.60F);
  return theme;
}
inline Theme theme_of(const Livery& livery, bool has_high_contrast, bool is_night) noexcept {
  if (is_night) return has_high_contrast ? high_contrast_night_theme(livery) : night_theme(livery);
  return has_high_contrast ? high_contrast_theme(livery) : day_theme(livery);
}

/// The light of the model: late afternoon, or a house at night, where exhibits have lamps of their
/// own and the floors are so dark that every way is told from them.
inline Light light_of(const Livery& livery, bool is_night) noexcept {
  Light light;
  if (is_night)
    light = {.sun = {0.058F, 0.060F, 0.071F, 0},
             .sky = {0.050F, 0.054F, 0.069F, 0},
             .bounce = {0.105F, 0.086F, 0.064F, 0},
             .doorway = with_opacity(srgb(0xE0A850), 0.36F),
             .lamp = {0.62F, 0.57F, 0.50F, 0},
             .least_way = least_way_at_night};
  light.paper = is_night ? night_theme(livery).paper : srgb(livery.paper);
  light.mark = srgb(livery.accent);
  return light;
}

inline Colour route_colour(RouteKind kind) noexcept {
  return srgb(info_of(kind).colour);
}

}  // namespace docent::scene
