#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

#include "runtime/motion/clip_sequence.h"
#include "runtime/motion/draft.h"
#include "runtime/motion/path_track.h"
#include "runtime/motion/placement.h"
#include "runtime/motion/search.h"
#include "runtime/motion/smoothing.h"
#include "runtime/motion/speed_limit.h"
#include "runtime/motion/steps.h"
#include "runtime/motion/vary_strides.h"
#include "runtime/motion/walk.h"
#include "runtime/motion/walk_graph.h"
#include "runtime/motion/warp.h"

namespace docent::motion {
namespace {

constexpr double shortest_way = 0.02;          // metres: nearer than that is there already
constexpr double largest_curved_start = 0.5;   // radians: below, the first steps curve
constexpr double largest_facing_error = 0.06;  // radians left at the end without a turn
constexpr double largest_walking_turn = 1.05;  // radians that a walker turns into without braking
constexpr double run_out = 0.65;         // metres walked on, slowing down, before turning round
constexpr double least_stretch = 0.62;   // of the clips' strides; below, small steps
constexpr double most_stretch = 1.14;    // of the clips' strides
constexpr double braking_stretch = 0.1;  // where a wall is near, strides get as short as needed
constexpr double take_over_seconds = 0.35;
constexpr double walking_speed = 0.25;  // metres a second: slower bodies about stand

bool is_finite(Vec2 p) {
  return std::isfinite(p.x) && std::isfinite(p.y);
}

std::vector<Vec2> finite_points(std::span<const Vec2> path) {
  std::vector<Vec2> out;
  for (const Vec2 p : path)
    if (is_finite(p) && (out.empty() || glm::distance(out.back(), p) > 1e-6)) out.push_back(p);
  return out;
}

double direction_of(std::span<const Vec2> path, double along) {
  const Vec2 way = point_along(path, along) - path.front();
  return glm::length(way) > 1e-9 ? std::atan2(way.y, way.x) : 0;
}

/// Makes a walk stretch by stretch; each takes over the momentum of the one before.
class WalkMaker {
 public:
  WalkMaker(const WalkGraph& graph, const WalkRequest& request)
      : graph_(graph), request_(request), path_(finite_points(request.path)) {}

  Result<Walk> make() {
    if (path_.empty() && !request_.previous)
      return std::unexpected(Error{Errc::InvalidInput, "the path has no point to walk to"});
    if (request_.previous && request_.previous->root.empty())
      return std::unexpected(Error{Errc::InvalidInput, "the walk to go on from is empty"});
    begin();
    begin_variety();
    if (is_walking_)
      go_on_walking();
    else
      walk_from_standing(path_);
    if (request_.final_heading) turn_to(*request_.final_heading, largest_facing_error);
    if (walk_.root.empty()) stand_still();
    if (request_.fidelity == Fidelity::Exact) limit_speeds(graph_, walk_);
    for (float& along : walk_.along) along = std::max(0.0f, along - static_cast<float>(lead_in_));
    return std::move(walk_);
  }

 private:
  void begin() {
    if (request_.previous) {
      const auto frame = std::min(request_.previous_frame, frame_count(*request_.previous) - 1);
      momentum_ = momentum_at(graph_, *request_.previous, frame);
      const ClipFrame source = request_.previous->source[frame];
      is_walking_ = request_.previous->gait[frame] == Gait::Walk &&
                    source.clip < graph_.clip.size() &&
                    source.frame < graph_.clip[source.clip].last &&
                    glm::length(momentum_.body_velocity.position) > walking_speed;
      source_ = source;
      return;
    }
    Placement body{path_.front(), 0};
    if (path_.size() > 1) body.heading = direction_of(path_, 0.25);
    if (request_.start) body = *request_.start;
    momentum_ = momentum_of(graph_, graph_.before_walking, body);
    lead_in_ = glm::distance(body.position, path_.front());
    if (lead_in_ > shortest_way) path_.insert(path_.begin(), body.position);
  }

  /// What differs from step to step goes on where the walk before left it.
  void begin_variety() {
    walk_.seed = seed_of(path_);
    if (!request_.previous) return;
    const Walk& before = *request_.previous;
    const auto frame = std::min(request_.previous_frame, frame_count(before) - 1);
    walk_.seed = before.seed;
    walk_.first_step = before.first_step + steps_a_frame(graph_) * frame;
    if (is_walking_) first_share_ = share_before_end(graph_, frame_count(before) - 1 - frame);
  }

