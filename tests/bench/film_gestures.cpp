/// Films what a guide does besides walking, for people's eyes: a sheet of pictures at even times,
/// seen from any side.
#include <algorithm>
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
#include "runtime/guide/avatar.h"
#include "runtime/scene/camera.h"

namespace docent::bench {
namespace {

struct Options {
  std::string scene = "greet";
  double yaw = 0, pitch = 0.2, distance = 3.2;  ///< The film's camera; yaw from the body's heading.
  double from = 0, to = 3;                      ///< Seconds.
  std::uint32_t pictures = 10, columns = 5, look = 1;
  std::uint32_t side = 300;     ///< Pixels.
  double aside = 1.0;           ///< Radians from straight ahead to the visitor or the exhibit.
  double away = 1.6, rise = 0;  ///< Metres to it, and above 1.2 m.
};

bool looks_round(const Options& options) {
  return options.scene == "back" || options.scene == "set-out";
}
bool walks(const Options& options) {
  return looks_round(options) || options.scene == "walk" || options.scene == "corner";
}

std::unique_ptr<plan::Plan> straight_ahead(const Museum& museum, const Placement& from,
                                           double metres, bool then_left) {
  auto plan = std::make_unique<plan::Plan>();
  const Vec2 ahead{std::cos(from.heading), std::sin(from.heading)};
  plan->points = {from.position, from.position + metres * ahead};
  plan->reach = {0, metres};
  if (then_left) {
    plan->points.push_back(plan->points.back() + metres * Vec2{-ahead.y, ahead.x});
    plan->reach.push_back(2 * metres);
  }
  motion::WalkRequest request;
  request.path = plan->points;
  const Result<motion::Walk> walk = motion::make_walk(museum.motion, request);
  if (!walk) return nullptr;
  plan->walk = *walk;
  plan->status = path::RouteStatus::Ok;
  plan->length = metres;
  return plan;
}

Vec3 beside(const guide::Avatar& avatar, double aside, double metres, double height) {
  const double angle = avatar.body.heading + aside;
  return to_world(avatar.body.position + metres * Vec2{std::cos(angle), std::sin(angle)}, height);
}

/// Where the walking camera would be: behind and above.
Vec3 kiosk_camera(const guide::Avatar& avatar) {
  return beside(avatar, std::numbers::pi, 6, 7.5);
}

void begin(const Options& options, guide::Avatar& avatar, const Museum& museum) {
  guide::Company& company = avatar.company;
  if (options.scene == "walk" || options.scene == "corner") company.calm = true;
  company.is_used = true;
  if (options.scene == "greet" || options.scene == "back" || options.scene == "set-out")
    company.visitor = kiosk_camera(avatar);
  else
    company.visitor = beside(avatar, -options.aside, 6, 6.0);
  if (options.scene == "greet-front") company.visitor = beside(avatar, options.aside, 4, 4);
  if (options.scene.starts_with("greet") || options.scene == "set-out") greet(avatar.manner);
  if (options.scene == "point")
    company.exhibit = beside(avatar, options.aside, options.away, 1.2 + options.rise);
  if (walks(options))
    avatar.plan = straight_ahead(museum, avatar.body, options.scene == "corner" ? 4 : 10,
                                 options.scene == "corner");
}

scene::CameraView seen(const Options& options, const guide::Avatar& avatar) {
  scene::CameraRig rig;
  rig.target = to_world(avatar.body.position, avatar.height + 0.95);
  rig.yaw = avatar.body.heading + std::numbers::pi + options.yaw;  // from the front
  rig.pitch = options.pitch;
  rig.distance = options.distance;
  return scene::view_of(rig, 1);
}

int film(const Options& options, const std::filesystem::path& out, const Museum& museum) {
  auto studio = film::open_studio(museum, {options.side, options.side});
  if (!studio) return 3;
  guide::Avatar avatar =
      guide::make_avatar(museum, 0, plan::make_standing(museum, museum.kiosk), 3);
  avatar.look = options.look;
  begin(options, avatar, museum);
  scene::DrawList list;
  std::vector<Pixels> pictures;
  constexpr double frame = 1.0 / 60;
  double time = 0;
  for (std::uint32_t i = 0; i < options.pictures; ++i) {
    const double at =
        options.from + (options.to - options.from) * i / std::max(1U, options.pictures - 1);
    for (; time < at; time += frame) {
      if (looks_round(options)) avatar.company.visitor = kiosk_camera(avatar);
      advance(museum, avatar, frame);
    }
    list.avatars.clear();
    list.palette.clear();
    list.joint.clear();
    draw(museum, avatar, list);
    list.camera = seen(options, avatar);
    list.focus = avatar.body.position;
    pictures.push_back(studio->take(list));
  }
  return image::write_png(out, film::contact_sheet(pictures, options.columns)) ? 0 : 3;
}

int run(int argc, char** argv) {
  CLI::App app{"Films what a guide does besides walking"};
  std::string database;
  std::filesystem::path out = "gestures.png";
  Options options;
  app.add_option("database", database, "a compiled museum")->required();
  app.add_option("--scene", options.scene,
                 "greet, greet-front, set-out, back (it looks round), point, walk, corner or idle");
  app.add_option("--out", out, "the sheet");
  app.add_option("--yaw", options.yaw,
                 "radians from the front to the camera, to the guide's right");
  app.add_option("--pitch", options.pitch, "radians that the camera looks down");
  app.add_option("--distance", options.distance, "metres");
  app.add_option("--from", options.from, "seconds: the first picture");
  app.add_option("--to", options.to, "seconds: the last");
  app.add_option("--pictures", options.pictures)->check(CLI::Range(1, 100));
  app.add_option("--columns", options.columns)->check(CLI::Range(1, 20));
  app.add_option("--side", options.side, "pixels of a picture")->check(CLI::Range(64, 1024));
  app.add_option("--look", options.look);
  app.add_option("--aside", options.aside, "radians from straight ahead to the exhibit, leftwards");
  app.add_option("--away", options.away, "metres to the exhibit");
  app.add_option("--rise", options.rise, "metres of the exhibit above 1.2 m");
  CLI11_PARSE(app, argc, argv);
  const Result<Museum> museum = sqlite::load_museum(database);
  if (!museum) {
    fmt::print(stderr, "{}\n", museum.error().what);
    return 1;
  }
  return film(options, out, *museum);
}

}  // namespace
}  // namespace docent::bench

int main(int argc, char** argv) {
  return docent::bench::run(argc, argv);
}
