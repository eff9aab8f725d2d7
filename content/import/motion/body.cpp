#include "content/import/motion/body.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <string_view>

#include "content/content_error.h"

namespace docent::import {
namespace {

enum class WordSide { Middle, Left, Right };

/// A joint's name, taken apart: "mixamorig:LeftUpLeg", "UpperLeg_L" and "lfemur" are the left
/// side's "upleg", "upperleg" and "femur".
struct JointName {
  WordSide side = WordSide::Middle;
  std::string base;
};

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}
bool is_upper(char c) {
  return c >= 'A' && c <= 'Z';
}
bool is_letter(char c) {
  return is_upper(c) || (c >= 'a' && c <= 'z');
}

/// Parts a name into lower-case words at blanks, punctuation, digits and changes of case.
std::vector<std::string> words_of(std::string_view name) {
  std::vector<std::string> words(1);
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (!is_letter(name[i])) {
      words.emplace_back();
      continue;
    }
    const bool after_lower = i > 0 && is_letter(name[i - 1]) && !is_upper(name[i - 1]);
    const bool before_lower =
        i + 1 < name.size() && is_letter(name[i + 1]) && !is_upper(name[i + 1]);
    if (is_upper(name[i]) && (after_lower || before_lower)) words.emplace_back();
    words.back() += lower(name[i]);
  }
  std::erase_if(words, [](const std::string& word) { return word.empty(); });
  return words;
}

WordSide side_word(std::string_view word) {
  if (word == "left" || word == "l" || word == "lt") return WordSide::Left;
  if (word == "right" || word == "r" || word == "rt") return WordSide::Right;
  return WordSide::Middle;
}

/// ASF writes the side as the first letter of one word, others run "left" into it.
JointName part_run_together(const std::string& word) {
  for (const std::string_view prefix : {"left", "right"})
    if (word.starts_with(prefix) && word.size() > prefix.size())
      return {side_word(prefix), word.substr(prefix.size())};
  for (const std::string_view base :
       {"hipjoint", "femur", "tibia",   "foot",  "toes",   "clavicle", "humerus",  "radius",
        "wrist",    "hand",  "fingers", "thumb", "thigh",  "shin",     "shoulder", "elbow",
        "knee",     "ankle", "toe",     "hip",   "collar", "calf",     "upperarm", "forearm"})
    if (word.size() == base.size() + 1 && word.ends_with(base) &&
        side_word(word.substr(0, 1)) != WordSide::Middle)
      return {side_word(word.substr(0, 1)), std::string(base)};
  return {WordSide::Middle, word};
}

JointName take_apart(std::string_view name) {
  if (const auto colon = name.rfind(':'); colon != name.npos) name.remove_prefix(colon + 1);
  JointName found;
  for (const std::string& word : words_of(name)) {
    const WordSide side = side_word(word);
    if (side == WordSide::Middle)
      found.base += word;
    else
      found.side = side;
  }
  return found.side == WordSide::Middle ? part_run_together(found.base) : found;
}

class NameTable {
 public:
  explicit NameTable(const Skeleton& skeleton) {
    for (std::size_t j = 0; j < skeleton.joint.size(); ++j)
      names_.push_back(skeleton.has_rotation[j] ? take_apart(skeleton.joint[j].name) : JointName{});
  }

  /// The first joint of that side whose name is one of `bases`, tried in order.
  JointIndex find(WordSide side, std::initializer_list<std::string_view> bases) const {
    for (const std::string_view base : bases)
      for (std::size_t j = 0; j < names_.size(); ++j)
        if (names_[j].side == side && names_[j].base == base)
          return JointIndex{static_cast<std::int32_t>(j)};
    return JointIndex::None;
  }

 private:
  std::vector<JointName> names_;
};

constexpr BodyPart on(WordSide side, BodyPart left, BodyPart right) {
  return side == WordSide::Left ? left : right;
}

