#include "runtime/scene/camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

namespace docent::scene {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double overview_pitch = 0.94;  ///< 54 degrees: steep enough to see over walls...
constexpr double walking_pitch = 0.84;   ///< ... and 48, where the model looks most like one.
constexpr double arrival_pitch = 0.79;
constexpr double nearest_distance = 9, farthest_distance = 24;  ///< Mostly 12 is enough.
constexpr double farthest_to_fit = 36;  ///< Where the goal is far behind who looks away from it.
constexpr double arrival_distance = 8.5;

/// The floor direction of an angle, in the world frame.
Vec3 world_direction(double angle) noexcept {
  return to_world({std::cos(angle), std::sin(angle)});
}

/// A box on the screen.
struct Bounds {
  float left = 1e9F, top = 1e9F, right = -1e9F, bottom = -1e9F;
  void add(ScreenPoint p) noexcept {
    left = std::min(left, p.x);
    right = std::max(right, p.x);
    top = std::min(top, p.y);
    bottom = std::max(bottom, p.y);
  }
};

float middle_x(const Rect& r) noexcept {
  return r.x + r.width / 2;
}
float middle_y(const Rect& r) noexcept {
  return r.y + r.height / 2;
}

/// Where the way and its goal are to be: the strip of helps covers the lowest tenth.
Rect kept_clear(const Rect& free) noexcept {
  return {free.x + 0.08F * free.width, free.y + 0.07F * free.height, 0.84F * free.width,
          0.8F * free.height};
}

/// What the walking camera has to show; endless where some of it is behind the eye.
Bounds bounds_of(const Walker& walker, const CameraView& view) noexcept {
  constexpr float body_height = 1.75F;
  Bounds bounds;
  const auto add = [&](Vec3 place) {
    if (const auto at = project(view, place))
      bounds.add(*at);
    else
      bounds.add({1e9F, 1e9F});
  };
  const Vec3 stands = to_world(walker.body.position, walker.height);
  add(stands);
  add(stands + Vec3(0, body_height, 0));
  for (const Vec2 p : walker.ahead) add(to_world(p, walker.height));
  for (const Vec3 p : walker.goal) add(p);
  return bounds;
}

/// By how much low to high has to move to lie within least to most.
float into(float low, float high, float least, float most) noexcept {
  return low < least ? least - low : high > most ? most - high : 0;
}

/// Metres of floor that one screen height shows at the target's distance.
double metres_per_screen(const CameraRig& rig) noexcept {
  return 2 * rig.distance * std::tan(rig.vertical_fov / 2);
}

}  // namespace

float field_of_view(const Rect& free) noexcept {
  constexpr float long_lens = 0.5236F;
  return 2 * std::atan(std::tan(long_lens / 2) / std::max(free.height, 0.1F));
}

double wrapped(double angle) noexcept {
  angle = std::fmod(angle, 2 * pi);
  if (angle > pi) return angle - 2 * pi;
  return angle <= -pi ? angle + 2 * pi : angle;
}

double smooth_step(double share) noexcept {
  share = std::clamp(share, 0.0, 1.0);
  return share * share * (3 - 2 * share);
}

double ease_out(double share) noexcept {
  share = 1 - std::clamp(share, 0.0, 1.0);
  return 1 - share * share * share;
}

CameraView view_of(const CameraRig& rig, float aspect) noexcept {
  const Vec3 ahead = world_direction(rig.yaw);
  const auto flat = static_cast<float>(std::cos(rig.pitch) * rig.distance);
  const auto rise = static_cast<float>(std::sin(rig.pitch) * rig.distance);

  CameraView view;
  view.target = rig.target;
  view.eye = rig.target - ahead * flat + Vec3(0, rise, 0);
  view.vertical_fov = rig.vertical_fov;
  view.view = glm::lookAt(view.eye, view.target, Vec3(0, 1, 0));
  const auto distance = static_cast<float>(rig.distance);
  view.projection = glm::perspective(view.vertical_fov, aspect, distance * 0.1F, distance * 3 + 20);
  // A shifted lens: clip x gains w times the shift, and w is -z.
  view.projection[2][0] = -(2 * rig.centre_x - 1);
  view.projection[2][1] = -(1 - 2 * rig.centre_y);
  return view;
}

