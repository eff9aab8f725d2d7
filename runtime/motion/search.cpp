#include "runtime/motion/search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "runtime/model/none.h"
#include "runtime/motion/follower.h"
#include "runtime/motion/make_foresight.h"
#include "runtime/motion/passages.h"

namespace docent::motion {
namespace {

constexpr double bucket_size = 0.3;     // metres of progress
constexpr double misfit_cost = 2.0;     // per square of the strides' relative warp and metre
constexpr double fair_slack = 1.5;      // metres whose fair cost may be spent in advance
constexpr double widened_before = 3.0;  // metres before costs went beyond what is fair: what causes
                                        // them comes earlier
constexpr double widened_beyond = 2.0;  // metres beyond the place where that showed
constexpr double calm_end = 0.5;        // metres before the end: only stopping counts
constexpr double bend_spacing = 0.1;    // metres between two looks at the bend
constexpr double largest_overshoot = 1.5;  // metres of effort beyond the path's end

constexpr std::uint32_t no_index = std::numeric_limits<std::uint32_t>::max();

/// A moment of the search: the middle of a transition's destination (or the start).
template <typename Follower>
struct State {
  Follower follower;
  double cost = 0;
  double effort = 0;
  std::uint32_t parent = no_index;      ///< Among the expanded states.
  std::uint32_t transition = no_index;  ///< That led here.
  std::uint32_t start = 0;              ///< Which of the starts it comes from.
};

/// What states are compared by.
struct Candidate {
  double rank = 0;  ///< The cost and what is foreseen to come.
  std::uint32_t transition = no_index;
  std::uint32_t place = 0;     ///< Where in the clips it leads: equal within some frames.
  std::uint32_t likeness = 0;  ///< Equal where two misses of the track are alike.
  std::uint32_t state = 0;     ///< Of its bucket.
};

template <typename Follower>
class BeamSearch {
 public:
  BeamSearch(const WalkGraph& graph, const PathTrack& track, std::span<const MotionStart> starts)
      : graph_(graph),
        track_(track),
        starts_(starts),
        goal_(Follower::total(track)),
        same_moment_(static_cast<std::uint32_t>(Follower::same_moment * graph.frame_rate) + 1),
        foresees_(!Follower::table(graph.motion->foresight).empty()),
        beam_width_((foresees_ ? 1 : Follower::groping) * Follower::beam_width),
        kept_beams_(foresees_ ? 2 : 3) {}

  MotionPlan run() {
    buckets_.resize(static_cast<std::size_t>((goal_ + largest_overshoot) / bucket_size) + 1);
    find_bends();
    home_ = widest();
    for (const MotionStart& start : starts_)
      home_ = std::min(home_, graph_.clip[start.frame.clip].rank);
    for (Bucket& bucket : buckets_) bucket.scope = home_;
    scope_ = home_;
    begin({home_});
    for (std::size_t b = 0; b < buckets_.size() || !ends_fairly();) {
      if (b < buckets_.size() && is_fair(b))
        go_through(b++);
      else
        b = widen(b);
    }
    return plan();
  }

 private:
  const MotionGraph& motion() const { return *graph_.motion; }
  std::uint32_t widest() const { return graph_.scopes - 1; }

  /// Stands at all starts of a scope, or at those that a narrower one leaves out.
  void begin(const Choice& choice) {
    for (std::uint32_t i = 0; i < starts_.size(); ++i) {
      const std::uint32_t rank = graph_.clip[starts_[i].frame.clip].rank;
      if (rank > choice.scope || (choice.beyond != Choice::nothing && rank <= choice.beyond))
        continue;
      Bucket& first = buckets_.front();
      first.candidates.push_back(
          {0, no_index, no_index, i, static_cast<std::uint32_t>(first.states.size())});
      first.states.push_back({.follower = Follower(graph_, track_, starts_[i]), .start = i});
    }
  }

  /// Walks on from the best states of a bucket; or, where that was done in a narrower scope, from
  /// those again by the transitions that this one adds, and from what has come new.
  void go_through(std::size_t b) {
    Bucket& bucket = buckets_[b];
    for (const Done& done : std::vector<Done>(bucket.done))
      if (const std::uint32_t before = scope_of(done.state, bucket.done_scope);
          before < bucket.scope)
        expand(done.state, {bucket.scope, before}, done.index);
    bucket.done_scope = bucket.scope;
    // A state may lead to its own bucket, so a bucket is done when nothing new has come.
    for (std::size_t round = 0; !bucket.candidates.empty() && round < 4; ++round) {
      candidates_.clear(), states_.clear();
      std::swap(candidates_, bucket.candidates);
      std::swap(states_, bucket.states);
      narrow(candidates_);
      for (const Candidate& candidate : candidates_) {
        const State<Follower>& state = states_[candidate.state];
        const auto index = static_cast<std::uint32_t>(expanded_.size());
        expanded_.push_back({state.parent, state.transition});
        if (bucket.scope < widest()) bucket.done.push_back({state, candidate.rank, index});
        const std::uint32_t scope = scope_of(state, bucket.scope);
        scope_ = std::max(scope_, scope);
        expand(state, {scope}, index);
      }
    }
    bucket.candidates = {}, bucket.states = {};
  }

