/// Films how a guide opens a door, for people's eyes: a sheet of pictures at even times, seen from
/// any side. The door is one of the database's, hung and opened in another way.
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "content/film/contact_sheet.h"
#include "content/film/studio.h"
#include "platform/image/image.h"
#include "platform/sqlite/content_reader.h"
#include "runtime/guide/doors.h"
#include "runtime/scene/camera.h"

namespace docent::bench {
namespace {

struct Options {
  std::string opens = "pull", swing = "double";
  double width = 2, side_of_door = -1, along = 0, metres = 4;  ///< Where the guide comes from.
  double yaw = 0.8, pitch = 0.35, distance = 4.5;              ///< The film's camera.
  double from = 3, to = 14;                                    ///< Seconds.
  std::uint32_t door = 0, pictures = 24, columns = 6, look = 1, side = 320;
};

void hang(const Options& options, Door& door) {
  const Vec2 middle = 0.5 * (door.a + door.b);
  const Vec2 half = options.width / 2 * glm::normalize(door.b - door.a);
  door.a = middle - half;
  door.b = middle + half;
  door.opens = options.opens == "pull"      ? DoorOpens::Pull
               : options.opens == "sliding" ? DoorOpens::Sliding
                                            : DoorOpens::Push;
  door.hinge = options.swing == "left"    ? DoorHinge::A
               : options.swing == "right" ? DoorHinge::B
                                          : DoorHinge::Both;
}

Placement beside(const Door& door, double metres, double along) {
  const Vec2 run = glm::normalize(door.b - door.a), left{-run.y, run.x};
  const Vec2 heading = -std::copysign(1.0, metres) * left;
  return {0.5 * (door.a + door.b) + metres * left + along * run, std::atan2(heading.y, heading.x)};
}

int film(const Options& options, const std::filesystem::path& out, Museum museum) {
  const std::uint32_t floor = museum.kiosk_floor;
  if (options.door >= museum.floors[floor].plan.doors.size()) {
    fmt::print(stderr, "the kiosk's floor has no such door\n");
    return 1;
  }
  Door& door = museum.floors[floor].plan.doors[options.door];
  hang(options, door);
  auto studio = film::open_studio(museum, {options.side, options.side});
  if (!studio) return 3;
  plan::Planner planner(museum, {});
  guide::Doors doors(museum);
  guide::Crowd crowd(museum, planner);
  const std::uint32_t who =
      crowd.add(floor, beside(door, options.side_of_door * options.metres, options.along), 100, 1);
  crowd.set_look(who, options.look);
  crowd.send(who, floor, beside(door, -options.side_of_door * 3, 0), RouteKind::Shortest);
  scene::DrawList list;
  list.leaves.reserve(2 * museum.floors[floor].plan.doors.size());
  std::vector<Pixels> pictures;
  constexpr double frame = 1.0 / 60;
  double time = 0;
  for (std::uint32_t i = 0; i < options.pictures; ++i) {
    const double at =
        options.from + (options.to - options.from) * i / std::max(1U, options.pictures - 1);
    for (; time < at; time += frame) {
      planner.wait();
      doors.step(frame, crowd);
      crowd.step(frame);
    }
    list.avatars.clear();
    list.palette.clear();
    list.joint.clear();
    list.leaves.clear();
    draw(museum, crowd[who].avatar, list);
    doors.draw(floor, list);
    list.floor = floor;
    scene::CameraRig rig;
    const Placement before = beside(door, options.side_of_door, 0);
    rig.target = to_world(before.position, museum.floors[floor].plan.height + 0.9);
    rig.yaw = before.heading + options.yaw;
    rig.pitch = options.pitch;
    rig.distance = options.distance;
    list.camera = scene::view_of(rig, 1);
    list.focus = before.position;
    pictures.push_back(studio->take(list));
  }
  return image::write_png(out, film::contact_sheet(pictures, options.columns)) ? 0 : 3;
}

int run(int argc, char** argv) {
  CLI::App app{"Films how a guide opens a door"};
  std::string database;
  std::filesystem::path out = "doors.png";
  Options options;
  app.add_option("database", database, "a compiled museum")->required();
  app.add_option("--door", options.door, "which of the kiosk's floor");
  app.add_option("--opens", options.opens, "push, pull or sliding")
      ->check(CLI::IsMember({"push", "pull", "sliding"}));
  app.add_option("--swing", options.swing, "left, right or double")
      ->check(CLI::IsMember({"left", "right", "double"}));
  app.add_option("--width", options.width, "metres");
  app.add_option("--comes-from", options.side_of_door, "-1: from where it is pulled, or 1");
  app.add_option("--along", options.along, "metres along the door from its middle");
  app.add_option("--metres", options.metres, "that the guide comes from before it");
  app.add_option("--yaw", options.yaw, "radians from behind the guide to the camera");
  app.add_option("--pitch", options.pitch, "radians that the camera looks down");
  app.add_option("--distance", options.distance, "metres");
  app.add_option("--from", options.from, "seconds: the first picture");
  app.add_option("--to", options.to, "seconds: the last");
  app.add_option("--pictures", options.pictures)->check(CLI::Range(1, 100));
  app.add_option("--columns", options.columns)->check(CLI::Range(1, 20));
  app.add_option("--side", options.side, "pixels of a picture")->check(CLI::Range(64, 1024));
  app.add_option("--look", options.look);
  app.add_option("--out", out, "the sheet");
  CLI11_PARSE(app, argc, argv);
  Result<Museum> museum = sqlite::load_museum(database);
  if (!museum) {
    fmt::print(stderr, "{}\n", museum.error().what);
    return 1;
  }
  return film(options, out, std::move(*museum));
}

}  // namespace
}  // namespace docent::bench

int main(int argc, char** argv) {
  return docent::bench::run(argc, argv);
}
