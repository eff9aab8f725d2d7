#pragma once

#include <array>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

namespace docent::test {

/// A joint of a body made up for tests: an adult in metres, facing +z, left at +x.
struct SampleJoint {
  std::string name;
  int parent;
  glm::dvec3 offset;
  bool end_site = false;
};

/// 22 joints under CMU's names, and the ends of head, hands and feet.
std::vector<SampleJoint> sample_body();

/// How a BVH text of that body is written.
struct BvhStyle {
  double metres_per_unit = 1;
  std::string rotation_order = "ZYX";  ///< First channel first: R = Rz Ry Rx.
  std::string line_end = "\n";
  std::string after_channels{};  ///< Blanks before the line end, say.
  std::string comment{};         ///< A line put between hierarchy and motion.
  std::string frame_time = "0.0083333";
  bool positions_everywhere = false;  ///< Every joint has positions that repeat its offset.
  bool dummy_root = false;            ///< A fixed joint at the origin carries the hips.
};

/// One frame: the hips' place in metres and three angles a joint (degrees, about z, y and x).
struct SampleFrame {
  glm::dvec3 hips{0, 0.95, 0};
  std::vector<std::array<double, 3>> zyx;
};

SampleFrame standing_frame(const std::vector<SampleJoint>& body);

std::string bvh_text(const std::vector<SampleJoint>& body, const std::vector<SampleFrame>& frames,
                     const BvhStyle& style = {});

/// Where the joints are in a frame, by matrices written out by hand: an oracle for the importer.
std::vector<glm::dvec3> places_in(const std::vector<SampleJoint>& body, const SampleFrame& frame,
                                  const std::string& rotation_order = "ZYX");

}  // namespace docent::test