JointIndex& part_of(Skeleton& skeleton, BodyPart part) {
  return skeleton.part[static_cast<std::size_t>(part)];
}

/// "Leg" is the shin where another joint is the thigh, and "Shoulder" the collar bone where
/// another joint is the upper arm; the names that settle it come first.
void name_limbs(const NameTable& names, WordSide side, Skeleton& skeleton) {
  const auto set = [&](BodyPart left, BodyPart right,
                       std::initializer_list<std::string_view> bases) {
    part_of(skeleton, on(side, left, right)) = names.find(side, bases);
  };
  using enum BodyPart;
  set(LeftHip, RightHip, {"upleg", "upperleg", "thigh", "femur", "hip"});
  set(LeftKnee, RightKnee, {"lowerleg", "knee", "calf", "shin", "tibia", "leg"});
  set(LeftAnkle, RightAnkle, {"ankle", "foot"});
  set(LeftToe, RightToe, {"toebase", "toes", "toe", "ball"});
  set(LeftElbow, RightElbow, {"forearm", "lowerarm", "elbow", "radius"});
  set(LeftWrist, RightWrist, {"wrist", "hand"});
  set(LeftShoulder, RightShoulder, {"upperarm", "uparm", "humerus", "arm", "shoulder"});
  set(LeftClavicle, RightClavicle, {"clavicle", "collar", "collarbone", "shoulder"});
  JointIndex& clavicle = part_of(skeleton, on(side, LeftClavicle, RightClavicle));
  if (clavicle == part_of(skeleton, on(side, LeftShoulder, RightShoulder)))
    clavicle = JointIndex::None;
}

/// A branch of the tree: from a joint that only it has down to an end.
using Branch = std::vector<std::size_t>;

bool contains(const Branch& branch, std::size_t joint) {
  return std::ranges::find(branch, joint) != branch.end();
}

/// The joints from the root to `joint`, both included.
Branch line_to(const Skeleton& skeleton, std::size_t joint) {
  Branch line{joint};
  while (skeleton.joint[line.back()].parent != JointIndex::None)
    line.push_back(index_of(skeleton.joint[line.back()].parent));
  std::ranges::reverse(line);
  return line;
}

float bone_length(const Skeleton& skeleton, std::size_t joint) {
  return glm::length(skeleton.joint[joint].offset);
}

/// The end that the longest line of bones below `joint` leads to; `joint` itself at an end.
std::size_t farthest_end(const Skeleton& skeleton, std::size_t joint) {
  std::vector<float> reach(skeleton.joint.size(), -1.0f);
  reach[joint] = 0;
  std::size_t farthest = joint;
  for (std::size_t j = joint + 1; j < skeleton.joint.size(); ++j) {
    const std::size_t parent = index_of(skeleton.joint[j].parent);
    if (reach[parent] < 0) continue;
    reach[j] = reach[parent] + bone_length(skeleton, j);
    if (reach[j] >= reach[farthest]) farthest = j;
  }
  return farthest;
}

/// The body in some frames of its motion. Which way it faces, and how its root's own axes lie, is
/// the recording's affair, so sides are asked frame by frame.
struct SampledPoses {
  std::vector<std::vector<Vec3>> places;  ///< By frame, then joint. World, y up.
  std::vector<float> height;              ///< Per joint: above the hips, mean of the frames.
};

SampledPoses sample_poses(const Skeleton& skeleton, const MotionClip& clip) {
  SampledPoses poses{.places = {}, .height = std::vector<float>(skeleton.joint.size())};
  const std::size_t step = std::max<std::size_t>(1, clip.root.size() / 32);
  for (std::size_t f = 0; f < clip.root.size(); f += step) {
    std::vector<Vec3>& places = poses.places.emplace_back();
    place_joints(skeleton, clip, f, places);
    for (std::size_t j = 0; j < places.size(); ++j) poses.height[j] += places[j].y - places[0].y;
  }
  for (float& height : poses.height) height /= static_cast<float>(poses.places.size());
  return poses;
}