CameraRig blend(const CameraRig& from, const CameraRig& to, double share) noexcept {
  const auto mix = [share](double a, double b) { return a + (b - a) * share; };
  const auto mixf = [share](float a, float b) { return a + (b - a) * static_cast<float>(share); };
  CameraRig rig;
  rig.target = glm::mix(from.target, to.target, static_cast<float>(share));
  rig.yaw = from.yaw + wrapped(to.yaw - from.yaw) * share;
  rig.pitch = mix(from.pitch, to.pitch);
  // Distances are felt as ratios.
  rig.distance = std::exp(mix(std::log(from.distance), std::log(to.distance)));
  rig.centre_x = mixf(from.centre_x, to.centre_x);
  rig.centre_y = mixf(from.centre_y, to.centre_y);
  rig.vertical_fov = mixf(from.vertical_fov, to.vertical_fov);
  return rig;
}

std::optional<ScreenPoint> project(const CameraView& view, Vec3 point) noexcept {
  const Vec4 clip = view.projection * (view.view * Vec4(point, 1));
  if (clip.w <= 1e-3F) return std::nullopt;
  return ScreenPoint{0.5F + clip.x / clip.w / 2, 0.5F - clip.y / clip.w / 2};
}

std::optional<Vec3> point_at_height(const CameraView& view, ScreenPoint at, float height) noexcept {
  const Vec4 far =
      glm::inverse(view.projection * view.view) * Vec4(2 * at.x - 1, 1 - 2 * at.y, 1, 1);
  if (std::abs(far.w) < 1e-9F) return std::nullopt;
  const Vec3 ray = Vec3(far) / far.w - view.eye;
  const float share = (height - view.eye.y) / ray.y;
  if (!(share > 0) || !std::isfinite(share)) return std::nullopt;
  return view.eye + share * ray;
}

CameraRig overview_of(std::span<const Vec2> outline, double height, double yaw, const Rect& free,
                      float aspect) noexcept {
  CameraRig rig{.yaw = yaw,
                .pitch = overview_pitch,
                .distance = 60,
                .centre_x = middle_x(free),
                .centre_y = middle_y(free),
                .vertical_fov = field_of_view(free)};
  if (outline.empty()) return rig;
  constexpr float air = 0.05F;  // of the free part, on every side
  const float room_x = free.width * (1 - 2 * air), room_y = free.height * (1 - 2 * air);
  Vec2 low = outline[0], high = outline[0];
  for (const Vec2 p : outline) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  rig.target = to_world((low + high) / 2.0, height);
  // So far off that nothing of the floor is behind the eye, which is more than half of this away.
  rig.distance = std::max(rig.distance, glm::distance(low, high));
  const Vec3 ahead = world_direction(yaw), right = world_direction(yaw - pi / 2);

  // Perspective makes the picture's middle differ from the floor's: move and scale until it fits.
  for (int round = 0; round < 24; ++round) {
    const CameraView view = view_of(rig, aspect);
    Bounds bounds;
    bool is_before_eye = true;
    for (const Vec2 p : outline)
      for (const double h : {height, height + 1.4}) {
        const auto at = project(view, to_world(p, h));
        if (at)
          bounds.add(*at);
        else
          is_before_eye = false;
      }
    if (!is_before_eye) {
      rig.distance *= 2;
      continue;
    }
    const float fill =
        std::max((bounds.right - bounds.left) / room_x, (bounds.bottom - bounds.top) / room_y);
    const auto metres = static_cast<float>(metres_per_screen(rig));
    const float off_x = (bounds.left + bounds.right) / 2 - middle_x(free);
    const float off_y = (bounds.top + bounds.bottom) / 2 - middle_y(free);
    rig.target += right * (off_x * metres * aspect);
    rig.target -= ahead * (off_y * metres / static_cast<float>(std::sin(rig.pitch)));
    rig.distance *= std::clamp(static_cast<double>(fill), 0.5, 2.0);
  }
  return rig;
}

double yaw_towards(const Walker& walker, double otherwise) noexcept {
  if (walker.ahead.empty()) return otherwise;
  Vec2 sum{};
  for (const Vec2 p : walker.ahead) sum += p - walker.body.position;
  for (const Vec3 p : walker.goal) sum += to_floor(p) - walker.body.position;
  if (dot(sum, sum) < 0.01) return otherwise;
  return std::atan2(sum.y, sum.x);
}

CameraRig close_behind(const Walker& walker, double yaw, const Rect& free) noexcept {
  return {.target = to_world(walker.body.position, walker.height) + Vec3(0, 0.9F, 0),
          .yaw = yaw,
          .pitch = walking_pitch,
          .distance = nearest_distance,
          .centre_x = middle_x(free),
          .centre_y = free.y + free.height * 0.7F,
          .vertical_fov = field_of_view(free)};
}

