#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "runtime/model/motion/motion_graph.h"
#include "runtime/model/result.h"
#include "runtime/motion/leg.h"
#include "runtime/motion/speed_limit.h"

namespace docent::motion {

/// The lower ends of a leg, in the frame of whatever they belong to.
struct LegEnds {
  Vec3 toe{}, ankle{};
};

/// What a search and a synthesis need to know of a clip.
struct ClipPath {
  std::vector<double> facing;                ///< Per frame: of the hips, unwrapped radians.
  std::array<std::vector<LegEnds>, 2> ends;  ///< Per side and frame.
  std::vector<Placement> body;  ///< Per frame: the root with the gait's sway taken out.
  std::vector<double> effort;   ///< Per frame: metres walked forwards since the first frame.
  std::uint32_t rank = 0;       ///< Of its class: the smallest scope that holds it.
  /// Per scope and frame: the least metres to a standing end by transitions of the scope; infinite
  /// where no way leads to one.
  std::vector<std::vector<double>> to_stand;
  std::uint32_t first = 0;  ///< Where its motion begins (a start clip stands for a while).
  std::uint32_t last = 0;   ///< Where its motion has ended.
  std::uint32_t first_transition = 0, last_transition = 0;  ///< Those from it, in the graph.
};

/// A standing body, placed at the origin of the floor and facing east.
struct Stand {
  Vec3 root{};
  std::vector<Quat> rotation;
  std::array<Foot, 2> foot;
};

/// How a body's arms hang on the average while it walks.
struct ArmsAtEase {
  std::array<Quat, 2> shoulder{Quat{1, 0, 0, 0}, Quat{1, 0, 0, 0}};  ///< Left, right.
};

/// A motion graph made ready to walk: made once, shared by all walks. Borrows the motion graph,
/// which must outlive it. Immutable, so any thread may read it.
///
/// A scope is the part of the graph that a search looks at. Scope 0 is the own graph of the class
/// "walk"; where no clip of that walks on, of the class with the most frames. Each further scope
/// adds the graph of one class, and what joins it to the others: of the classes left, the one most
/// like the first (MotionClass::coefficient). The last scope is the whole graph.
struct WalkGraph {
  const MotionGraph* motion = nullptr;
  Legs legs;
  double frame_rate = 120;
  double stride_seconds = 1.1;  ///< Two steps of the ordinary walk.
  double speed = 1;             ///< Metres a second of the ordinary walk.
  std::uint32_t scopes = 1;
  std::vector<ClipPath> clip;
  /// Per transition: the smallest scope that takes it; `scopes` where it leads from or to standing.
  std::vector<std::uint32_t> narrowest;
  /// Per scope and transition: the least metres to a standing end after it by transitions of the
  /// scope; infinite where the scope does not take it.
  std::vector<std::vector<float>> left_after;
  std::vector<std::uint32_t> starts, stops;  ///< Clips that begin, or end, standing; by rank. Every
                                             ///< start leads to a stand.
  QuickestMotion quickest;                   ///< In its clips.
  double turning_rate = 2.4;            ///< Radians a second that a walking body turns at most.
  std::array<float, 2> toe_height{};    ///< Of a planted foot's toe joint, metres.
  std::array<float, 2> ankle_height{};  ///< Of a planted foot's ankle joint, metres.
  ArmsAtEase arms;
  Stand before_walking;  ///< How the first start clip begins.
  Stand after_walking;   ///< How the first stop clip ends.
};

/// Can a walk take a transition in this scope, and come to a stand after it?
inline bool leads_to_stand(const WalkGraph& graph, std::size_t transition,
                           std::uint32_t scope) noexcept {
  return graph.left_after[scope][transition] != std::numeric_limits<float>::infinity();
}

/// Fails with a sentence where the graph cannot walk: no clips, no legs, no start, no stop, clips
/// of different rates, or no way from a start to a stop.
Result<WalkGraph> make_walk_graph(const MotionGraph& motion);

/// The body's circle for a run of frames: roots and facings with the gait's sway taken out.
/// `roots` and `headings` (unwrapped) have one entry per frame.
std::vector<Placement> body_track(std::span<const Vec2> roots, std::span<const double> headings,
                                  double stride_frames);

/// Metres walked forwards since the first frame, never decreasing.
std::vector<double> effort_along(std::span<const Placement> body);

/// The pose as it is when the body stands at the origin facing east.
Stand stand_of(const WalkGraph& graph, const PoseView& pose, const Placement& body);

}  // namespace docent::motion
