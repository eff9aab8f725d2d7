#include "content/compile/compile_exhibits.h"

#include "content/compile/compile_doors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <tuple>

#include "config/museum_cases.h"
#include "content/compile/check_footprints.h"
#include "content/compile/check_scale.h"
#include "content/compile/compile_ambient.h"
#include "content/compile/compile_connections.h"
#include "content/compile/compile_places.h"
#include "content/compile/compile_rooms.h"
#include "content/compile/compile_tours.h"
#include "content/compile/narrow_doors.h"
#include "content/compile/place_exhibits.h"
#include "runtime/model/geometry/door_leaf.h"
#include "runtime/model/geometry/polygon.h"
#include "runtime/path/building/building_map.h"
#include "runtime/path/route.h"

namespace docent::compile {

namespace {

double to_radians(double degrees) {
  return degrees * std::numbers::pi / 180;
}

class ExhibitCompiler {
 public:
  ExhibitCompiler(const config::MuseumConfig& config, std::span<const CompiledFloor> floors,
                  Museum& museum, Report& report)
      : config_(config), floors_(floors), museum_(museum), report_(report) {
    thing_of_.resize(config.exhibits.size());
    for (const CompiledFloor& compiled : floors) {
      maps_.push_back(compiled.floor.plan.vertex.empty() ? nullptr
                                                         : path::make_floor_map(compiled.floor));
      for (const Standing& thing : compiled.standing)
        if (thing.kind == Standing::Kind::Exhibit) thing_of_[thing.index] = &thing;
    }
  }

  void run() {
    compile_rooms(config_, maps_, museum_, report_);
    check_door_places();
    find_closed_passages();
    compile_connections(config_, maps_, floors_, museum_, report_);
    place_kiosk();
    name_kiosks();
    for (const config::ExhibitSection& section : config_.exhibits) add_exhibit(section);
    compile_places(config_, maps_, entrance_, museum_, report_);
    check_spots();
    check_other_floors();
    report_gaps();
    report_standing();
    check_scales();
    if (kiosk_floor_ >= maps_.size() || !maps_[kiosk_floor_]) return;
    museum_.ambient = compile_ambient(
        config_,
        {*maps_[kiosk_floor_], floors_[kiosk_floor_].standing, entrance_, museum_.body_radius},
        report_);
    if (entrance_) {
      check_doors();
      compile_tours(config_, maps_, museum_, report_);
    }
  }

 private:
  void error(const config::Place& place, std::string code, std::string message,
             std::string label = {}, std::string hint = {}) {
    report_.add(config::diagnostic_at(config_, place, std::move(code), std::move(message),
                                      std::move(label), std::move(hint)));
  }

  void warn_closed_off(const std::string& exhibit, const config::Place& place) {
    Diagnostic diagnostic = config::diagnostic_at(
        config_, place, "exhibit-closed-off",
        fmt::format("no visitor can reach exhibit '{}' from the kiosk while doors are closed",
                    exhibit));
    diagnostic.severity = Severity::Warning;
    report_.add(std::move(diagnostic));
  }

  bool has_closed_door(std::size_t floor) const {
    return std::ranges::any_of(floors_[floor].floor.plan.doors, &Door::closed);
  }

  /// A room for exhibits of a floor on which staff named none: the floor itself.
  std::uint32_t add_room_of_floor(std::uint32_t floor) {
    Room room;
    room.id = config_.floors[floor].name.value;
    room.floor = floor;
    // What staff call a floor among themselves is not for visitors.
    room.title = museum_.floors[floor].title.empty() ? museum_.title : museum_.floors[floor].title;
    museum_.rooms.push_back(std::move(room));
    return static_cast<std::uint32_t>(museum_.rooms.size() - 1);
  }

  void warning(const config::Place& place, std::string code, std::string message,
               std::string label = {}, std::string hint = {}) {
    Diagnostic diagnostic = config::diagnostic_at(
        config_, place, std::move(code), std::move(message), std::move(label), std::move(hint));
    diagnostic.severity = Severity::Warning;
    report_.add(std::move(diagnostic));
  }

