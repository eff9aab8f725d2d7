#include "tests/content/avatar/posed_body.h"

#include <glm/gtc/matrix_transform.hpp>

namespace docent::test {

PosedBody::PosedBody(const SkinnedMesh& mesh, const Skeleton& skeleton)
    : mesh_{mesh},
      skeleton_{skeleton},
      palette_(skeleton.joint.size() + of_figure(mesh.cloth.node, 0).size()),
      cloth_{motion::make_cloth_motion(of_figure(mesh.cloth.node, 0).size())} {}

motion::ClothView PosedBody::view() const {
  return {of_figure(mesh_.cloth.node, 0), of_figure(mesh_.cloth.collider, 0)};
}

void PosedBody::pose(const MotionClip& clip, std::size_t frame) {
  std::vector<Mat4> world;
  for (std::size_t j = 0; j < skeleton_.joint.size(); ++j) {
    const Mat4 turn = glm::mat4_cast(clip.rotation[frame * clip.joint_count + j]);
    const Joint& joint = skeleton_.joint[j];
    world.push_back(joint.parent == JointIndex::None
                        ? glm::translate(Mat4(1.0F), clip.root[frame]) * turn
                        : world[index_of(joint.parent)] * glm::translate(Mat4(1.0F), joint.offset) *
                              turn);
    palette_[j] = world[j] * mesh_.inverse_bind[j];
  }
}

void PosedBody::hang(const MotionClip& clip, std::size_t frame) {
  pose(clip, frame);
  motion::hang(view(), palette_, cloth_);
}

void PosedBody::swing(const MotionClip& clip, std::size_t frame, double seconds) {
  pose(clip, frame);
  motion::swing(view(), seconds, palette_, cloth_);
}

Vec3 PosedBody::place_of(const SkinnedVertex& vertex) const {
  Vec4 place{0};
  for (std::size_t k = 0; k < 4; ++k)
    place += static_cast<float>(vertex.weight[k]) / 255.0F *
             (palette_[vertex.joint[k]] * Vec4(vertex.position, 1));
  return Vec3(place);
}

std::vector<Vec3> PosedBody::places() const {
  std::vector<Vec3> places;
  for (const SkinnedVertex& vertex : mesh_.vertices) places.push_back(place_of(vertex));
  return places;
}

}  // namespace docent::test
