#include "content/import/drawing/read_drawing.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

#include "content/import/drawing/dxf.h"
#include "content/import/drawing/label.h"
#include "content/import/drawing/rooms.h"
#include "content/import/drawing/unit.h"

namespace docent::import {
namespace {

constexpr double least_quarter = std::numbers::pi / 3, most_quarter = std::numbers::pi / 1.8;

Diagnostic mistake(const BuildingSource& source, std::string code, std::string message,
                   std::string hint) {
  return {.file = source.file,
          .code = std::move(code),
          .message = std::move(message),
          .hint = std::move(hint)};
}

std::vector<LayerKind> kinds_of(const Drawing& drawing, const ImportOptions& options) {
  std::vector<LayerKind> kinds;
  for (const std::string& layer : drawing.layers)
    kinds.push_back(kind_of_layer(layer, options.layers));
  return kinds;
}

/// Radii of what could be door swings in any unit: quarter circles.
std::vector<double> leaf_radii(const Drawing& drawing, const std::vector<LayerKind>& kinds) {
  std::vector<double> radii, on_door_layers;
  for (const DrawnArc& arc : drawing.arcs) {
    if (kinds[arc.layer] == LayerKind::Other || arc.sweep < least_quarter ||
        arc.sweep > most_quarter)
      continue;
    radii.push_back(arc.radius);
    if (kinds[arc.layer] == LayerKind::Door || kinds[arc.layer] == LayerKind::Window)
      on_door_layers.push_back(arc.radius);
  }
  if (on_door_layers.size() >= 2) return on_door_layers;
  return radii.size() >= 2 ? radii : std::vector<double>{};
}

/// What is said of most rooms says nothing of any: the tag of an attribute, for one.
void drop_common_words(std::vector<FoundRoom>& rooms) {
  std::map<std::string, std::size_t> count;
  const auto words_of = [](const std::string& name) {
    std::vector<std::string> words;
    for (std::size_t at = 0; at < name.size();) {
      const std::size_t end = std::min(name.find(' ', at), name.size());
      if (end > at) words.push_back(name.substr(at, end - at));
      at = end + 1;
    }
    return words;
  };
  for (const FoundRoom& room : rooms) {
    const std::vector<std::string> words = words_of(room.name);
    for (const std::string& word : std::set<std::string>(words.begin(), words.end())) ++count[word];
  }
  for (FoundRoom& room : rooms) {
    std::string name;
    for (const std::string& word : words_of(room.name))
      if (rooms.size() < 8 || 10 * count[word] < 6 * rooms.size())
        name += (name.empty() ? "" : " ") + word;
    room.name = name;
  }
}

constexpr double farthest = 1e8;  ///< Metres: twice round the Earth. Numbers stay exact enough.
constexpr double longest_wall = 5000;  ///< Metres.

bool is_near(Vec2 p) {
  return std::abs(p.x) < farthest && std::abs(p.y) < farthest;
}

/// Takes out what lies farther away than anything that was drawn on purpose. Arcs keep their
/// places, since strokes name them.
void drop_far_things(Drawing& drawing) {
  std::size_t dropped = std::erase_if(drawing.segments, [](const DrawnSegment& segment) {
    return !is_near(segment.a) || !is_near(segment.b) ||
           glm::length(segment.b - segment.a) > longest_wall;
  });
  dropped += std::erase_if(drawing.rings, [](const DrawnRing& ring) {
    return !std::ranges::all_of(ring.corners, is_near);
  });
  dropped += std::erase_if(drawing.texts, [](const DrawnText& text) { return !is_near(text.at); });
  for (DrawnArc& arc : drawing.arcs)
    if (!is_near(arc.centre) || !is_near(arc.start) || !is_near(arc.end))
      arc = {.layer = arc.layer};
  if (dropped > 0) drawing.left_out["strokes longer or farther away than any building"] += dropped;
}

class BuildingOfPlans {
 public:
  BuildingOfPlans(const BuildingSource& source, const UnitFound& unit, std::optional<Vec2> move_by)
      : source_(source), move_by_(move_by) {
    building_.unit_said = unit.said;
    building_.frame_said = "the drawing's own, moved so that the plan begins at (0, 0)";
  }

