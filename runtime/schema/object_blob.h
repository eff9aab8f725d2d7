#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "runtime/model/exhibit/object.h"

/// An object's detail as bytes: five counts (u32: vertices, triangles' corners, parts, pictures,
/// bytes of all pictures), four numbers (f32: uv_low, uv_size), the vertices, the triangles, the
/// parts, the length of each picture (u32), and the pictures.
namespace docent::schema {

std::vector<std::byte> encode(const ObjectDetail& detail);

/// Replaces the detail by the one that the bytes hold; false, and nothing changed, where they hold
/// none that keeps its promises: every index names a vertex, parts cover the triangles in order,
/// and there are at most ObjectDetail::most_triangles and most_parts. Pictures are not looked into.
/// Safe on any bytes: takes memory in proportion to their length.
[[nodiscard]] bool decode(std::span<const std::byte> bytes, ObjectDetail& detail);

/// Does every corner name a vertex, and do three make a triangle?
bool is_whole(const ObjectMesh& mesh) noexcept;

}  // namespace docent::schema
