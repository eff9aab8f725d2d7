#include "content/import/motion/amc.h"

#include <fmt/core.h>

#include <algorithm>
#include <numbers>

#include "content/import/motion/body.h"
#include "content/import/motion/motion_text.h"
#include "content/read_source.h"

namespace docent::import {
namespace {

using DVec3 = glm::dvec3;
using DQuat = glm::dquat;

/// Joints sit where bones begin, so a bone's joint is one parent bone away from its parent's. Bones
/// that carry none end in an end site.
struct JointsOfBones {
  Skeleton skeleton;
  std::vector<std::size_t> joint_of_bone;
};

JointsOfBones make_joints(const AcclaimSkeleton& acclaim) {
  JointsOfBones made;
  std::vector<bool> carries(acclaim.bone.size());
  for (std::size_t b = 1; b < acclaim.bone.size(); ++b)
    carries[static_cast<std::size_t>(acclaim.bone[b].parent)] = true;
  const auto add = [&](std::string name, JointIndex parent, DVec3 offset, bool has_rotation) {
    made.skeleton.joint.push_back(
        {.name = std::move(name), .parent = parent, .offset = Vec3(offset)});
    made.skeleton.has_rotation.push_back(has_rotation);
    return made.skeleton.joint.size() - 1;
  };
  for (const AcclaimBone& bone : acclaim.bone) {
    JointIndex parent = JointIndex::None;
    DVec3 offset{};
    if (bone.parent >= 0) {
      const auto p = static_cast<std::size_t>(bone.parent);
      parent = JointIndex{static_cast<int>(made.joint_of_bone[p])};
      offset = acclaim.bone[p].direction * acclaim.bone[p].length;
    }
    made.joint_of_bone.push_back(add(bone.name, parent, offset, true));
    if (!carries[made.joint_of_bone.size() - 1])
      add(bone.name + " end", JointIndex{static_cast<int>(made.joint_of_bone.back())},
          bone.direction * bone.length, false);
  }
  return made;
}

/// What a line of numbers does to a bone. M = R_last ... R_first in the bone's own axes C, so in
/// the world's it is C M C^-1.
struct BoneMotion {
  DVec3 place{};
  DQuat rotation{1, 0, 0, 0};
};

BoneMotion read_bone_motion(MotionText& text, const AcclaimBone& bone, double angle_unit) {
  BoneMotion motion;
  DQuat turn{1, 0, 0, 0};
  for (const BoneFreedom freedom : bone.freedom) {
    if (text.at_line_end())
      throw text.error("wrong-count",
                       fmt::format("bone '{}' has {} freedoms, but this line is shorter", bone.name,
                                   bone.freedom.size()),
                       "the AMC belongs to another ASF, or was edited");
    const double value = text.next_number("the bone's value");
    const auto kind = static_cast<int>(freedom);
    if (freedom <= BoneFreedom::Tz) {
      motion.place[kind] = value;
    } else if (freedom <= BoneFreedom::Rz) {
      DVec3 about{};
      about[kind - 3] = 1;
      turn = glm::angleAxis(value * angle_unit, about) * turn;
    }
  }
  if (!text.at_line_end())
    throw text.error("wrong-count",
                     fmt::format("bone '{}' has {} freedoms, but this line is longer", bone.name,
                                 bone.freedom.size()),
                     "the AMC belongs to another ASF, or was edited");
  motion.rotation = bone.axis * turn * glm::inverse(bone.axis);
  return motion;
}

bool is_number(std::string_view word) {
  return std::ranges::all_of(word, [](char c) { return c >= '0' && c <= '9'; });
}

class AmcReader {
 public:
  AmcReader(std::string_view bytes, const std::string& file, const AcclaimSkeleton& skeleton)
      : text_(bytes, file), acclaim_(skeleton), joints_(make_joints(skeleton)) {}

