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
#include "runtime/path/shortest/make_tangent_graph.h"

namespace docent::path {
/// Inlined where candidates are listed: handed over in memory, a tangent costs as much again.
[[gnu::always_inline]] inline std::optional<EndTangent> ShortestWayMap::tangent_to(
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
    return EndTangent{side, std::sqrt(squared), arc.centre};
  }
  const double distance = std::sqrt(squared);
  if (rolling_ > distance + 2 * walls_.slack()) return {};
  const double length = std::sqrt(std::max(0.0, squared - rolling_ * rolling_));
  // The unit vector to the centre, turned away from the circle's side.
  const Vec2 direction = (length * between - sign * rolling_ * left_of(between)) / squared;
  const Vec2 out = -sign * left_of(direction);
  if (cross(arc.begin, out) < -same_angle || cross(out, arc.end) < -same_angle) return {};
  return EndTangent{side, length, arc.centre + rolling_ * out};
}

namespace {

/// A tangent that a way of the query begins or ends with, or some more of its way. Costs are in the
/// labels' unit.
struct Candidate {
  EndTangent tangent;      ///< `length` is that of the way between the end and the touch.
  std::int64_t bound = 0;  ///< No way by this tangent is shorter.
  std::int64_t cost = 0;   ///< As far as the end of the side's arc that labels count from: rolling
                           ///< there is taken off again. Known where `is_priced`.
  bool is_priced = false;
  bool is_clear = false;              ///< Known to be clear of walls.
  double angle = 0;                   ///< Of the touch on the side's arc. Known where `is_priced`.
  std::uint32_t bend = none;          ///< How the way came to the side from the end's tangent.
  std::uint32_t also_on_side = none;  ///< The next candidate of the same side.
};

/// A tangent that a way takes from one arc to the next, in the sense in which it is walked.
struct Bend {
  double leave_angle, arrive_angle, length;
  std::uint32_t arrive_side;
};

/// A bend of a candidate that goes on from another one.
struct CandidateBend {
  Bend bend;
  EndTangent end;        ///< The end's tangent.
  double angle;          ///< Of its touch.
  std::uint32_t nearer;  ///< The bend before, as seen from the end; none for the first.
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
  std::vector<Candidate> from, to;
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

class Query {
 public:
  Query(const ShortestWayMap& map, Vec2 from, Vec2 to)
      : map_(map),
        labels_(map.labels()),
        per_metre_(1 / map.labels().unit),
        from_(from),
        to_(to),
        work_(workspace()) {}

  Way run() {
    list_candidates(map_.sides_about(from_), map_.sides_about(to_));
    bound(work_.from, work_.to);
    bound(work_.to, work_.from);
    for (;;) {
      const Meeting best = meet();
      if (best.from == none) return {};
      // Both are tested before the labels meet again: each may be seen through a wall.
      const bool from_clear = drop_unless_clear(work_.from, best.from, from_);
      const bool to_clear = drop_unless_clear(work_.to, best.to, to_);
      if (!from_clear || !to_clear) continue;
      unpack(best);
      const bool first_turns = first_turns_forward(work_.from[best.from]);
      const bool last_turns = last_turns_forward(work_.to[best.to]);
      if (first_turns && last_turns) return trace(work_.from[best.from], work_.to[best.to]);
      if (!first_turns) go_on(work_.from, best.from, work_.to, true);
      if (!last_turns) go_on(work_.to, best.to, work_.from, false);
    }
  }

 private:
  std::int64_t in_units(double metres) const noexcept {
    return static_cast<std::int64_t>(metres * per_metre_);
  }

  void list_candidates(std::span<const std::uint32_t> about_from,
                       std::span<const std::uint32_t> about_to) {
    for (const std::uint32_t side : about_from) map_.prefetch_arc(side);
    for (const std::uint32_t side : about_to) map_.prefetch_arc(side);
    work_.from.clear();
    work_.bends.clear();
    for (const std::uint32_t side : about_from)
      if (const auto tangent = map_.tangent_to(side, from_)) {
        work_.from.emplace_back(*tangent);
        map_.prefetch_candidate(side);
      }
    work_.to.clear();
    // Turning along the other side begins where this side ends.
    for (const std::uint32_t back : about_to)
      if (const auto tangent = map_.tangent_to(back, to_)) {
        work_.to.emplace_back(EndTangent{back ^ 1U, tangent->length, tangent->touch});
        map_.prefetch_candidate(back ^ 1U);
      }
  }
  void price(Candidate& candidate, std::uint32_t entered) const {
    if (candidate.is_priced) return;
    candidate.is_priced = true;
    const double radius = map_.graph().radius;
    candidate.angle = map_.angle_at(candidate.tangent);
    candidate.cost =
        in_units(candidate.tangent.length - radius * map_.turn_along(entered, candidate.angle));
  }
  void price_from(Candidate& candidate) const { price(candidate, candidate.tangent.side); }
  void price_to(Candidate& candidate) const { price(candidate, candidate.tangent.side ^ 1U); }

