#include "tests/runtime/path/oracles.h"

#include <algorithm>
#include <cmath>

#include "runtime/model/none.h"

namespace docent::test {
namespace {

/// Where along p q, in [0, 1], it meets the wall; both ends where they run along each other.
void add_meetings(Vec2 p, Vec2 q, Vec2 a, Vec2 b, std::vector<double>& at) {
  const Vec2 run = q - p;
  const double squared = dot(run, run);
  for (const Vec2 end : {a, b}) at.push_back(std::clamp(dot(end - p, run) / squared, 0.0, 1.0));
  const double across = cross(run, b - a);
  if (across != 0) at.push_back(std::clamp(cross(a - p, b - a) / across, 0.0, 1.0));
}

bool sees(const FloorPlan& plan, Vec2 p, Vec2 q) {
  if (p == q) return true;
  constexpr double on_wall = 1e-9;
  std::vector<double> at{0, 1};
  for (std::uint32_t w = 0; w < plan.vertex.size(); ++w)
    add_meetings(p, q, wall_start(plan, w), wall_end(plan, w), at);
  std::ranges::sort(at);
  for (std::size_t i = 0; i + 1 < at.size(); ++i) {
    const Vec2 middle = p + (at[i] + at[i + 1]) / 2 * (q - p);
    if (!is_inside(plan, middle) && distance_to_nearest_wall(plan, middle) > on_wall) return false;
  }
  return true;
}

}  // namespace

double brute_force_length(const FloorPlan& plan, Vec2 from, Vec2 to) {
  return brute_force_lengths(plan, from, {&to, 1}).front();
}

std::vector<double> brute_force_lengths(const FloorPlan& plan, Vec2 from,
                                        std::span<const Vec2> to) {
  std::vector<Vec2> node(to.begin(), to.end());
  node.insert(node.end(), plan.vertex.begin(), plan.vertex.end());
  node.push_back(from);
  std::vector<double> length(node.size(), infinity);
  std::vector<bool> done(node.size(), false);
  length.back() = 0;
  for (std::size_t left = to.size(); left > 0;) {
    std::size_t next = node.size();
    for (std::size_t i = 0; i < node.size(); ++i)
      if (!done[i] && length[i] < infinity && (next == node.size() || length[i] < length[next]))
        next = i;
    if (next == node.size()) break;
    done[next] = true;
    if (next < to.size()) --left;
    for (std::size_t i = 0; i < node.size(); ++i) {
      const double longer = length[next] + glm::distance(node[next], node[i]);
      if (longer < length[i] && sees(plan, node[next], node[i])) length[i] = longer;
    }
  }
  length.resize(to.size());
  return length;
}

double sampled_clearance(const FloorPlan& plan, const std::vector<Vec2>& points) {
  double least = infinity;
  for (std::size_t i = 0; i < points.size(); ++i) {
    least = std::min(least, distance_to_nearest_wall(plan, points[i]));
    if (i == 0) continue;
    const Vec2 run = points[i] - points[i - 1];
    const int samples = static_cast<int>(glm::length(run) / 0.01);
    for (int s = 1; s <= samples; ++s)
      least = std::min(least,
                       distance_to_nearest_wall(
                           plan, points[i - 1] + run * (static_cast<double>(s) / (samples + 1))));
  }
  return least;
}

bool crosses_a_wall(const FloorPlan& plan, const std::vector<Vec2>& points) {
  constexpr double clearly = 1e-9;  // square metres: touching is not crossing
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vec2 p = points[i - 1], q = points[i];
    const Vec2 low = glm::min(p, q), high = glm::max(p, q);
    for (std::uint32_t w = 0; w < plan.vertex.size(); ++w) {
      const Vec2 a = wall_start(plan, w), b = wall_end(plan, w);
      if (std::max(a.x, b.x) < low.x || std::min(a.x, b.x) > high.x || std::max(a.y, b.y) < low.y ||
          std::min(a.y, b.y) > high.y)
        continue;  // far apart, as nearly all are
      const double a_side = cross(q - p, a - p), b_side = cross(q - p, b - p);
      const double p_side = cross(b - a, p - a), q_side = cross(b - a, q - a);
      if (std::min(a_side, b_side) < -clearly && std::max(a_side, b_side) > clearly &&
          std::min(p_side, q_side) < -clearly && std::max(p_side, q_side) > clearly)
        return true;
    }
  }
  return false;
}

double polyline_length(const std::vector<Vec2>& points) {
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) length += glm::distance(points[i - 1], points[i]);
  return length;
}

}  // namespace docent::test
