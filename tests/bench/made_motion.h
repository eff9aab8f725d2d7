#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "content/motion/make_motion_graph.h"

namespace docent::bench {

/// Recordings of one body at one rate.
struct Recordings {
  Skeleton skeleton;
  std::vector<motion::offline::SourceClip> clips;
};

/// Reads folders of clips, of the skeleton that the first clip shows; others are left out.
Recordings read_recordings(const std::vector<std::filesystem::path>& folders);

/// Makes motion of any length of a few recordings, and hands it over clip by clip: each in turn is
/// played again slower or faster (by up to a fifth, and drifting), every second round mirrored, and
/// with all joints but the hips turned by slow noise, of about two degrees, in the legs of a third
/// of one, so that standing feet go on standing. The first round is the recordings themselves.
/// Motion of a length is the beginning of the motion of any greater length. Returns its length in
/// seconds, which is that asked for and a part of a clip.
double make_motion(const Recordings& recorded, double seconds, std::uint64_t seed,
                   const std::function<void(motion::offline::SourceClip)>& take);

}  // namespace docent::bench
