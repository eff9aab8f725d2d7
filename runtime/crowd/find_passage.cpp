#include "runtime/crowd/find_passage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <queue>
#include <utility>

#include "runtime/crowd/contact.h"
#include "runtime/model/geometry/polyline.h"
#include "runtime/model/none.h"
#include "runtime/path/floor_map.h"

namespace docent::crowd {
namespace {

constexpr double column_step = 0.25;   // metres along the way
constexpr double lane_step = 0.13;     // metres beside it
constexpr int most_lanes = 11;         // on either side
constexpr double reach_ahead = 9;      // metres
constexpr double reach_behind = 3;     // metres
constexpr double horizon = 10;         // seconds that are thought ahead
constexpr double time_step = 0.2;      // seconds: times nearer than that are alike, and a wait
constexpr double moving_spare = 0.12;  // metres kept from others, since nobody walks to the tick
constexpr double standing_spare = 0.06;
constexpr double wall_spare = 0.02;  // metres: a walking body rounds corners a little
constexpr double crowd_reach = 1.2;  // metres about the way in which others make it crowded
constexpr int right_lane = -3;
constexpr double off_lane_cost = 0.6;     // seconds a second and metre
constexpr double aside_cost = 0.12;       // seconds for a step to another lane
constexpr double back_cost = 2.5;         // times the seconds
constexpr double start_again = 0.6;       // seconds that setting out takes after a wait
constexpr double narrow_wait_cost = 0.3;  // seconds a second: who has to wait does so where
constexpr double narrow = 2.4;            // others can pass, this many radii from any wall
constexpr double room_cost = 2.0;         // seconds that it takes a body that yields to make room
constexpr double unsafe_end_cost = 6;     // seconds
constexpr std::size_t most_expanded = 20000;

constexpr double never = std::numeric_limits<double>::infinity();

struct Move {
  int columns, lanes;
};
constexpr std::array<Move, 11> moves{{{1, 0},
                                      {2, 1},
                                      {2, -1},
                                      {1, 1},
                                      {1, -1},
                                      {0, 1},
                                      {0, -1},
                                      {-1, 0},
                                      {-1, 1},
                                      {-1, -1},
                                      {0, 0}}};

struct Column {
  Vec2 place{}, left{};
  double along = 0;
};

/// The polyline's points at equal distances.
std::vector<Vec2> resampled(std::span<const Vec2> line, double step, double most) {
  std::vector<Vec2> out;
  if (line.empty()) return out;
  out.push_back(line.front());
  double walked = 0, next = step;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double length = glm::distance(line[i - 1], line[i]);
    while (next <= walked + length && next <= most) {
      out.push_back(glm::mix(line[i - 1], line[i], (next - walked) / length));
      next += step;
    }
    walked += length;
  }
  if (walked <= most && walked > next - step + 1e-6) {
    // The very end counts; a last step that is hardly one is drawn out.
    if (walked - (next - step) < 0.4 * step && out.size() > 1) out.pop_back();
    out.push_back(line.back());
  }
  return out;
}

/// Another body while this one is on its way.
struct Other {
  std::uint32_t body = 0;
  const Trajectory* trajectory = nullptr;
  bool yields_when_asked = false;
  bool stands = false;  ///< From the beginning on.
};

class PassageSearch {
 public:
  PassageSearch(const path::FloorMap& map, const ReservationTable& reservations,
                const PassageQuery& query)
      : map_(map), reservations_(reservations), query_(query), radius_(reservations.body_radius()) {
    lay_columns();
    find_others();
  }

  Passage find() {
    Passage passage;
    if (columns_.empty()) return passage;
    if (way_is_free()) return straight();
    return pulled_out(search());
  }

 private:
  struct Node {
    int column = 0, lane = 0;
  };
  struct State {
    Node node;
    double seconds = 0, cost = 0;
    std::uint32_t parent = 0;
    std::uint32_t asked = none;  ///< Obliging body on the move to here.
    bool stands = false;
  };
  static constexpr int lanes = 2 * most_lanes + 1;

