#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "runtime/crowd/find_passage.h"
#include "runtime/crowd/reservation_table.h"
#include "runtime/path/building/building_map.h"
#include "runtime/plan/plan.h"

namespace docent::plan {

/// All bodies of a floor, as the worker knows them. Makes plans on which no body meets another.
///
/// A plan is given only where the circle of its walk, frame by frame, stays clear of all
/// trajectories to which others are committed, until the last of them stands; otherwise a shorter
/// one that ends at a safe place, or none for now (`Plan::holds`).
class Traffic {
 public:
  /// Borrows all of it. `building`: of the museum's floors.
  Traffic(const Museum& museum, const motion::WalkGraph* walking, const path::BuildingMap& building,
          std::uint32_t floor);

  /// Answers an order of a body on this floor, but for one with a ride. Without `seconds`, the body
  /// is the only one, and its clock stands still.
  std::unique_ptr<Plan> plan(const WalkOrder& order);

  /// Takes a place for a body that will come out there, from now on; false where another is or will
  /// be there. The plan then says who should make room.
  bool keep_place(const WalkOrder& order, Vec2 place, Plan& plan);
  /// A body leaves the floor; at `when` (crowd's clock) its place is free.
  void leave(std::uint32_t body, double when);

  const crowd::ReservationTable& reservations() const noexcept { return reservations_; }

 private:
  struct Member {
    double rank = 0;
    std::vector<Vec2> line;  ///< Where it wants to go along next.
  };
  void let_go(double now);
  std::unique_ptr<Plan> enter(const WalkOrder& order);
  std::unique_ptr<Plan> seek(const WalkOrder& order);
  std::unique_ptr<Plan> stop(const WalkOrder& order);
  std::unique_ptr<Plan> make_room(const WalkOrder& order);
  std::unique_ptr<Plan> get_on(const WalkOrder& order);
  /// Gives the plan a walk along a way, or some of it; the way begins `done` metres along the
  /// plan's own. False where the body has to stay.
  bool advance(Plan& plan, const Placement& from, std::span<const Vec2> way, double done);
  bool walk_alone(Plan& plan, const Placement& from, std::span<const Vec2> way, double done);
  double seconds_along(const Plan& plan, std::span<const Vec2> way) const;
  double speed_of(const WalkOrder& order) const noexcept;
  crowd::Passage find_passage(const WalkOrder& order, const Placement& from,
                              std::span<const Vec2> way, std::span<const std::uint32_t> near) const;
  /// A passage along a way that begins `done` metres along the plan's own, and the bodies that were
  /// looked at to find it.
  struct Advance {
    const Placement& from;
    std::span<const Vec2> way;
    double done;
    const crowd::Passage& passage;
    std::span<const std::uint32_t> near;
  };
  /// Gives the plan a walk along the passage, as far as nobody is met on it, and returns nothing.
  /// Where there is no such walk: returns a body met that was not looked at, or the body itself.
  std::optional<std::uint32_t> walk(Plan& plan, const Advance& advance);
  motion::Walk walk_to(const Plan& plan, const Advance& advance, std::uint32_t stop) const;
  void end_walk(bool arrives, Plan& plan) const;
  /// When a trajectory first leads into a wall, not before `from` (crowd's clock).
  std::optional<double> first_wall(const crowd::Trajectory& trajectory, double from) const;
  /// Commits the plan's body to a walk if it meets nobody and no wall; else returns the first
  /// conflict. A wall counts as a conflict with the body itself.
  std::optional<crowd::Conflict> commit(Plan& plan, motion::Walk walk);
  std::vector<std::uint32_t> yields_when_asked(const WalkOrder& order) const;

  const Museum& museum_;
  const motion::WalkGraph* walking_;
  const path::BuildingMap& building_;
  const path::FloorMap& map_;
  crowd::ReservationTable reservations_;
  std::map<std::uint32_t, Member> members_;
  std::map<std::uint32_t, double> leaving_;  ///< Per body: when its place is free.
};

}  // namespace docent::plan
