#include "runtime/motion/search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "runtime/motion/follower.h"
#include "runtime/motion/make_foresight.h"
#include "runtime/motion/passages.h"

namespace docent {
namespace {

constexpr double bucket_size = 0.3;        // metres of progress
constexpr double misfit_cost = 2.0;        // per square of the strides' relative warp and metre
constexpr double calm_end = 0.5;           // metres before the end: only stopping counts
constexpr double bend_spacing = 0.1;       // metres between two looks at the bend
constexpr double largest_overshoot = 1.5;  // metres of effort beyond the path's end

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr std::uint32_t no_index = std::numeric_limits<std::uint32_t>::max();

/// A moment of the search: the middle of a transition's destination (or the start).
template <typename Follower>
struct State {
  Follower follower;
  double cost = 0;
  double rank = 0;  ///< The cost and what is foreseen to come; what states are compared by.
  double effort = 0;
  std::uint32_t parent = no_index;      ///< Among the expanded states.
  std::uint32_t transition = no_index;  ///< That led here.
  std::uint32_t start = 0;              ///< Which of the starts it comes from.
  std::uint32_t likeness = 0;           ///< Equal where two misses of the track are alike.
};

template <typename Follower>
class BeamSearch {
 public:
  BeamSearch(const WalkGraph& graph, std::uint32_t scope, const PathTrack& track,
             std::span<const MotionStart> starts, double most_cost)
      : graph_(graph),
        scope_(scope),
        track_(track),
        starts_(starts),
        most_cost_(most_cost),
        goal_(Follower::total(track)) {}

  MotionPlan run() {
    buckets_.resize(static_cast<std::size_t>((goal_ + largest_overshoot) / bucket_size) + 1,
                    {.states = {}, .limit = most_cost_});
    find_bends();
    for (std::uint32_t i = 0; i < starts_.size(); ++i) {
      if (graph_.clip[starts_[i].frame.clip].rank > scope_) continue;
      buckets_.front().states.push_back(
          {.follower = Follower(graph_, track_, starts_[i]), .start = i, .likeness = i});
    }
    for (std::size_t b = 0; b < buckets_.size(); ++b) {
      // A state may lead to its own bucket, so a bucket is done when nothing new has come.
      for (std::size_t round = 0; !buckets_[b].states.empty() && round < 4; ++round) {
        std::vector<State<Follower>> states = std::move(buckets_[b].states);
        buckets_[b].states.clear();
        narrow(states);
        for (const State<Follower>& state : states) expand(state);
      }
      buckets_[b] = {};
    }
    return plan();
  }

  std::uint32_t expanded() const { return static_cast<std::uint32_t>(expanded_.size()); }
  std::uint32_t considered() const { return considered_; }

 private:
  const MotionGraph& motion() const { return *graph_.motion; }

  ClipFrame frame_of(const State<Follower>& state) const {
    return state.transition == no_index ? starts_[state.start].frame
                                        : motion().transitions[state.transition].to;
  }

  /// Keeps a state that leads on by a transition, unless enough others are better.
  void keep(const State<Follower>& walker, std::uint32_t transition, double cost) {
    const double progress = std::max(0.0, walker.follower.progress);
    const auto index = static_cast<std::size_t>(progress / bucket_size);
    if (index >= buckets_.size()) return;
    Bucket& bucket = buckets_[index];
    if (cost >= bucket.limit) return;
    const double past = progress - static_cast<double>(index) * bucket_size;
    const double rank = cost + foreseen(walker.follower, transition, past);
    if (rank >= bucket.limit) return;
    State<Follower>& state = bucket.states.emplace_back(walker);
    state.cost = cost;
    state.rank = rank;
    state.transition = transition;
    state.likeness = state.follower.likeness();
    if (bucket.states.size() < 6 * Follower::beam_width) return;
    const auto middle = bucket.states.begin() + 3 * Follower::beam_width;
    std::nth_element(bucket.states.begin(), middle, bucket.states.end(), is_cheaper);
    bucket.limit = middle->rank;
    bucket.states.erase(middle, bucket.states.end());
  }

