#include "runtime/crowd/meet.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "runtime/crowd/branchless.h"
#include "runtime/crowd/contact.h"
#include "runtime/model/geometry/segment.h"
#include "runtime/path/floor_map.h"

namespace docent::crowd {
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
double last_on_floor(const WalkableCells& floor, const Body& body, double first,
                     double last) noexcept {
  const path::WallGrid& walls = floor.map().walls();
  const auto is_clear_to = [&](double time) {
    return walls.segment_clear(body.position, place_at(body, time));
  };
  if (is_clear_to(last)) return last;
  // Plain arithmetic guesses, and the exact test says how near that is.
  constexpr double near = 1e-9, near_enough = 1e-12;
  const Vec2 from = place_at(body, first), to = place_at(body, last);
  double guess = last;
  floor.visit_walls(glm::min(from, to), glm::max(from, to), [&](Vec2 a, Vec2 b) {
    const double a_side = cross(body.velocity, a - body.position);
    const double b_side = cross(body.velocity, b - body.position);
    const double time = cross(b - a, a - body.position) / cross(b - a, body.velocity);
    if (a_side * b_side <= 0 && time > first) guess = std::min(guess, time);
    return true;
  });
  for (const double time : {guess - near, guess + near})
    if (time > first && time < last) (is_clear_to(time) ? first : last) = time;
  for (int halvings = 0; halvings < 40 && last - first > near_enough; ++halvings) {
    const double middle = first + (last - first) / 2;
    (is_clear_to(middle) ? first : last) = middle;
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

/// The least and the most of some numbers.
struct Range {
  double least = 0, most = 0;
};
Range range_of(double a, double b) noexcept {
  return {std::min(a, b), std::max(a, b)};
}
Range range_of(double a, double b, double c, double d) noexcept {
  return {std::min(std::min(a, b), std::min(c, d)), std::max(std::max(a, b), std::max(c, d))};
}
bool are_apart(Range a, Range b, double by) noexcept {
  return (a.most + by < b.least) | (b.most + by < a.least);
}

/// What plain arithmetic can say of the way between two bodies, where rounding cannot matter.
enum class Glance : std::uint8_t { Open, PathBlocked, SightBlocked, Unsure };

/// The way goes from `from[0]` to `to[0]`, to `to[1]`, and back to `from[1]`.
Glance glance(const WalkableCells& floor, const std::array<Vec2, 2>& from,
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
    if (any_holds(are_apart(range_of(a.x, b.x), {low.x, high.x}, 0),
                  are_apart(range_of(a.y, b.y), {low.y, high.y}, 0)))
      return true;
    const Vec2 wall = b - a;
    const auto side = [&](Vec2 point) { return cross(wall, point - a); };
    const std::array sides{side(from[0]), side(to[0]), side(from[1]), side(to[1])};
    const auto [least, most] = range_of(sides[0], sides[1], sides[2], sides[3]);
    if ((least > rounding) | (most < -rounding)) return true;
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

/// `margin` is many times the rounding on a floor of that size. Metres.
constexpr double furthest_stretch = 1e5;

bool is_far_out(Vec2 low, Vec2 high) noexcept {
  return !(low.x > -furthest_stretch && low.y > -furthest_stretch && high.x < furthest_stretch &&
           high.y < furthest_stretch);
}

/// Do all lines from one stretch to the other cross the wall from a to b? So they do if the line of
/// the wall parts the stretches, and is crossed between the wall's ends.
bool parts(Vec2 a, Vec2 b, const std::array<Vec2, 4>& ends, double tolerance) noexcept {
  const double length = glm::distance(a, b);
  if (!(length > 0)) return false;
  const Vec2 along = (b - a) / length;
  std::array<double, 4> side{}, at{};
  for (std::size_t i = 0; i < 4; ++i) {
    side[i] = cross(along, ends[i] - a);
    at[i] = dot(along, ends[i] - a);
  }
  const double sign = side[0] > 0 ? 1 : -1;
  if (!(sign * side[0] > tolerance && sign * side[1] > tolerance && sign * side[2] < -tolerance &&
        sign * side[3] < -tolerance))
    return false;
  for (const std::size_t i : {0, 1})
    for (const std::size_t j : {2, 3}) {
      // Lines begin and end within the tolerance of these, so they cross within the tolerance of
      // where these are so near to the wall.
      const double turn = (at[j] - at[i]) / (side[j] - side[i]);
      const double first = at[i] + (tolerance - side[i]) * turn,
                   last = at[i] - (tolerance + side[i]) * turn;
      if (!(std::min(first, last) > tolerance && std::max(first, last) < length - tolerance))
        return false;
    }
  return true;
}

}  // namespace

double clearance_at(const WalkableCells& floor, Vec2 point, double most) noexcept {
  const Vec2 low = point - most, high = point + most;
  double nearest = most * most;
  floor.visit_walls(low, high, [&](Vec2 a, Vec2 b) {
    if (any_holds(are_apart(range_of(a.x, b.x), {low.x, high.x}, 0),
                  are_apart(range_of(a.y, b.y), {low.y, high.y}, 0)))
      return true;
    nearest = std::min(nearest, nearest_on_segment(point, a, b).distance_squared);
    return true;
  });
  return std::max(std::sqrt(nearest) - margin, 0.0);
}

Sight sight_between(const WalkableCells& floor, const SweptLine& a, const SweptLine& b) noexcept {
  // A wall that parts them parts them, but meet.h has it that those whom more corners pass are not
  // watched; as many as that have more walls.
  constexpr int most_walls = 30, most_that_part_nobody = 3;
  const double tolerance = std::max(a.tolerance, b.tolerance) + margin;
  const std::array ends{a.from, a.to, b.from, b.to};
  const Range x = range_of(ends[0].x, ends[1].x, ends[2].x, ends[3].x);
  const Range y = range_of(ends[0].y, ends[1].y, ends[2].y, ends[3].y);
  const Vec2 low{x.least - tolerance, y.least - tolerance},
      high{x.most + tolerance, y.most + tolerance};
  if (is_far_out(low, high)) return Sight::Either;
  const Vec2 between = b.from + b.to - a.from - a.to;
  const double distance = std::sqrt(dot(between, between));
  const Vec2 across = distance > 0 ? left_of(between) / distance : Vec2{0, 1};
  const auto beside = [&](Vec2 point) { return dot(across, point); };
  const Range lane = range_of(beside(ends[0]), beside(ends[1]), beside(ends[2]), beside(ends[3]));
  int walls = 0;
  bool is_parted = false;
  floor.visit_walls(low, high, [&](Vec2 from, Vec2 to) {
    if (any_holds(are_apart(range_of(from.x, to.x), x, tolerance),
                  are_apart(range_of(from.y, to.y), y, tolerance),
                  are_apart(range_of(beside(from), beside(to)), lane, tolerance)))
      return true;
    const Vec2 wall = to - from;
    const auto side = [&](Vec2 point) { return cross(wall, point - from); };
    const Range sides = range_of(side(ends[0]), side(ends[1]), side(ends[2]), side(ends[3]));
    const double aside = tolerance * std::sqrt(dot(wall, wall));
    if (sides.least > aside || sides.most < -aside) return true;
    is_parted = is_parted || parts(from, to, ends, tolerance);
    return ++walls <= (is_parted ? most_walls : most_that_part_nobody);
  });
  if (walls == 0) return Sight::Open;
  return is_parted && walls <= most_walls ? Sight::Closed : Sight::Either;
}

double clamp_horizon(double horizon) noexcept {
  return horizon > 0 ? std::min(horizon, largest_horizon) : 0;
}

std::optional<double> time_of_impact(const WalkableCells& floor, const Body& a, const Body& b,
                                     double horizon) noexcept {
  if (!takes_part(a) || !takes_part(b)) return {};
  const auto contact = contact_of_circles(a, b, clamp_horizon(horizon));
  if (!contact) return {};
  if (!floor.map().is_inside(a.position) || !floor.map().is_inside(b.position))
    return contact->first;
  return time_in_sight(floor, a, b, *contact);
}

std::optional<double> time_in_sight(const WalkableCells& floor, const Body& a, const Body& b,
                                    const Collision& contact) noexcept {
  const path::WallGrid& walls = floor.map().walls();
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
  double last = last_on_floor(floor, a, contact.first, contact.last);
  last = last_on_floor(floor, b, contact.first, last);
  moments.add(contact.first);
  moments.add(last);
  if (moments.is_full()) return contact.first;
  const auto times = moments.sorted();
  for (std::size_t i = 0; i + 1 < times.size() && times[i] < last; ++i)
    if (times[i] < times[i + 1] && in_sight(times[i] + (times[i + 1] - times[i]) / 2))
      return times[i];
  return {};
}

}  // namespace docent::crowd
