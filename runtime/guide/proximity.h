#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "runtime/crowd/meetings.h"
#include "runtime/plan/plan.h"

namespace docent::guide {

struct Agent;

/// Who is or soon will be near whom among the agents of one floor, step by step
/// (runtime/crowd/meetings.h). A plan looks at those, whoever is blocked tries again when something
/// has changed about them, and who touches is counted.
///
/// Near is who comes within `near_reach` of another in the next `near_horizon` seconds if both go
/// straight on, with no wall between. Borrows the map. Does not allocate in a step.
class Proximity {
 public:
  static constexpr double near_reach = 1.2;  ///< Metres between two centres.
  static constexpr double near_horizon = 4;  ///< Seconds.

  Proximity(const path::FloorMap& map, std::uint32_t floor, double body_radius, std::size_t most);

  /// Where everybody is, `seconds` after the last look.
  void look(std::span<const Agent> agents, double seconds) noexcept;

  const plan::Nearby& near(std::uint32_t agent) const noexcept { return near_[agent]; }
  /// Pairs whose circles overlap, and agents whose circle is in a wall; 0 at all times, by design.
  std::size_t collisions() const noexcept { return collisions_; }

 private:
  const path::FloorMap& map_;
  std::uint32_t floor_;
  double body_radius_;
  std::optional<crowd::Meetings> meetings_;  ///< None for one who is alone.
  std::vector<crowd::Body> bodies_;          ///< Of those who are here.
  std::vector<std::uint32_t> agent_;         ///< Whose body that is.
  std::vector<plan::Nearby> near_;           ///< Per agent.
  std::vector<Vec2> last_;                   ///< Per agent: where it was.
  std::vector<bool> was_here_;
  std::size_t collisions_ = 0;
};

}  // namespace docent::guide
