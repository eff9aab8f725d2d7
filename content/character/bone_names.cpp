#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>

#include "content/character/find_bones.h"

namespace docent::character {
namespace {

enum class Where : std::uint8_t { Middle, Left, Right };

/// A joint's name, taken apart: "mixamorig:LeftForeArm" is "forearm" on the left.
struct JointName {
  std::string base;
  Where side = Where::Middle;
  int number = 0;        ///< Its last one: of "spine_02", 2.
  bool deforms = false;  ///< Rigify's mark of what moves the skin.
  bool is_control = false;
};

/// Words that say nothing of which bone it is.
constexpr std::array noise{"mixamorig", "bip",  "bip01",    "bone",     "bn",    "b",     "j",
                           "c",         "jnt",  "jt",       "joint",    "jo",    "def",   "skel",
                           "character", "rig",  "armature", "skeleton", "valve", "biped", "bind",
                           "cc",        "base", "deform",   "sk",       "root",  "g",     "m"};
/// Words of what moves bones, or of ends that are none.
constexpr std::array controls{"ik",         "fk",       "pole",   "target", "ctrl",   "control",
                              "controller", "mch",      "org",    "twist",  "roll",   "end",
                              "nub",        "scale",    "fake",   "slot",   "tweak",  "helper",
                              "site",       "effector", "eff",    "handle", "vis",    "corrective",
                              "share",      "attach",   "socket", "weapon", "cloth",  "skirt",
                              "sleeve",     "hair",     "sec",    "phys",   "master", "parent"};

bool is_one_of(std::string_view word, std::span<const char* const> words) {
  return std::ranges::find(words, word) != words.end();
}

/// Words of a name: at signs, digits and the capitals inside.
std::vector<std::string> words_of(std::string_view name) {
  std::vector<std::string> words;
  const auto kind = [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte >= 0x80 || std::islower(byte) != 0 ? 1
           : std::isupper(byte) != 0               ? 2
           : std::isdigit(byte) != 0               ? 3
                                                   : 0;
  };
  for (std::size_t i = 0; i < name.size(); ++i) {
    const int now = kind(name[i]);
    if (now == 0) continue;
    const int before = i == 0 ? 0 : kind(name[i - 1]);
    const int after = i + 1 < name.size() ? kind(name[i + 1]) : 0;
    const bool goes_on = before == now ? !(now == 2 && after == 1) : before == 2 && now == 1;
    if (!goes_on || words.empty()) words.emplace_back();
    words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(name[i])));
  }
  return words;
}

std::optional<Where> side_of(std::string_view word) {
  if (word == "l" || word == "left" || word == "lft") return Where::Left;
  if (word == "r" || word == "right" || word == "rgt") return Where::Right;
  return {};
}

struct Synonyms {
  HumanBone left, right;                ///< The same where it is in the middle.
  std::vector<std::string_view> names;  ///< The surest first.
};

const std::vector<Synonyms>& synonyms() {
  using enum HumanBone;
  static const std::vector<Synonyms> all{
      {Hips, Hips, {"hips", "pelvis", "hip", "lowertorso", "下半身", "腰", "センター"}},
      {Head, Head, {"head", "頭"}},
      {Neck, Neck, {"neck", "首"}},
      {LeftUpperLeg,
       RightUpperLeg,
       {"upperleg", "upleg", "thigh", "thighbend", "femur", "legupper", "hip", "足", "leg"}},
      {LeftLowerLeg,
       RightLowerLeg,
       {"lowerleg", "shin", "calf", "tibia", "shank", "loleg", "leglower", "leg", "knee", "ひざ"}},
      {LeftFoot, RightFoot, {"foot", "ankle", "feet", "足首"}},
      {LeftToes, RightToes, {"toes", "toe", "toebase", "ball", "つま先"}},
      {LeftShoulder,
       RightShoulder,
       {"clavicle", "collar", "collarbone", "clav", "scapula", "shoulder", "肩"}},
      {LeftUpperArm,
       RightUpperArm,
       {"upperarm", "uparm", "shldrbend", "shldr", "humerus", "armupper", "bicep", "arm",
        "shoulder", "腕"}},
      {LeftLowerArm,
       RightLowerArm,
       {"lowerarm", "forearm", "forearmbend", "radius", "loarm", "armlower", "elbow", "ひじ"}},
      {LeftHand, RightHand, {"hand", "wrist", "palm", "手首"}},
      {LeftEye, RightEye, {"eye", "eyeball", "目"}},
      {Jaw, Jaw, {"jaw"}},
  };
  return all;
}