  /// The bounds of some candidates, by what lies between them and any of the others.
  void bound(std::span<Candidate> some, const std::vector<Candidate>& others) const {
    LandmarkBound between(map_.search().landmarks(), 2 * map_.graph().radius);
    for (const Candidate& other : others)
      between.add(map_.sight_corner(other.tangent.side), other.tangent.length);
    for (Candidate& candidate : some)
      candidate.bound = in_units(candidate.tangent.length +
                                 between.from(map_.sight_corner(candidate.tangent.side)));
  }

  bool drop_unless_clear(std::vector<Candidate>& candidates, std::uint32_t index, Vec2 end) const {
    Candidate& candidate = candidates[index];
    if (!candidate.is_clear)
      candidate.is_clear = map_.walls().segment_clear(end, candidate.tangent.touch);
    if (candidate.is_clear) return true;
    candidate = candidates.back();
    candidates.pop_back();
    return false;
  }

  /// Puts in the place of a candidate, whose labels lead backwards, what it leads to: every tangent
  /// that leaves its side from its touch on. For ways that end on this very side it is kept.
  void go_on(std::vector<Candidate>& candidates, std::uint32_t index,
             const std::vector<Candidate>& others, bool is_from) {
    const TangentGraph& graph = map_.graph();
    const Candidate from = candidates[index];
    candidates[index].bound = unreached;
    // As seen from the end: a way to the query's goal is walked backwards.
    const std::uint32_t flip = is_from ? 0 : 1, side = from.tangent.side ^ flip;
    const double turned = map_.turn_along(side, from.angle);
    const std::size_t first_new = candidates.size();
    for (std::uint32_t k = graph.side_first[side]; k < graph.side_first[side + 1]; ++k) {
      const Tangent& tangent = graph.tangent[k];
      const double turn = map_.turn_along(side, tangent.leave_angle) - turned;
      if (turn < -same_angle) continue;
      Candidate next{
          .tangent = {tangent.arrive_side ^ flip,
                      from.tangent.length + graph.radius * std::max(0.0, turn) + tangent.length,
                      {}},
          .is_priced = true,
          .is_clear = true,
          .angle = tangent.arrive_angle,
          .bend = static_cast<std::uint32_t>(work_.bends.size())};
      next.cost = in_units(next.tangent.length -
                           graph.radius * map_.turn_along(tangent.arrive_side, next.angle));
      candidates.push_back(next);
      const Bend bend =
          is_from
              ? Bend{tangent.leave_angle, tangent.arrive_angle, tangent.length, tangent.arrive_side}
              : Bend{tangent.arrive_angle, tangent.leave_angle, tangent.length, from.tangent.side};
      const bool is_end = from.bend == none;
      work_.bends.push_back({bend, is_end ? from.tangent : work_.bends[from.bend].end,
                             is_end ? from.angle : work_.bends[from.bend].angle, from.bend});
    }
    bound(std::span(candidates).subspan(first_new), others);
  }

