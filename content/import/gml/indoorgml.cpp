#include "content/import/gml/indoorgml.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "content/content_error.h"
#include "content/import/building/geo_frame.h"
#include "content/import/building/level_list.h"
#include "content/import/building/plan_feature.h"
#include "content/import/building/shape.h"
#include "content/import/gml/gml_geometry.h"

namespace docent::import {
namespace {

/// Floors nearer to each other than this are one level's. Metres.
constexpr double one_level = 1.5;

/// A room with its floor as written, before levels and frame are known.
struct Cell {
  std::string id{}, name{}, description{};
  GmlFloor floor{};
  const XmlElement* element = nullptr;
  double ordinal = 0;
};

/// Gives cells their ordinals by the heights of their floors: 0 is the level at height 0 where
/// there is one, else the lowest.
std::vector<LevelFact> set_ordinals(std::vector<Cell>& cells) {
  std::vector<double> heights;
  for (const Cell& cell : cells) heights.push_back(cell.floor.height);
  std::ranges::sort(heights);
  std::vector<double> levels;
  for (const double height : heights)
    if (levels.empty() || height - levels.back() > one_level) levels.push_back(height);
  const auto ground =
      std::ranges::find_if(levels, [](double h) { return std::abs(h) < one_level; });
  const auto zero = ground == levels.end() ? 0 : ground - levels.begin();
  std::vector<LevelFact> facts;
  for (std::size_t i = 0; i < levels.size(); ++i)
    facts.push_back({.ordinal = static_cast<double>(static_cast<std::ptrdiff_t>(i) - zero),
                     .elevation = levels[i]});
  for (Cell& cell : cells)
    for (std::size_t i = 0; i < levels.size(); ++i)
      if (cell.floor.height >= levels[i] - 1e-9) cell.ordinal = facts[i].ordinal;
  return facts;
}

/// `level=4;` in a cell's description.
std::string_view said_in(std::string_view description, std::string_view key) {
  const std::size_t at = description.find(key);
  if (at == std::string_view::npos) return {};
  const std::string_view value = description.substr(at + key.size());
  return value.substr(0, value.find_first_of("; \t\r\n"));
}

/// One level that the file names itself.
void take_said_level(std::vector<Cell>& cells, std::vector<LevelFact>& facts) {
  if (facts.size() != 1) return;
  for (const Cell& cell : cells)
    if (const auto levels = parse_levels(said_in(cell.description, "level="));
        levels && levels->size() == 1) {
      facts[0].ordinal = levels->front();
      for (Cell& each : cells) each.ordinal = levels->front();
      return;
    }
}

std::string kind_by_name(std::string_view text) {
  std::string lower(text);
  std::ranges::transform(lower, lower.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  for (const std::string_view word : {"lift", "elevator", "aufzug"})
    if (lower.find(word) != std::string::npos) return "lift";
  if (lower.find("escalator") != std::string::npos) return "escalator";
  if (lower.find("ramp") != std::string::npos) return "ramp";
  return "stairs";
}

std::string_view reference_of(const XmlElement& element) {
  std::string_view reference = element.attribute("href");
  if (reference.starts_with('#')) reference.remove_prefix(1);
  return reference;
}

class IndoorGmlReader {
 public:
  IndoorGmlReader(const BuildingSource& source, const ImportOptions& options)
      : source_(source), options_(options), root_(parse_xml(source.file, source.bytes)) {}

  ImportedBuilding building() && {
    read_cells();
    facts_ = set_ordinals(cells_);
    take_said_level(cells_, facts_);
    find_frame_of_cells();
    for (const Cell& cell : cells_) add_cell(cell);
    read_graph();
    ImportedBuilding building = assemble(std::move(plan_), facts_);
    if (frame_.numbers != MapNumbers::Lengths) building.origin = frame_.origin;
    building.frame_said = frame_.said;
    return building;
  }

 private:
  void read_cells() {
    for (const char* kind :
         {"CellSpace", "GeneralSpace", "TransitionSpace", "ConnectionSpace", "AnchorSpace"})
      for (const XmlElement* element : find_all(root_, kind)) {
        Cell cell{.id = std::string(element->attribute("id")), .element = element};
        if (const XmlElement* name = element->child("name")) cell.name = name->text;
        if (const XmlElement* description = element->child("description"))
          cell.description = description->text;
        cell.floor = gml_floor(source_.file, *element);
        if (!cell.floor.polygons.empty()) cells_.push_back(std::move(cell));
      }
    if (cells_.empty())
      throw content::ContentError(
          source_.file, root_.line, root_.column, "no-rooms",
          "no cell of this IndoorGML has a floor",
          "export the cells with their geometry (Geometry2D or Geometry3D)");
  }

  void find_frame_of_cells() {
    MapNumbersSeen seen{.file = source_.file, .crs = "the drawing"};
    for (const XmlElement* element : find_all(root_, "Envelope"))
      if (!element->attribute("srsName").empty()) seen.crs = element->attribute("srsName");
    for (const Cell& cell : cells_)
      for (const auto& polygon : cell.floor.polygons)
        seen.rings.insert(seen.rings.end(), polygon.begin(), polygon.end());
    frame_ = find_frame(seen, options_);
  }

  void add_cell(const Cell& cell) {
    PlanFeature made{.role = FeatureRole::Room, .form = FeatureForm::Area};
    if (cell.element->name == "TransitionSpace") made.role = FeatureRole::Corridor;
    for (const auto& polygon : cell.floor.polygons) {
      auto& rings = made.polygons.emplace_back();
      for (const BuildingRing& ring : polygon) {
        auto& laid = rings.emplace_back();
        for (const Vec2 point : ring) laid.push_back(frame_.to_floor(point));
      }
    }
    made.levels = {cell.ordinal};
    made.name = cell.name;
    made.source_id = cell.id;
    made.placed = {source_.file, cell.element->line, cell.element->column};
    shape_[cell.id] = shape_of(made.polygons.front());
    cell_[cell.id] = &cell;
    plan_.push_back(std::move(made));
  }

  void read_graph() {
    for (const XmlElement* state : find_all(root_, "State")) {
      const XmlElement* dual = state->child("duality");
      if (dual != nullptr)
        cell_of_state_[std::string(state->attribute("id"))] = reference_of(*dual);
      const auto points = gml_points(source_.file, *state);
      if (!points.empty())
        state_at_[std::string(state->attribute("id"))] = frame_.to_floor(points[0].at);
    }
    for (const char* kind : {"CellSpaceBoundary", "ConnectionBoundary", "TransitionBoundary"})
      for (const XmlElement* boundary : find_all(root_, kind))
        boundary_[std::string(boundary->attribute("id"))] = boundary;
    for (const XmlElement* transition : find_all(root_, "Transition")) add_transition(*transition);
  }

  void add_transition(const XmlElement& transition) {
    std::vector<std::string> states;
    for (const XmlElement& child : transition.children)
      if (child.name == "connects") states.emplace_back(reference_of(child));
    if (states.size() != 2) return;
    const Cell *a = cell_at(states[0]), *b = cell_at(states[1]);
    if (a == nullptr || b == nullptr || a == b) return;
    std::vector<Vec2> line;
    for (const GmlPoint& point : gml_points(source_.file, transition))
      line.push_back(frame_.to_floor(point.at));
    if (a->ordinal != b->ordinal)
      add_vertical(*a, *b, states);
    else
      add_door(transition, *a, *b, line);
  }

  const Cell* cell_at(const std::string& state) const {
    const auto id = cell_of_state_.find(state);
    if (id == cell_of_state_.end()) return nullptr;
    const auto cell = cell_.find(id->second);
    return cell == cell_.end() ? nullptr : cell->second;
  }

  void add_door(const XmlElement& transition, const Cell& a, const Cell& b,
                const std::vector<Vec2>& line) {
    PlanFeature door{.role = FeatureRole::Door, .form = FeatureForm::Line};
    door.levels = {a.ordinal};
    door.source_id = transition.attribute("id");
    if (const XmlElement* dual = transition.child("duality"))
      if (const auto found = boundary_.find(reference_of(*dual)); found != boundary_.end())
        for (const GmlPoint& point : gml_points(source_.file, *found->second))
          door.line.push_back(frame_.to_floor(point.at));
    if (door.line.empty()) {
      door.form = FeatureForm::Point;
      door.line = {between(a, b, line)};
    }
    const Vec2 middle = (door.line.front() + door.line.back()) / 2.0;
    // A way and its way back are one door.
    const auto key = std::minmax(a.id, b.id);
    for (const auto& [cells, at] : doors_)
      if (cells == std::pair(key.first, key.second) && glm::distance(at, middle) < 0.5) return;
    doors_.push_back({{key.first, key.second}, middle});
    plan_.push_back(std::move(door));
  }

  /// Where a line goes from one cell to the other: the vertex that is nearest to both, else the
  /// middle of the edge that they share.
  Vec2 between(const Cell& a, const Cell& b, const std::vector<Vec2>& line) {
    const Shape &from = shape_[a.id], &to = shape_[b.id];
    Vec2 best = line.empty() ? Vec2{} : line[line.size() / 2];
    double nearest = 1.0;
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
      const double away = distance(from, line[i]) + distance(to, line[i]);
      if (away < nearest) {
        nearest = away;
        best = line[i];
      }
    }
    if (nearest < 1.0) return best;
    for (const double reach : {0.05, 0.15, 0.3, 0.6}) {
      const Shape both = common(grown(from, reach), grown(to, reach));
      if (!both.empty()) return middle_of(both);
    }
    return best;
  }

  void add_vertical(const Cell& a, const Cell& b, const std::vector<std::string>& states) {
    const auto key = std::minmax(a.id, b.id);
    if (!verticals_.insert({key.first, key.second}).second) return;
    PlanFeature link{.form = FeatureForm::Line};
    link.connection = kind_by_name(a.name + " " + b.name + " " + a.description + b.description);
    const bool rises = a.ordinal < b.ordinal;
    link.levels = {std::min(a.ordinal, b.ordinal), std::max(a.ordinal, b.ordinal)};
    link.up = true;
    for (const std::size_t i : {rises ? 0U : 1U, rises ? 1U : 0U}) {
      const auto at = state_at_.find(states[i]);
      link.line.push_back(at != state_at_.end() ? at->second
                                                : middle_of(shape_[(i == 0 ? a : b).id]));
    }
    link.source_id = key.first + "-" + key.second;
    plan_.push_back(std::move(link));
  }

  const BuildingSource& source_;
  const ImportOptions& options_;
  XmlElement root_;
  std::vector<Cell> cells_;
  std::vector<LevelFact> facts_;
  std::vector<PlanFeature> plan_;
  std::map<std::string, Shape, std::less<>> shape_;
  std::map<std::string, const Cell*, std::less<>> cell_;
  std::map<std::string, std::string, std::less<>> cell_of_state_;
  std::map<std::string, Vec2, std::less<>> state_at_;
  std::map<std::string, const XmlElement*, std::less<>> boundary_;
  std::vector<std::pair<std::pair<std::string, std::string>, Vec2>> doors_;
  std::set<std::pair<std::string, std::string>> verticals_;
  GeoFrame frame_;
};

/// A door's leaf as a line: the two points of its polygons that are farthest from each other.
std::vector<Vec2> footprint_of(const std::vector<GmlPoint>& points) {
  std::vector<Vec2> ends;
  double longest = 0;
  for (std::size_t i = 0; i < points.size() && i < 200; ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (const double length = glm::distance(points[i].at, points[j].at); length > longest) {
        longest = length;
        ends = {points[i].at, points[j].at};
      }
  return ends;
}

}  // namespace

ImportedBuilding read_indoorgml(const BuildingSource& source, const ImportOptions& options) {
  return IndoorGmlReader(source, options).building();
}

ImportedBuilding read_citygml(const BuildingSource& source, const ImportOptions& options) {
  const XmlElement root = parse_xml(source.file, source.bytes);
  std::vector<Cell> rooms;
  MapNumbersSeen seen{.file = source.file, .crs = "the model"};
  for (const XmlElement* element : find_all(root, "Envelope"))
    if (!element->attribute("srsName").empty()) seen.crs = element->attribute("srsName");
  for (const XmlElement* room : find_all(root, "Room")) {
    Cell cell{.id = std::string(room->attribute("id")), .element = room};
    if (const XmlElement* name = room->child("name")) cell.name = name->text;
    const auto floors = find_all(*room, "FloorSurface");
    cell.floor = gml_floor(source.file, floors.empty() ? *room : *floors.front());
    for (const auto& polygon : cell.floor.polygons)
      seen.rings.insert(seen.rings.end(), polygon.begin(), polygon.end());
    if (!cell.floor.polygons.empty()) rooms.push_back(std::move(cell));
  }
  if (rooms.empty())
    throw content::ContentError(source.file, root.line, root.column, "no-rooms",
                                "this CityGML has no Room with a floor: it is a model from outside",
                                "rooms need level of detail 4");
  const double ground =
      std::ranges::min(rooms, {}, [](const Cell& c) { return c.floor.height; }).floor.height;
  for (Cell& room : rooms) room.floor.height -= ground;
  const std::vector<LevelFact> facts = set_ordinals(rooms);
  const GeoFrame frame = find_frame(seen, options);
  std::vector<PlanFeature> plan;
  for (const Cell& room : rooms) {
    PlanFeature made{.role = FeatureRole::Room, .form = FeatureForm::Area};
    for (const auto& polygon : room.floor.polygons) {
      auto& rings = made.polygons.emplace_back();
      for (const BuildingRing& ring : polygon) {
        auto& laid = rings.emplace_back();
        for (const Vec2 point : ring) laid.push_back(frame.to_floor(point));
      }
    }
    made.levels = {room.ordinal};
    made.name = room.name;
    made.source_id = room.id;
    plan.push_back(std::move(made));
    for (const XmlElement* door : find_all(*room.element, "Door")) {
      PlanFeature leaf{.role = FeatureRole::Door, .form = FeatureForm::Line};
      for (const Vec2 end : footprint_of(gml_points(source.file, *door)))
        leaf.line.push_back(frame.to_floor(end));
      leaf.levels = {room.ordinal};
      leaf.source_id = door->attribute("id");
      const bool known = std::ranges::any_of(plan, [&](const PlanFeature& other) {
        return other.role == FeatureRole::Door && !leaf.line.empty() &&
               glm::distance(other.line.front() + other.line.back(),
                             leaf.line.front() + leaf.line.back()) < 1.0;
      });
      if (!leaf.line.empty() && !known) plan.push_back(std::move(leaf));
    }
  }
  ImportedBuilding building = assemble(std::move(plan), facts);
  building.frame_said = frame.said;
  return building;
}

}  // namespace docent::import
