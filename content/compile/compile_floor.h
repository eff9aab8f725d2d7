#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "content/compile/check_plan.h"
#include "content/compile/progress.h"
#include "content/compile/report.h"
#include "content/compile/standing.h"
#include "content/floor/close_doors.h"
#include "content/import/floor/geojson.h"
#include "runtime/model/geometry/floor.h"

namespace docent::compile {

/// A floor compiled, with the plan as it was drawn.
struct CompiledFloor {
  import::ImportedPlan drawn;
  Floor floor;           ///< Its closed doors are walls, and what stands on it obstacles.
  FloorPlan walls;       ///< The plan without what staff put on it.
  FloorPlan with_cases;  ///< With their cases, and without exhibits that stand free.
  std::vector<Standing> standing;
  std::vector<floor::DoorFault> door_faults;
  std::vector<PlanGap> gaps;  ///< Told with the exhibits that lie beyond them.
};

/// Plans the stages of compile_floor, which all floors share.
void plan_floor_stages(Progress& progress);

/// How large the labels of one radius may become, as entries of 16 bytes, on a floor of a building
/// that has so many: all floors together take no more than two that stand alone, in the database,
/// in a kiosk's memory and of the compiler's time.
constexpr std::size_t label_entries(std::size_t floors) noexcept {
  constexpr std::size_t alone = 11'000'000;
  return floors < 3 ? alone : 2 * alone / floors;
}

/// What staff put on a floor besides its plan.
struct FloorContents {
  std::vector<Door> doors;
  std::vector<Standing> standing;
};

/// Makes a floor of its plan files and what staff put on it: walls, Voronoi diagram, medial axis,
/// what corners see, and per radius a tangent graph with its labels, on up to `jobs` threads.
/// Mendings go into the report. Throws ContentError where the plan cannot be used. `most_entries`:
/// of the labels of one radius; where they would be more, ways are searched.
CompiledFloor compile_floor(const std::string& name, std::span<const std::string> files,
                            import::Coordinates coordinates, std::span<const double> radii,
                            Report& report, Progress& progress, unsigned jobs = 1,
                            FloorContents contents = {},
                            std::size_t most_entries = label_entries(1));

}  // namespace docent::compile
