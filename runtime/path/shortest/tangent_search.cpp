#include "runtime/path/shortest/tangent_search.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "runtime/model/none.h"
#include "runtime/path/flatten.h"
#include "runtime/path/shortest/free_arcs.h"

namespace docent::path {
namespace {

double sign(std::uint32_t side) noexcept {
  return side % 2 == 0 ? 1 : -1;
}

/// One search. A side is 2 * corner + sense (1: clockwise). The places it can be in are "on a side,
/// about to leave by tangent k": from there the way either takes k or rolls on to the next tangent
/// of the side; "about to arrive along a start tangent"; and "about to take the goal tangent".
/// Whatever enters the queue has the lower bound that it would have if it were clear of walls.
class Search {
 public:
  Search(const TangentSearchMap& map, double radius, Vec2 from, Vec2 to, const ClosedDoors* closed)
      : map_(map),
        closed_(closed),
        radius_(radius),
        rolling_(rolling_radius(radius, map.walls().slack())),
        from_(from),
        to_(to),
        to_goal_(landmarks(map, closed), radius),
        work_(workspace()) {
    work_.begin(map.corners());
  }

  Way run() {
    if (clear(from_, to_)) return {RouteStatus::Ok, glm::length(to_ - from_), 0, {from_, to_}};
    for (const std::uint32_t corner : map_.seen_from(to_))
      to_goal_.add(corner, glm::length(map_.corner(corner).position - to_));
    push_starts();
    while (!work_.queue.empty()) {
      const Entry entry = pop();
      const Tangent& tangent = work_.tangent[entry.tangent];
      if (entry.kind == Kind::Goal) {
        if (goal_is_clear(tangent.to_side)) return trace(entry.tangent, entry.cost);
      } else if (entry.cost == tangent.cost) {
        if (entry.kind == Kind::Roll)
          roll_on(entry.tangent);
        else
          take(entry.tangent);
      }
    }
    return {};
  }

 private:
  enum class State : std::uint8_t { Untested, Clear, Blocked };
  struct Tangent {
    std::uint32_t from_side = none;  ///< none: it is a start tangent.
    std::uint32_t to_side = 0;
    double leave_angle = 0, length = 0;
    Vec2 leave{}, arrive{};
    Vec2 in{};  ///< Unit direction from the corner to where the tangent arrives.
    State state = State::Untested;
    double cost = infinity;        ///< Of the way as far as its leaving.
    std::uint32_t arrival = none;  ///< The tangent by which the way came to from_side.
  };
  enum class Kind : std::uint8_t { Roll, Take, Goal };
  struct Entry {
    double bound;  ///< No way through here is shorter.
    double cost;   ///< Of the way so far; of the whole way where it is a goal.
    std::uint32_t tangent;
    Kind kind;
    bool operator<(const Entry& other) const noexcept {  // std heaps keep the largest first
      if (bound != other.bound) return bound > other.bound;
      if (kind != other.kind) return kind < other.kind;
      return tangent > other.tangent;
    }
  };
  struct Corner {
    std::uint32_t round = 0;
    std::vector<ArcInterval> arcs;
    std::uint32_t bound_round = 0;
    double bound = 0;
  };
  struct Side {
    std::uint32_t round = 0;  ///< In which it was listed.
    std::uint32_t first = 0, end = 0;
    std::uint32_t goal_round = 0;
    State goal_state = State::Untested;
    std::optional<double> goal_angle;
    Vec2 goal_touch{};
  };
  /// Kept per thread, so that a search pays for what it visits only.
  struct Workspace {
    std::uint32_t round = 0;
    std::vector<Corner> corner;
    std::vector<Side> side;
    std::vector<Tangent> tangent;
    std::vector<Entry> queue;

    void begin(std::size_t corners) {
      if (corner.size() < corners) corner.resize(corners);
      if (side.size() < 2 * corners) side.resize(2 * corners);
      if (++round == 0) {
        for (Corner& c : corner) c.round = c.bound_round = 0;
        for (Side& s : side) s.round = s.goal_round = 0;
        round = 1;
      }
      tangent.clear();
      queue.clear();
    }
  };
  static Workspace& workspace() {
    thread_local Workspace work;
    return work;
  }

