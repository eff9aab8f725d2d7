#include "content/import/drawing/choose_lines.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <span>

#include "content/import/drawing/line_kind.h"
#include "content/import/drawing/segment_grid.h"

namespace docent::import {
namespace {

/// A place to the tenth of a millimetre.
std::pair<std::int64_t, std::int64_t> key_of(Vec2 p) {
  return {std::llround(p.x * 1e4), std::llround(p.y * 1e4)};
}

/// Strokes that are drawn again say nothing new.
class Seen {
 public:
  bool again(Vec2 a, Vec2 b) {
    const auto [low, high] = std::minmax({key_of(a), key_of(b)});
    return !seen_.emplace(low, high).second;
  }

 private:
  using Key = std::pair<std::int64_t, std::int64_t>;
  std::set<std::pair<Key, Key>> seen_;
};

class Chooser {
 public:
  Chooser(const Drawing& drawing, const std::vector<LayerKind>& kinds, FoundPlans& found)
      : drawing_(drawing), kinds_(kinds), found_(found) {
    double walls = 0, dashed = 0, all = 0;
    for (const DrawnSegment& segment : drawing.segments) {
      const double length = glm::length(segment.b - segment.a);
      if (kinds[segment.layer] == LayerKind::Wall) walls += length;
      if (kinds[segment.layer] == LayerKind::Other) continue;
      all += length;
      if (segment.dashed) dashed += length;
    }
    walls_are_named_ = walls > 10;
    all_are_dashed_ = dashed > 0.6 * all;
  }

  Chosen choose() {
    Chosen chosen;
    Seen arcs, strokes;
    for (std::uint32_t i = 0; i < drawing_.arcs.size(); ++i) {
      const DrawnArc& arc = drawing_.arcs[i];
      if (kinds_[arc.layer] == LayerKind::Other) continue;
      if (arcs.again(arc.start + arc.centre, arc.end + arc.centre)) continue;
      if (swings_like_a_door(arc)) chosen.arcs.push_back(i);
      if (swings_like_a_door(arc) || could_end_at_a_leaf(arc)) chosen.any_arcs.push_back(i);
    }
    for (const DrawnSegment& segment : drawing_.segments) {
      if (kinds_[segment.layer] == LayerKind::Stairs)
        chosen.stairs.push_back({segment.a, segment.b, Wall});
      if (kinds_[segment.layer] == LayerKind::Door && !segment.of_curve)
        chosen.leaves.push_back({segment.a, segment.b, Wall});
      if (segment.dashed && !all_are_dashed_ && kinds_[segment.layer] != LayerKind::Wall) {
        ++found_.culled["dashed strokes: axes, and what is overhead"];
        continue;
      }
      if (!could_be_wall(segment)) {
        ++found_.culled["strokes on layers that draw no walls"];
        continue;
      }
      if (segment.arc != no_arc && swings_like_a_door(drawing_.arcs[segment.arc])) {
        ++found_.culled["strokes of door swings"];
        continue;
      }
      if (strokes.again(segment.a, segment.b)) {
        ++found_.culled["strokes drawn again"];
        continue;
      }
      const bool window = kinds_[segment.layer] == LayerKind::Window;
      const WallLine line{segment.a, segment.b, window ? Window : Wall};
      if (segment.arc != no_arc && could_end_at_a_leaf(drawing_.arcs[segment.arc]))
        chosen.strokes_of_arcs.emplace_back(segment.arc, line);
      else
        chosen.lines.push_back(line);
    }
    return chosen;
  }

 private:
  bool could_be_wall(const DrawnSegment& segment) const {
    switch (kinds_[segment.layer]) {
      case LayerKind::Wall:
      case LayerKind::Window:
        return true;
      case LayerKind::Door:  // Leaves and frames are no walls; gaps are shut without them.
        return false;
      case LayerKind::Unknown:
        return !walls_are_named_ && !(segment.of_block && segment.of_curve);
      case LayerKind::Room:
        return !walls_are_named_;
      case LayerKind::Stairs:
      case LayerKind::Other:
        break;
    }
    return false;
  }

  const Drawing& drawing_;
  const std::vector<LayerKind>& kinds_;
  FoundPlans& found_;
  bool walls_are_named_ = false, all_are_dashed_ = false;
};

/// Axes of a building's grid cross it and stand out on both sides: no wall does.
class Axes {
 public:
  explicit Axes(std::span<const WallLine> lines) : lines_(lines) {
    for (std::uint32_t i = 0; i < lines.size(); ++i) grid_.add(i, lines[i].a, lines[i].b);
  }