  /// Two things cannot stand on one spot, and visitors could touch only one of them.
  void check_spots() {
    std::map<std::tuple<std::uint32_t, long, long>, std::size_t> seen;
    for (std::size_t i = 0; i < museum_.exhibits.size(); ++i) {
      const Exhibit& exhibit = museum_.exhibits[i];
      if (!config_.exhibits[i].position.given || !config_.exhibits[i].id.given) continue;
      const Vec2 p = exhibit.placement.position;
      const auto [first, is_new] =
          seen.emplace(std::tuple(exhibit.floor, std::lround(p.x * 50), std::lround(p.y * 50)), i);
      const config::ExhibitSection& other = config_.exhibits[first->second];
      if (is_new || other.id.value == exhibit.id) continue;  // a copy is reported already
      warning(
          config_.exhibits[i].position.place, "same-spot",
          fmt::format("the exhibits '{}' and '{}' stand on one spot", other.id.value, exhibit.id),
          {},
          fmt::format("the first is at {}:{}; move one of them",
                      config_.files[static_cast<std::size_t>(other.position.place.file)],
                      other.position.place.range.line));
    }
  }

  void find_closed_passages() {
    passages_.resize(floors_.size());
    for (std::size_t floor = 0; floor < floors_.size(); ++floor)
      if (maps_[floor])
        passages_[floor] = closed_passages(floors_[floor].walls, *maps_[floor],
                                           floors_[floor].standing, museum_.body_radius);
  }

  /// Does something stand in the only way to a part of a floor?
  [[nodiscard]] bool is_cut_in_two(std::size_t floor) const {
    return std::ranges::any_of(passages_[floor],
                               [](const ClosedPassage& passage) { return !passage.way_round; });
  }

  /// What takes a part of the floor, where it should not.
  void report_standing() {
    for (std::size_t floor = 0; floor < floors_.size(); ++floor) {
      if (!maps_[floor]) continue;
      for (const Standing& thing : floors_[floor].standing)
        if (thing.kind == Standing::Kind::Case &&
            !is_walkable(floors_[floor].walls, thing.footprint.centre))
          error(config_.cases[thing.index].position.place, "case-outside-floor",
                fmt::format("{} stands outside the floor of '{}'", thing.name,
                            config_.floors[floor].name.value),
                {},
                "write the middle of the case: [east, north] in metres; a case that the plan "
                "shows already needs no [[case]]");
      for (const Overlap& overlap : overlaps_of(floors_[floor].standing)) report_overlap(overlap);
      for (const ClosedPassage& passage : passages_[floor]) report_closed(floor, passage);
    }
  }

  void report_overlap(const Overlap& overlap) {
    if (glm::distance(overlap.first->footprint.centre, overlap.second->footprint.centre) < 0.03)
      return;  // told as being on one spot
    const config::Place& first = place_of_position(config_, *overlap.first);
    warning(place_of_position(config_, *overlap.second), "things-overlap",
            fmt::format("{} and {} take the same {:.2f} m of the floor", overlap.first->name,
                        overlap.second->name, overlap.depth),
            fmt::format("it takes {}, the other one {}", size_text(overlap.second->footprint),
                        size_text(overlap.first->footprint)),
            fmt::format("the first is at {}:{}; move one of them, or write how large they are: "
                        "size = {:g} is taken where none is said",
                        config_.files[static_cast<std::size_t>(first.file)], first.range.line,
                        config::ordinary_size));
  }

