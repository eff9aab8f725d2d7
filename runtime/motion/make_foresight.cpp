#include "runtime/motion/make_foresight.h"

#include <cmath>
#include <limits>
#include <span>

#include "runtime/motion/follower.h"
#include "runtime/motion/passages.h"

namespace docent::motion {
namespace {

constexpr float dead_end = 4;      // what is foreseen where no continuation leads on
constexpr double steepness = 4.0;  // per square radian (or metre times 6) beyond the axes
constexpr float settled = 1e-3f;   // share of the costs that a sweep still changes
constexpr std::size_t most_sweeps = 40;
constexpr float farthest_miss = 2;                             // metres
constexpr std::size_t most_warped = 20'000, most_raw = 2'000;  // transitions: 8 and 10 MB

/// A track that bends evenly for longer than any continuation.
PathTrack bend_track(double bend) {
  PathTrack track;
  track.spacing = 0.02;
  const std::size_t samples = 600;
  for (std::size_t i = 0; i < samples; ++i) {
    const double along = track.spacing * static_cast<double>(i), turn = bend * along;
    track.position.push_back(
        std::abs(turn) < 1e-9 ? Vec2{along, 0} : Vec2{std::sin(turn), 1 - std::cos(turn)} / bend);
    track.heading.push_back(turn);
    track.stride.push_back(1), track.cadence.push_back(1);
    track.effort.push_back(along);
  }
  return track;
}

struct Misfit {
  double side = 0, turn = 0;
};
constexpr std::size_t sides_of(const RawFollower*) {
  return side_axis.count;
}
constexpr std::size_t sides_of(const WarpedFollower*) {
  return 1;
}
Misfit misfit_of(const RawFollower& follower) {
  return {follower.side_error, follower.heading_error};
}
Misfit misfit_of(const WarpedFollower& follower) {
  return {0, follower.heading_error};
}

/// What a misfit costs that the table's axes do not reach.
double beyond_axes(const Misfit& misfit) {
  const auto over = [](double value, const GridAxis& axis) {
    return std::max(0.0, std::abs(value) - axis.last());
  };
  const double turn = over(misfit.turn, turn_axis), side = over(misfit.side, side_axis);
  return steepness * (turn * turn + 6 * side * side);
}

/// The value function of one bend.
template <class Follower>
class BendValues {
 public:
  BendValues(const WalkGraph& graph, double bend) : graph_(graph), track_(bend_track(bend)) {
    follow_passages();
  }

  /// One slice per transition.
  std::vector<float> iterate() const {
    const std::size_t transitions = graph_.motion->transitions.size();
    std::vector<float> value(transitions * Follower::slice, 0.0f);
    for (std::size_t sweep = 0; sweep < most_sweeps; ++sweep) {
      float change = 0, most = 0;
      for (std::size_t state = 0; state < value.size(); ++state) {
        float least = dead_end;
        for (std::uint32_t i = first_[state]; i < first_[state + 1]; ++i)
          least = std::min(least, continuations_[i].cost +
                                      continuations_[i].decay * foreseen(value, continuations_[i]));
        change = std::max(change, std::abs(least - value[state]));
        most = std::max(most, least);
        value[state] = least;
      }
      if (change <= settled * most) break;
    }
    return value;
  }

 private:
  /// Small, because there are millions and every sweep reads them all.
  struct Continuation {
    float cost, decay;
    std::uint32_t cell;  ///< Of the table, where the misfit after it lies: the lowest corner.
    float side_share, turn_share;
  };

  static float foreseen(std::span<const float> value, const Continuation& continuation) {
    const auto along_row = [&](std::size_t cell) {
      return value[cell] + continuation.turn_share * (value[cell + 1] - value[cell]);
    };
    const float low = along_row(continuation.cell);
    if constexpr (Follower::slice == warped_slice) return low;
    return low + continuation.side_share * (along_row(continuation.cell + turn_axis.count) - low);
  }

  static Continuation continuation(double cost, double walked, std::uint32_t next,
                                   const Misfit& after) {
    const auto turn = turn_axis.place(after.turn);
    std::size_t cell = next * Follower::slice + turn.low;
    double side_share = 0;
    if constexpr (Follower::slice == raw_slice) {
      const auto side = side_axis.place(after.side);
      cell += side.low * turn_axis.count;
      side_share = side.share;
    }
    return {static_cast<float>(cost), static_cast<float>(std::exp(-walked / foresight_reach)),
            static_cast<std::uint32_t>(cell), static_cast<float>(side_share),
            static_cast<float>(turn.share)};
  }

