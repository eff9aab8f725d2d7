#include "content/compile/compile_exhibits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <numbers>
#include <optional>

#include "content/compile/compile_ambient.h"
#include "content/compile/narrow_doors.h"
#include "content/compile/place_exhibits.h"
#include "runtime/model/geometry/polygon.h"
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
    for (const CompiledFloor& compiled : floors)
      maps_.push_back(compiled.floor.plan.vertex.empty() ? nullptr
                                                         : path::make_floor_map(compiled.floor));
  }

  void run() {
    add_rooms();
    add_doors();
    place_kiosk();
    name_kiosks();
    for (const config::ExhibitSection& section : config_.exhibits) add_exhibit(section);
    if (kiosk_floor_ >= maps_.size() || !maps_[kiosk_floor_]) return;
    museum_.ambient =
        compile_ambient(config_, {*maps_[kiosk_floor_], entrance_, museum_.body_radius}, report_);
    if (entrance_) check_doors();
  }

 private:
  void error(const config::Place& place, std::string code, std::string message,
             std::string label = {}, std::string hint = {}) {
    report_.add(config::diagnostic_at(config_, place, std::move(code), std::move(message),
                                      std::move(label), std::move(hint)));
  }

  void add_rooms() {
    for (const config::RoomSection& section : config_.rooms) {
      Room room{
          .id = section.id.value,
          .floor = static_cast<std::uint32_t>(config::floor_index(config_, section.floor.value)),
          .title = plain_texts(section.title.value),
          .label = section.label.value,
          .outline = section.outline.value};
      if (section.outline.given && (room.outline.size() < 3 || signed_area(room.outline) == 0))
        error(section.outline.place, "bad-value",
              fmt::format("the outline of room '{}' holds no area", room.id));
      if (signed_area(room.outline) < 0) std::ranges::reverse(room.outline);
      museum_.rooms.push_back(std::move(room));
    }
  }

  /// A room for exhibits of a floor on which staff named none: the floor itself.
  std::uint32_t add_room_of_floor(std::uint32_t floor) {
    Room room;
    room.id = config_.floors[floor].name.value;
    room.floor = floor;
    for (const std::string& tag : config_.languages) room.title[tag] = room.id;
    museum_.rooms.push_back(std::move(room));
    return static_cast<std::uint32_t>(museum_.rooms.size() - 1);
  }

  void add_doors() {
    for (const config::DoorSection& section : config_.doors) {
      const std::size_t floor = config::floor_index(config_, section.floor.value);
      const Door door{.name = section.name.value,
                      .a = section.a.value,
                      .b = section.b.value,
                      .closed = section.closed.value};
      if (floor >= museum_.floors.size() || !section.a.given || !section.b.given) continue;
      if (maps_[floor] && !path::is_inside(*maps_[floor], (door.a + door.b) * 0.5))
        error(section.a.place, "door-outside-floor",
              fmt::format("door '{}' does not cross the floor", door.name),
              "its middle is not where one can walk");
      museum_.floors[floor].plan.doors.push_back(door);
    }
  }

  void place_kiosk() {
    const config::KioskSection& kiosk = config_.kiosk;
    kiosk_floor_ = config::floor_index(config_, kiosk.floor.value);
    museum_.kiosk_floor = static_cast<std::uint32_t>(kiosk_floor_);
    museum_.kiosk = {kiosk.position.value, to_radians(kiosk.facing.value)};
    if (kiosk_floor_ >= maps_.size() || !maps_[kiosk_floor_]) return;
    const path::FloorMap& map = *maps_[kiosk_floor_];
    if (!kiosk.position.given) {
      museum_.kiosk = most_open_place(floors_[kiosk_floor_].floor);
    } else if (const auto problem =
                   why_nobody_stands(map, museum_.kiosk.position, museum_.body_radius)) {
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
    if (const auto problem =
            why_nobody_stands(*maps_[kiosk.floor], kiosk.placement.position, museum_.body_radius))
      error(section.position.place, "kiosk-outside-floor",
            fmt::format("nobody can stand where the kiosk '{}' is said to be", kiosk.id),
            problem->label, problem->hint);
  }

  void add_exhibit(const config::ExhibitSection& section) {
    Exhibit exhibit;
    exhibit.id = section.id.value;
    exhibit.floor = static_cast<std::uint32_t>(config::floor_index(config_, section.floor.value));
    exhibit.placement = {section.position.value, to_radians(section.facing.value)};
    exhibit.title = plain_texts(section.title.value);
    exhibit.text = plain_texts(section.text.value);
    if (section.position.given && section.facing.given && exhibit.floor < maps_.size() &&
        maps_[exhibit.floor])
      place(section, exhibit);
    exhibit.room = room_of(exhibit);
    museum_.exhibits.push_back(std::move(exhibit));
  }

  void place(const config::ExhibitSection& section, Exhibit& exhibit) {
    const PlacingFloor floor{.map = *maps_[exhibit.floor],
                             .name = config_.floors[exhibit.floor].name.value,
                             .drawn = floors_[exhibit.floor].drawn.polygons,
                             .entrance = exhibit.floor == kiosk_floor_ ? entrance_ : std::nullopt,
                             .body_radius = museum_.body_radius};
    const WantedPlace wanted{
        .position = exhibit.placement.position,
        .heading = exhibit.placement.heading,
        .view = section.view.given ? std::optional(section.view.value) : std::nullopt};
    const PlacedExhibit placed = place_exhibit(floor, wanted);
    exhibit.place = placed.place;
    exhibit.viewing_point = placed.view;
    if (placed.problem) report_problem(section, *placed.problem);
    if (placed.problem && placed.problem->kind == PlaceProblem::Kind::Unreachable)
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
        return error(view_place, "exhibit-unreachable",
                     fmt::format("no visitor can reach exhibit '{}' from the kiosk", id),
                     problem.label, problem.hint);
    }
  }

  /// Names the doors that the guide does not fit through, if that keeps it from anything.
  void check_doors() {
    std::vector<Room> rooms;  // those that staff named
    std::ranges::copy_if(std::span(museum_.rooms).first(config_.rooms.size()),
                         std::back_inserter(rooms),
                         [&](const Room& room) { return room.floor == kiosk_floor_; });
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
