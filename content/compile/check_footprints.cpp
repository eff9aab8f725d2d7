#include "content/compile/check_footprints.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "content/compile/sets.h"
#include "content/floor/medial_axis.h"
#include "content/floor/voronoi.h"
#include "runtime/model/geometry/polygon.h"
#include "runtime/model/geometry/segment.h"
#include "runtime/path/medial_axis/medial_axis_map.h"
#include "runtime/path/route.h"

namespace docent::compile {

namespace {

constexpr double longest_detour = 15;  // metres
constexpr double sample_step = 0.1;    // metres along the axis

/// Where a body walks in the middle of the floor without things: points, and which follow on which.
struct Samples {
  std::vector<Vec2> point;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> steps;
};

Samples sample_axis(const Floor& floor, double radius) {
  const path::MedialAxisMap axis(floor);
  Samples samples{floor.roadmap.position, {}};
  for (const RoadmapEdge& edge : floor.roadmap.edges) {
    if (edge.clearance < path::least_clearance(radius)) continue;
    const path::EdgeCurve& curve = axis.curve(edge.voronoi_edge);
    const auto pieces = static_cast<int>(std::ceil(edge.length / sample_step));
    std::uint32_t last = edge.from;
    for (int i = 1; i < pieces; ++i) {
      const auto next = static_cast<std::uint32_t>(samples.point.size());
      samples.point.push_back(
          curve.point_at(std::lerp(curve.begin(), curve.end(), i * 1.0 / pieces)));
      samples.steps.emplace_back(last, next);
      last = next;
    }
    samples.steps.emplace_back(last, edge.to);
  }
  return samples;
}

class PassageFinder {
 public:
  PassageFinder(const path::FloorMap& map, std::span<const Standing> things, double radius)
      : map_(map), radius_(radius) {
    for (const Standing& thing : things)
      if (takes_floor(thing)) things_.push_back(&thing);
  }

  /// Is anything so near to a wall or another thing that a body cannot pass between?
  [[nodiscard]] bool may_close(const path::WallGrid& walls) const {
    const auto reach = [&](const Standing& thing) {
      return glm::length(thing.footprint.size) / 2 + radius_;
    };
    return std::ranges::any_of(things_, [&](const Standing* thing) {
      const Vec2 centre = thing->footprint.centre;
      return walls.nearest_wall(centre).distance < reach(*thing) + radius_ ||
             std::ranges::any_of(
                 things_,
                 [&](const Standing* other) {
                   return other != thing && glm::distance(centre, other->footprint.centre) <
                                                reach(*thing) + reach(*other);
                 });
    });
  }

  std::vector<ClosedPassage> find(const Samples& samples) {
    std::vector<bool> is_taken(samples.point.size());
    for (std::size_t i = 0; i < is_taken.size(); ++i) is_taken[i] = has_no_room(samples.point[i]);
    Sets stretch(samples.point.size());
    for (const auto& [a, b] : samples.steps)
      if (is_taken[a] && is_taken[b]) stretch.join(stretch.of(a), stretch.of(b));
    std::map<std::uint32_t, std::vector<std::uint32_t>> taken, sides;  // by stretch
    for (const auto& [a, b] : samples.steps) {
      if (is_taken[a] != is_taken[b])
        sides[stretch.of(is_taken[a] ? a : b)].push_back(is_taken[a] ? b : a);
      for (const std::uint32_t i : {a, b})
        if (is_taken[i]) taken[stretch.of(i)].push_back(i);
    }
    std::vector<ClosedPassage> passages;
    for (const auto& [of, ends] : sides)
      if (auto passage = passage_between(samples, ends)) {
        passage->by = things_about(samples, taken[of], passage->at);
        if (!passage->by.empty()) passages.push_back(std::move(*passage));
      }
    return passages;
  }

 private:
  [[nodiscard]] bool has_no_room(Vec2 p) const {
    return !map_.has_room(p, radius_) &&
           std::ranges::any_of(things_, [&](const Standing* thing) { return is_near(*thing, p); });
  }

  [[nodiscard]] bool is_near(const Standing& thing, Vec2 p) const {
    return floor::distance_to(thing.footprint, p) < radius_ + 1e-6;
  }

