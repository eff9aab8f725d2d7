#pragma once

#include <cstddef>

#include "content/object/shape.h"

namespace docent::object {

/// Collapses edges, cheapest first, until at most `triangles` are left (meshoptimizer: Garland and
/// Heckbert 1997, quadric error metrics); where seams of its pictures or loose triangles allow no
/// more, by cells of space (Rossignac and Borrel 1993). What is few enough stays as it is. Vertices
/// stay where they are; those that are left over go. Deterministic.
void simplify(Shape& shape, std::size_t triangles);

/// Leaves out triangles that lie on others, facing the same way.
void drop_repeated(Shape& shape);

/// The shape with one vertex at each place: without the seams of pictures.
Shape without_seams(const Shape& shape);

}  // namespace docent::object
