#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "runtime/crowd/trajectory.h"

namespace docent::crowd {

/// A body that would be come too near to.
struct Conflict {
  double seconds = 0;
  std::uint32_t body = 0;  ///< The other one.
};

/// The trajectories to which all bodies of a floor are committed. Whoever wants to go somewhere is
/// free to do so where no other's trajectory is: so nobody ever walks into anybody (prioritised
/// planning, Erdmann and Lozano-Perez 1987; every trajectory ends standing, which is always safe).
class ReservationTable {
 public:
  explicit ReservationTable(double body_radius) : radius_(body_radius) {}

  double body_radius() const noexcept { return radius_; }

  /// Commits a body to a trajectory; whatever it was committed to is void.
  void put(std::uint32_t body, Trajectory trajectory);
  void remove(std::uint32_t body) noexcept;

  /// Null for a body that is not here.
  const Trajectory* trajectory_of(std::uint32_t body) const noexcept;

  /// Of all others, whom a body on this trajectory would first come nearer than two radii and
  /// `spare`, and when.
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