  void lay_columns() {
    const std::vector<Vec2> ahead = resampled(query_.way, column_step, reach_ahead);
    std::vector<Vec2> behind = resampled(query_.behind, column_step, reach_behind);
    if (ahead.empty()) return;
    if (!behind.empty()) behind.erase(behind.begin());
    way_length_ = polyline_length(query_.way);
    origin_ = static_cast<int>(behind.size());
    std::vector<Vec2> all(behind.rbegin(), behind.rend());
    all.insert(all.end(), ahead.begin(), ahead.end());
    ends_at_goal_ = glm::distance(ahead.back(), query_.way.back()) < 1e-6;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Vec2 way = all[std::min(i + 1, all.size() - 1)] - all[i > 0 ? i - 1 : 0];
      const double size = glm::length(way);
      const int from_origin = static_cast<int>(i) - origin_;
      columns_.push_back({all[i], size > 1e-9 ? left_of(way / size) : Vec2{0, 1},
                          std::min(column_step * from_origin, way_length_)});
    }
    if (ends_at_goal_) columns_.back().along = way_length_;
    state_of_.assign(columns_.size() * lanes, Place::Unknown);
    busy_until_.assign(columns_.size() * lanes, -1);
  }

  void find_others() {
    for (const std::uint32_t body : query_.near) {
      const Trajectory* trajectory = reservations_.trajectory_of(body);
      if (trajectory == nullptr) continue;
      if (!is_crowded_) is_crowded_ = comes_near(*trajectory);
      const bool yields =
          std::ranges::find(query_.yields_when_asked, body) != query_.yields_when_asked.end();
      others_.push_back({body, trajectory, yields, trajectory->end() <= query_.seconds});
    }
  }

  /// Is it ever beside the way? Looked at by half seconds.
  bool comes_near(const Trajectory& trajectory) const {
    const double last = std::min(query_.seconds + horizon, trajectory.end());
    for (double t = query_.seconds;; t += 0.5) {
      const Vec2 there = place_at(trajectory, t);
      if (std::ranges::any_of(columns_, [&](const Column& column) {
            const Vec2 off = there - column.place;
            return dot(off, off) < crowd_reach * crowd_reach;
          }))
        return true;
      if (t >= last) return false;
    }
  }

  // Places.

  enum class Place : std::uint8_t { Unknown, Free, Blocked };

  std::size_t index(Node node) const {
    return static_cast<std::size_t>(node.column) * lanes +
           static_cast<std::size_t>(node.lane + most_lanes);
  }
  Vec2 place(Node node) const {
    const Column& column = columns_[static_cast<std::size_t>(node.column)];
    return column.place + (lane_step * node.lane) * column.left;
  }
  bool has_room(Node node) {
    if (node.lane == 0) return true;  // the way has been found for this body
    Place& state = state_of_[index(node)];
    if (state == Place::Unknown) {
      const Vec2 here = place(node), middle = columns_[static_cast<std::size_t>(node.column)].place;
      const bool free = map_.has_room(here, radius_ + wall_spare) &&
                        map_.walls().capsule_clear(middle, here, 0.5 * radius_);
      state = free ? Place::Free : Place::Blocked;
    }
    return state == Place::Free;
  }
  bool can_go(Node from, Node to) {
    if (!has_room(to)) return false;
    if (from.lane == 0 && to.lane == 0) return true;
    const Vec2 a = place(from), b = place(to);
    double room = radius_ + wall_spare;
    // The way may touch walls that the body has no room to spare from.
    if (from.lane == 0 || to.lane == 0)
      room = std::max(0.5 * radius_,
                      std::min({room, map_.clearance_at(a) - 1e-6, map_.clearance_at(b) - 1e-6}));
    return map_.walls().capsule_clear(a, b, room);
  }

  // Others.

  /// Who is met on a straight move; none, or whether it could be asked to make room.
  struct Encounter {
    std::uint32_t body = none;
    bool yields_when_asked = false;
  };
  Encounter met(Vec2 a, Vec2 b, double from, double seconds) const {
    Encounter out;
    for (const Other& other : others_) {
      const Vec2 then = place_at(*other.trajectory, from);
      const Vec2 later = place_at(*other.trajectory, from + seconds);
      const bool stands = other.trajectory->end() <= from;
      double distance = 2 * radius_ + (stands ? standing_spare : moving_spare);
      // Who begins near another may leave.
      if (from < query_.seconds + 1.0)
        distance = std::min(distance, std::max(2 * radius_ + 0.015, glm::distance(then, a) - 0.01));
      const Vec2 velocity = ((later - then) - (b - a)) / std::max(seconds, 1e-6);
      if (!contact(make_approach(then - a, velocity, distance), seconds)) continue;
      if (!(other.yields_when_asked && stands)) return {other.body, false};
      out = {other.body, true};
    }
    return out;
  }