/// From -1 to 1: how much a joint lies on the left of another for somebody whose feet point from
/// heel to toe. Left is where up x forward points.
float leftness(const SampledPoses& poses, std::size_t joint, std::size_t other, std::size_t heel,
               std::size_t toe) {
  float left = 0, all = 0;
  for (const std::vector<Vec3>& at : poses.places) {
    const Vec3 forward{at[toe].x - at[heel].x, 0, at[toe].z - at[heel].z};
    const Vec3 across{at[joint].x - at[other].x, 0, at[joint].z - at[other].z};
    left += glm::dot(glm::cross(Vec3{0, 1, 0}, forward), across);
    all += glm::length(forward) * glm::length(across);
  }
  return all > 0 ? left / all : 0;
}

/// Knee and hip (or elbow and shoulder) are the two joints of a limb's line that make its bones
/// most alike in length.
struct Limb {
  std::size_t upper = 0, middle = 0;
};

std::optional<Limb> find_limb(const Skeleton& skeleton, const Branch& line, std::size_t end) {
  std::optional<Limb> best;
  float best_difference = 0;
  const auto length_between = [&](std::size_t a, std::size_t b) {
    float length = 0;
    for (std::size_t i = a + 1; i <= b; ++i) length += bone_length(skeleton, line[i]);
    return length;
  };
  for (std::size_t upper = 0; upper < end; ++upper)
    for (std::size_t middle = upper + 1; middle < end; ++middle) {
      const float thigh = length_between(upper, middle), shin = length_between(middle, end);
      const float difference = std::abs(thigh - shin);
      if (thigh <= 0 || shin <= 0 || (best && difference >= best_difference)) continue;
      best = Limb{line[upper], line[middle]};
      best_difference = difference;
    }
  return best;
}

/// The legs of a body whose joints' names say nothing.
void shape_legs(const SampledPoses& poses, Skeleton& skeleton) {
  const auto children = children_of(skeleton);
  std::vector<std::size_t> ends;
  for (std::size_t j = 1; j < skeleton.joint.size(); ++j)
    if (children[j].empty()) ends.push_back(j);
  std::ranges::sort(ends, {}, [&](std::size_t j) { return poses.height[j]; });
  if (ends.size() < 2) return;

  const Branch first = line_to(skeleton, ends[0]);
  for (std::size_t i = 1; i < ends.size(); ++i) {
    const Branch second = line_to(skeleton, ends[i]);
    const auto parted =
        static_cast<std::size_t>(std::ranges::mismatch(first, second).in1 - first.begin());
    if (first.size() < parted + 4 || second.size() < parted + 4) continue;  // another toe
    // The end is the toe's tip; the ankle is two above it where the foot has a toe joint.
    const auto leg = [&](const Branch& line, bool left) {
      const Branch own(line.begin() + static_cast<std::ptrdiff_t>(parted), line.end());
      const std::size_t ankle = own.size() >= 5 ? own.size() - 3 : own.size() - 2;
      const auto limb = find_limb(skeleton, own, ankle);
      if (!limb) return;
      const auto set = [&](BodyPart left_part, BodyPart right_part, std::size_t joint) {
        part_of(skeleton, left ? left_part : right_part) = JointIndex{static_cast<int>(joint)};
      };
      using enum BodyPart;
      set(LeftHip, RightHip, limb->upper);
      set(LeftKnee, RightKnee, limb->middle);
      set(LeftAnkle, RightAnkle, own[ankle]);
      set(LeftToe, RightToe, own[ankle + 1]);
    };
    const auto side_of = [&](const Branch& line) {
      const Branch& other = &line == &first ? second : first;
      return leftness(poses, line[parted], other[parted], line[line.size() - 3], line.back());
    };
    const bool first_is_left = side_of(first) - side_of(second) > 0;
    leg(first, first_is_left);
    leg(second, !first_is_left);
    return;
  }
}