/// "lfemur", "rhand": a side without a capital before a name that only sides have.
void take_small_side(JointName& joint) {
  if (joint.side != Where::Middle || joint.base.size() < 4) return;
  const char first = joint.base.front();
  if (first != 'l' && first != 'r') return;
  const std::string_view rest = std::string_view(joint.base).substr(1);
  const bool is_known = std::ranges::any_of(synonyms(), [&](const Synonyms& kind) {
    return kind.left != kind.right && std::ranges::find(kind.names, rest) != kind.names.end();
  });
  if (!is_known) return;
  joint.side = first == 'l' ? Where::Left : Where::Right;
  joint.base.erase(0, 1);
}

/// The word that most names of a skeleton begin with, such as its character's own name; empty where
/// there is none.
std::string common_first_word(const import::gltf::Model& model, const std::vector<bool>& is_joint) {
  std::map<std::string, std::size_t> count;
  std::size_t joints = 0;
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    if (!is_joint[i]) continue;
    ++joints;
    const std::vector<std::string> words = words_of(model.nodes[i].name);
    if (words.size() > 1) ++count[words.front()];
  }
  for (const auto& [word, times] : count)
    if (joints >= 12 && 10 * times > 7 * joints) return word;
  return {};
}

JointName taken_apart(std::string_view name, std::string_view common) {
  if (const std::size_t colon = name.find_last_of(":|"); colon != std::string_view::npos)
    name.remove_prefix(colon + 1);
  JointName joint;
  std::vector<std::string> words = words_of(name);
  if (words.size() > 1 && words.front() == common) words.erase(words.begin());
  for (std::string& word : words) {
    joint.deforms = joint.deforms || word == "def";
    if (std::isdigit(static_cast<unsigned char>(word[0])) != 0) {
      joint.number = std::atoi(word.substr(0, 6).c_str());
      continue;
    }
    if (const auto side = side_of(word); side && joint.side == Where::Middle) {
      joint.side = *side;
      continue;
    }
    joint.is_control = joint.is_control || is_one_of(word, controls);
    if (!is_one_of(word, noise)) joint.base += word;
  }
  for (const auto& [mark, side] : {std::pair<std::string_view, Where>{"左", Where::Left},
                                   {"右", Where::Right},
                                   {"left", Where::Left},
                                   {"right", Where::Right}}) {
    if (joint.side != Where::Middle || !joint.base.starts_with(mark)) continue;
    joint.side = side;
    joint.base.erase(0, mark.size());
  }
  take_small_side(joint);
  return joint;
}

/// How well a node suits: less is better.
using Suit = std::tuple<bool, std::size_t, bool, int, std::int32_t>;

struct Candidate {
  std::int32_t node = -1;
  Suit suit{};
};

void offer(Candidate& best, std::int32_t node, Suit suit) {
  if (best.node < 0 || suit < best.suit) best = {node, suit};
}

bool hangs_on(const import::gltf::Model& model, std::int32_t node, std::int32_t ancestor) {
  while (node >= 0 && node != ancestor) node = model.nodes[static_cast<std::size_t>(node)].parent;
  return node >= 0;
}

struct Finger {
  std::string_view name;
  HumanBone left, right;  ///< Their first of three bones.
};
constexpr std::array fingers{
    Finger{"thumb", HumanBone::LeftThumbMetacarpal, HumanBone::RightThumbMetacarpal},
    Finger{"index", HumanBone::LeftIndexProximal, HumanBone::RightIndexProximal},
    Finger{"middle", HumanBone::LeftMiddleProximal, HumanBone::RightMiddleProximal},
    Finger{"ring", HumanBone::LeftRingProximal, HumanBone::RightRingProximal},
    Finger{"pinky", HumanBone::LeftLittleProximal, HumanBone::RightLittleProximal},
    Finger{"little", HumanBone::LeftLittleProximal, HumanBone::RightLittleProximal},
};

/// Fingers: the three first joints of a name below a hand, in the order of their numbers.
void name_fingers(const import::gltf::Model& model, const std::vector<JointName>& names,
                  BoneMap& bones) {
  for (const Finger& finger : fingers)
    for (const bool left : {true, false}) {
      const std::int32_t hand = bones[left ? HumanBone::LeftHand : HumanBone::RightHand];
      if (hand < 0) continue;
      std::vector<std::pair<int, std::int32_t>> found;
      for (std::size_t i = 0; i < names.size(); ++i) {
        const auto node = static_cast<std::int32_t>(i);
        if (names[i].base.find(finger.name) != std::string::npos && !names[i].is_control &&
            names[i].base.find("metacarpal") == std::string::npos && hangs_on(model, node, hand))
          found.emplace_back(names[i].number, node);
      }
      std::ranges::sort(found);
      const auto first = index_of(left ? finger.left : finger.right);
      for (std::size_t k = 0; k < std::min<std::size_t>(found.size(), 3); ++k)
        if (bones.node[first + k] < 0) bones.node[first + k] = found[k].second;
    }
}

