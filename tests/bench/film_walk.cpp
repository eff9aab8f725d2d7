/// Films walks along the shapes that ways through a museum are made of, for people's eyes: a
/// picture every 1/30 s of a guide and its trail, seen over the shoulder or from the side.
#include <cmath>
#include <filesystem>
#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "platform/gles/renderer.h"
#include "platform/headless/headless_display.h"
#include "platform/image/image.h"
#include "runtime/guide/stage.h"
#include "runtime/kiosk/exhibition.h"
#include "runtime/scene/camera.h"
#include "tests/bench/walk_shapes.h"

namespace docent::bench {
namespace {

constexpr double picture_seconds = 1.0 / 30;

struct Camera {
  double yaw = 0, pitch = 0.35, distance = 4.2;
  bool goes_along = false;  ///< Stays beside the guide.
};

std::unique_ptr<plan::Plan> plan_along(const Museum& museum, const WalkShape& shape, Vec2 from) {
  auto plan = std::make_unique<plan::Plan>();
  for (const Vec2 point : shape.path) plan->points.push_back(point + from - shape.path.front());
  plan->reach.push_back(0);
  for (std::size_t i = 1; i < plan->points.size(); ++i)
    plan->reach.push_back(plan->reach.back() + glm::distance(plan->points[i], plan->points[i - 1]));
  motion::WalkRequest request;
  request.path = plan->points;
  const Result<motion::Walk> walk = motion::make_walk(museum.motion, request);
  if (!walk) return nullptr;
  plan->walk = *walk;
  plan->status = path::RouteStatus::Ok;
  plan->length = plan->reach.back();
  return plan;
}

scene::CameraView seen(const guide::Avatar& avatar, const Camera& camera, double yaw) {
  scene::CameraRig rig;
  rig.target = to_world(avatar.body.position, 0.9);
  rig.yaw = yaw;
  rig.pitch = camera.pitch;
  rig.distance = camera.distance;
  return scene::view_of(rig, 1);
}

/// What walks are filmed with.
struct Studio {
  headless::HeadlessDisplay& display;
  gles::Renderer& renderer;
  Camera camera;
  std::filesystem::path folder;
};

int film(const Studio& studio, kiosk::Exhibition& exhibition, const WalkShape& shape) {
  const Museum& museum = exhibition.museum;
  const Camera& camera = studio.camera;
  auto plan = plan_along(museum, shape, museum.kiosk.position);
  if (!plan) return 1;
  kiosk::upload(exhibition);
  guide::Avatar avatar =
      guide::make_avatar(museum, 0, plan::make_standing(museum, plan->walk.body.front()));
  avatar.look = 1;
  avatar.plan = std::move(plan);
  scene::DrawList list;
  list.ribbons.reserve(1);
  list.ribbon_point.reserve(1 << 14);
  Pixels picture;
  double yaw = avatar.body.heading + camera.yaw;
  for (int i = 0; avatar.seconds < avatar.plan->seconds() + 1; ++i) {
    list.avatars.clear();
    list.palette.clear();
    list.ribbons.clear();
    list.ribbon_point.clear();
    guide::draw(museum, avatar, list);
    guide::draw_trail(avatar, 0, list);
    if (camera.goes_along)
      yaw = scene::turn_smoothly(yaw, avatar.body.heading + camera.yaw, picture_seconds, 0.6, 1.2);
    list.camera = seen(avatar, camera, yaw);
    list.focus = avatar.body.position;
    studio.renderer.draw(list, exhibition.holdings, studio.display.target());
    studio.display.read_back(picture);
    if (!image::write_png(studio.folder / fmt::format("{}-{:04}.png", shape.name, i), picture))
      return 3;
    guide::advance(museum, avatar, picture_seconds);
  }
  return 0;
}

int run(int argc, char** argv) {
  CLI::App app{"Films walks along basic shapes"};
  std::string database, shape;
  std::filesystem::path folder = "film";
  Camera camera;
  app.add_option("database", database, "a compiled museum with a large empty floor")->required();
  app.add_option("--shape", shape, "only that shape");
  app.add_option("--out", folder, "where the pictures go");
  app.add_option("--yaw", camera.yaw, "radians between the walk's and the camera's direction");
  app.add_option("--distance", camera.distance, "metres");
  app.add_flag("--along", camera.goes_along, "the camera turns with the guide");
  CLI11_PARSE(app, argc, argv);
  constexpr std::uint32_t side = 360;
  auto display = headless::open_headless({side, side});
  auto renderer = gles::make_renderer();
  if (!display || !renderer) return 3;
  std::filesystem::create_directories(folder);
  const Studio studio{**display, *renderer, camera, folder};
  for (const WalkShape& one : basic_shapes()) {
    if (!shape.empty() && one.name != shape) continue;
    auto exhibition = kiosk::load_exhibition(database, kiosk::Selection{}, {});
    if (!exhibition) {
      fmt::print(stderr, "{}\n", exhibition.error().what);
      return 1;
    }
    if (const int failed = film(studio, **exhibition, one); failed != 0) return failed;
    fmt::print("{}\n", one.name);
  }
  return 0;
}

}  // namespace
}  // namespace docent::bench

int main(int argc, char** argv) {
  return docent::bench::run(argc, argv);
}
