#pragma once

#include "runtime/model/connection.h"
#include "runtime/model/exhibit/object.h"
#include "runtime/model/exhibit/touch.h"
#include "runtime/model/geometry/floor.h"
#include "runtime/model/motion/motion_graph.h"
#include "runtime/model/motion/skinned_mesh.h"
#include "runtime/model/scenery.h"
#include "runtime/schema/blob.h"

/// The structs that blobs hold, field by field, in the order in which they lie in the bytes.
/// Whoever changes one raises schema::version.
namespace docent::schema {

void fields(auto& io, MaybeConst<Ring> auto& r) {
  io(r.first, r.count);
}

void fields(auto& io, MaybeConst<ConnectionStop> auto& s) {
  io(s.floor, s.placement.position, s.placement.heading);
}

void fields(auto& io, MaybeConst<Site> auto& s) {
  io(s.kind, s.index);
}
void fields(auto& io, MaybeConst<VoronoiEdge> auto& e) {
  io(e.from, e.to, e.left, e.right, e.on_medial_axis, e.parabola);
}
void fields(auto& io, MaybeConst<RoadmapEdge> auto& e) {
  io(e.from, e.to, e.voronoi_edge, e.length, e.clearance);
}
void fields(auto& io, MaybeConst<TangentArc> auto& a) {
  io(a.vertex, a.begin, a.end);
}
void fields(auto& io, MaybeConst<Tangent> auto& t) {
  io(t.leave, t.leave_angle, t.arrive_angle, t.length, t.arrive_side, t.onward);
}

void fields(auto& io, MaybeConst<SceneryVertex> auto& v) {
  io(v.position, v.normal, v.uv, v.sky, v.sun);
}
void fields(auto& io, MaybeConst<SceneryPart> auto& p) {
  io(p.surface, p.exhibit, p.first_index, p.index_count);
}

void fields(auto& io, MaybeConst<FootPlants> auto& p) {
  io(p.left, p.right);
}
void fields(auto& io, MaybeConst<ClipFrame> auto& f) {
  io(f.clip, f.frame);
}
void fields(auto& io, MaybeConst<Transition> auto& t) {
  io(t.from, t.to, t.radius, t.distance, t.alignment);
}

void fields(auto& io, MaybeConst<SkinnedVertex> auto& v) {
  io(v.position, v.normal, v.joint, v.weight, v.material, v.occlusion);
}

void fields(auto& io, MaybeConst<ClothNode> auto& n) {
  io(n.kind, n.figure, n.joint, n.weight, n.place, n.outward, n.above, n.left, n.right, n.radius);
  io(n.keeps_out, n.stiffness, n.damping, n.drag, n.tension, n.root, n.gravity);
}
void fields(auto& io, MaybeConst<ClothCollider> auto& c) {
  io(c.figure, c.joint, c.from, c.to, c.from_radius, c.to_radius);
}

void fields(auto& io, MaybeConst<Touch> auto& t) {
  io(t.beside, t.hand, t.body, t.palm, t.fingers, t.thumb, t.normal, t.ready, t.lean);
}

void fields(auto& io, MaybeConst<ObjectVertex> auto& v) {
  io(v.position, v.normal, v.uv, v.colour, v.occlusion);
}
void fields(auto& io, MaybeConst<ObjectPart> auto& p) {
  io(p.first_index, p.index_count, p.picture, p.wrap);
}

}  // namespace docent::schema
