#include "content/compile/compile_places.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "content/compile/compile_exhibits.h"
#include "content/compile/place_exhibits.h"
#include "runtime/path/building/building_map.h"

namespace docent::compile {
namespace {

/// Kept beyond the body's radius, as at viewing points. Metres.
constexpr double margin = 0.05;

class PlaceCompiler {
 public:
  PlaceCompiler(const config::MuseumConfig& config,
                std::span<const std::shared_ptr<const path::FloorMap>> maps, Museum& museum,
                Report& report)
      : config_(config), maps_(maps), museum_(museum), report_(report) {}

  void add(const config::PlaceSection& section) {
    const auto kind = place_kind_named(section.kind.value);
    Place place{
        .id = section.id.value,
        .kind = kind.value_or(PlaceKind::Information),
        .floor = static_cast<std::uint32_t>(config::floor_index(config_, section.floor.value)),
        .position = section.position.value,
        .title = plain_texts(section.title.value)};
    // What is missing is reported already.
    if (!kind || !section.position.given || place.floor >= maps_.size() || !maps_[place.floor])
      return;
    if (!find_standing(section, place)) return;
    museum_.places.push_back(std::move(place));
    sections_.push_back(&section);
  }

  /// Can visitors get there from the kiosk, while nothing is closed?
  void check_ways(Vec2 entrance) {
    if (museum_.places.empty() || std::ranges::find(maps_, nullptr) != maps_.end() ||
        museum_.connections.size() < config_.connections.size())
      return;
    const path::BuildingMap building(museum_, {maps_.begin(), maps_.end()});
    for (std::size_t i = 0; i < museum_.places.size(); ++i)
      if (!can_reach(building, entrance, museum_.places[i])) report_unreachable(i);
  }

 private:
  bool find_standing(const config::PlaceSection& section, Place& place) {
    const path::FloorMap& map = *maps_[place.floor];
    const double room = museum_.body_radius + margin;
    if (path::is_inside(map, place.position) && path::clearance_at(map, place.position) >= room) {
      place.standing = place.position;
      return true;
    }
    const auto free = nearest_free_point(map, place.position, room);
    if (free && glm::distance(*free, place.position) <= farthest_standing) {
      place.standing = *free;
      return true;
    }
    report_.add(config::diagnostic_at(
        config_, section.position.place, "place-outside-floor",
        fmt::format("place '{}' is far from where anybody can stand", place.id),
        fmt::format("{:.2f} m from the floor of '{}'", path::clearance_at(map, place.position),
                    config_.floors[place.floor].name.value),
        free ? fmt::format("the nearest point with room for a visitor is {}", point_text(*free))
             : std::string()));
    return false;
  }

  bool can_reach(const path::BuildingMap& building, Vec2 entrance, const Place& place) const {
    return building
               .route({.way = {.from = entrance,
                               .to = place.standing,
                               .radius = museum_.body_radius,
                               .tell_clearance = false},
                       .from_floor = museum_.kiosk_floor,
                       .to_floor = place.floor,
                       .permissions = {.closed_too = true}})
               .status == path::BuildingStatus::Ok;
  }

  void report_unreachable(std::size_t index) {
    const Place& place = museum_.places[index];
    Diagnostic diagnostic = config::diagnostic_at(
        config_, sections_[index]->position.place, "place-unreachable",
        fmt::format("no visitor can get from the kiosk to place '{}'", place.id),
        fmt::format("one would stand at {}", point_text(place.standing)),
        "move its position to where one stands to use it, on the floor and clear of walls");
    // A door that is closed for good may be what is in the way.
    const auto has_closed_door = [](const Floor& floor) {
      return std::ranges::any_of(floor.plan.doors, &Door::closed);
    };
    if (std::ranges::any_of(museum_.floors, has_closed_door))
      diagnostic.severity = Severity::Warning;
    report_.add(std::move(diagnostic));
  }

  const config::MuseumConfig& config_;
  std::span<const std::shared_ptr<const path::FloorMap>> maps_;
  Museum& museum_;
  Report& report_;
  std::vector<const config::PlaceSection*> sections_;  ///< Of museum_.places.
};

}  // namespace

void compile_places(const config::MuseumConfig& config,
                    std::span<const std::shared_ptr<const path::FloorMap>> maps,
                    std::optional<Vec2> entrance, Museum& museum, Report& report) {
  PlaceCompiler compiler(config, maps, museum, report);
  for (const config::PlaceSection& section : config.places) compiler.add(section);
  if (entrance) compiler.check_ways(*entrance);
}

}  // namespace docent::compile
