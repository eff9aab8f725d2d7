#include "runtime/path/closure/closed_doors.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <vector>

#include "content/floor/close_doors.h"
#include "content/floor/footprint.h"
#include "runtime/path/floor_map.h"
#include "tests/runtime/path/floors.h"

namespace docent::test::closed_doors_test {
namespace {

using path::ClosedDoors;
using path::RouteQuery;
using path::RouteStatus;
using path::Way;

constexpr double body = 0.25;
constexpr int columns = 3, rows = 2;
constexpr double room_size = 4, thickness = 0.2;

double at(int index) {
  return index * (room_size + thickness);
}

/// Rooms in a grid, some with a case in them, doors of 0.6 to 1.6 m between them.
struct Gallery {
  FloorPlan plan;
  std::vector<Door> doors;
};

void add_room(int column, int row, import::ImportedPlan& plan) {
  const Vec2 low{at(column), at(row)}, high = low + Vec2(room_size, room_size);
  std::vector<Points> holes;
  if (*rc::gen::arbitrary<bool>()) {
    const Vec2 centre = low + Vec2(*rc::gen::inRange(90, 311), *rc::gen::inRange(90, 311)) / 100.0;
    holes.push_back(regular_polygon(centre, *rc::gen::inRange(10, 80) / 100.0,
                                    *rc::gen::inRange(3, 8), *rc::gen::inRange(0, 90)));
  }
  plan.polygons.push_back(drawn(rectangle(low, high), holes).polygons.front());
}

/// Between the room and the one to the east of it, or to the north.
void add_door(int column, int row, bool east, import::ImportedPlan& plan,
              std::vector<Door>& doors) {
  const double half = *rc::gen::inRange(30, 81) / 100.0;
  const double along = *rc::gen::inRange(100, 301) / 100.0;
  const double depth = *rc::gen::inRange(3, 18) / 100.0;  // of the leaf, in the doorway
  const Vec2 room{at(column), at(row)};
  const auto place = [&](double across, double beside) {
    return room + (east ? Vec2(room_size + across, beside) : Vec2(beside, room_size + across));
  };
  const Vec2 low = place(0, along - half), high = place(thickness, along + half);
  plan.polygons.push_back(
      drawn(rectangle(glm::min(low, high), glm::max(low, high))).polygons.front());
  doors.push_back({.name = "d" + std::to_string(doors.size()),
                   .a = place(depth, along - half),
                   .b = place(depth, along + half)});
}

Gallery random_gallery() {
  import::ImportedPlan plan;
  Gallery gallery;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) add_room(column, row, plan);
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      if (column + 1 < columns) add_door(column, row, true, plan, gallery.doors);
      if (row + 1 < rows) add_door(column, row, false, plan, gallery.doors);
    }
  gallery.plan = mended(plan);
  return gallery;
}

Vec2 random_place() {
  return {*rc::gen::inRange(0, 1250) / 100.0 + 0.0031, *rc::gen::inRange(0, 830) / 100.0 + 0.0042};
}

/// A gallery with some doors closed: as they close live, and as the compiler closes them.
class Closure {
 public:
  Closure() : gallery_(random_gallery()) {
    std::vector<Door> for_good = gallery_.doors;
    for (std::uint32_t i = 0; i < for_good.size(); ++i) {
      for_good[i].closed = *rc::gen::inRange(0, 3) == 0;
      if (for_good[i].closed) closed_.push_back(i);
    }
    std::vector<floor::DoorFault> faults;
    const FloorPlan walled = floor::close_doors(gallery_.plan, for_good, faults);
    RC_ASSERT(faults.empty());
    gallery_.plan.doors = gallery_.doors;
    open_floor_ = floor_of(gallery_.plan, {0, body});
    walled_floor_ = floor_of(walled, {0, body});
    open_ = path::make_floor_map(open_floor_);
    walled_ = path::make_floor_map(walled_floor_);
    doors_ = std::make_unique<ClosedDoors>(gallery_.plan, open_floor_.sight, open_->walls().slack(),
                                           open_->medial_axis().roads(), closed_);
  }

  /// Near a leaf the compiled floor has a wall that is as thick as a door, and this one none.
  bool is_beside_a_leaf(Vec2 point) const {
    return std::abs(doors_->distance(point) - body) < floor::door_thickness ||
           doors_->distance(point) < floor::door_thickness;
  }
  Way live(RouteQuery query) const {
    query.closed = doors_.get();
    return path::route(*open_, query);
  }
  Way compiled(const RouteQuery& query) const { return path::route(*walled_, query); }
  const ClosedDoors& doors() const { return *doors_; }
  const path::FloorMap& open() const { return *open_; }