  /// What the next metres are likely to cost, `past` metres beyond what others are compared at.
  double foreseen(const Follower& follower, std::uint32_t transition, double past) const {
    const Foresight& foresight = motion().foresight;
    const std::vector<std::uint16_t>& table = Follower::table(foresight);
    const double room = goal_ - follower.progress;
    double cost = 0;
    if (!foresight.ending.empty()) {
      const std::uint16_t* row = &foresight.ending[transition * room_axis.count];
      const double miss = Foresight::unit * value_at(row, room_axis, room);
      cost += end_cost(miss, miss);
    }
    if (!table.empty()) {
      const auto [low, share] = bend_axis.place(bend_at(follower.progress));
      const std::uint16_t* of_bend = &table[(transition * bend_axis.count + low) * Follower::slice];
      const double ahead = (1 - share) * follower.foreseen(of_bend) +
                           share * follower.foreseen(of_bend + Follower::slice);
      cost += Foresight::unit * ahead * std::clamp((room - calm_end) / foresight_reach, 0.0, 1.0) *
              (1 - past / foresight_reach);
    }
    return cost;
  }

  /// How the track turns ahead, radians a metre.
  void find_bends() {
    const std::size_t count = static_cast<std::size_t>(goal_ / bend_spacing) + 2;
    std::size_t here = 0, ahead = 0;
    const std::size_t last = track_.heading.size() - 1;
    for (std::size_t i = 0; i < count; ++i) {
      const double progress = static_cast<double>(i) * bend_spacing;
      while (here < last && Follower::progress_at(track_, here) < progress) ++here;
      while (ahead < last && Follower::progress_at(track_, ahead) < progress + bend_reach) ++ahead;
      const double bend = (track_.heading[ahead] - track_.heading[here]) / bend_reach;
      bend_.push_back(std::copysign(std::sqrt(std::abs(bend)), bend));
    }
  }
  double bend_at(double progress) const {
    const auto i = static_cast<std::size_t>(std::max(progress, 0.0) / bend_spacing);
    return bend_[std::min(i, bend_.size() - 1)];
  }

  double end_cost(double misfit, double gap) const {
    return misfit_cost * misfit * misfit / std::max(goal_, 0.5) + Follower::gap_cost * gap * gap;
  }

  static bool is_cheaper(const State<Follower>& a, const State<Follower>& b) noexcept {
    return a.rank != b.rank ? a.rank < b.rank : a.transition < b.transition;
  }

  /// Of states that are alike the cheapest, and of those the cheapest few.
  void narrow(std::vector<State<Follower>>& states) const {
    const auto alike = [](const auto& a, const auto& b) {
      return a.transition == b.transition && a.likeness == b.likeness;
    };
    std::sort(states.begin(), states.end(), [&](const auto& a, const auto& b) {
      if (alike(a, b)) return a.rank < b.rank;
      return std::pair(a.transition, a.likeness) < std::pair(b.transition, b.likeness);
    });
    states.erase(std::unique(states.begin(), states.end(), alike), states.end());
    constexpr auto width = Follower::beam_width;
    if (states.size() > width) {
      std::nth_element(states.begin(), states.begin() + width, states.end(), is_cheaper);
      states.erase(states.begin() + width, states.end());
    }
    std::sort(states.begin(), states.end(), is_cheaper);
  }

  /// Walks on through the state's clip and branches off at every transition on the way.
  void expand(const State<Follower>& state) {
    const auto parent = static_cast<std::uint32_t>(expanded_.size());
    expanded_.push_back({state.parent, state.transition});
    const ClipFrame at = frame_of(state);
    State<Follower> walker = state;
    walker.parent = parent;
    if (state.transition != no_index)
      walker.follower.enter(motion().transitions[state.transition].alignment);
    const ClipPath& clip = graph_.clip[at.clip];
    const auto step = [&](std::size_t from, std::size_t to) {
      walker.cost += walker.follower.advance(track_, clip, from, to);
      walker.effort += clip.effort[to] - clip.effort[from];
    };
    const auto leave = [&](std::uint32_t transition) { branch(walker, transition); };
    const std::size_t frame =
        state.transition == no_index
            ? walk_from_start(graph_, scope_, at, step, leave)
            : walk_from_transition(graph_, scope_, state.transition, step, leave);
    const bool ends_standing = motion().clips[at.clip].role == ClipRole::Stop;
    if (ends_standing && frame <= clip.last) {
      walk_through(graph_, frame, clip.last, step);
      arrive(walker, clip.last);
    }
  }

