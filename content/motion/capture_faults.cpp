#include "content/motion/capture_faults.h"

#include <fmt/core.h>

#include <algorithm>

namespace docent {

std::vector<CaptureFault> find_capture_faults(const Skeleton& skeleton, const MotionClip& clip,
                                              const Track& track) {
  constexpr double impossible = 800;  // m/s2, for an adult
  const double seconds = 1 / clip.frame_rate;
  // At low rates the same acceleration is a large distance, but a joint never errs by less than
  // the noise of capture.
  const double limit = std::max(0.01, impossible * seconds * seconds) * size_of(skeleton);
  const std::uint32_t bridge = frames_in(0.1, clip.frame_rate);  // leaps this close are one fault

  std::vector<CaptureFault> faults;
  for (std::uint32_t f = 1; f + 1 < frame_count(clip); ++f) {
    CaptureFault here{.first = f, .last = f};
    for (std::size_t j = 0; j < track.joints; ++j) {
      const Vec3 course = 0.5f * (track.at(f - 1, j) + track.at(f + 1, j));
      const double off = 2 * glm::distance(track.at(f, j), course);
      if (off > here.metres) here.metres = off, here.joint = j;
    }
    if (here.metres < limit) continue;
    if (!faults.empty() && f - faults.back().last <= bridge) {
      CaptureFault& fault = faults.back();
      fault.last = f;
      if (here.metres > fault.metres) fault.metres = here.metres, fault.joint = here.joint;
    } else {
      faults.push_back(here);
    }
  }
  // A leap next to an end of the clip parts the end from the rest.
  for (CaptureFault& fault : faults) {
    if (fault.first <= bridge) fault.first = 0;
    if (fault.last + bridge >= frame_count(clip)) fault.last = frame_count(clip) - 1;
  }
  return faults;
}

std::string describe(const CaptureFault& fault, const Skeleton& skeleton) {
  return fmt::format("joint '{}' leaps by {:.0f} cm in frames {} to {}",
                     skeleton.joint[fault.joint].name, 100 * fault.metres, fault.first, fault.last);
}

}  // namespace docent
