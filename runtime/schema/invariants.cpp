#include "runtime/schema/invariants.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>

#include "runtime/model/exhibit/longer_text.h"
#include "runtime/model/hours/opening_hours.h"
#include "runtime/model/hours/time_zone.h"
#include "runtime/model/scenery_images.h"
#include "runtime/schema/media_invariants.h"
#include "runtime/schema/object_blob.h"

namespace docent::schema {

namespace {

bool finite(double v) {
  return std::isfinite(v);
}
bool finite(Vec2 v) {
  return finite(v.x) && finite(v.y);
}
bool finite(Vec3 v) {
  return finite(v.x) && finite(v.y) && finite(v.z);
}
bool finite(Quat q) {
  return finite(q.x) && finite(q.y) && finite(q.z) && finite(q.w);
}
bool finite(const Placement& p) {
  return finite(p.position) && finite(p.heading);
}

template <typename T>
bool all_finite(const std::vector<T>& values) {
  return std::ranges::all_of(values, [](const T& v) { return finite(v); });
}

bool all_below(const std::vector<std::uint32_t>& indices, std::size_t count) {
  return std::ranges::all_of(indices, [=](std::uint32_t i) { return i < count; });
}

/// Are these whole triangles of `vertices` vertices?
bool are_triangles(const std::vector<std::uint32_t>& indices, std::size_t vertices) {
  return indices.size() % 3 == 0 && all_below(indices, vertices);
}

template <typename Enum>
bool exists(Enum value, Enum count) {
  return value >= Enum{} && value < count;
}

bool keeps_rings(const FloorPlan& plan) {
  std::size_t end = 0;
  for (const Ring& ring : plan.ring) {
    if (ring.first != end || ring.count < 3 || ring.count > plan.vertex.size() - end) return false;
    end += ring.count;
    for (std::uint32_t i = ring.first; i < end; ++i)
      if (plan.next[i] != (i + 1 < end ? i + 1 : ring.first)) return false;
  }
  return end == plan.vertex.size();
}

bool keeps(const FloorPlan& plan) {
  return plan.next.size() == plan.vertex.size() && all_finite(plan.vertex) && finite(plan.height) &&
         keeps_rings(plan) && std::ranges::all_of(plan.doors, [](const Door& door) {
           return finite(door.a) && finite(door.b) && door.opens < DoorOpens::Count &&
                  door.hinge < DoorHinge::Count;
         });
}

bool keeps(const VoronoiDiagram& diagram, std::size_t walls) {
  const std::size_t sites = diagram.site.size();
  const std::size_t vertices = diagram.vertex.size();
  const auto sound_site = [=](const Site& s) {
    return s.kind <= Site::Kind::Corner && s.index < walls;
  };
  const auto sound_edge = [=](const VoronoiEdge& e) {
    return e.from < vertices && e.to < vertices && e.left < sites && e.right < sites;
  };
  const auto& first = diagram.region_first;
  return std::ranges::all_of(diagram.site, sound_site) &&
         std::ranges::all_of(diagram.edge, sound_edge) && all_finite(diagram.vertex) &&
         diagram.clearance.size() == vertices && all_finite(diagram.clearance) &&
         first.size() == sites + 1 && first.front() == 0 && std::ranges::is_sorted(first) &&
         first.back() == diagram.region_edge.size() &&
         all_below(diagram.region_edge, diagram.edge.size());
}

bool keeps(const Roadmap& roadmap, const VoronoiDiagram& diagram) {
  const std::size_t nodes = roadmap.position.size();
  const auto sound_edge = [&](const RoadmapEdge& e) {
    return e.from < nodes && e.to < nodes && e.voronoi_edge < diagram.edge.size() &&
           finite(e.length) && finite(e.clearance);
  };
  return all_finite(roadmap.position) && roadmap.clearance.size() == nodes &&
         all_finite(roadmap.clearance) && roadmap.voronoi_vertex.size() == nodes &&
         all_below(roadmap.voronoi_vertex, diagram.vertex.size()) &&
         std::ranges::all_of(roadmap.edges, sound_edge);
}

bool keeps(const TangentGraph& graph, std::size_t vertices) {
  const auto& first = graph.side_first;
  const std::size_t sides = 2 * graph.arc.size();
  const auto sound_arc = [=](const TangentArc& a) {
    return a.vertex < vertices && finite(a.begin) && finite(a.end);
  };
  const auto leads_onward = [&](const Tangent& t) {
    return t.onward == TangentGraph::no_tangent ||
           (t.onward >= first[t.arrive_side] && t.onward < first[t.arrive_side + 1]);
  };
  const auto sound_tangent = [&](const Tangent& t) {
    return finite(t.leave) && finite(t.leave_angle) && finite(t.arrive_angle) && finite(t.length) &&
           t.arrive_side < sides && leads_onward(t);
  };
  return finite(graph.radius) && graph.radius >= 0 && std::ranges::all_of(graph.arc, sound_arc) &&
         first.size() == sides + 1 && first.front() == 0 && std::ranges::is_sorted(first) &&
         first.back() == graph.tangent.size() && std::ranges::all_of(graph.tangent, sound_tangent);
}

bool keeps(const std::vector<TangentGraph>& graphs, std::size_t vertices) {
  return !graphs.empty() && graphs.front().radius == 0 &&
         std::ranges::is_sorted(graphs, {}, &TangentGraph::radius) &&
         std::ranges::all_of(graphs, [=](const TangentGraph& g) { return keeps(g, vertices); });
}

/// Is `first` where each of `lists` lists begins among `values`, and one more?
bool are_lists(const std::vector<std::uint32_t>& first, std::size_t lists, std::size_t values) {
  return first.size() == lists + 1 && first.front() == 0 && std::ranges::is_sorted(first) &&
         first.back() == values;
}

bool keeps(const SightMap& sight, std::size_t vertices) {
  const std::size_t corners = sight.corner.size();
  return all_below(sight.corner, vertices) && std::ranges::is_sorted(sight.corner) &&
         are_lists(sight.pair_first, corners, sight.pair_other.size()) &&
         all_below(sight.pair_other, corners) && finite(sight.origin) && finite(sight.cell_size) &&
         sight.cell_size > 0 &&
         are_lists(sight.cell_first, std::size_t{sight.columns} * sight.rows,
                   sight.cell_corner.size()) &&
         all_below(sight.cell_corner, corners);
}

/// Every entry leads to its station in as many steps as the station has entries.
bool lead_home(const LabelTable& table) {
  for (std::size_t s = 0; s + 1 < table.first.size(); ++s) {
    const std::uint32_t begin = table.first[s], end = table.first[s + 1];
    for (std::uint32_t e = begin; e < end; ++e) {
      std::uint32_t at = e, steps = begin;
      for (; at != LabelTable::no_parent && steps <= end; ++steps) {
        if (at < begin || at >= end) return false;
        at = table.parent[at];
      }
      if (at != LabelTable::no_parent) return false;
    }
  }
  return true;
}

bool keeps(const HubLabels& labels, const TangentGraph& graph, double diagonal) {
  const std::size_t tangents = graph.tangent.size();
  const std::size_t hubs = graph.radius == 0 ? 2 * graph.arc.size() : tangents;
  const auto& parts = labels.link_part;
  const auto is_link = [&](std::uint32_t link, std::size_t shortcuts) {
    return link == HubLabels::roll || link < tangents + shortcuts;
  };
  const auto sound_table = [&](const LabelTable& table) {
    const std::size_t entries = table.hub.size();
    const auto sound_hub = [=](const HubCost& h) {
      return h.hub < hubs && h.cost <= HubLabels::most_cost;
    };
    return are_lists(table.first, 2 * graph.arc.size(), entries) &&
           std::ranges::all_of(table.hub, sound_hub) && table.link.size() == entries &&
           table.parent.size() == entries &&
           std::ranges::all_of(table.link,
                               [&](std::uint32_t l) { return is_link(l, parts.size() / 2); }) &&
           lead_home(table);
  };
  if (!labels.has_labels()) return labels.leaving.hub.empty() && labels.arriving.hub.empty();
  // A shortcut is made of earlier ones, so taking it apart ends.
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (!is_link(parts[i], i / 2)) return false;
  return parts.size() % 2 == 0 && finite(labels.unit) && labels.unit > 0 &&
         labels.unit * HubLabels::most_cost >= diagonal * (1 - 1e-9) &&
         sound_table(labels.leaving) && sound_table(labels.arriving);
}

bool keeps(const std::vector<HubLabels>& labels, const std::vector<TangentGraph>& graphs,
           double diagonal) {
  if (labels.size() != graphs.size()) return false;
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (!keeps(labels[i], graphs[i], diagonal)) return false;
  return true;
}

bool keeps(const Scenery& scenery, std::size_t exhibits) {
  const std::size_t indices = scenery.indices.size();
  const auto sound_part = [=](const SceneryPart& p) {
    return exists(p.surface, Surface::Count) && p.exhibit >= -1 &&
           p.exhibit < static_cast<std::int64_t>(exhibits) && p.first_index <= indices &&
           p.index_count <= indices - p.first_index && p.index_count % 3 == 0;
  };
  const auto sound_vertex = [](const SceneryVertex& v) {
    return finite(v.position) && finite(v.normal) && finite(v.uv[0]) && finite(v.uv[1]);
  };
  const std::uint64_t texels = std::uint64_t{scenery.lightmap_width} * scenery.lightmap_height;
  return std::ranges::all_of(scenery.vertices, sound_vertex) &&
         are_triangles(scenery.indices, scenery.vertices.size()) &&
         std::ranges::all_of(scenery.parts, sound_part) && texels <= scenery.lightmap.size() &&
         scenery.lightmap.size() == Scenery::lightmap_channels * texels &&
         finite(scenery.lightmap_min) && finite(scenery.lightmap_max) && finite(scenery.sun);
}

bool sound_time(double value) {
  return std::isfinite(value) && value >= 0;
}

/// Is it as the kiosk will find it when it is first looked at from nearby?
bool keeps(const ExhibitObject& object) {
  const auto sound_length = [](float metres) { return std::isfinite(metres) && metres >= 0; };
  ObjectDetail detail;
  return sound_length(object.size.x) && sound_length(object.size.y) &&
         sound_length(object.size.z) && is_whole(object.distant) &&
         object.distant.triangles.size() / 3 <= ExhibitObject::most_distant_triangles &&
         object.detail.size() <= ExhibitObject::most_bytes && decode(object.detail, detail);
}

bool stands(const Exhibit& exhibit, const Museum& museum) {
  const ObjectStand& stand = exhibit.stand;
  return exhibit.object >= -1 &&
         exhibit.object < static_cast<std::int64_t>(museum.objects.size()) &&
         finite(stand.position) && std::isfinite(stand.base) && std::isfinite(stand.scale) &&
         stand.scale > 0;
}

bool is_unit(Vec3 v) {
  constexpr float rounding = 1e-3F;
  return finite(v) && std::abs(glm::dot(v, v) - 1) < rounding;
}

/// Is it what somebody does who stands before it?
bool keeps(const Touch& touch, double ground) {
  const auto is_near = [](double metres) { return metres <= Touch::farthest; };
  const double height = static_cast<double>(touch.palm.y) - ground;
  return touch.beside <= Side::Right && touch.hand <= Side::Right && finite(touch.body) &&
         finite(touch.palm) && finite(touch.ready) && is_unit(touch.fingers) &&
         is_unit(touch.thumb) && is_unit(touch.normal) && touch.lean >= 0 &&
         touch.lean <= Touch::most_lean && height >= 0 && height <= Touch::highest &&
         is_near(glm::distance(touch.body.position, to_floor(touch.palm))) &&
         is_near(static_cast<double>(glm::distance(touch.palm, touch.ready)));
}

bool keep_touches(const Exhibit& exhibit, const Museum& museum) {
  const auto in_order = [](const Touch& one, const Touch& next) {
    return one.beside < next.beside;
  };
  const std::vector<Touch>& all = exhibit.touches;
  return (all.empty() || may_be_touched(exhibit.place)) &&
         std::ranges::adjacent_find(all, std::not_fn(in_order)) == all.end() &&
         std::ranges::all_of(all, [&](const Touch& touch) {
           return keeps(touch, museum.floors[exhibit.floor].plan.height);
         });
}

bool keeps_length(const LocalText& more) {
  return std::ranges::all_of(
      more, [](const auto& entry) { return count_letters(entry.second) <= longest_more; });
}

bool keeps(const Exhibit& exhibit, const Museum& museum) {
  return exhibit.floor < museum.floors.size() && exhibit.room < museum.rooms.size() &&
         exhibit.image < museum.images.size() && exhibit.place <= ExhibitPlace::OnWallToTouch &&
         finite(exhibit.placement) && finite(exhibit.viewing_point) && sound_time(exhibit.weight) &&
         sound_time(exhibit.looking_seconds) && keeps_length(exhibit.more) &&
         stands(exhibit, museum) && keep_touches(exhibit, museum);
}

bool keeps(const Tour& tour, std::size_t exhibits) {
  std::vector<std::uint32_t> all = tour.exhibits;
  std::ranges::sort(all);
  return !all.empty() && all.back() < exhibits && tour.arrives.size() == all.size() &&
         std::ranges::all_of(tour.arrives, sound_time) &&
         std::ranges::adjacent_find(all) == all.end() && sound_time(tour.seconds) &&
         sound_time(tour.minutes) && (tour.minutes > 0 || !is_for_time(tour));
}

bool are_hours(const std::string& text) {
  return text.empty() || parse_opening_hours(text).has_value();
}

/// Can all hours be read, and the time in which they are told?
bool keeps_hours(const Museum& museum) {
  const auto sound = [](const auto& thing) { return are_hours(thing.hours); };
  return (museum.time_zone.empty() || parse_time_zone(museum.time_zone)) &&
         (museum.holidays.empty() || parse_dates(museum.holidays)) &&
         std::ranges::all_of(museum.rooms, sound) && std::ranges::all_of(museum.exhibits, sound) &&
         std::ranges::all_of(museum.connections, sound) &&
         std::ranges::all_of(museum.floors, [&](const Floor& floor) {
           return std::ranges::all_of(floor.plan.doors, sound);
         });
}

bool keeps(const Place& place, const Museum& museum) {
  return place.kind < PlaceKind::Count && place.floor < museum.floors.size() &&
         finite(place.position) && finite(place.standing);
}

bool keep(std::span<const WayOffer> offers) {
  for (std::size_t i = 0; i < offers.size(); ++i)
    if (static_cast<std::size_t>(offers[i].choice) >= way_choices.size() ||
        std::ranges::count(offers, offers[i].choice, &WayOffer::choice) != 1)
      return false;
  return true;
}

bool are_distinct(std::span<const ConnectionStop> stops) {
  std::vector<std::uint32_t> floors;
  for (const ConnectionStop& stop : stops) floors.push_back(stop.floor);
  std::ranges::sort(floors);
  return std::ranges::adjacent_find(floors) == floors.end();
}

bool keeps(const Connection& connection, const Museum& museum) {
  const auto ordinal = [&](const ConnectionStop& stop) {
    return museum.floors[stop.floor].plan.ordinal;
  };
  return connection.stops.size() >= 2 && connection.kind <= ConnectionKind::Ramp &&
         connection.direction <= ConnectionDirection::Down && sound_time(connection.wait_seconds) &&
         sound_time(connection.seconds_per_floor) && sound_time(connection.metres_per_floor) &&
         std::ranges::all_of(connection.stops,
                             [&](const ConnectionStop& stop) {
                               return stop.floor < museum.floors.size() && finite(stop.placement);
                             }) &&
         std::ranges::is_sorted(connection.stops, {}, ordinal) && are_distinct(connection.stops);
}

bool keeps(const Ambient& ambient) {
  // Written so that a time that is not a number fails too.
  return ambient.count <= Ambient::most && all_finite(ambient.entrances) &&
         ambient.look_least > 0 && ambient.look_least <= ambient.look_most &&
         ambient.look_most <= Ambient::longest_look;
}

bool keeps(const Typeface& typeface, std::size_t languages) {
  return !typeface.family.contains(',') && std::ranges::is_sorted(typeface.languages) &&
         std::ranges::adjacent_find(typeface.languages) == typeface.languages.end() &&
         (typeface.languages.empty() ||
          (typeface.languages.back() < languages && !typeface.family.empty()));
}

bool keeps(const Livery& livery, const Museum& museum) {
  const auto is_colour = [](std::uint32_t colour) { return colour <= 0xFFFFFF; };
  const auto is_logo = [&](std::uint32_t image) {
    return image == none || (image >= scenery_images(museum) && image < museum.images.size() &&
                             museum.images[image].width > 0 && museum.images[image].height > 0);
  };
  return is_colour(livery.paper) && is_colour(livery.ink) && is_colour(livery.accent) &&
         is_colour(livery.focus) && keeps(livery.titles, museum.languages.size()) &&
         keeps(livery.text, museum.languages.size()) && is_logo(livery.logo) &&
         is_logo(livery.logo_at_night) && museum.fonts.size() <= Typeface::most_files &&
         std::ranges::all_of(museum.fonts, [](const FontFile& font) {
           return !font.bytes.empty() && font.bytes.size() <= FontFile::largest;
         });
}

bool keeps(const Skeleton& skeleton) {
  const auto joints = static_cast<std::int32_t>(skeleton.joint.size());
  for (std::int32_t i = 0; i < joints; ++i) {
    const Joint& joint = skeleton.joint[static_cast<std::size_t>(i)];
    const auto parent = static_cast<std::int32_t>(joint.parent);
    const bool is_root = parent == static_cast<std::int32_t>(JointIndex::None);
    if (is_root != (i == 0) || parent < -1 || parent >= i || !finite(joint.offset)) return false;
  }
  if (joints == 0) return skeleton.has_rotation.empty();  // compiled without motion
  return skeleton.has_rotation.size() == skeleton.joint.size() &&
         std::ranges::all_of(skeleton.part, [=](JointIndex j) {
           const auto index = static_cast<std::int32_t>(j);
           return index >= -1 && index < joints;
         });
}

bool keeps(const MotionClip& clip, std::size_t joints) {
  return clip.joint_count == joints && !clip.root.empty() && clip.role <= ClipRole::Other &&
         clip.rotation.size() == clip.root.size() * joints &&
         clip.plants.size() == clip.root.size() && finite(clip.frame_rate) && clip.frame_rate > 0 &&
         all_finite(clip.root) && all_finite(clip.rotation);
}

bool keeps(const Foresight& foresight, std::size_t transitions) {
  const auto fits = [&](const std::vector<std::uint16_t>& table, std::size_t each) {
    return table.empty() || table.size() == transitions * each;
  };
  return fits(foresight.warped, bend_axis.count * warped_slice) &&
         fits(foresight.raw, bend_axis.count * raw_slice) &&
         fits(foresight.ending, room_axis.count);
}

/// A class's own graph: transitions among its clips, in ascending order.
bool keeps_own_graph(const MotionGraph& graph, const MotionClass& motion_class) {
  const std::vector<std::uint32_t>& own = motion_class.transition;
  const auto joins_own_clips = [&](std::uint32_t t) {
    if (t >= graph.transitions.size()) return false;
    const Transition& way = graph.transitions[t];
    return graph.clips[way.from.clip].motion_class == motion_class.name &&
           graph.clips[way.to.clip].motion_class == motion_class.name;
  };
  return std::ranges::adjacent_find(own, std::ranges::greater_equal{}) == own.end() &&
         std::ranges::all_of(own, joins_own_clips);
}

bool keeps_classes(const MotionGraph& graph) {
  const std::vector<MotionClass>& classes = graph.classes;
  for (std::size_t i = 0; i < classes.size(); ++i) {
    if (classes[i].coefficient.size() != classes.size() || classes[i].coefficient[i] != 0 ||
        !keeps_own_graph(graph, classes[i]))
      return false;
    for (std::size_t j = 0; j < i; ++j) {
      const float coefficient = classes[i].coefficient[j];
      if (!(coefficient >= 0) || !finite(static_cast<double>(coefficient)) ||
          coefficient != classes[j].coefficient[i] || classes[i].name == classes[j].name)
        return false;
    }
  }
  return std::ranges::all_of(graph.clips, [&](const MotionClip& clip) {
    return classes.empty() || std::ranges::any_of(classes, [&](const MotionClass& motion_class) {
             return motion_class.name == clip.motion_class;
           });
  });
}

bool keeps(const MotionGraph& graph) {
  const auto sound_frame = [&](const ClipFrame& f) {
    return f.clip < graph.clips.size() && f.frame < graph.clips[f.clip].root.size();
  };
  const auto has_window = [&](const ClipFrame& f, std::uint32_t radius) {
    return sound_frame(f) && f.frame >= radius &&
           radius < graph.clips[f.clip].root.size() - f.frame;
  };
  const auto sound_transition = [&](const Transition& t) {
    return has_window(t.from, t.radius) && has_window(t.to, t.radius) && finite(t.distance) &&
           finite(t.alignment);
  };
  const std::size_t joints = graph.skeleton.joint.size();
  return keeps(graph.skeleton) &&
         std::ranges::all_of(graph.clips,
                             [=](const MotionClip& clip) { return keeps(clip, joints); }) &&
         std::ranges::all_of(graph.transitions, sound_transition) &&
         keeps(graph.foresight, graph.transitions.size());
}

/// Do these cut `indices` into runs of whole triangles?
bool are_ends(const std::vector<std::uint32_t>& ends, std::size_t indices) {
  return !ends.empty() && ends.back() == indices && std::ranges::is_sorted(ends) &&
         std::ranges::all_of(ends, [](std::uint32_t end) { return end % 3 == 0; });
}

/// Can the cloth of one body swing?
bool keeps(std::span<const ClothNode> nodes, std::span<const ClothCollider> colliders,
           std::size_t joints) {
  if (colliders.size() > most_cloth_colliders) return false;
  const auto is_node = [&](std::uint8_t n, std::size_t end) {
    return n == ClothNode::none || n < end;
  };
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const ClothNode& node = nodes[n];
    const bool sound =
        exists(node.kind, ClothKind::Count) && finite(node.place) && finite(node.outward) &&
        finite(node.root) && finite(node.gravity) &&
        glm::dot(node.gravity, node.gravity) <= most_cloth_gravity * most_cloth_gravity &&
        is_node(node.above, n) &&
        (node.above == ClothNode::none || nodes[node.above].kind == node.kind) &&
        is_node(node.left, nodes.size()) && is_node(node.right, nodes.size()) &&
        std::ranges::all_of(node.joint, [=](std::uint8_t j) { return j < joints; }) &&
        std::reduce(node.weight.begin(), node.weight.end(), 0) == 255 &&
        std::cmp_less_equal(std::bit_width(node.keeps_out), colliders.size()) && node.radius >= 0 &&
        node.radius < 1 &&
        std::ranges::all_of(
            std::array{node.stiffness, node.tension},
            [](float x) { return x >= 0 && x <= most_cloth_pull; }) &&
        std::ranges::all_of(
            std::array{node.damping, node.drag},
            [](float x) { return x >= 0 && x <= most_cloth_damping; });
    if (!sound) return false;
  }
  return std::ranges::all_of(colliders, [=](const ClothCollider& limb) {
    return finite(limb.from) && finite(limb.to) && limb.joint < joints && limb.from_radius >= 0 &&
           limb.to_radius >= 0 && limb.from_radius <= most_cloth_radius &&
           limb.to_radius <= most_cloth_radius;
  });
}

bool keeps(const Cloth& cloth, std::size_t bodies, std::size_t joints) {
  const auto in_order = [=](const auto& parts) {
    using Part = std::ranges::range_value_t<decltype(parts)>;
    return std::ranges::is_sorted(parts, {}, &Part::figure) &&
           (parts.empty() || parts.back().figure < bodies);
  };
  if (!in_order(cloth.node) || !in_order(cloth.collider)) return false;
  for (std::size_t body = 0; body < bodies; ++body)
    if (!keeps(of_figure(cloth.node, body), of_figure(cloth.collider, body), joints)) return false;
  return true;
}

bool keeps(const SkinnedMesh& mesh, std::size_t joints) {
  const auto sound_matrix = [](const Mat4& m) {
    return finite(Vec3(m[0])) && finite(Vec3(m[1])) && finite(Vec3(m[2])) && finite(Vec3(m[3]));
  };
  const std::size_t matrices = joints + nodes_of(mesh);
  const auto sound_vertex = [=](const SkinnedVertex& v) {
    return finite(v.position) && finite(v.normal) && exists(v.material, Material::Count) &&
           std::ranges::all_of(v.joint, [=](std::uint8_t j) { return j < matrices; });
  };
  if (mesh.vertices.empty())
    return mesh.indices.empty() && mesh.figure_end.empty() && mesh.colour.empty() &&
           mesh.cloth.node.empty() && mesh.cloth.collider.empty();
  return are_ends(mesh.figure_end, mesh.indices.size()) && matrices <= most_joints &&
         keeps(mesh.cloth, mesh.figure_end.size(), joints) &&
         mesh.inverse_bind.size() == joints * (has_own_body(mesh) ? mesh.figure_end.size() : 1) &&
         mesh.colour.size() <= mesh.vertices.size() &&
         std::ranges::all_of(mesh.inverse_bind, sound_matrix) &&
         std::ranges::all_of(mesh.vertices, sound_vertex) &&
         are_triangles(mesh.indices, mesh.vertices.size());
}

std::string broken_floor(const Floor& floor) {
  if (!keeps(floor.plan)) return "its walls";
  if (!keeps(floor.diagram, floor.plan.vertex.size())) return "its Voronoi diagram";
  if (!keeps(floor.roadmap, floor.diagram)) return "its roadmap";
  if (!keeps(floor.sight, floor.plan.vertex.size())) return "its sight map";
  if (!keeps(floor.tangent_graphs, floor.plan.vertex.size())) return "its tangent graphs";
  if (!keeps(floor.hub_labels, floor.tangent_graphs, diagonal(floor.plan))) return "its hub labels";
  return {};
}

}  // namespace

