#pragma once

#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

#include "content/scenery/passage.h"
#include "runtime/model/exhibit/exhibit.h"
#include "runtime/model/floor_tint.h"
#include "runtime/model/geometry/floor_plan.h"
#include "runtime/model/scenery.h"

namespace docent::scenery {

/// What a part of the floor is laid with.
enum class Paving : std::uint8_t { Oak, Stone };

/// A part of the floor with its own paving. Floor frame, counter-clockwise polygon.
struct PavedArea {
  std::vector<Vec2> outline;
  Paving paving = Paving::Stone;
  std::uint8_t tint = no_floor_tint;  ///< By which a gallery is told from those beside it.
};

struct SceneryOptions {
  std::uint32_t floor = 0;  ///< Exhibits of other floors are left out.
  /// Floor frame, radians: the direction that is up in the overview. The sun stands to its left and
  /// behind, so that shadows fall to the lower right of the picture.
  double up = std::numbers::pi / 2;
  /// How one gets to other floors: drawn where the plan leaves room for it (flight.h, lift_car.h).
  std::vector<Passage> passages{};
  /// What the exhibits that stand free take of the floor, one per exhibit or none at all: metres
  /// across their front and deep; 0 for those that take none.
  std::vector<Vec2> taken{};
  /// How large the exhibits' own shapes are, one per exhibit or none at all: metres wide, high and
  /// deep; all 0 for those that are a picture.
  std::vector<Vec3> objects{};
  double texel = 0.05;  ///< Metres a lightmap texel; larger where the floor would need too many.
};

/// Builds what is drawn of a floor, as an architect's model: walls cut at shoulder height, cases
/// and columns where the plan has holes, stairs and lifts, the exhibits as pictures on walls and
/// stands in cases, and the light of one soft sun and of the sky on all of it.
///
/// `image_aspect` holds width over height of each exhibit's picture, one per exhibit.
/// SceneryPart::exhibit counts in `exhibits`. Floor that no area covers is oak. A plan without
/// interior gives an empty scenery. The result does not depend on the machine's threads.
/// Where exhibits have shapes of their own (`objects`) there is what these stand on, and no
/// picture; `stands`, one per exhibit or none at all, then says where.
Scenery make_scenery(const FloorPlan& plan, std::span<const Exhibit> exhibits,
                     std::span<const float> image_aspect, std::span<const PavedArea> paving,
                     const SceneryOptions& options = {}, std::span<ObjectStand> stands = {});

}  // namespace docent::scenery
