#pragma once

#include <vector>

#include "tests/bench/tracked_motion.h"

namespace docent::bench {

/// How far the zero moment point lies outside of the feet that touch the ground, for every frame in
/// which the body walks and a foot does: metres, 0 where it lies within. It is where the ground
/// would have to push so that the body does not tip (Vukobratovic and Borovac 2004).
///
/// Masses are the shares of the segments of a body and lie where its segments have their middle of
/// mass (Winter 2009, table 4.1); their places are smoothed to 6 Hz before they are differentiated.
std::vector<double> outside_the_feet(const TrackedMotion& motion);

}  // namespace docent::bench
