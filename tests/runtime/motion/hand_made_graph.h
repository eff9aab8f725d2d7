#pragma once

#include "runtime/model/motion/motion_graph.h"

namespace docent::test {

/// A stick figure of an adult's size with hips, legs, spine, head and arms.
Skeleton stick_figure();

/// A motion graph of simple clips of that figure, made by formula: stand to walk, straight walk,
/// walk to stand, and turns of 90 degrees to either side, with transitions wherever two clips are
/// in the same phase of the gait. Feet do not slide.
MotionGraph hand_made_graph();

}  // namespace docent::test
