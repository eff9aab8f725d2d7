#pragma once

#include "runtime/model/museum.h"

namespace docent::test {

/// A museum made by hand with at least one of everything that a database holds, for tests of the
/// writer and the reader. Its geometry is not a real floor's.
inline Museum small_museum() {
  Museum museum;
  museum.title = {{"en", "The Two Rooms"}, {"zh", "两室博物馆"}};
  museum.welcome = {{"en", "Welcome"}, {"zh", "欢迎"}};
  museum.languages = {
      {.tag = "en", .name = "English", .right_to_left = false, .words = {{"home", "Home"}}},
      {.tag = "ar", .name = "العربية", .right_to_left = true, .words = {{"home", "البداية"}}}};

  Floor floor;
  floor.plan = {.name = "ground",
                .height = 0.5,
                .vertex = {{0, 0}, {10, 0}, {10, 8}, {0, 8}},
                .ring = {{0, 4}},
                .next = {1, 2, 3, 0},
                .doors = {{.name = "gate", .a = {5, 0}, .b = {5, 8}, .closed = true}}};
  floor.diagram = {.site = {{Site::Kind::Wall, 0}, {Site::Kind::Wall, 1}},
                   .vertex = {{4, 4}, {6, 4}},
                   .clearance = {4, 4},
                   .edge = {{.from = 0, .to = 1, .left = 1, .right = 0, .on_medial_axis = true}},
                   .region_first = {0, 1, 2},
                   .region_edge = {0, 0}};
  floor.roadmap = {.position = {{4, 4}, {6, 4}},
                   .clearance = {4, 4},
                   .voronoi_vertex = {0, 1},
                   .edges = {{.from = 0, .to = 1, .voronoi_edge = 0, .length = 2, .clearance = 4}}};
  floor.tangent_graphs = {{.radius = 0, .arc = {}, .side_first = {0}, .tangent = {}},
                          {.radius = 0.25,
                           .arc = {{.vertex = 2, .begin = 0, .end = 1.5}},
                           .side_first = {0, 1, 1},
                           .tangent = {{.leave = {1, 2},
                                        .leave_angle = 0.5,
                                        .arrive_angle = 0.75,
                                        .length = 3,
                                        .arrive_side = 1,
                                        .onward = TangentGraph::no_tangent}}}};
  floor.sight = {.corner = {2},
                 .pair_first = {0, 0},
                 .pair_other = {},
                 .origin = {0, 0},
                 .cell_size = 5,
                 .columns = 2,
                 .rows = 2,
                 .cell_first = {0, 1, 1, 1, 1},
                 .cell_corner = {0}};
  floor.hub_labels = {{},
                      {.unit = 0.5,
                       .leaving = {.first = {0, 1, 1},
                                   .hub = {{.hub = 0, .cost = 1}},
                                   .link = {HubLabels::roll},
                                   .parent = {LabelTable::no_parent}},
                       .arriving = {.first = {0, 0, 1},
                                    .hub = {{.hub = 0, .cost = 7}},
                                    .link = {1},
                                    .parent = {LabelTable::no_parent}},
                       .link_part = {0, HubLabels::roll}}};
  floor.title = {{"en", "Ground floor"}};
  museum.floors.push_back(floor);
  floor.plan.name = "upper";
  floor.plan.ordinal = 1;
  floor.plan.height = 4.5;
  floor.plan.short_name = "1";
  floor.title = {{"en", "Upper floor"}};
  museum.floors.push_back(floor);
  museum.connections.push_back({.id = "lift",
                                .kind = ConnectionKind::Lift,
                                .direction = ConnectionDirection::Down,
                                .step_free = true,
                                .closed = true,
                                .wait_seconds = 20,
                                .seconds_per_floor = 2.5,
                                .metres_per_floor = 0.5,
                                .stops = {{0, {{1, 2}, 0.5}}, {1, {{3, 4}, -1}}}});

  museum.scenery.push_back(
      {.vertices = {{.position = {1, 2, 3}, .uv = {0.5F, 0.25F}, .sky = 7},
                    {.position = {4, 5, 6}},
                    {.position = {7, 8, 9}}},
       .indices = {0, 1, 2},
       .parts = {{.surface = Surface::Picture, .exhibit = 0, .first_index = 0, .index_count = 3}},
       .lightmap_width = 2,
       .lightmap_height = 1,
       .lightmap_min = {-1, -2},
       .lightmap_max = {11, 9},
       .lightmap = {std::byte{1}, std::byte{2}, std::byte{0}, std::byte{3}, std::byte{255},
                    std::byte{90}},
       .sun = {0.6F, 0.8F, 0}});
  museum.rooms.push_back({.id = "east",
                          .floor = 0,
                          .title = {{"en", "East"}},
                          .label = {5, 4},
                          .outline = {{0, 0}, {10, 0}, {10, 8}}});
  museum.exhibits.push_back({.id = "jade-disc",
                             .floor = 0,
                             .room = 0,
                             .placement = {{10, 4}, 3.0},
                             .viewing_point = {{8.5, 4}, 0.1},
                             .place = ExhibitPlace::OnWallToTouch,
                             .title = {{"en", "Jade disc"}},
                             .text = {{"en", "A disc of jade."}, {"zh", "玉璧。"}},
                             .more = {{"en", "It was found in a well."}},
                             .image = 0,
                             .touches = {{.beside = Side::Right,
                                          .hand = Side::Left,
                                          .body = {{9.25, 4.5}, 0.25},
                                          .palm = {9.75F, 1.75F, -4.25F},
                                          .fingers = {0, 1, 0},
                                          .thumb = {0, 0, 1},
                                          .normal = {-1, 0, 0},
                                          .ready = {9.5F, 1.75F, -4.25F},
                                          .lean = 0.125F}}});
  museum.pictures.push_back({.exhibit = 0,
                             .image = 0,
                             .caption = {{"en", "The back"}},
                             .description = {{"en", "A worn disc."}}});
  museum.cues = {{.picture = 0, .language = 0, .begin = 500, .end = 2000, .text = "It turns."},
                 {.picture = 0, .language = 0, .begin = 2000, .end = 60500, .text = "- Look!"},
                 {.picture = 0, .language = 1, .begin = 500, .end = 2000, .text = "يدور."}};
  museum.scenery.push_back(museum.scenery.front());
  museum.images.push_back(
      {.name = "images/disc.png", .width = 2, .height = 3, .bytes = {std::byte{0x89}}});
  museum.images.push_back(
      {.name = "images/logo.png", .width = 4, .height = 3, .bytes = {std::byte{0x89}}});
  museum.livery = {.accent = 0x00539B,
                   .titles = {.family = "House", .languages = {0, 1}},
                   .text = {},
                   .logo = 1,
                   .logo_shows_at_night = true};
  museum.fonts = {{.name = "house.ttf", .bytes = {std::byte{0}, std::byte{1}}}};
  // Two frames of 20 ms of silence, less what the encoder looks ahead.
  const std::byte contents{0x48}, quiet{0xff}, none{};
  museum.speech.push_back(
      {.language = 0,
       .text = "Jade disc",
       .made_of = "5a",
       .skip = 312,
       .samples = 1500,
       .packets = {std::byte{2}, none, contents, quiet, std::byte{2}, none, contents, quiet}});
  museum.speech.push_back(museum.speech.front());
  museum.speech.back().language = 1;
  museum.sounds = {{.exhibit = 0,
                    .title = {{"en", "The disc rings"}},
                    .description = {{"en", "A clear note."}}}};
  SpeechSound rings = museum.speech.back();
  rings.text = RecordingKey(0).text();
  rings.made_of = "5b";
  museum.speech.insert(museum.speech.end() - 1, rings);
  museum.sound_cues = {
      {.sound = 0, .language = 0, .begin = 0, .end = 1000, .text = "[It rings]"},
      {.sound = 0, .language = 0, .begin = 1000, .end = 300'500, .text = "[Silence]"},
      {.sound = 0, .language = 1, .begin = 0, .end = 1000, .text = "[رنين]"}};
  museum.kiosk = {{1, 1}, 0.5};
  museum.kiosks = {{.id = "foyer", .floor = 0, .placement = {{1, 1}, 0.5}},
                   {.id = "cafe", .floor = 0, .placement = {{9, 4}, -1.5}}};
  museum.body_radius = 0.3;
  museum.ambient = {.count = 12, .entrances = {{2, 3}, {5, 7}}, .look_least = 4, .look_most = 9.5};

  MotionGraph& graph = museum.motion;
  graph.skeleton.joint = {{.name = "Hips", .parent = JointIndex::None, .offset = {0, 1, 0}},
                          {.name = "Spine", .parent = JointIndex{0}, .offset = {0, 0.5F, 0}}};
  graph.skeleton.has_rotation = {true, false};
  graph.skeleton.part.fill(JointIndex::None);
  graph.skeleton.part[0] = JointIndex{0};
  graph.clips.push_back(
      {.name = "walk",
       .role = ClipRole::Walk,
       .motion_class = "walk",
       .frame_rate = 60,
       .joint_count = 2,
       .root = {{0, 1, 0}, {0, 1, 0.125F}},
       .rotation = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}},
       .plants = {{.left = true, .right = false}, {.left = false, .right = true}}});
  graph.transitions.push_back(
      {.from = {0, 1}, .to = {0, 0}, .radius = 0, .distance = 0.125F, .alignment = {{1, 2}, -0.5}});
  graph.classes = {{.name = "walk", .coefficient = {0, 1.5F}},
                   {.name = "jog", .coefficient = {1.5F, 0}}};
  museum.avatar = {.vertices = {{.position = {0, 1, 0},
                                 .normal = {0, 0, 1},
                                 .joint = {0, 1, 0, 0},
                                 .weight = {200, 55, 0, 0},
                                 .material = Material::Coat,
                                 .occlusion = 100}},
                   .indices = {0, 0, 0},
                   .figure_end = {3},
                   .inverse_bind = {Mat4(1), Mat4(2)}};
  museum.avatar.cloth.node = {{.weight = {255, 0, 0, 0}, .place = {0, 2, 2}},
                              {.weight = {255, 0, 0, 0}, .place = {0, 1, 2}, .above = 0}};
  museum.avatar.cloth.collider = {{.joint = 1, .to_radius = 0.25F}};
  return museum;
}

}  // namespace docent::test