  /// The cheapest pair of candidates, counting as if every roll could also be a little negative:
  /// no true way is cheaper.
  Meeting meet() {
    // The two that lead the straightest give a cost that most others cannot reach.
    if (!bring_forward(work_.from, from_) || !bring_forward(work_.to, to_)) return {};
    Meeting best = meet_on_one_side();
    work_.next_round(map_.hubs());
    ShortestWayMap::prefetch(map_.leaving(work_.from[0].tangent.side));
    ShortestWayMap::prefetch(map_.arriving(work_.to[0].tangent.side));
    if (work_.from[0].bound < best.cost) leave(0);
    if (work_.to[0].bound < best.cost) arrive(0, best);
    for (std::uint32_t i = 1; i < work_.from.size(); ++i)
      if (work_.from[i].bound < best.cost)
        ShortestWayMap::prefetch(map_.leaving(work_.from[i].tangent.side));
    for (std::uint32_t i = 1; i < work_.to.size(); ++i)
      if (work_.to[i].bound < best.cost)
        ShortestWayMap::prefetch(map_.arriving(work_.to[i].tangent.side));
    for (std::uint32_t i = 1; i < work_.from.size(); ++i)
      if (work_.from[i].bound < best.cost) leave(i);
    for (std::uint32_t i = 0; i < work_.to.size(); ++i)
      if (work_.to[i].bound < best.cost) arrive(i, best);
    if (best.arriving != none) find_leaving(best);
    return best;
  }
  /// Moves the candidate of the smallest bound to the front, of those that are clear of walls.
  bool bring_forward(std::vector<Candidate>& candidates, Vec2 end) const {
    while (!candidates.empty()) {
      std::swap(candidates.front(), *std::ranges::min_element(candidates, {}, &Candidate::bound));
      if (drop_unless_clear(candidates, 0, end)) return true;
    }
    return false;
  }
  void leave(std::uint32_t index) {
    Candidate& candidate = work_.from[index];
    price_from(candidate);
    const std::uint64_t so_far =
        (work_.round << cost_bits) + static_cast<std::uint64_t>(bias + candidate.cost);
    std::uint64_t* const hub = work_.hub.data();
    for (const auto& [name, further] : map_.leaving(candidate.tangent.side))
      hub[name] = std::min(hub[name], so_far + further);
  }
  void arrive(std::uint32_t index, Meeting& best) {
    Candidate& candidate = work_.to[index];
    price_to(candidate);
    // What an earlier round left is so much larger that it loses without being asked for.
    const std::uint64_t so_far =
        static_cast<std::uint64_t>(bias + candidate.cost) - (work_.round << cost_bits);
    const std::uint64_t* const hub = work_.hub.data();
    const std::span<const HubCost> label = map_.arriving(candidate.tangent.side);
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
              labels_.arriving.first[candidate.tangent.side] +
                  static_cast<std::uint32_t>(where - label.data())};
  }

  /// Which candidate's label brought the cost of the hub where a meeting takes place?
  void find_leaving(Meeting& best) const {
    const std::uint32_t hub = labels_.arriving.hub[best.arriving].hub;
    const auto cost = static_cast<std::int64_t>(work_.hub[hub] - (work_.round << cost_bits));
    for (std::uint32_t i = 0; i < work_.from.size(); ++i) {
      if (!work_.from[i].is_priced) continue;
      const auto label = map_.leaving(work_.from[i].tangent.side);
      const auto entry = std::ranges::lower_bound(label, hub, {}, &HubCost::hub);
      if (entry == label.end() || entry->hub != hub) continue;
      if (bias + work_.from[i].cost + entry->cost != cost) continue;
      best.from = i;
      best.leaving = labels_.leaving.first[work_.from[i].tangent.side] +
                     static_cast<std::uint32_t>(entry - label.begin());
      return;
    }
  }

  /// The shortest way of two candidates that touch the same side.
  Meeting meet_on_one_side() {
    const double radius = map_.graph().radius;
    Meeting best;
    work_.on_side.forget(2 * map_.graph().arc.size());
    for (std::uint32_t i = 0; i < work_.from.size(); ++i) {
      Candidate& first = work_.from[i];
      const bool is_alone = !work_.on_side.has(first.tangent.side);
      std::uint32_t& on_side = work_.on_side[first.tangent.side];
      first.also_on_side = is_alone ? none : on_side;
      on_side = i;
    }
    for (std::uint32_t k = 0; k < work_.to.size(); ++k) {
      Candidate& last = work_.to[k];
      const std::uint32_t side = last.tangent.side;
      if (!work_.on_side.has(side)) continue;
      price_to(last);
      for (std::uint32_t i = work_.on_side[side]; i != none; i = work_.from[i].also_on_side) {
        Candidate& first = work_.from[i];
        price_from(first);
        const double turn = map_.turn_along(side, last.angle) - map_.turn_along(side, first.angle);
        if (turn < -same_angle) continue;
        const std::int64_t cost =
            in_units(first.tangent.length + radius * std::max(0.0, turn) + last.tangent.length);
        if (cost < best.cost) best = {cost, i, k, none, none};
      }
    }
    return best;
  }

  /// Writes the tangents of a meeting's way, in order, into the workspace.
  void unpack(const Meeting& best) {
    work_.tangents.clear();
    if (best.leaving == none) return;
    // A leaving label leads from its hub back to the side, so its links come last first.
    work_.links.clear();
    const LabelTable& leaving = labels_.leaving;
    for (std::uint32_t e = best.leaving; leaving.parent[e] != LabelTable::no_parent;
         e = leaving.parent[e])
      work_.links.push_back(leaving.link[e]);
    take_apart();
    const LabelTable& arriving = labels_.arriving;
    for (std::uint32_t e = best.arriving; e != LabelTable::no_parent; e = arriving.parent[e]) {
      work_.links.assign(1, arriving.link[e]);
      take_apart();
    }
  }
  void take_apart() {
    const auto tangents = static_cast<std::uint32_t>(map_.graph().tangent.size());
    while (!work_.links.empty()) {
      const std::uint32_t link = work_.links.back();
      work_.links.pop_back();
      if (link == HubLabels::roll) continue;
      if (link < tangents) {
        work_.tangents.push_back(link);
        continue;
      }
      const std::size_t part = 2 * std::size_t{link - tangents};
      work_.links.push_back(labels_.link_part[part + 1]);
      work_.links.push_back(labels_.link_part[part]);
    }
  }

