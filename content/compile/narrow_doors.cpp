#include "content/compile/narrow_doors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <queue>
#include <ranges>
#include <set>
#include <tuple>
#include <utility>

#include "content/compile/place_exhibits.h"
#include "content/compile/sets.h"
#include "runtime/model/geometry/polygon.h"
#include "runtime/model/none.h"
#include "runtime/path/floor_map.h"

namespace docent::compile {

namespace {

/// Where a narrow place is narrowest on the widest way through it, and the parts that it joins.
struct Neck {
  std::uint32_t edge = 0;      ///< Of the roadmap.
  std::uint32_t a = 0, b = 0;  ///< Parts.
};

/// The roadmap of a floor, taken apart where it is too narrow for a body. What is left hangs
/// together in parts, each known by one of its nodes.
class Parts {
 public:
  Parts(const Roadmap& roadmap, double radius)
      : roadmap_(roadmap), least_(path::least_clearance(radius)), part_(roadmap.position.size()) {
    for (const RoadmapEdge& edge : roadmap.edges)
      if (edge.clearance >= least_) part_.join(part_.of(edge.from), part_.of(edge.to));
    find_necks();
  }

  [[nodiscard]] bool has_room(std::uint32_t node) const {
    return roadmap_.clearance[node] >= least_;
  }
  std::uint32_t of(std::uint32_t node) { return part_.of(node); }
  [[nodiscard]] const std::vector<Neck>& necks() const { return necks_; }

 private:
  /// Finds the necks of each narrow place: edges that are too narrow and hang together at nodes
  /// that are. Joining the edges of one, the widest first, joins two parts at the narrowest edge of
  /// the widest way between them. Dead ends join none.
  void find_necks() {
    const auto nodes = static_cast<std::uint32_t>(roadmap_.position.size());
    Sets place(nodes);
    std::vector<std::uint32_t> narrow;
    for (std::uint32_t e = 0; e < roadmap_.edges.size(); ++e) {
      const auto& [from, to, voronoi_edge, length, clearance] = roadmap_.edges[e];
      if (clearance >= least_) continue;
      narrow.push_back(e);
      if (!has_room(from) && !has_room(to)) place.join(place.of(from), place.of(to));
    }
    const auto place_of = [&](std::uint32_t e) {
      const RoadmapEdge& edge = roadmap_.edges[e];
      if (has_room(edge.from) && has_room(edge.to)) return nodes + e;  // a place of its own
      return place.of(has_room(edge.from) ? edge.to : edge.from);
    };
    std::ranges::sort(narrow, {}, [&](std::uint32_t e) {
      // To the micrometre: of a doorway with even walls, its middle counts as the narrowest.
      const RoadmapEdge& edge = roadmap_.edges[e];
      const double ends = roadmap_.clearance[edge.from] + roadmap_.clearance[edge.to];
      return std::tuple(place_of(e), -std::llround(1e6 * edge.clearance), -std::llround(1e6 * ends),
                        e);
    });
    Sets joined(nodes);
    for (std::size_t begin = 0, end = 0; begin < narrow.size(); begin = end) {
      while (end < narrow.size() && place_of(narrow[end]) == place_of(narrow[begin])) ++end;
      join_place(std::span(narrow).subspan(begin, end - begin), joined);
    }
  }

  /// Leaves `joined` as it was: every number alone.
  void join_place(std::span<const std::uint32_t> edges, Sets& joined) {
    const auto ends_of = [&](std::uint32_t e) {
      const RoadmapEdge& edge = roadmap_.edges[e];
      const auto end = [&](std::uint32_t node) { return has_room(node) ? of(node) : node; };
      return std::pair(end(edge.from), end(edge.to));
    };
    for (const std::uint32_t e : edges) {
      const auto [from, to] = ends_of(e);
      std::uint32_t a = joined.of(from), b = joined.of(to);
      if (a == b) continue;
      if (has_room(a) && has_room(b)) necks_.push_back({e, a, b});
      if (!has_room(a)) std::swap(a, b);
      joined.join(a, b);  // known by a part, if it holds one
    }
    for (const std::uint32_t e : edges) {
      const auto [from, to] = ends_of(e);
      joined.leave(from);
      joined.leave(to);
    }
  }

  const Roadmap& roadmap_;
  double least_;  ///< Clearance at which a body fits.
  Sets part_;
  std::vector<Neck> necks_;
};

class DoorFinder {
 public:
  explicit DoorFinder(const ComingBody& body)
      : body_(body), roadmap_(body.map.floor().roadmap), parts_(roadmap_, body.radius) {}