CameraRig behind(const Walker& walker, double yaw, const Rect& free, float aspect) noexcept {
  CameraRig rig = close_behind(walker, yaw, free);
  // Back off until all that has to be seen fits; then move the picture until it is inside.
  const Rect inner = kept_clear(free);
  for (; rig.distance < farthest_distance; rig.distance += 0.25) {
    const Bounds seen = bounds_of(walker, view_of(rig, aspect));
    if (seen.right - seen.left > inner.width || seen.bottom - seen.top > inner.height) continue;
    rig.centre_x += into(seen.left, seen.right, inner.x, inner.x + inner.width);
    rig.centre_y += into(seen.top, seen.bottom, inner.y, inner.y + inner.height);
    return rig;
  }
  return with_all_in_view(rig, walker, free, aspect);  // up to the edges
}

CameraRig with_all_in_view(CameraRig rig, const Walker& walker, const Rect& free,
                           float aspect) noexcept {
  constexpr float edge = 0.025F;  // of the free part
  const Rect inner{free.x + edge * free.width, free.y + edge * free.height,
                   (1 - 2 * edge) * free.width, (1 - 2 * edge) * free.height};
  Bounds seen = bounds_of(walker, view_of(rig, aspect));
  for (int round = 0; round < 24; ++round) {
    const float fill =
        std::max((seen.right - seen.left) / inner.width, (seen.bottom - seen.top) / inner.height);
    if (fill <= 1 || rig.distance >= farthest_to_fit) break;
    rig.distance *= std::min(1.0005 * static_cast<double>(fill), 1.25);
    seen = bounds_of(walker, view_of(rig, aspect));
  }
  rig.centre_x += into(seen.left, seen.right, inner.x, inner.x + inner.width);
  rig.centre_y += into(seen.top, seen.bottom, inner.y, inner.y + inner.height);
  return rig;
}

CameraRig beside(Vec2 standing, Vec2 exhibit, double yaw, double height, const Rect& free,
                 float aspect) noexcept {
  CameraRig rig{.target = to_world((standing + exhibit) / 2.0, height) + Vec3(0, 1.0F, 0),
                .yaw = yaw,
                .pitch = arrival_pitch,
                .distance = arrival_distance,
                .centre_x = middle_x(free),
                .centre_y = free.y + free.height * 0.5F,
                .vertical_fov = field_of_view(free)};
  // Raise or lower the picture until the exhibit is in the upper third.
  const float wanted = free.y + free.height * 0.3F;
  const Vec3 object = to_world(exhibit, height) + Vec3(0, 1.2F, 0);
  for (int round = 0; round < 4; ++round)
    if (const auto at = project(view_of(rig, aspect), object)) rig.centre_y += wanted - at->y;
  rig.centre_y =
      std::clamp(rig.centre_y, free.y + free.height * 0.3F, free.y + free.height * 0.75F);
  return rig;
}

CameraRig close_up(Vec3 foot, Vec3 size, double yaw, const Rect& free, float aspect) noexcept {
  constexpr double pitch = 0.42, nearest = 1.5;
  constexpr float share = 0.55F, seen = 0.5359F;  // twice the tangent of 15 degrees
  const float across = std::hypot(size.x, size.z);
  const float tall =
      size.y * static_cast<float>(std::cos(pitch)) + across * static_cast<float>(std::sin(pitch));
  const float free_aspect = aspect * free.width / std::max(free.height, 0.1F);
  const float needed = std::max({tall / share, across / (share * free_aspect), 0.02F});
  CameraRig rig;
  rig.target = foot + Vec3{0, size.y / 2, 0};
  rig.yaw = yaw;
  rig.pitch = pitch;
  rig.distance = needed / seen;
  rig.centre_x = middle_x(free);
  rig.centre_y = free.y + 0.47F * free.height;
  rig.vertical_fov = field_of_view(free);
  if (rig.distance < nearest) {
    const auto longer = static_cast<float>(nearest / rig.distance);
    rig.vertical_fov = 2 * std::atan(std::tan(rig.vertical_fov / 2) / longer);
    rig.distance = nearest;
  }
  return rig;
}

double turn_smoothly(double current, double wanted, double seconds, double time_constant,
                     double max_rate) noexcept {
  const double off = wrapped(wanted - current);
  const double step = off * (1 - std::exp(-seconds / time_constant));
  const double most = max_rate * seconds;
  return wrapped(current + std::clamp(step, -most, most));
}

}  // namespace docent::scene
