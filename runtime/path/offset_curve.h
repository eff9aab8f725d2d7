#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "runtime/path/medial_axis_map.h"
#include "runtime/path/reflex_corner.h"

namespace docent {

class FloorMap;

/// Where the curve at one distance from the walls meets a Voronoi edge.
struct LevelCrossing {
  std::uint32_t voronoi_edge = 0;
  double at = 0;       ///< The place on it, as EdgeCurve counts.
  bool rises = false;  ///< The clearance grows past the distance when going from `from` to `to`.
};

/// A piece of that curve inside the region of one site: parallel to a wall, or an arc about a
/// corner. The wall is to the right of it.
struct LevelPiece {
  std::uint32_t site = 0;
  std::uint32_t from = 0, to = 0;  ///< Crossings.
  double begin = 0, end = 0;  ///< Metres along the wall, growing, or radians on the corner's arc
                              ///< (see ReflexCorner), falling.
};

/// The curve of all points at one distance from the nearest wall, from clipping each Voronoi region
/// at that distance; linear in the size of the diagram.
class LevelCurve {
 public:
  /// `distance` is positive. Borrows the map.
  LevelCurve(const MedialAxisMap& map, double distance);

  double distance() const noexcept { return distance_; }
  std::span<const LevelCrossing> crossings() const noexcept { return crossing_; }
  std::span<const LevelPiece> pieces() const noexcept { return piece_; }
  /// The crossings of a Voronoi edge, none to two, in its direction.
  std::uint32_t first_crossing(std::uint32_t voronoi_edge) const noexcept {
    return edge_first_[voronoi_edge];
  }
  std::uint32_t end_crossing(std::uint32_t voronoi_edge) const noexcept {
    return edge_first_[voronoi_edge + 1];
  }
  /// The piece that begins at a crossing.
  std::uint32_t piece_from(std::uint32_t crossing) const noexcept { return piece_from_[crossing]; }

  /// How a piece of a site's region counts places: where `point` is seen from the site.
  double place_of(std::uint32_t site, Vec2 point) const;
  Vec2 point_at(std::uint32_t site, double place) const;
  double length_between(std::uint32_t site, double a, double b) const noexcept;
  void append_points(std::uint32_t site, double a, double b, std::vector<Vec2>& points) const;
  /// Half the integral of r x dr along it, r from `origin`.
  double area_between(std::uint32_t site, double a, double b, Vec2 origin) const;

 private:
  void find_crossings();
  void find_pieces();
  bool is_wall(std::uint32_t site) const noexcept;

  const MedialAxisMap& map_;
  double distance_;
  std::vector<ReflexCorner> corner_;  ///< Per site; unused for walls.
  std::vector<LevelCrossing> crossing_;
  std::vector<std::uint32_t> edge_first_;
  std::vector<LevelPiece> piece_;
  std::vector<std::uint32_t> piece_from_;
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

/// Makes it; at distance 0 it is the walls. Empty where the distance is negative or not finite.
OffsetCurve offset_curve(const MedialAxisMap& map, double distance);
OffsetCurve offset_curve(const FloorMap& map, double distance);

}  // namespace docent
