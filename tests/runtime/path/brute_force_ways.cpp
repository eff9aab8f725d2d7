#include "tests/runtime/path/brute_force_ways.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>

#include "runtime/model/geometry/segment.h"
#include "runtime/model/none.h"
#include "tests/content/floor/plans.h"

namespace docent::test {
namespace {

constexpr double pi = std::numbers::pi;

bool crosses(Vec2 p, Vec2 q, Vec2 a, Vec2 b) {
  const double pa = cross(q - p, a - p), pb = cross(q - p, b - p);
  const double ap = cross(b - a, p - a), aq = cross(b - a, q - a);
  return ((pa < 0 && pb > 0) || (pa > 0 && pb < 0)) && ((ap < 0 && aq > 0) || (ap > 0 && aq < 0));
}

double distance_between(Vec2 p, Vec2 q, Vec2 a, Vec2 b) {
  if (crosses(p, q, a, b)) return 0;
  return std::min({distance_to_segment(p, a, b), distance_to_segment(q, a, b),
                   distance_to_segment(a, p, q), distance_to_segment(b, p, q)});
}

/// Is a point's straight line inside the floor or on its walls? Cut at every wall, and the middle
/// of each part looked at.
bool point_sees(const FloorPlan& plan, Vec2 p, Vec2 q, double slack) {
  const Vec2 run = q - p;
  const double squared = dot(run, run);
  if (squared == 0) return true;
  std::vector<double> cut{0, 1};
  for (std::uint32_t w = 0; w < plan.vertex.size(); ++w) {
    const Vec2 a = wall_start(plan, w), b = wall_end(plan, w);
    if (crosses(p, q, a, b)) {
      // Through a wall, unless it is one of its ends that the line touches.
      const double deepest = std::min({distance_to_segment(a, p, q), distance_to_segment(b, p, q),
                                       distance_to_segment(p, a, b), distance_to_segment(q, a, b)});
      if (deepest > slack) return false;
    }
    if (distance_to_segment(a, p, q) <= slack) cut.push_back(dot(a - p, run) / squared);
    const double across = cross(run, b - a);
    if (across != 0) cut.push_back(cross(a - p, b - a) / across);
  }
  for (double& at : cut) at = std::clamp(at, 0.0, 1.0);
  std::ranges::sort(cut);
  for (std::size_t i = 0; i + 1 < cut.size(); ++i) {
    const Vec2 middle = p + (cut[i] + cut[i + 1]) / 2 * run;
    if (!is_inside(plan, middle) && distance_to_nearest_wall(plan, middle) > slack) return false;
  }
  return true;
}

Vec2 unit_of(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

}  // namespace

BruteForceWays::BruteForceWays(const FloorPlan& plan, double radius, double slack)
    : plan_(plan), radius_(radius), slack_(slack) {
  std::vector<std::uint32_t> before(plan.vertex.size());
  for (std::uint32_t i = 0; i < plan.vertex.size(); ++i) before[plan.next[i]] = i;
  for (std::uint32_t i = 0; i < plan.vertex.size(); ++i) {
    const Vec2 in = plan.vertex[i] - plan.vertex[before[i]];
    const Vec2 out = plan.vertex[plan.next[i]] - plan.vertex[i];
    if (cross(in, out) < 0) centre_.push_back(plan.vertex[i]);
  }
  on_circle_.resize(centre_.size());
  if (radius == 0)
    for (std::uint32_t c = 0; c < centre_.size(); ++c) {
      touch_.push_back({c, 0, centre_[c]});
      graph_.emplace_back();
    }
  for (std::uint32_t a = 0; a < centre_.size(); ++a)
    for (std::uint32_t b = a + 1; b < centre_.size(); ++b) connect_circles(a, b);
  for (std::uint32_t c = 0; c < centre_.size() && radius > 0; ++c) connect_along(c);
}

bool BruteForceWays::is_clear(Vec2 p, Vec2 q) const {
  if (radius_ == 0) return point_sees(plan_, p, q, slack_);
  for (std::uint32_t w = 0; w < plan_.vertex.size(); ++w)
    if (distance_between(p, q, wall_start(plan_, w), wall_end(plan_, w)) < radius_ - slack_)
      return false;
  return true;
}

bool BruteForceWays::is_arc_clear(std::uint32_t circle, double begin, double end) const {
  const Vec2 centre = centre_[circle];
  if (end < begin) end += 2 * pi;
  const auto is_near = [&](double angle, Vec2 a, Vec2 b) {
    while (angle < begin) angle += 2 * pi;
    return angle <= end &&
           distance_to_segment(centre + radius_ * unit_of(angle), a, b) < radius_ - slack_;
  };
  for (std::uint32_t w = 0; w < plan_.vertex.size(); ++w) {
    const Vec2 a = wall_start(plan_, w), b = wall_end(plan_, w);
    const double off = distance_to_segment(centre, a, b);
    if (off > 2 * radius_) continue;
    // The distance to the wall is least at an end of the arc, towards an end of the wall, square to
    // the wall, or where circle and wall cross.
    std::vector<double> angles{begin, end};
    for (const Vec2 to : {a - centre, b - centre})
      if (dot(to, to) > 0) angles.push_back(std::atan2(to.y, to.x));
    const Vec2 along = glm::normalize(b - a);
    const double square = std::atan2(left_of(along).y, left_of(along).x);
    const double height = dot(a - centre, left_of(along));  // of the wall's line over the centre
    angles.insert(angles.end(), {square, square + pi});
    if (std::abs(height) < radius_) {
      const double spread = std::acos(height / radius_);
      angles.insert(angles.end(), {square + spread, square - spread});
    }
    for (double angle : angles) {
      while (angle - 2 * pi >= begin) angle -= 2 * pi;
      if (is_near(angle, a, b)) return false;
    }
  }
  return true;
}

BruteForceWays::Touch BruteForceWays::touch(std::uint32_t circle, Vec2 direction) const {
  return {circle, std::atan2(direction.y, direction.x), centre_[circle] + radius_ * direction};
}

std::vector<BruteForceWays::Touch> BruteForceWays::touches_from(Vec2 point,
                                                                std::uint32_t circle) const {
  const Vec2 to = point - centre_[circle];
  const double distance = glm::length(to);
  if (radius_ == 0) return {{circle, 0, centre_[circle]}};
  if (distance < radius_ - slack_) return {};
  const double half = std::acos(std::min(1.0, radius_ / distance));
  const double towards = std::atan2(to.y, to.x);
  return {touch(circle, unit_of(towards + half)), touch(circle, unit_of(towards - half))};
}

void BruteForceWays::connect_circles(std::uint32_t a, std::uint32_t b) {
  const Vec2 between = centre_[b] - centre_[a];
  const double distance = glm::length(between);
  if (radius_ == 0) {
    if (!is_clear(centre_[a], centre_[b])) return;
    graph_[a].push_back({b, distance});
    graph_[b].push_back({a, distance});
    return;
  }
  if (distance == 0) return;
  const double towards = std::atan2(between.y, between.x);
  std::vector<std::pair<double, double>> angles{{towards + pi / 2, towards + pi / 2},
                                                {towards - pi / 2, towards - pi / 2}};
  if (distance >= 2 * radius_ - slack_) {
    const double half = std::acos(std::min(1.0, 2 * radius_ / distance));
    angles.insert(angles.end(),
                  {{towards + half, towards + half + pi}, {towards - half, towards - half + pi}});
  }
  for (const auto& [at_a, at_b] : angles) {
    const Touch leave = touch(a, unit_of(at_a)), arrive = touch(b, unit_of(at_b));
    if (!is_clear(leave.place, arrive.place)) continue;
    const auto node = static_cast<std::uint32_t>(touch_.size());
    const double length = glm::distance(leave.place, arrive.place);
    touch_.insert(touch_.end(), {leave, arrive});
    graph_.push_back({{node + 1, length}});
    graph_.push_back({{node, length}});
    on_circle_[a].push_back(node);
    on_circle_[b].push_back(node + 1);
  }
}

void BruteForceWays::connect_along(std::uint32_t circle) {
  std::vector<std::uint32_t>& touches = on_circle_[circle];
  std::ranges::sort(touches, {}, [&](std::uint32_t t) { return touch_[t].angle; });
  for (std::size_t i = 0; i < touches.size() && touches.size() > 1; ++i) {
    const std::uint32_t a = touches[i], b = touches[(i + 1) % touches.size()];
    double turn = touch_[b].angle - touch_[a].angle;
    if (turn < 0) turn += 2 * pi;
    if (!is_arc_clear(circle, touch_[a].angle, touch_[a].angle + turn)) continue;
    graph_[a].push_back({b, radius_ * turn});
    graph_[b].push_back({a, radius_ * turn});
  }
}

std::uint32_t BruteForceWays::join(Vec2 point, Joined& joined) const {
  const auto node = static_cast<std::uint32_t>(joined.graph.size());
  joined.graph.emplace_back();
  joined.touch.push_back({none, 0, point});
  for (std::uint32_t c = 0; c < centre_.size(); ++c)
    for (const Touch& at : touches_from(point, c)) {
      if (!is_clear(point, at.place)) continue;
      std::uint32_t reached = c;
      if (radius_ > 0) {
        reached = static_cast<std::uint32_t>(joined.graph.size());
        joined.graph.emplace_back();
        joined.touch.push_back(at);
        join_along(reached, joined);
      }
      const double length = glm::distance(point, at.place);
      joined.graph[node].push_back({reached, length});
      joined.graph[reached].push_back({node, length});
    }
  return node;
}

/// To the next touches of its circle on either side, as far as the arc between is clear.
void BruteForceWays::join_along(std::uint32_t node, Joined& joined) const {
  const Touch at = joined.touch[node];
  std::vector<std::uint32_t>& others = joined.on_circle[at.circle];
  for (const double sense : {1.0, -1.0}) {
    double least = infinity;
    std::uint32_t next = none;
    for (const std::uint32_t other : others) {
      double turn = sense * (joined.touch[other].angle - at.angle);
      if (turn < 0) turn += 2 * pi;
      if (turn < least) {
        least = turn;
        next = other;
      }
    }
    if (next == none) continue;
    const double begin = sense > 0 ? at.angle : joined.touch[next].angle;
    if (!is_arc_clear(at.circle, begin, begin + least)) continue;
    joined.graph[node].push_back({next, radius_ * least});
    joined.graph[next].push_back({node, radius_ * least});
  }
  others.push_back(node);
}

double BruteForceWays::length(Vec2 from, Vec2 to) const {
  if (is_clear(from, to)) return glm::distance(from, to);
  Joined joined{graph_, touch_, on_circle_};
  const std::uint32_t start = join(from, joined), goal = join(to, joined);
  std::vector<double> length(joined.graph.size(), infinity);
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  length[start] = 0;
  queue.emplace(0, start);
  while (!queue.empty()) {
    const auto [so_far, node] = queue.top();
    queue.pop();
    if (node == goal) return so_far;
    if (so_far > length[node]) continue;
    for (const Edge& edge : joined.graph[node])
      if (so_far + edge.length < length[edge.to]) {
        length[edge.to] = so_far + edge.length;
        queue.emplace(length[edge.to], edge.to);
      }
  }
  return infinity;
}

}  // namespace docent::test
