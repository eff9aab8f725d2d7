#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "runtime/crowd/trajectory.h"

namespace docent::crowd {

/// The first body that a trajectory would come too near to.
struct Conflict {
  double seconds = 0;      ///< When; crowd's clock.
  std::uint32_t body = 0;  ///< The other one.
};

/// The trajectories to which all bodies of a floor are committed. A body may be committed only to a
/// trajectory that comes near no other's, so nobody ever walks into anybody (prioritised planning,
/// Erdmann and Lozano-Perez 1987). Every trajectory ends standing, so it is safe for ever.
class ReservationTable {
 public:
  explicit ReservationTable(double body_radius) : radius_(body_radius) {}

  double body_radius() const noexcept { return radius_; }

  /// Commits a body to a trajectory; whatever it was committed to is void.
  void put(std::uint32_t body, Trajectory trajectory);
  void remove(std::uint32_t body) noexcept;

  /// Null for a body that is not in the table.
  const Trajectory* trajectory_of(std::uint32_t body) const noexcept;

  /// The first other body to which this one, on this trajectory, would come nearer than two radii
  /// and `spare` (metres), not before `from` (crowd's clock); none where it meets nobody.
  std::optional<Conflict> first_conflict(std::uint32_t body, const Trajectory& trajectory,
                                         double spare, double from) const noexcept;

  struct Entry {
    std::uint32_t body = 0;
    Trajectory trajectory;
  };
  /// In order of their bodies.
  std::span<const Entry> entries() const noexcept { return entries_; }

 private:
  double radius_;
  std::vector<Entry> entries_;
};

}  // namespace docent::crowd
