#include "content/import/building_xml/building_xml.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

#include "content/content_error.h"
#include "content/import/building/geo_frame.h"
#include "content/import/building/plan_feature.h"
#include "content/import/xml/xml_tree.h"
#include "runtime/model/geometry/segment.h"
#include "runtime/model/place_kind.h"

namespace docent::import {
namespace {

class BuildingXmlReader {
 public:
  BuildingXmlReader(const BuildingSource& source, const ImportOptions& options)
      : source_(source), options_(options), root_(parse_xml(source.file, source.bytes)) {}

  ImportedBuilding building() && {
    read_scale();
    double ordinal = 0;
    for (const XmlElement* floor : find_all(root_, "floor")) {
      for (const XmlElement* space : find_all(*floor, "space")) read_space(*space, ordinal);
      ++ordinal;
    }
    if (plan_.empty()) fail(root_, "this building has no space with a polygon, so it has no rooms");
    ImportedBuilding building = assemble(std::move(plan_), {});
    // Its floors are counted, not named: one alone may be any.
    if (building.levels.size() == 1) building.levels.front().unsaid = true;
    building.unit_said = fmt::format("one pixel is {:.4g} m", scale_);
    return building;
  }

 private:
  [[noreturn]] void fail(const XmlElement& at, const std::string& message) const {
    throw content::ContentError(source_.file, at.line, at.column, "invalid-building-xml", message,
                                "export the plan again");
  }

  double number_in(const XmlElement& element, std::string_view text) const {
    double value = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (fault != std::errc{} || end != text.data() + text.size() || !std::isfinite(value) ||
        std::abs(value) > 1e7)
      fail(element, fmt::format("<{}> holds something that is no number", element.name));
    return value;
  }

  static const XmlElement* inside(const XmlElement& element,
                                  std::initializer_list<std::string_view> path) {
    const XmlElement* at = &element;
    for (const std::string_view name : path)
      if (at != nullptr) at = at->child(name);
    return at;
  }

  /// How long a pixel is: so many of them are so many centimetres.
  void read_scale() {
    const XmlElement* drawn = inside(root_, {"scale", "represented_distance", "value"});
    const XmlElement* real = inside(root_, {"scale", "real_distance", "value"});
    const XmlElement* unit = inside(root_, {"scale", "real_distance", "um"});
    if (const double said = unit_in_metres(options_.unit); said > 0) {
      scale_ = said;
      return;
    }
    const double metres = unit == nullptr ? 0.01 : unit_in_metres(unit->text);
    if (drawn == nullptr || real == nullptr || !(number_in(*drawn, drawn->text) > 0) ||
        !(number_in(*real, real->text) > 0) || metres == 0)
      fail(root_, "the file does not say how long its pixels are (<scale>)");
    scale_ = number_in(*real, real->text) * metres / number_in(*drawn, drawn->text);
  }

  Vec2 point_of(const XmlElement& point) const {
    return {scale_ * number_in(point, point.attribute("x")),
            -scale_ * number_in(point, point.attribute("y"))};
  }
  std::vector<Vec2> points_of(const XmlElement& element) const {
    std::vector<Vec2> points;
    for (const XmlElement& child : element.children)
      if (child.name == "point") points.push_back(point_of(child));
    return points;
  }

  void read_space(const XmlElement& space, double ordinal) {
    const XmlElement* polygon = space.child("bounding_polygon");
    if (polygon == nullptr) return;
    PlanFeature room{.role = FeatureRole::Room, .form = FeatureForm::Area};
    BuildingRing ring = points_of(*polygon);
    if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    if (ring.size() < 3) return;
    room.polygons = {{std::move(ring)}};
    room.levels = {ordinal};
    room.source_id = space.attribute("id");
    room.placed = {source_.file, space.line, space.column};
    if (const XmlElement* label = inside(space, {"labels", "label"})) set_label(room, label->text);
    plan_.push_back(std::move(room));
    read_portals(space, ordinal);
  }

  /// `CLASSROOM` is written for people: Classroom.
  static void set_label(PlanFeature& room, const std::string& label) {
    room.name = label;
    for (std::size_t i = 1; i < room.name.size(); ++i)
      if (room.name[i] >= 'A' && room.name[i] <= 'Z')
        room.name[i] = static_cast<char>(room.name[i] - 'A' + 'a');
    constexpr std::array<std::pair<std::string_view, std::string_view>, 7> places{
        {{"BATHROOM", "toilets"},
         {"WASHROOM", "toilets"},
         {"ENTRANCE", "entrance"},
         {"CANTEEN", "restaurant"},
         {"LIBRARY", "library"},
         {"RECEPTION", "information"},
         {"CONVENIENCE STORE", "shop"}}};
    for (const auto& [word, kind] : places)
      if (label == word) room.places = {std::string(kind)};
    if (label == "ELEVATOR") room.connection = "lift";
    if (label == "STAIRS") room.connection = "stairs";
  }