/// The chest is where the arms part, and the head the highest end of what it carries.
void shape_trunk(const SampledPoses& poses, Skeleton& skeleton) {
  using enum BodyPart;
  JointIndex& head = part_of(skeleton, Head);
  if (head == JointIndex::None) {
    std::size_t highest = 0;
    for (std::size_t j = 1; j < skeleton.joint.size(); ++j)
      if (poses.height[j] > poses.height[highest]) highest = j;
    const Branch line = line_to(skeleton, highest);
    if (line.size() > 1) head = JointIndex{static_cast<int>(line[line.size() - 2])};
  }
  if (head == JointIndex::None) return;
  const std::size_t top = farthest_end(skeleton, index_of(head));
  part_of(skeleton, HeadTop) = JointIndex{static_cast<int>(top)};

  const Branch line = line_to(skeleton, index_of(head));
  const auto carries = [&](std::size_t j, JointIndex limb) {
    return limb != JointIndex::None && contains(line_to(skeleton, index_of(limb)), j);
  };
  std::size_t chest = 0;
  for (std::size_t i = 1; i + 1 < line.size(); ++i)
    if (carries(line[i], skeleton[LeftShoulder]) && carries(line[i], skeleton[RightShoulder]))
      chest = i;
  if (chest == 0 && line.size() > 2) chest = (line.size() - 1) / 2;
  if (chest > 0) part_of(skeleton, Chest) = JointIndex{static_cast<int>(line[chest])};
  for (std::size_t i = 1; i < chest; ++i)
    if (skeleton[Spine] == JointIndex::None && bone_length(skeleton, line[i]) > 0)
      part_of(skeleton, Spine) = JointIndex{static_cast<int>(line[i])};
  if (skeleton[Spine] == JointIndex::None) part_of(skeleton, Spine) = skeleton[Chest];
  if (skeleton[Neck] == JointIndex::None && chest + 2 < line.size())
    part_of(skeleton, Neck) = JointIndex{static_cast<int>(line[chest + 1])};
}

/// The arms of a body whose joints' names say nothing: the two longest branches that leave the
/// line from the hips to the head.
void shape_arms(const SampledPoses& poses, Skeleton& skeleton) {
  using enum BodyPart;
  if (skeleton[LeftShoulder] != JointIndex::None || skeleton[LeftHip] == JointIndex::None) return;
  const auto children = children_of(skeleton);
  std::size_t highest = 0;
  for (std::size_t j = 1; j < skeleton.joint.size(); ++j)
    if (poses.height[j] > poses.height[highest]) highest = j;
  const Branch spine = line_to(skeleton, highest);
  std::vector<std::size_t> starts;
  for (const std::size_t j : spine)
    for (const std::size_t child : children[j])
      if (!contains(spine, child) && j != 0) starts.push_back(child);
  const auto length_of = [&](std::size_t start) {
    return line_to(skeleton, farthest_end(skeleton, start)).size();
  };
  std::ranges::sort(starts, [&](std::size_t a, std::size_t b) {
    return std::pair(length_of(b), a) < std::pair(length_of(a), b);
  });
  if (starts.size() < 2) return;

  const auto is_on_left = [&](std::size_t joint, std::size_t other) {
    float left = 0;
    for (const std::vector<Vec3>& at : poses.places)
      left += glm::dot(at[joint] - at[other],
                       at[index_of(skeleton[LeftHip])] - at[index_of(skeleton[RightHip])]);
    return left > 0;
  };
  for (std::size_t i = 0; i < 2; ++i) {
    const Branch whole = line_to(skeleton, farthest_end(skeleton, starts[i]));
    const Branch own(std::ranges::find(whole, starts[i]), whole.end());
    if (own.size() < 4) continue;
    const std::size_t wrist = own.size() - 2;
    const auto limb = find_limb(skeleton, own, wrist);
    if (!limb) continue;
    const bool is_left = is_on_left(starts[i], starts[1 - i]);
    const auto set = [&](BodyPart left_part, BodyPart right_part, std::size_t joint) {
      part_of(skeleton, is_left ? left_part : right_part) = JointIndex{static_cast<int>(joint)};
    };
    set(LeftShoulder, RightShoulder, limb->upper);
    set(LeftElbow, RightElbow, limb->middle);
    set(LeftWrist, RightWrist, own[wrist]);
    if (limb->upper != own[0]) set(LeftClavicle, RightClavicle, own[0]);
  }
}

