#pragma once

#include <vector>

#include "content/import/gltf/model.h"

namespace docent::import::object {

/// A scene of one node that shows these primitives; those without triangles are left out.
gltf::Model scene_of(std::vector<gltf::Primitive> primitives);

/// Adds a polygon as triangles about its first corner; those without area by their indices alone
/// are left out.
void add_polygon(const std::vector<std::uint32_t>& corners, gltf::Primitive& primitive);

/// sRGB bytes or shares (0 to 1) as linear light.
float linear_of(float srgb);

}  // namespace docent::import::object