  ImportedBuilding make(FoundPlans& found) {
    titled_ = std::ranges::all_of(found.plans,
                                  [](const FoundPlan& plan) { return plan.ordinal.has_value(); });
    // Some titles say nothing of the others' order, and what staff say wins.
    if (!titled_ || !source_.level.empty())
      for (FoundPlan& plan : found.plans) plan.ordinal.reset();
    for (std::size_t i = 0; i < found.plans.size(); ++i) add_level(found.plans[i], i, found);
    if (found.plans.size() > 1)
      doubt(
          "several-plans", "", {0, 0},
          fmt::format("{} plans lie side by side in this drawing; each became a level{}",
                      found.plans.size(), titled_ ? ", as its title says" : ""),
          "say the levels' order in museum.toml (ordinal of each [[floor]]), or save each plan as "
          "a file of its own");
    if (found.wings > 0)
      doubt("several-plans", "", {0, 0},
            fmt::format("{} parts lie apart from the plan and were taken for wings of its floor",
                        found.wings),
            "save a plan that is another floor as a file of its own");
    say_culls(found);
    return std::move(building_);
  }

 private:
  void doubt(std::string code, const std::string& level, Vec2 at, std::string message,
             std::string hint) {
    building_.doubts.push_back({std::move(code), level, at, std::move(message), std::move(hint)});
  }

  void add_level(FoundPlan& plan, std::size_t index, const FoundPlans& found) {
    origin_ = origin_of(plan);
    if (!building_.moved_by) building_.moved_by = origin_;
    ImportedLevel level;
    level.name = !source_.level.empty() && found.plans.size() == 1
                     ? source_.level
                     : fmt::format("{:g}", plan.ordinal.value_or(static_cast<double>(index)));
    level.ordinal = plan.ordinal.value_or(static_cast<double>(index));
    level.unsaid = !plan.ordinal && source_.level.empty();
    if (plan.ordinal) level.titles["en"] = plan.title.substr(0, 60);
    drop_common_words(plan.rooms);
    for (std::size_t i = 0; i < plan.rooms.size(); ++i) add_room(level, plan.rooms[i], i);
    for (std::size_t i = 0; i < plan.doors.size(); ++i) add_door(level, plan.doors[i], i);
    for (FoundStairs& stairs : plan.stairs) {
      const Vec2 at = stairs.middle - origin_;
      if (stairs.kind != "ramp") level.places.push_back({stairs.kind, stairs.name, {}, at});
      level.shafts.push_back({std::move(stairs.kind), std::move(stairs.name), at});
    }
    for (std::vector<Vec2>& column : plan.columns) level.obstacles.push_back(moved(column));
    if (found.outlines_taken && plan.rooms.size() > 1)
      doubt("no-doors", level.name, {0, 0},
            "the rooms are closed outlines and no doors are drawn, so no room leads to another",
            "write a [[door]] in the wall for each: floor, a and b, its two ends");
    building_.levels.push_back(std::move(level));
  }

  /// Plans of one museum that lie over one another in their drawings do so in the museum.
  Vec2 origin_of(const FoundPlan& plan) const {
    constexpr double reach = 50;  // Metres.
    const Vec2 low = plan.low - Vec2(reach), high = plan.high + Vec2(reach);
    const auto is_over = [&](Vec2 p) {
      return p.x > low.x && p.y > low.y && p.x < high.x && p.y < high.y;
    };
    return move_by_ && is_over(*move_by_) ? *move_by_ : plan.low;
  }

  std::vector<Vec2> moved(std::vector<Vec2> ring) const {
    for (Vec2& corner : ring) corner -= origin_;
    return ring;
  }

