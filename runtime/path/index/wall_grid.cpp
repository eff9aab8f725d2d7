#include "runtime/path/index/wall_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "runtime/model/geometry/orientation.h"
#include "runtime/model/geometry/segment.h"
#include "runtime/model/none.h"
#include "runtime/path/index/stamped_array.h"

namespace docent::path {
namespace {

/// Measured on the reference maps: fewer cells make long lists, more cost memory and steps.
constexpr double cells_per_wall = 6;
/// Cells hold walls from a little further than the radius, so that rounding in the walk through the
/// cells cannot miss one. Metres.
constexpr double margin = 1e-6;

/// Does the direction from the corner `v` to `x` point into the closed interior? `before` and
/// `after` are the neighbours of v in its ring; the interior lies left of before -> v -> after.
bool leads_inside(Vec2 before, Vec2 v, Vec2 after, Vec2 x) noexcept {
  if (orientation(before, v, after) >= 0)
    return orientation(before, v, x) >= 0 && orientation(v, after, x) >= 0;
  return orientation(before, v, x) >= 0 || orientation(v, after, x) >= 0;
}

}  // namespace

WallGrid::WallGrid(const FloorPlan& plan, double radius) : radius_(radius) {
  const std::size_t walls = plan.vertex.size();
  wall_.resize(walls);
  previous_.assign(walls, 0);
  next_ = plan.next;
  Vec2 low{infinity, infinity}, high{-infinity, -infinity};
  for (std::uint32_t i = 0; i < walls; ++i) {
    wall_[i] = {wall_start(plan, i), wall_end(plan, i)};
    previous_[plan.next[i]] = i;
    low = glm::min(low, wall_[i].a);
    high = glm::max(high, wall_[i].a);
  }
  if (walls == 0) low = high = {0, 0};
  link_places();
  const Vec2 farthest = glm::max(glm::abs(low), glm::abs(high));
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  slack_ = std::max(rounding, 4 * epsilon * std::max(farthest.x, farthest.y));
  const double reach = radius_ + 2 * margin;
  origin_ = low - Vec2{reach, reach};
  const Vec2 extent = high - low + Vec2{2 * reach, 2 * reach};
  cell_size_ =
      std::max({std::sqrt(extent.x * extent.y / (cells_per_wall * static_cast<double>(walls) + 1)),
                std::max(extent.x, extent.y) / 4096, radius_ / 4});
  cells_per_metre_ = 1 / cell_size_;
  columns_ = 1 + static_cast<int>(extent.x * cells_per_metre_);
  rows_ = 1 + static_cast<int>(extent.y * cells_per_metre_);

  cell_first_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
  for (const Wall& wall : wall_)
    visit_cells_near_wall(wall, [&](std::size_t cell) { ++cell_first_[cell + 1]; });
  for (std::size_t i = 1; i < cell_first_.size(); ++i) cell_first_[i] += cell_first_[i - 1];
  cell_wall_.resize(cell_first_.back());
  std::vector<std::uint32_t> fill(cell_first_.begin(), cell_first_.end() - 1);
  for (std::uint32_t i = 0; i < walls; ++i)
    visit_cells_near_wall(wall_[i], [&](std::size_t cell) { cell_wall_[fill[cell]++] = i; });
}

void WallGrid::link_places() {
  std::vector<std::uint32_t> order(wall_.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto place = [&](std::uint32_t wall) {
    return std::pair{wall_[wall].a.x, wall_[wall].a.y};
  };
  std::ranges::sort(order, {}, place);
  same_place_ = order;
  for (std::size_t i = 0; i < order.size();) {
    std::size_t end = i + 1;
    while (end < order.size() && place(order[end]) == place(order[i])) ++end;
    for (std::size_t k = i; k < end; ++k) same_place_[order[k]] = order[k + 1 < end ? k + 1 : i];
    i = end;
  }
}

template <class Visitor>
void WallGrid::visit_cells_near_wall(const Wall& wall, Visitor visit) const {
  const double reach = radius_ + margin;
  const auto cell_at = [&](double metres, int count) {
    return std::clamp(static_cast<int>(metres * cells_per_metre_), 0, count - 1);
  };
  const Vec2 low = glm::min(wall.a, wall.b) - origin_ - Vec2{reach, reach};
  const Vec2 high = glm::max(wall.a, wall.b) - origin_ + Vec2{reach, reach};
  const Vec2 along = wall.b - wall.a;
  const double length = std::sqrt(dot(along, along));
  const Vec2 normal = length > 0 ? left_of(along) / length : Vec2{0, 0};
  // Half of a cell's width as seen along the normal, plus the reach: nearer centres touch the wall.
  const double touches = reach + (std::abs(normal.x) + std::abs(normal.y)) * cell_size_ / 2;
  for (int y = cell_at(low.y, rows_); y <= cell_at(high.y, rows_); ++y)
    for (int x = cell_at(low.x, columns_); x <= cell_at(high.x, columns_); ++x) {
      const Vec2 centre = origin_ + cell_size_ * Vec2{x + 0.5, y + 0.5};
      if (std::abs(dot(normal, centre - wall.a)) <= touches) visit(cell_of(x, y));
    }
}

/// Walks through the cells from p to q (Amanatides and Woo 1987) until `blocked` says so of a wall.
template <class Blocked>
bool WallGrid::passes(Vec2 p, Vec2 q, Blocked blocked) const noexcept {
  // In cells, and clipped to the grid: outside there are no walls.
  const Vec2 size{columns_, rows_};
  Vec2 first = (p - origin_) * cells_per_metre_, last = (q - origin_) * cells_per_metre_;
  const auto is_in = [&](Vec2 at) {
    return at.x >= 0 && at.y >= 0 && at.x <= size.x && at.y <= size.y;
  };
  if (!is_in(first) || !is_in(last)) {
    const Vec2 from = first, delta = last - first;
    double enter = 0, leave = 1;
    for (int axis = 0; axis < 2; ++axis) {
      if (delta[axis] == 0) {
        if (from[axis] < 0 || from[axis] > size[axis]) return true;
        continue;
      }
      const double t0 = -from[axis] / delta[axis], t1 = (size[axis] - from[axis]) / delta[axis];
      enter = std::max(enter, std::min(t0, t1));
      leave = std::min(leave, std::max(t0, t1));
    }
    if (!(enter <= leave)) return true;
    first = from + enter * delta;
    last = from + leave * delta;
  }
  int x = std::clamp(static_cast<int>(first.x), 0, columns_ - 1);
  int y = std::clamp(static_cast<int>(first.y), 0, rows_ - 1);
  const int last_x = std::clamp(static_cast<int>(last.x), 0, columns_ - 1);
  const int last_y = std::clamp(static_cast<int>(last.y), 0, rows_ - 1);
  const Vec2 run = last - first;
  const int step_x = run.x < 0 ? -1 : 1, step_y = run.y < 0 ? -1 : 1;
  // How much of the segment passes a column and a row, and where it enters the next ones.
  const double per_x = std::abs(1 / run.x), per_y = std::abs(1 / run.y);
  double next_x = run.x != 0 ? std::abs((x + (step_x > 0)) - first.x) * per_x : infinity;
  double next_y = run.y != 0 ? std::abs((y + (step_y > 0)) - first.y) * per_y : infinity;
  for (int steps = std::abs(last_x - x) + std::abs(last_y - y);; --steps) {
    for (const std::uint32_t wall : walls_in(cell_of(x, y)))
      if (blocked(wall)) return false;
    if (steps <= 0) return true;
    const bool in_x = (next_x < next_y && x != last_x) || y == last_y;
    (in_x ? x : y) += in_x ? step_x : step_y;
    (in_x ? next_x : next_y) += in_x ? per_x : per_y;
  }
}

/// Is it so for any of the corners at the place of one?
template <class Holds>
bool WallGrid::at_place(std::uint32_t corner, Holds holds) const noexcept {
  std::uint32_t at = corner;
  do {
    if (holds(at)) return true;
    at = same_place_[at];
  } while (at != corner);
  return false;
}

/// Does the segment p q leave the closed interior at this wall, or at the corner where it begins?
bool WallGrid::crosses(Vec2 p, Vec2 q, std::uint32_t wall) const noexcept {
  const auto [a, b] = wall_[wall];
  const int a_side = orientation(p, q, a), b_side = orientation(p, q, b);
  if (a_side == 0) {
    const Vec2 direction = q - p;
    const double at = dot(a - p, direction);
    if (at < 0 || at > dot(direction, direction)) return false;
    // Where obstacles share a corner the floor meets it in several wedges: one must hold both ways.
    const auto stays_inside = [&](std::uint32_t corner) {
      const Vec2 before = wall_[previous_[corner]].a, after = wall_[corner].b;
      return (q == a || leads_inside(before, a, after, q)) &&
             (p == a || leads_inside(before, a, after, p));
    };
    return !at_place(wall, stays_inside);
  }
  if (b_side == 0 || a_side == b_side) return false;  // b's corner is the next wall's to judge
  const int p_side = orientation(a, b, p), q_side = orientation(a, b, q);
  if (p_side == 0) return q_side < 0;
  if (q_side == 0) return p_side < 0;
  return p_side != q_side;
}

/// Is the wall nearer to the segment p q than `least`? `beside` is that times the segment's length.
bool WallGrid::comes_near(Vec2 p, Vec2 q, Vec2 direction, double beside, double least,
                          std::uint32_t wall) const noexcept {
  const auto [a, b] = wall_[wall];
  const double a_side = cross(direction, a - p), b_side = cross(direction, b - p);
  if ((a_side > beside && b_side > beside) || (a_side < -beside && b_side < -beside)) return false;
  return segment_distance_squared(p, q, a, b) < least * least;
}

bool WallGrid::segment_clear(Vec2 p, Vec2 q) const noexcept {
  if (p == q) return true;
  if (radius_ == 0) return passes(p, q, [&](std::uint32_t wall) { return crosses(p, q, wall); });

  const Vec2 direction = q - p;
  const double length = std::sqrt(dot(direction, direction));
  const double least = least_clearance(radius_) - slack_;
  return passes(p, q, [&](std::uint32_t wall) {
    return comes_near(p, q, direction, least * length, least, wall);
  });
}

bool WallGrid::capsule_clear(Vec2 p, Vec2 q, double radius) const noexcept {
  const double least = least_clearance(radius) - slack_;
  const double reach = radius - radius_ + margin;
  const auto cell_at = [&](double metres, int count) {
    return static_cast<int>(std::clamp(metres * cells_per_metre_, 0.0, count - 1.0));
  };
  const Vec2 direction = q - p;
  const double beside = least * std::sqrt(dot(direction, direction));
  const auto is_free = [&](std::size_t cell) {
    return std::ranges::none_of(walls_in(cell), [&](std::uint32_t wall) {
      return comes_near(p, q, direction, beside, least, wall);
    });
  };
  const Vec2 from = p - origin_, to = q - origin_;
  const Vec2 run = to - from;
  for (int y = cell_at(std::min(from.y, to.y) - reach, rows_),
           last = cell_at(std::max(from.y, to.y) + reach, rows_);
       y <= last; ++y) {
    // The part of the segment within reach of this row of cells.
    double enter = 0, leave = 1;
    if (run.y != 0) {
      const double low = (y * cell_size_ - reach - from.y) / run.y;
      const double high = ((y + 1) * cell_size_ + reach - from.y) / run.y;
      enter = std::clamp(std::min(low, high), 0.0, 1.0);
      leave = std::clamp(std::max(low, high), 0.0, 1.0);
    }
    const auto [left, right] = std::minmax({from.x + enter * run.x, from.x + leave * run.x});
    for (int x = cell_at(left - reach, columns_), end = cell_at(right + reach, columns_); x <= end;
         ++x)
      if (!is_free(cell_of(x, y))) return false;
  }
  return true;
}

std::vector<std::uint32_t> WallGrid::walls_about(Vec2 centre, double reach) const {
  const auto cell_at = [&](double metres, int count) {
    return static_cast<int>(std::clamp(metres * cells_per_metre_, 0.0, count - 1.0));
  };
  const Vec2 low = centre - origin_ - Vec2{reach, reach};
  const Vec2 high = centre - origin_ + Vec2{reach, reach};
  // Beside a finely drawn curve a wall is listed in hundreds of cells.
  thread_local StampedArray<std::uint8_t> is_found;
  is_found.forget(wall_.size());
  std::vector<std::uint32_t> found;
  for (int y = cell_at(low.y, rows_); y <= cell_at(high.y, rows_); ++y)
    for (int x = cell_at(low.x, columns_); x <= cell_at(high.x, columns_); ++x)
      for (const std::uint32_t wall : walls_in(cell_of(x, y)))
        if (!is_found.has(wall)) {
          is_found[wall] = 1;
          found.push_back(wall);
        }
  std::ranges::sort(found);
  return found;
}

WallGrid::Nearest WallGrid::nearest_wall(Vec2 p) const noexcept {
  Nearest best{.distance = infinity};
  if (!std::isfinite(p.x) || !std::isfinite(p.y)) return best;
  double best_squared = infinity;
  const auto consider = [&](std::uint32_t wall) {
    const NearestOnSegment near = nearest_on_segment(p, wall_[wall].a, wall_[wall].b);
    if (near.distance_squared >= best_squared) return;
    best_squared = near.distance_squared;
    best.wall = wall;
    best.t = near.t;
  };
  const Vec2 at = (p - origin_) * cells_per_metre_;
  if (!(at.x >= 0 && at.y >= 0 && at.x < columns_ && at.y < rows_)) {
    for (std::uint32_t wall = 0; wall < wall_.size(); ++wall) consider(wall);
  } else {
    const int x0 = static_cast<int>(at.x), y0 = static_cast<int>(at.y);
    const auto look_at_row = [&](int y, int from, int to, int step) {
      if (y < 0 || y >= rows_) return;
      for (int x = from; x <= to; x += step)
        if (x >= 0 && x < columns_)
          for (const std::uint32_t wall : walls_in(cell_of(x, y))) consider(wall);
    };
    // Square rings about the point's cell; ring k is at least k - 1 cells and a bit away.
    const double inner = std::min({at.x - x0, at.y - y0, x0 + 1 - at.x, y0 + 1 - at.y});
    for (int ring = 0; ring <= std::max(columns_, rows_); ++ring) {
      const double away = std::max(0.0, (ring - 1 + inner) * cell_size_);
      if (ring > 0 && away * away > best_squared) break;
      look_at_row(y0 - ring, x0 - ring, x0 + ring, 1);
      for (int y = y0 - ring + 1; y < y0 + ring; ++y)
        look_at_row(y, x0 - ring, x0 + ring, std::max(1, 2 * ring));
      if (ring > 0) look_at_row(y0 + ring, x0 - ring, x0 + ring, 1);
    }
  }
  best.distance = std::sqrt(best_squared);
  return best;
}

double WallGrid::distance_within(std::size_t cell, Vec2 p) const noexcept {
  double squared = infinity;
  for (const std::uint32_t wall : walls_in(cell))
    squared =
        std::min(squared, nearest_on_segment(p, wall_[wall].a, wall_[wall].b).distance_squared);
  return std::sqrt(squared);
}

bool WallGrid::is_inside(Vec2 p, const Nearest& nearest) const noexcept {
  if (!std::isfinite(nearest.distance)) return false;
  if (nearest.distance == 0) return true;
  const auto [a, b] = wall_[nearest.wall];
  if (nearest.t > 0 && nearest.t < 1) return orientation(a, b, p) >= 0;
  // Nearest to a corner: a reflex one is seen from inside, a convex one from outside.
  // Of several at one place only one can be seen from afar.
  return at_place(nearest.t > 0 ? next_[nearest.wall] : nearest.wall, [&](std::uint32_t corner) {
    return orientation(wall_[previous_[corner]].a, wall_[corner].a, wall_[corner].b) <= 0;
  });
}

Vec2 WallGrid::brought_inside(Vec2 p) const noexcept {
  const auto cell = cell_at(p);
  if (!cell || is_clear(*cell)) return p;
  const Nearest nearest = nearest_wall(p);
  if (nearest.distance > touching) return p;
  const auto [a, b] = wall_[nearest.wall];
  if (nearest.t > 0 && nearest.t < 1 ? orientation(a, b, p) >= 0 : is_inside(p, nearest)) return p;
  const Vec2 foot = glm::mix(a, b, nearest.t);
  for (const Vec2 corner : {a, b})
    if (glm::distance(foot, corner) <= touching) return corner;
  const Vec2 inward = left_of(glm::normalize(b - a));
  for (double by = slack_ / 1024; by <= touching; by *= 2)
    if (const Vec2 inside = foot + by * inward; orientation(a, b, inside) > 0) return inside;
  return p;
}

std::optional<std::size_t> WallGrid::cell_at(Vec2 p) const noexcept {
  const Vec2 at = (p - origin_) * cells_per_metre_;
  if (!(at.x >= 0 && at.y >= 0 && at.x < columns_ && at.y < rows_)) return {};
  return cell_of(static_cast<int>(at.x), static_cast<int>(at.y));
}

Vec2 WallGrid::centre_of(std::size_t cell) const noexcept {
  const auto columns = static_cast<std::size_t>(columns_);
  const std::size_t row = cell / columns, column = cell % columns;
  return origin_ +
         cell_size_ * Vec2{static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5};
}

double WallGrid::segment_clearance(Vec2 p, Vec2 q, double at_most) const noexcept {
  double squared = at_most * at_most;
  if (!std::isfinite(squared)) return at_most;
  const auto cell_at = [&](double metres, int count) {
    return static_cast<int>(std::clamp(metres * cells_per_metre_, 0.0, count - 1.0));
  };
  const Vec2 reach{at_most, at_most};
  const Vec2 low = glm::min(p, q) - origin_ - reach, high = glm::max(p, q) - origin_ + reach;
  const Vec2 direction = q - p;
  const double length = std::sqrt(dot(direction, direction));
  const double touches = (at_most + cell_size_) * length;
  for (int y = cell_at(low.y, rows_); y <= cell_at(high.y, rows_); ++y)
    for (int x = cell_at(low.x, columns_); x <= cell_at(high.x, columns_); ++x) {
      const Vec2 centre = origin_ + cell_size_ * Vec2{x + 0.5, y + 0.5};
      if (std::abs(cross(direction, centre - p)) > touches) continue;
      for (const std::uint32_t wall : walls_in(cell_of(x, y)))
        squared = std::min(squared, segment_distance_squared(p, q, wall_[wall].a, wall_[wall].b));
    }
  return std::sqrt(squared);
}

}  // namespace docent::path
