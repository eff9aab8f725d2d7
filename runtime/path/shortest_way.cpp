#include "runtime/path/shortest_way.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "runtime/path/flatten.h"
#include "runtime/path/make_tangent_graph.h"

namespace docent {
namespace {

constexpr std::uint32_t none = TangentGraph::no_tangent;

double length_of(Vec2 v) noexcept {
  return std::sqrt(dot(v, v));
}

/// A straight way between a query's end point and a side of the graph.
struct EndTangent {
  std::uint32_t side = 0;
  double angle = 0;  ///< On the side's arc.
  double length = 0;
  Vec2 touch{};
};

/// One search. The places it can be in are "about to leave by tangent k" (each k once, so the graph
/// is the tangents themselves: from k the way either takes it or rolls on to k + 1), "about to
/// arrive along the start tangent k" and "about to take the goal tangent of a side". End tangents
/// enter the queue by the lower bound that they would give if they were clear, and are tested
/// against the walls only when their turn comes: most never do.
class Search {
 public:
  Search(const ShortestWayMap& map, Vec2 from, Vec2 to)
      : map_(map), graph_(map.graph), from_(from), to_(to), work_(workspace()) {
    work_.begin(graph_.tangent.size(), graph_.side_first.size());
  }

  Way run() {
    if (map_.walls.segment_clear(from_, to_))
      return {RouteStatus::Ok, length_of(to_ - from_), 0, {from_, to_}};
    push_starts();
    while (!work_.queue.empty()) {
      const Entry entry = pop();
      switch (entry.kind) {
        case Kind::Start:
          if (start_is_clear(entry.index)) {
            const EndTangent& start = work_.start[entry.index];
            arrive(start.side, start.angle, start.length,
                   static_cast<std::uint32_t>(graph_.tangent.size()) + entry.index);
          }
          break;
        case Kind::Leave:
          if (entry.cost == work_.cost[entry.index]) leave(entry.index, entry.cost);
          break;
        case Kind::Goal:
          if (goal_is_clear(entry.index)) return trace(entry.index, entry.arrival, entry.cost);
          break;
      }
    }
    return {};
  }

 private:
  enum class Kind : std::uint8_t { Start, Leave, Goal };
  struct Entry {
    double bound;           ///< No way through here is shorter.
    double cost;            ///< Way so far; for Goal the whole way.
    std::uint32_t index;    ///< Of the start tangent, the tangent, or the goal's side.
    std::uint32_t arrival;  ///< Goal only: how the way came to the side.
    Kind kind;
    bool operator<(const Entry& other) const noexcept {  // std heaps keep the largest first
      if (bound != other.bound) return bound > other.bound;
      if (kind != other.kind) return kind < other.kind;
      return index > other.index;
    }
  };
  enum class GoalState : std::uint8_t { Unknown, None, Untested, Clear, Blocked };

  /// What a search needs to remember per tangent and side, kept per thread between queries so that
  /// a query pays for what it visits and not for the size of the floor.
  struct Workspace {
    std::uint32_t round = 0;
    std::vector<std::uint32_t> tangent_round, side_round;
    std::vector<double> cost;
    std::vector<std::uint32_t> arrival;  ///< Per tangent: how the way came to its side.
    std::vector<GoalState> goal_state;
    std::vector<EndTangent> goal;
    std::vector<EndTangent> start;
    std::vector<Entry> queue;

    void begin(std::size_t tangents, std::size_t sides) {
      if (tangent_round.size() < tangents || side_round.size() < sides || round == none) {
        tangent_round.assign(std::max(tangents, tangent_round.size()), 0);
        side_round.assign(std::max(sides, side_round.size()), 0);
        cost.resize(tangent_round.size());
        arrival.resize(tangent_round.size());
        goal_state.resize(side_round.size());
        goal.resize(side_round.size());
        round = 0;
      }
      ++round;
      start.clear();
      queue.clear();
    }
  };
  static Workspace& workspace() {
    thread_local Workspace work;
    return work;
  }