  std::vector<NarrowDoor> find(std::span<const Vec2> wanted) {
    const auto home = part_reached_from(body_.from);
    if (!home || parts_.necks().empty()) return {};
    find_rooms();
    find_edges();
    std::set<std::uint32_t> wanted_parts = parts_of_lost_rooms(*home);
    for (const Vec2 place : wanted)
      if (const auto part = part_reached_from(place)) wanted_parts.insert(*part);
    wanted_parts.erase(*home);
    if (wanted_parts.empty()) return {};
    const std::vector<Neck> necks = necks_between(*home, wanted_parts, parts_.necks());
    std::set<std::uint32_t> on_widest_way;
    for (const Neck& neck : necks_between(*home, wanted_parts, widest(necks)))
      on_widest_way.insert(neck.edge);
    std::vector<NarrowDoor> doors;
    for (const Neck& neck : necks) {
      const Vec2 position = position_of(neck.edge);
      const bool needed = on_widest_way.contains(neck.edge);
      std::string name = door_name(neck.edge, position);
      if (name.empty() && !needed) continue;
      if (name.empty()) name = place_name(neck.edge, position);
      doors.push_back({position, 2 * roadmap_.edges[neck.edge].clearance, std::move(name), needed});
    }
    return doors;
  }

 private:
  /// The part of a place with room: from the nearest wall straight up to the medial axis, along it
  /// where there is room, and out of the dead end where that is one.
  std::optional<std::uint32_t> part_reached_from(Vec2 place) {
    const path::MedialAxisMap& axis = body_.map.medial_axis();
    const auto above = axis.place_above(body_.map.site_at(place), place);
    if (!above) return {};
    const path::EdgeCurve& curve = axis.curve(above->voronoi_edge);
    const auto end_of = [&](std::uint32_t e, bool to) {
      return to ? axis.diagram().edge[e].to : axis.diagram().edge[e].from;
    };
    const bool onward =
        curve.clearance_between(above->at, curve.end()) >= path::least_clearance(body_.radius);
    std::uint32_t vertex = end_of(above->voronoi_edge, onward);
    while (axis.node_at(vertex) == none) {
      const std::uint32_t e = axis.edge_to_road(vertex);
      if (e == none) return {};
      vertex = end_of(e, end_of(e, false) == vertex);
    }
    const std::uint32_t node = axis.node_at(vertex);
    return parts_.has_room(node) ? std::optional(parts_.of(node)) : std::nullopt;
  }

  /// Notes in which room the nodes are: inside its outline; and of a room without one, the node
  /// nearest to where its name stands.
  void find_rooms() {
    const auto nodes = static_cast<std::uint32_t>(roadmap_.position.size());
    room_of_node_.assign(nodes, nullptr);
    for (const Room& room : body_.rooms) {
      const auto from_label = [&](std::uint32_t node) {
        return glm::distance(roadmap_.position[node], room.label);
      };
      if (room.outline.empty())
        room_of_node_[std::ranges::min(std::views::iota(0U, nodes), {}, from_label)] = &room;
      for (std::uint32_t node = 0; node < nodes; ++node)
        if (contains(room.outline, roadmap_.position[node])) room_of_node_[node] = &room;
    }
  }

  void find_edges() {
    edges_at_.resize(roadmap_.position.size());
    for (std::uint32_t e = 0; e < roadmap_.edges.size(); ++e)
      for (const std::uint32_t node : {roadmap_.edges[e].from, roadmap_.edges[e].to})
        edges_at_[node].push_back(e);
  }

  /// Of every room of which no part is `home`: the part where it is widest.
  std::set<std::uint32_t> parts_of_lost_rooms(std::uint32_t home) {
    std::set<std::uint32_t> parts;
    for (const Room& room : body_.rooms) {
      std::optional<std::uint32_t> widest;
      bool is_reached = false;
      for (std::uint32_t node = 0; node < room_of_node_.size(); ++node) {
        if (room_of_node_[node] != &room || !parts_.has_room(node)) continue;
        is_reached = is_reached || parts_.of(node) == home;
        if (!widest || roadmap_.clearance[node] > roadmap_.clearance[*widest]) widest = node;
      }
      if (widest && !is_reached) parts.insert(parts_.of(*widest));
    }
    return parts;
  }

  /// Those of the necks on the widest ways between all parts, which form a tree.
  std::vector<Neck> widest(std::vector<Neck> necks) const {
    std::ranges::stable_sort(necks, std::greater<>(),
                             [&](const Neck& neck) { return roadmap_.edges[neck.edge].clearance; });
    Sets joined(roadmap_.position.size());
    std::erase_if(necks, [&](const Neck& neck) {
      const std::uint32_t a = joined.of(neck.a), b = joined.of(neck.b);
      joined.join(a, b);
      return a == b;
    });
    return necks;
  }