  /// The scope in which a state is walked on from: at least the one that leads to a stand from
  /// there.
  std::uint32_t scope_of(const State<Follower>& state, std::uint32_t least) const {
    const ClipFrame at = frame_of(state);
    const auto& to_stand = graph_.clip[at.clip].to_stand;
    while (least < widest() && to_stand[least][at.frame] == infinity) ++least;
    return least;
  }

  /// What a fair walk may have cost at most when it is so far.
  double fair_cost_at(double progress) const {
    return base_cost_ + Follower::fair_cost * std::max(0.0, progress - base_progress_);
  }

  /// Is there a state in a bucket that has not cost too much? Where the widest scope has none
  /// either, costs count from there.
  bool is_fair(std::size_t b) {
    if (widest() == home_) return true;
    Bucket& bucket = buckets_[b];
    for (const Candidate& candidate : bucket.candidates)
      bucket.least_cost = std::min(bucket.least_cost, bucket.states[candidate.state].cost);
    const double progress = static_cast<double>(b) * bucket_size;
    if (bucket.least_cost == infinity ||
        bucket.least_cost <= fair_cost_at(std::min(progress + fair_slack, goal_)))
      return true;
    if (bucket.scope < widest()) return false;
    base_cost_ = bucket.least_cost;
    base_progress_ = progress;
    return true;
  }

  bool ends_fairly() const {
    return buckets_.back().scope == widest() || (best_ && best_->cost <= fair_cost_at(goal_));
  }

  /// Takes in the next class from before the walk was last within its means to a little beyond the
  /// bucket that is not fair. Says where to go on.
  std::size_t widen(std::size_t b) {
    const std::size_t end = buckets_.size();
    const std::uint32_t scope = buckets_[std::min(b, end - 1)].scope + 1;
    std::size_t first = std::min(b, end - 1);
    const auto within_means = [&](std::size_t bucket) {
      return buckets_[bucket].least_cost <= fair_cost_at(static_cast<double>(bucket) * bucket_size);
    };
    while (first > 0 && !within_means(first)) --first;
    first -= std::min(first, static_cast<std::size_t>(widened_before / bucket_size));
    if (first == 0) begin({scope, scope - 1});
    const auto lead = static_cast<std::size_t>(widened_beyond / bucket_size);
    for (std::size_t i = first; i < std::min(b + lead, end); ++i) {
      Bucket& bucket = buckets_[i];
      bucket.scope = std::max(bucket.scope, scope);
      bucket.limit = infinity;
      if (bucket.done.size() >= beam_width_)
        bucket.limit = std::ranges::max(bucket.done, {}, &Done::rank).rank;
    }
    scope_ = std::max(scope_, scope);
    return first;
  }

  ClipFrame frame_of(const State<Follower>& state) const {
    return state.transition == no_index ? starts_[state.start].frame
                                        : motion().transitions[state.transition].to;
  }

  /// Where a walker leaves its clip: what all transitions from there have in common.
  struct Outlook {
    std::size_t bucket = 0;
    bool sees_end = false;    ///< Foresight says something of where it will stand.
    bool sees_ahead = false;  ///< Foresight says something of the next metres, worth `weight`.
    double weight = 0;
    GridAxis::Place room{}, bend{};
    typename Follower::Misfit misfit;
  };

  Outlook outlook_from(const Follower& follower) const {
    Outlook out;
    const double progress = std::max(0.0, follower.progress);
    out.bucket = static_cast<std::size_t>(progress * (1 / bucket_size));
    const double past = progress - static_cast<double>(out.bucket) * bucket_size;
    const double room = goal_ - follower.progress;
    const double weight = std::clamp((room - calm_end) * (1 / foresight_reach), 0.0, 1.0) *
                          (1 - past * (1 / foresight_reach));
    out.sees_end = !motion().foresight.ending.empty() && room < room_axis.last();
    out.room = room_axis.place(room);
    out.sees_ahead = !Follower::table(motion().foresight).empty() && weight > 0;
    out.weight = Foresight::unit * weight;
    out.bend = bend_at(progress);
    out.misfit = follower.misfit();
    return out;
  }

