#include "tests/content/character/made_character.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>
#include <vector>

#include "runtime/model/geometry/vec2.h"

namespace docent::test {
namespace {

struct MadeJoint {
  const char* mixamo;
  const char* vrm;
  int parent;
  Vec3 place;    ///< World, metres.
  Vec3 box_end;  ///< The box reaches from the joint to here...
  Vec3 half;     ///< ... this far to the sides.
};

std::vector<MadeJoint> joints_of(const MadeCharacter& made) {
  const float turn = made.arm_down * std::numbers::pi_v<float> / 180;
  const float hip = 0.9F * made.legs, c = std::cos(turn), s = std::sin(turn);
  const float knee = hip - 0.42F * made.legs, ankle = hip - 0.82F * made.legs;
  const float wide = 0.16F * made.girth;
  std::vector<MadeJoint> joints{
      {"Hips", "hips", -1, {0, hip + 0.05F, 0}, {0, hip + 0.15F, 0}, {wide, 0, 0.1F}},
      {"Spine", "spine", 0, {0, hip + 0.15F, 0}, {0, hip + 0.3F, 0}, {wide, 0, 0.1F}},
      {"Spine1", "chest", 1, {0, hip + 0.3F, 0}, {0, hip + 0.55F, 0}, {wide, 0, 0.1F}},
      {"Neck", "neck", 2, {0, hip + 0.55F, 0}, {0, hip + 0.62F, 0}, {0.05F, 0, 0.05F}},
      {"Head", "head", 3, {0, hip + 0.62F, 0.01F}, {0, hip + 0.8F, 0.01F}, {0.08F, 0, 0.1F}}};
  for (const float x : {1.0F, -1.0F}) {
    const bool left = x > 0;
    const auto along = [&](float out) {
      return Vec3{x * (0.18F + out * c), hip + 0.5F - out * s, 0};
    };
    const int first = static_cast<int>(joints.size());
    const Vec3 thin{0.05F, 0.05F, 0.05F};
    joints.push_back({left ? "LeftShoulder" : "RightShoulder",
                      left ? "leftShoulder" : "rightShoulder",
                      2,
                      {x * 0.04F, hip + 0.49F, 0},
                      along(0),
                      thin});
    joints.push_back({left ? "LeftArm" : "RightArm", left ? "leftUpperArm" : "rightUpperArm", first,
                      along(0), along(0.28F), thin});
    joints.push_back({left ? "LeftForeArm" : "RightForeArm",
                      left ? "leftLowerArm" : "rightLowerArm", first + 1, along(0.28F),
                      along(0.52F), 0.8F * thin});
    joints.push_back({left ? "LeftHand" : "RightHand", left ? "leftHand" : "rightHand", first + 2,
                      along(0.52F), along(0.68F), 0.7F * thin});
    joints.push_back({left ? "LeftUpLeg" : "RightUpLeg",
                      left ? "leftUpperLeg" : "rightUpperLeg",
                      0,
                      {x * 0.09F, hip, 0},
                      {x * 0.09F, knee, 0},
                      {0.07F, 0, 0.07F}});
    joints.push_back({left ? "LeftLeg" : "RightLeg",
                      left ? "leftLowerLeg" : "rightLowerLeg",
                      first + 4,
                      {x * 0.09F, knee, 0},
                      {x * 0.09F, ankle, 0},
                      {0.05F, 0, 0.05F}});
    joints.push_back({left ? "LeftFoot" : "RightFoot",
                      left ? "leftFoot" : "rightFoot",
                      first + 5,
                      {x * 0.09F, ankle, 0},
                      {x * 0.09F, 0, 0.12F},
                      {0.045F, 0, 0.03F}});
    joints.push_back({left ? "LeftToeBase" : "RightToeBase",
                      left ? "leftToes" : "rightToes",
                      first + 6,
                      {x * 0.09F, 0.02F, 0.12F},
                      {x * 0.09F, 0, 0.2F},
                      {0.045F, 0.01F, 0.01F}});
  }
  const float plait = made.hair <= 4 ? 0.11F : 1.2F / static_cast<float>(made.hair);
  for (int k = 0; k < made.hair; ++k) {
    const Vec3 root{0, hip + 0.78F - plait * static_cast<float>(k), -0.12F};
    joints.push_back({"Plait",
                      nullptr,
                      k == 0 ? MadeCharacter::head : MadeCharacter::first_hair + k - 1,
                      root,
                      root - Vec3{0, plait, 0},
                      {0.02F, 0, 0.02F}});
  }
  return joints;
}

/// Bytes that grow, and the views and accessors into them.
struct Bytes {
  std::string data, views, accessors;
  int count = 0;

  template <typename Number>
  void add(const std::vector<Number>& numbers, std::size_t elements, int component,
           const char* type) {
    const std::size_t at = data.size();
    data.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number));
    while (data.size() % 4 != 0) data += '\0';
    views += fmt::format("{}{{\"buffer\":0,\"byteOffset\":{},\"byteLength\":{}}}",
                         count == 0 ? "" : ",", at, numbers.size() * sizeof(Number));
    accessors +=
        fmt::format("{}{{\"bufferView\":{},\"componentType\":{},\"count\":{},\"type\":\"{}\"}}",
                    count == 0 ? "" : ",", count, component, elements, type);
    ++count;
  }
};

void append(std::string& out, std::uint32_t value) {
  char bytes[4];
  std::memcpy(bytes, &value, 4);
  out.append(bytes, 4);
}

}  // namespace

