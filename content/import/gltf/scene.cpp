#include "content/import/gltf/scene.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>

#include "content/import/gltf/accessor.h"

namespace docent::import::gltf {
namespace {

Mat4 transform_of(const Part& node, Source& source) {
  constexpr float farthest = 1e6F;
  if (const Part matrix = node["matrix"]; matrix.is_there()) {
    if (matrix.size() != 16) matrix.fail("must have sixteen numbers");
    std::array<float, 16> number{};
    for (std::size_t i = 0; i < 16; ++i) {
      number[i] = matrix.at(i).number();
      if (std::abs(number[i]) > farthest) matrix.fail("is too large");
    }
    return glm::make_mat4(number.data());
  }
  const Vec3 place = node["translation"].vec3_or(Vec3{0});
  const Vec4 turn = node["rotation"].vec4_or({0, 0, 0, 1});
  const Vec3 scale = node["scale"].vec3_or(Vec3{1});
  for (int i = 0; i < 3; ++i)
    if (std::abs(place[i]) > farthest || std::abs(scale[i]) > farthest)
      node.fail("is moved or scaled too far");
  if (scale.x == 0 || scale.y == 0 || scale.z == 0)
    source.warn(fmt::format("{}.scale is 0 along an axis: what hangs on it is flat", node.name()));
  const float length = std::sqrt(glm::dot(turn, turn));
  Quat rotation{1, 0, 0, 0};
  if (length > 1e-6F && std::isfinite(length))
    rotation = Quat{turn.w / length, turn.x / length, turn.y / length, turn.z / length};
  else
    source.warn(fmt::format("{}.rotation is no rotation; it is left out", node.name()));
  Mat4 matrix = glm::mat4_cast(rotation);
  for (int i = 0; i < 3; ++i) matrix[i] *= scale[i];
  matrix[3] = Vec4(place, 1);
  return matrix;
}

void read_nodes(Source& source, Model& model) {
  const Part nodes = source.root()["nodes"];
  if (nodes.size() > most_nodes)
    nodes.fail(fmt::format("has {} entries; at most {} can be read", nodes.size(), most_nodes));
  const std::size_t meshes = source.root()["meshes"].size();
  const std::size_t skins = source.root()["skins"].size();
  model.nodes.resize(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Part part = nodes.at(i);
    Node& node = model.nodes[i];
    node.name = plain_name(part["name"].text_or(""));
    node.local = transform_of(part, source);
    node.mesh = part["mesh"].index_or_none(meshes, "mesh");
    node.skin = part["skin"].index_or_none(skins, "skin");
    const Part children = part["children"];
    for (std::size_t c = 0; c < children.size(); ++c) {
      const Part child = children.at(c);
      const auto index = static_cast<std::size_t>(child.index_or_none(nodes.size(), "node"));
      if (model.nodes[index].parent != none)
        child.fail(fmt::format("names node {}, which hangs on node {} already", index,
                               model.nodes[index].parent));
      model.nodes[index].parent = static_cast<std::int32_t>(i);
      node.children.push_back(static_cast<std::int32_t>(index));
    }
  }
}

/// All below and with these, parents first.
std::vector<std::int32_t> below(const Model& model, std::vector<std::int32_t> first) {
  for (std::size_t i = 0; i < first.size(); ++i) {
    const std::vector<std::int32_t>& children =
        model.nodes[static_cast<std::size_t>(first[i])].children;
    first.insert(first.end(), children.begin(), children.end());
  }
  return first;
}

void put_in_order(Source& source, Model& model) {
  std::vector<std::int32_t> roots;
  for (std::size_t i = 0; i < model.nodes.size(); ++i)
    if (model.nodes[i].parent == none) roots.push_back(static_cast<std::int32_t>(i));
  model.order = below(model, std::move(roots));
  if (model.order.size() == model.nodes.size()) return;
  std::vector<bool> is_reached(model.nodes.size());
  for (const std::int32_t i : model.order) is_reached[static_cast<std::size_t>(i)] = true;
  const auto lost =
      static_cast<std::size_t>(std::ranges::find(is_reached, false) - is_reached.begin());
  source.root()["nodes"].at(lost).fail("hangs on itself: nodes form a ring");
}

void mark_scene(Source& source, Model& model) {
  const Part scenes = source.root()["scenes"];
  if (scenes.size() == 0) {
    for (Node& node : model.nodes) node.in_scene = true;
    return;
  }
  const Part chosen = source.root()["scene"];
  const auto index =
      static_cast<std::size_t>(std::max(chosen.index_or_none(scenes.size(), "scene"), 0));
  const Part roots = scenes.at(index)["nodes"];
  std::vector<std::int32_t> shown;
  for (std::size_t i = 0; i < roots.size(); ++i) {
    const std::int32_t root = roots.at(i).index_or_none(model.nodes.size(), "node");
    Node& node = model.nodes[static_cast<std::size_t>(root)];
    if (node.in_scene) continue;
    node.in_scene = true;
    shown.push_back(root);
  }
  for (std::size_t i = 0; i < shown.size(); ++i)
    for (const std::int32_t child : model.nodes[static_cast<std::size_t>(shown[i])].children) {
      Node& node = model.nodes[static_cast<std::size_t>(child)];
      if (node.in_scene) continue;
      node.in_scene = true;
      shown.push_back(child);
    }
}

void read_skins(Source& source, Model& model) {
  const Part skins = source.root()["skins"];
  if (skins.size() > most_nodes) skins.fail("has too many entries");
  std::size_t total = 0;
  for (std::size_t i = 0; i < skins.size(); ++i) {
    const Part part = skins.at(i), joints = part["joints"];
    if (joints.size() == 0) joints.fail("is empty");
    total += joints.size();
    if (total > 10 * most_nodes) skins.fail("have too many joints in all");
    Skin skin;
    for (std::size_t j = 0; j < joints.size(); ++j)
      skin.joints.push_back(joints.at(j).index_or_none(model.nodes.size(), "node"));
    skin.inverse_bind.assign(skin.joints.size(), Mat4{1});
    if (const Part matrices = part["inverseBindMatrices"]; matrices.is_there()) {
      const Numbers numbers = read_numbers(source, matrices.whole(0, UINT32_MAX), matrices);
      if (numbers.components != 16) matrices.fail("must be of type MAT4");
      if (numbers.count < skin.joints.size())
        matrices.fail(
            fmt::format("has {} matrices for {} joints", numbers.count, skin.joints.size()));
      for (std::size_t j = 0; j < skin.joints.size(); ++j)
        skin.inverse_bind[j] = glm::make_mat4(numbers.value.data() + 16 * j);
    }
    model.skins.push_back(std::move(skin));
  }
}

}  // namespace

void read_scene(Source& source, Model& model) {
  read_nodes(source, model);
  put_in_order(source, model);
  mark_scene(source, model);
  read_skins(source, model);
}

}  // namespace docent::import::gltf
