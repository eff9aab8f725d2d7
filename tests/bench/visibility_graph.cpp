#include "tests/bench/visibility_graph.h"
#include "runtime/model/geometry/orientation.h"

#include <algorithm>

namespace docent::bench {
namespace {

constexpr auto later = [](const auto& a, const auto& b) { return a.f > b.f; };

}  // namespace

VisibilityGraph::VisibilityGraph(const FloorPlan& plan) : sight_(plan) {
  for (std::uint32_t v = 0; v < plan.vertex.size(); ++v) {
    const Corner corner{v, plan.vertex[v], plan.vertex[sight_.previous(v)],
                        plan.vertex[plan.next[v]]};
    if (orientation(corner.before, corner.at, corner.after) < 0) corner_.push_back(corner);
  }
  for (const Corner& corner : corner_) {
    first_.push_back(static_cast<std::uint32_t>(link_.size()));
    for (std::uint32_t other = 0; other < corner_.size(); ++other) {
      const Corner& c = corner_[other];
      if (&c == &corner || !is_taut(corner, c.at) || !is_taut(c, corner.at)) continue;
      if (sight_.sees(corner.at, c.at)) link_.push_back({other, glm::distance(corner.at, c.at)});
    }
  }
  first_.push_back(static_cast<std::uint32_t>(link_.size()));
  closed_.resize(corner_.size()), g_.resize(corner_.size()), parent_.resize(corner_.size());
}

/// Can a shortest path bend at the corner on the line from another point? Only where that line
/// touches the corner: both of its walls lie on one side of the line, or one on the line.
bool VisibilityGraph::is_taut(const Corner& corner, Vec2 other) {
  return orientation(other, corner.at, corner.before) *
             orientation(other, corner.at, corner.after) >=
         0;
}

FoundPath VisibilityGraph::find(Vec2 from, Vec2 to) {
  if (sight_.sees(from, to)) return {glm::distance(from, to), {from, to}};
  from_ = from, to_ = to;
  ++query_;
  open_.clear();
  for (std::uint32_t c = 0; c < corner_.size(); ++c) {
    const double g = glm::distance(from, corner_[c].at);
    open_.push_back({.f = g + glm::distance(corner_[c].at, to), .g = g, .corner = c});
  }
  std::ranges::make_heap(open_, later);
  while (!open_.empty()) {
    std::ranges::pop_heap(open_, later);
    const Entry entry = open_.back();
    open_.pop_back();
    const Corner& corner = corner_[entry.corner];
    if (closed_[entry.corner] == query_) continue;
    if (entry.parent == start && !(is_taut(corner, from) && sight_.sees(from, corner.at))) continue;
    closed_[entry.corner] = query_;
    g_[entry.corner] = entry.g;
    parent_[entry.corner] = entry.parent;
    // Its f is then the length of the whole path, and no other entry has a smaller one.
    if (is_taut(corner, to) && sight_.sees(corner.at, to)) return path_through(entry.corner);
    for (std::uint32_t i = first_[entry.corner]; i < first_[entry.corner + 1]; ++i)
      push(entry.g + link_[i].length, link_[i].corner, entry.corner);
  }
  return {};
}

void VisibilityGraph::push(double g, std::uint32_t corner, std::uint32_t parent) {
  if (closed_[corner] == query_) return;
  open_.push_back({g + glm::distance(corner_[corner].at, to_), g, corner, parent});
  std::ranges::push_heap(open_, later);
}

FoundPath VisibilityGraph::path_through(std::uint32_t corner) const {
  FoundPath path{.length = g_[corner] + glm::distance(corner_[corner].at, to_), .points = {to_}};
  for (; corner != start; corner = parent_[corner]) path.points.push_back(corner_[corner].at);
  path.points.push_back(from_);
  std::ranges::reverse(path.points);
  return path;
}

}  // namespace docent::bench
