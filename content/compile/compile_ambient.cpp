#include "content/compile/compile_ambient.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string>
#include <utility>

#include "content/compile/check_footprints.h"
#include "content/compile/place_exhibits.h"
#include "runtime/model/geometry/polygon.h"
#include "runtime/path/floor_map.h"

namespace docent::compile {

namespace {

constexpr double area_each = 4;  // square metres; with less, people are in each other's way

/// Square metres of the piece of floor that holds a point: the inside of the outer wall that is
/// next about it, without the holes of that piece.
double area_about(const FloorPlan& plan, Vec2 point) {
  const auto polygon = [&](const Ring& ring) {
    return std::span(plan.vertex).subspan(ring.first, ring.count);
  };
  const auto outer_wall_about = [&](Vec2 p) {
    const Ring* next = nullptr;
    for (const Ring& ring : plan.ring) {
      const double area = signed_area(polygon(ring));
      if (area > 0 && contains(polygon(ring), p) &&
          (next == nullptr || area < signed_area(polygon(*next))))
        next = &ring;
    }
    return next;
  };
  const Ring* outer = outer_wall_about(point);
  if (outer == nullptr) return 0;
  double area = signed_area(polygon(*outer));
  for (const Ring& ring : plan.ring)
    if (const double hole = signed_area(polygon(ring));
        hole < 0 && outer_wall_about(plan.vertex[ring.first]) == outer)
      area += hole;
  return area;
}

void check_count(const config::MuseumConfig& config, const path::FloorMap& map, Vec2 kiosk,
                 Report& report) {
  const config::Located<std::int64_t>& count = config.ambient.count;
  const double area = area_about(map.plan(), kiosk);
  const auto fit =
      std::min<std::int64_t>(Ambient::most, static_cast<std::int64_t>(area / area_each));
  if (count.value <= fit) return;
  report.add(config::diagnostic_at(
      config, count.place, "too-many-visitors",
      fmt::format("{} visitors cannot stroll here: {} fit", count.value, fit), {},
      fmt::format("write count = {} or less: each wants {} of the {:.0f} square metres about the "
                  "kiosk, and {} is the most anywhere",
                  fit, area_each, area, Ambient::most)));
}

void check_entrance(const config::MuseumConfig& config, const AmbientFloor& floor,
                    const config::Located<Vec2>& entrance, Report& report) {
  if (const auto problem =
          why_not_there(floor.map, floor.standing, entrance.value, floor.body_radius))
    report.add(
        config::diagnostic_at(config, entrance.place, "entrance-outside-floor",
                              "strolling visitors cannot come from here: nobody can stand here",
                              problem->label, problem->hint));
  else if (!can_walk(floor.map, *floor.kiosk, entrance.value, floor.body_radius))
    report.add(config::diagnostic_at(
        config, entrance.place, "entrance-unreachable",
        "strolling visitors cannot come from here: there is no way to the kiosk",
        "no visitor can leave this place",
        fmt::format("every way from here to the kiosk is narrower than {:.2f} m",
                    2 * floor.body_radius)));
}

}  // namespace

Ambient compile_ambient(const config::MuseumConfig& config, const AmbientFloor& floor,
                        Report& report) {
  const config::AmbientSection& section = config.ambient;
  if (floor.kiosk) {
    check_count(config, floor.map, *floor.kiosk, report);
    for (const config::Located<Vec2>& entrance : section.from.value)
      check_entrance(config, floor, entrance, report);
  }
  Ambient ambient;
  ambient.count = static_cast<std::uint32_t>(section.count.value);
  for (const config::Located<Vec2>& entrance : section.from.value)
    ambient.entrances.push_back(entrance.value);
  if (section.look.given) {
    ambient.look_least = section.look.value.least;
    ambient.look_most = section.look.value.most;
  }
  return ambient;
}

}  // namespace docent::compile
