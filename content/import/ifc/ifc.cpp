#include "content/import/ifc/ifc.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "content/import/drawing/inscribed.h"
#include "content/import/drawing/label.h"
#include "content/import/drawing/lower_case.h"
#include "content/import/drawing/unit.h"
#include "content/import/ifc/outline.h"
#include "content/import/ifc/step_file.h"
#include "runtime/model/geometry/polygon.h"
#include "runtime/model/geometry/segment.h"

namespace docent::import {
namespace {

using glm::dvec3;
using Number = std::uint64_t;

/// Places of arguments that all versions of IFC share.
enum Argument : std::size_t {
  GlobalId = 0,
  Name = 2,
  ObjectPlacement = 5,
  Shape = 6,
  LongName = 7,
  StoreyElevation = 9,
  DoorWidth = 9
};

struct Storey {
  Number number = 0;
  std::string name{};
  std::optional<double> elevation{};
  ImportedLevel level{};
  double height = 0;  ///< Metres, of its floor, by elevation or by its spaces.
  bool has_stairs = false;
};

/// Names of storeys on which nobody walks, where they hold no doors.
bool is_no_floor(std::string_view name) {
  const std::string small = lower_case(name);
  if (small.find("fdn") != std::string::npos || small.find("fund") != std::string::npos ||
      small.find("found") != std::string::npos || small.find("footing") != std::string::npos)
    return true;
  static const std::set<std::string> roofs = {"roof",   "dach",       "toit",     "toiture",
                                              "tetto",  "tejado",     "tak",      "katto",
                                              "t/roof", "roof level", "flachdach"};
  return roofs.contains(small);
}

class IfcBuilding {
 public:
  IfcBuilding(const BuildingSource& source, const ImportOptions& options)
      : source_(source), options_(options), step_(parse_step(source.file, source.bytes)) {}

  BuildingOrDiagnostics read() {
    if (!find_unit()) return std::unexpected(problems_);
    index_relations();
    index_areas();
    find_storeys();
    find_spaces();
    if (storeys_.empty() || spaces_.empty())
      return std::unexpected(Diagnostics{
          {.file = source_.file,
           .code = "no-rooms",
           .message = storeys_.empty() ? "this IFC model has no storey (IfcBuildingStorey)"
                                       : "this IFC model has no spaces (IfcSpace), so no rooms",
           .hint = "export it again with rooms (spaces), which most programs ask for"}});
    find_doors();
    find_empty_openings();
    find_virtual_openings();
    find_connections();
    leave_out_storeys();
    number_levels();
    bring_near();
    return std::move(building_);
  }

 private:
  // Units.

  double metres_of_unit(const StepRecord& unit) const {
    static const std::map<std::string, double> prefixes = {
        {"KILO", 1e3}, {"DECI", 0.1}, {"CENTI", 0.01}, {"MILLI", 0.001}, {"MICRO", 1e-6}};
    if (unit.type == "IFCSIUNIT") {
      const auto prefix = prefixes.find(unit[2].text);
      return prefix == prefixes.end() ? 1 : prefix->second;
    }
    if (unit.type == "IFCCONVERSIONBASEDUNIT") {
      const StepRecord& measure = step_.at(unit[3]);
      return measure[0].number * metres_of_unit(step_.at(measure[1]));
    }
    return 0;
  }

  bool find_unit() {
    if (!options_.unit.empty()) {
      const auto metres = metres_of(options_.unit);
      if (!metres) {
        problems_.push_back({.file = source_.file,
                             .code = "unknown-unit",
                             .message = fmt::format("'{}' is no unit of length", options_.unit),
                             .hint = "say --unit mm, cm, m, in or ft"});
        return false;
      }
      metres_ = *metres;
      building_.unit_said = "by --unit: " + options_.unit;
      return true;
    }
    for (const Number assignment : step_.all("IFCUNITASSIGNMENT"))
      for (const StepValue& reference : step_.at(assignment)[0].items) {
        const StepRecord& unit = step_.at(reference);
        if (unit[1].text != "LENGTHUNIT") continue;
        if (const double metres = metres_of_unit(unit); metres > 0 && std::isfinite(metres)) {
          metres_ = metres;
          building_.unit_said = fmt::format("stated: a unit is {:g} m", metres);
          return true;
        }
      }
    building_.unit_said = "not stated: metres, as IFC has it";
    doubt("unit", "", {}, "the model states no unit of length; read as metres",
          "say --unit to decide");
    return true;
  }

