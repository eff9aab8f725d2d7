#include "content/motion/made_stands.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>

#include "content/motion/extract_root_motion.h"
#include "content/motion/foot_plants.h"
#include "content/motion/joint_positions.h"
#include "runtime/motion/leg.h"
#include "runtime/motion/pose.h"

namespace docent::motion::offline {
namespace {

constexpr double stand_seconds = 0.12;    // at the beginning of a start
constexpr double gather_seconds = 1.0;    // until it walks as fast as it was recorded
constexpr double loosen_seconds = 0.8;    // until nothing of the stand is left
constexpr double walking_seconds = 1.2;   // of the recording after that, for blends
constexpr double standing_reach = 0.985;  // hip to ankle, of the straight leg
constexpr double feet_apart = 0.95;       // of the hip joints' distance

/// A frame in the middle of a step, and the foot that bears it.
struct Passing {
  std::size_t frame = 0;
  Side bears = Side::Left;
};

/// A recording, forwards or backwards in time.
struct Reel {
  const MotionClip& clip;
  bool backwards = false;

  double seconds() const { return static_cast<double>(frame_count(clip) - 1) / clip.frame_rate; }
  void look(double at, PoseView& pose) const {
    sample(clip, backwards ? seconds() - at : at, pose);
  }
};

/// The moments in which the free foot passes the other, by the reel's clock.
std::vector<Passing> find_passings(const Skeleton& skeleton, const Legs& legs, const Reel& reel) {
  std::vector<Passing> out;
  std::vector<Quat> rotation(reel.clip.joint_count);
  PoseView pose{{}, rotation};
  std::optional<double> before;
  for (std::size_t f = 0; f < frame_count(reel.clip); ++f) {
    const std::size_t frame = reel.backwards ? frame_count(reel.clip) - 1 - f : f;
    const FootPlants plants = reel.clip.plants[frame];
    reel.look(static_cast<double>(f) / reel.clip.frame_rate, pose);
    const double heading = facing(skeleton, legs, pose);
    const Vec2 apart = to_floor(foot_of(skeleton, legs[Side::Left], pose).toe -
                                foot_of(skeleton, legs[Side::Right], pose).toe);
    const double ahead = dot(apart, Vec2{std::cos(heading), std::sin(heading)});
    const bool passes = before && (*before < 0) != (ahead < 0);
    before = ahead;
    if (passes && plants.left != plants.right)
      out.push_back({f, plants.left ? Side::Left : Side::Right});
  }
  return out;
}

/// The pose of that moment with both feet on the ground, side by side, and the body between them.
void stand(const Skeleton& skeleton, const Legs& legs, Side bears, PoseView& pose) {
  const Foot planted = foot_of(skeleton, legs[bears], pose);
  const double heading = facing(skeleton, legs, pose);
  const Vec3 left = to_world({-std::sin(heading), std::cos(heading)});
  const Vec3 hips =
      hip_of(skeleton, legs[Side::Left], pose) - hip_of(skeleton, legs[Side::Right], pose);
  const float width = static_cast<float>(feet_apart) * glm::length(hips);
  const float side = bears == Side::Left ? -1.0F : 1.0F;
  Foot free = planted;
  free.toe += side * width * left;
  pose.root += 0.5F * (planted.toe + free.toe) - Vec3(pose.root.x, 0, pose.root.z);
  pose.root.y -= 0.5F * (planted.toe.y + free.toe.y);
  // The ankles are behind the toes: so is the body.
  const Vec3 ankle = ankle_of(legs[bears], planted);
  const Vec3 ahead = to_world({std::cos(heading), std::sin(heading)});
  pose.root += dot(ankle - planted.toe, ahead) * 0.5F * ahead;
  // In the middle of a step knees are bent further than in standing.
  double up = 1;
  for (const Side s : both_sides) {
    const Vec3 off =
        hip_of(skeleton, legs[s], pose) - ankle_of(legs[s], s == bears ? planted : free);
    const double reach = standing_reach * static_cast<double>(legs[s].length);
    const double aside = std::hypot(off.x, off.z);
    up = std::min(
        up, std::sqrt(std::max(0.0, reach * reach - aside * aside)) - static_cast<double>(off.y));
  }
  pose.root.y += static_cast<float>(up);
  place_foot(skeleton, legs[bears], planted, pose);
  place_foot(skeleton, legs[other(bears)], free, pose);
}

float smooth(double t) {
  const double x = std::clamp(t, 0.0, 1.0);
  return static_cast<float>(x * x * (3 - 2 * x));
}

/// Stands, and then plays the reel from `passing` on, faster and faster.
MotionClip made_start(const Skeleton& skeleton, const Legs& legs, const Reel& reel,
                      const Passing& passing) {
  const double rate = reel.clip.frame_rate;
  const double from = static_cast<double>(passing.frame) / rate;
  std::vector<Quat> standing(reel.clip.joint_count), moving(reel.clip.joint_count);
  PoseView still{{}, standing}, walk{{}, moving};
  reel.look(from, still);
  const Vec3 root_then = still.root;
  stand(skeleton, legs, passing.bears, still);
  const Vec3 shift = still.root - root_then;

  MotionClip made;
  made.frame_rate = rate;
  made.joint_count = reel.clip.joint_count;
  made.motion_class = reel.clip.motion_class;
  const double whole = stand_seconds + gather_seconds + walking_seconds;
  for (std::size_t f = 0; f <= static_cast<std::size_t>(whole * rate); ++f) {
    const double t = static_cast<double>(f) / rate - stand_seconds;
    const double gathered = std::clamp(t, 0.0, gather_seconds);
    const double played =
        gathered * gathered / (2 * gather_seconds) + std::max(0.0, t - gather_seconds);
    reel.look(from + played, walk);
    const float weight = smooth(t / loosen_seconds);
    made.root.push_back(walk.root + (1 - weight) * shift);
    for (std::size_t j = 0; j < moving.size(); ++j)
      made.rotation.push_back(glm::slerp(standing[j], moving[j], weight));
  }
  return made;
}

void turn_round_in_time(MotionClip& clip) {
  std::ranges::reverse(clip.root);
  std::vector<Quat> rotation;
  rotation.reserve(clip.rotation.size());
  for (std::size_t f = clip.root.size(); f-- > 0;)
    rotation.insert(
        rotation.end(), clip.rotation.begin() + static_cast<std::ptrdiff_t>(f * clip.joint_count),
        clip.rotation.begin() + static_cast<std::ptrdiff_t>((f + 1) * clip.joint_count));
  clip.rotation = std::move(rotation);
}

/// The clips to make them of: ordinary straight walking before brisk, walking before turning, long
/// before short.
std::vector<const MotionClip*> by_fitness(const std::vector<MotionClip>& clips) {
  std::vector<const MotionClip*> out;
  for (const MotionClip& clip : clips)
    if (clip.role != ClipRole::Start && clip.role != ClipRole::Stop) out.push_back(&clip);
  const auto unfit = [](const MotionClip* clip) {
    const bool walks = std::string_view(clip->motion_class) == "walk";
    return std::tuple(!walks, clip->role != ClipRole::Walk, -static_cast<long>(frame_count(*clip)));
  };
  std::ranges::stable_sort(out, {}, unfit);
  return out;
}

void make(const Skeleton& skeleton, const Legs& legs, ClipRole role,
          const std::vector<const MotionClip*>& sources, std::vector<MotionClip>& out) {
  bool has[2] = {false, false};
  for (const MotionClip* clip : sources) {
    const Reel reel{*clip, role == ClipRole::Stop};
    for (const Passing& passing : find_passings(skeleton, legs, reel)) {
      const double left = reel.seconds() - static_cast<double>(passing.frame) / clip->frame_rate;
      if (has[index_of(passing.bears)] || left < gather_seconds / 2 + walking_seconds) continue;
      has[index_of(passing.bears)] = true;
      MotionClip made = made_start(skeleton, legs, reel, passing);
      if (reel.backwards) turn_round_in_time(made);
      made.role = role;
      made.name = clip->name + (reel.backwards ? ", stopping" : ", starting") +
                  (passing.bears == Side::Left ? " on the left foot" : " on the right foot");
      find_foot_plants(skeleton, joint_positions(skeleton, made), made);
      out.push_back(std::move(made));
    }
    if (has[0] && has[1]) return;
  }
}

}  // namespace

std::vector<MotionClip> made_stands(const Skeleton& skeleton,
                                    const std::vector<MotionClip>& clips) {
  std::vector<MotionClip> out;
  const std::optional<Legs> legs = find_legs(skeleton);
  if (!legs) return out;
  const std::vector<const MotionClip*> sources = by_fitness(clips);
  for (const ClipRole role : {ClipRole::Start, ClipRole::Stop})
    if (std::ranges::none_of(clips, [&](const MotionClip& c) { return c.role == role; }))
      make(skeleton, *legs, role, sources, out);
  return out;
}

}  // namespace docent::motion::offline
