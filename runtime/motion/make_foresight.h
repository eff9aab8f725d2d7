#pragma once

#include "runtime/motion/walk_graph.h"

namespace docent::motion {

/// How far a search foresees, metres: the weight of what comes later falls to 1/e at this distance.
constexpr double foresight_reach = 3.0;
/// Over this distance the coming bend of the track is measured. Metres.
constexpr double bend_reach = 1.2;

/// Works out what walking on costs after each transition, for both searches
/// (runtime/motion/search.h), on tracks that bend evenly: the value function of the passages
/// (Treuille, Lee, Popovic 2007), by value iteration over the misfit of the body and the track's
/// bend. For the content compiler: `begin_foresight`, then `add_bend` for every place of bend_axis,
/// in any order and on any threads. Takes some 3 s in all for seven clips of 26 s together, and
/// grows with transitions times passages; graphs of very many transitions get smaller tables or
/// none. The whole graph is foreseen, also for a search that stays in one class.
Foresight begin_foresight(const WalkGraph& graph);
void add_bend(const WalkGraph& graph, std::size_t bend, Foresight& foresight);
/// Both, for all bends, on this thread.
Foresight make_foresight(const WalkGraph& graph);

}  // namespace docent::motion
