#pragma once

#include "runtime/scene/colour.h"

namespace docent::scene {

/// The light that the model stands in, and the paper round it. Linear light. The defaults are late
/// afternoon, so that pale plaster in full light comes out just below paper.
struct Light {
  Colour sun{1.20F, 1.11F, 0.97F, 0};
  Colour sky{0.51F, 0.52F, 0.53F, 0};
  Colour bounce{0.70F, 0.615F, 0.52F, 0};  ///< From the floor, on what looks down.
  Colour paper = srgb(0xF5F1E8);
  Colour mark = srgb(0xD2452D);                          ///< Of marks that are nobody's.
  Colour doorway = with_opacity(srgb(0xFFC15A), 0.72F);  ///< What lies in those of a way.
  Colour lamp{0, 0, 0, 0};  ///< On bodies alone, so that they are seen in the dark.
  float least_way = 0;      ///< Ways and marks shine until they are so bright.
  bool operator==(const Light&) const = default;
};

/// `share` of the way from one to the other.
inline Light mixed(const Light& from, const Light& to, float share) noexcept {
  return {mixed(from.sun, to.sun, share),       mixed(from.sky, to.sky, share),
          mixed(from.bounce, to.bounce, share), mixed(from.paper, to.paper, share),
          mixed(from.mark, to.mark, share),     mixed(from.doorway, to.doorway, share),
          mixed(from.lamp, to.lamp, share),     std::lerp(from.least_way, to.least_way, share)};
}

}  // namespace docent::scene
