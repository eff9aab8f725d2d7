#include "runtime/path/shortest/shortest_way.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <span>

#include "runtime/model/none.h"
#include "runtime/path/flatten.h"
#include "runtime/path/index/stamped_array.h"
#include "runtime/path/shortest/arc_angle.h"
#include "runtime/path/shortest/make_tangent_graph.h"
#include "runtime/path/shortest/savings.h"

namespace docent::path {
/// Inlined where candidates are listed. Where they touch is found for the few that are looked at:
/// kept for all, it costs more.
[[gnu::always_inline]] inline std::optional<double> ShortestWayMap::length_to(
    std::uint32_t side, Vec2 point) const noexcept {
  const ArcOfEnds& arc = arc_[side / 2];
  const double sign = side % 2 == 0 ? 1 : -1;
  const Vec2 between = arc.centre - point;
  const double squared = dot(between, between);
  if (graph_.radius == 0) {
    // The direction from the corner to where it is touched, not yet of unit length.
    const Vec2 out = -sign * left_of(between);
    const double slack = same_angle * (std::abs(between.x) + std::abs(between.y));
    if (cross(arc.begin, out) < -slack || cross(out, arc.end) < -slack) return {};
    return std::sqrt(squared);
  }
  const double nearest = std::max(0.0, rolling_ - 2 * walls_.slack());
  if (squared < nearest * nearest) return {};
  const double length = std::sqrt(std::max(0.0, squared - rolling_ * rolling_));
  // From the centre to the touch, times the distance squared.
  const Vec2 out = -(rolling_ * between + sign * length * left_of(between));
  const double slack = same_angle * squared;
  if (cross(arc.begin, out) < -slack || cross(out, arc.end) < -slack) return {};
  return length;
}

Vec2 ShortestWayMap::touch_of(std::uint32_t side, Vec2 point, double length) const noexcept {
  const ArcOfEnds& arc = arc_[side / 2];
  if (graph_.radius == 0) return arc.centre;
  const double sign = side % 2 == 0 ? 1 : -1;
  const Vec2 between = arc.centre - point;
  return arc.centre -
         rolling_ * (rolling_ * between + sign * length * left_of(between)) / dot(between, between);
}

namespace {

/// A tangent that a way of the query begins or ends with, or some more of its way. Costs are in the
/// labels' unit. Most are bounded and never looked at again.
struct Candidate {
  double length;           ///< Metres of the way between the end and the touch.
  std::int64_t bound = 0;  ///< No way by this tangent is shorter.
  std::uint32_t side;
  float saved = 0;                    ///< Metres (see savings.h).
  std::uint32_t looked = none;        ///< What is known of it beyond that.
  std::uint32_t also_on_side = none;  ///< The next candidate of the same side.
};

/// What is known of a candidate that was looked at.
struct Looked {
  Vec2 touch{};
  double turn = 0;        ///< How far along its side's arc the touch is, as seen from the end.
  std::int64_t cost = 0;  ///< As far as the end of the side's arc that labels count from: rolling
                          ///< there is taken off again.
  bool is_clear = false;  ///< Known to be clear of walls.
  std::uint32_t bend = none;  ///< How the way came to the side from the end's tangent.
};

/// A tangent that a way takes from one arc to the next, in the sense in which it is walked.
struct Bend {
  double leave_angle, arrive_angle, length;
  std::uint32_t arrive_side;
};

/// The straight way between an end of the query and the first side that it touches.
struct EndTangent {
  double length;  ///< Metres.
  double angle;   ///< Of the touch on the side's arc.
  std::uint32_t side;
};

/// A bend of a candidate that goes on from another one.
struct CandidateBend {
  Bend bend;
  EndTangent end;
  std::uint32_t nearer;  ///< The bend before, as seen from the end; none for the first.
};

/// One end of a query.
struct End {
  Vec2 at{};
  std::uint32_t flip = 0;  ///< 1 for the goal, from which a way is walked backwards.
  std::vector<Candidate> candidates;
  std::vector<std::uint32_t> open;  ///< Candidates that may still be the best.
};

/// What is added to the cost of either end, so that rolls may be taken off: no arc is longer.
constexpr std::int64_t bias = 2 * std::int64_t{HubLabels::most_cost};
/// So many bits hold the sum of the two biases, of a label's two costs and of the two of candidates
/// (five of the largest costs each, with a bend beyond the shortest way), and one more.
constexpr unsigned cost_bits = 38;
constexpr std::uint64_t never = std::numeric_limits<std::uint64_t>::max();
constexpr std::int64_t unreached = std::int64_t{1} << (cost_bits - 1);

/// How two candidates meet.
struct Meeting {
  std::int64_t cost = unreached;
  std::uint32_t from = none, to = none;           ///< Candidates.
  std::uint32_t leaving = none, arriving = none;  ///< Entries; none where both touch one side.
};

/// Per thread, so that a query pays for what it visits only.
struct Workspace {
  /// Per hub, what it costs to get there: the cost with the bias in the lower bits, the round in
  /// the upper ones, which counts down, so that a smaller number is cheaper or newer and telling
  /// takes no branch.
  std::vector<std::uint64_t> hub;
  std::uint64_t round = 0;
  End from, to;
  std::vector<Looked> looked;
  std::vector<CandidateBend> bends;
  StampedArray<std::uint32_t> on_side;  ///< Which candidate touches a side first.
  std::vector<std::uint32_t> tangents;  ///< Of the way, in order, those of its labels.
  std::vector<Bend> way;                ///< All of the way, in order.
  std::vector<std::uint32_t> links;     ///< Yet to be taken apart.

