#include "tests/bench/polyanya.h"
#include "runtime/model/geometry/orientation.h"

#include <algorithm>
#include <utility>

namespace docent::bench {
namespace {

Vec2 mirrored(Vec2 p, Vec2 on_line, Vec2 along) {
  const Vec2 normal = left_of(along);
  return p - 2 * dot(p - on_line, normal) / dot(normal, normal) * normal;
}

constexpr auto later = [](const auto& a, const auto& b) { return a.f > b.f; };

}  // namespace

Polyanya::Polyanya(NavigationMesh mesh)
    : mesh_(std::move(mesh)),
      grid_(mesh_),
      start_(static_cast<std::uint32_t>(mesh_.vertex.size())),
      point_(mesh_.vertex),
      best_g_(mesh_.vertex.size() + 1),
      reached_(mesh_.vertex.size() + 1) {
  point_.emplace_back();
  double extent = 0;
  for (const Vec2 p : mesh_.vertex) extent = std::max(extent, glm::distance(p, mesh_.vertex[0]));
  rounding_ = 1e-12 * extent;
}

FoundPath Polyanya::find(Vec2 from, Vec2 to) {
  point_[start_] = from;
  goal_ = to;
  ++query_;
  start_polygons_.clear(), goal_polygons_.clear(), expanded_.clear(), open_.clear();
  grid_.find(from, start_polygons_);
  grid_.find(to, goal_polygons_);
  for (const std::uint32_t polygon : start_polygons_) {
    if (holds_goal(polygon)) return {glm::distance(from, to), {from, to}};
    start_in(polygon);
  }
  while (!open_.empty()) {
    Node node = pop();
    if (node.polygon == none) return path_to(node);
    // A node with one successor is followed at once, without a detour through the heap.
    while (!holds_goal(node.polygon)) {
      expand(node);
      if (successors_.size() != 1) break;
      node = successors_.front();
      successors_.clear();
    }
    if (holds_goal(node.polygon)) reach_goal(node);
    push_successors();
  }
  return {};
}

int Polyanya::side(Line line, std::uint32_t vertex) const {
  return orientation(point_[line.a], point_[line.b], point_[vertex]);
}

Vec2 Polyanya::meet(Line line, const EdgeView& edge) const {
  const Vec2 a = point_[line.a], along = point_[line.b] - a;
  const Vec2 left = point_[edge.left], right = point_[edge.right];
  const double from_left = cross(along, left - a), from_right = cross(along, right - a);
  return left + from_left / (from_left - from_right) * (right - left);
}

bool Polyanya::holds_goal(std::uint32_t polygon) const {
  return std::ranges::find(goal_polygons_, polygon) != goal_polygons_.end();
}

/// The length of the shortest path from the root through the interval to the goal, if nothing else
/// were in the way; the goal is mirrored where it lies on the root's side.
double Polyanya::lower_bound(Vec2 root, const Interval& interval, const EdgeView& edge) const {
  const Vec2 left = point_[edge.left], along = point_[edge.right] - left;
  const Vec2 goal = cross(along, goal_ - left) < 0 ? mirrored(goal_, left, along) : goal_;
  const auto through = [&](Vec2 p) { return glm::distance(root, p) + glm::distance(p, goal); };
  if (cross(interval.left.at - root, goal - root) > 0) return through(interval.left.at);
  if (cross(interval.right.at - root, goal - root) < 0) return through(interval.right.at);
  return glm::distance(root, goal);
}

void Polyanya::start_in(std::uint32_t polygon) {
  const auto corners = mesh_.corners(polygon);
  const auto size = static_cast<std::uint32_t>(corners.size());
  for (std::uint32_t k = 0; k < size; ++k) {
    const EdgeView edge{.edge = k, .right = corners[k], .left = corners[(k + 1) % size]};
    if (orientation(point_[edge.right], point_[edge.left], point_[start_]) <= 0) continue;
    add_whole_edge({.polygon = polygon}, start_, 0, edge);
  }
  push_successors();
}

void Polyanya::expand(const Node& node) {
  if (node.g > best_g_[node.root] + rounding_) return;
  const auto index = static_cast<std::uint32_t>(expanded_.size());
  expanded_.push_back(node);
  Node from = node;
  from.parent = index;

  const auto corners = mesh_.corners(node.polygon);
  const auto size = static_cast<std::uint32_t>(corners.size());
  const auto& [left_sight, right_sight, left, right] = node.interval;
  const auto turns_at = [&](const End& end, std::uint32_t corner) {
    return end.vertex == corner && mesh_.is_reflex[corner] != 0;
  };
  const std::uint32_t rightmost = corners[(node.entry + 1) % size], leftmost = corners[node.entry];
  const bool root_is_on_entry = node.root == rightmost || node.root == leftmost;
  const bool turns_right = !root_is_on_entry && turns_at(right, rightmost);
  const bool turns_left = !root_is_on_entry && turns_at(left, leftmost);
  const Vec2 root = point_[node.root];
  const double g_right = turns_right ? node.g + glm::distance(root, right.at) : 0;
  const double g_left = turns_left ? node.g + glm::distance(root, left.at) : 0;

  EdgeView edge{.left = rightmost};
  if (!root_is_on_entry) {
    edge.left_of_right = side(right_sight, rightmost);
    edge.left_of_left = side(left_sight, rightmost);
  }
  for (std::uint32_t k = 1; k < size; ++k) {
    edge.edge = (node.entry + k) % size;
    edge.right = std::exchange(edge.left, corners[(edge.edge + 1) % size]);
    if (root_is_on_entry) {
      add_whole_edge(from, node.root, node.g, edge);
      continue;
    }
    edge.right_of_right = std::exchange(edge.left_of_right, side(right_sight, edge.left));
    edge.right_of_left = std::exchange(edge.left_of_left, side(left_sight, edge.left));
    if (turns_right) turn_right(from, edge, g_right);
    look_through(from, edge);
    if (turns_left) turn_left(from, edge, g_left);
  }
}

/// The part of an edge that the root sees, if it is more than a point.
void Polyanya::look_through(const Node& node, const EdgeView& edge) {
  if (edge.left_of_right <= 0 || edge.right_of_left >= 0) return;
  Interval seen = node.interval;
  if (edge.right_of_right >= 0) {
    seen.right_sight = {node.root, edge.right};
    seen.right = {point_[edge.right], edge.right};
  } else {
    seen.right = {meet(seen.right_sight, edge), none};
  }
  if (edge.left_of_left <= 0) {
    seen.left_sight = {node.root, edge.left};
    seen.left = {point_[edge.left], edge.left};
  } else {
    seen.left = {meet(seen.left_sight, edge), none};
  }
  add(node, node.root, node.g, edge, seen);
}

/// What comes into sight of the interval's right end, a corner, by turning right about it.
void Polyanya::turn_right(const Node& node, const EdgeView& edge, double g) {
  const std::uint32_t root = node.interval.right.vertex;
  if (edge.right == root) {
    if (edge.left_of_right <= 0) add_whole_edge(node, root, g, edge);
    return;
  }
  if (edge.right_of_right >= 0) return;
  Interval seen;
  seen.right_sight = {root, edge.right};
  seen.right = {point_[edge.right], edge.right};
  if (edge.left_of_right <= 0) {
    seen.left_sight = {root, edge.left};
    seen.left = {point_[edge.left], edge.left};
  } else {
    seen.left_sight = node.interval.right_sight;
    seen.left = {meet(seen.left_sight, edge), none};
  }
  add(node, root, g, edge, seen);
}

/// The same about its left end.
void Polyanya::turn_left(const Node& node, const EdgeView& edge, double g) {
  const std::uint32_t root = node.interval.left.vertex;
  if (edge.left == root) {
    if (edge.right_of_left >= 0) add_whole_edge(node, root, g, edge);
    return;
  }
  if (edge.left_of_left <= 0) return;
  Interval seen;
  seen.left_sight = {root, edge.left};
  seen.left = {point_[edge.left], edge.left};
  if (edge.right_of_left >= 0) {
    seen.right_sight = {root, edge.right};
    seen.right = {point_[edge.right], edge.right};
  } else {
    seen.right_sight = node.interval.left_sight;
    seen.right = {meet(seen.right_sight, edge), none};
  }
  add(node, root, g, edge, seen);
}

void Polyanya::add_whole_edge(const Node& node, std::uint32_t root, double g,
                              const EdgeView& edge) {
  add(node, root, g, edge,
      {.left_sight = {root, edge.left},
       .right_sight = {root, edge.right},
       .left = {point_[edge.left], edge.left},
       .right = {point_[edge.right], edge.right}});
}

/// A successor beyond an edge of the node's polygon, unless it leads nowhere or its root has been
/// reached on a shorter path.
void Polyanya::add(const Node& node, std::uint32_t root, double g, const EdgeView& edge,
                   const Interval& interval) {
  const std::uint32_t place = mesh_.first[node.polygon] + edge.edge;
  const std::uint32_t polygon = mesh_.across[place];
  if (polygon == NavigationMesh::wall) return;
  if (mesh_.exits[polygon] == 1 && !holds_goal(polygon)) return;
  if (reached_[root] != query_ || g < best_g_[root]) {
    best_g_[root] = g;
    reached_[root] = query_;
  } else if (g > best_g_[root] + rounding_) {
    return;
  }
  successors_.push_back({.parent = node.parent,
                         .root = root,
                         .g = g,
                         .f = g + lower_bound(point_[root], interval, edge),
                         .polygon = polygon,
                         .entry = mesh_.across_edge[place],
                         .interval = interval});
}

/// The node's polygon holds the goal: straight there where it is in sight, else about an end of the
/// interval that is a corner. Where sight is cut off beside the goal, another node gets there.
void Polyanya::reach_goal(const Node& node) {
  const auto side_of_goal = [&](Line line) {
    return orientation(point_[line.a], point_[line.b], goal_);
  };
  const auto& [left_sight, right_sight, left, right] = node.interval;
  const bool root_is_on_entry = node.root == left.vertex || node.root == right.vertex;
  if (root_is_on_entry) return reach_goal_from(node, node.root);
  if (side_of_goal(left_sight) > 0) {
    if (left.vertex != none) reach_goal_from(node, left.vertex);
  } else if (side_of_goal(right_sight) < 0) {
    if (right.vertex != none) reach_goal_from(node, right.vertex);
  } else {
    reach_goal_from(node, node.root);
  }
}

void Polyanya::reach_goal_from(const Node& node, std::uint32_t root) {
  Node last{.parent = static_cast<std::uint32_t>(expanded_.size()), .root = root};
  expanded_.push_back(node);
  const Vec2 bend = point_[root];
  last.f = node.g + glm::distance(point_[node.root], bend) + glm::distance(bend, goal_);
  push(last);
}

void Polyanya::push_successors() {
  for (const Node& successor : successors_) push(successor);
  successors_.clear();
}

void Polyanya::push(const Node& node) {
  open_.push_back(node);
  std::ranges::push_heap(open_, later);
}

Polyanya::Node Polyanya::pop() {
  std::ranges::pop_heap(open_, later);
  const Node node = open_.back();
  open_.pop_back();
  return node;
}

FoundPath Polyanya::path_to(const Node& last) const {
  FoundPath path{.length = last.f, .points = {goal_}};
  for (const Node* node = &last;; node = &expanded_[node->parent]) {
    if (path.points.back() != point_[node->root]) path.points.push_back(point_[node->root]);
    if (node->parent == none) break;
  }
  std::ranges::reverse(path.points);
  return path;
}

}  // namespace docent::bench
