#include "content/motion/capture_faults.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "content/import/motion/motion_file.h"
#include "content/motion/fill_gap.h"

namespace docent::motion::offline {
namespace {

/// The joints from the head down to the root: what carries them is heavy.
std::vector<bool> trunk_of(const Skeleton& skeleton) {
  std::vector<bool> trunk(skeleton.joint.size());
  for (JointIndex j = skeleton[BodyPart::HeadTop] == JointIndex::None ? skeleton[BodyPart::Head]
                                                                      : skeleton[BodyPart::HeadTop];
       j != JointIndex::None; j = skeleton.joint[index_of(j)].parent)
    trunk[index_of(j)] = true;
  return trunk;
}

/// The least leaps that are faults, in metres from one frame to the next, by joint.
std::vector<double> least_leaps(const Skeleton& skeleton, double frame_rate) {
  constexpr double impossible = 800, impossible_of_trunk = 250;  // m/s2, for an adult
  const double seconds = 1 / frame_rate;
  std::vector<double> leaps;
  // At low rates the same acceleration is a large distance, but a joint never errs by less than
  // the noise of capture.
  for (const bool is_trunk : trunk_of(skeleton))
    leaps.push_back(
        std::max(0.01, (is_trunk ? impossible_of_trunk : impossible) * seconds * seconds) *
        size_of(skeleton));
  return leaps;
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
  const std::vector<double> limit = least_leaps(skeleton, clip.frame_rate);
  std::vector<CaptureFault> faults;
  for (std::uint32_t f = 1; f + 1 < frame_count(clip); ++f) {
    CaptureFault here{.first = f, .last = f};
    for (std::size_t j = 0; j < track.joints; ++j)
      if (const double off = leap_of(track, f, j); off >= limit[j] && off > here.metres)
        here.metres = off, here.joint = j;
    if (here.metres == 0) continue;
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
                       const JointPositions& track, const std::vector<double>& limit) {
  // What moves a quarter as far as the limit moves with what is thrown.
  std::vector<bool> thrown(track.joints);
  for (std::uint32_t f = fault.first; f <= fault.last; ++f)
    for (std::size_t j = 0; j < track.joints; ++j)
      if (leap_of(track, f, j) > 0.25 * limit[j]) thrown[j] = true;
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

/// How a mended part must be.
enum class Demand : std::uint8_t {
  Sound,  ///< Nothing leaps in it, or where it meets the rest.
  Calm,   ///< And neither does the trunk bend within a thirtieth of a second as no walker's does.
};

/// How sharply the way of a joint bends within a time, at most; metres.
double sharpest_bend(const JointPositions& track, std::size_t joint, std::size_t first,
                     std::size_t end, std::size_t step) {
  double most = 0;
  for (std::size_t f = std::max(first, step);
       f + step < track.place.size() / track.joints && f < end; ++f) {
    const Vec3 course = 0.5f * (track.at(f - step, joint) + track.at(f + step, joint));
    most = std::max(most, 2 * static_cast<double>(glm::distance(track.at(f, joint), course)));
  }
  return most;
}

bool meets(Demand demand, const Skeleton& skeleton, const Gap& gap, const MotionClip& clip,
           const JointPositions& track) {
  constexpr double sharp = 22;  // m/s2
  constexpr double bend_seconds = 1.0 / 30;
  const std::vector<double> limit = least_leaps(skeleton, clip.frame_rate);
  const auto begin = static_cast<std::size_t>(std::max<std::int64_t>(gap.first - 1, 1));
  const auto end =
      static_cast<std::size_t>(std::min<std::int64_t>(gap.last + 2, frame_count(clip) - 1));
  for (std::size_t j = 0; j < track.joints; ++j)
    if (sharpest_bend(track, j, begin, end, 1) >= limit[j]) return false;
  if (demand == Demand::Sound) return true;
  const std::uint32_t step = frames_in(bend_seconds, clip.frame_rate);
  const double most = sharp * bend_seconds * bend_seconds * size_of(skeleton);
  const std::vector<bool> trunk = trunk_of(skeleton);
  for (std::size_t j = 0; j < track.joints; ++j)
    if (trunk[j] && sharpest_bend(track, j, begin - std::min<std::size_t>(begin, step), end + step,
                                  step) > most)
      return false;
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

bool fill_gap(const Skeleton& skeleton, const CaptureFault& fault, const Gap& gap, Demand demand,
              MotionClip& clip, JointPositions& track) {
  if (gap.before < 0 && gap.after < 0) return false;
  const Throwers throwers =
      find_throwers(skeleton, fault, track, least_leaps(skeleton, clip.frame_rate));
  const Kept kept = keep(clip, gap);
  const std::int64_t frames = frame_count(clip);
  if (throwers.body) fill(gap, Channel<Vec3>{.values = clip.root}, frames);
  for (std::size_t j = 0; j < throwers.turns.size(); ++j)
    if (throwers.turns[j])
      fill(gap, Channel<Quat>{.values = clip.rotation, .stride = clip.joint_count, .offset = j},
           frames);
  place_again(skeleton, clip, gap, track);
  if (meets(demand, skeleton, gap, clip, track)) return true;
  put_back(kept, gap, clip);
  place_again(skeleton, clip, gap, track);
  return false;
}

/// The frames beside a fault may be a little wrong, too, and their speeds very much. Where a trunk
/// was thrown, it also takes a while to come back.
bool mend(const Skeleton& skeleton, const CaptureFault& fault, MotionClip& clip,
          JointPositions& track) {
  const auto widened = [&](Demand demand, double seconds) {
    const std::int64_t most = frames_in(seconds, clip.frame_rate);
    for (std::int64_t more = 0; more <= most; ++more)
      if (fill_gap(skeleton, fault, gap_of(fault.first, fault.last, frame_count(clip), more),
                   demand, clip, track))
        return true;
    return false;
  };
  if (trunk_of(skeleton)[fault.joint] && widened(Demand::Calm, 0.12)) return true;
  return widened(Demand::Sound, 0.04);
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