  void doubt(std::string code, const std::string& level, Vec2 at, std::string message,
             std::string hint) {
    building_.doubts.push_back({std::move(code), level, at, std::move(message), std::move(hint)});
  }

  // Relations.

  void index_relations() {
    for (const char* type : {"IFCRELAGGREGATES", "IFCRELNESTS"})
      for (const Number relation : step_.all(type))
        for (const StepValue& part : step_.at(relation)[5].items) {
          whole_[part.reference] = step_.at(relation)[4].reference;
          parts_[step_.at(relation)[4].reference].push_back(part.reference);
        }
    for (const Number relation : step_.all("IFCRELCONTAINEDINSPATIALSTRUCTURE"))
      for (const StepValue& part : step_.at(relation)[4].items)
        whole_.try_emplace(part.reference, step_.at(relation)[5].reference);
    for (const Number relation : step_.all("IFCRELFILLSELEMENT"))
      opening_[step_.at(relation)[5].reference] = step_.at(relation)[4].reference;
  }

  /// The storey in which something stands, however deep.
  std::optional<std::size_t> storey_of(Number number) const {
    for (int depth = 0; depth < 32; ++depth) {
      if (const auto storey = storey_index_.find(number); storey != storey_index_.end())
        return storey->second;
      const auto whole = whole_.find(number);
      if (whole == whole_.end()) return std::nullopt;
      number = whole->second;
    }
    return std::nullopt;
  }

  glm::dmat4 world_of(const StepRecord& product) const {
    return placement_of(step_, product[ObjectPlacement]);
  }

  std::vector<dvec3> points_in_metres(Number number) const {
    const StepRecord& product = step_.at(number);
    std::vector<dvec3> points = points_of(step_, product[Shape], world_of(product));
    for (dvec3& p : points) p *= metres_;
    std::erase_if(points, [](const dvec3& p) { return !std::isfinite(p.x + p.y + p.z); });
    return points;
  }

  /// Of a product and of what it is made of.
  std::vector<dvec3> all_points(Number number, int depth = 0) const {
    std::vector<dvec3> points = points_in_metres(number);
    const auto parts = parts_.find(number);
    if (parts == parts_.end() || depth > 4) return points;
    for (const Number part : parts->second) {
      const std::vector<dvec3> more = all_points(part, depth + 1);
      points.insert(points.end(), more.begin(), more.end());
    }
    return points;
  }

  /// The areas that the model itself says of its spaces: net ones before gross ones.
  void index_areas() {
    static constexpr std::array<std::string_view, 6> names = {
        "NetFloorArea", "GSA BIM Area", "GrossFloorArea", "NetArea", "GrossArea", "Area"};
    std::map<Number, std::size_t> rank;
    const double square = area_unit();
    for (const Number relation : step_.all("IFCRELDEFINESBYPROPERTIES")) {
      const StepRecord& record = step_.at(relation);
      const StepRecord& definition = step_.at(record[5]);
      const bool quantities = definition.type == "IFCELEMENTQUANTITY";
      if (!quantities && definition.type != "IFCPROPERTYSET") continue;
      for (const StepValue& reference : definition[quantities ? 5 : 4].items) {
        const StepRecord& part = step_.at(reference);
        if (part.type != (quantities ? "IFCQUANTITYAREA" : "IFCPROPERTYSINGLEVALUE")) continue;
        const auto name = std::ranges::find(names, part[0].text);
        const double area = part[quantities ? 3 : 2].number * square;
        if (name == names.end() || !(area > 0) || !std::isfinite(area)) continue;
        const auto order = static_cast<std::size_t>(name - names.begin());
        for (const StepValue& object : record[4].items) {
          const auto [known, fresh] = rank.try_emplace(object.reference, order);
          if (!fresh && known->second <= order) continue;
          known->second = order;
          areas_[object.reference] = area;
        }
      }
    }
  }