  void next_round(std::size_t hubs) {
    if (hub.size() < hubs) hub.resize(hubs, never);
    if (round <= 1) {  // In round 0 costs added to `never` would not fit.
      std::ranges::fill(hub, never);
      round = never >> cost_bits;
    }
    --round;
  }
};
Workspace& workspace() {
  thread_local Workspace work;
  return work;
}

/// So many points a roll has room for, before all that there are must be moved.
constexpr std::size_t points_a_roll = 4;

class Query {
 public:
  Query(const ShortestWayMap& map, Vec2 from, Vec2 to)
      : map_(map),
        labels_(map.labels()),
        per_metre_(1 / map.labels().unit),
        work_(workspace()),
        from_(work_.from),
        to_(work_.to) {
    from_.at = from;
    from_.flip = 0;
    to_.at = to;
    to_.flip = 1;
  }

  Way run() {
    list_candidates();
    bound(from_.candidates, to_.candidates);
    bound(to_.candidates, from_.candidates);
    for (;;) {
      const Meeting best = meet();
      if (best.from == none) return {};
      // Both are tested before the labels meet again: each may be seen through a wall.
      const bool from_clear = drop_unless_clear(from_, best.from);
      const bool to_clear = drop_unless_clear(to_, best.to);
      if (!from_clear || !to_clear) continue;
      unpack(best);
      const bool first_turns = first_turns_forward(from_.candidates[best.from]);
      const bool last_turns = last_turns_forward(to_.candidates[best.to]);
      if (first_turns && last_turns)
        return trace(from_.candidates[best.from], to_.candidates[best.to]);
      if (!first_turns) go_on(from_, best.from, to_);
      if (!last_turns) go_on(to_, best.to, from_);
    }
  }

 private:
  std::int64_t in_units(double metres) const noexcept {
    return static_cast<std::int64_t>(metres * per_metre_);
  }

  void list_candidates() {
    work_.looked.clear();
    work_.bends.clear();
    const auto about_from = map_.sides_about(from_.at), about_to = map_.sides_about(to_.at);
    for (const std::uint32_t side : about_from) map_.prefetch_arc(side);
    for (const std::uint32_t side : about_to) map_.prefetch_arc(side);
    list_candidates(from_, about_from);
    list_candidates(to_, about_to);
  }
  void list_candidates(End& end, std::span<const std::uint32_t> about) const {
    end.candidates.clear();
    for (const std::uint32_t side : about)
      if (const auto length = map_.length_to(side, end.at)) {
        // Turning along the other side begins where this side ends.
        end.candidates.push_back({.length = *length,
                                  .side = side ^ end.flip,
                                  .saved = static_cast<float>(map_.saved_at(side))});
        map_.prefetch_landmarks(side);
      }
  }

