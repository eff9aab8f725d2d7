#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "runtime/crowd/body.h"
#include "runtime/crowd/cells.h"
#include "runtime/crowd/meet.h"
#include "runtime/crowd/regions.h"
#include "runtime/model/geometry/vec2.h"
#include "runtime/model/none.h"

namespace docent::crowd {

/// Two bodies that collide now or soon.
struct Meeting {
  std::uint32_t a = 0, b = 0;  ///< Indices of the bodies, a < b.
  double time = 0;             ///< Seconds from now; 0 where they touch already.
};

/// Who meets whom, step after step: all pairs for which `time_of_impact` (meet.h) has an answer,
/// and no others, found without comparing everybody with everybody.
///
/// For every body its Voronoi region is known, followed from neighbour to neighbour, and its cover:
/// the cells that its circle passes over up to the horizon, as far as one can walk to them under
/// the circle. Two bodies that meet share a cell: the point where their circles touch is on the
/// open line between the centres. A cover is made a little larger than need be and kept, with the
/// neighbours found in it, until the body leaves it. So a step compares each body with the few that
/// it may meet, and only a body that has left its cover looks for neighbours again.
///
/// What is kept changes the cost of an answer and never the answer. There may be any number of
/// bodies up to `most_bodies`, and they may jump, come and go. Those that reach over dozens of
/// cells, or are off the floor, are compared with everybody. Borrows the map. For one thread; the
/// frame loop may call it: nothing is allocated while there are at most 4096 pairs of neighbours,
/// or eight to a body on average, or no more than ever before.
class Meetings {
 public:
  Meetings(const path::FloorMap& map, std::size_t most_bodies);

  /// Where everybody is now. Those beyond `most_bodies` are left out.
  void update(std::span<const Body> bodies) noexcept;

  /// All meetings from now to the horizon (seconds; see meet.h), sorted by a, then b. Valid until
  /// the next call. Quickest where the horizon is the same in every step.
  std::span<const Meeting> find(double horizon);

  /// The Voronoi region (site) that a body is in; none off the floor.
  std::uint32_t region_of(std::size_t body) const noexcept;
  const WalkableCells& cells() const noexcept { return cells_; }

 private:
  static constexpr std::size_t most_cells = 32;  ///< That one body covers.

  /// A place, and where it was looked up.
  struct CachedPlace {
    Vec2 at{};
    double clearance = -1;  ///< A move shorter than that passes no wall. Negative: to be looked up.
    double slack = -1;      ///< A move shorter than that stays in the region.
    std::uint32_t region = none;
  };
  /// What a body covers: all cells under a capsule that one can walk to from the body's cell
  /// without leaving the cells under the capsule. Holds while the body, now and at the horizon, is
  /// within `tolerance` of the capsule's axis. The body has been at the clear place, and no wall is
  /// within `clear_radius` of that: a body within it has passed no wall. Fills one cache line.
  struct alignas(64) CachedCover {
    Vec2 from{}, along{};  ///< Where the axis begins; its unit vector, or (0, 0) for a point.
    float length = 0;      ///< Of the axis. All lengths here are metres.
    float tolerance = 0;
    float radius = -1;               ///< Of the body, or a little more.
    float clear_x = 0, clear_y = 0;  ///< The clear place, relative to `from`.
    float clear_radius = 0;
    std::uint32_t cells = 0;  ///< How many; 0 for a body without a cover.