  void report_closed(std::size_t floor, const ClosedPassage& passage) {
    const Standing& thing = *passage.by.front();
    std::string others;
    for (const Standing* other : std::span(passage.by).subspan(1))
      others += fmt::format("{}{}", others.empty() ? ", with " : " and ", other->name);
    const std::string& language = config_.languages.front();
    const std::string name =
        passage_name(passage, floors_[floor].walls.doors, rooms_of(floor), language);
    const auto& beyond = beyond_things_[floor];
    const bool keeps_from = !passage.way_round && !beyond.empty();
    Diagnostic diagnostic = config::diagnostic_at(
        config_, place_of_position(config_, thing), "thing-in-the-way",
        fmt::format("{}{} closes {}: {}", thing.name, others, name,
                    passage.way_round ? fmt::format("the way round is {:.0f} m", *passage.way_round)
                                      : "nobody can get past"),
        fmt::format("it takes {} of the floor, and the guide needs {:.2f} m beside it",
                    size_text(thing.footprint), 2 * museum_.body_radius),
        fmt::format("move it, or write a smaller size{}",
                    keeps_from ? fmt::format("; no visitor can get to {}", some_of(beyond)) : ""));
    if (!keeps_from) diagnostic.severity = Severity::Warning;
    report_.add(std::move(diagnostic));
  }

  /// Those of a floor that staff named.
  std::vector<Room> rooms_of(std::size_t floor) const {
    std::vector<Room> rooms;
    std::ranges::copy_if(std::span(museum_.rooms).first(config_.rooms.size()),
                         std::back_inserter(rooms),
                         [&](const Room& room) { return room.floor == floor; });
    return rooms;
  }

  /// Where things stand outside of a plan, the plan itself may be what is wrong.
  void check_scales() {
    if (!report_.has_errors()) return;
    for (std::size_t floor = 0; floor < floors_.size(); ++floor) {
      if (!maps_[floor]) continue;
      const auto doubt = scale_doubt(floors_[floor].floor.plan.vertex, things_on(floor));
      if (doubt)
        warning(config_.floors[floor].plan.place, "odd-plan",
                fmt::format("the plan of floor '{}' does not fit: {}",
                            config_.floors[floor].name.value, doubt->message),
                {}, doubt->hint);
    }
  }

  std::vector<Vec2> things_on(std::size_t floor) const {
    std::vector<Vec2> things;
    const auto is_here = [&](const config::Located<std::string>& name) {
      return config::floor_index(config_, name.value) == floor;
    };
    for (const config::RoomSection& room : config_.rooms)
      if (is_here(room.floor) && room.outline.given)
        things.insert(things.end(), room.outline.value.begin(), room.outline.value.end());
    const auto add = [&](const auto& sections) {
      for (const auto& section : sections)
        if (section.position.given && is_here(section.floor))
          things.push_back(section.position.value);
    };
    add(config_.exhibits);
    add(config_.places);
    add(config_.kiosks);
    for (const config::ConnectionSection& connection : config_.connections)
      add(connection.stops.value);
    return things;
  }

  /// A slit in the plan is told in place of what lies beyond it.
  void report_gaps() {
    for (std::size_t floor = 0; floor < floors_.size(); ++floor)
      for (const PlanGap& gap : floors_[floor].gaps) {
        const auto& beyond = beyond_gaps_[floor];
        report_.add({.file = floors_[floor].drawn.files[gap.place.file],
                     .line = gap.place.line,
                     .column = gap.place.column,
                     .severity = beyond.empty() ? Severity::Warning : Severity::Error,
                     .code = "plan-gap",
                     .message = fmt::format("there is a gap of {} in the plan at {}: what lies on "
                                            "its two sides is not joined",
                                            gap_text(gap.width), point_text(gap.at)),
                     .hint = beyond.empty()
                                 ? "draw the areas so that they touch or overlap"
                                 : fmt::format("draw the areas so that they touch or overlap; no "
                                               "visitor can get to {}",
                                               some_of(beyond))});
      }
  }

  static std::string gap_text(double metres) {
    return metres < 0.0095 ? fmt::format("{:.1f} mm", metres * 1000)
                           : fmt::format("{:.0f} cm", metres * 100);
  }

