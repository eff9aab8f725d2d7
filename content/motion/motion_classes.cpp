#include "content/motion/motion_classes.h"

#include <algorithm>

#include "content/motion/gait_cycle.h"

namespace docent::motion::offline {
namespace {

constexpr std::size_t most_strides = 100;  // each is compared with each

GaitCycle basic_gait_of(const MotionClass& motion_class, const Skeleton& skeleton,
                        std::span<const MotionClip> clips) {
  std::vector<GaitCycle> strides;
  for (const MotionClip& clip : clips) {
    if (clip.motion_class != motion_class.name || strides.size() >= most_strides) continue;
    const auto more = find_gait_cycles(skeleton, clip, joint_positions(skeleton, clip));
    strides.insert(strides.end(), more.begin(), more.end());
  }
  return strides.empty() ? GaitCycle{} : strides[basic_gait(strides)];
}

}  // namespace

std::vector<MotionClass> find_motion_classes(const Skeleton& skeleton,
                                             std::span<const MotionClip> clips) {
  std::vector<MotionClass> classes;
  for (const MotionClip& clip : clips)
    if (std::ranges::find(classes, clip.motion_class, &MotionClass::name) == classes.end())
      classes.push_back({.name = clip.motion_class, .coefficient = {}});

  std::vector<GaitCycle> gaits;
  for (MotionClass& motion_class : classes) {
    gaits.push_back(basic_gait_of(motion_class, skeleton, clips));
    motion_class.coefficient.resize(classes.size());
  }
  for (std::size_t i = 0; i < classes.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      classes[i].coefficient[j] = classes[j].coefficient[i] = static_cast<float>(
          std::max(unlikeness(gaits[i], gaits[j]), unlikeness(gaits[j], gaits[i])));
  return classes;
}

}  // namespace docent::motion::offline