    bool is_near(Vec2 point, double most_along, double most_beside) const noexcept {
      const Vec2 way = point - from;
      const Vec2 beside = way - std::min(std::max(dot(way, along), 0.0), most_along) * along;
      return dot(beside, beside) <= most_beside * most_beside;
    }
    bool holds(const Body& now, Vec2 end) const noexcept;
    Vec2 clear_place() const noexcept { return from + Vec2{clear_x, clear_y}; }
    bool is_clear_at(Vec2 point) const noexcept {
      const Vec2 way = point - clear_place();
      return dot(way, way) <= static_cast<double>(clear_radius) * clear_radius;
    }
    /// Is the straight way there from the clear place open, with so much room about its end?
    bool leads_to(Vec2 point, double clearance) const noexcept {
      return glm::distance(point, clear_place()) < clear_radius + clearance;
    }
    void clear(Vec2 place, double clearance) noexcept;
  };
  static constexpr std::uint32_t occupants_a_block = 14;
  /// Who is in a cell, in one cache line. Cell i begins with block i; the blocks that follow it by
  /// `next` are full.
  struct alignas(64) OccupantBlock {
    std::uint32_t next = none;
    std::uint32_t count = 0;
    std::array<std::uint32_t, occupants_a_block> occupant{};
  };
  struct Mover {
    Body now;
    std::uint32_t version = 1;  ///< Grows with every new cover.
    bool takes_part = false;
  };
  /// Two bodies whose capsules come near each other; valid while both covers have these versions.
  struct Neighbours {
    std::uint32_t a = 0, b = 0;    ///< The one that looked first.
    std::uint32_t versions = 0;    ///< The sum of both; 0 for two who need no comparing.
    Sight sight = Sight::Unknown;  ///< While both covers hold.
  };

  void sort_bodies() noexcept;
  void swap_bodies(std::uint32_t a, std::uint32_t b) noexcept;
  void look_up(std::uint32_t body) noexcept;
  std::uint32_t cell_of(std::uint32_t body) noexcept;
  bool is_on_floor(std::uint32_t body) noexcept;
  std::span<const std::uint32_t> list_leavers(double horizon) noexcept;
  bool is_covered(std::uint32_t body, Vec2 end) noexcept;
  void cover(std::uint32_t body, Vec2 end);
  void uncover(std::uint32_t body) noexcept;
  void enter(std::uint32_t cell, std::uint32_t body) noexcept;
  void leave(std::uint32_t cell, std::uint32_t body) noexcept;
  using CellList = std::array<std::uint32_t, most_cells>;
  std::uint32_t followed_cell(std::uint32_t body, double clearance) const noexcept;
  std::uint32_t list_cells(const CachedCover& cover, std::uint32_t own,
                           CellList& list) const noexcept;
  void enter_cells(std::uint32_t body, const CachedCover& made, const CellList& list);
  static SweptLine swept_line_of(const CachedCover& cover) noexcept {
    return {cover.from, cover.from + static_cast<double>(cover.length) * cover.along,
            cover.tolerance};
  }
  bool may_meet(const CachedCover& a, const CachedCover& b) const noexcept;
  void compare_neighbours(double horizon);
  void compare_with_everybody(std::uint32_t body, double horizon);
  std::pair<std::uint32_t, std::uint32_t> in_order(std::uint32_t a, std::uint32_t b) const noexcept;
  void sort_found();

  Regions regions_;
  WalkableCells cells_;
  std::size_t most_bodies_;
  std::uint32_t count_ = 0;  ///< Of the bodies given.
  std::uint64_t steps_ = 0;
  /// Bodies that are near each other get numbers near each other, for the caches: a body has a
  /// number in here and an index for the caller. What follows is by number, unless said otherwise.
  std::uint32_t numbers_ = 0;  ///< In use.
  std::vector<std::uint32_t> index_of_;
  std::vector<std::uint32_t> number_of_;  ///< By index.
  struct Numbering {
    std::uint32_t square = 0, before = 0;
  };
  std::vector<Numbering> numbering_;
  std::vector<Mover> body_;
  std::vector<CachedPlace> place_;
  std::vector<CachedCover> cover_;
  std::vector<std::uint32_t> covered_;  ///< Cells, `most_cells` per body.
  std::vector<OccupantBlock> blocks_;
  std::uint32_t spare_block_ = none;    ///< The first block that no cell uses.
  std::vector<std::uint64_t> seen_in_;  ///< Per body: the last look that met it.
  std::uint64_t looks_ = 0;
  std::vector<Neighbours> neighbours_;  ///< By a.
  std::vector<Neighbours> new_neighbours_, merged_;
  std::vector<std::uint32_t> candidate_;   ///< Neighbours that come near each other in time.
  std::vector<std::uint32_t> leaver_;      ///< Bodies that have perhaps left their cover.
  std::vector<std::uint32_t> everywhere_;  ///< Bodies to compare with everybody.
  std::vector<Meeting> found_, sorted_;
  std::vector<std::uint32_t> first_found_;
};

}  // namespace docent::crowd
