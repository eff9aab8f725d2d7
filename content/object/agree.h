#pragma once

#include "content/object/shape.h"

namespace docent::object {

/// Turns triangles so that those that share an edge face the same way, each surface outwards.
/// Surfaces that agree already stay as they are, whichever way that is. Returns how many were
/// turned.
std::size_t agree(Shape& shape);

}  // namespace docent::object
