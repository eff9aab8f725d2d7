#include "tests/bench/made_motion.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "content/import/motion/motion_folder.h"

namespace docent::bench {
namespace {

constexpr double turn = 2 * std::numbers::pi;

/// Which joint takes over a joint's part when left and right change places.
std::vector<std::size_t> other_side(const Skeleton& skeleton) {
  std::vector<std::size_t> other(skeleton.joint.size());
  for (std::size_t j = 0; j < other.size(); ++j) {
    other[j] = j;
    std::string name = skeleton.joint[j].name;
    for (const auto& [from, to] : {std::pair{"Left", "Right"}, {"Right", "Left"}})
      if (const std::size_t at = name.find(from); at != std::string::npos) {
        name.replace(at, std::string_view(from).size(), to);
        break;
      }
    for (std::size_t k = 0; k < other.size(); ++k)
      if (skeleton.joint[k].name == name) other[j] = k;
  }
  return other;
}

/// The motion in a mirror that stands along the middle of the body (the model frame's x = 0).
MotionClip mirrored(const Skeleton& skeleton, const MotionClip& clip) {
  const std::vector<std::size_t> other = other_side(skeleton);
  MotionClip result = clip;
  for (Vec3& root : result.root) root.x = -root.x;
  for (std::size_t f = 0; f < clip.root.size(); ++f)
    for (std::size_t j = 0; j < other.size(); ++j) {
      const Quat q = clip.rotation[f * clip.joint_count + other[j]];
      result.rotation[f * clip.joint_count + j] = Quat(q.w, q.x, -q.y, -q.z);
    }
  return result;
}

/// A slow wave about nought; the mean square is half of the size's square.
struct Wave {
  double size, hertz, phase;

  double at(double seconds) const { return size * std::sin(turn * hertz * seconds + phase); }
};

bool is_leg(const Skeleton& skeleton, std::size_t joint) {
  for (JointIndex j{static_cast<int>(joint)}; j != JointIndex::None;
       j = skeleton.joint[index_of(j)].parent)
    if (j == skeleton[BodyPart::LeftHip] || j == skeleton[BodyPart::RightHip]) return true;
  return false;
}

class Variation {
 public:
  Variation(std::uint64_t seed, const Skeleton& skeleton) : random_(seed) {
    rate_ = std::exp(uniform(std::log(0.84), std::log(1.19)));
    drift_ = {.size = 0.06, .hertz = uniform(0.1, 0.4), .phase = uniform(0, turn)};
    for (std::size_t j = 0; j < skeleton.joint.size(); ++j) {
      // Feet that stand must go on standing: what turns a leg moves them most.
      const double degrees = is_leg(skeleton, j) ? 0.6 : 3.5;
      for (std::array<Wave, 2>& waves : axis_.emplace_back())
        for (Wave& wave : waves)
          wave = {.size = uniform(0, degrees) * turn / 360,
                  .hertz = uniform(0.1, 0.9),
                  .phase = uniform(0, turn)};
    }
  }

  MotionClip of(const MotionClip& clip) const {
    MotionClip result = clip;
    result.root.clear();
    result.rotation.clear();
    double at = 0;
    for (std::size_t frame = 0; at < static_cast<double>(clip.root.size() - 1); ++frame) {
      const double seconds = static_cast<double>(frame) / clip.frame_rate;
      add_frame(clip, at, seconds, result);
      at += rate_ * (1 + drift_.at(seconds));
    }
    return result;
  }

 private:
  double uniform(double from, double to) {
    // Not std::uniform_real_distribution, whose numbers differ between libraries.
    return from + (to - from) * static_cast<double>(random_() >> 11) * 0x1p-53;
  }

  void add_frame(const MotionClip& clip, double at, double seconds, MotionClip& result) const {
    const auto before = static_cast<std::size_t>(at);
    const auto part = static_cast<float>(at - static_cast<double>(before));
    result.root.push_back(glm::mix(clip.root[before], clip.root[before + 1], part));
    for (std::size_t j = 0; j < clip.joint_count; ++j) {
      const Quat a = clip.rotation[before * clip.joint_count + j];
      const Quat b = clip.rotation[(before + 1) * clip.joint_count + j];
      Vec3 noise{};
      for (std::size_t axis = 0; axis < axis_[j].size(); ++axis)
        for (const Wave& wave : axis_[j][axis])
          noise[static_cast<int>(axis)] += static_cast<float>(wave.at(seconds));
      // The root's noise would tilt and shift the whole body against its feet.
      const Quat turned = j == 0 ? Quat(1, 0, 0, 0) : Quat(noise);
      result.rotation.push_back(glm::slerp(a, b, part) * turned);
    }
  }

  std::mt19937_64 random_;
  double rate_ = 1;
  Wave drift_{};
  std::vector<std::array<std::array<Wave, 2>, 3>> axis_;
};

}  // namespace

Recordings read_recordings(const std::vector<std::filesystem::path>& folders) {
  Recordings recordings;
  std::vector<Diagnostic> problems;
  for (const std::filesystem::path& folder : folders)
    for (import::FolderMotion& motion : import::read_motion_folder(folder, problems)) {
      if (recordings.clips.empty()) recordings.skeleton = motion.motion.skeleton;
      const bool same =
          std::ranges::equal(recordings.skeleton.joint, motion.motion.skeleton.joint,
                             [](const auto& a, const auto& b) {
                               return a.name == b.name && glm::distance(a.offset, b.offset) < 1e-3f;
                             });
      if (same && (recordings.clips.empty() ||
                   motion.motion.clip.frame_rate == recordings.clips.front().clip.frame_rate))
        recordings.clips.push_back({.clip = std::move(motion.motion.clip), .file = motion.file});
    }
  return recordings;
}

double make_motion(const Recordings& recorded, double seconds, std::uint64_t seed,
                   const std::function<void(motion::offline::SourceClip)>& take) {
  double so_far = 0;
  for (std::size_t v = 0; so_far < seconds; ++v) {
    const std::size_t round = v / recorded.clips.size();
    const motion::offline::SourceClip& source = recorded.clips[v % recorded.clips.size()];
    MotionClip clip = source.clip;
    if (round % 2 == 1) clip = mirrored(recorded.skeleton, clip);
    if (round > 0) clip = Variation(seed + v, recorded.skeleton).of(clip);
    clip.name = fmt::format("{:04}-{}", v, source.clip.name);
    so_far += static_cast<double>(frame_count(clip)) / clip.frame_rate;
    const std::string file = clip.name + ".bvh";
    take({.clip = std::move(clip), .file = file});
  }
  return so_far;
}

}  // namespace docent::bench