  StrideVariety variety() const {
    const bool is_first = walk_.root.empty();
    return {walk_.seed, walk_.first_step + steps_a_frame(graph_) * frame_count(walk_),
            is_first ? first_share_ : 0};
  }

  /// Feet come down elsewhere in each walk.
  std::uint32_t foot_seed() const {
    return walk_.seed ^ static_cast<std::uint32_t>(variety().first_step);
  }

  TrackPace pace() const {
    TrackPace pace;
    pace.speed = graph_.speed;
    pace.turning_rate = graph_.turning_rate;
    pace.most_share = request_.pace;
    pace.careful = request_.careful;
    if (request_.fidelity == Fidelity::Raw) pace.turning_rate = 1e9;
    return pace;
  }

  void go_on_walking() {
    if (polyline_length(path_) < shortest_way) return brake();
    const double turn = wrap_angle(direction_of(path_, 0.3) - momentum_.body.heading);
    std::vector<Vec2> path = path_;
    if (std::abs(turn) > largest_walking_turn) {
      const std::vector<Vec2> ahead = first_part(braking_line(), run_out);
      path.assign(ahead.begin(), ahead.end());
      path.insert(path.end(), ahead.rbegin(), ahead.rend());
      path.insert(path.end(), path_.begin(), path_.end());
      path = finite_points(path);
    }
    lead_in_ = polyline_length(path) - polyline_length(path_);
    if (walk_on(path, least_stretch)) return;
    brake();
    // A path that leads on the same way is joined where the body has come to; to any other it goes
    // back along the line that it knows to be clear.
    const double passed = glm::distance(momentum_.body.position, path_.front());
    const bool leads_on = std::abs(turn) <= largest_walking_turn;
    std::vector<Vec2> rest =
        joined(momentum_.body.position, leads_on ? last_part(path_, passed) : path_);
    lead_in_ = walk_.along.empty() ? 0.0 : static_cast<double>(walk_.along.back());
    lead_in_ += polyline_length(rest) - polyline_length(path_);
    walk_from_standing(std::move(rest));
  }

  /// Where the body would have gone on to.
  std::vector<Vec2> braking_line() const {
    std::vector<Vec2> line = finite_points(request_.old_path_ahead);
    if (line.size() >= 2) return line;
    const Vec2 at = momentum_.body.position;
    return {at,
            at + 3.0 * Vec2(std::cos(momentum_.body.heading), std::sin(momentum_.body.heading))};
  }

  static std::vector<Vec2> joined(Vec2 first, std::span<const Vec2> path) {
    std::vector<Vec2> out{first};
    out.insert(out.end(), path.begin(), path.end());
    return finite_points(out);
  }

  /// Stops within the shortest natural distance.
  void brake() {
    const std::vector<Vec2> line = braking_line();
    const double natural = graph_.clip[source_.clip].to_stand.back()[source_.frame];
    const double room = polyline_length(line);
    const double distance = std::min(std::isfinite(natural) ? natural : 1.0, room);
    if (distance < shortest_way || !walk_on(first_part(line, distance), braking_stretch))
      step_to({line.front(), momentum_.body.heading});
  }

  /// Comes to a stand by putting one foot beside the other.
  void step_to(const Placement& place) {
    const Side first = momentum_.planted[0] ? Side::Right : Side::Left;
    const std::vector<Step> steps{{first, place}, {other(first), place}};
    add(make_steps(graph_, momentum_, steps, graph_.after_walking, Gait::Walk));
  }

  void walk_from_standing(std::vector<Vec2> path) {
    if (path.size() < 2 || polyline_length(path) < shortest_way) return;
    turn_to(direction_of(path, 0.3), largest_curved_start);
    std::vector<MotionStart> starts;
    starts.reserve(graph_.starts.size());
    for (const std::uint32_t clip : graph_.starts)
      starts.push_back({{clip, graph_.clip[clip].first}, momentum_.body});
    if (!walk_along(path, starts, least_stretch, pace())) walk_by_small_steps(path);
  }

