#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <string_view>

#include "content/import/building/level_list.h"
#include "content/import/building/plan_feature.h"
#include "content/import/building/shape.h"
#include "content/import/building/wall_line.h"
#include "runtime/model/none.h"

namespace docent::import {
namespace {

bool is_room(const PlanFeature& feature) noexcept {
  return feature.form == FeatureForm::Area &&
         (feature.role == FeatureRole::Room || feature.role == FeatureRole::Corridor ||
          feature.role == FeatureRole::Hall);
}

std::string_view kind_of(FeatureRole role) noexcept {
  if (role == FeatureRole::Corridor) return "corridor";
  return role == FeatureRole::Hall ? "hall" : "room";
}

Vec2 position_of(const PlanFeature& feature) {
  if (feature.form != FeatureForm::Area || feature.polygons.empty())
    return feature.line.empty() ? Vec2{} : feature.line[feature.line.size() / 2];
  return middle_of(shape_of(feature.polygons.front()));
}

/// How thick a drawn wall is taken to be, metres.
constexpr double wall_thickness = 0.1;
/// A closed wall no thicker than this is the wall itself; a thicker one is a line about rooms.
constexpr double thickest_wall = 1.0;

/// A lift or stairs on one level, which may go on above it.
struct Shaft {
  const PlanFeature* feature = nullptr;
  double ordinal = 0;
  Shape shape{};
};

class Assembler {
 public:
  Assembler(std::vector<PlanFeature> features, const std::vector<LevelFact>& facts)
      : features_(std::move(features)), facts_(facts) {}

  ImportedBuilding building() && {
    give_levels();
    make_levels();
    for (const PlanFeature& feature : features_) {
      add_rooms(feature);
      add_obstacles(feature);
      add_way(feature);
      add_places(feature);
    }
    for (const PlanFeature& feature : features_) add_door(feature);
    add_connections();
    return std::move(building_);
  }

 private:
  /// A plan that never speaks of levels has one.
  void give_levels() {
    const bool some = std::ranges::any_of(features_, [](const PlanFeature& feature) {
      return is_room(feature) && !feature.levels.empty();
    });
    const bool rooms = std::ranges::any_of(features_, is_room);
    unsaid_ = !some && rooms && facts_.size() != 1;
    for (PlanFeature& feature : features_) {
      if (!feature.levels.empty()) continue;
      if (!some && rooms)
        feature.levels = {facts_.size() == 1 ? facts_[0].ordinal : 0.0};
      else if (is_room(feature))
        doubt("room-without-level", "", position_of(feature),
              fmt::format("{} says on no level and was left out", called(feature)),
              "give it a level in the plan and import again");
    }
  }

  static std::string called(const PlanFeature& feature) {
    if (!feature.name.empty()) return fmt::format("'{}'", feature.name);
    return feature.source_id.empty() ? "a room without a name"
                                     : fmt::format("the room {}", feature.source_id);
  }

  void doubt(std::string code, std::string level, Vec2 at, std::string message, std::string hint) {
    building_.doubts.push_back(
        {std::move(code), std::move(level), at, std::move(message), std::move(hint)});
  }

  void make_levels() {
    std::set<double> ordinals;
    for (const PlanFeature& feature : features_)
      if (is_room(feature)) ordinals.insert(feature.levels.begin(), feature.levels.end());
    if (ordinals.empty())
      for (const PlanFeature& feature : features_)
        ordinals.insert(feature.levels.begin(), feature.levels.end());
    for (const double ordinal : ordinals) {
      ImportedLevel level{.name = level_name(ordinal), .ordinal = ordinal, .unsaid = unsaid_};
      for (const LevelFact& fact : facts_) {
        if (fact.ordinal != ordinal) continue;
        if (!fact.name.empty()) level.name = fact.name;
        if (!fact.titles.empty()) level.titles = fact.titles;
        if (!fact.short_name.empty()) level.short_name = fact.short_name;
        level.elevation = fact.elevation;
      }
      building_.levels.push_back(std::move(level));
    }
  }

  ImportedLevel* level_at(double ordinal) {
    const auto level = std::ranges::find(building_.levels, ordinal, &ImportedLevel::ordinal);
    return level == building_.levels.end() ? nullptr : &*level;
  }

  void add_rooms(const PlanFeature& feature) {
    if (!is_room(feature)) return;
    for (const double ordinal : feature.levels)
      for (const std::vector<BuildingRing>& rings : feature.polygons)
        level_at(ordinal)->rooms.push_back({.name = feature.name,
                                            .titles = feature.titles,
                                            .kind = std::string(kind_of(feature.role)),
                                            .rings = rings,
                                            .source_id = feature.source_id,
                                            .place = feature.placed});
  }