  /// Does the way leave the arc where its labels begin not before it has arrived there? (Inside,
  /// the graph sees to it.) Points need not ask: a way that turns the wrong way there is not the
  /// shortest.
  bool first_turns_forward(const Candidate& first) const {
    if (map_.graph().radius == 0 || work_.tangents.empty()) return true;
    const std::uint32_t side = first.tangent.side;
    const Tangent& leave = map_.graph().tangent[work_.tangents.front()];
    return map_.turn_along(side, leave.leave_angle) >=
           map_.turn_along(side, first.angle) - same_angle;
  }
  /// Does it arrive where its labels end not after it leaves?
  bool last_turns_forward(const Candidate& last) const {
    if (map_.graph().radius == 0 || work_.tangents.empty()) return true;
    const std::uint32_t side = last.tangent.side;
    const Tangent& arrive = map_.graph().tangent[work_.tangents.back()];
    return map_.turn_along(side, arrive.arrive_angle) <=
           map_.turn_along(side, last.angle) + same_angle;
  }

  /// All bends of a way whose labels are unpacked.
  void list_bends(const Candidate& first, const Candidate& last) const {
    work_.way.clear();
    for (std::uint32_t i = first.bend; i != none; i = work_.bends[i].nearer)
      work_.way.push_back(work_.bends[i].bend);
    std::ranges::reverse(work_.way);
    for (const std::uint32_t k : work_.tangents) {
      const Tangent& tangent = map_.graph().tangent[k];
      work_.way.push_back(
          {tangent.leave_angle, tangent.arrive_angle, tangent.length, tangent.arrive_side});
    }
    for (std::uint32_t i = last.bend; i != none; i = work_.bends[i].nearer)
      work_.way.push_back(work_.bends[i].bend);
  }

  Way trace(const Candidate& first, const Candidate& last) const {
    list_bends(first, last);
    const auto tangent_of = [&](const Candidate& candidate) {
      return candidate.bend == none ? candidate.tangent : work_.bends[candidate.bend].end;
    };
    const auto angle_of = [&](const Candidate& candidate) {
      return candidate.bend == none ? candidate.angle : work_.bends[candidate.bend].angle;
    };
    const double radius = map_.graph().radius;
    Way way{RouteStatus::Ok, tangent_of(first).length + tangent_of(last).length, radius, {}};
    way.points.reserve(work_.way.size() + 4);
    way.points.push_back(from_);
    std::uint32_t side = tangent_of(first).side;
    double angle = angle_of(first);
    const auto roll = [&](double until) {
      way.length +=
          radius * std::max(0.0, map_.turn_along(side, until) - map_.turn_along(side, angle));
      append_arc(map_.corner(side), radius, angle, until, way.points);
    };
    for (const Bend& bend : work_.way) {
      roll(bend.leave_angle);
      way.length += bend.length;
      side = bend.arrive_side;
      angle = bend.arrive_angle;
    }
    roll(angle_of(last));
    append_point(to_, way.points);
    if (way.points.size() == 1) way.points.push_back(to_);
    return way;
  }

  const ShortestWayMap& map_;
  const HubLabels& labels_;
  double per_metre_;
  Vec2 from_, to_;
  Workspace& work_;
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
  for (std::size_t cell = 0; cell < walls_.cells(); ++cell)
    is_room_.push_back(walls_.is_clear(cell) && walls_.is_inside(walls_.centre_of(cell)));
  for (std::size_t a = 0; a < corner_.size(); ++a) {
    const ReflexCorner& corner = corner_[a];
    arc_.push_back({corner.position, corner.direction_at(graph_.arc[a].begin),
                    corner.direction_at(graph_.arc[a].end), graph_.arc[a].begin, 0});
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

double ShortestWayMap::angle_at(const EndTangent& tangent) const noexcept {
  const ArcOfEnds& arc = arc_[tangent.side / 2];
  if (graph_.radius == 0) return arc.begin_angle;
  const Vec2 out = tangent.touch - arc.centre;
  const double turn = std::atan2(cross(arc.begin, out), dot(arc.begin, out));
  // Just beyond the end of nearly half a turn is not far before its begin.
  return arc.begin_angle + (turn < -std::numbers::pi / 2 ? turn + 2 * std::numbers::pi : turn);
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
