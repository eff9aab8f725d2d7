#include "runtime/motion/search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "runtime/motion/placement.h"
#include "runtime/motion/smoothing.h"

namespace docent {
namespace {

constexpr double bucket_size = 0.1;    // metres of progress
constexpr double least_seconds = 0.4;  // of plain clip between two blends
constexpr double look_seconds = 0.05;  // between two looks at the path
constexpr double blend_cost = 0.012;   // radians squared times metres: a blend costs as much as
                                       // walking one metre with the heading off by 6 degrees
constexpr double distance_cost = 4.0;  // per square metre of a transition's pose distance
constexpr double misfit_cost = 2.0;    // per square of the strides' relative warp and metre
constexpr double gap_cost = 8.0;       // per square metre between a raw track's end and the path's
constexpr double largest_overshoot = 1.5;  // metres of effort beyond the path's end

/// Follows a track that will be warped: `progress` is effort and the heading error fades over the
/// distance in which a warp takes it up.
struct WarpedFollower {
  static constexpr std::size_t beam_width = 16;  // 40 finds nothing better on most paths
  static constexpr double forgetting = 0.7;      // metres

  double progress = 0;
  double heading_error = 0;
  double track_heading = 0;  ///< At `progress`.
  std::size_t hint = 0;

  WarpedFollower(const WalkGraph&, const PathTrack& track, const MotionStart& start)
      : heading_error(wrap_angle(start.body.heading - track.heading.front())),
        track_heading(track.heading.front()) {}

  void enter(const Placement&) noexcept {}

  double advance(const PathTrack& track, const ClipPath& clip, std::size_t from,
                 std::size_t to) noexcept {
    const double step = clip.effort[to] - clip.effort[from];
    progress += step;
    const double heading = at_effort(track, progress, hint).placement.heading;
    heading_error += clip.body[to].heading - clip.body[from].heading - (heading - track_heading);
    heading_error *= forgetting / (forgetting + step);
    track_heading = heading;
    return heading_error * heading_error * step;
  }

  static double total(const PathTrack& track) noexcept { return track.effort.back(); }
  /// What stands at the end is judged by its progress alone.
  double end_gap(const PathTrack&, const ClipPath&) const noexcept { return 0; }
  std::uint32_t likeness() const noexcept { return 0; }
};

/// Follows a track with the clips' own motion: `progress` is metres of path.
struct RawFollower {
  static constexpr std::size_t beam_width = 40;
  static constexpr double side_weight = 6.0;  // square radians per square metre

  double progress = 0;
  Placement clip_to_floor;  ///< Lays the present clip onto the floor.
  double side_error = 0, heading_error = 0;
  std::size_t at = 0;  ///< Sample of the track that is nearest.

  RawFollower(const WalkGraph& graph, const PathTrack& track, const MotionStart& start) {
    const Placement body = graph.clip[start.frame.clip].body[start.frame.frame];
    clip_to_floor = compose(start.body, inverse(body));
    find_nearest(track, start.body);
  }

  void enter(const Placement& alignment) noexcept {
    clip_to_floor = compose(clip_to_floor, alignment);
  }

  void find_nearest(const PathTrack& track, const Placement& body) noexcept {
    const auto distance_to = [&](std::size_t i) {
      return glm::distance(body.position, track.position[i]);
    };
    const auto ahead = static_cast<std::size_t>(0.3 / track.spacing);
    const std::size_t last = std::min(at + ahead, track.position.size() - 1);
    for (std::size_t i = at + 1; i <= last; ++i)
      if (distance_to(i) <= distance_to(at)) at = i;
    progress = track.spacing * static_cast<double>(at);
    const double heading = track.heading[at];
    const Vec2 offset = body.position - track.position[at];
    side_error = glm::length(offset);
    heading_error = wrap_angle(body.heading - heading);
  }

  double advance(const PathTrack& track, const ClipPath& clip, std::size_t from,
                 std::size_t to) noexcept {
    find_nearest(track, compose(clip_to_floor, clip.body[to]));
    const double step = clip.effort[to] - clip.effort[from];
    return (side_weight * side_error * side_error + 0.3 * heading_error * heading_error) * step;
  }