  static std::string some_of(const std::vector<std::string>& ids) {
    constexpr std::size_t most = 3;
    std::string text =
        fmt::format("'{}'", fmt::join(std::span(ids).first(std::min(ids.size(), most)), "', '"));
    if (ids.size() > most) text += fmt::format(" and {} more", ids.size() - most);
    return text;
  }

  void check_door_places() {
    for (std::size_t floor = 0; floor < maps_.size(); ++floor) {
      if (!maps_[floor]) continue;
      const std::vector<const config::DoorSection*> sections = door_sections(config_, floor);
      for (const floor::DoorFault& fault : floors_[floor].door_faults)
        report_fault(*sections[fault.door], fault);
      const path::WallGrid walls(floors_[floor].walls, 0);
      for (const config::DoorSection* section : sections)
        if (!section->closed.value) check_open_door(walls, *section);
    }
  }

  void check_open_door(const path::WallGrid& walls, const config::DoorSection& section) {
    if (!walls.is_inside((section.a.value + section.b.value) * 0.5))
      return report_fault(section, {});
    const double at_a = walls.nearest_wall(section.a.value).distance,
                 at_b = walls.nearest_wall(section.b.value).distance;
    if (std::max(at_a, at_b) <= largest_door_gap) return;
    warning(at_a > at_b ? section.a.place : section.b.place, "door-in-the-open",
            fmt::format("door '{}' stands in the open floor: one could go round it",
                        section.called().value),
            fmt::format("{:.2f} m from any wall", std::max(at_a, at_b)),
            "let both ends of the door lie at a wall, where the frame is");
  }

  void report_fault(const config::DoorSection& section, const floor::DoorFault& fault) {
    if (fault.kind == floor::DoorFault::Kind::Outside)
      return error(section.a.place, "door-outside-floor",
                   fmt::format("door '{}' does not cross the floor", section.called().value),
                   "its middle is not where one can walk",
                   "write the doorway's two ends: on the floor, or in the wall between two rooms, "
                   "which it then opens");
    error(fault.end == section.a.value ? section.a.place : section.b.place, "door-leaves-gap",
          fmt::format("door '{}' is closed, but one can go round it", section.called().value),
          fmt::format("{:.2f} m from the wall", fault.gap),
          "let both ends of the door lie at a wall, where the frame is");
  }

  void place_kiosk() {
    const config::KioskSection& kiosk = config_.kiosk;
    kiosk_floor_ = config::floor_index(config_, kiosk.floor.value);
    museum_.kiosk_floor = static_cast<std::uint32_t>(kiosk_floor_);
    museum_.kiosk = {kiosk.position.value, to_radians(kiosk.facing.value)};
    if (kiosk_floor_ >= maps_.size() || !maps_[kiosk_floor_]) return;
    if (!kiosk.position.given) {
      museum_.kiosk = most_open_place(floors_[kiosk_floor_].floor);
    } else if (const auto problem = why_not_there(kiosk_floor_, museum_.kiosk.position)) {
      error(kiosk.position.place, "kiosk-outside-floor",
            "nobody can stand where the kiosk is said to be", problem->label, problem->hint);
      return;
    }
    entrance_ = museum_.kiosk.position;
  }

  /// Kiosks that have names; the first is placed already, as the one that the museum is seen from.
  void name_kiosks() {
    for (const config::KioskSection& section : config_.kiosks) {
      if (!section.id.given) continue;
      KioskPlace kiosk{
          .id = section.id.value,
          .floor = static_cast<std::uint32_t>(config::floor_index(config_, section.floor.value)),
          .placement = {section.position.value, to_radians(section.facing.value)}};
      if (museum_.kiosks.empty())
        kiosk.placement = museum_.kiosk;
      else
        check_standing(section, kiosk);
      museum_.kiosks.push_back(std::move(kiosk));
    }
  }

