#include "runtime/motion/walk_graph.h"

#include <algorithm>
#include <cmath>

#include "runtime/model/none.h"
#include "runtime/motion/placement.h"
#include "runtime/motion/smoothing.h"
#include "runtime/motion/vary_strides.h"

namespace docent::motion {
namespace {

constexpr double within_stride = 1.4;    // of a stride's mean: how quickly a body turns at most
constexpr double still_speed = 0.06;     // metres a second of the hips: below it a body stands
constexpr double stillness_kept = 0.08;  // seconds of standing kept before a start, after a stop

PoseView frame_of(const MotionClip& clip, std::size_t frame, std::vector<Quat>& buffer) {
  const auto first = clip.rotation.begin() + static_cast<std::ptrdiff_t>(frame * clip.joint_count);
  buffer.assign(first, first + clip.joint_count);
  return {clip.root[frame], buffer};
}

std::vector<double> facings(const Skeleton& skeleton, const Legs& legs, const MotionClip& clip) {
  std::vector<double> out(frame_count(clip));
  std::vector<Quat> buffer;
  for (std::size_t f = 0; f < out.size(); ++f)
    out[f] = facing(skeleton, legs, frame_of(clip, f, buffer));
  unwrap_angles(out);
  return out;
}

std::vector<LegEnds> leg_ends(const Skeleton& skeleton, const Leg& leg, const MotionClip& clip) {
  std::vector<LegEnds> ends;
  std::vector<Quat> buffer;
  for (std::size_t f = 0; f < frame_count(clip); ++f) {
    const LegPose at = leg_pose(skeleton, leg, frame_of(clip, f, buffer));
    ends.push_back({at.position[leg.toe], at.position[leg.ankle]});
  }
  return ends;
}

double speed_at(const MotionClip& clip, std::size_t frame) {
  const std::size_t span = std::max<std::size_t>(1, static_cast<std::size_t>(clip.frame_rate / 24));
  const std::size_t from = frame > span ? frame - span : 0;
  const std::size_t to = std::min<std::size_t>(frame + span, frame_count(clip) - 1);
  if (to == from) return 0;
  return glm::distance(to_floor(clip.root[from]), to_floor(clip.root[to])) * clip.frame_rate /
         static_cast<double>(to - from);
}

/// Where standing ends at a start clip's beginning, and begins at a stop clip's end.
void trim_stillness(const MotionClip& clip, ClipPath& path) {
  const auto kept = static_cast<std::uint32_t>(stillness_kept * clip.frame_rate);
  path.first = 0;
  path.last = frame_count(clip) - 1;
  if (clip.role == ClipRole::Start) {
    std::uint32_t moving = 0;
    while (moving < path.last && speed_at(clip, moving) < still_speed) ++moving;
    path.first = moving > kept ? moving - kept : 0;
  }
  if (clip.role == ClipRole::Stop) {
    std::uint32_t moving = path.last;
    while (moving > 0 && speed_at(clip, moving) < still_speed) --moving;
    path.last = std::min(path.last, moving + kept);
  }
}

template <typename Value>
Value median_of(std::vector<Value> values, Value otherwise) {
  if (values.empty()) return otherwise;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

bool is_planted(const FootPlants& plants, Side side) {
  return side == Side::Left ? plants.left : plants.right;
}

/// What the guide does where nothing else is needed.
std::size_t home_class(const MotionGraph& motion) {
  std::size_t home = 0, most = 0;
  for (std::size_t i = 0; i < motion.classes.size(); ++i) {
    std::size_t frames = 0;
    for (const MotionClip& clip : motion.clips) {
      if (clip.motion_class != motion.classes[i].name) continue;
      const bool goes_on = clip.role != ClipRole::Start && clip.role != ClipRole::Stop;
      if (goes_on && clip.motion_class == "walk") return i;
      frames += frame_count(clip);
    }
    if (frames > most) most = frames, home = i;
  }
  return home;
}

void rank_classes(WalkGraph& graph) {
  const std::vector<MotionClass>& classes = graph.motion->classes;
  if (classes.empty()) return;
  std::vector<const MotionClass*> order;
  for (const MotionClass& motion_class : classes) order.push_back(&motion_class);
  const std::size_t home = home_class(*graph.motion);
  std::swap(order.front(), order[home]);
  std::stable_sort(order.begin() + 1, order.end(), [home](const auto* a, const auto* b) {
    return a->coefficient[home] < b->coefficient[home];
  });
  graph.scopes = static_cast<std::uint32_t>(order.size());
  for (std::size_t c = 0; c < graph.clip.size(); ++c)
    for (std::uint32_t rank = 0; rank < graph.scopes; ++rank)
      if (order[rank]->name == graph.motion->clips[c].motion_class) graph.clip[c].rank = rank;
}

void rank_transitions(WalkGraph& graph) {
  const MotionGraph& motion = *graph.motion;
  std::vector<bool> is_own(motion.transitions.size());
  for (const MotionClass& motion_class : motion.classes)
    for (const std::uint32_t t : motion_class.transition) is_own[t] = true;
  for (std::size_t t = 0; t < motion.transitions.size(); ++t) {
    const std::uint32_t from = graph.clip[motion.transitions[t].from.clip].rank,
                        to = graph.clip[motion.transitions[t].to.clip].rank;
    graph.narrowest.push_back(from == to && !is_own[t] ? graph.scopes - 1 : std::max(from, to));
  }
}

/// Time between two plants of one foot.
double stride_seconds(const WalkGraph& graph) {
  std::vector<double> strides;
  for (std::size_t c = 0; c < graph.clip.size(); ++c) {
    const MotionClip& clip = graph.motion->clips[c];
    if (graph.clip[c].rank > 0) continue;
    for (const Side side : both_sides) {
      double last = -1;
      for (std::size_t f = 1; f < clip.plants.size(); ++f) {
        if (is_planted(clip.plants[f - 1], side) || !is_planted(clip.plants[f], side)) continue;
        const double now = static_cast<double>(f) / clip.frame_rate;
        if (last >= 0 && now - last > 0.7 && now - last < 1.8) strides.push_back(now - last);
        last = now;
      }
    }
  }
  return median_of(std::move(strides), 1.1);
}

void measure_resting_heights(WalkGraph& graph) {
  const MotionGraph& motion = *graph.motion;
  std::vector<Quat> buffer;
  for (const Side side : both_sides) {
    std::vector<float> toes, ankles;
    const Leg& leg = graph.legs[side];
    for (std::size_t c = 0; c < graph.clip.size(); ++c) {
      if (graph.clip[c].rank > 0) continue;
      const MotionClip& clip = motion.clips[c];
      for (std::size_t f = 0; f < clip.plants.size(); ++f) {
        if (!is_planted(clip.plants[f], side)) continue;
        const LegPose at = leg_pose(motion.skeleton, leg, frame_of(clip, f, buffer));
        toes.push_back(at.position[leg.toe].y);
        ankles.push_back(at.position[leg.ankle].y);
      }
    }
    graph.toe_height[index_of(side)] = median_of(std::move(toes), 0.03f);
    graph.ankle_height[index_of(side)] = median_of(std::move(ankles), 0.08f);
  }
}

double ordinary_speed(const WalkGraph& graph) {
  std::vector<double> speeds;
  for (std::size_t c = 0; c < graph.clip.size(); ++c) {
    const MotionClip& clip = graph.motion->clips[c];
    if (clip.role == ClipRole::Start || clip.role == ClipRole::Stop || graph.clip[c].rank > 0)
      continue;
    const double seconds = static_cast<double>(frame_count(clip)) / clip.frame_rate;
    if (seconds > 0.2) speeds.push_back(graph.clip[c].effort.back() / seconds);
  }
  return std::clamp(median_of(std::move(speeds), 1.0), 0.3, 3.0);
}

/// How quickly the body turns that turns most. Its facing is a mean over a stride; within one it
/// turns more quickly.
double turning_rate(const WalkGraph& graph) {
  double most = 0;
  for (const ClipPath& clip : graph.clip)
    for (std::size_t f = 1; f < clip.body.size(); ++f)
      most = std::max(most, std::abs(clip.body[f].heading - clip.body[f - 1].heading));
  return std::clamp(within_stride * most * graph.frame_rate, 1.0, 2.4);
}

/// Who stands has arrived: no search leaves a clip from there, or comes to where it still stands.
void leave_out_standing(WalkGraph& graph) {
  const auto& transitions = graph.motion->transitions;
  const auto is_walking = [&](const ClipFrame& at) {
    return at.frame >= graph.clip[at.clip].first && at.frame <= graph.clip[at.clip].last;
  };
  for (std::size_t t = 0; t < transitions.size(); ++t)
    if (!is_walking(transitions[t].from) || !is_walking(transitions[t].to))
      graph.narrowest[t] = graph.scopes;
}

void find_transition_ranges(WalkGraph& graph) {
  const auto& transitions = graph.motion->transitions;
  for (std::uint32_t c = 0; c < graph.clip.size(); ++c) {
    const auto of_clip = [](const Transition& t, std::uint32_t clip) { return t.from.clip < clip; };
    const auto first = std::lower_bound(transitions.begin(), transitions.end(), c, of_clip);
    const auto last = std::lower_bound(first, transitions.end(), c + 1, of_clip);
    graph.clip[c].first_transition = static_cast<std::uint32_t>(first - transitions.begin());
    graph.clip[c].last_transition = static_cast<std::uint32_t>(last - transitions.begin());
  }
}

/// The least effort from every frame to a standing end within a scope. One sweep of a clip takes it
/// from its transitions' destinations; sweeps go on until nothing improves, which takes as many as
/// the shortest ways have transitions.
void measure_ways_to_stand(WalkGraph& graph, std::uint32_t scope) {
  const auto& transitions = graph.motion->transitions;
  for (ClipPath& clip : graph.clip) clip.to_stand.emplace_back(clip.effort.size(), infinity);
  for (const std::uint32_t c : graph.stops) {
    ClipPath& clip = graph.clip[c];
    if (clip.rank > scope) continue;
    for (std::size_t f = 0; f <= clip.last; ++f)
      clip.to_stand[scope][f] = clip.effort[clip.last] - clip.effort[f];
  }
  for (bool improved = true; improved;) {
    improved = false;
    for (ClipPath& clip : graph.clip) {
      if (clip.rank > scope) continue;
      std::vector<double>& to_stand = clip.to_stand[scope];
      double best = infinity;  // effort at the transition plus what comes after it
      std::uint32_t t = clip.last_transition;
      for (std::size_t f = to_stand.size(); f-- > 0;) {
        for (; t > clip.first_transition && transitions[t - 1].from.frame >= f; --t) {
          const Transition& way = transitions[t - 1];
          if (graph.narrowest[t - 1] > scope) continue;
          best = std::min(best, clip.effort[way.from.frame] +
                                    graph.clip[way.to.clip].to_stand[scope][way.to.frame]);
        }
        if (best - clip.effort[f] < to_stand[f] - 1e-9) {
          to_stand[f] = best - clip.effort[f];
          improved = true;
        }
      }
    }
  }
}

void measure_ways_after(WalkGraph& graph, std::uint32_t scope) {
  std::vector<float>& left = graph.left_after.emplace_back();
  for (std::size_t t = 0; t < graph.narrowest.size(); ++t) {
    const ClipFrame& to = graph.motion->transitions[t].to;
    left.push_back(graph.narrowest[t] > scope
                       ? std::numeric_limits<float>::infinity()
                       : static_cast<float>(graph.clip[to.clip].to_stand[scope][to.frame]));
  }
}

bool is_well_formed(const MotionGraph& motion) {
  for (const MotionClip& clip : motion.clips)
    if (clip.root.empty() || clip.joint_count != motion.skeleton.joint.size() ||
        clip.rotation.size() != clip.root.size() * clip.joint_count ||
        clip.plants.size() != clip.root.size())
      return false;
  for (const Transition& t : motion.transitions)
    for (const ClipFrame& end : {t.from, t.to})
      if (end.clip >= motion.clips.size() || end.frame >= frame_count(motion.clips[end.clip]))
        return false;
  for (const MotionClass& motion_class : motion.classes)
    for (const std::uint32_t t : motion_class.transition)
      if (t >= motion.transitions.size()) return false;
  return true;
}

std::unexpected<Error> cannot_walk(const char* why) {
  return std::unexpected(Error{Errc::InvalidInput, why});
}

void describe_clip(WalkGraph& graph, std::uint32_t index) {
  const MotionClip& clip = graph.motion->clips[index];
  ClipPath& path = graph.clip[index];
  std::vector<Vec2> roots(clip.root.size());
  std::transform(clip.root.begin(), clip.root.end(), roots.begin(), to_floor);
  path.facing = facings(graph.motion->skeleton, graph.legs, clip);
  for (const Side side : both_sides)
    path.ends[index_of(side)] = leg_ends(graph.motion->skeleton, graph.legs[side], clip);
  path.body = body_track(roots, path.facing, graph.stride_seconds * clip.frame_rate);
  path.effort = effort_along(path.body);
  trim_stillness(clip, path);
  if (clip.role == ClipRole::Start) graph.starts.push_back(index);
  if (clip.role == ClipRole::Stop) graph.stops.push_back(index);
}

Stand stand_in_clip(const WalkGraph& graph, std::uint32_t index, std::uint32_t frame) {
  std::vector<Quat> buffer;
  return stand_of(graph, frame_of(graph.motion->clips[index], frame, buffer),
                  graph.clip[index].body[frame]);
}

}  // namespace

std::vector<Placement> body_track(std::span<const Vec2> roots, std::span<const double> headings,
                                  double stride_frames) {
  // A box as long as a stride silences the stride's frequency and all its multiples. Smoothing cuts
  // corners; adding back what a second pass takes away (Tukey's twicing) undoes that to second
  // order.
  const auto stride = static_cast<std::size_t>(std::max(stride_frames, 1.0)) | 1u;
  const std::size_t jerk = (stride / 4) | 1u;
  const auto smooth_points = [&](std::span<const Vec2> points) {
    return box_pinned(box_pinned(points, stride), jerk);
  };
  const std::vector<Vec2> once = smooth_points(roots), twice = smooth_points(once);
  const std::vector<double> heading = box_held(box_held(headings, stride), jerk);
  std::vector<Placement> body(roots.size());
  for (std::size_t f = 0; f < body.size(); ++f) body[f] = {2.0 * once[f] - twice[f], heading[f]};
  return body;
}

std::vector<double> effort_along(std::span<const Placement> body) {
  std::vector<double> effort(body.size(), 0.0);
  for (std::size_t f = 1; f < body.size(); ++f) {
    const double heading = body[f].heading;
    const double forwards =
        dot(body[f].position - body[f - 1].position, Vec2(std::cos(heading), std::sin(heading)));
    effort[f] = effort[f - 1] + std::max(0.0, forwards);
  }
  return effort;
}

Stand stand_of(const WalkGraph& graph, const PoseView& pose, const Placement& body) {
  const Placement home = inverse(body);
  const Quat turn = world_rotation(home.heading);
  Stand stand{moved(home, pose.root), {pose.rotation.begin(), pose.rotation.end()}, {}};
  stand.rotation[0] = turn * stand.rotation[0];
  const PoseView placed{stand.root, stand.rotation};
  for (const Side side : both_sides)
    stand.foot[index_of(side)] = foot_of(graph.motion->skeleton, graph.legs[side], placed);
  return stand;
}

Result<WalkGraph> make_walk_graph(const MotionGraph& motion) {
  if (motion.clips.empty())
    return cannot_walk("the museum holds no walking clips: compile it without --no-motion");
  if (!is_well_formed(motion)) return cannot_walk("the motion graph is damaged: recompile");
  WalkGraph graph;
  graph.motion = &motion;
  const std::optional<Legs> legs = find_legs(motion.skeleton);
  if (!legs) return cannot_walk("the clips' skeleton has no legs of hip, knee, ankle and toe");
  graph.legs = *legs;
  graph.frame_rate = motion.clips.front().frame_rate;
  for (const MotionClip& clip : motion.clips)
    if (clip.frame_rate != graph.frame_rate)
      return cannot_walk("the clips have different frame rates");
  graph.clip.resize(motion.clips.size());
  rank_classes(graph);
  rank_transitions(graph);
  graph.stride_seconds = stride_seconds(graph);
  for (std::uint32_t c = 0; c < graph.clip.size(); ++c) describe_clip(graph, c);
  if (graph.starts.empty()) return cannot_walk("no clip begins standing and goes on to walk");
  if (graph.stops.empty()) return cannot_walk("no clip ends walking and stands still");
  const auto rank_of = [&](std::uint32_t clip) { return graph.clip[clip].rank; };
  std::ranges::stable_sort(graph.starts, {}, rank_of);
  std::ranges::stable_sort(graph.stops, {}, rank_of);
  leave_out_standing(graph);
  find_transition_ranges(graph);
  for (std::uint32_t scope = 0; scope < graph.scopes; ++scope) {
    measure_ways_to_stand(graph, scope);
    measure_ways_after(graph, scope);
  }
  std::erase_if(graph.starts, [&](std::uint32_t c) {
    return graph.clip[c].to_stand.back()[graph.clip[c].first] == infinity;
  });
  if (graph.starts.empty())
    return cannot_walk("no transitions lead from a start clip to a stop clip");
  graph.speed = ordinary_speed(graph);
  graph.quickest = quickest_motion(motion);
  graph.turning_rate = turning_rate(graph);
  measure_resting_heights(graph);
  graph.arms = arms_at_ease(motion);
  graph.before_walking =
      stand_in_clip(graph, graph.starts.front(), graph.clip[graph.starts.front()].first);
  graph.after_walking =
      stand_in_clip(graph, graph.stops.front(), graph.clip[graph.stops.front()].last);
  return graph;
}

}  // namespace docent::motion
