#pragma once

#include "runtime/model/geometry/treads.h"
#include "runtime/model/result.h"
#include "runtime/motion/walk.h"

namespace docent::motion {

/// A way over a flight, from stop to stop in a straight line. Floor frame.
struct Ascent {
  Vec2 from{}, to{};
  Treads treads;  ///< Along the line; its rise below 0 leads down.
};

/// A walk that takes a flight step by step, one foot on each tread: Walk::climb says how high. Made
/// of a walk on level ground with as many steps: its time, trunk and arms stay, its feet go to the
/// treads (inverse kinematics), and the body over them. `request`: as for make_walk, which its path
/// is made for; it begins where a body stands at ascent.from. Fails where the graph cannot walk, or
/// where no walk has as many steps. Any thread may call.
Result<Walk> climb(const WalkGraph& graph, const Ascent& ascent, WalkRequest request);

}  // namespace docent::motion