  void branch(const State<Follower>& walker, std::uint32_t t) {
    const Transition& way = motion().transitions[t];
    const double left = graph_.clip[way.to.clip].to_stand[scope_][way.to.frame];
    ++considered_;
    if (walker.effort + left > effort_limit()) return;
    keep(walker, t, walker.cost + cost_of(way));
  }

  double effort_limit() const { return 1.6 * goal_ + 2 * largest_overshoot; }

  void arrive(State<Follower> walker, std::uint32_t frame) {
    const double misfit = goal_ - walker.follower.progress;
    const double gap = walker.follower.end_gap(track_, graph_.clip[frame_of(walker).clip]);
    walker.cost += end_cost(misfit, gap);
    if (best_ ? walker.cost >= best_->cost : walker.cost > most_cost_) return;
    best_ = std::move(walker);
    best_frame_ = frame;
  }

  MotionPlan plan() const {
    MotionPlan plan;
    if (!best_) return plan;
    plan.start = starts_[best_->start].frame;
    plan.last_frame = best_frame_;
    plan.effort = best_->effort;
    plan.cost = best_->cost;
    plan.expanded = expanded();
    for (std::uint32_t i = best_->parent; i != no_index; i = expanded_[i].parent)
      if (expanded_[i].transition != no_index) plan.transitions.push_back(expanded_[i].transition);
    std::reverse(plan.transitions.begin(), plan.transitions.end());
    return plan;
  }

  const WalkGraph& graph_;
  std::uint32_t scope_;
  const PathTrack& track_;
  std::span<const MotionStart> starts_;
  double most_cost_;  ///< Of a way that is taken.
  double goal_;
  struct Bucket {
    std::vector<State<Follower>> states;
    double limit = infinite;  ///< Ranks from there on are lost.
  };
  std::vector<Bucket> buckets_;
  std::vector<double> bend_;
  struct Expanded {
    std::uint32_t parent, transition;
  };
  std::vector<Expanded> expanded_;
  std::optional<State<Follower>> best_;
  std::uint32_t best_frame_ = 0;
  std::uint32_t considered_ = 0;
};

/// Searches the first scope that holds a start, and wider ones while no way is fair: costs no more
/// than Follower::fair_cost a metre. A search gives up where none can be fair any more; the widest
/// one does not.
template <typename Follower>
MotionPlan find_motion(const WalkGraph& graph, const PathTrack& track,
                       std::span<const MotionStart> starts) {
  const double fair = Follower::fair_cost * Follower::total(track);
  const std::uint32_t widest = graph.scopes - 1;
  std::uint32_t scope = widest, expanded = 0, considered = 0;
  for (const MotionStart& start : starts)
    scope = std::min(scope, graph.clip[start.frame.clip].rank);
  for (;; ++scope) {
    BeamSearch<Follower> search(graph, scope, track, starts, scope < widest ? fair : infinite);
    MotionPlan plan = search.run();
    expanded += search.expanded();
    considered += search.considered();
    if (plan.expanded == 0 && scope < widest) continue;
    if (plan.expanded > 0) plan.expanded = expanded;
    plan.considered = considered;
    plan.scope = scope;
    return plan;
  }
}

}  // namespace

MotionPlan find_warped_motion(const WalkGraph& graph, const PathTrack& track,
                              std::span<const MotionStart> starts) {
  return find_motion<WarpedFollower>(graph, track, starts);
}

MotionPlan find_raw_motion(const WalkGraph& graph, const PathTrack& track,
                           std::span<const MotionStart> starts) {
  return find_motion<RawFollower>(graph, track, starts);
}

}  // namespace docent
