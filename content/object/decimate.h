#pragma once

#include <cstddef>

#include "content/object/shape.h"

namespace docent::object {

/// Collapses edges until at most `triangles` are left, always the one after which the surface is
/// least far from what it was, both ways (Klein, Liebich and Straßer 1996): where the quadrics of
/// simplify() spend triangles by the mean, this spends them where most is missed. Then moves
/// corners along their normals where that brings the surface nearer. Seams of pictures stay whole,
/// and sheets that touch stay two. Returns how far the surface is off at most, as a share of its
/// longest side, as far as samples three pixels of 1080 apart say; more than 1/100 is not done, so
/// that more triangles may be left. Vertices that none uses stay. Deterministic.
float decimate(Shape& shape, std::size_t triangles);

}  // namespace docent::object