  static double total(const PathTrack& track) noexcept { return track.length(); }
  /// A track that runs past the path's end shows no further progress: what counts is where it ends.
  double end_gap(const PathTrack& track, const ClipPath& clip) const noexcept {
    const Placement end = compose(clip_to_floor, clip.body[clip.last]);
    return glm::distance(end.position, track.position.back());
  }
  std::uint32_t likeness() const noexcept {
    const auto steps = [](double value, double step) {
      return static_cast<std::uint32_t>(static_cast<std::int32_t>(std::lround(value / step))) &
             255u;
    };
    return steps(side_error, 0.04) << 8 | steps(heading_error, 0.08);
  }
};

constexpr std::uint32_t no_index = std::numeric_limits<std::uint32_t>::max();

/// A moment of the search: the middle of a transition's destination (or the start).
template <typename Follower>
struct State {
  Follower follower;
  double cost = 0;
  double effort = 0;
  std::uint32_t parent = no_index;      ///< Among the expanded states.
  std::uint32_t transition = no_index;  ///< That led here.
};

template <typename Follower>
class BeamSearch {
 public:
  BeamSearch(const WalkGraph& graph, const PathTrack& track, const MotionStart& start)
      : graph_(graph), track_(track), start_(start), goal_(Follower::total(track)) {}

  MotionPlan run() {
    buckets_.resize(static_cast<std::size_t>((goal_ + largest_overshoot) / bucket_size) + 1);
    keep(State<Follower>{Follower(graph_, track_, start_)});
    for (std::size_t b = 0; b < buckets_.size(); ++b) {
      // A state may lead to its own bucket, so a bucket is done when nothing new has come.
      for (std::size_t round = 0; !buckets_[b].empty() && round < 4; ++round) {
        std::vector<State<Follower>> states = std::move(buckets_[b]);
        buckets_[b].clear();
        narrow(states);
        for (const State<Follower>& state : states) expand(state);
      }
      buckets_[b] = {};
    }
    return plan();
  }

 private:
  const MotionGraph& motion() const { return *graph_.motion; }

  ClipFrame frame_of(const State<Follower>& state) const {
    return state.transition == no_index ? start_.frame : motion().transitions[state.transition].to;
  }

  void keep(State<Follower> state) {
    const double progress = std::max(0.0, state.follower.progress);
    const auto bucket = static_cast<std::size_t>(progress / bucket_size);
    if (bucket < buckets_.size()) buckets_[bucket].push_back(std::move(state));
  }

  /// Of states that are alike the cheapest, and of those the cheapest few.
  void narrow(std::vector<State<Follower>>& states) const {
    std::sort(states.begin(), states.end(), [](const auto& a, const auto& b) {
      if (a.transition != b.transition) return a.transition < b.transition;
      const auto like_a = a.follower.likeness(), like_b = b.follower.likeness();
      return like_a != like_b ? like_a < like_b : a.cost < b.cost;
    });
    const auto alike = [](const auto& a, const auto& b) {
      return a.transition == b.transition && a.follower.likeness() == b.follower.likeness();
    };
    states.erase(std::unique(states.begin(), states.end(), alike), states.end());
    const auto cheaper = [](const auto& a, const auto& b) {
      return a.cost != b.cost ? a.cost < b.cost : a.transition < b.transition;
    };
    constexpr auto width = Follower::beam_width;
    if (states.size() > width) {
      std::nth_element(states.begin(), states.begin() + width, states.end(), cheaper);
      states.erase(states.begin() + width, states.end());
    }
    std::sort(states.begin(), states.end(), cheaper);
  }