  /// The necks that hang together with `home`, without those that lead only to parts that nobody
  /// wants.
  std::vector<Neck> necks_between(std::uint32_t home, const std::set<std::uint32_t>& wanted,
                                  std::vector<Neck> necks) const {
    Sets joined(roadmap_.position.size());
    for (const Neck& neck : necks) joined.join(joined.of(neck.a), joined.of(neck.b));
    std::erase_if(necks, [&](const Neck& neck) { return joined.of(neck.a) != joined.of(home); });

    std::map<std::uint32_t, std::set<std::uint32_t>> neighbours;
    for (const Neck& neck : necks) {
      neighbours[neck.a].insert(neck.b);
      neighbours[neck.b].insert(neck.a);
    }
    std::vector<std::uint32_t> unwanted;
    const auto consider = [&](std::uint32_t part) {
      if (part != home && !wanted.contains(part) && neighbours[part].size() == 1)
        unwanted.push_back(part);
    };
    for (const auto& [part, others] : neighbours) consider(part);
    while (!unwanted.empty()) {
      const std::uint32_t part = unwanted.back();
      unwanted.pop_back();
      const std::uint32_t other = *neighbours[part].begin();
      neighbours[part].clear();
      neighbours[other].erase(part);
      consider(other);
    }
    std::erase_if(necks, [&](const Neck& neck) { return !neighbours[neck.a].contains(neck.b); });
    return necks;
  }

  [[nodiscard]] Vec2 position_of(std::uint32_t e) const {
    const path::EdgeCurve& curve = body_.map.medial_axis().curve(roadmap_.edges[e].voronoi_edge);
    return curve.point_at(curve.lowest_place());
  }

  /// Staff's own name for a doorway that they can close, else the rooms on both sides; empty where
  /// these are not two.
  [[nodiscard]] std::string door_name(std::uint32_t e, Vec2 position) const {
    for (const Door& door : body_.doors) {
      const Vec2 across = door.b - door.a, from_a = position - door.a;
      const double width = dot(across, across), place = dot(from_a, across);  // both times |across|
      if (place >= 0 && place <= width && std::abs(cross(across, from_a)) <= width)
        return fmt::format("the door '{}'", door.name);
    }
    const auto [one, other] = rooms_beside(e);
    if (one == nullptr || one == other) return {};
    return fmt::format("the door between '{}' and '{}'", title_of(*one), title_of(*other));
  }

  [[nodiscard]] std::string place_name(std::uint32_t e, Vec2 position) const {
    const Room* room = rooms_beside(e).second;
    const std::string in = room != nullptr ? fmt::format(" in '{}'", title_of(*room)) : "";
    return fmt::format("the narrow place{} at {}", in, point_text(position));
  }

  /// In the order of museum.toml, null first.
  [[nodiscard]] std::pair<const Room*, const Room*> rooms_beside(std::uint32_t e) const {
    return std::minmax(
        {room_beyond(e, roadmap_.edges[e].from), room_beyond(e, roadmap_.edges[e].to)},
        std::less<>());
  }

  [[nodiscard]] const std::string& title_of(const Room& room) const {
    const auto title = room.title.find(body_.language);
    return title == room.title.end() ? room.id : title->second;
  }

  /// The room that one comes to first after a neck, through one end of its edge.
  [[nodiscard]] const Room* room_beyond(std::uint32_t neck, std::uint32_t end) const {
    using Reached = std::pair<double, std::uint32_t>;
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> next;
    std::vector<bool> is_done(roadmap_.position.size(), false);
    next.emplace(0.0, end);
    while (!next.empty()) {
      const auto [length, node] = next.top();
      next.pop();
      if (parts_.has_room(node) && room_of_node_[node] != nullptr) return room_of_node_[node];
      if (is_done[node]) continue;
      is_done[node] = true;
      for (const std::uint32_t e : edges_at_[node]) {
        const RoadmapEdge& edge = roadmap_.edges[e];
        if (e != neck) next.emplace(length + edge.length, edge.from == node ? edge.to : edge.from);
      }
    }
    return nullptr;
  }

  const ComingBody& body_;
  const Roadmap& roadmap_;
  Parts parts_;
  std::vector<const Room*> room_of_node_;             ///< Per node, or null.
  std::vector<std::vector<std::uint32_t>> edges_at_;  ///< Per node.
};

}  // namespace

std::vector<NarrowDoor> narrow_doors(const ComingBody& body, std::span<const Vec2> wanted) {
  return DoorFinder(body).find(wanted);
}

}  // namespace docent::compile
