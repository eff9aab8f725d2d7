#include "tests/content/import/motion/sample_body.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace docent::test {
namespace {

using DMat4 = glm::dmat4;

/// The matrix of a turn about an axis, from the textbook.
DMat4 turn(char axis, double degrees) {
  const double c = std::cos(degrees * std::numbers::pi / 180);
  const double s = std::sin(degrees * std::numbers::pi / 180);
  if (axis == 'X') return {1, 0, 0, 0, 0, c, s, 0, 0, -s, c, 0, 0, 0, 0, 1};
  if (axis == 'Y') return {c, 0, -s, 0, 0, 1, 0, 0, s, 0, c, 0, 0, 0, 0, 1};
  return {c, s, 0, 0, -s, c, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
}

DMat4 moved(glm::dvec3 by) {
  return {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, by.x, by.y, by.z, 1};
}

double angle_about(char axis, const std::array<double, 3>& zyx) {
  return zyx[static_cast<std::size_t>('Z' - axis)];
}

class BvhWriter {
 public:
  BvhWriter(const std::vector<SampleJoint>& body, const BvhStyle& style)
      : body_(body), style_(style) {}

  std::string write(const std::vector<SampleFrame>& frames) {
    line("HIERARCHY");
    if (style_.dummy_root) {
      line("ROOT reference");
      line("{");
      line("OFFSET 0 0 0");
      channels(true);
    }
    write_joint(0);
    if (style_.dummy_root) line("}");
    if (!style_.comment.empty()) line(style_.comment);
    line("MOTION");
    line(fmt::format("Frames: {}", frames.size()));
    line(fmt::format("Frame Time: {}", style_.frame_time));
    for (const SampleFrame& frame : frames) write_frame(frame);
    return text_;
  }

 private:
  void line(const std::string& words) { text_ += words + style_.line_end; }

  void channels(bool positions) {
    std::string words = positions ? "CHANNELS 6 Xposition Yposition Zposition" : "CHANNELS 3";
    for (const char axis : style_.rotation_order) words += fmt::format(" {}rotation", axis);
    line(words + style_.after_channels);
  }

  void write_joint(int joint) {
    const SampleJoint& own = body_[static_cast<std::size_t>(joint)];
    if (own.end_site)
      line("End Site");
    else
      line(joint == 0 && !style_.dummy_root ? "ROOT " + own.name : "JOINT " + own.name);
    line("{");
    const glm::dvec3 offset = own.offset / style_.metres_per_unit;
    line(fmt::format("OFFSET {:.9f} {:.9f} {:.9f}", offset.x, offset.y, offset.z));
    if (!own.end_site) channels(joint == 0 || style_.positions_everywhere);
    for (int child = joint + 1; child < static_cast<int>(body_.size()); ++child)
      if (body_[static_cast<std::size_t>(child)].parent == joint) write_joint(child);
    line("}");
  }

  void write_frame(const SampleFrame& frame) {
    std::string words;
    const auto put = [&](double value) { words += fmt::format("{:.9f} ", value); };
    if (style_.dummy_root) words += "0 0 0 0 0 0 ";
    for (std::size_t j = 0; j < body_.size(); ++j) {
      if (body_[j].end_site) continue;
      const glm::dvec3 place = (j == 0 ? frame.hips : body_[j].offset) / style_.metres_per_unit;
      if (j == 0 || style_.positions_everywhere) put(place.x), put(place.y), put(place.z);
      for (const char axis : style_.rotation_order) put(angle_about(axis, frame.zyx[j]));
    }
    line(words);
  }

  const std::vector<SampleJoint>& body_;
  BvhStyle style_;
  std::string text_;
};

}  // namespace

std::vector<SampleJoint> sample_body() {
  std::vector<SampleJoint> body{{"Hips", -1, {0, 0, 0}}};
  const auto add = [&](const std::string& name, int parent, glm::dvec3 offset, bool end = false) {
    body.push_back({name, parent, offset, end});
    return static_cast<int>(body.size()) - 1;
  };
  const auto leg = [&](const std::string& side, double x) {
    const int hip = add(side + "UpLeg", 0, {x, -0.08, 0});
    const int knee = add(side + "Leg", hip, {0, -0.41, 0});
    const int ankle = add(side + "Foot", knee, {0, -0.41, 0});
    const int toe = add(side + "ToeBase", ankle, {0, -0.06, 0.13});
    add("", toe, {0, 0, 0.06}, true);
  };
  leg("Left", 0.09);
  leg("Right", -0.09);
  const int spine = add("Spine", 0, {0, 0.12, 0});
  const int chest = add("Spine1", spine, {0, 0.2, 0});
  const int neck = add("Neck", chest, {0, 0.16, 0});
  const int head = add("Head", neck, {0, 0.1, 0});
  add("", head, {0, 0.2, 0}, true);
  const auto arm = [&](const std::string& side, double to) {
    const int clavicle = add(side + "Shoulder", chest, {0.03 * to, 0.12, 0});
    const int shoulder = add(side + "Arm", clavicle, {0.15 * to, 0, 0});
    const int elbow = add(side + "ForeArm", shoulder, {0.3 * to, 0, 0});
    const int wrist = add(side + "Hand", elbow, {0.26 * to, 0, 0});
    add("", wrist, {0.17 * to, 0, 0}, true);
  };
  arm("Left", 1);
  arm("Right", -1);
  return body;
}

SampleFrame standing_frame(const std::vector<SampleJoint>& body) {
  return {.zyx = std::vector<std::array<double, 3>>(body.size())};
}

std::string bvh_text(const std::vector<SampleJoint>& body, const std::vector<SampleFrame>& frames,
                     const BvhStyle& style) {
  return BvhWriter(body, style).write(frames);
}

std::vector<glm::dvec3> places_in(const std::vector<SampleJoint>& body, const SampleFrame& frame,
                                  const std::string& rotation_order) {
  std::vector<DMat4> world;
  std::vector<glm::dvec3> places;
  for (std::size_t j = 0; j < body.size(); ++j) {
    DMat4 local = moved(j == 0 ? frame.hips : body[j].offset);
    if (!body[j].end_site)
      for (const char axis : rotation_order)
        local = local * turn(axis, angle_about(axis, frame.zyx[j]));
    world.push_back(j == 0 ? local : world[static_cast<std::size_t>(body[j].parent)] * local);
    places.emplace_back(world.back()[3]);
  }
  return places;
}

}  // namespace docent::test
