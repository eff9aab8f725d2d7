#pragma once

#include <cstdint>
#include <span>

#include "runtime/model/motion/motion_graph.h"
#include "runtime/motion/draft.h"
#include "runtime/motion/walk_graph.h"

namespace docent::motion {

ArmsAtEase arms_at_ease(const MotionGraph& motion);

/// Where a stretch of walking is in what differs from step to step.
struct StrideVariety {
  std::uint32_t seed = 0;
  double first_step = 0;  ///< Which step its first frame is in.
  double first_share =
      0;  ///< How much of it is to be seen there, in [0, 1]: nothing of who stands.
};

/// Steps in a frame, by the clock: what differs glides on while a body stands, too.
double steps_a_frame(const WalkGraph& graph) noexcept;

/// How much of it is to be seen in a frame of a walk with so many frames left.
double share_before_end(const WalkGraph& graph, std::size_t frames_left) noexcept;

/// Makes no stride like another, though they play the same clip: how far the arms swing, hang
/// before the body, are bent and stand off, how the chest is carried and where the head looks
/// differs from step to step as it does in people, with a memory of tens of steps
/// (runtime/model/motion/variation.h). Legs and hips stay as they are. It ends as it was, so that
/// who stands stands as ever.
void vary_strides(const WalkGraph& graph, const StrideVariety& variety, Draft& draft);

/// A seed of where a path leads.
std::uint32_t seed_of(std::span<const Vec2> path) noexcept;

}  // namespace docent::motion