  /// Keeps a state that leads on by a transition, unless enough others are better.
  void keep(const State<Follower>& walker, const Outlook& outlook, std::uint32_t transition,
            double cost) {
    if (outlook.bucket >= buckets_.size()) return;
    Bucket& bucket = buckets_[outlook.bucket];
    if (cost >= bucket.limit) return;
    const double rank = cost + foreseen(outlook, transition);
    if (rank >= bucket.limit) return;
    bucket.candidates.push_back({rank, transition, place_of(transition), walker.follower.likeness(),
                                 static_cast<std::uint32_t>(bucket.states.size())});
    State<Follower>& state = bucket.states.emplace_back(walker);
    state.cost = cost;
    state.transition = transition;
    if (bucket.candidates.size() < (kept_beams_ + 3) * beam_width_) return;
    const auto middle =
        bucket.candidates.begin() + static_cast<std::ptrdiff_t>(kept_beams_ * beam_width_);
    std::nth_element(bucket.candidates.begin(), middle, bucket.candidates.end(), is_cheaper);
    bucket.limit = middle->rank;
    bucket.candidates.erase(middle, bucket.candidates.end());
  }

  /// What the next metres are likely to cost after a transition.
  double foreseen(const Outlook& outlook, std::uint32_t transition) const {
    const Foresight& foresight = motion().foresight;
    double cost = 0;
    if (outlook.sees_end) {
      const std::uint16_t* row = &foresight.ending[transition * room_axis.count];
      const double miss = Foresight::unit * value_at(row, outlook.room);
      cost += end_cost(miss, miss);
    }
    if (outlook.sees_ahead) {
      const std::uint16_t* of_bend = &Follower::table(
          foresight)[(transition * bend_axis.count + outlook.bend.low) * Follower::slice];
      const double share = outlook.bend.share;
      cost += outlook.weight * ((1 - share) * outlook.misfit.foreseen(of_bend) +
                                share * outlook.misfit.foreseen(of_bend + Follower::slice));
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
      bend_.push_back(bend_axis.place(std::copysign(std::sqrt(std::abs(bend)), bend)));
    }
  }
  GridAxis::Place bend_at(double progress) const {
    const auto i = static_cast<std::size_t>(progress * (1 / bend_spacing));
    return bend_[std::min(i, bend_.size() - 1)];
  }

  /// Transitions that lead to nearly the same moment of a clip lead to nearly the same walks.
  std::uint32_t place_of(std::uint32_t transition) const {
    const ClipFrame& to = motion().transitions[transition].to;
    return to.clip << 20 | to.frame / same_moment_;
  }

  double end_cost(double misfit, double gap) const {
    return misfit_cost * misfit * misfit / std::max(goal_, 0.5) + Follower::gap_cost * gap * gap;
  }

  static bool is_cheaper(const Candidate& a, const Candidate& b) noexcept {
    return a.rank != b.rank ? a.rank < b.rank : a.transition < b.transition;
  }

  /// Of states that are alike the cheapest, and of those the cheapest few.
  void narrow(std::vector<Candidate>& states) const {
    const auto likeness = [](const Candidate& c) {
      return std::uint64_t{c.place} << 32 | c.likeness;
    };
    std::sort(states.begin(), states.end(), [&](const Candidate& a, const Candidate& b) {
      const std::uint64_t of_a = likeness(a), of_b = likeness(b);
      return of_a != of_b ? of_a < of_b : a.rank < b.rank;
    });
    const auto alike = [&](const Candidate& a, const Candidate& b) {
      return likeness(a) == likeness(b);
    };
    states.erase(std::unique(states.begin(), states.end(), alike), states.end());
    if (states.size() > beam_width_) {
      const auto end = states.begin() + static_cast<std::ptrdiff_t>(beam_width_);
      std::nth_element(states.begin(), end, states.end(), is_cheaper);
      states.erase(end, states.end());
    }
    std::sort(states.begin(), states.end(), is_cheaper);
  }

