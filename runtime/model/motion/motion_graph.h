#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/model/geometry/vec2.h"
#include "runtime/model/motion/foresight.h"
#include "runtime/model/motion/motion_clip.h"
#include "runtime/model/motion/skeleton.h"

namespace docent {

/// A frame of a clip.
struct ClipFrame {
  std::uint32_t clip = 0;
  std::uint32_t frame = 0;
};

/// A blended passage from the window round `from` to the window round `to` (Kovar, Gleicher, Pighin
/// 2002).
struct Transition {
  ClipFrame from;  ///< Middle of the source window.
  ClipFrame to;    ///< Middle of the destination window.
  std::uint32_t radius =
      0;               ///< Frames L: the blend runs over [from - L, from + L] and [to - L, to + L].
  float distance = 0;  ///< Metres, root mean square over the window's point cloud after alignment.
  Placement alignment;  ///< Rigid motion on the floor that lays the destination clip onto the
                        ///< source clip.
};

/// A class of motion, such as "walk" or "jog". It has a graph of its own, in which no walk comes to
/// a dead end; transitions between clips of two classes join these graphs.
struct MotionClass {
  std::string name;  ///< As MotionClip::motion_class has it.
  /// How its gait differs from that of each class, itself included, in the order of
  /// MotionGraph::classes: metres, summed over the poses of a stride. Symmetric; 0 for itself.
  std::vector<float> coefficient;
  /// The transitions of its own graph, ascending: those between its clips that lie in the largest
  /// strongly connected part, lead into it from a start, or out of it to a stop.
  std::vector<std::uint32_t> transition{};
};

/// What the avatar can do: its clips and the transitions between them. Only the largest strongly
/// connected part (and what leads into it from a start, or out of it to a stop) is kept, so no walk
/// comes to a dead end.
struct MotionGraph {
  Skeleton skeleton;
  std::vector<MotionClip> clips;
  std::vector<Transition> transitions;  ///< Sorted by (from.clip, from.frame, to.clip, to.frame).
  Foresight foresight{};
  std::vector<MotionClass> classes{};  ///< Of the clips, in the order in which they first appear;
                                       ///< none where all clips count as one class.
};

}  // namespace docent
