#pragma once

#include <vector>

#include "content/object/shape.h"

namespace docent::object {

/// Gives the shape a normal for each vertex, and doubles vertices where faces meet at a crease of
/// more than `crease` radians: round things become smooth, and edges stay sharp, whatever the file
/// said of it. Returns one unit vector a vertex.
std::vector<Vec3> crease(Shape& shape, float crease);

}  // namespace docent::object
