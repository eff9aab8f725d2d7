#pragma once

#include <rapidcheck.h>

#include <ostream>
#include <string>
#include <tuple>
#include <vector>

#include "content/import/floor/geojson.h"
#include "tests/content/floor/plans.h"
#include "tests/content/floor/random_plan.h"

namespace docent::test {

/// What people, scanners and file formats do to a plan.
enum class Dirt : std::uint8_t {
  Nudge,        ///< A corner lies up to 3 mm off.
  Repeat,       ///< A corner comes twice, up to 0.9 mm apart.
  Spike,        ///< A ring runs out and back, along one line or nearly.
  Cross,        ///< Two corners are in the wrong order.
  TouchWall,    ///< A ring is moved until a corner of it lies on a side of another.
  TouchCorner,  ///< Or on a corner of another.
  Sliver,       ///< A gap of 1 mm and a case of 1 mm along a side.
  Needle,       ///< A long thin case across everything.
  Backwards,    ///< A ring runs the other way round.
  Twin,         ///< A ring comes twice.
  Flat,         ///< A case without area.
  Room,         ///< Another area, which overlaps, touches or stands apart.
};
constexpr int kinds_of_dirt = 12;

/// Kind, ring, vertex, and two amounts from -100 to 99.
using Soiling = std::tuple<int, int, int, int, int>;

/// Where on the map a plan lies.
enum class Where : std::uint8_t { AtOrigin, InMapMetres, FarInMapMetres, InDegrees };

/// A hall with obstacles, and what was done to it.
struct DirtyPlan {
  int shape = 0;  ///< Of the hall.
  std::vector<Obstacle> obstacles;
  std::vector<Soiling> soilings;
  Where where = Where::AtOrigin;
};

/// As a GeoJSON file says it; for `Where::InDegrees` in longitude and latitude.
std::string geojson(const DirtyPlan& plan);
inline import::Coordinates coordinates_of(const DirtyPlan& plan) {
  return plan.where == Where::InDegrees ? import::Coordinates::Wgs84 : import::Coordinates::Metres;
}

/// For rapidcheck's reports.
// NOLINTNEXTLINE(readability-identifier-naming): rapidcheck looks for this name.
inline void showValue(const DirtyPlan& plan, std::ostream& out) {
  out << geojson(plan);
}

/// Up to so many of what a generator makes.
template <typename T>
rc::Gen<std::vector<T>> up_to(int count, const rc::Gen<T>& any) {
  return rc::gen::mapcat(rc::gen::inRange(0, count + 1), [any](int n) {
    return rc::gen::container<std::vector<T>>(static_cast<std::size_t>(n), any);
  });
}

inline rc::Gen<DirtyPlan> any_dirty_plan() {
  const rc::Gen<Soiling> any_soiling = rc::gen::tuple(
      rc::gen::inRange(0, kinds_of_dirt), rc::gen::inRange(0, 50), rc::gen::inRange(0, 50),
      rc::gen::inRange(-100, 100), rc::gen::inRange(-100, 100));
  // Ranges shrink with the size that rapidcheck begins with, and a hall cannot.
  return rc::gen::resize(
      rc::kNominalSize,
      rc::gen::map(
          rc::gen::tuple(rc::gen::inRange(0, 4), up_to(7, any_obstacle()), up_to(8, any_soiling),
                         rc::gen::inRange(0, 4)),
          [](const std::tuple<int, std::vector<Obstacle>, std::vector<Soiling>, int>& parts) {
            const auto& [shape, obstacles, soilings, where] = parts;
            return DirtyPlan{shape, obstacles, soilings, static_cast<Where>(where)};
          }));
}

}  // namespace docent::test
