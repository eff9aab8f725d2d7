#include "content/import/drawing/join_drawings.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "content/import/drawing/unit.h"

namespace docent::import {
namespace {

template <typename T>
void append(std::vector<T>& to, std::vector<T>& from) {
  std::ranges::move(from, std::back_inserter(to));
}

void lay_over(Drawing& all, Drawing& other) {
  if (all.metres_per_unit && other.metres_per_unit)
    scale(other, *other.metres_per_unit / *all.metres_per_unit);
  if (!all.metres_per_unit && other.metres_per_unit) {
    all.metres_per_unit = other.metres_per_unit;
    all.unit = other.unit;
  }
  const auto layers = static_cast<std::uint32_t>(all.layers.size());
  const auto arcs = static_cast<std::uint32_t>(all.arcs.size());
  for (DrawnSegment& segment : other.segments) {
    segment.layer += layers;
    if (segment.arc != no_arc) segment.arc += arcs;
  }
  for (DrawnArc& arc : other.arcs) arc.layer += layers;
  for (DrawnRing& ring : other.rings) ring.layer += layers;
  for (DrawnText& text : other.texts) text.layer += layers;
  append(all.layers, other.layers);
  append(all.segments, other.segments);
  append(all.arcs, other.arcs);
  append(all.rings, other.rings);
  append(all.texts, other.texts);
  for (const auto& [what, count] : other.left_out) all.left_out[what] += count;
}

}  // namespace

Drawing join_drawings(std::vector<Drawing> drawings) {
  if (drawings.empty()) return {};
  Drawing all = std::move(drawings.front());
  for (std::size_t i = 1; i < drawings.size(); ++i) lay_over(all, drawings[i]);
  return all;
}

}  // namespace docent::import