  /// After when one may stand at a place for good.
  double busy_until(Node node) {
    double& until = busy_until_[index(node)];
    if (until >= 0) return until;
    until = 0;
    const Vec2 here = place(node);
    const double distance = 2 * radius_ + standing_spare;
    for (const Other& other : others_) {
      const Trajectory& trajectory = *other.trajectory;
      const Vec2 end = trajectory.place.back() - here;
      if (dot(end, end) < distance * distance) {
        if (!other.yields_when_asked) until = never;
        continue;
      }
      for (double t = trajectory.end(); t > std::max(query_.seconds, until); t -= 0.1) {
        const Vec2 off = place_at(trajectory, t) - here;
        if (dot(off, off) < (distance + 0.05) * (distance + 0.05)) {
          until = std::max(until, t + 0.1);
          break;
        }
      }
    }
    return until;
  }
  bool is_safe(Node node, double seconds) { return seconds >= busy_until(node); }

  bool way_is_free() {
    double seconds = query_.seconds + query_.delay;
    const Vec2 start = columns_[static_cast<std::size_t>(origin_)].place;
    if (met(start, start, query_.seconds, query_.delay).body != none) return false;
    for (std::size_t i = static_cast<std::size_t>(origin_) + 1; i < columns_.size(); ++i) {
      const Vec2 a = columns_[i - 1].place, b = columns_[i].place;
      const double dt = glm::distance(a, b) / query_.speed;
      if (met(a, b, seconds, dt).body != none) return false;
      seconds += dt;
    }
    return is_safe({static_cast<int>(columns_.size()) - 1, 0}, seconds);
  }

  Passage straight() {
    Passage passage;
    passage.is_straight = true;
    passage.reaches_goal = ends_at_goal_;
    double seconds = query_.seconds + query_.delay;
    for (std::size_t i = static_cast<std::size_t>(origin_); i < columns_.size(); ++i) {
      if (i > static_cast<std::size_t>(origin_))
        seconds += glm::distance(columns_[i - 1].place, columns_[i].place) / query_.speed;
      passage.points.push_back(columns_[i].place);
      passage.line.push_back(columns_[i].place);
      passage.along.push_back(columns_[i].along);
      if (is_safe({static_cast<int>(i), 0}, seconds))
        passage.stop.push_back(static_cast<std::uint32_t>(passage.points.size() - 1));
    }
    return passage;
  }

  // The search.

  int wanted_lane(int column) {
    if (!is_crowded_) return 0;
    // The goal itself is met on the way.
    const int left = static_cast<int>(columns_.size()) - 1 - column;
    if (ends_at_goal_ && left < 3) return 0;
    for (int lane = right_lane; lane < 0; ++lane)
      if (has_room({column, lane})) return lane;
    return 0;
  }

  double remaining(Node node) const {
    const Column& column = columns_[static_cast<std::size_t>(node.column)];
    return (way_length_ - column.along) / query_.speed;
  }

  bool is_goal(Node node) const {
    return ends_at_goal_ && node.lane == 0 && node.column + 1 == static_cast<int>(columns_.size());
  }

  /// The states from the last to the first.
  std::vector<State> search() {
    std::vector<State> closed;
    const auto rank = [this](const State& s) { return s.cost + remaining(s.node); };
    struct Open {
      double rank = 0;
      State state;
      bool operator<(const Open& other) const { return rank > other.rank; }
    };
    std::priority_queue<Open> open;
    const auto buckets = static_cast<std::size_t>(horizon / time_step) + 2;
    std::vector<bool> seen(columns_.size() * lanes * buckets, false);
    const Node start{origin_, 0};
    open.push({0, {start, query_.seconds, 0, none, none, query_.delay > 0}});
    std::optional<std::uint32_t> best;
    double best_rank = never;
    while (!open.empty() && closed.size() < most_expanded) {
      const State state = open.top().state;
      const double state_rank = open.top().rank;
      open.pop();
      if (state_rank >= best_rank) break;
      const double passed = state.seconds - query_.seconds;
      const std::size_t bucket =
          std::min(buckets - 1, static_cast<std::size_t>(std::lround(passed / time_step)));
      const std::size_t key = index(state.node) * buckets + bucket;
      if (seen[key]) continue;
      seen[key] = true;
      const auto here = static_cast<std::uint32_t>(closed.size());
      closed.push_back(state);
      const bool at_goal = is_goal(state.node);
      const bool at_edge =
          !ends_at_goal_ && state.node.column + 1 == static_cast<int>(columns_.size());
      if (at_goal || at_edge || passed >= horizon) {
        const double whole =
            state_rank + (is_safe(state.node, state.seconds) ? 0 : unsafe_end_cost);
        if (whole < best_rank) {
          best_rank = whole;
          best = here;
        }
        continue;
      }
      for (const Move move : moves) {
        State next = state;
        next.parent = here;
        if (!make(move, state, next)) continue;
        open.push({rank(next), next});
      }
    }
    std::vector<State> out;
    for (std::uint32_t i = best.value_or(0); i != none && !closed.empty(); i = closed[i].parent)
      out.push_back(closed[i]);
    return out;
  }

