#include "content/motion/quantise.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "content/import/motion/motion_file.h"
#include "runtime/model/motion/motion_grid.h"

namespace docent::motion::offline {
namespace {

using namespace motion_grid;

/// Places are sums of floats, here as in the kiosk.
constexpr double rounding_margin = 0.01 * quantise_tolerance;

/// The part with which a rotation stays derived as long as no other must be: a part of less than a
/// half is steep, and makes large errors of small ones.
constexpr float least_derived = 0.5F;

Vec3 on_grid(Vec3 place) {
  const auto rounded = [](float metres) {
    const double steps = std::round(static_cast<double>(metres) * root_steps);
    return static_cast<float>(steps / root_steps + 0.0);  // no step from 0 is 0, never -0
  };
  return {rounded(place.x), rounded(place.y), rounded(place.z)};
}

/// The nearest rotation (of unit length) whose parts but the derived one lie on the grid.
Quat on_grid(const Quat& q, std::size_t derived, int bits) {
  const auto steps = static_cast<float>(steps_of(bits));
  RotationSteps rounded{};
  std::array<float, 4> part{};
  for (std::size_t i = 0; i < part.size(); ++i) {
    rounded[i] = std::lround(part_of(q, i) * steps);
    part[i] = part_at(rounded[i], bits);
  }
  const double size = derived_steps(rounded, derived, bits);
  part[derived] = derived_at(part_of(q, derived) < 0 ? -size : size, bits);
  return from_parts(part);
}

std::size_t largest_part(const Quat& q) {
  std::size_t largest = 3;
  for (std::size_t i = 0; i < 3; ++i)
    if (std::abs(part_of(q, i)) > std::abs(part_of(q, largest))) largest = i;
  return largest;
}

MotionClip on_grid(const MotionClip& clip, int bits) {
  MotionClip result = clip;
  for (Vec3& place : result.root) place = on_grid(place);
  for (std::size_t j = 0; j < clip.joint_count; ++j) {
    std::size_t derived = 3;
    for (std::size_t i = j; i < clip.rotation.size(); i += clip.joint_count) {
      const Quat& q = clip.rotation[i];
      if (std::abs(part_of(q, derived)) < least_derived) derived = largest_part(q);
      result.rotation[i] = on_grid(q, derived, bits);
    }
  }
  return result;
}

/// How far apart the two places of the joint are that differs most in a frame.
class Difference {
 public:
  Difference(const Skeleton& skeleton, const MotionClip& a, const MotionClip& b)
      : skeleton_(skeleton), a_(a), b_(b) {}

  double in_frame(std::size_t frame) {
    import::place_joints(skeleton_, a_, frame, place_a_);
    import::place_joints(skeleton_, b_, frame, place_b_);
    double largest = 0;
    for (std::size_t j = 0; j < place_a_.size(); ++j)
      largest = std::max<double>(largest, glm::distance(place_a_[j], place_b_[j]));
    return largest;
  }

 private:
  const Skeleton& skeleton_;
  const MotionClip& a_;
  const MotionClip& b_;
  std::vector<Vec3> place_a_, place_b_;
};

bool keeps_tolerance(const Skeleton& skeleton, const MotionClip& a, const MotionClip& b) {
  Difference difference(skeleton, a, b);
  for (std::size_t f = 0; f < a.root.size(); ++f)
    if (difference.in_frame(f) > quantise_tolerance - rounding_margin) return false;
  return true;
}

}  // namespace

void quantise(const Skeleton& skeleton, MotionClip& clip) {
  for (Quat& q : clip.rotation) q = glm::normalize(q);
  MotionClip result;
  for (int bits = least_bits; bits <= most_bits; ++bits) {
    result = on_grid(clip, bits);
    if (keeps_tolerance(skeleton, clip, result)) break;
  }
  clip = std::move(result);
}

double largest_difference(const Skeleton& skeleton, const MotionClip& a, const MotionClip& b) {
  Difference difference(skeleton, a, b);
  double largest = 0;
  for (std::size_t f = 0; f < a.root.size(); ++f)
    largest = std::max(largest, difference.in_frame(f));
  return largest;
}

}  // namespace docent::motion::offline