/// Toes and finger tips: the ends of what the ankle and wrist carry. A foot without a toe joint
/// has its end site for a toe.
void find_tips(Skeleton& skeleton) {
  const auto tip = [&](BodyPart from, BodyPart tip_part) {
    if (skeleton[from] != JointIndex::None)
      part_of(skeleton, tip_part) =
          JointIndex{static_cast<int>(farthest_end(skeleton, index_of(skeleton[from])))};
  };
  using enum BodyPart;
  for (const auto& [ankle, toe] : {std::pair{LeftAnkle, LeftToe}, std::pair{RightAnkle, RightToe}})
    if (skeleton[toe] == JointIndex::None) tip(ankle, toe);
  tip(LeftToe, LeftToeTip);
  tip(RightToe, RightToeTip);
  tip(LeftWrist, LeftHandTip);
  tip(RightWrist, RightHandTip);
}

constexpr std::array paired_parts{
    std::pair{BodyPart::LeftHip, BodyPart::RightHip},
    std::pair{BodyPart::LeftKnee, BodyPart::RightKnee},
    std::pair{BodyPart::LeftAnkle, BodyPart::RightAnkle},
    std::pair{BodyPart::LeftToe, BodyPart::RightToe},
    std::pair{BodyPart::LeftToeTip, BodyPart::RightToeTip},
    std::pair{BodyPart::LeftClavicle, BodyPart::RightClavicle},
    std::pair{BodyPart::LeftShoulder, BodyPart::RightShoulder},
    std::pair{BodyPart::LeftElbow, BodyPart::RightElbow},
    std::pair{BodyPart::LeftWrist, BodyPart::RightWrist},
    std::pair{BodyPart::LeftHandTip, BodyPart::RightHandTip},
};

/// Do both feet point behind the body whose left hip is on its left? Then the sides are named as
/// somebody before it sees them, or the recording is mirrored. Feet that turn out by less than 60
/// degrees say so, in a body that mostly stands.
bool has_sides_swapped(const SampledPoses& poses, const Skeleton& skeleton) {
  using enum BodyPart;
  const auto says_so = [&](BodyPart ankle, BodyPart tip) {
    return skeleton[ankle] != JointIndex::None && skeleton[tip] != JointIndex::None &&
           leftness(poses, index_of(skeleton[LeftHip]), index_of(skeleton[RightHip]),
                    index_of(skeleton[ankle]), index_of(skeleton[tip])) < -0.5f;
  };
  return skeleton[LeftHip] != JointIndex::None && skeleton[RightHip] != JointIndex::None &&
         says_so(LeftAnkle, LeftToeTip) && says_so(RightAnkle, RightToeTip);
}

}  // namespace

std::vector<std::vector<std::size_t>> children_of(const Skeleton& skeleton) {
  std::vector<std::vector<std::size_t>> children(skeleton.joint.size());
  for (std::size_t j = 1; j < skeleton.joint.size(); ++j)
    children[index_of(skeleton.joint[j].parent)].push_back(j);
  return children;
}