  Looked& look_at(const End& end, Candidate& candidate) const {
    if (candidate.looked == none) {
      candidate.looked = static_cast<std::uint32_t>(work_.looked.size());
      const std::uint32_t side = candidate.side ^ end.flip;
      const Vec2 touch = map_.touch_of(side, end.at, candidate.length);
      const double turn = map_.turn_at(side, touch);
      work_.looked.push_back({.touch = touch,
                              .turn = turn,
                              .cost = in_units(candidate.length - map_.graph().radius * turn)});
    }
    return work_.looked[candidate.looked];
  }

  /// The bounds of some candidates, by what lies between them and any of the others.
  void bound(std::span<Candidate> some, const std::vector<Candidate>& others) const {
    // What is saved is no more than the radius, so that no length becomes negative.
    const double radius = map_.graph().radius;
    LandmarkBound between(map_.search().landmarks(), radius);
    for (const Candidate& other : others)
      between.add(map_.sight_corner(other.side), other.length + radius - other.saved);
    for (Candidate& candidate : some)
      candidate.bound = in_units(candidate.length - candidate.saved +
                                 between.from(map_.sight_corner(candidate.side)));
  }

  bool drop_unless_clear(End& end, std::uint32_t index) const {
    Candidate& candidate = end.candidates[index];
    Looked& looked = look_at(end, candidate);
    if (!looked.is_clear) looked.is_clear = map_.walls().segment_clear(end.at, looked.touch);
    if (looked.is_clear) return true;
    candidate = end.candidates.back();
    end.candidates.pop_back();
    return false;
  }

  /// Puts in the place of a candidate, whose labels lead backwards, what it leads to: every tangent
  /// that leaves its side from its touch on. For ways that end on this very side it is kept.
  void go_on(End& end, std::uint32_t index, const End& other) {
    const TangentGraph& graph = map_.graph();
    end.candidates[index].bound = unreached;
    const Candidate from = end.candidates[index];
    const Looked looked = work_.looked[from.looked];
    const std::uint32_t side = from.side ^ end.flip;
    const std::size_t first_new = end.candidates.size();
    for (std::uint32_t k = graph.side_first[side]; k < graph.side_first[side + 1]; ++k) {
      const Tangent& tangent = graph.tangent[k];
      const double turn = map_.turn_along(side, tangent.leave_angle) - looked.turn;
      if (turn < -same_angle) continue;
      const double length = from.length + graph.radius * std::max(0.0, turn) + tangent.length;
      const double rolled = map_.turn_along(tangent.arrive_side, tangent.arrive_angle);
      end.candidates.push_back({.length = length,
                                .side = tangent.arrive_side ^ end.flip,
                                .saved = static_cast<float>(map_.saved_at(tangent.arrive_side)),
                                .looked = static_cast<std::uint32_t>(work_.looked.size())});
      work_.looked.push_back({.turn = rolled,
                              .cost = in_units(length - graph.radius * rolled),
                              .is_clear = true,
                              .bend = static_cast<std::uint32_t>(work_.bends.size())});
      const Bend bend =
          end.flip == 0
              ? Bend{tangent.leave_angle, tangent.arrive_angle, tangent.length, tangent.arrive_side}
              : Bend{tangent.arrive_angle, tangent.leave_angle, tangent.length, from.side};
      work_.bends.push_back({bend, first_tangent(end, from, looked), looked.bend});
    }
    bound(std::span(end.candidates).subspan(first_new), other.candidates);
  }