  static Sense sense_of(std::uint32_t side) noexcept {
    return side % 2 == 0 ? Sense::CounterClockwise : Sense::Clockwise;
  }
  /// How far the way has to turn round a side's corner from one angle to another; negative where
  /// the other lies behind.
  static double turn(std::uint32_t side, double from, double to) noexcept {
    return side % 2 == 0 ? to - from : from - to;
  }
  bool on_arc(std::uint32_t arc, double angle) const noexcept {
    return angle >= graph_.arc[arc].begin - same_angle && angle <= graph_.arc[arc].end + same_angle;
  }

  void push(Entry entry) {
    work_.queue.push_back(entry);
    std::push_heap(work_.queue.begin(), work_.queue.end());
  }
  Entry pop() {
    std::pop_heap(work_.queue.begin(), work_.queue.end());
    const Entry entry = work_.queue.back();
    work_.queue.pop_back();
    return entry;
  }

  /// The tangent between a point and a side: as the way goes from the point (`outwards`) or to it.
  std::optional<EndTangent> end_tangent(Vec2 point, std::uint32_t side, bool outwards) const {
    const ReflexCorner& corner = map_.corner[side / 2];
    const double left = graph_.radius * sign_of(sense_of(side));
    if (graph_.radius == 0 && point == corner.position) {
      // Standing on the corner: any direction may follow.
      const TangentArc& arc = graph_.arc[side / 2];
      const bool at_begin = outwards == (side % 2 == 0);
      return EndTangent{side, at_begin ? arc.begin : arc.end, 0, point};
    }
    const auto line = outwards ? tangent_line(point, 0, corner.position, left, touching)
                               : tangent_line(corner.position, left, point, 0, touching);
    if (!line) return {};
    const Vec2 direction = -sign_of(sense_of(side)) * line->left;
    if (cross(corner.begin, direction) < -same_angle) return {};
    const double angle = corner.angle_of(direction);
    if (!on_arc(side / 2, angle)) return {};
    const Vec2 touch = corner.position + graph_.radius * direction;
    return EndTangent{side, angle, length_of(touch - point), touch};
  }

  void push_starts() {
    for (std::uint32_t side = 0; side < 2 * graph_.arc.size(); ++side) {
      const auto start = end_tangent(from_, side, true);
      if (!start) continue;
      const double bound = start->length + length_of(to_ - start->touch);
      push({bound, start->length, static_cast<std::uint32_t>(work_.start.size()), 0, Kind::Start});
      work_.start.push_back(*start);
    }
  }
  bool start_is_clear(std::uint32_t index) const {
    return map_.walls.segment_clear(from_, work_.start[index].touch);
  }

