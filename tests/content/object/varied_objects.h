#pragma once

#include <cstdint>
#include <string>

#include "content/object/shape.h"

namespace docent::object {

/// A copy of an object as a stranger would bring it.
struct VariedObject {
  std::string bytes, name;  ///< A file of some format, which the name's ending says.
  std::string told;         ///< What was done to it, and what format it is.
};

/// The same seed gives the same copy: turned, scaled to another unit, stretched, mirrored, merged
/// with `other`, cut in two, its triangles shuffled, split into loose ones, turned inside out or
/// repeated, with some that have no area; as GLB (corners shared or not, all types of indices), OBJ
/// (counted from the beginning or the end, with wrong normals or none), PLY or STL (text, or binary
/// of either byte order).
VariedObject varied(const Shape& shape, const Shape& other, std::uint32_t seed);

}  // namespace docent::object
