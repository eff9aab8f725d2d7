#include "content/import/gltf/placing.h"

#include <algorithm>

namespace docent::import::gltf {

std::vector<Mat4> world_of_nodes(const Model& model) {
  std::vector<Mat4> world(model.nodes.size(), Mat4{1});
  for (const std::int32_t n : model.order) {
    const Node& node = model.nodes[entry(n)];
    world[entry(n)] = node.parent < 0 ? node.local : world[entry(node.parent)] * node.local;
  }
  return world;
}

Placing::Placing(const Model& model, const std::vector<Mat4>& world, std::int32_t node,
                 const Primitive& primitive)
    : primitive_{primitive}, rigid_{world[entry(node)]} {
  const std::int32_t skin = model.nodes[entry(node)].skin;
  if (skin < 0 || primitive.joint.empty()) return;
  const Skin& it = model.skins[entry(skin)];
  for (std::size_t j = 0; j < it.joints.size(); ++j)
    joint_.push_back(world[entry(it.joints[j])] * it.inverse_bind[j]);
}

Mat4 Placing::at(std::size_t vertex) const {
  if (joint_.empty()) return rigid_;
  Mat4 blend{0};
  for (std::size_t k = 0; k < 4; ++k)
    if (const float share = primitive_.weight[vertex][static_cast<int>(k)]; share > 0)
      blend +=
          share * joint_[std::min<std::size_t>(primitive_.joint[vertex][k], joint_.size() - 1)];
  return blend;
}

}  // namespace docent::import::gltf
