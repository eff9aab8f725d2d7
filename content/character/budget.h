#pragma once

#include "content/character/colour.h"
#include "content/character/surface.h"

namespace docent::character {

/// A guide's triangles at most.
inline constexpr std::size_t most_triangles = 15'000;

/// A surface with a colour for each vertex, of no more triangles than the budget.
struct ColouredSurface {
  Surface surface;
  std::vector<VertexColour> colour;
};

/// Brings a character to the budget: what is clear is left out; what is too much is simplified
/// (meshoptimizer); and since the kiosk keeps colours by vertex, triangles that are left over are
/// spent where a picture shows more than their corners do: there, edges are halved, the worst
/// first. The same surface gives the same result. `springs` are those that it is bound to.
ColouredSurface to_budget(Surface surface, const Springs& springs, const Colours& colours,
                          std::size_t triangles = most_triangles);

}  // namespace docent::character