  void add_obstacles(const PlanFeature& feature) {
    if (feature.role != FeatureRole::Wall && feature.role != FeatureRole::Obstacle) return;
    for (const double ordinal : feature.levels) {
      ImportedLevel* level = level_at(ordinal);
      if (level == nullptr) continue;
      for (const Shape& shape : solids(feature))
        for (const auto& rings : polygons_of(shape)) add_solid(*level, rings);
    }
  }

  void add_way(const PlanFeature& feature) {
    if (feature.role != FeatureRole::Way || feature.line.size() < 2 || feature.levels.size() != 1)
      return;
    if (ImportedLevel* level = level_at(feature.levels[0])) level->ways.push_back(feature.line);
  }

  /// A ring of walls has rooms inside: it becomes two halves, which have none.
  static void add_solid(ImportedLevel& level, const std::vector<BuildingRing>& rings) {
    if (rings.size() == 1) return level.obstacles.push_back(rings.front());
    const Shape shape = shape_of(rings);
    const Box box = shape.bounds();
    const Vec2 in_hole = rings[1].front();
    const std::vector<BuildingRing> west{{{box.low.x - 1, box.low.y - 1},
                                          {in_hole.x, box.low.y - 1},
                                          {in_hole.x, box.high.y + 1},
                                          {box.low.x - 1, box.high.y + 1}}};
    const Shape half = shape_of(west);
    for (const Shape& side : {common(shape, half), without(shape, half)})
      for (const auto& part : polygons_of(side))
        if (part.size() < rings.size())
          add_solid(level, part);
        else
          level.obstacles.push_back(part.front());
  }

  static std::vector<Shape> solids(const PlanFeature& feature) {
    std::vector<Shape> shapes;
    if (feature.form == FeatureForm::Line)
      shapes.push_back(shape_about(feature.line, wall_thickness / 2, LineEnds::Square));
    if (feature.form != FeatureForm::Area) return shapes;
    for (const std::vector<BuildingRing>& rings : feature.polygons) {
      Shape shape = shape_of(rings);
      const bool thin = grown(shape, -thickest_wall / 2).empty();
      if (feature.role == FeatureRole::Obstacle || thin || rings.size() > 1) {
        shapes.push_back(std::move(shape));
      } else {
        BuildingRing closed = rings.front();
        closed.push_back(closed.front());
        shapes.push_back(shape_about(closed, wall_thickness / 2, LineEnds::Flat));
      }
    }
    return shapes;
  }

  void add_places(const PlanFeature& feature) {
    if (feature.places.empty()) return;
    const Vec2 at = position_of(feature);
    for (const std::string& kind : feature.places) {
      if (!feature.connection.empty() && (kind == "lift" || kind == "stairs")) continue;
      for (const double ordinal : feature.levels)
        if (ImportedLevel* level = level_at(ordinal))
          level->places.push_back(
              {.kind = kind, .name = feature.name, .titles = feature.titles, .position = at});
    }
  }

  void add_door(const PlanFeature& feature) {
    if (feature.role != FeatureRole::Door || feature.line.empty()) return;
    std::vector<double> levels = feature.levels;
    if (levels.empty())
      for (const ImportedLevel& level : building_.levels)
        if (wall_at(level, feature.line.front(), touching)) levels.push_back(level.ordinal);
    for (const double ordinal : levels)
      if (ImportedLevel* level = level_at(ordinal)) add_door_on(*level, feature);
  }

  static constexpr double touching = 0.05;     ///< Metres: a door's node is on the wall.
  static constexpr double off_wall = 0.6;      ///< Metres: a door belongs to no wall farther off.
  static constexpr double usual_door = 1.0;    ///< Metres: where nothing is said.
  static constexpr double widest_point = 4.0;  ///< Metres: a door drawn as a point is no wider.