  bool is_axis(const WallLine& line) const {
    const double length = length_of(line);
    if (length < shortest_axis) return false;
    const Vec2 along = (line.b - line.a) / length;
    double first = length, last = 0;
    std::set<std::int64_t> crossed;  // Each wall once, whatever it is made of.
    grid_.near(line.a, line.b, 0.02, [&](std::uint32_t i) {
      const Vec2 a = lines_[i].a - line.a, b = lines_[i].b - line.a;
      const Vec2 run = lines_[i].b - lines_[i].a;
      const double across_a = cross(along, a), across_b = cross(along, b);
      if (glm::length(run) < 0.3 || std::abs(cross(along, run)) < 0.3 * glm::length(run)) return;
      if (std::max(across_a, across_b) < -0.02 || std::min(across_a, across_b) > 0.02) return;
      const double share = across_a / (across_a - across_b);
      const double at = dot(a + std::clamp(share, 0.0, 1.0) * (b - a), along);
      if (at < -0.02 || at > length + 0.02) return;
      first = std::min(first, at);
      last = std::max(last, at);
      crossed.insert(std::llround(at / 0.05));
    });
    return crossed.size() >= 4 && first > least_tail && length - last > least_tail;
  }

 private:
  static constexpr double shortest_axis = 4, least_tail = 0.8;  ///< Metres.
  std::span<const WallLine> lines_;
  SegmentGrid grid_{1};
};

/// Axes with the bubbles at their ends, which have the axes' names.
void drop_axes(std::vector<WallLine>& lines, FoundPlans& found) {
  const Axes axes(lines);
  std::vector<WallLine> walls;
  for (const WallLine& line : lines)
    if (!axes.is_axis(line)) walls.push_back(line);
  if (walls.size() < lines.size())
    found.culled["axes: lines that cross the plan and stand out of it"] +=
        lines.size() - walls.size();
  lines = std::move(walls);
}

/// Lines that lie twenty times farther out than nine tenths of all are strays.
void drop_strays(std::vector<WallLine>& lines, FoundPlans& found) {
  if (lines.size() < 20) return;
  const auto range = [&](auto coordinate) {
    std::vector<double> values;
    for (const WallLine& line : lines) {
      values.push_back(coordinate(line.a));
      values.push_back(coordinate(line.b));
    }
    std::ranges::sort(values);
    const double low = values[values.size() / 10], high = values[values.size() * 9 / 10];
    const double margin = 5 * (high - low) + 10;
    return std::pair{low - margin, high + margin};
  };
  const auto [left, right] = range([](Vec2 p) { return p.x; });
  const auto [low, high] = range([](Vec2 p) { return p.y; });
  const auto gone = std::ranges::remove_if(lines, [&](const WallLine& line) {
    const auto out = [&](Vec2 p) { return p.x < left || p.x > right || p.y < low || p.y > high; };
    return out(line.a) || out(line.b);
  });
  if (!gone.empty()) found.culled["strokes far away from the plan"] += gone.size();
  lines.erase(gone.begin(), gone.end());
}

}  // namespace

Chosen choose_lines(const Drawing& drawing, const std::vector<LayerKind>& kinds,
                    FoundPlans& found) {
  Chosen chosen = Chooser(drawing, kinds, found).choose();
  drop_strays(chosen.lines, found);
  drop_axes(chosen.lines, found);
  return chosen;
}

std::vector<Flight> take_flights(Chosen& chosen, FoundPlans& found) {
  std::vector<Flight> flights = find_flights(chosen.lines);
  std::vector<bool> is_tread(chosen.lines.size(), false);
  for (const Flight& flight : flights)
    for (const std::uint32_t tread : flight.treads) is_tread[tread] = true;
  std::vector<WallLine> others;
  for (std::size_t i = 0; i < chosen.lines.size(); ++i)
    if (!is_tread[i]) others.push_back(chosen.lines[i]);
  found.culled["treads of stairs"] = chosen.lines.size() - others.size();
  chosen.lines = std::move(others);
  std::ranges::move(find_flights(chosen.stairs), std::back_inserter(flights));
  return flights;
}

std::vector<Swing> swings_of(const Drawing& drawing, Chosen& chosen, FoundPlans& found) {
  std::vector<WallLine> leaves = chosen.leaves;
  leaves.insert(leaves.end(), chosen.lines.begin(), chosen.lines.end());
  std::vector<Swing> swings = find_swings(drawing, chosen.arcs, chosen.lines, leaves);
  std::vector<bool> is_swing(drawing.arcs.size(), false);
  for (const Swing& swing : swings) is_swing[swing.arc] = true;
  std::vector<std::uint32_t> others;
  for (const std::uint32_t arc : chosen.any_arcs)
    if (!is_swing[arc]) others.push_back(arc);
  for (const Swing& swing : find_swings_by_leaves(drawing, others, chosen.lines)) {
    is_swing[swing.arc] = true;
    swings.push_back(swing);
  }
  for (const auto& [arc, line] : chosen.strokes_of_arcs)
    if (!is_swing[arc]) chosen.lines.push_back(line);
  found.culled["arcs that are no doors"] = static_cast<std::size_t>(
      std::ranges::count_if(chosen.arcs, [&](std::uint32_t arc) { return !is_swing[arc]; }));
  return swings;
}

}  // namespace docent::import
