#include "content/character/sheet.h"

#include <algorithm>
#include <numbers>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include "content/avatar/stance.h"
#include "content/character/paint.h"
#include "runtime/motion/cloth.h"

namespace docent::character {
namespace {

constexpr float width = 1600, row = 620;

/// What swings has swung for so many seconds since the last palette, or hangs still.
std::vector<Mat4> palette_of(const std::vector<Mat4>& world, const SkinnedMesh& body,
                             double seconds, motion::ClothMotion& cloth) {
  std::vector<Mat4> palette;
  for (std::size_t j = 0; j < std::min(world.size(), body.inverse_bind.size()); ++j)
    palette.push_back(world[j] * body.inverse_bind[j]);
  palette.resize(matrices_of(body), Mat4{1});
  motion::swing({body.cloth.node, body.cloth.collider}, seconds, palette, cloth);
  return palette;
}

std::vector<Mat4> worlds_at(const Skeleton& skeleton, const MotionClip& clip, std::size_t frame) {
  std::vector<Mat4> world;
  for (std::size_t j = 0; j < skeleton.joint.size(); ++j) {
    const Joint& joint = skeleton.joint[j];
    const Mat4 turn = glm::mat4_cast(clip.rotation[frame * clip.joint_count + j]);
    world.push_back(joint.parent == JointIndex::None
                        ? glm::translate(Mat4{1}, clip.root[frame]) * turn
                        : world[docent::index_of(joint.parent)] *
                              glm::translate(Mat4{1}, joint.offset) * turn);
  }
  return world;
}

/// Where the body faces, radians about the vertical from +z.
float facing_of(const Mat4& hips) {
  return std::atan2(hips[2].x, hips[2].z);
}

}  // namespace

Pixels draw_sheet(const Skeleton& skeleton, const SkinnedMesh& body, const MotionClip& walk) {
  Painting painting(static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(2 * row));
  float top = 1.2F;
  for (const SkinnedVertex& v : body.vertices) top = std::max(top, v.position.y);
  const float scale = 0.86F * row / (top + 0.1F);

  motion::ClothMotion cloth = motion::make_cloth_motion(body.cloth.node.size());
  const std::vector<Mat4> standing =
      palette_of(avatar::stand_at_ease(skeleton).world, body, 0, cloth);
  constexpr int views = 5;
  for (int i = 0; i < views; ++i)
    painting.add(body, standing,
                 {.x = width * (static_cast<float>(i) + 0.5F) / views,
                  .floor = 0.94F * row,
                  .scale = scale,
                  .yaw = static_cast<float>(i) * 0.4F * std::numbers::pi_v<float>});

  constexpr int steps = 6;
  const std::size_t frames = walk.root.size();
  const auto stride = static_cast<std::size_t>(std::max(1.2 * walk.frame_rate, 1.0));
  std::size_t next = 0;
  std::vector<Mat4> world, palette;
  for (int i = 0; i < steps && frames > 0; ++i) {
    const std::size_t frame =
        std::min(frames - 1, frames / 3 + static_cast<std::size_t>(i) * stride / steps);
    for (; next <= frame; ++next) {
      world = worlds_at(skeleton, walk, next);
      palette = palette_of(world, body, 1 / walk.frame_rate, cloth);
    }
    painting.add(body, palette,
                 {.x = width * (static_cast<float>(i) + 0.5F) / steps,
                  .floor = 1.94F * row,
                  .scale = scale,
                  .yaw = facing_of(world.front()) + 0.9F,
                  .middle = Vec3(world.front()[3])});
  }
  return painting.picture();
}

}  // namespace docent::character
