#pragma once

#include <string>

namespace docent::test {

/// How a character that a test makes departs from the usual one: 1.7 m, a T-pose, Mixamo's names.
struct MadeCharacter {
  float legs = 1;         ///< Share of the usual leg's length.
  float girth = 1;        ///< Share of the usual trunk's width.
  float arm_down = 0;     ///< Degrees that the arms hang below the horizontal.
  float unit = 1;         ///< Metres in a unit of the file's joints, under a node that scales back.
  bool has_names = true;  ///< Without: only the shape tells the bones.
  bool faces_back = false;  ///< As VRM 0.x does, towards -z.
  bool is_vrm1 = false, is_vrm0 = false;
  int hair =
      0;  ///< Joints of a plait down the back of the head: nodes `first_hair` and on. At most 200.
  /// What VRMC_springBone (1.0) or secondaryAnimation (0.x) holds.
  std::string springs = R"({"springs":[{"joints":[]}]})";

  static constexpr int head = 4, first_hair = 21;  ///< Nodes of the file.
};

/// The bytes of a GLB: boxes round the bones, bound to one skin.
std::string make_glb(const MadeCharacter& made);

}  // namespace docent::test
