#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "runtime/model/museum.h"
#include "runtime/model/route_kind.h"

namespace docent::draw {

/// A line over the plan. Frame: floor.
struct DrawnLine {
  /// A way of that kind, in its colour and pattern. None: a line of equal clearance, thin; what it
  /// encloses is shaded.
  std::optional<RouteKind> kind = RouteKind::Shortest;
  std::vector<Vec2> points;
  bool closed = false;
  double clearance = 0;  ///< Metres: of a level or of an offset curve.
};

/// What of a floor is drawn.
struct PlanLayers {
  bool walls = false;        ///< Outlines, cases, columns and doors.
  bool regions = false;      ///< Voronoi regions, tinted so that neighbours differ.
  bool sites = false;        ///< Walls' ends and reflex corners.
  bool skeleton = false;     ///< The roadmap, darker where the room is wider.
  bool exhibits = false;     ///< Objects, viewing points and ids; the kiosk.
  bool grid = false;         ///< Lines at whole metres, with their coordinates at the edge.
  bool connections = false;  ///< Where stairs, escalators, lifts and ramps are, and lead to.
};

/// Draws one floor of a museum as an SVG document, the longer side 1,800 pixels, with a scale bar
/// and a legend. `lines` lie on top, in their order; levels come with the least clearance first.
/// The curves of the diagram are exact: an arc of a parabola is a quadratic Bezier curve.
std::string draw_plan(const Museum& museum, std::uint32_t floor, const PlanLayers& layers,
                      const std::vector<DrawnLine>& lines);

/// A floor and the lines over it.
struct DrawnFloor {
  std::uint32_t floor = 0;
  std::vector<DrawnLine> lines;
};

/// Draws several floors side by side, in their order, each as draw_plan does but all to one scale
/// and with one frame, so that what lies above one another is at the same place.
std::string draw_building(const Museum& museum, const std::vector<DrawnFloor>& floors,
                          const PlanLayers& layers);

}  // namespace docent::draw