  void check_standing(const config::KioskSection& section, const KioskPlace& kiosk) {
    if (!section.position.given || kiosk.floor >= maps_.size() || !maps_[kiosk.floor]) return;
    if (const auto problem = why_not_there(kiosk.floor, kiosk.placement.position))
      error(section.position.place, "kiosk-outside-floor",
            fmt::format("nobody can stand where the kiosk '{}' is said to be", kiosk.id),
            problem->label, problem->hint);
  }

  std::optional<PlaceProblem> why_not_there(std::size_t floor, Vec2 point) const {
    return compile::why_not_there(*maps_[floor], floors_[floor].standing, point,
                                  museum_.body_radius);
  }

  void add_exhibit(const config::ExhibitSection& section) {
    Exhibit exhibit;
    exhibit.id = section.id.value;
    exhibit.floor = static_cast<std::uint32_t>(config::floor_index(config_, section.floor.value));
    exhibit.placement = {section.position.value, to_radians(section.facing.value)};
    exhibit.title = plain_texts(section.title.value);
    exhibit.text = plain_texts(section.text.value);
    exhibit.description = plain_texts(section.description.value);
    exhibit.more = plain_texts(section.more.value);
    for (const config::PictureSection& picture : section.pictures.value)
      museum_.pictures.push_back({.exhibit = static_cast<std::uint32_t>(museum_.exhibits.size()),
                                  .caption = plain_texts(picture.caption.value),
                                  .description = plain_texts(picture.description.value)});
    for (const config::ExhibitSoundSection& sound : section.sounds.value)
      museum_.sounds.push_back({.exhibit = static_cast<std::uint32_t>(museum_.exhibits.size()),
                                .title = plain_texts(sound.title.value),
                                .description = plain_texts(sound.description.value)});
    exhibit.artist = plain_texts(section.artist.value);
    exhibit.subject = plain_texts(section.subject.value);
    exhibit.period = plain_texts(section.period.value);
    exhibit.closed = section.closed.value;
    exhibit.hours = section.hours.value;
    if (section.weight.given) exhibit.weight = section.weight.value;
    if (section.looking_seconds.given) exhibit.looking_seconds = section.looking_seconds.value;
    if (section.position.given && section.facing.given && exhibit.floor < maps_.size() &&
        maps_[exhibit.floor])
      place(section, exhibit);
    exhibit.room = room_of(exhibit);
    museum_.exhibits.push_back(std::move(exhibit));
  }

  void place(const config::ExhibitSection& section, Exhibit& exhibit) {
    const PlacingFloor floor{.map = *maps_[exhibit.floor],
                             .name = config_.floors[exhibit.floor].name.value,
                             .entrance = exhibit.floor == kiosk_floor_ ? entrance_ : std::nullopt,
                             .body_radius = museum_.body_radius};
    const Standing& thing = *thing_of_[museum_.exhibits.size()];
    const WantedPlace wanted{
        .position = exhibit.placement.position,
        .heading = exhibit.placement.heading,
        .place = thing.place,
        .takes = takes_floor(thing) ? std::optional(thing.footprint) : std::nullopt,
        .view = section.view.given ? std::optional(section.view.value) : std::nullopt};
    PlacedExhibit placed = place_exhibit(floor, wanted);
    if (placed.problem && placed.problem->kind == PlaceProblem::Kind::ViewBlocked)
      placed.problem = why_not_there(exhibit.floor, *wanted.view);
    exhibit.place = placed.place;
    exhibit.viewing_point = placed.view;
    if (placed.problem) report_problem(section, *placed.problem);
    if (placed.problem && placed.problem->kind == PlaceProblem::Kind::Unreachable &&
        !has_closed_door(kiosk_floor_))
      unreached_.push_back(placed.view.position);
  }

