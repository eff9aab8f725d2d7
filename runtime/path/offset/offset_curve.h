#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "runtime/path/medial_axis/medial_axis_map.h"
#include "runtime/path/touching.h"

namespace docent::path {

class FloorMap;

/// A place where the curve at one distance from the walls meets a Voronoi edge: twice the edge's
/// number, plus one for the second place on it.
using LevelCrossing = std::uint32_t;

/// A piece of that curve inside the region of one site: parallel to a wall, or an arc about a
/// corner. The site is to the right of it.
struct LevelPiece {
  std::uint32_t site = 0;
  LevelCrossing from = 0, to = 0;
  double begin = 0, end = 0;  ///< Metres along the wall, growing, or radians on the corner's arc
                              ///< (see ReflexCorner), falling.
  Vec2 first{}, last{};       ///< The points of its crossings.
};

/// The curve of all points at one distance from the nearest wall, found by cutting the Voronoi
/// regions at that distance. No part of it is made before it is asked for.
///
/// Following the curve round a region passes the region's edges above the distance. All in all
/// there are no more than three times as many of these as pieces: cut off at the distance, the
/// diagram is a plane graph with one piece to a face. So the whole curve costs time linear in its
/// own size.
class LevelCurve {
 public:
  /// `distance` is positive. Borrows the map.
  LevelCurve(const MedialAxisMap& map, double distance) noexcept
      : map_(&map), distance_(distance) {}

  double distance() const noexcept { return distance_; }
  /// Does the curve pass a place of a clearance by? At exactly the distance there is no area
  /// between what would pass there, so it closes before.
  bool passes(double clearance) const noexcept { return clearance > distance_ + touching; }

  /// The crossings of a Voronoi edge, in its direction.
  struct Crossings {
    std::array<double, 2> at{};  ///< Places on it, as EdgeCurve counts.
    std::uint32_t count = 0;
    bool first_rises = false;  ///< Does the clearance grow past the distance at the first? At the
                               ///< second it does the opposite.
    /// Is what lies below them not below the distance, but for `touching`? Then the curve meets
    /// there what comes from the other sides, in a point.
    bool at_pinch = false;
  };
  Crossings crossings_of(std::uint32_t voronoi_edge) const noexcept;
  Vec2 point_at(LevelCrossing crossing) const noexcept;

  /// The piece that begins at a crossing, and the one that ends there.
  LevelPiece piece_from(LevelCrossing crossing) const noexcept;
  LevelPiece piece_to(LevelCrossing crossing) const noexcept;
  /// The pieces in the region of a site.
  std::vector<LevelPiece> pieces_in(std::uint32_t site) const;

  /// The place of `point`, as the pieces in a site's region count places (LevelPiece::begin).
  double place_of(std::uint32_t site, Vec2 point) const noexcept;
  Vec2 point_at(std::uint32_t site, double place) const noexcept;
  double length_between(std::uint32_t site, double a, double b) const noexcept;
  void append_points(std::uint32_t site, double a, double b, std::vector<Vec2>& points) const;
  /// Half the integral of r x dr along it, r from `origin`.
  double area_between(std::uint32_t site, double a, double b, Vec2 origin) const noexcept;

 private:
  bool is_wall(std::uint32_t site) const noexcept;
  static bool rises(const Crossings& crossings, std::uint32_t which) noexcept {
    return crossings.first_rises != (which == 1);
  }
  /// A crossing with where it is.
  struct Found {
    LevelCrossing crossing = 0;
    double at = 0;
  };
  Found next_crossing(LevelCrossing crossing, const Crossings& here, std::uint32_t site,
                      bool counter_clockwise) const noexcept;
  Vec2 point_at(const Found& found) const noexcept {
    return map_->curve(found.crossing / 2).point_at(found.at);
  }
  LevelPiece piece(std::uint32_t site, const Found& from, const Found& to) const noexcept;

  const MedialAxisMap* map_;
  double distance_;
};

/// One closed curve; counter-clockwise round a part of the floor, clockwise round a hole in one.
struct OffsetRing {
  std::vector<Vec2> points;  ///< Not closed; arcs flattened.
  double area = 0;           ///< Square metres, exact; negative for a hole.
  double length = 0;         ///< Metres, exact.
};

/// The part of a floor that keeps a distance from all walls.
struct OffsetCurve {
  double distance = 0;
  std::vector<OffsetRing> rings{};
  std::uint32_t components = 0, holes = 0;
  double area = 0;       ///< Square metres, holes taken out.
  double perimeter = 0;  ///< Metres.
};

/// Makes the offset curve, in time linear in its size. At distance 0 it is the walls; empty where
/// the distance is negative or not finite.
///
/// What keeps the distance only within `touching` has no area and is left out: a door of twice the
/// distance closes, and the curve touches itself in it. The parts on its two sides are components
/// of their own; and a part that meets itself there goes round a hole. Every ring has an area.
OffsetCurve offset_curve(const MedialAxisMap& map, double distance);
OffsetCurve offset_curve(const FloorMap& map, double distance);

}  // namespace docent::path
