#pragma once

#include "runtime/model/connection.h"

namespace docent::scenery {

/// Stairs, an escalator, a ramp or a lift as one floor meets it. Floor frame.
struct Passage {
  ConnectionKind kind = ConnectionKind::Stairs;
  Placement here;   ///< The stop: one stands here and looks into it.
  Vec2 there{};     ///< The stop on the other floor; a lift needs none.
  double rise = 0;  ///< Metres from this floor up to that; below 0: it leads down.
};

}  // namespace docent::scenery