  void report_problem(const config::ExhibitSection& section, const PlaceProblem& problem) {
    const std::string& id = section.id.value;
    const config::Place& view_place =
        section.view.given ? section.view.place : section.position.place;
    switch (problem.kind) {
      case PlaceProblem::Kind::Outside:
        return error(section.position.place, "exhibit-outside-floor",
                     fmt::format("exhibit '{}' stands outside the building", id), problem.label,
                     problem.hint);
      case PlaceProblem::Kind::NoView:
        return error(section.facing.place, "exhibit-unreachable",
                     fmt::format("exhibit '{}' cannot be looked at from the front", id),
                     problem.label, problem.hint);
      case PlaceProblem::Kind::ViewBlocked:
        return error(view_place, "exhibit-unreachable",
                     fmt::format("nobody can stand at the viewing point of exhibit '{}'", id),
                     problem.label, problem.hint);
      case PlaceProblem::Kind::Unreachable:
        if (has_closed_door(kiosk_floor_)) return warn_closed_off(id, view_place);
        if (!floors_[kiosk_floor_].gaps.empty()) return beyond_gaps_[kiosk_floor_].push_back(id);
        if (is_cut_in_two(kiosk_floor_)) return beyond_things_[kiosk_floor_].push_back(id);
        return error(view_place, "exhibit-unreachable",
                     fmt::format("no visitor can reach exhibit '{}' from the kiosk", id),
                     problem.label, problem.hint);
    }
  }

  /// Can visitors get from the kiosk to what stands on the other floors?
  void check_other_floors() {
    // What is wrong with connections and plans is reported already.
    if (!entrance_ || std::ranges::find(maps_, nullptr) != maps_.end() ||
        museum_.connections.size() < config_.connections.size())
      return;
    const path::BuildingMap building(museum_, maps_);
    for (std::size_t i = 0; i < museum_.exhibits.size(); ++i) {
      const Exhibit& exhibit = museum_.exhibits[i];
      if (exhibit.floor == kiosk_floor_) continue;
      const path::BuildingWay way = building.route({.way = {.from = *entrance_,
                                                            .to = exhibit.viewing_point.position,
                                                            .radius = museum_.body_radius,
                                                            .tell_clearance = false},
                                                    .from_floor = museum_.kiosk_floor,
                                                    .to_floor = exhibit.floor,
                                                    .permissions = {.closed_too = true}});
      if (way.status != path::BuildingStatus::NoRoute) continue;
      const config::Place& place = config_.exhibits[i].position.place;
      if (has_closed_door(kiosk_floor_) || has_closed_door(exhibit.floor))
        warn_closed_off(exhibit.id, place);
      else if (!floors_[exhibit.floor].gaps.empty())
        beyond_gaps_[exhibit.floor].push_back(exhibit.id);
      else if (is_cut_in_two(exhibit.floor))
        beyond_things_[exhibit.floor].push_back(exhibit.id);
      else
        report_.add(no_way_to(exhibit, place));
    }
  }

  Diagnostic no_way_to(const Exhibit& exhibit, const config::Place& place) const {
    const std::string& floor = config_.floors[exhibit.floor].name.value;
    const bool has_stop = std::ranges::any_of(museum_.connections, [&](const Connection& c) {
      return std::ranges::find(c.stops, exhibit.floor, &ConnectionStop::floor) != c.stops.end();
    });
    return config::diagnostic_at(
        config_, place, "exhibit-unreachable",
        fmt::format("no visitor can get from the kiosk to exhibit '{}' on floor '{}'", exhibit.id,
                    floor),
        {},
        has_stop ? "look whether the connections' stops, and the doors between, leave room"
                 : fmt::format("no connection leads to '{}': write a [[connection]] with a stop "
                               "there",
                               floor));
  }

