#pragma once

#include <string>
#include <vector>

#include "runtime/motion/walk_graph.h"
#include "tests/bench/museum_routes.h"
#include "tests/bench/tracked_motion.h"

namespace docent::bench {

/// How natural the walks of some clips are, along the routes of a museum of one kind.
struct RoutesLook {
  std::string kind;
  double nearest_pose = 0;              ///< Metres, the 95th percentile.
  double long_steps = 0;                ///< Share of the steps that last longer than 0.70 s.
  double step_median = 0, step_95 = 0;  ///< Seconds.
  double outside_feet = 0;              ///< Metres, the 95th percentile of the zero moment point's.
  double head_bend = 0;                 ///< Metres, the worst.
  double drift = 0;                     ///< Of planted feet, metres, the 95th percentile.
  double deviation_mean = 0, deviation_largest = 0;  ///< Metres.
};

/// And how natural they are besides, beside their clips.
struct Naturalness {
  std::vector<RoutesLook> routes;    ///< Of each kind; then of stairs-like paths of 0.8 m.
  double outside_feet_of_clips = 0;  ///< Metres, the 95th percentile.
  double long_steps_of_clips = 0, step_95_of_clips = 0;
  double head_bend_of_clips = 0;              ///< Metres.
  double hairpin_bend = 0, hairpin_time = 0;  ///< On `hairpin_path`; metres, seconds.
  double other_stride = 0;                    ///< Metres, the median on the ellipse.
  double other_stride_of_clips = 0;
  double knee_jolt = 0;          ///< Radians a second squared, the 95th percentile of the clips'.
  double arm_swing[2] = {0, 0};  ///< Metres: the clips' medians, left and right.
  double arm_variation[2] = {0, 0};               ///< Share of the swing, on the ellipse.
  double ready_seconds = 0, stretch_seconds = 0;  ///< 33 m of the ellipse; its first 8 m.
  double held_out = 0;  ///< Metres: the 95th percentile of takes left out; 0: none.

  double worst_head_bend() const;  ///< Over the clips' worst.
};

Naturalness measure_naturalness(const motion::WalkGraph& graph,
                                const std::vector<MuseumRoutes>& routes,
                                const std::vector<TrackedMotion>& held_out = {});

/// The table of today's values beside the yardsticks and the goals.
std::string to_table(const std::string& title, const Naturalness& look);

}  // namespace docent::bench
