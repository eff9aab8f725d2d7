#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "content/character/human_bone.h"
#include "content/character/standing.h"
#include "content/import/gltf/model.h"

namespace docent::character {

/// A bone that swings: hair, a ribbon, a tail of a coat. In the frame of Standing and the file's
/// own size, as it was modelled.
struct SpringBone {
  HumanBone body = HumanBone::Hips;  ///< Which carries it.
  std::int32_t above = -1;           ///< The one that it hangs from; comes before it.
  Vec3 root{0}, end{0};
  float pull = 0;                          ///< m/s2, towards where it was modelled; 0 or more.
  Vec3 gravity{0};                         ///< m/s2.
  float drag = 0;                          ///< 1/s.
  float radius = 0;                        ///< Of its end.
  std::vector<std::uint32_t> colliders{};  ///< That its end is kept out of.
  double skin = 0;                         ///< How many vertices go with it, by their shares.
};
struct SpringBall {
  HumanBone body = HumanBone::Hips;  ///< Which carries it.
  Vec3 from{0}, to{0};
  float radius = 0;
};
struct Springs {
  std::vector<SpringBone> bone;
  std::vector<SpringBall> ball;
  std::vector<std::int32_t> bone_of_node;  ///< One a node of the file; -1: it goes with the body.
};

/// No character keeps more of them...
inline constexpr std::size_t most_spring_bones = 150;
/// ... and a guide has no more, because of what they cost a frame (tests/bench/README.md); nor more
/// than its skeleton leaves room for (fit.h).
inline constexpr std::size_t most_bones_of_a_guide = 24;

/// Takes over what VRM says of swinging (VRM 1.0, springBone; UniVRM for 0.x): joints and their
/// ends, as bones. Bones of the body never swing. What cannot be used is told in `notes`.
Springs springs_of(const import::gltf::Model& model, const Standing& standing,
                   std::vector<std::string>& notes);

/// Makes fewer of them: again and again the end of the chain that bears least goes with the bone
/// that it hangs from, which reaches as far then if nothing else hangs there; a chain of one goes
/// with the body. Writes for each bone which of the new ones it is part of, or -1.
Springs with_at_most(std::size_t most, const Springs& springs, std::vector<std::int32_t>& became);

/// Which of the colliders there is room for: those that most bones are kept out of.
std::vector<std::uint32_t> busiest_balls(const Springs& springs, std::size_t most);

}  // namespace docent::character
