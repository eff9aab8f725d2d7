#include "runtime/crowd/trajectory.h"

#include <algorithm>
#include <cmath>

#include "runtime/crowd/contact.h"

namespace docent::crowd {

Trajectory standing_trajectory(Vec2 place) {
  return {0, {place}};
}

Vec2 place_at(const Trajectory& trajectory, double seconds) noexcept {
  const double at = (seconds - trajectory.start) / Trajectory::step;
  if (at <= 0) return trajectory.place.front();
  const auto last = static_cast<double>(trajectory.place.size() - 1);
  if (at >= last) return trajectory.place.back();
  const auto i = static_cast<std::size_t>(at);
  return glm::mix(trajectory.place[i], trajectory.place[i + 1], at - static_cast<double>(i));
}

std::optional<double> first_impact(const Trajectory& a, const Trajectory& b, double distance,
                                   double from) noexcept {
  const double end = std::max({a.end(), b.end(), from});
  Vec2 now = place_at(b, from) - place_at(a, from);
  if (dot(now, now) < distance * distance) return from;
  // Steps of the finer of both clocks: each body bends only at its own times.
  for (double t = from; t < end;) {
    const auto next_of = [t](const Trajectory& c) {
      const double steps = std::floor((t - c.start) / Trajectory::step + 1e-6) + 1;
      return c.start + Trajectory::step * std::max(0.0, steps);
    };
    const double next = std::min({next_of(a), next_of(b), end});
    const Vec2 then = place_at(b, next) - place_at(a, next);
    const double seconds = next - t;
    // Who is far away may be left out for as long as both could need to come near.
    constexpr double fastest = 4;  // metres a second, of both together
    if (const double gap = glm::length(now) - distance; gap > fastest * 0.5) {
      t += gap / fastest;
      now = place_at(b, t) - place_at(a, t);
      continue;
    }
    if (seconds > 1e-9)
      if (const auto met = contact(make_approach(now, (then - now) / seconds, distance), seconds))
        return t + met->first;
    t = next;
    now = then;
  }
  return {};
}

}  // namespace docent::crowd
