#pragma once

#include <rapidcheck.h>

#include "runtime/model/motion/motion_graph.h"

namespace docent::test {

/// A motion graph of a few short clips with transitions at random between them: what no compiler
/// would leave, dead ends and sections that reach over the last exit among it. Clip 0 is a start,
/// clip 1 a stop. Each walks on by a centimetre a frame, along a bend of its own.
rc::Gen<MotionGraph> random_graph();

}  // namespace docent::test