  /// How far the way has to turn along a side from one angle to another.
  static double turn(std::uint32_t side, double from, double to) noexcept {
    return sign(side) * (to - from);
  }
  double arrive_angle(const Tangent& tangent) const noexcept {
    return map_.corner(tangent.to_side / 2).angle_of(tangent.in);
  }
  static const Landmarks& landmarks(const TangentSearchMap& map, const ClosedDoors* closed) {
    return closed != nullptr && closed->landmarks() != nullptr ? *closed->landmarks()
                                                               : map.landmarks();
  }
  bool clear(Vec2 p, Vec2 q) const noexcept {
    if (closed_ != nullptr && closed_->blocks(p, q, radius_)) return false;
    return radius_ == 0 ? map_.walls().segment_clear(p, q)
                        : map_.walls().capsule_clear(p, q, radius_);
  }

  /// No way from a touch of a corner to the goal is shorter.
  double left_to_go(std::uint32_t corner, Vec2 touch) {
    Corner& known = work_.corner[corner];
    if (known.bound_round != work_.round) {
      known.bound_round = work_.round;
      known.bound = to_goal_.from(corner);
    }
    return std::max(known.bound, glm::length(to_ - touch));
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

  const std::vector<ArcInterval>& arcs_of(std::uint32_t corner) {
    Corner& known = work_.corner[corner];
    if (known.round != work_.round) {
      known.round = work_.round;
      if (radius_ <= TangentSearchMap::usual_radius && map_.has_usual_room(corner))
        known.arcs.assign(1, {0, map_.corner(corner).extent});
      else
        known.arcs = free_arcs(map_.plan(), map_.walls(), map_.corner(corner),
                               map_.wall_before(corner), radius_);
      if (closed_ != nullptr) closed_->cut_arcs(map_.corner(corner), radius_, known.arcs);
    }
    return known.arcs;
  }
  /// Which free arc of the corner holds an angle.
  std::uint32_t arc_at(std::uint32_t corner, double angle) {
    const std::vector<ArcInterval>& arcs = arcs_of(corner);
    for (std::uint32_t i = 0; i < arcs.size(); ++i)
      if (angle >= arcs[i].begin - same_angle && angle <= arcs[i].end + same_angle) return i;
    return none;
  }

  void push_starts() {
    for (const std::uint32_t corner : map_.seen_from(from_))
      for (const std::uint32_t side : {2 * corner, 2 * corner + 1}) {
        if (const auto start = end_tangent(from_, side, true)) {
          const double bound = start->length + left_to_go(corner, start->arrive);
          push({bound, 0, static_cast<std::uint32_t>(work_.tangent.size()), Kind::Take});
          work_.tangent.push_back(*start);
          work_.tangent.back().cost = 0;
        }
      }
  }
  /// From a point to a side (`outwards`), or from a side to a point: then `leave` is the point.
  std::optional<Tangent> end_tangent(Vec2 point, std::uint32_t side, bool outwards) const noexcept {
    const ReflexCorner& corner = map_.corner(side / 2);
    const double left = rolling_ * sign(side);
    Tangent tangent;
    tangent.to_side = side;
    tangent.leave = point;
    if (radius_ == 0 && point == corner.position) {  // any direction may follow
      const bool at_begin = outwards == (side % 2 == 0);
      tangent.in = at_begin ? corner.begin : corner.direction_at(corner.extent);
      tangent.arrive = point;
      return tangent;
    }
    const double slack = 2 * map_.walls().slack();
    const auto line = outwards ? tangent_line(point, 0, corner.position, left, slack)
                               : tangent_line(corner.position, left, point, 0, slack);
    if (!line) return {};
    const Vec2 direction = -sign(side) * line->left;
    if (!map_.touches(side / 2, direction)) return {};
    tangent.in = direction;
    tangent.arrive = corner.position + rolling_ * direction;
    tangent.length = glm::length(tangent.arrive - point);
    return tangent;
  }

  void take(std::uint32_t index) {
    Tangent& tangent = work_.tangent[index];
    if (tangent.state == State::Untested)
      tangent.state = clear(tangent.leave, tangent.arrive) ? State::Clear : State::Blocked;
    if (tangent.state == State::Blocked) return;
    const std::uint32_t side = tangent.to_side;
    const double angle = arrive_angle(tangent), cost = tangent.cost + tangent.length;
    const std::uint32_t arc = arc_at(side / 2, angle);
    if (arc == none) return;
    list_tangents(side);
    const Side& known = work_.side[side];
    const auto first = std::lower_bound(
        work_.tangent.begin() + known.first, work_.tangent.begin() + known.end, angle,
        [&](const Tangent& t, double a) { return turn(side, a, t.leave_angle) < -same_angle; });
    relax(static_cast<std::uint32_t>(first - work_.tangent.begin()), side, arc, angle, cost, index);
    push_goal(side, arc, angle, cost, index);
  }
  /// Beside the tangent itself, the way may go on to the next one of its side.
  void roll_on(std::uint32_t index) {
    const Tangent tangent = work_.tangent[index];
    push({tangent.cost + tangent.length + left_to_go(tangent.to_side / 2, tangent.arrive),
          tangent.cost, index, Kind::Take});
    const std::uint32_t arc = arc_at(tangent.from_side / 2, tangent.leave_angle);
    relax(index + 1, tangent.from_side, arc, tangent.leave_angle, tangent.cost, tangent.arrival);
  }
  /// The way is on an arc of a side at an angle, and may roll on to a tangent.
  void relax(std::uint32_t index, std::uint32_t side, std::uint32_t arc, double angle, double cost,
             std::uint32_t arrival) {
    if (index >= work_.side[side].end) return;
    const double leave_angle = work_.tangent[index].leave_angle;
    if (arc_at(side / 2, leave_angle) != arc) return;
    cost += radius_ * std::max(0.0, turn(side, angle, leave_angle));
    Tangent& next = work_.tangent[index];
    if (next.cost <= cost) return;
    next.cost = cost;
    next.arrival = arrival;
    push({cost + left_to_go(side / 2, next.leave), cost, index, Kind::Roll});
  }

  /// All tangents that may leave a side, in the order in which the way meets them.
  void list_tangents(std::uint32_t side) {
    Side& known = work_.side[side];
    if (known.round == work_.round) return;
    known.round = work_.round;
    known.first = static_cast<std::uint32_t>(work_.tangent.size());
    if (radius_ <= TangentSearchMap::usual_radius)
      for (const std::uint32_t to_side : map_.usual_sides_after(side)) add_tangent(side, to_side);
    else
      for (const std::uint32_t other : map_.seen_from(side / 2))
        for (const std::uint32_t to_side : {2 * other, 2 * other + 1}) add_tangent(side, to_side);
    std::sort(work_.tangent.begin() + known.first, work_.tangent.end(),
              [&](const Tangent& a, const Tangent& b) {
                const double turned = turn(side, a.leave_angle, b.leave_angle);
                return turned != 0 ? turned > 0 : a.to_side < b.to_side;
              });
    known.end = static_cast<std::uint32_t>(work_.tangent.size());
  }
  void add_tangent(std::uint32_t side, std::uint32_t to_side) {
    const ReflexCorner &corner = map_.corner(side / 2), &other = map_.corner(to_side / 2);
    const auto line = tangent_line(corner.position, rolling_ * sign(side), other.position,
                                   rolling_ * sign(to_side), 2 * map_.walls().slack());
    if (!line) return;
    const Vec2 out = -sign(side) * line->left, in = -sign(to_side) * line->left;
    if (!map_.touches(side / 2, out) || !map_.touches(to_side / 2, in)) return;
    Tangent tangent;
    tangent.leave_angle = corner.angle_of(out);
    if (arc_at(side / 2, tangent.leave_angle) == none) return;
    tangent.from_side = side;
    tangent.to_side = to_side;
    tangent.leave = corner.position + rolling_ * out;
    tangent.arrive = other.position + rolling_ * in;
    tangent.in = in;
    tangent.length = glm::length(tangent.arrive - tangent.leave);
    work_.tangent.push_back(tangent);
  }

  void push_goal(std::uint32_t side, std::uint32_t arc, double angle, double cost,
                 std::uint32_t arrival) {
    Side& known = work_.side[side];
    if (known.goal_round != work_.round) {
      known.goal_round = work_.round;
      known.goal_state = State::Untested;
      known.goal_angle.reset();
      if (const auto goal = end_tangent(to_, side, false)) {
        known.goal_angle = arrive_angle(*goal);
        known.goal_touch = goal->arrive;
      }
    }
    if (!known.goal_angle || known.goal_state == State::Blocked) return;
    const double turned = turn(side, angle, *known.goal_angle);
    if (turned < -same_angle || arc_at(side / 2, *known.goal_angle) != arc) return;
    const double whole =
        cost + radius_ * std::max(0.0, turned) + glm::length(to_ - known.goal_touch);
    push({whole, whole, arrival, Kind::Goal});
  }
  bool goal_is_clear(std::uint32_t side) {
    Side& known = work_.side[side];
    if (known.goal_state == State::Untested)
      known.goal_state = clear(known.goal_touch, to_) ? State::Clear : State::Blocked;
    return known.goal_state == State::Clear;
  }

  /// Writes the way down from its last arrival back to the start, and turns it round.
  Way trace(std::uint32_t arrival, double cost) const {
    Way way{RouteStatus::Ok, cost, radius_, {to_}};
    double leave_angle = *work_.side[work_.tangent[arrival].to_side].goal_angle;
    for (std::uint32_t k = arrival; k != none; k = work_.tangent[k].arrival) {
      const Tangent& tangent = work_.tangent[k];
      const ReflexCorner& corner = map_.corner(tangent.to_side / 2);
      append_arc(corner.position, corner.begin, radius_, leave_angle, arrive_angle(tangent),
                 way.points);
      leave_angle = tangent.leave_angle;
    }
    append_point(from_, way.points);
    if (way.points.size() == 1) way.points.push_back(from_);
    std::ranges::reverse(way.points);
    return way;
  }

  const TangentSearchMap& map_;
  const ClosedDoors* closed_;
  double radius_;
  double rolling_;  ///< Radius of the circles on which it bends.
  Vec2 from_, to_;
  LandmarkBound to_goal_;
  Workspace& work_;
};

}  // namespace

TangentSearchMap::TangentSearchMap(const FloorPlan& plan, const SightMap& sight,
                                   const WallGrid& walls)
    : plan_(plan), sight_(sight), walls_(walls), landmarks_(plan, sight) {
  std::vector<std::uint32_t> previous(plan.vertex.size());
  for (std::uint32_t i = 0; i < plan.vertex.size(); ++i) previous[plan.next[i]] = i;
  for (const std::uint32_t vertex : sight.corner) {
    before_.push_back(previous[vertex]);
    const auto corner =
        reflex_corner(plan, previous[vertex], vertex).value_or(ReflexCorner{.vertex = vertex});
    corner_.push_back({corner, corner.direction_at(corner.extent)});
    // A smaller disc that touches the corner in the same direction lies inside the larger one.
    const auto arcs = free_arcs(plan, walls, corner, before_.back(), usual_radius);
    has_usual_room_.push_back(arcs.size() == 1 && arcs[0].begin == 0 &&
                              arcs[0].end == corner.extent);
  }
  list_usual_sides();
}

/// A tangent's direction from the corner that it leaves turns one way, from that for radius 0 to
/// that for the usual radius; from the corner where it arrives likewise. Some direction of each
/// must touch: perhaps those of two radii, so this is a little too much.
bool TangentSearchMap::may_lead(std::uint32_t side, std::uint32_t to_side) const noexcept {
  const Vec2 from = corner(side / 2).position, to = corner(to_side / 2).position;
  const auto thin = tangent_line(from, 0, to, 0, 0);
  const auto wide =
      tangent_line(from, usual_radius * sign(side), to, usual_radius * sign(to_side), infinity);
  if (!thin) return false;
  const auto some_touch = [&](std::uint32_t at) {
    const Vec2 first = -sign(at) * thin->left, last = -sign(at) * wide->left;
    if (touches(at / 2, first) || touches(at / 2, last)) return true;
    const Vec2 begin = corner(at / 2).begin;
    return cross(first, begin) * cross(begin, last) >= 0 && dot(first + last, begin) > 0;
  };
  return some_touch(side) && some_touch(to_side);
}

void TangentSearchMap::list_usual_sides() {
  for (std::uint32_t side = 0; side < 2 * corners(); ++side) {
    for (const std::uint32_t other : seen_from(side / 2))
      for (const std::uint32_t to_side : {2 * other, 2 * other + 1})
        if (may_lead(side, to_side)) usual_side_.push_back(to_side);
    usual_first_.push_back(static_cast<std::uint32_t>(usual_side_.size()));
  }
  usual_side_.shrink_to_fit();
}

std::span<const std::uint32_t> TangentSearchMap::seen_from(std::uint32_t i) const noexcept {
  return std::span(sight_.pair_other)
      .subspan(sight_.pair_first[i], sight_.pair_first[i + 1] - sight_.pair_first[i]);
}

std::span<const std::uint32_t> TangentSearchMap::seen_from(Vec2 point) const noexcept {
  const auto cell = sight_.cell_at(point);
  if (!cell) return {};
  return std::span(sight_.cell_corner)
      .subspan(sight_.cell_first[*cell], sight_.cell_first[*cell + 1] - sight_.cell_first[*cell]);
}

Way search_tangents(const TangentSearchMap& map, double radius, Vec2 from, Vec2 to,
                    const ClosedDoors* closed) {
  return Search(map, radius, from, to, closed).run();
}

}  // namespace docent::path