/// The last node that two hang on.
std::int32_t fork_of(const import::gltf::Model& model, std::int32_t a, std::int32_t b) {
  while (a >= 0 && !hangs_on(model, b, a)) a = model.nodes[static_cast<std::size_t>(a)].parent;
  return a;
}

/// Hips that no name tells are where the legs meet (MakeHuman's "root", Rigify's "DEF-spine"); such
/// a head is the last of the spine (Rigify's "DEF-spine.006").
void name_ends_of_spine(const import::gltf::Model& model, const std::vector<JointName>& names,
                        BoneMap& bones) {
  const std::vector<bool> is_joint = skin_joints(model);
  const auto moves_skin = [&](std::int32_t node) {
    return node >= 0 && is_joint[static_cast<std::size_t>(node)];
  };
  if (bones.has(HumanBone::LeftUpperLeg) && bones.has(HumanBone::RightUpperLeg)) {
    const std::int32_t fork =
        fork_of(model, bones[HumanBone::LeftUpperLeg], bones[HumanBone::RightUpperLeg]);
    std::int32_t& hips = bones[HumanBone::Hips];
    if (hips < 0 || (!moves_skin(hips) && moves_skin(fork))) hips = fork;
  }
  if (bones.has(HumanBone::Head)) return;
  int highest = 0;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto node = static_cast<std::int32_t>(i);
    const bool is_above = names[i].base == "spine" && names[i].side == Where::Middle &&
                          !names[i].is_control && names[i].number > highest;
    if (!is_above || hangs_on(model, bones[HumanBone::LeftUpperArm], node)) continue;
    highest = names[i].number;
    bones[HumanBone::Head] = node;
  }
}

}  // namespace

BoneMap bones_by_name(const import::gltf::Model& model) {
  const std::vector<bool> is_joint = skin_joints(model);
  std::vector<JointName> names;
  const std::string common = common_first_word(model, is_joint);
  for (const import::gltf::Node& node : model.nodes)
    names.push_back(taken_apart(node.name, common));

  BoneMap bones;
  std::vector<bool> is_taken(model.nodes.size());
  for (const Synonyms& kind : synonyms())
    for (const Where side : {Where::Left, Where::Right}) {
      const bool is_middle = kind.left == kind.right;
      if (is_middle && side == Where::Right) continue;
      const HumanBone bone = side == Where::Left ? kind.left : kind.right;
      Candidate best;
      for (std::size_t i = 0; i < names.size(); ++i) {
        const JointName& name = names[i];
        if (name.side != (is_middle ? Where::Middle : side) || name.is_control || is_taken[i])
          continue;
        const auto found = std::ranges::find(kind.names, name.base);
        if (found == kind.names.end()) continue;
        const auto rank = static_cast<std::size_t>(found - kind.names.begin());
        offer(best, static_cast<std::int32_t>(i),
              {!is_joint[i], rank, !name.deforms, name.number, static_cast<std::int32_t>(i)});
      }
      if (best.node < 0) continue;
      bones[bone] = best.node;
      is_taken[static_cast<std::size_t>(best.node)] = true;
    }
  for (const auto& [shoulder, upper, lower] :
       {std::tuple{HumanBone::LeftShoulder, HumanBone::LeftUpperArm, HumanBone::LeftLowerArm},
        {HumanBone::RightShoulder, HumanBone::RightUpperArm, HumanBone::RightLowerArm}})
    if (!bones.has(upper) && bones.has(shoulder) && bones.has(lower)) {
      bones[upper] = bones[shoulder];  // "LeftShoulder, LeftElbow, LeftWrist"
      bones[shoulder] = -1;
    }
  for (const auto& [upper, lower] : {std::pair{HumanBone::LeftUpperLeg, HumanBone::LeftLowerLeg},
                                     {HumanBone::RightUpperLeg, HumanBone::RightLowerLeg}})
    if (bones.has(upper) && bones.has(lower) && hangs_on(model, bones[upper], bones[lower]))
      std::swap(bones[upper], bones[lower]);
  name_ends_of_spine(model, names, bones);
  name_fingers(model, names, bones);
  return bones;
}

}  // namespace docent::character
