#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace docent::scene {

/// Linear RGB and opacity. Not premultiplied: the renderer does that.
struct Colour {
  float r = 0, g = 0, b = 0, a = 1;
  bool operator==(const Colour&) const = default;
};

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

/// One channel of linear light as sRGB, [0, 1].
inline float srgb_channel(float light) noexcept {
  return light <= 0.0031308F ? 12.92F * light : 1.055F * std::pow(light, 1 / 2.4F) - 0.055F;
}

/// A colour as 0xRRGGBB.
inline std::uint32_t hex_of(const Colour& colour) noexcept {
  const auto channel = [](float light, unsigned shift) {
    const float level = std::clamp(srgb_channel(light), 0.0F, 1.0F) * 255;
    return static_cast<std::uint32_t>(std::lround(level)) << shift;
  };
  return channel(colour.r, 16) | channel(colour.g, 8) | channel(colour.b, 0);
}

inline Colour with_opacity(Colour colour, float opacity) noexcept {
  colour.a *= opacity;
  return colour;
}

/// `share` of the way from one to the other.
inline Colour mixed(const Colour& from, const Colour& to, float share) noexcept {
  return {std::lerp(from.r, to.r, share), std::lerp(from.g, to.g, share),
          std::lerp(from.b, to.b, share), std::lerp(from.a, to.a, share)};
}

/// The relative luminance (WCAG 2.2).
inline float luminance(const Colour& colour) noexcept {
  return 0.2126F * colour.r + 0.7152F * colour.g + 0.0722F * colour.b;
}

/// The ratio of two luminances (WCAG 2.2): 1 to 21.
inline float contrast(float a, float b) noexcept {
  return (std::max(a, b) + 0.05F) / (std::min(a, b) + 0.05F);
}
inline float contrast(const Colour& a, const Colour& b) noexcept {
  return contrast(luminance(a), luminance(b));
}

/// The colour in more of its own light, until it is so bright; what no channel can hold comes as
/// white.
inline Colour lifted(const Colour& colour, float least) noexcept {
  const float now = luminance(colour);
  if (now >= least) return colour;
  const float more = least / std::max(now, 1e-3F);
  const Colour bright{std::min(1.0F, colour.r * more), std::min(1.0F, colour.g * more),
                      std::min(1.0F, colour.b * more), colour.a};
  const float reached = luminance(bright);
  if (reached >= least) return bright;
  return mixed(bright, {1, 1, 1, colour.a}, (least - reached) / (1 - reached));
}

/// The colour in less of its own light, until it is so dark.
inline Colour deepened(const Colour& colour, float most) noexcept {
  const float now = luminance(colour);
  return now <= most ? colour : with_opacity(mixed({0, 0, 0, 1}, colour, most / now), colour.a);
}

/// As far from `from` towards `to` as it `holds` of what one gets; on the way that ends once.
/// `from` where it never holds.
inline Colour furthest_mix(const Colour& from, const Colour& to, auto holds) noexcept {
  constexpr int halvings = 12;  // finer than a step of eight bits
  float within = 0, beyond = 1;
  for (int i = 0; i < halvings; ++i) {
    const float share = (within + beyond) / 2;
    (holds(mixed(from, to, share)) ? within : beyond) = share;
  }
  return mixed(from, to, within);
}

}  // namespace docent::scene