  /// The cheapest pair of candidates, counting as if every roll could also be a little negative:
  /// no true way is cheaper.
  Meeting meet() {
    // The two that lead the straightest give a cost that most others cannot reach.
    if (!bring_forward(from_, labels_.leaving) || !bring_forward(to_, labels_.arriving)) return {};
    Meeting best;
    work_.next_round(map_.hubs());
    if (from_.candidates[0].bound < best.cost) leave(from_.candidates[0]);
    if (to_.candidates[0].bound < best.cost) arrive(0, best);
    list_open(from_, labels_.leaving, best.cost);
    list_open(to_, labels_.arriving, best.cost);
    meet_on_one_side(best);
    for (const std::uint32_t i : from_.open)
      if (from_.candidates[i].bound < best.cost)
        ShortestWayMap::prefetch(map_.leaving(from_.candidates[i].side));
    for (const std::uint32_t i : to_.open)
      if (to_.candidates[i].bound < best.cost)
        ShortestWayMap::prefetch(map_.arriving(to_.candidates[i].side));
    for (const std::uint32_t i : from_.open)
      if (i > 0 && from_.candidates[i].bound < best.cost) leave(from_.candidates[i]);
    for (const std::uint32_t i : to_.open)
      if (to_.candidates[i].bound < best.cost) arrive(i, best);
    if (best.arriving != none) find_leaving(best);
    return best;
  }
  /// Moves the candidate of the smallest bound to the front, of those that are clear of walls.
  bool bring_forward(End& end, const LabelTable& labels) const {
    while (!end.candidates.empty()) {
      Candidate& front = end.candidates.front();
      std::swap(front, *std::ranges::min_element(end.candidates, {}, &Candidate::bound));
      const std::uint32_t side = front.side;
      __builtin_prefetch(&labels.first[side]);
      if (!drop_unless_clear(end, 0)) continue;
      ShortestWayMap::prefetch(labels.of(side));
      return true;
    }
    return false;
  }
  /// Lists the candidates that may cost less, and those that are kept for their side's sake.
  void list_open(End& end, const LabelTable& labels, std::int64_t cost) const {
    end.open.clear();
    for (std::uint32_t i = 0; i < end.candidates.size(); ++i) {
      const Candidate& candidate = end.candidates[i];
      if (candidate.bound >= cost && candidate.bound != unreached) continue;
      end.open.push_back(i);
      __builtin_prefetch(&labels.first[candidate.side]);
    }
  }
  void leave(Candidate& candidate) {
    const std::uint64_t so_far = (work_.round << cost_bits) +
                                 static_cast<std::uint64_t>(bias + look_at(from_, candidate).cost);
    std::uint64_t* const hub = work_.hub.data();
    for (const auto& [name, further] : map_.leaving(candidate.side))
      hub[name] = std::min(hub[name], so_far + further);
  }
  void arrive(std::uint32_t index, Meeting& best) {
    Candidate& candidate = to_.candidates[index];
    // What an earlier round left is so much larger that it loses without being asked for.
    const std::uint64_t so_far = static_cast<std::uint64_t>(bias + look_at(to_, candidate).cost) -
                                 (work_.round << cost_bits);
    const std::uint64_t* const hub = work_.hub.data();
    const std::span<const HubCost> label = map_.arriving(candidate.side);
    // Rolls taken off at both ends may be more than the way: with its biases no cost is negative.
    auto least = static_cast<std::uint64_t>(2 * bias + best.cost);
    const HubCost* where = nullptr;
    for (const HubCost& entry : label) {
      const std::uint64_t cost = hub[entry.hub] + so_far + entry.cost;
      if (cost < least) {
        least = cost;
        where = &entry;
      }
    }
    if (where)
      best = {static_cast<std::int64_t>(least) - 2 * bias, none, index, none,
              labels_.arriving.first[candidate.side] +
                  static_cast<std::uint32_t>(where - label.data())};
  }

  /// Which candidate's label brought the cost of the hub where a meeting takes place?
  void find_leaving(Meeting& best) const {
    const std::uint32_t hub = labels_.arriving.hub[best.arriving].hub;
    const auto cost = static_cast<std::int64_t>(work_.hub[hub] - (work_.round << cost_bits));
    for (std::uint32_t i = 0; i < from_.candidates.size(); ++i) {
      const Candidate& candidate = from_.candidates[i];
      if (candidate.looked == none || candidate.bound == unreached) continue;
      const auto label = map_.leaving(candidate.side);
      const auto entry = std::ranges::lower_bound(label, hub, {}, &HubCost::hub);
      if (entry == label.end() || entry->hub != hub) continue;
      if (bias + work_.looked[candidate.looked].cost + entry->cost != cost) continue;
      best.from = i;
      best.leaving =
          labels_.leaving.first[candidate.side] + static_cast<std::uint32_t>(entry - label.begin());
      return;
    }
  }

