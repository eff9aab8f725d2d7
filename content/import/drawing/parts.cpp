#include "content/import/drawing/parts.h"

#include <algorithm>
#include <functional>
#include <map>
#include <numeric>
#include <utility>

#include "content/import/drawing/drawn_box.h"
#include "content/import/drawing/line_kind.h"
#include "content/import/drawing/segment_grid.h"
#include "runtime/model/geometry/segment.h"

namespace docent::import {
namespace {

constexpr double apart = 1.5;  ///< Metres: what is farther from all else is another plan.

}  // namespace

std::vector<std::vector<std::uint32_t>> parts_that_lie_together(std::span<const WallLine> lines) {
  std::vector<std::uint32_t> parent(lines.size());
  std::iota(parent.begin(), parent.end(), 0U);
  const auto root = [&](std::uint32_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  double length = 0;
  for (const WallLine& line : lines) length += length_of(line);
  SegmentGrid grid(std::max(apart, length / 1e6));
  // Whoever comes to a cell joins the last one there: the chain holds all.
  std::vector<std::uint32_t> seen(lines.size(), no_face);
  for (std::uint32_t i = 0; i < lines.size(); ++i) {
    grid.near(lines[i].a, lines[i].b, apart / 2, [&](std::uint32_t j) {
      if (seen[j] == i) return;
      seen[j] = i;
      if (root(i) != root(j) &&
          segment_distance_squared(lines[i].a, lines[i].b, lines[j].a, lines[j].b) < apart * apart)
        parent[root(i)] = root(j);
    });
    grid.add(i, lines[i].a, lines[i].b);
  }
  std::map<std::uint32_t, std::vector<std::uint32_t>> parts;
  for (std::uint32_t i = 0; i < lines.size(); ++i) parts[root(i)].push_back(i);

  struct Part {
    DrawnBox box;
    std::vector<std::uint32_t> members;
    double size() const { return (box.high.x - box.low.x) * (box.high.y - box.low.y); }
  };
  std::vector<Part> sorted;
  for (auto& [key, members] : parts) {
    Part part;
    for (const std::uint32_t i : members) {
      part.box.add(lines[i].a);
      part.box.add(lines[i].b);
    }
    part.members = std::move(members);
    sorted.push_back(std::move(part));
  }
  std::ranges::stable_sort(sorted, std::greater{}, &Part::size);
  std::vector<Part> whole;  // What stands free in a hall belongs to the hall.
  for (Part& part : sorted) {
    const auto around =
        std::ranges::find_if(whole, [&](const Part& other) { return other.box.meets(part.box); });
    if (around == whole.end()) {
      whole.push_back(std::move(part));
      continue;
    }
    around->members.insert(around->members.end(), part.members.begin(), part.members.end());
    around->box.add(part.box.low);
    around->box.add(part.box.high);
  }
  std::vector<std::vector<std::uint32_t>> out;
  for (Part& part : whole) out.push_back(std::move(part.members));
  return out;
}

}  // namespace docent::import
