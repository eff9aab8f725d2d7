#pragma once

#include "content/import/gltf/model.h"

namespace docent::import::gltf {

/// The colour of a model at a place of its surface: base colour, picture, the vertex's own tint and
/// what glows, as standard and toon materials have them; linear, with opacity. What materials say
/// of shine and relief is left out. `material` may be none.
Vec4 colour_at(const Model& model, std::int32_t material, glm::vec2 uv, Vec4 tint);

/// Is there a picture that shows?
bool has_picture(const Model& model, std::int32_t material);

/// A share of linear light as sRGB's share, and back from a byte.
float srgb_of(float linear);
float linear_of(std::byte srgb);

}  // namespace docent::import::gltf
