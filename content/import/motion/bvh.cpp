#include "content/import/motion/bvh.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "content/import/motion/body.h"
#include "content/import/motion/motion_text.h"
#include "content/read_source.h"

namespace docent::import {
namespace {

using DVec3 = glm::dvec3;
using DQuat = glm::dquat;

constexpr std::size_t most_joints = 1024;
constexpr std::size_t most_frames = 10'000'000;  // A day at 120 frames a second.

/// One number a frame: a coordinate of a joint's place, or a turn about one of its axes.
struct Channel {
  bool rotation = false;
  int axis = 0;  ///< 0 x, 1 y, 2 z.
};

struct BvhJoint {
  std::string name;
  int parent = -1;
  bool end_site = false;
  DVec3 offset{};
  std::vector<Channel> channels{};
  std::size_t first_value = 0;  ///< Of a frame's values.
};

struct Hierarchy {
  std::vector<BvhJoint> joint;
  std::size_t values = 0;  ///< Numbers a frame.
};

DVec3 read_offset(MotionText& text) {
  DVec3 offset{};
  for (int axis = 0; axis < 3; ++axis) offset[axis] = text.next_number("the joint's OFFSET");
  return offset;
}

Channel read_channel(MotionText& text) {
  const std::string_view word = text.next_word();
  constexpr std::array<std::string_view, 6> names{"Xposition", "Yposition", "Zposition",
                                                  "Xrotation", "Yrotation", "Zrotation"};
  for (std::size_t i = 0; i < names.size(); ++i)
    if (same_word(word, names[i])) return {.rotation = i >= 3, .axis = static_cast<int>(i % 3)};
  throw text.error("unknown-channel", fmt::format("'{}' is not a channel", word.substr(0, 24)),
                   "channels are Xposition, Yposition, Zposition, Xrotation, Yrotation, Zrotation");
}

void read_channels(MotionText& text, Hierarchy& hierarchy, BvhJoint& joint) {
  if (!joint.channels.empty())
    throw text.error("second-channels", fmt::format("'{}' has CHANNELS twice", joint.name));
  const std::size_t count = text.next_count("the number of CHANNELS", 6);
  joint.first_value = hierarchy.values;
  for (std::size_t i = 0; i < count; ++i) joint.channels.push_back(read_channel(text));
  hierarchy.values += count;
}

/// The name and opening brace after ROOT, JOINT or End. Names may hold blanks.
std::string read_name(MotionText& text) {
  std::string_view line = text.rest_of_line();
  const bool opened = line.ends_with('{');
  if (opened) line.remove_suffix(1);
  while (!line.empty() && (line.back() == ' ' || line.back() == '\t')) line.remove_suffix(1);
  const std::string name(line);
  if (name.empty()) throw text.error("nameless-joint", "a joint has no name");
  if (!opened) text.expect("{");
  return name;
}

/// Reads from the word after HIERARCHY to the brace that closes the root.
Hierarchy read_hierarchy(MotionText& text) {
  Hierarchy hierarchy;
  std::vector<int> open;  // The joints whose braces are open, outermost first.
  const auto begin = [&](std::string name, bool end_site) {
    if (hierarchy.joint.size() == most_joints)
      throw text.error("too-many-joints",
                       fmt::format("the hierarchy has more than {} joints", most_joints));
    hierarchy.joint.push_back(
        {.name = std::move(name), .parent = open.empty() ? -1 : open.back(), .end_site = end_site});
    open.push_back(static_cast<int>(hierarchy.joint.size()) - 1);
  };

  text.expect("ROOT");
  begin(read_name(text), false);
  while (!open.empty()) {
    BvhJoint& joint = hierarchy.joint[static_cast<std::size_t>(open.back())];
    if (text.accept("OFFSET")) {
      joint.offset = read_offset(text);
    } else if (text.accept("CHANNELS")) {
      read_channels(text, hierarchy, joint);
    } else if (text.accept("JOINT")) {
      begin(read_name(text), false);
    } else if (text.accept("End")) {
      text.expect("Site");
      text.expect("{");
      begin(joint.name + " end", true);
    } else {
      text.expect("}");
      open.pop_back();
    }
  }
  return hierarchy;
}

struct Motion {
  std::size_t frames = 0;
  double seconds_per_frame = 0;
  std::vector<double> values;
  std::vector<Diagnostic> notes;
};

/// Finds the line of a frame table that does not hold `width` numbers, to say where it went wrong.
void blame_a_line(const MotionText& text, std::size_t table, std::size_t width) {
  const std::string_view rest = text.text_from(table);
  std::size_t begin = 0;
  while (begin < rest.size()) {
    const std::size_t end = std::min(rest.find_first_of("\r\n", begin), rest.size());
    MotionText line(rest.substr(begin, end - begin), text.file());
    std::size_t numbers = 0;
    while (!line.next_word().empty()) ++numbers;
    if (numbers != 0 && numbers != width)
      throw text.error_at(
          table + begin, "wrong-count",
          fmt::format("this frame has {} numbers, but the joints have {} channels", numbers, width),
          "export the file again; it was cut short or edited");
    begin = end + 1;
  }
}

Motion read_frames(MotionText& text, const Hierarchy& hierarchy) {
  Motion motion;
  text.expect("MOTION");
  text.expect_label("Frames:");
  const std::size_t declared_at = text.last_place();
  const std::size_t declared = text.next_count("the number of frames", most_frames);
  text.expect("Frame");
  text.expect_label("Time:");
  motion.seconds_per_frame = text.next_number("the frame time");
  if (motion.seconds_per_frame < 1e-4 || motion.seconds_per_frame > 1)
    throw text.error("bad-frame-time", fmt::format("a frame of {} s is not between 0.1 ms and 1 s",
                                                   motion.seconds_per_frame));

  const std::size_t table = text.place();
  // Two characters are the least that a number takes: no more memory than the text deserves.
  motion.values.reserve(
      std::min(declared * hierarchy.values, text.text_from(table).size() / 2 + 1));
  while (!text.at_end()) motion.values.push_back(text.next_number("a frame's value"));

  if (motion.values.size() % hierarchy.values != 0) {
    blame_a_line(text, table, hierarchy.values);
    throw text.error("wrong-count",
                     fmt::format("the last frame has {} numbers of {}",
                                 motion.values.size() % hierarchy.values, hierarchy.values));
  }
  motion.frames = motion.values.size() / hierarchy.values;
  if (motion.frames != declared)
    throw text.error_at(
        declared_at, motion.frames < declared ? "missing-frames" : "surplus-frames",
        fmt::format("{} frames are declared, but {} are there", declared, motion.frames),
        motion.frames < declared ? "the file was cut short; copy it again from where it came from"
                                 : "set the number after 'Frames:' to what is there");
  if (motion.frames == 0) throw text.error_at(declared_at, "no-frames", "the file has no frames");
  return motion;
}

/// Is the first frame a T-pose that an exporter put before the recording? (The cgspeed release of
/// CMU's recordings has one.) A person set it: whole degrees on every axis and most joints
/// straight; and the recording does not go on from it.
bool begins_with_rest_pose(const Hierarchy& hierarchy, std::span<const double> first,
                           std::span<const double> second) {
  constexpr double largest_step = 5;  // Degrees from one frame to the next.
  std::size_t rotations = 0, straight = 0;
  bool leaps = false;
  for (const BvhJoint& joint : hierarchy.joint)
    for (std::size_t c = 0; c < joint.channels.size(); ++c) {
      if (!joint.channels[c].rotation) continue;
      const double value = first[joint.first_value + c];
      if (std::abs(value - std::round(value)) > 1e-6) return false;
      ++rotations;
      straight += value == 0;
      leaps = leaps || std::abs(second[joint.first_value + c] - value) > largest_step;
    }
  return leaps && 4 * straight > 3 * rotations;
}

void drop_rest_pose(const Hierarchy& hierarchy, const std::string& file, Motion& motion) {
  const auto frame = [&](std::size_t f) {
    return std::span(motion.values).subspan(f * hierarchy.values, hierarchy.values);
  };
  if (motion.frames < 3 || !begins_with_rest_pose(hierarchy, frame(0), frame(1))) return;
  motion.values.erase(motion.values.begin(),
                      motion.values.begin() + static_cast<std::ptrdiff_t>(hierarchy.values));
  --motion.frames;
  motion.notes.push_back({.file = file,
                          .severity = Severity::Warning,
                          .code = "rest-pose-dropped",
                          .message = "the first frame is a T-pose and was left out",
                          .hint = "it is no part of the recording; nothing needs to be done"});
}

/// A joint's transform in its parent's frame, in one frame of the motion. Channels turn in the
/// order in which they are listed: R = R1 R2 R3.
struct LocalTransform {
  DVec3 place{};
  DQuat rotation{1, 0, 0, 0};
};

LocalTransform local_transform(const BvhJoint& joint, std::span<const double> frame) {
  LocalTransform local{.place = joint.offset};
  for (std::size_t c = 0; c < joint.channels.size(); ++c) {
    const double value = frame[joint.first_value + c];
    const int axis = joint.channels[c].axis;
    if (joint.channels[c].rotation) {
      DVec3 about{};
      about[axis] = 1;
      local.rotation = local.rotation * glm::angleAxis(value * std::numbers::pi / 180, about);
    } else if (joint.parent < 0) {
      local.place[axis] += value;
    } else {
      local.place[axis] = value;
    }
  }
  return local;
}

bool has_positions(const BvhJoint& joint) {
  return std::ranges::any_of(joint.channels, [](const Channel& c) { return !c.rotation; });
}

/// The joint that moves the body: the first that branches, or carries the translation, below
/// joints with a single child each (a dummy root at the origin, say).
std::size_t find_hips(const Hierarchy& hierarchy) {
  std::vector<std::size_t> children(hierarchy.joint.size()), only_child(hierarchy.joint.size());
  for (std::size_t j = 1; j < hierarchy.joint.size(); ++j) {
    const auto parent = static_cast<std::size_t>(hierarchy.joint[j].parent);
    ++children[parent];
    only_child[parent] = j;
  }
  std::size_t hips = 0;
  for (std::size_t j = 0; children[j] == 1 && !hierarchy.joint[only_child[j]].end_site;) {
    j = only_child[j];
    if (children[j] > 1 || has_positions(hierarchy.joint[j])) hips = j;
  }
  return hips;
}

/// The bones of the body from `hips` down, under the hips as joint 0.
Skeleton make_skeleton(const Hierarchy& hierarchy, std::size_t hips) {
  Skeleton skeleton;
  for (std::size_t j = hips; j < hierarchy.joint.size(); ++j) {
    const BvhJoint& joint = hierarchy.joint[j];
    const bool is_root = j == hips;
    skeleton.joint.push_back(
        {.name = joint.name,
         .parent = is_root ? JointIndex::None : JointIndex{joint.parent - static_cast<int>(hips)},
         .offset = is_root ? Vec3{} : Vec3(joint.offset)});
    skeleton.has_rotation.push_back(!joint.end_site);
  }
  return skeleton;
}

/// By how much the frames of a motion change the length or place of a bone, in file units.
struct BoneStretch {
  double most = 0;
  std::string joint;
};

/// Places the bones whose joints have positions in the frames: a bone is the mean of what they say.
BoneStretch take_bones_from_frames(const Hierarchy& hierarchy, std::size_t hips,
                                   const Motion& motion, Skeleton& skeleton) {
  BoneStretch stretch;
  for (std::size_t j = hips + 1; j < hierarchy.joint.size(); ++j) {
    const BvhJoint& joint = hierarchy.joint[j];
    if (!has_positions(joint)) continue;
    const auto bone_in = [&](std::size_t f) {
      return local_transform(joint, std::span(motion.values).subspan(f * hierarchy.values)).place;
    };
    DVec3 mean{};
    for (std::size_t f = 0; f < motion.frames; ++f) mean += bone_in(f);
    mean /= static_cast<double>(motion.frames);
    skeleton.joint[j - hips].offset = Vec3(mean);
    for (std::size_t f = 0; f < motion.frames; ++f)
      if (const double change = glm::distance(bone_in(f), mean); change > stretch.most)
        stretch = {change, joint.name};
  }
  return stretch;
}

void note_stretch(const BoneStretch& stretch, const std::string& file, RecordedMotion& recorded) {
  const double metres = stretch.most * recorded.scale.metres_per_unit;
  if (metres < 0.01) return;
  recorded.notes.push_back(
      {.file = file,
       .severity = Severity::Warning,
       .code = "stretching-bone",
       .message = fmt::format("the bone to '{}' changes by {:.1f} cm; its mean is used",
                              stretch.joint, 100 * metres),
       .hint = "bake the motion to bones of constant length before exporting it"});
}

MotionClip make_clip(const Hierarchy& hierarchy, std::size_t hips, const Motion& motion) {
  MotionClip clip;
  clip.frame_rate = frame_rate_of(motion.seconds_per_frame);
  clip.joint_count = static_cast<std::uint32_t>(hierarchy.joint.size() - hips);
  clip.root.reserve(motion.frames);
  clip.rotation.reserve(motion.frames * clip.joint_count);
  for (std::size_t f = 0; f < motion.frames; ++f) {
    const auto frame = std::span(motion.values).subspan(f * hierarchy.values);
    LocalTransform world;
    for (std::size_t j = 0; j <= hips; ++j) {
      const LocalTransform local = local_transform(hierarchy.joint[j], frame);
      world.place += world.rotation * local.place;
      world.rotation = world.rotation * local.rotation;
    }
    clip.root.emplace_back(world.place);
    clip.rotation.emplace_back(world.rotation);
    for (std::size_t j = hips + 1; j < hierarchy.joint.size(); ++j)
      clip.rotation.emplace_back(local_transform(hierarchy.joint[j], frame).rotation);
  }
  make_rotations_continuous(clip);
  return clip;
}

}  // namespace

RecordedMotion parse_bvh(std::string_view bytes, const std::string& file,
                         std::optional<double> metres_per_unit) {
  MotionText text(bytes, file);
  text.expect("HIERARCHY");
  const Hierarchy hierarchy = read_hierarchy(text);
  if (hierarchy.values == 0) throw text.error("no-channels", "no joint has CHANNELS");
  if (same_word(text.peek_word(), "ROOT"))
    throw text.error_at(text.place(), "second-root", "the file holds a second body",
                        "export one file for each body");
  Motion motion = read_frames(text, hierarchy);
  drop_rest_pose(hierarchy, file, motion);

  const std::size_t hips = find_hips(hierarchy);
  RecordedMotion recorded{.skeleton = make_skeleton(hierarchy, hips),
                          .clip = make_clip(hierarchy, hips, motion),
                          .notes = motion.notes};
  const BoneStretch stretch = take_bones_from_frames(hierarchy, hips, motion, recorded.skeleton);
  recorded.clip.name = std::filesystem::path(file).stem().string();
  if (find_body_parts(recorded.skeleton, recorded.clip))
    recorded.notes.push_back(swapped_sides_note(file));
  recorded.scale.stated = metres_per_unit.has_value();
  scale_to_metres(recorded, metres_per_unit ? *metres_per_unit
                                            : judge_metres_per_unit(recorded.skeleton, file));
  note_stretch(stretch, file, recorded);
  return recorded;
}

RecordedMotion read_bvh(const std::filesystem::path& path, std::optional<double> metres_per_unit) {
  return parse_bvh(content::read_recording(path), path.string(), metres_per_unit);
}

}  // namespace docent::import