  void follow_passages() {
    constexpr std::size_t sides = sides_of(static_cast<const Follower*>(nullptr));
    for (std::uint32_t t = 0; t < graph_.motion->transitions.size(); ++t)
      for (std::size_t side = 0; side < sides; ++side)
        for (std::size_t turn = 0; turn < turn_axis.count; ++turn)
          follow(t, {sides > 1 ? side_axis.value(side) : 0, turn_axis.value(turn)});
  }
  void follow(std::uint32_t t, const Misfit& misfit) {
    const ClipFrame at = graph_.motion->transitions[t].to;
    const ClipPath& clip = graph_.clip[at.clip];
    Follower follower(graph_, track_, {at, {Vec2{0, misfit.side}, misfit.turn}});
    double cost = 0, walked = 0;
    walk_from_transition(
        graph_, Choice{graph_.scopes - 1}, t,
        [&](std::size_t from, std::size_t to) {
          cost += follower.advance(track_, clip, from, to);
          walked += clip.effort[to] - clip.effort[from];
        },
        [&](std::uint32_t next) {
          const Misfit after = misfit_of(follower);
          continuations_.push_back(
              continuation(cost + cost_of(graph_.motion->transitions[next]) + beyond_axes(after),
                           walked, next, after));
        });
    first_.push_back(static_cast<std::uint32_t>(continuations_.size()));
  }

  const WalkGraph& graph_;
  PathTrack track_;
  std::vector<std::uint32_t> first_{0};
  std::vector<Continuation> continuations_;
};

std::uint16_t in_units(double value) {
  return static_cast<std::uint16_t>(std::lround(std::clamp(value / Foresight::unit, 0.0, 65535.0)));
}

/// Fills in what belongs to one bend.
template <class Follower>
void add_bend(const WalkGraph& graph, std::size_t bend, std::vector<std::uint16_t>& table) {
  const double root = bend_axis.value(bend);
  const std::vector<float> value = BendValues<Follower>(graph, root * std::abs(root)).iterate();
  for (std::size_t i = 0; i < value.size(); ++i) {
    const std::size_t transition = i / Follower::slice, place = i % Follower::slice;
    table[(transition * bend_axis.count + bend) * Follower::slice + place] =
        in_units(static_cast<double>(value[i]));
  }
}

/// By how much the stand that is reached misses the end, at best.
std::vector<std::uint16_t> endings(const WalkGraph& graph) {
  const auto& transitions = graph.motion->transitions;
  struct Continuation {
    std::uint32_t transition;
    double walked;
  };
  std::vector<std::vector<Continuation>> continuations(transitions.size());
  std::vector<float> miss(transitions.size() * room_axis.count, farthest_miss);
  for (std::uint32_t t = 0; t < transitions.size(); ++t) {
    const ClipFrame at = transitions[t].to;
    const ClipPath& clip = graph.clip[at.clip];
    double walked = 0;
    const auto step = [&](std::size_t from, std::size_t to) {
      walked += clip.effort[to] - clip.effort[from];
    };
    walk_from_transition(graph, Choice{graph.scopes - 1}, t, step,
                         [&](std::uint32_t next) { continuations[t].push_back({next, walked}); });
    if (graph.motion->clips[at.clip].role != ClipRole::Stop || at.frame > clip.last) continue;
    for (std::size_t room = 0; room < room_axis.count; ++room)
      miss[t * room_axis.count + room] = static_cast<float>(
          std::abs(room_axis.value(room) - (clip.effort[clip.last] - clip.effort[at.frame])));
  }
  for (bool improved = true; improved;) {
    improved = false;
    for (std::size_t t = 0; t < transitions.size(); ++t)
      for (const Continuation& continuation : continuations[t])
        for (std::size_t room = 0; room < room_axis.count; ++room) {
          const double left = room_axis.value(room) - continuation.walked;
          if (left < room_axis.first) continue;
          const auto there = static_cast<float>(
              value_at(&miss[continuation.transition * room_axis.count], room_axis, left));
          float& here = miss[t * room_axis.count + room];
          if (there >= here - 1e-4f) continue;
          here = there;
          improved = true;
        }
  }
  std::vector<std::uint16_t> table;
  for (const float metres : miss) table.push_back(in_units(static_cast<double>(metres)));
  return table;
}

}  // namespace

Foresight begin_foresight(const WalkGraph& graph) {
  const std::size_t transitions = graph.motion->transitions.size();
  const auto table = [&](std::size_t slice, std::size_t most) {
    return std::vector<std::uint16_t>(transitions <= most ? transitions * bend_axis.count * slice
                                                          : 0);
  };
  return {.warped = table(warped_slice, most_warped),
          .raw = table(raw_slice, most_raw),
          .ending = transitions <= most_warped ? endings(graph) : std::vector<std::uint16_t>{}};
}

void add_bend(const WalkGraph& graph, std::size_t bend, Foresight& foresight) {
  if (!foresight.warped.empty()) add_bend<WarpedFollower>(graph, bend, foresight.warped);
  if (!foresight.raw.empty()) add_bend<RawFollower>(graph, bend, foresight.raw);
}

Foresight make_foresight(const WalkGraph& graph) {
  Foresight foresight = begin_foresight(graph);
  for (std::size_t bend = 0; bend < bend_axis.count; ++bend) add_bend(graph, bend, foresight);
  return foresight;
}

}  // namespace docent::motion