  /// Walks on through the state's clip and branches off at every transition on the way.
  void expand(const State<Follower>& state) {
    const auto parent = static_cast<std::uint32_t>(expanded_.size());
    expanded_.push_back(state);
    const ClipFrame at = frame_of(state);
    const ClipPath& clip = graph_.clip[at.clip];
    State<Follower> walker = state;
    walker.parent = parent;
    std::size_t frame = at.frame;
    const auto walk_to = [&](std::size_t to) {
      const auto look = static_cast<std::size_t>(look_seconds * graph_.frame_rate) + 1;
      while (frame < to) {
        const std::size_t next = std::min(frame + look, to);
        walker.cost += walker.follower.advance(track_, clip, frame, next);
        walker.effort += clip.effort[next] - clip.effort[frame];
        frame = next;
      }
    };
    bool branched = false;
    for (const bool hurried : {false, true}) {
      if (branched) break;
      const std::size_t earliest = earliest_middle(state, hurried);
      for (std::uint32_t t = clip.first_transition; t < clip.last_transition; ++t) {
        const Transition& way = motion().transitions[t];
        if (way.from.frame < at.frame || way.from.frame < earliest + way.radius) continue;
        if (way.from.frame < frame) continue;
        walk_to(way.from.frame);
        branch(walker, t);
        branched = true;
      }
    }
    const bool ends_standing = motion().clips[at.clip].role == ClipRole::Stop;
    if (ends_standing && frame <= clip.last) {
      walk_to(clip.last);
      arrive(walker, clip.last);
    }
  }

  /// The frame before which the middle of the next transition, less its radius, must not be.
  std::size_t earliest_middle(const State<Follower>& state, bool hurried) const {
    if (state.transition == no_index) return start_.frame.frame;
    const Transition& came = motion().transitions[state.transition];
    const double rest = hurried ? 0.0 : least_seconds * graph_.frame_rate;
    return came.to.frame + came.radius + static_cast<std::size_t>(rest);
  }

  void branch(const State<Follower>& walker, std::uint32_t t) {
    const Transition& way = motion().transitions[t];
    const double left = graph_.clip[way.to.clip].to_stand[way.to.frame];
    if (walker.effort + left > effort_limit()) return;
    State<Follower> next = walker;
    next.follower.enter(way.alignment);
    next.cost += blend_cost + distance_cost * way.distance * way.distance;
    next.transition = t;
    keep(std::move(next));
  }

  double effort_limit() const { return 1.6 * goal_ + 2 * largest_overshoot; }

  void arrive(State<Follower> walker, std::uint32_t frame) {
    const double misfit = goal_ - walker.follower.progress;
    const double gap = walker.follower.end_gap(track_, graph_.clip[frame_of(walker).clip]);
    walker.cost += misfit_cost * misfit * misfit / std::max(goal_, 0.5) + gap_cost * gap * gap;
    if (best_ && best_->cost <= walker.cost) return;
    best_ = std::move(walker);
    best_frame_ = frame;
  }

  MotionPlan plan() const {
    MotionPlan plan;
    if (!best_) return plan;
    plan.start = start_.frame;
    plan.last_frame = best_frame_;
    plan.effort = best_->effort;
    plan.cost = best_->cost;
    plan.expanded = static_cast<std::uint32_t>(expanded_.size());
    for (std::uint32_t i = best_->parent; i != no_index; i = expanded_[i].parent)
      if (expanded_[i].transition != no_index) plan.transitions.push_back(expanded_[i].transition);
    std::reverse(plan.transitions.begin(), plan.transitions.end());
    return plan;
  }

  const WalkGraph& graph_;
  const PathTrack& track_;
  MotionStart start_;
  double goal_;
  std::vector<std::vector<State<Follower>>> buckets_;
  std::vector<State<Follower>> expanded_;
  std::optional<State<Follower>> best_;
  std::uint32_t best_frame_ = 0;
};

}  // namespace

MotionPlan find_warped_motion(const WalkGraph& graph, const PathTrack& track,
                              const MotionStart& start) {
  return BeamSearch<WarpedFollower>(graph, track, start).run();
}

MotionPlan find_raw_motion(const WalkGraph& graph, const PathTrack& track,
                           const MotionStart& start) {
  return BeamSearch<RawFollower>(graph, track, start).run();
}

}  // namespace docent
