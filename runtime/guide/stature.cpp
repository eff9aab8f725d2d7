#include "runtime/guide/stature.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace docent::guide {
namespace {

constexpr float stature = 1.6F;  // metres: of the shortest of our guides

}  // namespace

float stature_scale(const scene::CameraView& camera, const interface::ScreenShape& shape,
                    Vec3 ground) noexcept {
  const auto feet = scene::project(camera, ground);
  const auto head = scene::project(camera, ground + Vec3(0, stature, 0));
  if (!feet || !head) return 1;
  const float tall = (feet->y - head->y) * static_cast<float>(shape.height);
  const float least = least_stature_mm * interface::measures_of(shape).mm;
  constexpr float shortest = 1, largest = 6;  // pixels; a museum that is a point on the glass
  return tall < shortest ? 1 : std::clamp(least / tall, 1.0F, largest);
}

float millimetres_to_figure(const scene::CameraView& camera, const interface::ScreenShape& shape,
                            Vec3 ground, scene::ScreenPoint at) noexcept {
  constexpr float half_width = 0.25F, away = 1e9F;  // of its height; millimetres
  const float scale = stature_scale(camera, shape, ground);
  const auto feet = scene::project(camera, ground);
  const auto head = scene::project(camera, ground + Vec3(0, scale * stature, 0));
  if (!feet || !head) return away;
  const auto width = static_cast<float>(shape.width), height = static_cast<float>(shape.height);
  const float mm = 1 / interface::measures_of(shape).mm;
  const glm::vec2 foot{feet->x * width * mm, feet->y * height * mm};
  const glm::vec2 up = glm::vec2{head->x * width * mm, head->y * height * mm} - foot;
  const glm::vec2 off = glm::vec2{at.x * width * mm, at.y * height * mm} - foot;
  const float square = std::max(glm::dot(up, up), 1e-6F);
  const float share = std::clamp(glm::dot(off, up) / square, 0.0F, 1.0F);
  return glm::length(off - share * up) - half_width * std::sqrt(square);
}

void enlarge_last(Vec3 ground, float scale, scene::DrawList& list) noexcept {
  if (scale == 1 || list.avatars.empty()) return;
  const auto larger = [&](Vec3 place) { return ground + scale * (place - ground); };
  scene::AvatarDraw& avatar = list.avatars.back();
  const Vec3 off = (1 - scale) * ground;
  Mat4 about(scale);
  about[3] = Vec4(off, 1);
  for (Mat4& matrix : std::span(list.palette).subspan(avatar.first_matrix)) matrix = about * matrix;
  for (Vec3& joint : std::span(list.joint).subspan(avatar.first_matrix)) joint = larger(joint);
  for (Vec3& foot : avatar.feet) foot = larger(foot);
  for (float& height : avatar.foot_height) height *= scale;
  avatar.centre = larger(avatar.centre);
  avatar.scale = scale;
}

}  // namespace docent::guide