  /// The shortest way of two open candidates that touch the same side, if it is shorter.
  void meet_on_one_side(Meeting& best) {
    const double radius = map_.graph().radius;
    work_.on_side.forget(2 * map_.graph().arc.size());
    for (const std::uint32_t i : from_.open) {
      Candidate& first = from_.candidates[i];
      const bool is_alone = !work_.on_side.has(first.side);
      std::uint32_t& on_side = work_.on_side[first.side];
      first.also_on_side = is_alone ? none : on_side;
      on_side = i;
    }
    for (const std::uint32_t k : to_.open) {
      Candidate& last = to_.candidates[k];
      if (!work_.on_side.has(last.side)) continue;
      const double last_turn = map_.extent(last.side) - look_at(to_, last).turn;
      for (std::uint32_t i = work_.on_side[last.side]; i != none;
           i = from_.candidates[i].also_on_side) {
        Candidate& first = from_.candidates[i];
        const double turn = last_turn - look_at(from_, first).turn;
        if (turn < -same_angle) continue;
        const std::int64_t cost =
            in_units(first.length + radius * std::max(0.0, turn) + last.length);
        if (cost < best.cost) best = {cost, i, k, none, none};
      }
    }
  }

  /// Writes the tangents of a meeting's way, in order, into the workspace.
  void unpack(const Meeting& best) {
    work_.tangents.clear();
    if (best.leaving == none) return;
    work_.links.clear();
    const LabelTable& arriving = labels_.arriving;
    for (std::uint32_t e = best.arriving; e != LabelTable::no_parent; e = arriving.parent[e])
      add_link(arriving.link[e]);
    std::ranges::reverse(work_.links);
    // A leaving label leads from its hub back to the side, so its links come last first.
    const LabelTable& leaving = labels_.leaving;
    for (std::uint32_t e = best.leaving; leaving.parent[e] != LabelTable::no_parent;
         e = leaving.parent[e])
      add_link(leaving.link[e]);
    take_apart();
  }
  /// Puts a link before those that are yet to be taken apart, and begins to fetch what it is.
  void add_link(std::uint32_t link) {
    if (link == HubLabels::roll) return;
    work_.links.push_back(link);
    const auto tangents = static_cast<std::uint32_t>(map_.graph().tangent.size());
    if (link < tangents)
      __builtin_prefetch(&map_.graph().tangent[link]);
    else
      __builtin_prefetch(&labels_.link_part[2 * std::size_t{link - tangents}]);
  }
  void take_apart() {
    const auto tangents = static_cast<std::uint32_t>(map_.graph().tangent.size());
    while (!work_.links.empty()) {
      const std::uint32_t link = work_.links.back();
      work_.links.pop_back();
      if (link < tangents) {
        work_.tangents.push_back(link);
        continue;
      }
      const std::size_t part = 2 * std::size_t{link - tangents};
      add_link(labels_.link_part[part + 1]);
      add_link(labels_.link_part[part]);
    }
  }

  /// Does the way leave the arc where its labels begin not before it has arrived there? (Inside,
  /// the graph sees to it.) Points need not ask: a way that turns the wrong way there is not the
  /// shortest.
  bool first_turns_forward(const Candidate& first) const {
    if (map_.graph().radius == 0 || work_.tangents.empty()) return true;
    const Tangent& leave = map_.graph().tangent[work_.tangents.front()];
    return map_.turn_along(first.side, leave.leave_angle) >=
           work_.looked[first.looked].turn - same_angle;
  }
  /// Does it arrive where its labels end not after it leaves?
  bool last_turns_forward(const Candidate& last) const {
    if (map_.graph().radius == 0 || work_.tangents.empty()) return true;
    const Tangent& arrive = map_.graph().tangent[work_.tangents.back()];
    return map_.turn_along(last.side ^ 1, arrive.arrive_angle) >=
           work_.looked[last.looked].turn - same_angle;
  }

  /// All bends of a way whose labels are unpacked.
  void list_bends(const Looked& first, const Looked& last) const {
    work_.way.clear();
    for (std::uint32_t i = first.bend; i != none; i = work_.bends[i].nearer)
      work_.way.push_back(work_.bends[i].bend);
    std::ranges::reverse(work_.way);
    for (const std::uint32_t k : work_.tangents) {
      const Tangent& tangent = map_.graph().tangent[k];
      map_.prefetch_arc(tangent.arrive_side);
      work_.way.push_back(
          {tangent.leave_angle, tangent.arrive_angle, tangent.length, tangent.arrive_side});
    }
    for (std::uint32_t i = last.bend; i != none; i = work_.bends[i].nearer)
      work_.way.push_back(work_.bends[i].bend);
  }

