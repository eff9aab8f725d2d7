/// How long do people need who are in each other's way, and do they stay apart: docent's crowd
/// beside ORCA, in the situations that narrow floors bring about.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "runtime/path/route.h"
#include "tests/bench/orca.h"
#include "tests/runtime/guide/situations.h"
#include "tests/runtime/path/floors.h"

namespace docent::bench {
namespace {

constexpr double radius = 0.25, frame_seconds = 1.0 / 60;

std::vector<OrcaWall> walls_of(const FloorPlan& plan) {
  std::vector<OrcaWall> walls;
  for (const auto& ring : plan.ring)
    for (std::uint32_t i = 0; i < ring.count; ++i)
      walls.push_back(
          {plan.vertex[ring.first + i], plan.vertex[ring.first + (i + 1) % ring.count]});
  return walls;
}

/// Towards the point half a metre along the shortest way, slower at its end.
Vec2 preferred_velocity(const path::FloorMap& map, Vec2 from, Vec2 to, double speed) {
  path::RouteQuery query;
  query.from = from;
  query.to = to;
  query.radius = radius - 0.01;
  query.tell_clearance = false;
  const path::Way way = path::route(map, query);
  Vec2 towards = to;
  double left = 0.5;
  for (std::size_t i = 1; way.status == path::RouteStatus::Ok && i < way.points.size() && left > 0;
       ++i) {
    const double piece = glm::distance(way.points[i - 1], way.points[i]);
    towards =
        piece > left ? glm::mix(way.points[i - 1], way.points[i], left / piece) : way.points[i];
    left -= piece;
  }
  const Vec2 off = towards - from;
  const double distance = glm::length(off);
  if (distance < 1e-6) return {};
  return std::min(speed, distance / 0.25) / distance * off;
}

test::Scene play_orca(const test::Situation& situation, double speed, double horizon) {
  const Floor floor = test::floor_of(situation.plan, {radius - 0.01});
  const auto map = path::make_floor_map(floor);
  const std::vector<OrcaWall> walls = walls_of(situation.plan);
  OrcaSettings settings;
  settings.horizon = horizon;
  test::Scene scene;
  scene.radius = radius;
  const std::size_t count = situation.parts.size();
  scene.arrival.assign(count, std::numeric_limits<double>::infinity());
  std::vector<OrcaBody> bodies(count);
  for (std::size_t i = 0; i < count; ++i) {
    // Perfect symmetry, which holds it up for ever, is undone by three centimetres.
    const double angle = 2.4 * static_cast<double>(i);
    bodies[i].position =
        situation.parts[i].from.position + 0.03 * Vec2{std::cos(angle), std::sin(angle)};
    bodies[i].most_speed = speed * situation.parts[i].pace;
    if (situation.parts[i].stays) {
      scene.arrival[i] = 0;
      bodies[i].most_speed = 0;
    }
  }
  for (double t = 0; t < situation.seconds && !scene.all_arrived(); t += frame_seconds) {
    std::vector<Vec2> next(count);
    for (std::size_t i = 0; i < count; ++i) {
      if (situation.parts[i].stays) continue;
      const Vec2 wanted = preferred_velocity(*map, bodies[i].position,
                                             situation.parts[i].to.position, bodies[i].most_speed);
      next[i] = orca_velocity(bodies, i, wanted, walls, settings);
    }
    for (std::size_t i = 0; i < count; ++i) {
      bodies[i].velocity = next[i];
      bodies[i].position += frame_seconds * next[i];
      scene.least_clearance =
          std::min(scene.least_clearance, path::clearance_at(*map, bodies[i].position));
      for (std::size_t j = 0; j < i; ++j)
        scene.deepest_overlap =
            std::max(scene.deepest_overlap,
                     2 * radius - glm::distance(bodies[i].position, bodies[j].position));
      if (glm::distance(bodies[i].position, situation.parts[i].to.position) < 0.1)
        scene.arrival[i] = std::min(scene.arrival[i], t);
    }
  }
  return scene;
}

std::vector<double> alone_with_orca(const test::Situation& situation, double speed) {
  std::vector<double> out;
  for (const test::Part& part : situation.parts) {
    test::Situation alone = situation;
    alone.parts = {part};
    out.push_back(part.stays ? 0 : play_orca(alone, speed, 1).arrival.front());
  }
  return out;
}

void tell(const char* name, const std::string& method, const test::Situation& situation,
          const test::Scene& scene, const std::vector<double>& alone) {
  double delay = 0, last = 0;
  int walkers = 0, arrived = 0;
  for (std::size_t i = 0; i < scene.arrival.size(); ++i) {
    if (situation.parts[i].stays) continue;
    ++walkers;
    if (!std::isfinite(scene.arrival[i])) continue;
    ++arrived;
    delay += scene.arrival[i] - alone[i];
    last = std::max(last, scene.arrival[i]);
  }
  fmt::print("| {} | {} | {} of {} | {:.1f} | {:.1f} | {:.0f} | {:.0f} |\n", name, method, arrived,
             walkers, arrived > 0 ? delay / arrived : 0, last,
             1000 * std::max(0.0, scene.deepest_overlap),
             1000 * std::max(0.0, radius - scene.least_clearance));
}

int run(int argc, char** argv) {
  CLI::App app{"docent's crowd beside ORCA"};
  double speed = 1.15;
  app.add_option("--speed", speed, "metres a second of ORCA's discs; docent's walk at the clips'");
  CLI11_PARSE(app, argc, argv);
  struct Named {
    const char* name;
    test::Situation (*make)();
  };
  fmt::print(
      "| situation | by | arrive | mean delay, s | last, s | overlap, mm | in a wall, mm |\n"
      "| --- | --- | --- | --- | --- | --- | --- |\n");
  for (const Named& each :
       {Named{"corridor", test::head_on_in_a_corridor},
        Named{"doorway", test::head_on_in_a_doorway}, Named{"crossing", test::four_ways},
        Named{"twelve", test::twelve_through_a_doorway}, Named{"overtaking", test::overtaking},
        Named{"in the way", test::one_in_the_way}, Named{"ring", test::ring_of_sixteen}}) {
    const test::Situation situation = each.make();
    tell(each.name, "docent", situation, play(situation), seconds_alone(situation));
    const std::vector<double> alone = alone_with_orca(situation, speed);
    for (const double horizon : {1.0, 2.0, 4.0})
      tell(each.name, fmt::format("ORCA, {} s ahead", horizon), situation,
           play_orca(situation, speed, horizon), alone);
  }
  return 0;
}

}  // namespace
}  // namespace docent::bench

int main(int argc, char** argv) {
  return docent::bench::run(argc, argv);
}