  void add_room(ImportedLevel& level, const FoundRoom& room, std::size_t index) {
    ImportedRoom out;
    out.name = room.name;
    out.kind = kind_of_room(room.name);
    for (const std::vector<Vec2>& ring : room.rings) out.rings.push_back(moved(ring));
    out.source_id = fmt::format("room/{}", index + 1);
    out.place = {source_.file, room.line, 0};
    if (std::string kind = place_of_room(room.name); !kind.empty())
      level.places.push_back({std::move(kind), room.name, {}, room.middle - origin_});
    if (room.stated_area && std::abs(room.area - *room.stated_area) > 0.05 * *room.stated_area)
      doubt("area-differs", level.name, room.middle - origin_,
            fmt::format("'{}' is {:.1f} m2 in the drawing, but its text says {:.4g} m2", room.name,
                        room.area, *room.stated_area),
            "look whether a wall is missing there");
    level.rooms.push_back(std::move(out));
  }

  void add_door(ImportedLevel& level, const FoundDoor& door, std::size_t index) {
    ImportedDoor out;
    out.id = fmt::format("door-{}", index + 1);
    out.a = door.a - origin_;
    out.b = door.b - origin_;
    out.width = glm::length(door.b - door.a);
    out.doubtful = !door.swing && (!door.certain || out.width > 1.6);
    out.source_id = out.id;
    if (out.doubtful) {
      const Vec2 at = 0.5 * (out.a + out.b);
      const bool wide = out.width > 2.6;
      doubt(wide ? "open-end" : "doubtful-door", level.name, at,
            fmt::format("{} is a gap of {:.2f} m in the walls at ({:.1f}, {:.1f}), {}", out.id,
                        out.width, at.x, at.y,
                        wide ? "wider than a door: taken for the open end of a room"
                             : "and no leaf is drawn"),
            fmt::format("if it is none, write closed = true under the [[door]] {}", out.id));
    }
    level.doors.push_back(std::move(out));
  }

  void say_culls(const FoundPlans& found) {
    std::string said;
    for (const auto& [what, count] : found.culled)
      said += fmt::format("{}{} {}", said.empty() ? "" : ", ", count, what);
    if (!said.empty())
      doubt("left-out", building_.levels.front().name, {0, 0}, "left out: " + said,
            "--layers wall=...,door=... says which layers are looked at");
  }

  const BuildingSource& source_;
  std::optional<Vec2> move_by_;
  ImportedBuilding building_;
  Vec2 origin_{};
  bool titled_ = false;  ///< Each plan has a title that says which floor it is.
};

}  // namespace

BuildingOrDiagnostics read_drawing(Drawing drawing, const BuildingSource& source,
                                   const ImportOptions& options) {
  const std::vector<LayerKind> kinds = kinds_of(drawing, options);
  const UnitFound unit = find_unit(drawing, leaf_radii(drawing, kinds), options.unit);
  if (!unit.refused.empty())
    return std::unexpected(
        Diagnostics{mistake(source, "unknown-unit", unit.refused,
                            "say --unit mm, cm, m, in or ft: the unit of the drawing's numbers")});
  scale(drawing, unit.metres);
  drop_far_things(drawing);
  FoundPlans found = find_rooms(drawing, kinds);
  if (!found.refused.empty())
    return std::unexpected(Diagnostics{
        mistake(source, "too-large-drawing", found.refused,
                "name the layers of walls, --layers wall=A-WALL, or the unit, --unit")});
  if (found.plans.empty())
    return std::unexpected(Diagnostics{mistake(
        source, "no-rooms", "no room is enclosed by the lines of this drawing",
        "name the layers of walls, --layers wall=A-WALL, or close the walls in the drawing")});
  for (const auto& [what, count] : drawing.left_out) found.culled[what] += count;
  ImportedBuilding building = BuildingOfPlans(source, unit, options.move_by).make(found);
  if (!unit.doubt.empty())
    building.doubts.insert(building.doubts.begin(),
                           {"unit", "", {0, 0}, unit.doubt, "say --unit to decide"});
  return building;
}

BuildingOrDiagnostics read_dxf(const BuildingSource& source, const ImportOptions& options) {
  return read_drawing(parse_dxf(source.file, source.bytes), source, options);
}

}  // namespace docent::import
