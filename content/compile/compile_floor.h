#pragma once

#include <span>
#include <string>
#include <vector>

#include "content/compile/progress.h"
#include "content/compile/report.h"
#include "content/import/floor/geojson.h"
#include "runtime/model/geometry/floor.h"

namespace docent::compile {

/// A floor compiled, with the plan as it was drawn.
struct CompiledFloor {
  import::ImportedPlan drawn;
  Floor floor;
};

/// Plans the stages of compile_floor, which all floors share.
void plan_floor_stages(Progress& progress);

/// Makes a floor of its plan files: walls, Voronoi diagram, medial axis, what corners see, and
/// per radius a tangent graph with its labels, on up to `jobs` threads. Mendings go into the
/// report. Throws ContentError where the plan cannot be used.
CompiledFloor compile_floor(const std::string& name, std::span<const std::string> files,
                            import::Coordinates coordinates, std::span<const double> radii,
                            Report& report, Progress& progress, unsigned jobs = 1);

}  // namespace docent::compile