  /// The way reaches `side` at `angle`; from here it may roll on to any tangent that leaves later.
  void arrive(std::uint32_t side, double angle, double cost, std::uint32_t arrival) {
    relax(first_leaving(side, angle, arrival), side, angle, cost, arrival);
    const EndTangent* goal = goal_tangent(side);
    if (goal == nullptr) return;
    const double roll = turn(side, angle, goal->angle);
    if (roll < -same_angle) return;
    const double whole = cost + graph_.radius * std::max(0.0, roll) + goal->length;
    push({whole, whole, side, arrival, Kind::Goal});
  }
  std::uint32_t first_leaving(std::uint32_t side, double angle, std::uint32_t arrival) const {
    if (arrival < graph_.tangent.size()) return graph_.tangent[arrival].onward;
    std::uint32_t first = graph_.side_first[side], count = graph_.side_first[side + 1] - first;
    while (count > 0) {
      const std::uint32_t half = count / 2;
      if (turn(side, angle, graph_.tangent[first + half].leave_angle) < -same_angle) {
        first += half + 1;
        count -= half + 1;
      } else {
        count = half;
      }
    }
    return first < graph_.side_first[side + 1] ? first : none;
  }
  void relax(std::uint32_t tangent, std::uint32_t side, double angle, double cost,
             std::uint32_t arrival) {
    if (tangent == none) return;
    const Tangent& next = graph_.tangent[tangent];
    cost += graph_.radius * std::max(0.0, turn(side, angle, next.leave_angle));
    if (work_.tangent_round[tangent] == work_.round && work_.cost[tangent] <= cost) return;
    work_.tangent_round[tangent] = work_.round;
    work_.cost[tangent] = cost;
    work_.arrival[tangent] = arrival;
    push({cost + length_of(to_ - next.leave), cost, tangent, 0, Kind::Leave});
  }
  void leave(std::uint32_t index, double cost) {
    const Tangent& tangent = graph_.tangent[index];
    arrive(tangent.arrive_side, tangent.arrive_angle, cost + tangent.length, index);
    const std::uint32_t side = side_left_by(index);
    if (index + 1 < graph_.side_first[side + 1])
      relax(index + 1, side, tangent.leave_angle, cost, work_.arrival[index]);
  }
  /// The side that a tangent leaves is the one that its way arrived at.
  std::uint32_t side_left_by(std::uint32_t tangent) const {
    return side_of_arrival(work_.arrival[tangent]);
  }
  std::uint32_t side_of_arrival(std::uint32_t arrival) const {
    return arrival < graph_.tangent.size() ? graph_.tangent[arrival].arrive_side
                                           : work_.start[arrival - graph_.tangent.size()].side;
  }

  const EndTangent* goal_tangent(std::uint32_t side) {
    if (work_.side_round[side] != work_.round) {
      work_.side_round[side] = work_.round;
      const auto goal = end_tangent(to_, side, false);
      work_.goal_state[side] = goal ? GoalState::Untested : GoalState::None;
      if (goal) work_.goal[side] = *goal;
    }
    const GoalState state = work_.goal_state[side];
    return state == GoalState::None || state == GoalState::Blocked ? nullptr : &work_.goal[side];
  }
  bool goal_is_clear(std::uint32_t side) {
    if (work_.goal_state[side] == GoalState::Untested)
      work_.goal_state[side] = map_.walls.segment_clear(work_.goal[side].touch, to_)
                                   ? GoalState::Clear
                                   : GoalState::Blocked;
    return work_.goal_state[side] == GoalState::Clear;
  }

  /// Writes the way down from its last arrival back to the start, and turns it round.
  Way trace(std::uint32_t side, std::uint32_t arrival, double cost) const {
    Way way{RouteStatus::Ok, cost, graph_.radius, {to_}};
    double leave_angle = work_.goal[side].angle;
    for (;;) {
      const bool from_start = arrival >= graph_.tangent.size();
      const double arrive_angle = from_start ? work_.start[arrival - graph_.tangent.size()].angle
                                             : graph_.tangent[arrival].arrive_angle;
      append_arc(map_.corner[side / 2], graph_.radius, leave_angle, arrive_angle, way.points);
      if (from_start) break;
      leave_angle = graph_.tangent[arrival].leave_angle;
      side = side_left_by(arrival);
      arrival = work_.arrival[arrival];
    }
    append_point(from_, way.points);
    if (way.points.size() == 1) way.points.push_back(from_);
    std::ranges::reverse(way.points);
    return way;
  }

  const ShortestWayMap& map_;
  const TangentGraph& graph_;
  Vec2 from_, to_;
  Workspace& work_;
};

}  // namespace

ShortestWayMap::ShortestWayMap(const FloorPlan& plan, const TangentGraph& tangents)
    : graph(tangents), walls(plan, tangents.radius), corner(corners_of_arcs(plan, tangents)) {}

Way shortest_way(const ShortestWayMap& map, Vec2 from, Vec2 to) {
  return Search(map, from, to).run();
}

}  // namespace docent
