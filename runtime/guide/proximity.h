#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "runtime/crowd/meetings.h"
#include "runtime/plan/plan.h"

namespace docent::guide {

struct Agent;

/// Which agents of one floor are near each other, step by step (runtime/crowd/meetings.h). A plan
/// looks at the agents near its own, a blocked agent tries again when something has changed about
/// them, and overlaps are counted.
///
/// Two agents are near each other if they come within `near_reach` in the next `near_horizon`
/// seconds when both go straight on, with no wall between. Borrows the map. Does not
/// allocate in a step.
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
  std::optional<crowd::Meetings> meetings_;  ///< None where there is one agent at most.
  std::vector<crowd::Body> bodies_;          ///< Of the agents that are here.
  std::vector<std::uint32_t> agent_;         ///< Per body: its agent.
  std::vector<plan::Nearby> near_;           ///< Per agent.
  std::vector<Vec2> last_;                   ///< Per agent: where it was.
  std::vector<bool> was_here_;
  std::size_t collisions_ = 0;
};

}  // namespace docent::guide