std::string broken_invariant(const Museum& museum) {
  if (museum.floors.empty()) return "it has no floor";
  if (museum.languages.empty()) return "it has no language";
  for (const Floor& floor : museum.floors)
    if (const std::string part = broken_floor(floor); !part.empty())
      return part + " on floor '" + floor.plan.name + "'";
  if (museum.scenery.size() != museum.floors.size()) return "its scenery";
  for (const Scenery& scenery : museum.scenery)
    if (!keeps(scenery, museum.exhibits.size())) return "its scenery";
  for (const Room& room : museum.rooms)
    if (room.floor >= museum.floors.size() || !finite(room.label) || !all_finite(room.outline))
      return "room '" + room.id + "'";
  for (const ExhibitObject& object : museum.objects)
    if (!keeps(object)) return "object '" + object.name + "'";
  for (const Exhibit& exhibit : museum.exhibits)
    if (!keeps(exhibit, museum)) return "exhibit '" + exhibit.id + "'";
  if (scenery_images(museum) > most_scenery_images) return "the number of exhibits' pictures";
  if (const std::string part = broken_media(museum); !part.empty()) return part;
  for (const Tour& tour : museum.tours)
    if (!keeps(tour, museum.exhibits.size())) return "tour '" + tour.id + "'";
  if (!std::ranges::is_sorted(museum.tours, {}, is_for_time)) return "the order of its tours";
  for (const Connection& connection : museum.connections)
    if (!keeps(connection, museum)) return "connection '" + connection.id + "'";
  for (const Place& place : museum.places)
    if (!keeps(place, museum)) return "place '" + place.id + "'";
  if (!keep(museum.ways)) return "the ways that it offers";
  if (!keeps(museum.livery, museum)) return "its own look";
  if (!keeps_hours(museum)) return "its hours";
  if (museum.kiosk_floor >= museum.floors.size() || !finite(museum.kiosk)) return "the kiosk";
  for (const KioskPlace& kiosk : museum.kiosks)
    if (kiosk.floor >= museum.floors.size() || !finite(kiosk.placement))
      return "kiosk '" + kiosk.id + "'";
  if (!finite(museum.body_radius) || museum.body_radius <= 0) return "the body's radius";
  if (!keeps(museum.ambient)) return "its strolling visitors";
  if (!keeps(museum.motion)) return "its motion";
  if (!keeps_classes(museum.motion)) return "its classes of motion";
  if (!keeps(museum.avatar, museum.motion.skeleton.joint.size())) return "its avatar";
  return {};
}

}  // namespace docent::schema
