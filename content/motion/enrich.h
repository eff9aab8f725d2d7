#pragma once

#include <string>
#include <vector>

#include "content/motion/pose_distance.h"
#include "runtime/model/diagnostic.h"
#include "runtime/model/motion/motion_clip.h"
#include "runtime/model/motion/skeleton.h"

namespace docent::motion::offline {

/// Which clips are made of those that were recorded. README.md has what they gain and cost.
struct Enrichment {
  bool mirrored = false;  ///< Seen in a mirror, where that brings something new.
  bool turns = false;     ///< Turns by angles between those recorded.
};

/// Makes these clips, turns first. A clip is mirrored where `clips` lack the result: none has its
/// role and class and turns as far, to 12 degrees, on the same foot. So starts and stops
/// get one for the other foot, turns one for the other side or foot, and straight walks, which come
/// by both feet, none. Only the part of a clip is kept in which it starts, stops or turns, and half
/// a second round it for blends.
///
/// `clips` have roles and plants, and `cloud` has an entry for each. A skeleton that cannot be
/// mirrored gives a warning about `folder`.
std::vector<MotionClip> enrich(const Skeleton& skeleton, const std::vector<MotionClip>& clips,
                               const std::vector<PoseCloud>& cloud, Enrichment enrichment,
                               const std::string& folder, std::vector<Diagnostic>& warnings);

}  // namespace docent::motion::offline
