#include "runtime/company/meet.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "runtime/path/floor_map.h"

namespace docent {
namespace {

Vec2 place_at(const Body& body, double time) noexcept {
  return body.position + time * body.velocity;
}

/// The times, ascending, at which something may change between two bodies.
class Moments {
 public:
  bool is_full() const noexcept { return count_ == time_.size(); }
  void add(double time) noexcept {
    if (!is_full()) time_[count_++] = time;
  }
  std::span<const double> sorted() noexcept {
    std::ranges::sort(std::span(time_).first(count_));
    return std::span(time_).first(count_);
  }

 private:
  std::array<double, 67> time_{};
  std::size_t count_ = 0;
};

/// The last time, up to `last`, to which the straight way of a centre stays on the floor, given
/// that it does to `first`.
double last_on_floor(const WallGrid& walls, const Body& body, double first, double last) noexcept {
  if (walls.segment_clear(body.position, place_at(body, last))) return last;
  for (int halvings = 0; halvings < 60; ++halvings) {
    const double middle = first + (last - first) / 2;
    if (middle <= first || middle >= last) break;
    (walls.segment_clear(body.position, place_at(body, middle)) ? first : last) = middle;
  }
  return first;
}

/// Adds the times within the contact at which a corner is on the line between the two centres. In
/// (a + t u, b + t v, corner) the orientation is a quadratic polynomial of t.
void add_passings(const Body& a, const Body& b, Vec2 corner, const Collision& contact,
                  Moments& moments) noexcept {
  const Vec2 apart = b.position - a.position, drift = b.velocity - a.velocity;
  const Vec2 to_corner = corner - a.position;
  const double squared = -cross(drift, a.velocity);
  const double linear = cross(drift, to_corner) - cross(apart, a.velocity);
  const double constant = cross(apart, to_corner);
  const double discriminant = linear * linear - 4 * squared * constant;
  if (!(discriminant >= 0)) return;
  const double sum = -(linear + std::copysign(std::sqrt(discriminant), linear)) / 2;
  const auto consider = [&](double time) {
    if (!(time > contact.first && time < contact.last)) return;
    const Vec2 line = apart + time * drift;
    const double along = dot(to_corner - time * a.velocity, line);
    constexpr double more = 1e-9;  // Rather one that is none than none that is one.
    if (along >= -more && along <= dot(line, line) + more) moments.add(time);
  };
  if (squared != 0) consider(sum / squared);
  if (sum != 0) consider(constant / sum);
}

}  // namespace

bool takes_part(const Body& body) noexcept {
  const auto is_number = [](double value) { return std::abs(value) <= largest_number; };
  return is_number(body.position.x) && is_number(body.position.y) && is_number(body.velocity.x) &&
         is_number(body.velocity.y) && body.radius >= 0 && is_number(body.radius);
}

double clamp_horizon(double horizon) noexcept {
  return horizon > 0 ? std::min(horizon, largest_horizon) : 0;
}

std::optional<double> time_of_meeting(const Bays& floor, const Body& a, const Body& b,
                                      double horizon) noexcept {
  if (!takes_part(a) || !takes_part(b)) return {};
  const auto contact = contact_of_circles(a, b, clamp_horizon(horizon));
  if (!contact) return {};
  if (!floor.map().is_inside(a.position) || !floor.map().is_inside(b.position))
    return contact->first;
  return time_in_sight(floor, a, b, *contact);
}

std::optional<double> time_in_sight(const Bays& floor, const Body& a, const Body& b,
                                    const Collision& contact) noexcept {
  const WallGrid& walls = floor.map().walls();
  const auto in_sight = [&](double time) {
    return walls.segment_clear(place_at(a, time), place_at(b, time));
  };
  if (!walls.segment_clear(a.position, place_at(a, contact.first)) ||
      !walls.segment_clear(b.position, place_at(b, contact.first)))
    return {};
  if (in_sight(contact.first)) return contact.first;

  // A wall is between them when they touch first. Do they see each other later? Sight begins and
  // ends where a corner passes the line between them, and is the same in between.
  Collision open = contact;
  open.last = last_on_floor(walls, a, open.first, open.last);
  open.last = last_on_floor(walls, b, open.first, open.last);
  Moments moments;
  moments.add(open.first);
  moments.add(open.last);
  const std::array ends{place_at(a, open.first), place_at(a, open.last), place_at(b, open.first),
                        place_at(b, open.last)};
  const Vec2 low = glm::min(glm::min(ends[0], ends[1]), glm::min(ends[2], ends[3]));
  const Vec2 high = glm::max(glm::max(ends[0], ends[1]), glm::max(ends[2], ends[3]));
  floor.visit_corners(low, high, [&](Vec2 corner) { add_passings(a, b, corner, open, moments); });
  if (moments.is_full()) return contact.first;
  const auto times = moments.sorted();
  for (std::size_t i = 0; i + 1 < times.size(); ++i)
    if (times[i] < times[i + 1] && in_sight(times[i] + (times[i + 1] - times[i]) / 2))
      return times[i];
  return {};
}

}  // namespace docent