  /// The tangent of the end where a candidate began.
  EndTangent first_tangent(const End& end, const Candidate& candidate, const Looked& looked) const {
    if (looked.bend == none)
      return {candidate.length, map_.angle_after(candidate.side ^ end.flip, looked.turn),
              candidate.side};
    return work_.bends[looked.bend].end;
  }

  Way trace(const Candidate& first, const Candidate& last) const {
    const Looked &first_looked = work_.looked[first.looked],
                 &last_looked = work_.looked[last.looked];
    list_bends(first_looked, last_looked);
    const EndTangent begin = first_tangent(from_, first, first_looked);
    const EndTangent end = first_tangent(to_, last, last_looked);
    const double radius = map_.graph().radius;
    Way way{RouteStatus::Ok, begin.length + end.length, radius, {}};
    way.points.reserve((radius > 0 ? points_a_roll : 1) * (work_.way.size() + 1) + 2);
    way.points.push_back(from_.at);
    std::uint32_t side = begin.side;
    double angle = begin.angle;
    const auto roll = [&](double until) {
      const double turn = side % 2 == 0 ? until - angle : angle - until;
      way.length += radius * std::max(0.0, turn);
      map_.append_roll(side, angle, until, way.points);
    };
    for (const Bend& bend : work_.way) {
      roll(bend.leave_angle);
      way.length += bend.length;
      side = bend.arrive_side;
      angle = bend.arrive_angle;
    }
    roll(end.angle);
    append_point(to_.at, way.points);
    if (way.points.size() == 1) way.points.push_back(to_.at);
    return way;
  }