  /// Makes a move; false where it cannot be made.
  bool make(Move move, const State& state, State& next) {
    next.node = {state.node.column + move.columns, state.node.lane + move.lanes};
    if (next.node.column < 0 || next.node.column >= static_cast<int>(columns_.size()) ||
        std::abs(next.node.lane) > most_lanes)
      return false;
    const bool waits = move.columns == 0 && move.lanes == 0;
    const Vec2 a = place(state.node), b = place(next.node);
    // Standing is only for places where one may stand for good.
    if (waits && !is_safe(state.node, state.seconds)) return false;
    if (!waits && !can_go(state.node, next.node)) return false;
    double seconds = waits ? time_step : glm::distance(a, b) / query_.speed;
    if (!waits && state.stands) seconds += std::max(query_.delay, start_again);
    next.stands = waits;
    const Encounter met = this->met(a, b, state.seconds, seconds);
    if (met.body != none && !met.yields_when_asked) return false;
    next.asked = met.body;
    next.seconds = state.seconds + seconds;
    double cost = move.columns < 0 ? back_cost * seconds : seconds;
    if (waits && map_.clearance_at(a) < narrow * radius_) cost += narrow_wait_cost * seconds;
    if (met.body != none && state.asked != met.body) cost += room_cost;
    const int off = std::abs(next.node.lane - wanted_lane(next.node.column));
    cost += off_lane_cost * lane_step * off * seconds;
    if (!waits && move.lanes != 0) cost += aside_cost;
    next.cost = state.cost + cost;
    return true;
  }

  /// The states up to the first wait, as points.
  Passage pulled_out(std::vector<State> states) {
    Passage passage;
    std::ranges::reverse(states);
    const auto add = [&](const State& state) {
      passage.points.push_back(place(state.node));
      passage.along.push_back(columns_[static_cast<std::size_t>(state.node.column)].along);
      if (passage.points.size() == 1 || is_safe(state.node, state.seconds))
        passage.stop.push_back(static_cast<std::uint32_t>(passage.points.size() - 1));
    };
    if (states.empty()) states.push_back({{origin_, 0}, query_.seconds, 0, none, none, true});
    add(states.front());
    bool waited = false;
    for (std::size_t i = 1; i < states.size(); ++i) {
      const Node last = states[i - 1].node, node = states[i].node;
      waited = waited || (last.column == node.column && last.lane == node.lane) ||
               states[i].asked != none;
      if (states[i].asked != none &&
          std::ranges::find(passage.in_the_way, states[i].asked) == passage.in_the_way.end())
        passage.in_the_way.push_back(states[i].asked);
      if (!waited) add(states[i]);
      passage.line.push_back(place(node));
    }
    passage.reaches_goal = !waited && is_goal(states.back().node);
    return passage;
  }

  const path::FloorMap& map_;
  const ReservationTable& reservations_;
  const PassageQuery& query_;
  double radius_;
  std::vector<Column> columns_;
  int origin_ = 0;
  double way_length_ = 0;
  bool ends_at_goal_ = false, is_crowded_ = false;
  std::vector<Other> others_;
  std::vector<Place> state_of_;
  std::vector<double> busy_until_;
};

}  // namespace

Passage find_passage(const path::FloorMap& map, const ReservationTable& reservations,
                     const PassageQuery& query) {
  return PassageSearch(map, reservations, query).find();
}

}  // namespace docent::crowd