std::string make_glb(const MadeCharacter& made) {
  const std::vector<MadeJoint> joints = joints_of(made);
  std::vector<float> position, weight, inverse_bind;
  std::vector<std::uint8_t> bound;
  std::vector<std::uint16_t> index;
  const auto out = [&](Vec3 p) {
    return (made.faces_back ? Vec3{-p.x, p.y, -p.z} : p) / made.unit;
  };
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const Vec3 low = glm::min(joints[j].place, joints[j].box_end) - joints[j].half;
    const Vec3 high = glm::max(joints[j].place, joints[j].box_end) + joints[j].half;
    const auto first = static_cast<std::uint16_t>(position.size() / 3);
    for (int corner = 0; corner < 8; ++corner) {
      Vec3 p{(corner & 1) != 0 ? high.x : low.x, (corner & 2) != 0 ? high.y : low.y,
             (corner & 4) != 0 ? high.z : low.z};
      p.y = std::max(p.y, 0.0F);
      p = out(p);
      position.insert(position.end(), {p.x, p.y, p.z});
      bound.insert(bound.end(), {static_cast<std::uint8_t>(j), 0, 0, 0});
      weight.insert(weight.end(), {1, 0, 0, 0});
    }
    for (const int i : {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                        2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5})
      index.push_back(static_cast<std::uint16_t>(first + i));
    const Vec3 at = out(joints[j].place);
    inverse_bind.insert(inverse_bind.end(),
                        {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -at.x, -at.y, -at.z, 1});
  }
  Bytes bytes;
  bytes.add(position, position.size() / 3, 5126, "VEC3");
  bytes.add(bound, bound.size() / 4, 5121, "VEC4");
  bytes.add(weight, weight.size() / 4, 5126, "VEC4");
  bytes.add(index, index.size(), 5123, "SCALAR");
  bytes.add(inverse_bind, joints.size(), 5126, "MAT4");

  std::string nodes, list, bones1, bones0;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    std::string children;
    for (std::size_t c = 0; c < joints.size(); ++c)
      if (joints[c].parent == static_cast<int>(j))
        children += fmt::format("{}{}", children.empty() ? "" : ",", c);
    const Vec3 above =
        joints[j].parent < 0 ? Vec3{0} : joints[static_cast<std::size_t>(joints[j].parent)].place;
    const Vec3 off = out(joints[j].place) - out(above);
    nodes +=
        fmt::format("{}{{{}\"translation\":[{},{},{}]{}}}", j == 0 ? "" : ",",
                    made.has_names ? fmt::format("\"name\":\"mixamorig:{}\",", joints[j].mixamo)
                                   : std::string(),
                    off.x, off.y, off.z,
                    children.empty() ? std::string() : fmt::format(",\"children\":[{}]", children));
    list += fmt::format("{}{}", j == 0 ? "" : ",", j);
    if (joints[j].vrm == nullptr) continue;
    bones1 += fmt::format("{}\"{}\":{{\"node\":{}}}", j == 0 ? "" : ",", joints[j].vrm, j);
    bones0 += fmt::format("{}{{\"bone\":\"{}\",\"node\":{}}}", j == 0 ? "" : ",", joints[j].vrm, j);
  }
  const auto mesh = joints.size(), armature = joints.size() + 1;
  nodes += fmt::format(",{{\"mesh\":0,\"skin\":0}},{{\"children\":[0,{}],\"scale\":[{},{},{}]}}",
                       mesh, made.unit, made.unit, made.unit);
  std::string extensions;
  if (made.is_vrm1)
    extensions = fmt::format(
        R"("extensions":{{"VRMC_vrm":{{"specVersion":"1.0","humanoid":{{"humanBones":{{{}}}}},)"
        R"("expressions":{{"preset":{{"blink":{{}},"happy":{{}}}}}}}},)"
        R"("VRMC_springBone":{}}},)",
        bones1, made.springs);
  if (made.is_vrm0)
    extensions =
        fmt::format(R"("extensions":{{"VRM":{{"humanoid":{{"humanBones":[{}]}},"blendShapeMaster":)"
                    R"({{"blendShapeGroups":[{{"name":"Blink","presetName":"blink"}}]}},)"
                    R"("secondaryAnimation":{}}}}},)",
                    bones0, made.springs);
  std::string json = fmt::format(
      R"({{"asset":{{"version":"2.0"}},{}"scene":0,"scenes":[{{"nodes":[{}]}}],"nodes":[{}],)"
      R"("skins":[{{"joints":[{}],"inverseBindMatrices":4}}],"materials":[{{"pbrMetallicRoughness":)"
      R"({{"baseColorFactor":[0.2,0.4,0.8,1]}}}}],"meshes":[{{"primitives":[{{"attributes":)"
      R"({{"POSITION":0,"JOINTS_0":1,"WEIGHTS_0":2}},"indices":3,"material":0}}]}}],)"
      R"("buffers":[{{"byteLength":{}}}],"bufferViews":[{}],"accessors":[{}]}})",
      extensions, armature, nodes, list, bytes.data.size(), bytes.views, bytes.accessors);
  while (json.size() % 4 != 0) json += ' ';

  std::string glb = "glTF";
  append(glb, 2);
  append(glb, static_cast<std::uint32_t>(28 + json.size() + bytes.data.size()));
  append(glb, static_cast<std::uint32_t>(json.size()));
  append(glb, 0x4E4F534A);
  glb += json;
  append(glb, static_cast<std::uint32_t>(bytes.data.size()));
  append(glb, 0x004E4942);
  return glb + bytes.data;
}

}  // namespace docent::test