  const ShortestWayMap& map_;
  const HubLabels& labels_;
  double per_metre_;
  Workspace& work_;
  End &from_, &to_;
};

}  // namespace

ShortestWayMap::ShortestWayMap(const FloorPlan& plan, const SightMap& sight,
                               const TangentGraph& tangents, const HubLabels& labels,
                               const TangentSearchMap& search)
    : graph_(tangents),
      labels_(labels),
      sight_(sight),
      search_(search),
      walls_(plan, tangents.radius),
      rolling_(rolling_radius(tangents.radius, walls_.slack())),
      corner_(corners_of_arcs(plan, tangents)) {
  const double farthest = walls_.cell_size() * std::numbers::sqrt2 / 2 + walls_.slack();
  for (std::size_t cell = 0; cell < walls_.cells(); ++cell) {
    const Vec2 centre = walls_.centre_of(cell);
    const WallGrid::Nearest nearest = walls_.nearest_wall(centre);
    is_inside_.push_back((walls_.is_clear(cell) || nearest.distance > farthest) &&
                         walls_.is_inside(centre, nearest));
  }
  for (std::size_t a = 0; a < corner_.size(); ++a) {
    const ReflexCorner& corner = corner_[a];
    arc_.push_back({corner.position,
                    corner.direction_at(graph_.arc[a].begin),
                    corner.direction_at(graph_.arc[a].end),
                    graph_.arc[a].begin,
                    0,
                    {}});
  }
  if (graph_.radius > 0) {
    const std::vector<double> saved = savings(graph_);
    for (std::uint32_t side = 0; side < saved.size(); ++side)
      arc_[side / 2].saved[side % 2] = static_cast<std::uint16_t>(std::min(
          ArcOfEnds::all_saved, std::ceil(ArcOfEnds::all_saved * saved[side] / graph_.radius) + 1));
  }
  for (const auto* table : {&labels.leaving, &labels.arriving})
    for (const HubCost& hub : table->hub) hubs_ = std::max(hubs_, std::size_t{hub.hub} + 1);

  // The arcs of each corner lie together, in the order of the vertices.
  std::vector<std::uint32_t> first_arc;
  std::uint32_t arc = 0;
  for (std::uint32_t c = 0; c < sight.corner.size(); ++c) {
    while (arc < graph_.arc.size() && graph_.arc[arc].vertex < sight.corner[c]) ++arc;
    first_arc.push_back(arc);
    for (std::uint32_t a = arc; a < graph_.arc.size() && graph_.arc[a].vertex == sight.corner[c];
         ++a)
      arc_[a].corner = c;
  }
  const double reach = sight.cell_size * std::numbers::sqrt2 / 2;
  cell_first_.reserve(sight.cell_first.size());
  cell_first_.push_back(0);
  for (std::size_t cell = 0; cell + 1 < sight.cell_first.size(); ++cell) {
    const std::size_t row = cell / sight.columns, column = cell % sight.columns;
    const Vec2 centre = sight.origin + sight.cell_size * Vec2{static_cast<double>(column) + 0.5,
                                                              static_cast<double>(row) + 0.5};
    for (std::uint32_t i = sight.cell_first[cell]; i < sight.cell_first[cell + 1]; ++i) {
      const std::uint32_t seen = sight.cell_corner[i];
      for (std::uint32_t a = first_arc[seen];
           a < graph_.arc.size() && graph_.arc[a].vertex == sight.corner[seen]; ++a)
        for (const std::uint32_t side : {2 * a, 2 * a + 1})
          if (may_touch(side, centre, reach)) cell_side_.push_back(side);
    }
    cell_first_.push_back(static_cast<std::uint32_t>(cell_side_.size()));
  }
  cell_side_.shrink_to_fit();
}

bool ShortestWayMap::may_touch(std::uint32_t side, Vec2 centre, double reach) const noexcept {
  const double distance = glm::length(centre - corner_[side / 2].position);
  const double nearest = distance - reach;
  if (nearest <= rolling_) return true;
  const double tangent = std::sqrt(nearest * nearest - rolling_ * rolling_);
  // The tangent's direction turns by one over its length for every metre that its end moves.
  const double slack = reach / tangent + same_angle;
  if (slack > 1) return true;
  const double left = rolling_ * (side % 2 == 0 ? 1 : -1);
  const auto line = tangent_line(centre, 0, corner_[side / 2].position, left, 2 * walls_.slack());
  if (!line) return true;
  const Vec2 direction = (side % 2 == 0 ? -1.0 : 1.0) * line->left;
  // Is the direction within the slack of the arc? Measured from the arc's middle, so that neither
  // end is taken for the other where a sharp tip's arc spans nearly half a turn. The cosine is flat
  // at 0: it tells angles apart to 1e-6 there, and what is listed too much does no harm.
  constexpr double cosine_slack = 1e-12;
  const TangentArc& arc = graph_.arc[side / 2];
  const double half = (arc.end - arc.begin) / 2;
  const Vec2 begin = arc_[side / 2].begin;
  const Vec2 middle = std::cos(half) * begin + std::sin(half) * left_of(begin);
  return dot(middle, direction) >=
         std::cos(std::min(half + slack, std::numbers::pi)) - cosine_slack;
}

std::span<const std::uint32_t> ShortestWayMap::sides_about(Vec2 point) const noexcept {
  const auto cell = sight_.cell_at(point);
  if (!cell) return {};
  return std::span(cell_side_)
      .subspan(cell_first_[*cell], cell_first_[*cell + 1] - cell_first_[*cell]);
}

double ShortestWayMap::turn_at(std::uint32_t side, Vec2 touch) const noexcept {
  if (graph_.radius == 0) return 0;
  const ArcOfEnds& arc = arc_[side / 2];
  const Vec2 out = touch - arc.centre;
  return side % 2 == 0 ? angle_between(arc.begin, out) : angle_between(out, arc.end);
}

void ShortestWayMap::append_roll(std::uint32_t side, double from, double to,
                                 std::vector<Vec2>& points) const {
  const ArcOfEnds& arc = arc_[side / 2];
  append_arc(arc.centre, arc.begin, graph_.radius, from - arc.begin_angle, to - arc.begin_angle,
             points);
}

std::optional<Way> straight_way(const ShortestWayMap& map, Vec2 from, Vec2 to) {
  __builtin_prefetch(map.sides_about(from).data());  // for a bent one
  __builtin_prefetch(map.sides_about(to).data());
  if (!map.walls().segment_clear(from, to)) return {};
  return Way{RouteStatus::Ok, glm::length(to - from), 0, {from, to}};
}

Way bent_way(const ShortestWayMap& map, Vec2 from, Vec2 to) {
  return Query(map, from, to).run();
}

}  // namespace docent::path