  /// Walks on through the state's clip and branches off at every transition on the way that is
  /// taken. `index` is its own among the expanded states.
  void expand(const State<Follower>& state, const Choice& choice, std::uint32_t index) {
    const ClipFrame at = frame_of(state);
    State<Follower> walker = state;
    walker.parent = index;
    if (state.transition != no_index)
      walker.follower.enter(motion().transitions[state.transition].alignment);
    const ClipPath& clip = graph_.clip[at.clip];
    Outlook outlook;
    bool has_moved = true;
    const auto step = [&](std::size_t from, std::size_t to) {
      walker.cost += walker.follower.advance(track_, clip, from, to);
      walker.effort += clip.effort[to] - clip.effort[from];
      has_moved = true;
    };
    const auto leave = [&](std::uint32_t transition) {
      if (has_moved) outlook = outlook_from(walker.follower);
      has_moved = false;
      branch(walker, outlook, transition, choice.scope);
    };
    const std::size_t frame =
        state.transition == no_index
            ? walk_from_start(graph_, choice, at, step, leave)
            : walk_from_transition(graph_, choice, state.transition, step, leave);
    const bool ends_standing =
        motion().clips[at.clip].role == ClipRole::Stop && choice.beyond == Choice::nothing;
    if (ends_standing && frame <= clip.last) {
      walk_through(graph_, frame, clip.last, step);
      arrive(walker, clip.last);
    }
  }

  void branch(const State<Follower>& walker, const Outlook& outlook, std::uint32_t t,
              std::uint32_t scope) {
    ++considered_;
    const double left = double{graph_.left_after[scope][t]};
    if (walker.effort + left > effort_limit()) return;
    keep(walker, outlook, t, walker.cost + cost_of(motion().transitions[t]));
  }

  double effort_limit() const { return 1.6 * goal_ + 2 * largest_overshoot; }

  void arrive(State<Follower> walker, std::uint32_t frame) {
    const double misfit = goal_ - walker.follower.progress;
    const double gap = walker.follower.end_gap(track_, graph_.clip[frame_of(walker).clip]);
    walker.cost += end_cost(misfit, gap);
    // Far from the end any way that comes there is better, however poorly it keeps to the track.
    const bool is_there = std::abs(misfit) <= largest_overshoot;
    if (best_ && (ends_there_ != is_there ? ends_there_ : walker.cost >= best_->cost)) return;
    best_ = std::move(walker);
    best_frame_ = frame;
    ends_there_ = is_there;
  }

  MotionPlan plan() const {
    MotionPlan plan;
    plan.considered = considered_;
    plan.scope = scope_;
    if (!best_) return plan;
    plan.start = starts_[best_->start].frame;
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
  std::span<const MotionStart> starts_;
  double goal_;
  std::uint32_t home_ = 0;     ///< The scope that it begins in,
  std::uint32_t scope_ = 0;    ///< and the widest that was needed.
  std::uint32_t same_moment_;  ///< Frames.
  bool foresees_;              ///< There is a table of foresight.
  std::size_t beam_width_;     ///< Wide where nothing is foreseen: then many lead into dead ends.
  std::size_t kept_beams_;  ///< Widths of the beam that are kept before states that are alike are
                            ///< dropped: more where nothing is foreseen and costs say little.
  /// A state that was walked on from, kept while a wider scope may have to do so again.
  struct Done {
    State<Follower> state;
    double rank = 0;
    std::uint32_t index = 0;  ///< Among the expanded states.
  };
  struct Bucket {
    std::vector<State<Follower>> states;
    std::vector<Candidate> candidates;  ///< States that are still worth walking on from.
    double limit = infinity;            ///< Ranks from there on are lost.
    std::uint32_t scope = 0;            ///< In which they are walked on from.
    std::vector<Done> done;
    std::uint32_t done_scope = 0;
    double least_cost = infinity;
  };
  std::vector<Bucket> buckets_;
  std::vector<State<Follower>> states_;  ///< Of the bucket that is gone through.
  std::vector<Candidate> candidates_;
  double base_cost_ = 0, base_progress_ = 0;  ///< Where fair costs are counted from.
  std::vector<GridAxis::Place> bend_;         ///< Where foresight has it, every bend_spacing.
  struct Expanded {
    std::uint32_t parent, transition;
  };
  std::vector<Expanded> expanded_;
  std::optional<State<Follower>> best_;
  bool ends_there_ = false;  ///< The best one: about where the track ends.
  std::uint32_t best_frame_ = 0;
  std::uint32_t considered_ = 0;
};

}  // namespace

MotionPlan find_warped_motion(const WalkGraph& graph, const PathTrack& track,
                              std::span<const MotionStart> starts) {
  return BeamSearch<WarpedFollower>(graph, track, starts).run();
}

MotionPlan find_raw_motion(const WalkGraph& graph, const PathTrack& track,
                           std::span<const MotionStart> starts) {
  return BeamSearch<RawFollower>(graph, track, starts).run();
}

}  // namespace docent::motion