  /// Square metres of a unit of area.
  double area_unit() const {
    for (const Number assignment : step_.all("IFCUNITASSIGNMENT"))
      for (const StepValue& reference : step_.at(assignment)[0].items) {
        const StepRecord& unit = step_.at(reference);
        if (unit[1].text != "AREAUNIT") continue;
        const double metres = metres_of_unit(unit);
        return unit.type == "IFCSIUNIT" ? metres * metres : metres;
      }
    return metres_ * metres_;
  }

  // Storeys and spaces.

  void find_storeys() {
    for (const Number number : step_.all("IFCBUILDINGSTOREY")) {
      const StepRecord& record = step_.at(number);
      Storey storey{.number = number};
      storey.name = !record[Name].text.empty() ? record[Name].text : record[LongName].text;
      if (record[StoreyElevation].kind == StepValue::Kind::Number)
        storey.elevation = record[StoreyElevation].number * metres_;
      storey.height = storey.elevation ? *storey.elevation : world_of(record)[3].z * metres_;
      while (storey.name.empty() || std::ranges::count(storeys_, storey.name, &Storey::name) > 0)
        storey.name +=
            fmt::format("{}storey {}", storey.name.empty() ? "" : " ", storeys_.size() + 1);
      storey_index_[number] = storeys_.size();
      storeys_.push_back(std::move(storey));
    }
  }

  /// What differs by half is no measure of this outline.
  void set_area(Number space, ImportedRoom& room) const {
    const auto stated = areas_.find(space);
    if (stated == areas_.end()) return;
    double outline = std::abs(signed_area(room.rings.front()));
    for (std::size_t i = 1; i < room.rings.size(); ++i)
      outline -= std::abs(signed_area(room.rings[i]));
    if (stated->second > 0.5 * outline && stated->second < 1.5 * outline)
      room.stated_area = stated->second;
  }

  void find_spaces() {
    std::size_t without_outline = 0, without_storey = 0;
    for (const Number number : step_.all("IFCSPACE")) {
      const StepRecord& record = step_.at(number);
      const auto storey = storey_of(number);
      if (!storey) {
        ++without_storey;
        continue;
      }
      ImportedRoom room;
      room.rings = outline_of(step_, record[Shape], world_of(record));
      for (BuildingRing& ring : room.rings)
        for (Vec2& corner : ring) corner *= metres_;
      if (room.rings.empty() || !(std::abs(signed_area(room.rings.front())) > 0.05)) {
        ++without_outline;
        continue;
      }
      room.name = record[Name].text;
      if (!record[LongName].text.empty() && record[LongName].text != room.name)
        room.name += (room.name.empty() ? "" : " ") + record[LongName].text;
      room.kind = kind_of_room(room.name);
      set_area(number, room);
      room.source_id = record[GlobalId].text;
      room.place = {source_.file, record.line, 0};
      Storey& home = storeys_[*storey];
      spaces_[number] = {*storey, home.level.rooms.size()};
      if (std::string kind = place_of_room(room.name); !kind.empty())
        home.level.places.push_back(
            {std::move(kind), room.name, {}, inscribed_circle(room.rings).centre});
      home.level.rooms.push_back(std::move(room));
    }
    if (without_outline > 0)
      doubt(
          "space-without-outline", "", {},
          fmt::format("{} spaces have no outline on the ground and were left out", without_outline),
          "export the model with the bodies of its spaces");
    if (without_storey > 0)
      doubt("space-without-storey", "", {},
            fmt::format("{} spaces belong to no storey and were left out", without_storey),
            "put them into a storey in the model");
  }

  // Doors.

  /// From jamb to jamb: how far the points reach along the door's own x, in the middle of its
  /// depth.
  static std::optional<std::pair<Vec2, Vec2>> jambs(const std::vector<dvec3>& points, Vec2 along) {
    if (points.empty()) return std::nullopt;
    Vec2 low(std::numeric_limits<double>::max()), high(std::numeric_limits<double>::lowest());
    for (const dvec3& p : points) {
      const Vec2 local{dot(Vec2(p), along), dot(Vec2(p), left_of(along))};
      low = glm::min(low, local);
      high = glm::max(high, local);
    }
    const double width = high.x - low.x, depth = high.y - low.y;
    if (!(width > 0.3) || width > 12 || depth > 2.5) return std::nullopt;
    const double middle = (low.y + high.y) / 2;
    const auto at = [&](double x) { return x * along + middle * left_of(along); };
    return std::pair{at(low.x), at(high.x)};
  }

