#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "runtime/model/geometry/vec2.h"
#include "runtime/model/none.h"
#include "runtime/path/route.h"

namespace docent::crowd {

/// The Voronoi regions of a floor and their neighbours, to follow a moving point from one region to
/// the next.
///
/// Frame: floor. Borrows the map. Immutable, so any thread may ask.
class Regions {
 public:
  explicit Regions(const path::FloorMap& map);

  /// Where a point is.
  struct Place {
    std::uint32_t region = none;  ///< Its site; `none` for a point off the floor.
    double clearance = 0;         ///< Metres to the nearest wall; perhaps a little less.
    /// Every point nearer to this one than `slack` is in the same region. Metres; perhaps less than
    /// it could be, never more.
    double slack = 0;
  };
  /// Looks on the whole floor.
  Place find(Vec2 point) const noexcept;
  /// The same, beginning in a region: goes to the neighbour that is nearest to the point, until
  /// none is nearer. For a point on a border the answer may be any of the regions that meet there.
  Place follow(Vec2 point, std::uint32_t region) const noexcept;

 private:
  /// A wall from a to b, or a corner, where both are the same.
  struct SiteShape {
    Vec2 a{}, b{}, along{};  ///< `along` is a unit vector.
    double length = 0;       ///< Metres.
    /// Of a wall: the sites of its corners at a and b, where those are reflex. Of a corner: the
    /// sites of the walls that end and begin there.
    std::uint32_t at_a = none;
    std::uint32_t at_b = none;
    bool is_wall = false;
  };
  std::span<const std::uint32_t> next_to(std::uint32_t region) const noexcept {
    return std::span(next_).subspan(next_first_[region],
                                    next_first_[region + 1] - next_first_[region]);
  }
  /// Distance to a site, squared, and how far along its wall the foot of the perpendicular is; that
  /// may lie beyond the wall's ends. Metres.
  struct Foot {
    double distance_squared = 0, at = 0;
  };
  struct Nearer {
    std::uint32_t region = none;
    Foot foot;
  };
  static Foot foot_on(const SiteShape& shape, Vec2 point) noexcept;
  Place place_in(Vec2 point, std::uint32_t region, Foot foot, Nearer& nearer) const noexcept;

  const path::FloorMap& map_;
  std::vector<SiteShape> shape_;
  std::vector<std::uint32_t> next_first_, next_;
};

}  // namespace docent::crowd