  /// Names the doors that the guide does not fit through, if that keeps it from anything.
  void check_doors() {
    if (is_cut_in_two(kiosk_floor_)) return;  // by what can be moved, which is told
    const std::vector<Room> rooms = rooms_of(kiosk_floor_);
    const ComingBody body{.map = *maps_[kiosk_floor_],
                          .rooms = rooms,
                          .doors = museum_.floors[kiosk_floor_].plan.doors,
                          .language = config_.languages.front(),
                          .from = *entrance_,
                          .radius = museum_.body_radius};
    const std::vector<NarrowDoor> doors = narrow_doors(body, unreached_);
    if (doors.empty()) return;
    std::vector<std::string> named;
    double narrowest = 2 * body.radius;
    for (const NarrowDoor& door : doors) {
      named.push_back(fmt::format("{} ({:.2f} m)", door.name, door.width));
      if (door.is_on_widest_way) narrowest = std::min(narrowest, door.width);
    }
    Diagnostic diagnostic = config::diagnostic_at(
        config_, config_.avatar.radius.place, "guide-too-wide",
        fmt::format("the guide, {:.2f} m wide, does not fit through {}", 2 * body.radius,
                    fmt::join(named, ", ")),
        {},
        fmt::format("under [avatar] write radius = {:.2f} or less, or widen the {} in {}",
                    std::floor(50 * narrowest) / 100, doors.size() == 1 ? "door" : "doors",
                    config_.floors[kiosk_floor_].plan.value));
    // A room without exhibits may well be for nobody.
    if (unreached_.empty()) diagnostic.severity = Severity::Warning;
    report_.add(std::move(diagnostic));
  }

  /// The room that an exhibit hangs in is the one in front of it; where no outline holds that
  /// place, the one whose label is nearest.
  std::uint32_t room_of(const Exhibit& exhibit) {
    const Vec2 object = exhibit.placement.position;
    const Vec2 front = object + 0.3 * Vec2(std::cos(exhibit.placement.heading),
                                           std::sin(exhibit.placement.heading));
    for (const Vec2 p : {front, exhibit.viewing_point.position, object})
      for (std::uint32_t i = 0; i < museum_.rooms.size(); ++i)
        if (museum_.rooms[i].floor == exhibit.floor && contains(museum_.rooms[i].outline, p))
          return i;
    std::optional<std::uint32_t> nearest;
    const auto distance = [&](std::uint32_t i) {
      return glm::distance(museum_.rooms[i].label, object);
    };
    for (std::uint32_t i = 0; i < museum_.rooms.size(); ++i)
      if (museum_.rooms[i].floor == exhibit.floor && (!nearest || distance(i) < distance(*nearest)))
        nearest = i;
    return nearest ? *nearest : add_room_of_floor(exhibit.floor);
  }

  const config::MuseumConfig& config_;
  std::span<const CompiledFloor> floors_;
  Museum& museum_;
  Report& report_;
  std::vector<std::shared_ptr<const path::FloorMap>> maps_;  ///< Null for floors without a plan.
  std::size_t kiosk_floor_ = 0;
  std::optional<Vec2> entrance_;
  std::vector<const Standing*> thing_of_;  ///< By exhibit; null for those without a position.
  std::vector<std::vector<ClosedPassage>> passages_;  ///< By floor.
  /// Exhibits, by floor.
  std::map<std::size_t, std::vector<std::string>> beyond_gaps_, beyond_things_;
  std::vector<Vec2> unreached_;  ///< Viewing points to which there is no way on the kiosk's floor.
};

}  // namespace

Placement most_open_place(const Floor& floor) {
  const auto& clearance = floor.roadmap.clearance;
  const auto widest = std::ranges::max_element(clearance);
  if (widest == clearance.end()) return {};
  const auto node = static_cast<std::size_t>(widest - clearance.begin());
  return {floor.roadmap.position[node], std::numbers::pi / 2};
}

LocalText plain_texts(const config::LocatedTexts& texts) {
  LocalText plain;
  for (const auto& [tag, text] : texts) plain[tag] = text.value;
  return plain;
}

void compile_exhibits(const config::MuseumConfig& config, std::span<const CompiledFloor> floors,
                      Museum& museum, Report& report) {
  ExhibitCompiler(config, floors, museum, report).run();
}

}  // namespace docent::compile