  static Vec2 unit_along(const glm::dmat4& world) {
    const Vec2 along(world[0]);
    const double length = glm::length(along);
    return length > 1e-9 ? along / length : Vec2{1, 0};
  }

  void find_doors() {
    std::size_t unplaced = 0;
    for (const char* type : {"IFCDOOR", "IFCDOORSTANDARDCASE"})
      for (const Number number : step_.all(type)) unplaced += !add_door(number);
    if (unplaced > 0)
      doubt(
          "door-without-place", "", {},
          fmt::format("{} doors have neither an opening nor a storey and were left out", unplaced),
          "write a [[door]] where one is missing");
  }

  bool add_door(Number number) {
    const StepRecord& record = step_.at(number);
    const auto storey = storey_of(number);
    if (!storey) return false;
    const glm::dmat4 world = world_of(record);
    const Vec2 along = unit_along(world);
    std::optional<std::pair<Vec2, Vec2>> found;
    if (const auto opening = opening_.find(number); opening != opening_.end())
      found = jambs(points_in_metres(opening->second), along);
    if (!found) found = jambs(points_in_metres(number), along);
    const double width = record[DoorWidth].number * metres_;
    if (!found && width > 0.3) {
      const Vec2 origin = Vec2(world[3]) * metres_;
      found = std::pair{origin, origin + width * along};
    }
    if (!found) return false;
    ImportedLevel& level = storeys_[*storey].level;
    ImportedDoor door;
    door.a = found->first;
    door.b = found->second;
    door.width = width > 0.3 && width < 12 ? width : glm::length(door.b - door.a);
    door.id = fmt::format("door-{}", ++doors_);
    door.source_id = record[GlobalId].text;
    level.doors.push_back(std::move(door));
    return true;
  }

  /// Passages without a door: openings in walls that nothing fills, as high as people.
  void find_empty_openings() {
    std::set<Number> filled;
    for (const auto& [door, opening] : opening_) filled.insert(opening);
    for (const Number relation : step_.all("IFCRELVOIDSELEMENT")) {
      const StepValue &host = step_.at(relation)[4], &opening = step_.at(relation)[5];
      if (filled.contains(opening.reference) || !step_.at(host).type.starts_with("IFCWALL"))
        continue;
      const auto storey = storey_of(host.reference);
      if (!storey) continue;
      const std::vector<dvec3> points = points_in_metres(opening.reference);
      const auto found = jambs(points, unit_along(world_of(step_.at(host))));
      if (!found || glm::distance(found->first, found->second) < 0.55) continue;
      const auto [low, high] = std::ranges::minmax(points, {}, [](const dvec3& p) { return p.z; });
      if (high.z - low.z < 1.8 || std::abs(low.z - storeys_[*storey].height) > 0.4) continue;
      ImportedDoor door;
      door.a = found->first;
      door.b = found->second;
      door.width = glm::distance(door.a, door.b);
      door.id = fmt::format("opening-{}", opening.reference);
      door.source_id = step_.at(opening)[GlobalId].text;
      storeys_[*storey].level.doors.push_back(std::move(door));
    }
  }

  /// Where two spaces of a storey end at one another and at nothing (IfcVirtualElement).
  void find_virtual_openings() {
    struct Side {
      Number space = 0;
      std::vector<dvec3> points;
    };
    std::map<Number, std::vector<Side>> sides;
    for (const char* type :
         {"IFCRELSPACEBOUNDARY", "IFCRELSPACEBOUNDARY1STLEVEL", "IFCRELSPACEBOUNDARY2NDLEVEL"})
      for (const Number relation : step_.all(type)) {
        const StepRecord& record = step_.at(relation);
        if (step_.at(record[5]).type != "IFCVIRTUALELEMENT") continue;
        const StepRecord& space = step_.at(record[4]);
        Side side{record[4].reference,
                  points_of_item(step_, step_.at(record[6])[0], world_of(space))};
        for (dvec3& p : side.points) p *= metres_;
        sides[record[5].reference].push_back(std::move(side));
      }
    for (const auto& [element, both] : sides) {
      if (both.size() != 2 || !spaces_.contains(both[0].space) || !spaces_.contains(both[1].space))
        continue;
      const auto [storey, room] = spaces_.at(both[0].space);
      if (spaces_.at(both[1].space).first != storey || both[0].space == both[1].space) continue;
      add_opening(storey, room, spaces_.at(both[1].space).second, both[0].points,
                  step_.at(element)[GlobalId].text);
    }
  }