  RecordedMotion read(const AcclaimOptions& options) {
    RecordedMotion recorded;
    recorded.skeleton = joints_.skeleton;
    MotionClip& clip = recorded.clip;
    clip.frame_rate = options.frame_rate;
    clip.joint_count = static_cast<std::uint32_t>(joints_.skeleton.joint.size());
    read_header();
    for (std::size_t number = text_.at_end() ? 0 : first_frame(); !text_.at_end(); ++number) {
      const std::size_t place = text_.place();
      if (const double found = text_.next_number("the frame's number");
          found != static_cast<double>(number))
        throw text_.error_at(place, "missing-frames",
                             fmt::format("frame {} follows here, but it says {}", number, found),
                             "frames are missing or out of order; export the file again");
      read_frame(number, clip);
    }
    if (clip.root.empty()) throw text_.error("no-frames", "the file has no frames");
    make_rotations_continuous(clip);
    return recorded;
  }

 private:
  void read_header() {
    degrees_ = acclaim_.degrees;
    while (text_.peek_word().starts_with(':')) {
      const std::string_view word = text_.next_word();
      if (same_word(word, ":degrees")) degrees_ = true;
      if (same_word(word, ":radians")) degrees_ = false;
      text_.rest_of_line();
    }
  }

  /// Recordings cut from longer ones begin with another number than 1.
  std::size_t first_frame() {
    MotionText ahead = text_;
    return ahead.next_count("the first frame's number", 100'000'000);
  }

  /// Bones come in the same order in every frame, so the search begins after the last one found.
  std::optional<std::size_t> find_bone(std::string_view name) {
    for (std::size_t i = 0; i < acclaim_.bone.size(); ++i) {
      const std::size_t b = (last_bone_ + 1 + i) % acclaim_.bone.size();
      if (acclaim_.bone[b].name == name) return b;
    }
    return {};
  }

  void read_frame(std::size_t number, MotionClip& clip) {
    const std::size_t place = text_.last_place();
    std::vector<Quat> rotation(clip.joint_count, Quat{1, 0, 0, 0});
    std::vector<bool> said(acclaim_.bone.size());
    DVec3 root{};
    const double angle_unit = degrees_ ? std::numbers::pi / 180 : 1;
    while (!text_.at_end() && !is_number(text_.peek_word())) {
      const std::string_view name = text_.next_word();
      const auto bone = find_bone(name);
      if (!bone)
        throw text_.error("unknown-bone",
                          fmt::format("the skeleton has no bone '{}'", name.substr(0, 24)),
                          "the AMC belongs to another ASF");
      last_bone_ = *bone;
      said[*bone] = true;
      const BoneMotion motion = read_bone_motion(text_, acclaim_.bone[*bone], angle_unit);
      if (*bone == 0) root = motion.place;
      rotation[joints_.joint_of_bone[*bone]] = Quat(motion.rotation);
    }
    for (std::size_t b = 0; b < said.size(); ++b)
      if (!said[b] && !acclaim_.bone[b].freedom.empty())
        throw text_.error_at(
            place, "missing-frames",
            fmt::format("frame {} does not say bone '{}'", number, acclaim_.bone[b].name),
            "the file was cut short; copy it again from where it came from");
    clip.root.emplace_back(root);
    clip.rotation.insert(clip.rotation.end(), rotation.begin(), rotation.end());
  }

  MotionText text_;
  const AcclaimSkeleton& acclaim_;
  JointsOfBones joints_;
  std::size_t last_bone_ = 0;
  bool degrees_ = true;
};

}  // namespace

RecordedMotion parse_amc(std::string_view text, const std::string& file,
                         const AcclaimSkeleton& skeleton, const AcclaimOptions& options) {
  RecordedMotion recorded = AmcReader(text, file, skeleton).read(options);
  recorded.clip.name = std::filesystem::path(file).stem().string();
  if (find_body_parts(recorded.skeleton, recorded.clip))
    recorded.notes.push_back(swapped_sides_note(file));
  recorded.scale.stated = true;
  scale_to_metres(recorded, options.metres_per_unit.value_or(0.0254 / skeleton.length_unit));
  return recorded;
}

RecordedMotion read_amc(const std::filesystem::path& path, const AcclaimSkeleton& skeleton,
                        const AcclaimOptions& options) {
  return parse_amc(content::read_recording(path), path.string(), skeleton, options);
}

}  // namespace docent::import
