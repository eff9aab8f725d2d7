#include "tests/runtime/path/floors.h"

#include "content/content_error.h"
#include "content/floor/medial_axis.h"
#include "content/floor/sight.h"
#include "content/floor/voronoi.h"
#include "runtime/path/shortest/make_hub_labels.h"
#include "runtime/path/shortest/make_tangent_graph.h"

namespace docent::test {
namespace {

bool has_shared_points(const FloorPlan& plan) {
  for (std::size_t i = 0; i < plan.vertex.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (plan.vertex[i] == plan.vertex[j]) return true;
  return false;
}

}  // namespace

Floor floor_of(const FloorPlan& plan, std::initializer_list<double> radii) {
  Floor floor;
  floor.plan = plan;
  floor.diagram = floor::voronoi_diagram(plan);
  floor.sight = floor::make_sight_map(plan, floor.diagram);
  floor.roadmap = floor::medial_axis(plan, floor.diagram);
  for (const double radius : radii) {
    floor.tangent_graphs.push_back(path::make_tangent_graph(plan, floor.sight, radius));
    floor.hub_labels.push_back(path::make_hub_labels(plan, floor.tangent_graphs.back()));
  }
  return floor;
}

import::ImportedPlan hall_with_a_box() {
  return drawn(rectangle({0, 0}, {12, 8}), {rectangle({5, 3}, {7, 5})});
}

import::ImportedPlan two_rooms(double door_width) {
  const double low = 2 - door_width / 2, high = 2 + door_width / 2;
  return drawn({{0, 0},
                {4, 0},
                {4, low},
                {4.2, low},
                {4.2, 0},
                {8.2, 0},
                {8.2, 4},
                {4.2, 4},
                {4.2, high},
                {4, high},
                {4, 4},
                {0, 4}});
}

std::optional<FloorPlan> random_hall() {
  auto obstacles = *any_obstacles();
  if (obstacles.size() > 8) obstacles.resize(8);
  try {
    FloorPlan plan = mended(hall_with(obstacles));
    if (has_shared_points(plan)) return {};
    return plan;
  } catch (const content::ContentError&) {
    return {};  // The obstacles filled the hall.
  }
}

Vec2 random_point() {
  return {*rc::gen::inRange(0, 1200) / 100.0 + 0.003, *rc::gen::inRange(0, 800) / 100.0 + 0.004};
}

}  // namespace docent::test