  bool walk_on(const std::vector<Vec2>& path, double shortest_stride) {
    const Vec2 velocity = momentum_.body_velocity.position;
    TrackPace pace = this->pace();
    pace.first_share = std::min(1.0, glm::length(velocity) / graph_.speed);
    pace.first_turn = wrap_angle(direction_of(path, 0.3) - std::atan2(velocity.y, velocity.x));
    return walk_along(path, {{source_, momentum_.body}}, shortest_stride, pace);
  }

  /// False where the clips cannot do it: no way to a stand from there, or strides would have to be
  /// too short or too long.
  bool walk_along(const std::vector<Vec2>& path, const std::vector<MotionStart>& starts,
                  double shortest_stride, const TrackPace& pace) {
    const PathTrack track = make_path_track(path, pace);
    const auto began = std::chrono::steady_clock::now();
    const MotionPlan plan = request_.fidelity == Fidelity::Raw
                                ? find_raw_motion(graph_, track, starts)
                                : find_warped_motion(graph_, track, starts);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - began;
    if (plan.expanded == 0) return false;
    const double stretch = track.effort.back() / std::max(plan.effort, 1e-6);
    const bool exact = request_.fidelity == Fidelity::Exact;
    if (exact && (stretch < shortest_stride || stretch > most_stretch)) return false;
    const ClipPath& first = graph_.clip[plan.start.clip];
    const ClipSequence sequence =
        play(graph_, plan, compose(momentum_.body, inverse(first.body[plan.start.frame])));
    Draft draft = request_.fidelity == Fidelity::Raw
                      ? as_it_is(graph_, sequence)
                      : warp_onto(graph_, sequence, track, momentum_, foot_seed());
    if (exact) vary_strides(graph_, variety(), draft);
    draft.walk.transitions = static_cast<std::uint32_t>(plan.transitions.size());
    draft.walk.expanded = plan.expanded;
    draft.walk.considered = plan.considered;
    draft.walk.scope = plan.scope;
    draft.walk.search_seconds = taken.count();
    add(std::move(draft));
    return true;
  }

  void walk_by_small_steps(const std::vector<Vec2>& path) {
    const PathTrack track = make_path_track(path, pace());
    const std::vector<Step> steps = plan_short_walk(track, momentum_);
    Draft draft = make_steps(graph_, momentum_, steps, graph_.after_walking, Gait::Walk);
    const auto frames = static_cast<double>(draft.walk.along.size() - 1);
    for (std::size_t f = 0; f < draft.walk.along.size(); ++f)
      draft.walk.along[f] = static_cast<float>(track.length() * static_cast<double>(f) / frames);
    add(std::move(draft));
  }

  void turn_to(double heading, double tolerance) {
    const double angle = wrap_angle(heading - momentum_.body.heading);
    const bool in_the_air = !momentum_.planted[0] || !momentum_.planted[1];
    if (std::abs(angle) <= tolerance && !in_the_air) return;
    add(make_steps(graph_, momentum_, plan_turn(momentum_.body, angle, momentum_),
                   graph_.after_walking, Gait::Turn));
  }

  void stand_still() { add(make_steps(graph_, momentum_, {}, graph_.after_walking, Gait::Idle)); }

  void add(Draft draft) {
    inertialise(momentum_, take_over_seconds, draft);
    if (request_.fidelity == Fidelity::Exact) {
      lower_hips(graph_, draft);
      place_feet(graph_, draft);
    }
    const float along = walk_.along.empty() ? 0.0f : walk_.along.back();
    for (float& a : draft.walk.along) a += along;
    append(std::move(draft), walk_);
    momentum_ = momentum_at(graph_, walk_, frame_count(walk_) - 1);
    momentum_.planted = {true, true};
  }

  const WalkGraph& graph_;
  const WalkRequest& request_;
  std::vector<Vec2> path_;
  Momentum momentum_;
  ClipFrame source_;
  bool is_walking_ = false;
  double first_share_ = 0;  ///< Of what differs from step to step, when it begins.
  double lead_in_ = 0;      ///< Metres walked before the asked path begins.
  Walk walk_;
};

}  // namespace

Result<Walk> make_walk(const WalkGraph& graph, const WalkRequest& request) {
  return WalkMaker(graph, request).make();
}

Result<Walk> make_walk(const MotionGraph& graph, const WalkRequest& request) {
  const Result<WalkGraph> ready = make_walk_graph(graph);
  if (!ready) return std::unexpected(ready.error());
  return make_walk(*ready, request);
}

}  // namespace docent::motion