  void add_opening(std::size_t storey, std::size_t room, std::size_t other,
                   const std::vector<dvec3>& points, const std::string& id) {
    Vec2 a{}, b{};
    double longest = 0;
    for (const dvec3& p : points)  // The two points that are farthest apart on the ground.
      for (const dvec3& q : points)
        if (const double length = glm::length(Vec2(p) - Vec2(q)); length > longest) {
          longest = length;
          a = Vec2(p);
          b = Vec2(q);
        }
    ImportedLevel& level = storeys_[storey].level;
    if (longest < 0.4) {
      doubt("opening-without-place", storeys_[storey].name, {},
            fmt::format("'{}' and '{}' are open to one another, but the model does not say where",
                        level.rooms[room].name, level.rooms[other].name),
            "write a [[door]] there");
      return;
    }
    level.doors.push_back({.id = fmt::format("door-{}", ++doors_),
                           .a = a,
                           .b = b,
                           .width = longest,
                           .source_id = id});
  }

  // Connections.

  void find_connections() {
    std::set<Number> done;
    const auto each = [&](const char* type, const char* kind) {
      for (const Number number : step_.all(type)) {
        const auto whole = whole_.find(number);  // A flight of a stair that is done already.
        if (whole != whole_.end() && done.contains(whole->second)) continue;
        done.insert(number);
        add_climb(number, kind);
      }
    };
    each("IFCSTAIR", "stairs");
    each("IFCSTAIRFLIGHT", "stairs");
    each("IFCRAMP", "ramp");
    each("IFCRAMPFLIGHT", "ramp");
    find_lifts();
  }

