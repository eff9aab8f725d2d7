#include "content/import/motion/bvh_write.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <fstream>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>
#include <vector>

#include "content/content_error.h"
#include "content/import/motion/body.h"

namespace docent::import {
namespace {

using Text = fmt::memory_buffer;

std::string indent(std::size_t depth) {
  return std::string(depth, '\t');
}

/// An end site holds an offset and nothing else.
bool is_end_site(const Skeleton& skeleton, std::size_t joint) {
  return joint != 0 && !skeleton.has_rotation[joint];
}

/// Writes joint, children and braces, and notes in `order` the joints as their channels come.
void write_joint(const Skeleton& skeleton, const std::vector<std::vector<std::size_t>>& children,
                 std::size_t joint, std::size_t depth, Text& text,
                 std::vector<std::size_t>& order) {
  auto out = fmt::appender(text);
  const std::string tabs = indent(depth);
  const Joint& own = skeleton.joint[joint];
  if (is_end_site(skeleton, joint))
    fmt::format_to(out, "{}End Site\n{}{{\n", tabs, tabs);
  else
    fmt::format_to(out, "{}{} {}\n{}{{\n", tabs, joint == 0 ? "ROOT" : "JOINT", own.name, tabs);
  const Vec3 offset = joint == 0 ? Vec3{} : own.offset;
  fmt::format_to(out, "{}\tOFFSET {:.6f} {:.6f} {:.6f}\n", tabs, offset.x, offset.y, offset.z);
  if (!is_end_site(skeleton, joint)) {
    order.push_back(joint);
    fmt::format_to(out, "{}\tCHANNELS {} Zrotation Yrotation Xrotation\n", tabs,
                   joint == 0 ? "6 Xposition Yposition Zposition" : "3");
    for (const std::size_t child : children[joint])
      write_joint(skeleton, children, child, depth + 1, text, order);
  }
  fmt::format_to(out, "{}}}\n", tabs);
}

/// Turns about z, y and x, in degrees: R = Rz Ry Rx.
using EulerZyx = std::array<double, 3>;

/// The whole turns that bring an angle closest to another.
double nearest_turn(double angle, double to) {
  return angle + 360 * std::round((to - angle) / 360);
}

/// Of the many ways to write a rotation, the one closest to the frame before.
EulerZyx euler_zyx(const Quat& rotation, const EulerZyx& before) {
  constexpr double degrees = 180 / std::numbers::pi;
  const glm::dmat3 r = glm::mat3_cast(glm::normalize(glm::dquat(rotation)));  // r[column][row]
  const double cos_y = std::hypot(r[0][0], r[0][1]);
  const double y = std::atan2(-r[0][2], cos_y);
  if (cos_y < 1e-7) {  // z and x turn about the same line; leave z where it was
    const double z = before[0] / degrees;
    const double sum = std::atan2(-r[1][0], r[1][1]);  // z - x where y is up, z + x where down
    const double x = y > 0 ? z - sum : sum - z;
    return {before[0], y * degrees, nearest_turn(x * degrees, before[2])};
  }
  const double z = std::atan2(r[0][1], r[0][0]) * degrees;
  const double x = std::atan2(r[1][2], r[2][2]) * degrees;
  const auto placed = [&](double az, double ay, double ax) {
    return EulerZyx{nearest_turn(az, before[0]), nearest_turn(ay, before[1]),
                    nearest_turn(ax, before[2])};
  };
  const auto distance = [&](const EulerZyx& e) {
    return std::abs(e[0] - before[0]) + std::abs(e[1] - before[1]) + std::abs(e[2] - before[2]);
  };
  const EulerZyx one = placed(z, y * degrees, x),
                 other = placed(z + 180, 180 - y * degrees, x + 180);
  return distance(other) < distance(one) ? other : one;
}

void write_frames(const Skeleton& skeleton, const MotionFrames& motion,
                  const std::vector<std::size_t>& order, Text& text) {
  auto out = fmt::appender(text);
  const std::size_t joints = skeleton.joint.size();
  std::vector<EulerZyx> angles(joints);
  for (std::size_t f = 0; f < motion.root.size(); ++f) {
    const Vec3 root = motion.root[f];
    fmt::format_to(out, "{:.6f} {:.6f} {:.6f}", root.x, root.y, root.z);
    for (const std::size_t j : order) {
      angles[j] = euler_zyx(motion.rotation[f * joints + j], angles[j]);
      for (const double angle : angles[j])
        fmt::format_to(out, " {:.6f}", std::abs(angle) < 5e-7 ? 0.0 : angle);
    }
    text.push_back('\n');
  }
}

}  // namespace

std::string to_bvh(const Skeleton& skeleton, const MotionFrames& motion) {
  Text text;
  std::vector<std::size_t> order;
  fmt::format_to(fmt::appender(text), "HIERARCHY\n");
  write_joint(skeleton, children_of(skeleton), 0, 0, text, order);
  fmt::format_to(fmt::appender(text), "MOTION\nFrames: {}\nFrame Time: {:.9f}\n",
                 motion.root.size(), 1 / motion.frame_rate);
  write_frames(skeleton, motion, order, text);
  return fmt::to_string(text);
}

void write_bvh(const Skeleton& skeleton, const MotionFrames& motion,
               const std::filesystem::path& path) {
  const std::string text = to_bvh(skeleton, motion);
  std::filesystem::path unfinished = path;
  unfinished += ".part";
  std::ofstream out(unfinished, std::ios::binary | std::ios::trunc);
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
  out.close();
  std::error_code failure;
  if (out) std::filesystem::rename(unfinished, path, failure);
  if (out && !failure) return;
  std::error_code ignored;
  std::filesystem::remove(unfinished, ignored);
  throw content::ContentError(
      Errc::Environment, path.string(), "cannot-write", "the motion cannot be written here",
      "check that the folder exists, that you may write to it and that the disk is "
      "not full");
}

}  // namespace docent::import