 private:
  Gallery gallery_;
  std::vector<std::uint32_t> closed_;
  Floor open_floor_, walled_floor_;
  std::shared_ptr<const path::FloorMap> open_, walled_;
  std::unique_ptr<ClosedDoors> doors_;
};

RouteQuery random_query(RouteKind kind, double radius) {
  return {.kind = kind, .from = random_place(), .to = random_place(), .radius = radius};
}

RC_GTEST_PROP(AShortestWayRoundClosedDoors, IsThatOfAFloorCompiledWithoutThem, ()) {
  const Closure closure;
  for (int i = 0; i < 20; ++i) {
    const RouteQuery query =
        random_query(RouteKind::Shortest, *rc::gen::element(body, body, 0.0, 0.1, 0.4));
    if (closure.is_beside_a_leaf(query.from) || closure.is_beside_a_leaf(query.to)) continue;

    const Way live = closure.live(query), compiled = closure.compiled(query);

    if (std::abs(closure.doors().distance(query.from) - query.radius) < floor::door_thickness ||
        std::abs(closure.doors().distance(query.to) - query.radius) < floor::door_thickness)
      continue;
    RC_ASSERT(live.status == compiled.status);
    if (live.status != RouteStatus::Ok) continue;
    RC_ASSERT(std::abs(live.length - compiled.length) < 1e-6);
    RC_ASSERT(!closure.doors().crosses(live.points));
  }
}

class Measured {
 public:
  void add(const Way& live, const Way& compiled) {
    ++count_;
    if (live.status != compiled.status) ++others_;
    if (live.status != RouteStatus::Ok || compiled.status != RouteStatus::Ok) return;
    const double off = std::abs(live.length - compiled.length);
    off_.push_back(off);
  }
  ~Measured() {
    if (std::getenv("DOCENT_MEASURE") == nullptr) return;
    std::ranges::sort(off_);
    if (off_.empty()) return;
    std::printf(
        "%d queries, %d of another status, lengths off: median %.2g, 95%% %.3f, most %.3f\n",
        count_, others_, off_[off_.size() / 2], off_[off_.size() * 95 / 100], off_.back());
  }

 private:
  int count_ = 0, others_ = 0;
  std::vector<double> off_;
};

RC_GTEST_PROP(AWayRoundClosedDoors, GoesThroughNone, ()) {
  static Measured skeleton, offset;
  const Closure closure;
  for (int i = 0; i < 20; ++i)
    for (const RouteKind kind : {RouteKind::Skeleton, RouteKind::Offset}) {
      const RouteQuery query = random_query(kind, body);
      if (closure.is_beside_a_leaf(query.from) || closure.is_beside_a_leaf(query.to)) continue;

      const Way live = closure.live(query);

      if (live.status == RouteStatus::Ok) RC_ASSERT(!closure.doors().crosses(live.points));
      (kind == RouteKind::Skeleton ? skeleton : offset).add(live, closure.compiled(query));
    }
}

TEST(ClosedDoors, CloseAWideDoorwayInWhichSomethingStands) {
  import::ImportedPlan plan = drawn(rectangle({0, 0}, {4, 4}));
  plan.polygons.push_back(drawn(rectangle({4.2, 0}, {8.2, 4})).polygons.front());
  plan.polygons.push_back(drawn(rectangle({4, 0.5}, {4.2, 3.5})).polygons.front());
  Floor floor = floor_of(floor::with_obstacles(
      mended(plan),
      std::vector<floor::Footprint>{{.centre = {4.1, 2}, .heading = 0, .size = {0.6, 0.6}}}));
  floor.plan.doors = {{.name = "wide", .a = {4.1, 0.5}, .b = {4.1, 3.5}}};
  const auto map = path::make_floor_map(floor);
  const std::vector<std::uint32_t> doors{0};
  const auto status = [&](double radius) {
    return path::route(*map, {.from = {2, 2}, .to = {6, 2}, .radius = radius}).status;
  };
  ASSERT_EQ(status(0), RouteStatus::Ok);
  ASSERT_EQ(status(0.25), RouteStatus::Ok) << "on either side of it";

  map->close(std::make_shared<ClosedDoors>(floor.plan, floor.sight, map->walls().slack(),
                                           map->medial_axis().roads(), doors));

  EXPECT_NE(status(0), RouteStatus::Ok);
  EXPECT_NE(status(0.25), RouteStatus::Ok);
}

}  // namespace
}  // namespace docent::test::closed_doors_test