  void add_door_on(ImportedLevel& level, const PlanFeature& feature) {
    ImportedDoor door{.id = feature.name, .width = feature.width, .source_id = feature.source_id};
    const bool drawn =
        feature.line.size() > 1 && glm::distance(feature.line.front(), feature.line.back()) > 0.2;
    if (drawn) {
      door.a = feature.line.front();
      door.b = feature.line.back();
      door.width = glm::distance(door.a, door.b);
    } else {
      const Vec2 at = feature.line.front();
      const auto wall = wall_at(level, at, off_wall);
      const double width =
          std::clamp(feature.width > 0 ? feature.width : usual_door, 0.3, widest_point);
      const Vec2 half = wall ? wall->along * (width / 2) : Vec2{};
      const Vec2 on = wall ? wall->at : at;
      door.a = on - half;
      door.b = on + half;
      door.doubtful = !wall || wall->distance > touching;
      if (!wall)
        doubt("door-without-wall", level.name, at,
              fmt::format("the door {} stands in no wall", feature.source_id),
              "draw it on the wall of the room that it opens, or leave it out");
      else if (door.doubtful)
        doubt("door-off-wall", level.name, at,
              fmt::format("the door {} is {:.2f} m beside the nearest wall, and was moved there",
                          feature.source_id, wall->distance),
              "draw it on the wall");
    }
    for (const std::string& room : {feature.from, feature.to})
      if (!room.empty() && !knows_room(room))
        doubt(
            "door-names-unknown-room", level.name, (door.a + door.b) / 2.0,
            fmt::format("the door {} names '{}', which no room is called", feature.source_id, room),
            "correct the name in the plan; the door was taken for where it is drawn");
    level.doors.push_back(std::move(door));
  }

  bool knows_room(const std::string& name) {
    if (room_names_.empty())
      for (const PlanFeature& feature : features_)
        if (is_room(feature)) room_names_.insert(feature.name);
    return room_names_.contains(name);
  }

  void add_connections() {
    std::vector<Shaft> shafts;
    for (const PlanFeature& feature : features_) {
      if (feature.connection.empty()) continue;
      if (feature.form == FeatureForm::Area) {
        if (feature.polygons.empty()) continue;
        if (feature.levels.size() > 1)
          add_area_connection(feature);
        else if (!feature.levels.empty())
          shafts.push_back({&feature, feature.levels[0], shape_of(feature.polygons.front())});
      }
    }
    add_stacked(shafts);
    for (const PlanFeature& feature : features_) {
      if (feature.connection.empty() || feature.levels.size() < 2) continue;
      if (feature.form == FeatureForm::Point) add_point_connection(feature);
      if (feature.form == FeatureForm::Line) add_line_connection(feature);
    }
  }

  void connect(const PlanFeature& feature, std::vector<ImportedStop> stops) {
    if (stops.size() < 2) return;
    std::string direction;
    if (feature.connection == "escalator" && feature.up && !feature.direction.empty())
      direction = (feature.direction == "forward") == *feature.up ? "up" : "down";
    building_.connections.push_back({.kind = feature.connection,
                                     .stops = std::move(stops),
                                     .direction = direction,
                                     .name = feature.name,
                                     .source_id = feature.source_id});
  }

  void add_area_connection(const PlanFeature& feature) {
    const Vec2 at = position_of(feature);
    std::vector<ImportedStop> stops;
    for (const double ordinal : feature.levels)
      if (const ImportedLevel* level = level_at(ordinal))
        stops.push_back({level->name, at, facing_into(*level, at)});
    connect(feature, std::move(stops));
  }

  /// One goes in from the nearest door.
  static double facing_into(const ImportedLevel& level, Vec2 at) {
    double facing = 0, nearest = infinity;
    for (const ImportedDoor& door : level.doors) {
      const Vec2 from = (door.a + door.b) / 2.0;
      const double away = glm::distance(from, at);
      if (away >= nearest || away < 1e-6) continue;
      nearest = away;
      facing = std::atan2(at.y - from.y, at.x - from.x);
    }
    return facing;
  }

  /// A node inside a lift that is drawn as an area says nothing new.
  bool is_inside_area(const PlanFeature& point) const {
    return std::ranges::any_of(features_, [&](const PlanFeature& other) {
      return other.form == FeatureForm::Area && other.connection == point.connection &&
             other.levels == point.levels && !other.polygons.empty() &&
             holds(shape_of(other.polygons.front()), point.line.front());
    });
  }

  void add_point_connection(const PlanFeature& feature) {
    if (feature.line.empty() || is_inside_area(feature)) return;
    std::vector<ImportedStop> stops;
    for (const double ordinal : feature.levels)
      if (const ImportedLevel* level = level_at(ordinal))
        stops.push_back({level->name, feature.line.front(), 0});
    connect(feature, std::move(stops));
  }

  /// Stairs drawn as a line: their ends are on the lowest and the highest level, those between lie
  /// between.
  void add_line_connection(const PlanFeature& feature) {
    if (feature.line.size() < 2) return;
    std::vector<ImportedStop> stops;
    const bool up = feature.up ? *feature.up : leads_up(feature);
    const auto last = static_cast<double>(feature.levels.size() - 1);
    for (std::size_t i = 0; i < feature.levels.size(); ++i) {
      const ImportedLevel* level = level_at(feature.levels[i]);
      if (level == nullptr) continue;
      const double share = static_cast<double>(i) / last;
      const Vec2 at = point_along(feature.line, up ? share : 1 - share);
      const Vec2 on = point_along(feature.line, up ? share + 0.01 : 0.99 - share);
      stops.push_back({level->name, at, std::atan2(on.y - at.y, on.x - at.x)});
    }
    connect(feature, std::move(stops));
  }

