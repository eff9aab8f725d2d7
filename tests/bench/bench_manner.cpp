/// What a body costs the frame loop: its walk sampled, idle, gaze and gestures laid over it, and
/// its joints placed.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "platform/sqlite/content_reader.h"
#include "runtime/guide/avatar.h"
#include "runtime/scene/look.h"
#include "tests/bench/measure.h"

namespace docent::bench {
namespace {

constexpr double frame = 1.0 / 60;

std::unique_ptr<plan::Plan> walk_ahead(const Museum& museum, double metres) {
  auto plan = std::make_unique<plan::Plan>();
  const Placement& from = museum.kiosk;
  plan->points = {from.position,
                  from.position + metres * Vec2{std::cos(from.heading), std::sin(from.heading)}};
  plan->reach = {0, metres};
  plan->status = path::RouteStatus::Ok;
  motion::WalkRequest request;
  request.path = plan->points;
  auto walk = motion::make_walk(museum.motion, request);
  if (walk) plan->walk = std::move(*walk);
  return plan;
}

struct Clothes {
  std::uint32_t look = 0;
  bool swing = true;
};

enum class Doing : std::uint8_t { Nothing, Looks, Waves, Points };

/// Microseconds a frame of one of many bodies, the median of the rounds.
double cost(const Museum& museum, bool walks, Doing doing, const Clothes& clothes = {}) {
  constexpr std::size_t bodies = 64;
  constexpr int rounds = 60;
  std::vector<guide::Avatar> all;
  for (std::size_t i = 0; i < bodies; ++i) {
    all.push_back(guide::make_avatar(museum, 0, plan::make_standing(museum, museum.kiosk), i));
    guide::Avatar& one = all.back();
    one.look = clothes.look;
    if (!clothes.swing) one.palette.clear();
    if (walks) one.plan = walk_ahead(museum, 30);
    const Vec3 aside = to_world(one.body.position + Vec2{1.2, 0.8}, 1.3);
    if (doing != Doing::Nothing) one.company = {.visitor = aside + Vec3(2, 4, 2), .is_used = true};
    if (doing == Doing::Points) one.company.exhibit = aside;
    one.company.calm = doing == Doing::Points;  // all the time
  }
  std::vector<double> microseconds;
  for (int round = 0; round < rounds; ++round) {
    const double begun = now();
    for (guide::Avatar& one : all) {
      if (doing == Doing::Waves) guide::greet(one.manner);
      advance(museum, one, frame);
    }
    microseconds.push_back(1e6 * (now() - begun) / bodies);
  }
  return median(microseconds);
}

int measure(const std::string& database) {
  const Result<Museum> museum = sqlite::load_museum(database);
  if (!museum) {
    std::fprintf(stderr, "%s\n", museum.error().what.c_str());
    return 1;
  }
  std::printf("microseconds a body and frame      stands     walks\n");
  const auto row = [&](const char* name, Doing doing) {
    std::printf("%-30s %10.2f %9.2f\n", name, cost(*museum, false, doing),
                cost(*museum, true, doing));
  };
  row("nothing else", Doing::Nothing);
  row("looks at a visitor", Doing::Looks);
  row("waves", Doing::Waves);
  row("points", Doing::Points);
  std::printf("of it its clothes, by look\n");
  for (std::uint32_t look = 0; look < scene::guide_look_count; ++look) {
    const auto clothes = [&](bool walks) {
      return cost(*museum, walks, Doing::Nothing, {look}) -
             cost(*museum, walks, Doing::Nothing, {look, false});
    };
    std::printf("%-30u %10.2f %9.2f\n", look, clothes(false), clothes(true));
  }
  return 0;
}

}  // namespace
}  // namespace docent::bench

int main(int argc, char** argv) {
  CLI::App app("What a body costs a frame: walk, idle, gaze and gestures");
  std::string database;
  app.add_option("database", database, "The sample museum, compiled")->required();
  CLI11_PARSE(app, argc, argv);
  return docent::bench::measure(database);
}
