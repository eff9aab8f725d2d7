#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "runtime/model/geometry/floor_plan.h"
#include "runtime/model/museum.h"
#include "runtime/path/way.h"

namespace docent::test {

/// Somebody with a way of their own.
struct Part {
  Placement from, to;
  RouteKind kind = RouteKind::Shortest;
  double pace = 1;
  double rank = 0;
  bool stays = false;             ///< Stands where it is, for ever, whatever others want.
  std::vector<Placement> then{};  ///< Where it goes after that, one after the other, ...
  double rests = 0;               ///< ... not before so many seconds have passed.
};

/// Several people on one floor.
struct Situation {
  FloorPlan plan;
  std::vector<Part> parts;
  double seconds = 60;  ///< That are watched at most.
};

/// What was seen, frame by frame.
struct Scene {
  double radius = 0;
  std::vector<std::vector<Placement>> track;  ///< Per part and frame.
  std::vector<double> arrival;                ///< Seconds of each; infinite for who never came.
  double deepest_overlap = 0;                 ///< Metres by which two circles overlap at most.
  double least_clearance = 1e9;               ///< Metres from a centre to a wall.
  double quickest_change = 0;  ///< Metres that a centre moves between two frames at most.
  double step_ms = 0;          ///< Slowest step of the frame thread.

  bool all_arrived() const;
};

/// Lets the planner and the crowd play it, 60 frames a second.
Scene play(const Situation& situation);

/// Seconds that each would take alone.
std::vector<double> seconds_alone(const Situation& situation);

/// The tracks on the plan, later ones darker, a circle each second.
void draw_scene(const Situation& situation, const Scene& scene, const std::filesystem::path& file);

}  // namespace docent::test
