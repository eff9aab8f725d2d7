#pragma once

#include <cstddef>
#include <cstdint>

#include "runtime/model/museum.h"
#include "runtime/schema/elements.h"
#include "runtime/schema/label_blob.h"
#include "runtime/schema/motion_blob.h"

/// Which column of schema.sql holds which field of the model, said once for the writer and the
/// reader alike. `row(name, field)` stands for one column; the field is const when writing.
namespace docent::schema {

void columns(auto& row, MaybeConst<Museum> auto& museum) {
  row("kiosk_floor", museum.kiosk_floor);
  row("kiosk_x", museum.kiosk.position.x);
  row("kiosk_y", museum.kiosk.position.y);
  row("kiosk_heading", museum.kiosk.heading);
  row("body_radius", museum.body_radius);
  row("time_zone", museum.time_zone);
  row("holidays", museum.holidays);
  row("ambient_count", museum.ambient.count);
  row("ambient_entrance", museum.ambient.entrances);
  row("ambient_look_least", museum.ambient.look_least);
  row("ambient_look_most", museum.ambient.look_most);
}

void columns(auto& row, MaybeConst<Livery> auto& livery) {
  row("paper", livery.paper);
  row("ink", livery.ink);
  row("accent", livery.accent);
  row("focus", livery.focus);
  row("title_family", livery.titles.family);
  row("title_language", livery.titles.languages);
  row("text_family", livery.text.family);
  row("text_language", livery.text.languages);
  row("logo", livery.logo);
  row("logo_at_night", livery.logo_at_night);
  row("logo_shows_at_night", livery.logo_shows_at_night);
}

void columns(auto& row, MaybeConst<FontFile> auto& font) {
  row("name", font.name);
  row("bytes", font.bytes);
}

void columns(auto& row, MaybeConst<KioskPlace> auto& kiosk) {
  row("name", kiosk.id);
  row("floor", kiosk.floor);
  row("x", kiosk.placement.position.x);
  row("y", kiosk.placement.position.y);
  row("heading", kiosk.placement.heading);
}

void columns(auto& row, MaybeConst<Language> auto& language) {
  row("tag", language.tag);
  row("name", language.name);
  row("right_to_left", language.right_to_left);
}

void columns(auto& row, MaybeConst<Floor> auto& floor) {
  row("name", floor.plan.name);
  row("ordinal", floor.plan.ordinal);
  row("height", floor.plan.height);
  row("short_name", floor.plan.short_name);
  row("vertex", floor.plan.vertex);
  row("ring", floor.plan.ring);
  row("next", floor.plan.next);
}

void columns(auto& row, MaybeConst<Connection> auto& connection) {
  row("name", connection.id);
  row("kind", connection.kind);
  row("direction", connection.direction);
  row("step_free", connection.step_free);
  row("closed", connection.closed);
  row("hours", connection.hours);
  row("wait_seconds", connection.wait_seconds);
  row("seconds_per_floor", connection.seconds_per_floor);
  row("metres_per_floor", connection.metres_per_floor);
  row("stop", connection.stops);
}

void columns(auto& row, MaybeConst<Door> auto& door) {
  row("name", door.name);
  row("ax", door.a.x);
  row("ay", door.a.y);
  row("bx", door.b.x);
  row("by", door.b.y);
  row("closed", door.closed);
  row("hours", door.hours);
  row("opens", door.opens);
  row("hinge", door.hinge);
}

void columns(auto& row, MaybeConst<VoronoiDiagram> auto& diagram) {
  row("site", diagram.site);
  row("vertex", diagram.vertex);
  row("clearance", diagram.clearance);
  row("edge", diagram.edge);
  row("region_first", diagram.region_first);
  row("region_edge", diagram.region_edge);
}

void columns(auto& row, MaybeConst<Roadmap> auto& roadmap) {
  row("position", roadmap.position);
  row("clearance", roadmap.clearance);
  row("voronoi_vertex", roadmap.voronoi_vertex);
  row("edge", roadmap.edges);
}

void columns(auto& row, MaybeConst<TangentGraph> auto& graph) {
  row("radius", graph.radius);
  row("arc", graph.arc);
  row("side_first", graph.side_first);
  row("tangent", graph.tangent);
}

void columns(auto& row, MaybeConst<SightMap> auto& sight) {
  row("corner", sight.corner);
  row("pair_first", sight.pair_first);
  row("pair_other", sight.pair_other);
  row("origin_x", sight.origin.x);
  row("origin_y", sight.origin.y);
  row("cell_size", sight.cell_size);
  row("cell_columns", sight.columns);
  row("cell_rows", sight.rows);
  row("cell_first", sight.cell_first);
  row("cell_corner", sight.cell_corner);
}

void columns(auto& row, MaybeConst<HubLabels> auto& labels) {
  row("unit", labels.unit);
  row("leaving", labels.leaving);
  row("arriving", labels.arriving);
  row("link_part", labels.link_part);
}

void columns(auto& row, MaybeConst<Scenery> auto& scenery) {
  row("vertex", scenery.vertices);
  row("triangle", scenery.indices);
  row("part", scenery.parts);
  row("lightmap_width", scenery.lightmap_width);
  row("lightmap_height", scenery.lightmap_height);
  row("lightmap_min_x", scenery.lightmap_min.x);
  row("lightmap_min_y", scenery.lightmap_min.y);
  row("lightmap_max_x", scenery.lightmap_max.x);
  row("lightmap_max_y", scenery.lightmap_max.y);
  row("lightmap", scenery.lightmap);
  row("sun_x", scenery.sun.x);
  row("sun_y", scenery.sun.y);
  row("sun_z", scenery.sun.z);
}

void columns(auto& row, MaybeConst<Room> auto& room) {
  row("name", room.id);
  row("floor", room.floor);
  row("label_x", room.label.x);
  row("label_y", room.label.y);
  row("outline", room.outline);
  row("closed", room.closed);
  row("hours", room.hours);
}

void columns(auto& row, MaybeConst<Exhibit> auto& exhibit) {
  row("name", exhibit.id);
  row("floor", exhibit.floor);
  row("room", exhibit.room);
  row("x", exhibit.placement.position.x);
  row("y", exhibit.placement.position.y);
  row("heading", exhibit.placement.heading);
  row("view_x", exhibit.viewing_point.position.x);
  row("view_y", exhibit.viewing_point.position.y);
  row("view_heading", exhibit.viewing_point.heading);
  row("place", exhibit.place);
  row("image", exhibit.image);
  row("closed", exhibit.closed);
  row("hours", exhibit.hours);
  row("weight", exhibit.weight);
  row("looking_seconds", exhibit.looking_seconds);
  row("object", exhibit.object);
  row("object_x", exhibit.stand.position.x);
  row("object_y", exhibit.stand.position.y);
  row("object_base", exhibit.stand.base);
  row("object_scale", exhibit.stand.scale);
  row("touch", exhibit.touches);
}

void columns(auto& row, MaybeConst<FurtherPicture> auto& picture) {
  row("exhibit", picture.exhibit);
  row("image", picture.image);
}

void columns(auto& row, MaybeConst<ExhibitSound> auto& sound) {
  row("exhibit", sound.exhibit);
}

void columns(auto& row, MaybeConst<SoundCue> auto& cue) {
  row("sound", cue.sound);
  row("language", cue.language);
  row("begin_ms", cue.begin);
  row("end_ms", cue.end);
  row("text", cue.text);
}

void columns(auto& row, MaybeConst<Cue> auto& cue) {
  row("picture", cue.picture);
  row("language", cue.language);
  row("begin_ms", cue.begin);
  row("end_ms", cue.end);
  row("text", cue.text);
}

void columns(auto& row, MaybeConst<Place> auto& place) {
  row("name", place.id);
  row("kind", place.kind);
  row("floor", place.floor);
  row("x", place.position.x);
  row("y", place.position.y);
  row("standing_x", place.standing.x);
  row("standing_y", place.standing.y);
}

void columns(auto& row, MaybeConst<WayOffer> auto& offer) {
  row("choice", offer.choice);
}

void columns(auto& row, MaybeConst<Tour> auto& tour) {
  row("name", tour.id);
  row("exhibit", tour.exhibits);
  row("fixed", tour.fixed);
  row("seconds", tour.seconds);
  row("arrives", tour.arrives);
  row("minutes", tour.minutes);
}

void columns(auto& row, MaybeConst<EncodedImage> auto& image) {
  row("name", image.name);
  row("width", image.width);
  row("height", image.height);
  row("bytes", image.bytes);
  row("small", image.small);
}

void columns(auto& row, MaybeConst<ExhibitObject> auto& object) {
  row("name", object.name);
  row("width", object.size.x);
  row("height", object.size.y);
  row("depth", object.size.z);
  row("distant_vertex", object.distant.vertices);
  row("distant_triangle", object.distant.triangles);
  row("detail", object.detail);
}

void columns(auto& row, MaybeConst<SpeechSound> auto& piece) {
  row("language", piece.language);
  row("text", piece.text);
  row("made_of", piece.made_of);
  row("skip", piece.skip);
  row("samples", piece.samples);
  row("packets", piece.packets);
}

void columns(auto& row, MaybeConst<Joint> auto& joint) {
  row("name", joint.name);
  row("parent", joint.parent);
  row("x", joint.offset.x);
  row("y", joint.offset.y);
  row("z", joint.offset.z);
}

void columns(auto& row, MaybeConst<MotionClip> auto& clip) {
  row("name", clip.name);
  row("role", clip.role);
  row("motion_class", clip.motion_class);
  row("frame_rate", clip.frame_rate);
  row("motion", clip);
}

void columns(auto& row, MaybeConst<MotionClass> auto& motion_class) {
  row("name", motion_class.name);
  row("coefficient", motion_class.coefficient);
  row("transition", motion_class.transition);
}

void columns(auto& row, MaybeConst<MotionGraph> auto& graph) {
  row("has_rotation", graph.skeleton.has_rotation);
  row("body_part", graph.skeleton.part);
  row("transition", graph.transitions);
}

void columns(auto& row, MaybeConst<Foresight> auto& foresight) {
  row("warped", foresight.warped);
  row("raw", foresight.raw);
  row("ending", foresight.ending);
}

void columns(auto& row, MaybeConst<SkinnedMesh> auto& mesh) {
  row("vertex", mesh.vertices);
  row("triangle", mesh.indices);
  row("figure_end", mesh.figure_end);
  row("inverse_bind", mesh.inverse_bind);
  row("colour", mesh.colour);
  row("cloth_node", mesh.cloth.node);
  row("cloth_collider", mesh.cloth.collider);
}

/// Goes through all tables in one order. A store has
///  - row(table, id, value): the row with that id;
///  - rows(table, values): all rows, ids 0, 1, ...;
///  - rows_of(table, parent column, parent id, values): those that belong to one parent;
///  - texts(subject, owner, map): rows of `text`.
void tables(auto& store, MaybeConst<Museum> auto& museum) {
  store.row("museum", 0, museum);
  store.rows("kiosk", museum.kiosks);
  store.row("livery", 0, museum.livery);
  store.rows("font", museum.fonts);
  store.texts("museum.title", 0, museum.title);
  store.texts("museum.welcome", 0, museum.welcome);
  store.texts("museum.reading", 0, museum.readings);
  store.rows("language", museum.languages);
  for (std::size_t i = 0; i < museum.languages.size(); ++i)
    store.texts("language.word", i, museum.languages[i].words);

  store.rows("floor", museum.floors);
  for (std::size_t i = 0; i < museum.floors.size(); ++i) {
    auto& floor = museum.floors[i];
    store.texts("floor.title", i, floor.title);
    store.rows_of("door", "floor", i, floor.plan.doors);
    store.row("voronoi_diagram", i, floor.diagram);
    store.row("roadmap", i, floor.roadmap);
    store.row("sight_map", i, floor.sight);
    store.rows_of("tangent_graph", "floor", i, floor.tangent_graphs);
    store.rows_of("hub_labels", "floor", i, floor.hub_labels);
  }
  store.rows("connection", museum.connections);
  store.rows("scenery", museum.scenery);

  store.rows("room", museum.rooms);
  for (std::size_t i = 0; i < museum.rooms.size(); ++i)
    store.texts("room.title", i, museum.rooms[i].title);
  store.rows("exhibit", museum.exhibits);
  for (std::size_t i = 0; i < museum.exhibits.size(); ++i) {
    store.texts("exhibit.title", i, museum.exhibits[i].title);
    store.texts("exhibit.text", i, museum.exhibits[i].text);
    store.texts("exhibit.description", i, museum.exhibits[i].description);
    store.texts("exhibit.more", i, museum.exhibits[i].more);
    store.texts("exhibit.artist", i, museum.exhibits[i].artist);
    store.texts("exhibit.subject", i, museum.exhibits[i].subject);
    store.texts("exhibit.period", i, museum.exhibits[i].period);
  }
  store.rows("picture", museum.pictures);
  for (std::size_t i = 0; i < museum.pictures.size(); ++i) {
    store.texts("picture.caption", i, museum.pictures[i].caption);
    store.texts("picture.description", i, museum.pictures[i].description);
  }
  store.rows("cue", museum.cues);
  store.rows("sound", museum.sounds);
  for (std::size_t i = 0; i < museum.sounds.size(); ++i) {
    store.texts("sound.title", i, museum.sounds[i].title);
    store.texts("sound.description", i, museum.sounds[i].description);
  }
  store.rows("sound_cue", museum.sound_cues);
  store.rows("place", museum.places);
  for (std::size_t i = 0; i < museum.places.size(); ++i)
    store.texts("place.title", i, museum.places[i].title);
  store.rows("way", museum.ways);
  for (std::size_t i = 0; i < museum.ways.size(); ++i)
    store.texts("way.title", i, museum.ways[i].title);
  store.rows("tour", museum.tours);
  for (std::size_t i = 0; i < museum.tours.size(); ++i)
    store.texts("tour.title", i, museum.tours[i].title);
  store.rows("image", museum.images);
  store.rows("object", museum.objects);
  store.rows("speech", museum.speech);

  store.rows("joint", museum.motion.skeleton.joint);
  store.rows("motion_clip", museum.motion.clips);
  store.rows("motion_class", museum.motion.classes);
  store.row("motion_graph", 0, museum.motion);
  store.row("foresight", 0, museum.motion.foresight);
  store.row("avatar", 0, museum.avatar);
}

}  // namespace docent::schema
