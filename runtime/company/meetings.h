#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/company/bays.h"
#include "runtime/company/body.h"
#include "runtime/company/meet.h"
#include "runtime/company/regions.h"
#include "runtime/model/geometry/vec2.h"

namespace docent {

/// Two bodies that collide now or soon.
struct Meeting {
  std::uint32_t a = 0, b = 0;  ///< Indices of the bodies, a < b.
  double time = 0;             ///< Seconds from now; 0 where they touch already.
};

/// Who meets whom, step after step: all pairs for which `time_of_meeting` (meet.h) has an answer,
/// and no others, found without comparing everybody with everybody.
///
/// Every body is known by its Voronoi region, followed from neighbour to neighbour, and by the bays
/// that its circle covers on its way up to the horizon, as far as one can walk to them under it.
/// Who meet share a bay: the point where the circles touch is on the open line between the centres.
/// Both are kept while a body stays near where they were made, so a step costs little more than
/// looking at those who share a bay.
///
/// What is kept changes the cost of an answer and never the answer. Bodies may be given in any
/// number up to the one promised, jump, come and go. Bodies that reach over dozens of bays are
/// compared with everybody. Borrows the map. For one thread; the frame loop may call it: nothing is
/// allocated while no more meetings are found at once than ever before (there is room for four
/// times as many as bodies).
class Meetings {
 public:
  Meetings(const FloorMap& map, std::size_t most_bodies);

  /// Where everybody is now. More than promised are left out, the last ones.
  void update(std::span<const Body> bodies) noexcept;

  /// All meetings from now to the horizon (seconds; see meet.h), by a, then by b. Valid until the
  /// next call.
  std::span<const Meeting> find(double horizon);

  /// The Voronoi region (site) that a body is in; Regions::none off the floor.
  std::uint32_t region_of(std::size_t body) const noexcept { return place_[body].region; }
  const Bays& bays() const noexcept { return bays_; }

 private:
  static constexpr std::size_t most_bays = 32;  ///< That one body covers.

  /// A place, and where it was looked up.
  struct KeptPlace {
    Vec2 at{};
    double slack = -1;  ///< Negative: to be looked up.
    double clearance = 0;
    std::uint32_t region = Regions::none;
    bool takes_part = false;
  };
  /// What a body covers: all bays under a capsule, somewhat wider than its own, that one can walk
  /// to from the body's bay without leaving the capsule's bays.
  struct KeptCover {
    Vec2 from{}, along{};  ///< The capsule's axis begins here; a unit vector, or none.
    double length = 0;     ///< Of the axis, metres.
    double radius = -1;    ///< Of the body. Negative: to be made.
    std::uint32_t square = 0, region = 0;  ///< The body's own.
    std::uint32_t bays = 0;  ///< How many; 0 for a body that is compared with everybody.
  };
  /// A body as those who share a bay look at it.
  struct Guest {
    Vec2 position{}, velocity{};
    double radius = 0;
    std::uint32_t index = 0;
  };

  std::span<const std::uint32_t> bays_of(std::uint32_t body) const noexcept {
    return std::span(cover_bay_).subspan(body * most_bays, cover_[body].bays);
  }
  bool is_covered(std::uint32_t body, Vec2 end) noexcept;
  void cover(std::uint32_t body, Vec2 end) noexcept;
  void sort_into_bays();
  void compare_in_bay(std::uint32_t bay, double horizon);
  void compare_with_everybody(std::uint32_t body, double horizon);
  bool is_first_bay_of_both(std::uint32_t bay, std::uint32_t a, std::uint32_t b) const noexcept;
  void add(std::uint32_t a, std::uint32_t b, const Collision& contact);
  bool is_far_from_walls(std::uint32_t a, std::uint32_t b, double time) const noexcept;
  void sort_found();

  Regions regions_;
  Bays bays_;
  std::size_t most_bodies_;
  std::vector<Body> body_;
  std::vector<KeptPlace> place_;
  std::vector<KeptCover> cover_;
  std::vector<std::uint32_t> cover_bay_;    ///< `most_bays` per body.
  std::vector<std::uint32_t> everywhere_;   ///< Bodies to compare with everybody.
  std::vector<std::uint32_t> guests_;       ///< Per bay: how many; 0 between two calls.
  std::vector<std::uint32_t> first_guest_;  ///< Per bay with guests: where they begin.
  std::vector<std::uint32_t> used_bay_;
  std::vector<std::uint32_t> guest_;  ///< Bodies, by bay.
  std::vector<Guest> company_;        ///< Of one bay.
  std::vector<Meeting> found_, sorted_;
  std::vector<std::uint32_t> first_found_;
};

}  // namespace docent