  /// Storeys from low to high that hold rooms.
  std::vector<std::size_t> storeys_upwards() const {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < storeys_.size(); ++i)
      if (!storeys_[i].level.rooms.empty()) order.push_back(i);
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return storeys_[i].height; });
    return order;
  }

  /// The storey whose floor is nearest to a height.
  std::optional<std::size_t> storey_at(double height) const {
    std::optional<std::size_t> best;
    for (const std::size_t i : storeys_upwards())
      if (!best ||
          std::abs(storeys_[i].height - height) < std::abs(storeys_[*best].height - height))
        best = i;
    return best;
  }

  static Vec2 middle(const std::vector<dvec3>& points, double from, double to) {
    Vec2 low(std::numeric_limits<double>::max()), high(std::numeric_limits<double>::lowest());
    for (const dvec3& p : points)
      if (p.z >= from && p.z <= to) {
        low = glm::min(low, Vec2(p));
        high = glm::max(high, Vec2(p));
      }
    return 0.5 * (low + high);
  }

  /// The nearest place in a room of this storey, 0.4 m inside where there is room for it.
  std::optional<Vec2> in_a_room(std::size_t storey, Vec2 p, double reach) const {
    std::optional<Vec2> best;
    double nearest = reach;
    for (const ImportedRoom& room : storeys_[storey].level.rooms) {
      if (inside(room.rings, p)) return p;
      for (const BuildingRing& ring : room.rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
          const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
          const NearestOnSegment on = nearest_on_segment(p, a, b);
          const double apart = std::sqrt(on.distance_squared);
          if (apart >= nearest || apart < 1e-9) continue;
          const Vec2 edge = a + on.t * (b - a);
          const Vec2 further = edge + 0.4 * (edge - p) / apart;
          nearest = apart;
          best = inside(room.rings, further) ? further : edge;
        }
    }
    return best;
  }

  void add_climb(Number number, const char* kind) {
    const std::vector<dvec3> points = all_points(number);
    const auto own = storey_of(number);
    const std::vector<std::size_t> order = storeys_upwards();
    if (points.empty() && !own) return;
    const std::string name = step_.at(number)[Name].text;
    double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();
    for (const dvec3& p : points) {
      low = std::min(low, p.z);
      high = std::max(high, p.z);
    }
    std::optional<std::size_t> below = points.empty() ? own : storey_at(low), above;
    if (own && !storeys_[*own].level.rooms.empty()) below = own;
    if (!below) return;
    const auto at = std::ranges::find(order, *below);
    if (at != order.end() && at + 1 != order.end()) above = *(at + 1);
    if (above && !points.empty() && high < storeys_[*above].height - 1.2) above.reset();
    if (!above) {
      doubt("stairs-to-nowhere", storeys_[*below].name,
            points.empty() ? Vec2{} : middle(points, low, high),
            fmt::format("the {} '{}' reach no storey with rooms above '{}'", kind, name,
                        storeys_[*below].name),
            "write a [[connection]] if they lead somewhere");
      return;
    }
    storeys_[*below].has_stairs = storeys_[*above].has_stairs = true;
    const Vec2 foot = middle(points, low, low + 0.25 * (high - low));
    const Vec2 head = middle(points, high - 0.15 * (high - low), high);
    add_connection(kind, name, step_.at(number)[GlobalId].text, {{*below, foot}, {*above, head}});
  }

  struct StopFound {
    std::size_t storey = 0;
    Vec2 at{};
  };

  void add_connection(const char* kind, const std::string& name, const std::string& id,
                      const std::vector<StopFound>& stops) {
    ImportedConnection connection{.kind = kind, .name = name, .source_id = id};
    Vec2 towards = stops.back().at - stops.front().at;
    if (glm::length(towards) < 0.3) towards = {1, 0};
    for (const StopFound& stop : stops) {
      const auto place = in_a_room(stop.storey, stop.at, 6);
      if (!place) {
        doubt("stop-outside-rooms", storeys_[stop.storey].name, stop.at,
              fmt::format("the {} '{}' stop in no room of '{}'", kind, name,
                          storeys_[stop.storey].name),
              "put the stop of the [[connection]] into a room");
        continue;
      }
      const Vec2 in = stop.storey == stops.front().storey ? towards : -towards;
      connection.stops.push_back({storeys_[stop.storey].name, *place, std::atan2(in.y, in.x)});
    }
    if (connection.stops.size() >= 2) building_.connections.push_back(std::move(connection));
  }

  /// Lifts that stand over one another are one; each serves the storeys that its shaft passes.
  void find_lifts() {
    struct Shaft {
      Vec2 at{};
      double low = 0, high = 0;
      std::string name{}, id{};
      std::set<std::size_t> storeys{};
    };
    std::vector<Shaft> shafts;
    for (const Number number : step_.all("IFCTRANSPORTELEMENT")) {
      const StepRecord& record = step_.at(number);
      const std::vector<dvec3> points = all_points(number);
      const bool escalator = record[8].text == "ESCALATOR" || record[8].text == "MOVINGWALKWAY";
      if (escalator) {
        add_climb(number, "escalator");
        continue;
      }
      Shaft shaft{.name = record[Name].text, .id = record[GlobalId].text};
      shaft.low = std::numeric_limits<double>::max();
      shaft.high = std::numeric_limits<double>::lowest();
      for (const dvec3& p : points) {
        shaft.low = std::min(shaft.low, p.z);
        shaft.high = std::max(shaft.high, p.z);
      }
      shaft.at = points.empty() ? Vec2(world_of(record)[3]) * metres_
                                : middle(points, shaft.low, shaft.high);
      if (const auto own = storey_of(number)) shaft.storeys.insert(*own);
      for (const std::size_t i : storeys_upwards())
        if (storeys_[i].height > shaft.low - 1 && storeys_[i].height < shaft.high - 1)
          shaft.storeys.insert(i);
      const auto same = std::ranges::find_if(
          shafts, [&](const Shaft& other) { return glm::length(other.at - shaft.at) < 1; });
      if (same == shafts.end())
        shafts.push_back(std::move(shaft));
      else
        same->storeys.insert(shaft.storeys.begin(), shaft.storeys.end());
    }
    for (const Shaft& shaft : shafts) {
      std::vector<StopFound> stops;
      for (const std::size_t i : storeys_upwards())
        if (shaft.storeys.contains(i)) {
          stops.push_back({i, shaft.at});
          storeys_[i].has_stairs = true;
        }
      if (stops.size() >= 2) add_connection("lift", shaft.name, shaft.id, stops);
    }
  }

  // Levels.

  void leave_out_storeys() {
    std::erase_if(storeys_, [&](Storey& storey) {
      const bool empty = storey.level.rooms.empty();
      const bool roof = is_no_floor(storey.name) && storey.level.doors.empty() && !empty;
      if (!empty && !roof) return false;
      doubt("storey-left-out", "", {},
            empty ? fmt::format("the storey '{}' has no spaces and was left out", storey.name)
                  : fmt::format("the storey '{}' is no floor to walk on and was left out",
                                storey.name),
            "");
      std::erase_if(building_.connections, [&](ImportedConnection& connection) {
        std::erase_if(connection.stops,
                      [&](const ImportedStop& stop) { return stop.level == storey.name; });
        return connection.stops.size() < 2;
      });
      return true;
    });
  }

  /// 0 is the storey nearest to the height 0, where IFC has the ground.
  void number_levels() {
    std::ranges::stable_sort(storeys_, {}, &Storey::height);
    std::size_t ground = 0;
    for (std::size_t i = 0; i < storeys_.size(); ++i)
      if (std::abs(storeys_[i].height) < std::abs(storeys_[ground].height)) ground = i;
    for (std::size_t i = 0; i < storeys_.size(); ++i) {
      Storey& storey = storeys_[i];
      storey.level.name = storey.name;
      storey.level.ordinal = static_cast<double>(i) - static_cast<double>(ground);
      storey.level.elevation = storey.height;
      building_.levels.push_back(std::move(storey.level));
    }
  }

  /// Models that stand on the map's own coordinates, far from (0, 0), are moved by whole
  /// kilometres.
  void bring_near() {
    building_.frame_said = "the model's own";
    Vec2 low(std::numeric_limits<double>::max());
    for (const ImportedLevel& level : building_.levels)
      for (const ImportedRoom& room : level.rooms)
        for (const Vec2 corner : room.rings.front()) low = glm::min(low, corner);
    if (building_.levels.empty() || std::max(std::abs(low.x), std::abs(low.y)) < 5000) return;
    const Vec2 by = glm::floor(low / 1000.0) * 1000.0;
    building_.frame_said = fmt::format("the model's own, moved by ({:.0f}, {:.0f})", -by.x, -by.y);
    for (ImportedLevel& level : building_.levels) {
      for (ImportedRoom& room : level.rooms)
        for (BuildingRing& ring : room.rings)
          for (Vec2& corner : ring) corner -= by;
      for (ImportedDoor& door : level.doors) {
        door.a -= by;
        door.b -= by;
      }
      for (ImportedPlace& place : level.places) place.position -= by;
    }
    for (ImportedConnection& connection : building_.connections)
      for (ImportedStop& stop : connection.stops) stop.position -= by;
    for (Doubt& each : building_.doubts) each.at -= by;
  }

  const BuildingSource& source_;
  const ImportOptions& options_;
  StepFile step_;
  double metres_ = 1;
  std::map<Number, Number> whole_, opening_;
  std::map<Number, std::vector<Number>> parts_;
  std::map<Number, double> areas_;  ///< Square metres, as the model says of spaces.
  std::vector<Storey> storeys_;
  std::map<Number, std::size_t> storey_index_;
  std::map<Number, std::pair<std::size_t, std::size_t>> spaces_;  ///< Storey and room.
  std::size_t doors_ = 0;
  Diagnostics problems_;
  ImportedBuilding building_;
};

}  // namespace

bool looks_like_ifc(std::string_view bytes) {
  return bytes.substr(0, 256).find("ISO-10303-21") != std::string_view::npos;
}

BuildingOrDiagnostics read_ifc(const BuildingSource& source, const ImportOptions& options) {
  return IfcBuilding(source, options).read();
}

}  // namespace docent::import
