#pragma once

#include <cstdint>
#include <vector>

#include "content/object/shape.h"

namespace docent::object {

/// How much of the open space about it each vertex sees, of 255, past the object itself and the
/// floor that it stands on: what lies deep is dark. The object is looked at from many sides, and
/// counted where it is seen (a depth buffer each, Williams 1978).
std::vector<std::uint8_t> occlusion_of(const Shape& shape, const std::vector<Vec3>& normals);

}  // namespace docent::object
