#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/model/geometry/vec2.h"

namespace docent::import {

/// Where something stands in a source file, for the sentence that tells its author about it.
struct SourcePlace {
  std::uint32_t file = 0;    ///< Index into ImportedPlan::files.
  std::uint32_t line = 0;    ///< From 1.
  std::uint32_t column = 0;  ///< From 1, in bytes.
};

/// A closed ring as its author drew it, the first vertex not repeated at the end. It may cross
/// itself, run either way round and hold repeated vertices; it has at least one vertex, and every
/// coordinate is finite.
struct ImportedRing {
  std::vector<Vec2> vertex;
  std::vector<SourcePlace> place;  ///< One per vertex.
};

/// One walkable area: the inside of `outer` without the insides of `holes`.
struct ImportedPolygon {
  ImportedRing outer;
  std::vector<ImportedRing> holes;
  bool doorway = false;  ///< Cut through a wall by a door (content/floor/open_doors.h).
};

/// Something in a source that is no area and was left out.
struct LeftOut {
  std::string what;  ///< `LineString`.
  SourcePlace place;
};

/// One floor as it was read, before mending (content/floor/mend.h). Frame: floor.
struct ImportedPlan {
  std::vector<std::string> files;  ///< As the author named them.
  std::vector<ImportedPolygon> polygons;
  std::vector<LeftOut> left_out;
  /// Points whose third number is a height, unless a decimal comma made it: at most one a ring.
  std::vector<SourcePlace> doubtful_heights{};
};

}  // namespace docent::import
