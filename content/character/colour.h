#pragma once

#include <cstdint>
#include <vector>

#include "content/character/surface.h"
#include "runtime/model/motion/skinned_mesh.h"

namespace docent::character {

/// The colours of a character's materials at places of its surface: base colour, picture, the
/// vertex's own tint and what glows, as standard and toon materials have them. What they say of
/// shine, relief and outlines is lost.
class Colours {
 public:
  explicit Colours(const import::gltf::Model& model) : model_{model} {}

  /// Linear, with opacity.
  Vec4 at(const SurfaceVertex& vertex) const;
  /// Is there anything to see here? Not below a material's cutoff, or where it is mostly clear.
  bool is_seen(const SurfaceVertex& vertex) const;
  bool has_picture(const SurfaceVertex& vertex) const;

 private:
  const import::gltf::Material* material_of(const SurfaceVertex& vertex) const;

  const import::gltf::Model& model_;
};

/// Linear light as sRGB bytes.
VertexColour srgb_of(Vec4 linear);

}  // namespace docent::character