  /// Of the ends of a taken stretch of the axis, two between which one cannot walk any more: those
  /// without any way first.
  [[nodiscard]] std::optional<ClosedPassage> passage_between(
      const Samples& samples, const std::vector<std::uint32_t>& ends) const {
    std::optional<ClosedPassage> longest;
    const Vec2 from = samples.point[ends.front()];
    for (const std::uint32_t end : ends) {
      const Vec2 to = samples.point[end];
      const auto round = way(from, to);
      if (round && *round <= glm::distance(from, to) + longest_detour) continue;
      if (longest && longest->way_round && round && *round <= *longest->way_round) continue;
      longest = ClosedPassage{
          .by = {}, .at = (from + to) * 0.5, .from = from, .to = to, .way_round = round};
      if (!round) break;
    }
    return longest;
  }

  [[nodiscard]] std::optional<double> way(Vec2 from, Vec2 to) const {
    const path::Way found =
        path::route(map_, {.kind = RouteKind::Shortest, .from = from, .to = to, .radius = radius_});
    return found.status == path::RouteStatus::Ok ? std::optional(found.length) : std::nullopt;
  }

  [[nodiscard]] std::vector<const Standing*> things_about(const Samples& samples,
                                                          const std::vector<std::uint32_t>& taken,
                                                          Vec2 middle) const {
    std::vector<const Standing*> about;
    std::ranges::copy_if(things_, std::back_inserter(about), [&](const Standing* thing) {
      return std::ranges::any_of(
          taken, [&](std::uint32_t i) { return is_near(*thing, samples.point[i]); });
    });
    std::ranges::stable_sort(about, {}, [&](const Standing* thing) {
      return floor::distance_to(thing->footprint, middle);
    });
    return about;
  }

  const path::FloorMap& map_;
  double radius_;
  std::vector<const Standing*> things_;
};

const Room* room_at(std::span<const Room> rooms, Vec2 point) {
  const auto room =
      std::ranges::find_if(rooms, [&](const Room& r) { return contains(r.outline, point); });
  return room == rooms.end() ? nullptr : &*room;
}

const std::string& title_of(const Room& room, const std::string& language) {
  const auto title = room.title.find(language);
  return title == room.title.end() ? room.id : title->second;
}

}  // namespace

std::vector<ClosedPassage> closed_passages(const FloorPlan& walls, const path::FloorMap& map,
                                           std::span<const Standing> things, double radius) {
  PassageFinder finder(map, things, radius);
  if (!finder.may_close(path::WallGrid(walls, 0))) return {};
  Floor bare;
  bare.plan = walls;
  bare.diagram = floor::voronoi_diagram(bare.plan);
  bare.roadmap = floor::medial_axis(bare.plan, bare.diagram);
  return finder.find(sample_axis(bare, radius));
}

std::string passage_name(const ClosedPassage& passage, std::span<const Door> doors,
                         std::span<const Room> rooms, const std::string& language) {
  constexpr double near_door = 0.5;  // metres
  for (const Door& door : doors)
    if (distance_to_segment(passage.at, door.a, door.b) < near_door)
      return fmt::format("the door '{}'", door.name);
  const Room* from = room_at(rooms, passage.from);
  const Room* to = room_at(rooms, passage.to);
  if (from != nullptr && to != nullptr && from != to)
    return fmt::format("the way between '{}' and '{}'", title_of(*from, language),
                       title_of(*to, language));
  return fmt::format("the passage at {}", point_text(passage.at));
}

const Standing* in_the_way(std::span<const Standing> things, Vec2 point, double radius) {
  const Standing* nearest = nullptr;
  double least = radius;
  for (const Standing& thing : things) {
    if (!takes_floor(thing)) continue;
    const double distance = floor::distance_to(thing.footprint, point);
    if (distance >= least) continue;
    least = distance;
    nearest = &thing;
  }
  return nearest;
}

std::optional<PlaceProblem> why_not_there(const path::FloorMap& map,
                                          std::span<const Standing> things, Vec2 point,
                                          double radius) {
  std::optional<PlaceProblem> problem = why_nobody_stands(map, point, radius);
  const Standing* thing = problem ? in_the_way(things, point, radius) : nullptr;
  if (thing == nullptr) return problem;
  const double away = floor::distance_to(thing->footprint, point);
  problem->label = fmt::format("{} {}, which takes {} of the floor",
                               away > 0 ? fmt::format("{:.2f} m from", away) : "on the place of",
                               thing->name, size_text(thing->footprint));
  return problem;
}

}  // namespace docent::compile
