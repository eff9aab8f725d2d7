#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "runtime/plan/plan.h"
#include "runtime/plan/traffic.h"

namespace docent::plan {

/// Who is on which connection, as the worker knows it. Gives no ride on which one body meets
/// another: a ride begins when the place where the body comes out is free, which is kept for it
/// from then on, and when nobody else is between its two stops.
class Rides {
 public:
  /// Seconds for which the place that a body leaves is still taken.
  static constexpr double leaving_seconds = 1.5;

  explicit Rides(const Museum& museum, const motion::WalkGraph* walking)
      : museum_(museum), walking_(walking) {}

  /// Answers an order with a ride. `from`, `to`: of the floors that it leads from and to.
  std::unique_ptr<Plan> plan(const WalkOrder& order, Traffic& from, Traffic& to);

 private:
  struct Taken {
    std::uint32_t connection = 0, low = 0, high = 0;  ///< The stops between which it is.
    std::uint32_t body = 0;
    double until = 0;  ///< Crowd's clock.
  };
  bool is_taken(const Ride& ride, std::uint32_t body) const noexcept;
  motion::Walk walk_of(const WalkOrder& order, const Placement& from) const;
  std::optional<motion::Walk> take_stairs(const WalkOrder& order, const Placement& from,
                                          const Placement& to) const;

  const Museum& museum_;
  const motion::WalkGraph* walking_;
  std::vector<Taken> taken_;
};

}  // namespace docent::plan
