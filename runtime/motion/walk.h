#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "runtime/model/motion/motion_graph.h"
#include "runtime/model/result.h"
#include "runtime/motion/careful_place.h"

namespace docent::motion {

/// What the body does in a frame.
enum class Gait : std::uint8_t { Idle, Turn, Walk };

/// How high the ground is that a body climbs, above the floor where its walk begins. Metres.
struct Climb {
  float body = 0;               ///< Under the body: smooth over treads, which feet are set on.
  std::array<float, 2> foot{};  ///< Under each foot (Side).
};

/// A walk made to measure: motion laid onto the floor, ready to be sampled by the frame loop.
///
/// World frame, metres (floor (x, y) is world (x, height, -y) with height 0 here). All arrays have
/// one entry per frame, `rotation` has joint_count per frame, as in MotionClip.
struct Walk {
  double frame_rate = 120;
  std::uint32_t joint_count = 0;
  std::vector<Vec3> root;
  std::vector<Quat> rotation;
  std::vector<FootPlants> plants;
  std::vector<Placement> body;  ///< Where the body's circle stands and faces: the root with the
                                ///< sway of the gait taken out.
  std::vector<float> along;     ///< Metres along the path asked for; 0 before it is reached.
  std::vector<Gait> gait;
  std::vector<Climb> climb;       ///< Stairs (climb.h): what `root` is to be raised by. Empty on
                                  ///< level ground.
  std::vector<ClipFrame> source;  ///< The clip frame that each frame was made from.
  std::uint32_t seed = 0;  ///< Of what differs from step to step (vary_strides.h), which goes on
  double first_step = 0;   ///< through all walks of a body: which step its first frame is in.
  std::uint32_t transitions = 0;  ///< How many blends it holds.
  std::uint32_t expanded = 0;     ///< Search nodes expanded.
  std::uint32_t considered = 0;   ///< Transitions that the search looked at, counted each time.
  std::uint32_t scope = 0;        ///< The widest that was searched (walk_graph.h).
  double search_seconds = 0;
};

inline std::uint32_t frame_count(const Walk& walk) noexcept {
  return static_cast<std::uint32_t>(walk.root.size());
}

/// Raw is the motion of the clips as it is; Exact warps it onto the path and pins planted feet.
enum class Fidelity : std::uint8_t { Exact, Raw };

/// What is asked of a walk.
struct WalkRequest {
  /// Floor frame, at least two different points. With `previous` it may be empty: the avatar stops
  /// as soon as it naturally can.
  std::span<const Vec2> path;
  std::optional<Placement>
      start;  ///< Standing; facing along the path from its first point when absent.
  std::optional<double> final_heading;  ///< Radians; along the path's end when absent.
  /// A walk in progress to go on from, at one of its frames: the new walk's frame 0 is that frame,
  /// and it moves on without a jump in place or pose. The path then begins at
  /// walk->body[frame].position.
  const Walk* previous = nullptr;
  std::uint32_t previous_frame = 0;
  /// Where `previous` would have gone on to, from its body at previous_frame: where the new path
  /// leads another way (by more than 60 degrees) a walking avatar brakes along this line, turns on
  /// the spot, walks back to the new path's beginning and on. Straight ahead when empty, which may
  /// be too near to a wall.
  std::span<const Vec2> old_path_ahead;
  double pace = 1;  ///< Share of the clips' speed that is walked at most, in (0, 1].
  std::span<const CarefulPlace> careful;  ///< Where it slows down.
  Fidelity fidelity = Fidelity::Exact;
};

struct WalkGraph;

/// Synthesises a walk from the motion graph along a path: starts standing (or from `previous`),
/// turns on the spot by steps where the path starts or ends in another direction, and ends
/// standing. The result keeps to the path (Exact) so that a clear path is a clear walk. Fails with
/// a sentence where the graph cannot walk (no start, no stop, no clips). `graph`
/// (runtime/motion/walk_graph.h) is made once and shared by all walks. Any thread may call.
Result<Walk> make_walk(const WalkGraph& graph, const WalkRequest& request);

/// The same for a single walk: makes the graph ready (some milliseconds) and forgets it.
Result<Walk> make_walk(const MotionGraph& graph, const WalkRequest& request);

}  // namespace docent::motion
