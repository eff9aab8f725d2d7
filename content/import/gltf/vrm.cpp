#include <algorithm>
#include <string_view>

#include "content/import/gltf/scene.h"
#include "content/import/gltf/springs.h"

namespace docent::import::gltf {
namespace {

/// The names of thumbs moved by one joint between VRM 0.x and 1.0.
std::string bone_of_1_0(std::string bone) {
  const auto replace = [&](std::string_view old_name, std::string_view new_name) {
    if (const std::size_t at = bone.find(old_name); at != std::string::npos)
      bone.replace(at, old_name.size(), new_name);
  };
  if (bone.ends_with("ThumbProximal"))
    replace("ThumbProximal", "ThumbMetacarpal");
  else if (bone.ends_with("ThumbIntermediate"))
    replace("ThumbIntermediate", "ThumbProximal");
  return bone;
}

Vrm vrm_1_0(const Part& part, std::size_t nodes) {
  Vrm vrm{.version = "1.0", .bones = {}, .expressions = {}};
  const Part bones = part["humanoid"]["humanBones"];
  for (const std::string& bone : bones.keys())
    vrm.bones.push_back({bone, bones[bone]["node"].index_or_none(nodes, "node")});
  if (const Part expressions = part["expressions"]; expressions.is_there())
    for (const char* kind : {"preset", "custom"})
      for (const std::string& name : expressions[kind].keys())
        vrm.expressions.push_back(plain_name(name));
  return vrm;
}

Vrm vrm_0(const Part& part, std::size_t nodes) {
  Vrm vrm{.version = "0.x", .bones = {}, .expressions = {}};
  const Part bones = part["humanoid"]["humanBones"];
  for (std::size_t i = 0; i < bones.size(); ++i) {
    const Part bone = bones.at(i);
    const Part node = bone["node"];
    if (!node.is_there()) continue;
    vrm.bones.push_back(
        {bone_of_1_0(plain_name(bone["bone"].text())), node.index_or_none(nodes, "node")});
  }
  if (const Part master = part["blendShapeMaster"]; master.is_there()) {
    const Part groups = master["blendShapeGroups"];
    for (std::size_t i = 0; i < groups.size(); ++i) {
      const std::string preset = groups.at(i)["presetName"].text_or("unknown");
      vrm.expressions.push_back(plain_name(
          preset == "unknown" || preset.empty() ? groups.at(i)["name"].text_or("") : preset));
    }
  }
  return vrm;
}

}  // namespace

Vrm read_vrm(Source& source, std::size_t nodes) {
  const Part extensions = source.root()["extensions"];
  if (!extensions.is_there()) return {};
  Vrm vrm;
  if (const Part part = extensions["VRMC_vrm"]; part.is_there()) {
    vrm = vrm_1_0(part, nodes);
    read_springs_1_0(source, extensions["VRMC_springBone"], nodes, vrm);
  } else if (const Part old = extensions["VRM"]; old.is_there()) {
    vrm = vrm_0(old, nodes);
    read_springs_0(source, old["secondaryAnimation"], nodes, vrm);
  }
  return vrm;
}

}  // namespace docent::import::gltf
