#include "content/motion/capture_faults.h"

#include <fmt/core.h>

#include <algorithm>

#include "content/import/motion/motion_file.h"
#include "content/motion/fill_gap.h"

namespace docent::motion::offline {
namespace {

/// The least leap that is a fault, in metres from one frame to the next.
double least_leap(const Skeleton& skeleton, double frame_rate) {
  constexpr double impossible = 800;  // m/s2, for an adult
  const double seconds = 1 / frame_rate;
  // At low rates the same acceleration is a large distance, but a joint never errs by less than
  // the noise of capture.
  return std::max(0.01, impossible * seconds * seconds) * size_of(skeleton);
}

/// Leaps this close, in frames, are one fault.
std::uint32_t bridge(const MotionClip& clip) {
  return frames_in(0.1, clip.frame_rate);
}

/// By how much a joint leaves its course in a frame that is not an end; metres.
double leap_of(const JointPositions& track, std::size_t frame, std::size_t joint) {
  const Vec3 course = 0.5f * (track.at(frame - 1, joint) + track.at(frame + 1, joint));
  return 2 * static_cast<double>(glm::distance(track.at(frame, joint), course));
}

/// The faults from the first to the last frame in which something leaps.
std::vector<CaptureFault> find_leaps(const Skeleton& skeleton, const MotionClip& clip,
                                     const JointPositions& track) {
  const double limit = least_leap(skeleton, clip.frame_rate);
  std::vector<CaptureFault> faults;
  for (std::uint32_t f = 1; f + 1 < frame_count(clip); ++f) {
    CaptureFault here{.first = f, .last = f};
    for (std::size_t j = 0; j < track.joints; ++j)
      if (const double off = leap_of(track, f, j); off > here.metres)
        here.metres = off, here.joint = j;
    if (here.metres < limit) continue;
    if (!faults.empty() && f - faults.back().last <= bridge(clip)) {
      CaptureFault& fault = faults.back();
      fault.last = f;
      if (here.metres > fault.metres) fault.metres = here.metres, fault.joint = here.joint;
    } else {
      faults.push_back(here);
    }
  }
  return faults;
}

/// The joints whose own rotation throws others: parents of the thrown that were not thrown
/// themselves. Entry 0 is also set where the whole body is thrown, which is then moved back.
struct Throwers {
  std::vector<bool> turns;
  bool body = false;
};

Throwers find_throwers(const Skeleton& skeleton, const CaptureFault& fault,
                       const JointPositions& track, double limit) {
  // What moves a quarter as far as the limit moves with what is thrown.
  std::vector<bool> thrown(track.joints);
  for (std::uint32_t f = fault.first; f <= fault.last; ++f)
    for (std::size_t j = 0; j < track.joints; ++j)
      if (leap_of(track, f, j) > 0.25 * limit) thrown[j] = true;
  Throwers throwers{.turns = std::vector<bool>(track.joints), .body = thrown[0]};
  for (std::size_t j = 1; j < track.joints; ++j)
    if (thrown[j]) throwers.turns[index_of(skeleton.joint[j].parent)] = true;
  return throwers;
}

void place_again(const Skeleton& skeleton, const MotionClip& clip, const Gap& gap,
                 JointPositions& track) {
  std::vector<Vec3> places;
  for (std::int64_t f = gap.first; f <= gap.last; ++f) {
    const auto frame = static_cast<std::size_t>(f);
    import::place_joints(skeleton, clip, frame, places);
    std::ranges::copy(places,
                      track.place.begin() + static_cast<std::ptrdiff_t>(frame * track.joints));
  }
}

/// Does anything leap in the frames of a gap, or where it meets the sound ones?
bool is_sound(const Gap& gap, const MotionClip& clip, const JointPositions& track, double limit) {
  const std::int64_t begin = std::max<std::int64_t>(gap.first - 1, 1);
  const std::int64_t end = std::min<std::int64_t>(gap.last + 2, frame_count(clip) - 1);
  for (std::int64_t f = begin; f < end; ++f)
    for (std::size_t j = 0; j < track.joints; ++j)
      if (leap_of(track, static_cast<std::size_t>(f), j) >= limit) return false;
  return true;
}

/// The frames of a gap, to be put back where mending fails.
struct Kept {
  std::vector<Vec3> root;
  std::vector<Quat> rotation;
};

Kept keep(const MotionClip& clip, const Gap& gap) {
  const auto joints = static_cast<std::int64_t>(clip.joint_count);
  return {{clip.root.begin() + gap.first, clip.root.begin() + gap.last + 1},
          {clip.rotation.begin() + gap.first * joints,
           clip.rotation.begin() + (gap.last + 1) * joints}};
}

void put_back(const Kept& kept, const Gap& gap, MotionClip& clip) {
  std::ranges::copy(kept.root, clip.root.begin() + gap.first);
  std::ranges::copy(kept.rotation, clip.rotation.begin() +
                                       gap.first * static_cast<std::int64_t>(clip.joint_count));
}

bool fill_gap(const Skeleton& skeleton, const CaptureFault& fault, const Gap& gap, MotionClip& clip,
              JointPositions& track) {
  const double limit = least_leap(skeleton, clip.frame_rate);
  if (gap.before < 0 && gap.after < 0) return false;
  const Throwers throwers = find_throwers(skeleton, fault, track, limit);
  const Kept kept = keep(clip, gap);
  const std::int64_t frames = frame_count(clip);
  if (throwers.body) fill(gap, Channel<Vec3>{.values = clip.root}, frames);
  for (std::size_t j = 0; j < throwers.turns.size(); ++j)
    if (throwers.turns[j])
      fill(gap, Channel<Quat>{.values = clip.rotation, .stride = clip.joint_count, .offset = j},
           frames);
  place_again(skeleton, clip, gap, track);
  if (is_sound(gap, clip, track, limit)) return true;
  put_back(kept, gap, clip);
  place_again(skeleton, clip, gap, track);
  return false;
}

/// The frames beside a fault may be a little wrong, too, and their speeds very much.
bool mend(const Skeleton& skeleton, const CaptureFault& fault, MotionClip& clip,
          JointPositions& track) {
  const std::int64_t most = frames_in(0.04, clip.frame_rate);
  for (std::int64_t more = 0; more <= most; ++more)
    if (fill_gap(skeleton, fault, gap_of(fault.first, fault.last, frame_count(clip), more), clip,
                 track))
      return true;
  return false;
}

}  // namespace

std::vector<CaptureFault> find_capture_faults(const Skeleton& skeleton, const MotionClip& clip,
                                              const JointPositions& track) {
  std::vector<CaptureFault> faults = find_leaps(skeleton, clip, track);
  for (CaptureFault& fault : faults) {
    if (fault.first <= bridge(clip)) fault.first = 0;
    if (fault.last + bridge(clip) >= frame_count(clip)) fault.last = frame_count(clip) - 1;
  }
  return faults;
}

std::vector<CaptureFault> mend_capture_faults(const Skeleton& skeleton, MotionClip& clip,
                                              JointPositions& track) {
  const std::uint32_t longest = frames_in(0.15, clip.frame_rate);
  std::vector<CaptureFault> mended;
  for (const CaptureFault& fault : find_leaps(skeleton, clip, track))
    if (fault.last - fault.first < longest && mend(skeleton, fault, clip, track))
      mended.push_back(fault);
  return mended;
}

std::string describe(const CaptureFault& fault, const Skeleton& skeleton) {
  const std::string frames = fault.first == fault.last
                                 ? fmt::format("frame {}", fault.first)
                                 : fmt::format("frames {} to {}", fault.first, fault.last);
  return fmt::format("joint '{}' leaps by {:.0f} cm in {}", skeleton.joint[fault.joint].name,
                     100 * fault.metres, frames);
}

}  // namespace docent::motion::offline