  /// The two spaces that each segment of a portal joins, as the space's <portals> say.
  using Joined = std::pair<std::string, std::string>;
  static std::map<std::string, Joined> joined_by(const XmlElement& space) {
    std::map<std::string, Joined> joined;
    const XmlElement* portals = space.child("portals");
    if (portals == nullptr) return joined;
    for (const XmlElement& portal : portals->children) {
      const XmlElement* segment = portal.child("linesegment");
      const XmlElement* target = portal.child("target");
      if (segment == nullptr || target == nullptr) continue;
      std::vector<std::string> ids;
      for (const XmlElement& id : target->children) ids.push_back(id.text);
      if (ids.size() == 2) joined[segment->text] = std::minmax(ids[0], ids[1]);
    }
    return joined;
  }

  void read_portals(const XmlElement& space, double ordinal) {
    const XmlElement* drawn = space.child("space_representation");
    if (drawn == nullptr) return;
    const std::map<std::string, Joined> joined = joined_by(space);
    const std::string own(space.attribute("id"));
    for (const XmlElement& segment : drawn->children) {
      const XmlElement* kind = segment.child("class");
      if (kind == nullptr || kind->text != "PORTAL") continue;
      PlanFeature door{.role = FeatureRole::Door, .form = FeatureForm::Line};
      door.line = points_of(segment);
      if (door.line.empty()) continue;
      const XmlElement* features = segment.child("features");
      if (features != nullptr && features->text == "DOUBLE") door.width = 1.6;
      door.levels = {ordinal};
      door.source_id = segment.attribute("id");
      const auto named = joined.find(door.source_id);
      if (!is_known(door, own, named == joined.end() ? Joined{} : named->second))
        plan_.push_back(std::move(door));
    }
  }

  static Vec2 middle_of(const PlanFeature& door) {
    return (door.line.front() + door.line.back()) / 2.0;
  }

  /// Both spaces that a portal joins draw it, each on its own side of the wall: the nearest that
  /// the other one has drawn for the same two is the same door, and is so once.
  bool is_known(const PlanFeature& door, const std::string& own, const Joined& joins) {
    const Vec2 at = middle_of(door);
    if (joins.first.empty())
      return std::ranges::any_of(plan_, [&](const PlanFeature& other) {
        return other.role == FeatureRole::Door && other.levels == door.levels &&
               glm::distance(middle_of(other), at) < same_door;
      });
    std::vector<Drawn>& drawn = drawn_[joins];
    Drawn* nearest = nullptr;
    for (Drawn& other : drawn)
      if (other.by != own && !other.met &&
          (nearest == nullptr || glm::distance(other.at, at) < glm::distance(nearest->at, at)))
        nearest = &other;
    if (nearest != nullptr && glm::distance(nearest->at, at) < same_opening) {
      nearest->met = true;
      put_between(plan_[nearest->feature], nearest->at, at);
      return true;
    }
    drawn.push_back({own, at, plan_.size(), false});
    return false;
  }

  /// A point that both sides of a thick wall have: the door stands in the middle of the wall.
  void put_between(PlanFeature& door, Vec2 one, Vec2 two) const {
    const double apart = glm::distance(one, two);
    if (apart < 0.1 || glm::distance(door.line.front(), door.line.back()) > 0.2) return;
    Vec2 along{};
    double nearest = 0.3;
    for (const PlanFeature& room : plan_) {
      if (room.form != FeatureForm::Area) continue;
      const BuildingRing& ring = room.polygons.front().front();
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
        const double away = distance_to_segment(one, a, b);
        if (away >= nearest || a == b) continue;
        nearest = away;
        along = glm::normalize(b - a);
      }
    }
    if (along == Vec2{} || std::abs(dot(along, two - one)) > 0.7 * apart) return;
    const double half = (door.width > 0 ? door.width : 1.0) / 2;
    const Vec2 middle = (one + two) / 2.0;
    door.line = {middle - half * along, middle + half * along};
  }

  struct Drawn {
    std::string by;  ///< The space that drew it.
    Vec2 at{};
    std::size_t feature = 0;  ///< In `plan_`.
    bool met = false;
  };

  static constexpr double same_door = 0.4;     ///< Metres.
  static constexpr double same_opening = 3.0;  ///< Metres: what two say of one portal.

  const BuildingSource& source_;
  const ImportOptions& options_;
  XmlElement root_;
  double scale_ = 0;
  std::vector<PlanFeature> plan_;
  std::map<Joined, std::vector<Drawn>> drawn_;  ///< By the spaces that they join.
};

}  // namespace

ImportedBuilding read_building_xml(const BuildingSource& source, const ImportOptions& options) {
  return BuildingXmlReader(source, options).building();
}

}  // namespace docent::import
