#include "content/compile/standing.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "config/museum_cases.h"
#include "runtime/model/geometry/polygon.h"

namespace docent::compile {
namespace {

constexpr double on_wall_within = 0.05;  // metres

/// Two boxes that were meant to touch overlap by less.
constexpr double touching = 0.005;  // metres

floor::Footprint footprint_of(const auto& section, double ordinary_facing) {
  const double degrees = section.facing.given ? section.facing.value : ordinary_facing;
  const config::Size size = section.size.given
                                ? section.size.value
                                : config::Size{config::ordinary_size, config::ordinary_size};
  return {.centre = section.position.value,
          .heading = degrees * std::numbers::pi / 180,
          .size = {size.across, size.deep}};
}

bool is_in_hole(std::span<const import::ImportedPolygon> drawn, Vec2 p) {
  return std::ranges::any_of(drawn, [&](const import::ImportedPolygon& polygon) {
    return std::ranges::any_of(
        polygon.holes, [&](const import::ImportedRing& hole) { return contains(hole.vertex, p); });
  });
}

}  // namespace

bool takes_floor(const Standing& thing) {
  const bool is_free = thing.kind == Standing::Kind::Case || thing.place == ExhibitPlace::OnFloor;
  return is_free &&
         std::min(thing.footprint.size.x, thing.footprint.size.y) >= floor::smallest_footprint;
}

std::vector<Standing> standing_on(const config::MuseumConfig& config, std::size_t floor) {
  std::vector<Standing> things;
  const auto add = [&](Standing::Kind kind, const char* what, const auto& sections,
                       double ordinary_facing) {
    for (std::size_t i = 0; i < sections.size(); ++i)
      if (sections[i].position.given &&
          config::floor_index(config, sections[i].floor.value) == floor)
        things.push_back({.kind = kind,
                          .index = i,
                          .name = fmt::format("{} '{}'", what, sections[i].id.value),
                          .footprint = footprint_of(sections[i], ordinary_facing),
                          .place = {}});
  };
  add(Standing::Kind::Case, "case", config.cases, config::ordinary_facing);
  add(Standing::Kind::Exhibit, "exhibit", config.exhibits, 0);
  return things;
}

std::optional<ExhibitPlace> what_it_stands_on(const path::WallGrid& walls,
                                              std::span<const import::ImportedPolygon> drawn,
                                              std::span<const floor::Footprint> cases, Vec2 point) {
  const auto nearest = walls.nearest_wall(point);
  const bool in_case = std::ranges::any_of(
      cases, [&](const floor::Footprint& each) { return floor::covers(each, point); });
  if (in_case) return ExhibitPlace::InCase;
  if (nearest.distance <= on_wall_within) return ExhibitPlace::OnWall;
  if (walls.is_inside(point, nearest)) return ExhibitPlace::OnFloor;
  if (is_in_hole(drawn, point)) return ExhibitPlace::InCase;
  return {};
}

std::vector<Overlap> overlaps_of(std::span<const Standing> things) {
  std::vector<const Standing*> before;
  std::vector<Overlap> overlaps;
  for (const Standing& thing : things) {
    if (!takes_floor(thing)) continue;
    const auto depth = [&](const Standing* other) {
      const floor::Footprint &a = thing.footprint, &b = other->footprint;
      const double reach = (glm::length(a.size) + glm::length(b.size)) / 2;
      return glm::distance(a.centre, b.centre) < reach ? floor::overlap_of(a, b) : 0.0;
    };
    const auto first = std::ranges::find_if(
        before, [&](const Standing* other) { return depth(other) > touching; });
    if (first != before.end()) overlaps.push_back({*first, &thing, depth(*first)});
    before.push_back(&thing);
  }
  return overlaps;
}

const config::Place& place_of_position(const config::MuseumConfig& config, const Standing& thing) {
  return thing.kind == Standing::Kind::Case ? config.cases[thing.index].position.place
                                            : config.exhibits[thing.index].position.place;
}

std::string size_text(const floor::Footprint& footprint) {
  return fmt::format("{:.2f} by {:.2f} m", footprint.size.x, footprint.size.y);
}

}  // namespace docent::compile
