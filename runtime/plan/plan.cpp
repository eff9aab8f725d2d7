#include "runtime/plan/plan.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "runtime/plan/stretch.h"

namespace docent::plan {

void Nearby::add(std::uint32_t other, double when) noexcept {
  std::size_t at = count;
  while (at > 0 && seconds[at - 1] > when) --at;
  if (at == most) return;
  count = std::min<std::uint32_t>(count + 1, most);
  for (std::size_t i = count - 1; i > at; --i) {
    agent[i] = agent[i - 1];
    seconds[i] = seconds[i - 1];
  }
  agent[at] = other;
  seconds[at] = static_cast<float>(when);
}

Vec2 point_along(const Plan& plan, double metres) noexcept {
  if (plan.points.empty()) return {};
  const auto after = std::ranges::upper_bound(plan.reach, metres);
  if (after == plan.reach.begin()) return plan.points.front();
  if (after == plan.reach.end()) return plan.points.back();
  const auto i = static_cast<std::size_t>(after - plan.reach.begin());
  const double t = (metres - plan.reach[i - 1]) / (plan.reach[i] - plan.reach[i - 1]);
  return glm::mix(plan.points[i - 1], plan.points[i], t);
}

std::unique_ptr<Plan> make_standing(const Museum& museum, const Placement& place) {
  const Result<motion::WalkGraph> walking = motion::make_walk_graph(museum.motion);
  return make_standing(walking ? &*walking : nullptr, place);
}

std::unique_ptr<Plan> make_standing(const motion::WalkGraph* walking, const Placement& place) {
  auto plan = std::make_unique<Plan>();
  plan->order.start = place;
  plan->status = path::RouteStatus::Ok;
  // A walk begins standing: its first frame is the pose.
  const std::array path{place.position,
                        place.position + Vec2{std::cos(place.heading), std::sin(place.heading)}};
  plan->walk = walk_along(walking, plan->order, place, path, {});
  motion::Walk& walk = plan->walk;
  walk.root.resize(1);
  walk.rotation.resize(walk.joint_count);
  walk.plants.resize(1);
  walk.body.assign(1, place);
  walk.along.assign(1, 0);
  walk.gait.assign(1, motion::Gait::Idle);
  walk.source.resize(1);
  return plan;
}

}  // namespace docent::plan