bool find_body_parts(Skeleton& skeleton, const MotionClip& clip) {
  using enum BodyPart;
  skeleton.part.fill(JointIndex::None);
  part_of(skeleton, Hips) = JointIndex{0};
  const NameTable names(skeleton);
  name_limbs(names, WordSide::Left, skeleton);
  name_limbs(names, WordSide::Right, skeleton);
  part_of(skeleton, Head) = names.find(WordSide::Middle, {"head"});
  part_of(skeleton, Neck) = names.find(WordSide::Middle, {"lowerneck", "neck"});

  const SampledPoses poses = sample_poses(skeleton, clip);
  const auto missing = [&](std::initializer_list<BodyPart> parts) {
    return std::ranges::any_of(parts, [&](BodyPart p) { return skeleton[p] == JointIndex::None; });
  };
  if (missing({LeftHip, LeftKnee, LeftAnkle, RightHip, RightKnee, RightAnkle}))
    shape_legs(poses, skeleton);
  shape_arms(poses, skeleton);
  shape_trunk(poses, skeleton);
  find_tips(skeleton);
  if (!has_sides_swapped(poses, skeleton)) return false;
  for (const auto& [left, right] : paired_parts)
    std::swap(part_of(skeleton, left), part_of(skeleton, right));
  return true;
}

Diagnostic swapped_sides_note(const std::string& file) {
  return {.file = file,
          .severity = Severity::Warning,
          .code = "swapped-sides",
          .message =
              "the joints that are named left are on this body's right, so each counts for "
              "the other side",
          .hint = "nothing need be done, unless the recording was mirrored by mistake"};
}

bool are_counterparts(std::string_view name, std::string_view other) {
  const JointName a = take_apart(name), b = take_apart(other);
  const bool sides_swap = a.side == WordSide::Middle
                              ? b.side == WordSide::Middle
                              : b.side != WordSide::Middle && b.side != a.side;
  return sides_swap && a.base == b.base;
}

double leg_length(const Skeleton& skeleton) {
  const JointIndex hip = skeleton[BodyPart::LeftHip], ankle = skeleton[BodyPart::LeftAnkle];
  if (hip == JointIndex::None || ankle == JointIndex::None) return 0;
  double length = 0;
  for (JointIndex j = ankle; j != JointIndex::None && j != hip;
       j = skeleton.joint[index_of(j)].parent)
    length += bone_length(skeleton, index_of(j));
  return length;
}

double judge_metres_per_unit(const Skeleton& skeleton, const std::string& file) {
  // Hip to ankle, of adults between 1.5 m and 2 m tall, is 0.48 of the height (Winter 2009: thigh
  // 0.245, shank 0.246 less the ankle's height).
  constexpr double adult_leg = 0.83;
  constexpr double furthest_off = 1.5;  // Less than half of the step from inches to CMU's units.
  constexpr double cmu_unit = 0.0254 / 0.45;
  const double leg = leg_length(skeleton);
  double best = 0, best_ratio = furthest_off;
  for (const double unit : {0.001, 0.01, 0.0254, cmu_unit, 1.0}) {
    const double ratio = leg > 0 ? std::exp(std::abs(std::log(leg * unit / adult_leg))) : 1e9;
    if (ratio < best_ratio) best = unit, best_ratio = ratio;
  }
  if (best == 0)
    throw content::ContentError(
        file, 0, 0, "unknown-unit",
        leg > 0 ? fmt::format("a leg of {:.3g} units fits no usual unit of length", leg)
                : "the skeleton has no legs to judge its unit of length by",
        "state it in a clips.toml beside the clips: metres_per_unit = 0.01");
  return best;
}

void scale_to_metres(RecordedMotion& motion, double metres_per_unit) {
  motion.scale.metres_per_unit = metres_per_unit;
  const auto factor = static_cast<float>(metres_per_unit);
  for (Joint& joint : motion.skeleton.joint) joint.offset *= factor;
  for (Vec3& root : motion.clip.root) root *= factor;
}

}  // namespace docent::import
