#include "content/film/walk_film.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>

#include "runtime/guide/stage.h"
#include "runtime/guide/turn_table.h"
#include "runtime/motion/walk.h"
#include "runtime/plan/plan.h"
#include "runtime/scene/camera.h"

namespace docent::film {
namespace {

constexpr double frame_seconds = 1.0 / 60;

Result<std::unique_ptr<plan::Plan>> plan_along(const Museum& museum, std::span<const Vec2> path,
                                               std::uint32_t floor) {
  motion::WalkRequest request;
  request.path = path;
  Result<motion::Walk> walk = motion::make_walk(museum.motion, request);
  if (!walk) return std::unexpected(walk.error());
  auto plan = std::make_unique<plan::Plan>();
  plan->order.floor = floor;
  plan->points.assign(path.begin(), path.end());
  plan->reach.push_back(0);
  for (std::size_t i = 1; i < path.size(); ++i)
    plan->reach.push_back(plan->reach.back() + glm::distance(path[i], path[i - 1]));
  plan->length = plan->reach.back();
  plan->walk = std::move(*walk);
  plan->end = plan->walk.body.back();
  plan->status = path::RouteStatus::Ok;
  return plan;
}

/// From where the visitor of the glass sees the guide, whoever films it.
Vec3 visitor_of(const guide::Avatar& walker) {
  return camera_on(walker, View::Kiosk, walker.body.heading, 0, 1).eye;
}

/// A camera that turns and rises slower than the guide and the walls before it do.
class Operator {
 public:
  Operator(const Museum& museum, View view, const guide::Avatar& walker)
      : museum_(museum),
        view_(view),
        yaw_(camera_yaw(view, walker.body.heading)),
        pitch_(pitch_for(walker)) {}

  void go_along(const guide::Avatar& walker, double seconds) {
    constexpr double time_constant = 0.6, most_rate = 1.2;  // radians a second
    yaw_ = scene::turn_smoothly(yaw_, camera_yaw(view_, walker.body.heading), seconds,
                                time_constant, most_rate);
    pitch_ = scene::turn_smoothly(pitch_, pitch_for(walker), seconds, time_constant / 2, most_rate);
  }
  [[nodiscard]] scene::CameraView seen(const guide::Avatar& walker, float aspect) const {
    return camera_on(walker, view_, yaw_, pitch_, aspect);
  }

 private:
  [[nodiscard]] double pitch_for(const guide::Avatar& walker) const {
    return camera_pitch(view_, museum_.floors[walker.shown_floor].plan, walker.body.position, yaw_);
  }

  const Museum& museum_;
  View view_;
  double yaw_, pitch_;
};

void fill(const Museum& museum, const guide::Avatar& walker, scene::DrawList& list) {
  list.avatars.clear();
  list.palette.clear();
  list.joint.clear();
  list.ribbons.clear();
  list.ribbon_point.clear();
  guide::draw(museum, walker, list);
  guide::draw_trail(walker, 0, list);
  guide::draw_objects(museum, walker.shown_floor, {}, {}, list);
  list.floor = walker.shown_floor;
  list.focus = walker.body.position;
}

}  // namespace

Result<guide::Avatar> make_walker(const Museum& museum, std::span<const Vec2> path,
                                  const WalkFilm& film) {
  auto plan = plan_along(museum, path, film.floor);
  if (!plan) return std::unexpected(plan.error());
  guide::Avatar walker = guide::make_avatar(
      museum, film.floor, plan::make_standing(museum, (*plan)->walk.body.front()));
  walker.look = film.look;
  walker.plan = std::move(*plan);
  walker.company.is_used = true;
  return walker;
}

std::vector<Pixels> film_walk(const Museum& museum, guide::Avatar& walker, const WalkFilm& film,
                              Studio& studio) {
  scene::DrawList list;
  list.ribbons.reserve(1);
  list.objects.reserve(museum.exhibits.size());
  list.ribbon_point.reserve(walker.plan->points.size() + 1);
  Operator camera(museum, film.view, walker);
  std::vector<Pixels> pictures;
  double time = 0;
  for (std::uint32_t i = 0; i < film.pictures; ++i) {
    const double share = static_cast<double>(i) / std::max(1U, film.pictures - 1);
    for (const double at = std::lerp(film.from, film.to, share); time < at;) {
      const double step = std::min(frame_seconds, at - time);
      walker.company.visitor = visitor_of(walker);
      guide::advance(museum, walker, step);
      camera.go_along(walker, step);
      time += step;
    }
    fill(museum, walker, list);
    list.camera = camera.seen(walker, studio.aspect());
    pictures.push_back(studio.take(list));
  }
  return pictures;
}

}  // namespace docent::film