  static Vec2 point_along(const std::vector<Vec2>& line, double share) {
    double length = 0;
    for (std::size_t i = 1; i < line.size(); ++i) length += glm::distance(line[i - 1], line[i]);
    double left = std::clamp(share, 0.0, 1.0) * length;
    for (std::size_t i = 1; i < line.size(); ++i) {
      const double piece = glm::distance(line[i - 1], line[i]);
      if (left <= piece && piece > 0) return glm::mix(line[i - 1], line[i], left / piece);
      left -= piece;
    }
    return line.back();
  }

  /// Nothing is said: the end at which something of the lower level lies is below.
  bool leads_up(const PlanFeature& feature) const {
    int up = 0;
    for (const PlanFeature& other : features_) {
      if (&other == &feature || other.levels.size() != 1 || other.form == FeatureForm::Point)
        continue;
      const bool low = other.levels[0] == feature.levels.front();
      const bool high = other.levels[0] == feature.levels.back();
      if (low == high) continue;
      const auto touches = [&](Vec2 end) {
        return std::ranges::any_of(other.line, [&](Vec2 p) { return glm::distance(p, end) < 0.1; });
      };
      if (touches(feature.line.front())) up += low ? 1 : -1;
      if (touches(feature.line.back())) up += high ? 1 : -1;
    }
    return up >= 0;
  }

  /// Stairs and lifts that are drawn on each level for itself go on where they lie over each other,
  /// or bear one name.
  void add_stacked(const std::vector<Shaft>& shafts) {
    std::vector<std::size_t> group(shafts.size());
    std::iota(group.begin(), group.end(), std::size_t{0});
    const auto root = [&](std::size_t i) {
      while (group[i] != i) i = group[i] = group[group[i]];
      return i;
    };
    for (std::size_t i = 0; i < shafts.size(); ++i)
      for (std::size_t j = i + 1; j < shafts.size(); ++j)
        if (goes_on(shafts[i], shafts[j])) group[root(i)] = root(j);
    std::map<std::size_t, std::vector<const Shaft*>> groups;
    for (std::size_t i = 0; i < shafts.size(); ++i) groups[root(i)].push_back(&shafts[i]);
    for (auto& [first, members] : groups) connect_stack(members);
  }

  bool goes_on(const Shaft& a, const Shaft& b) const {
    if (a.ordinal == b.ordinal || a.feature->connection != b.feature->connection) return false;
    if (!are_neighbours(a.ordinal, b.ordinal)) return false;
    if (!a.feature->name.empty() && a.feature->name == b.feature->name &&
        distance(a.shape, b.shape) < 10)
      return true;
    if (!meet(a.shape.bounds(), b.shape.bounds(), 0)) return false;
    return common(a.shape, b.shape).area() > 0.5 * std::min(a.shape.area(), b.shape.area());
  }

  bool are_neighbours(double a, double b) const {
    const auto [low, high] = std::minmax(a, b);
    return std::ranges::none_of(building_.levels, [low = low, high = high](const auto& level) {
      return level.ordinal > low && level.ordinal < high;
    });
  }

  void connect_stack(std::vector<const Shaft*>& members) {
    if (members.size() < 2) return;
    std::ranges::stable_sort(members, {}, &Shaft::ordinal);
    const bool twice = std::ranges::adjacent_find(members, {}, &Shaft::ordinal) != members.end();
    if (!twice) return connect_shafts(members);
    for (const Shaft* low : members)
      for (const Shaft* high : members)
        if (low->ordinal < high->ordinal && goes_on(*low, *high)) connect_shafts({low, high});
  }

  void connect_shafts(const std::vector<const Shaft*>& members) {
    std::vector<ImportedStop> stops;
    for (const Shaft* shaft : members) {
      const ImportedLevel* level = level_at(shaft->ordinal);
      if (level == nullptr) continue;
      const Vec2 at = middle_of(shaft->shape);
      stops.push_back({level->name, at, facing_into(*level, at)});
    }
    connect(*members.front()->feature, std::move(stops));
  }

  std::vector<PlanFeature> features_;
  const std::vector<LevelFact>& facts_;
  bool unsaid_ = false;
  std::set<std::string, std::less<>> room_names_;
  ImportedBuilding building_;
};

}  // namespace

ImportedBuilding assemble(std::vector<PlanFeature> features, const std::vector<LevelFact>& facts) {
  return Assembler(std::move(features), facts).building();
}

}  // namespace docent::import
