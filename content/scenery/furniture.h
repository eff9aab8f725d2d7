#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "content/scenery/mesh_builder.h"
#include "runtime/model/exhibit/exhibit.h"
#include "runtime/model/geometry/floor_plan.h"
#include "runtime/model/scenery.h"

namespace docent::scenery {

/// What a hole of the plan stands for.
enum class HoleKind : std::uint8_t {
  Wall,      ///< A partition or a block of building: as high as the walls.
  Column,    ///< Round or square, cut like a wall.
  Pedestal,  ///< Open, with an object on it.
  Case,      ///< A closed base with glass on it.
  Flight,    ///< Stairs, an escalator or a ramp (flight.h).
};

/// One kind per ring, by its size, shape and what stands in it; rings that are no holes count as
/// Wall.
std::vector<HoleKind> hole_kinds(const FloorPlan& plan, std::span<const Exhibit> exhibits);

/// Something that keeps light away: everything over `outline` up to `height` metres. Below 0 it
/// lets light in: an opening that is so deep.
struct Blocker {
  Outline outline;
  double height = 0;
};

/// Builds what stands in a room: adds its faces to `mesh`, and the shapes that keep light away to
/// `blockers`.
void build_hole(HoleKind kind, const Outline& hole, MeshBuilder& mesh,
                std::vector<Blocker>& blockers);

/// Metres: where the glass of a case ends.
inline constexpr double glass_top = 1.5;
/// How high the top of a case's body or of a pedestal is, metres.
double top_of(HoleKind kind, const Outline& outline);

/// A closed body on its shadow gap: a plinth.
void build_plinth(const Outline& outline, double height, MeshBuilder& mesh);

/// An exhibit as a picture: hung on its wall, or standing up on its case, pedestal or the floor.
struct ExhibitStand {
  std::int32_t exhibit = -1;
  Placement placement;
  float aspect = 1;  ///< Width over height of the picture.
  HoleKind on = HoleKind::Wall;
  const Outline* hole = nullptr;  ///< What it stands on; null on a wall or the floor.
  bool on_wall = false;
  Vec2 taken{};  ///< Of the floor, across its front and deep: it stands on a base that large.
};
void build_stand(const ExhibitStand& stand, MeshBuilder& mesh, std::vector<Blocker>& blockers);

/// The ring as an outline: counter-clockwise.
Outline outline_of(const FloorPlan& plan, const Ring& ring);

}  // namespace docent::scenery
