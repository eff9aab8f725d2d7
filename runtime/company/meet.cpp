#include "runtime/company/meet.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
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
  bool is_empty() const noexcept { return count_ == 0; }
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
  for (int halvings = 0; halvings < 40; ++halvings) {
    const double middle = first + (last - first) / 2;
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

/// What plain arithmetic can say of the way between two bodies, where rounding cannot matter.
enum class Glance : std::uint8_t { Open, PathBlocked, SightBlocked, Unsure };

/// The way goes from `from[0]` to `to[0]`, to `to[1]`, and back to `from[1]`.
Glance glance(const Bays& floor, const std::array<Vec2, 2>& from,
              const std::array<Vec2, 2>& to) noexcept {
  // Square metres, for the sides of a line: many times the rounding where nothing is further out
  // than `furthest`.
  constexpr double rounding = 1e-7, furthest = 1e5;
  const Vec2 low = glm::min(glm::min(from[0], to[0]), glm::min(from[1], to[1]));
  const Vec2 high = glm::max(glm::max(from[0], to[0]), glm::max(from[1], to[1]));
  const double widest = 4 * floor.size();
  if (!(high.x - low.x < widest && high.y - low.y < widest && std::abs(low.x) < furthest &&
        std::abs(low.y) < furthest))
    return Glance::Unsure;
  const std::array<std::array<Vec2, 2>, 3> line{
      {{from[0], to[0]}, {from[1], to[1]}, {to[0], to[1]}}};
  Glance seen = Glance::Open;
  floor.visit_walls(low, high, [&](Vec2 a, Vec2 b) {
    if (std::max(a.x, b.x) < low.x || std::min(a.x, b.x) > high.x || std::max(a.y, b.y) < low.y ||
        std::min(a.y, b.y) > high.y)
      return true;
    const Vec2 wall = b - a;
    const auto side = [&](Vec2 point) { return cross(wall, point - a); };
    const std::array sides{side(from[0]), side(to[0]), side(from[1]), side(to[1])};
    const auto [least, most] = std::ranges::minmax(sides);
    if (least > rounding || most < -rounding) return true;
    const std::array<std::array<double, 2>, 3> line_sides{
        {{sides[0], sides[1]}, {sides[2], sides[3]}, {sides[1], sides[3]}}};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [s, t] = line_sides[i];
      if ((s > rounding && t > rounding) || (s < -rounding && t < -rounding)) continue;
      const Vec2 along = line[i][1] - line[i][0];
      const double a_side = cross(along, a - line[i][0]), b_side = cross(along, b - line[i][0]);
      if ((a_side > rounding && b_side > rounding) || (a_side < -rounding && b_side < -rounding))
        continue;
      const bool crosses = std::min(s, t) < -rounding && std::max(s, t) > rounding &&
                           std::min(a_side, b_side) < -rounding &&
                           std::max(a_side, b_side) > rounding;
      if (crosses && i < 2) {
        seen = Glance::PathBlocked;
        return false;
      }
      if (!crosses) seen = Glance::Unsure;
      if (seen == Glance::Open) seen = Glance::SightBlocked;
    }
    return true;
  });
  return seen;
}

}  // namespace

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
  switch (glance(floor, {a.position, b.position},
                 {place_at(a, contact.first), place_at(b, contact.first)})) {
    case Glance::Open:
      return contact.first;
    case Glance::PathBlocked:
      return {};
    case Glance::SightBlocked:
      break;
    case Glance::Unsure:
      if (!walls.segment_clear(a.position, place_at(a, contact.first)) ||
          !walls.segment_clear(b.position, place_at(b, contact.first)))
        return {};
      if (in_sight(contact.first)) return contact.first;
  }

  // A wall is between them when they touch first. Do they see each other later? Sight begins and
  // ends where a corner passes the line between them, and is the same in between.
  Moments moments;
  const std::array ends{place_at(a, contact.first), place_at(a, contact.last),
                        place_at(b, contact.first), place_at(b, contact.last)};
  const Vec2 low = glm::min(glm::min(ends[0], ends[1]), glm::min(ends[2], ends[3]));
  const Vec2 high = glm::max(glm::max(ends[0], ends[1]), glm::max(ends[2], ends[3]));
  floor.visit_corners(low, high,
                      [&](Vec2 corner) { add_passings(a, b, corner, contact, moments); });
  if (moments.is_empty()) return {};
  double last = last_on_floor(walls, a, contact.first, contact.last);
  last = last_on_floor(walls, b, contact.first, last);
  moments.add(contact.first);
  moments.add(last);
  if (moments.is_full()) return contact.first;
  const auto times = moments.sorted();
  for (std::size_t i = 0; i + 1 < times.size() && times[i] < last; ++i)
    if (times[i] < times[i + 1] && in_sight(times[i] + (times[i + 1] - times[i]) / 2))
      return times[i];
  return {};
}

}  // namespace docent
