#include "platform/gles/renderer.h"

#include <GLES3/gl3.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <glm/gtc/matrix_transform.hpp>
#include <iterator>
#include <optional>
#include <string_view>

#include "content/scenery/scenery.h"
#include "platform/headless/headless_display.h"
#include "runtime/scene/look.h"
#include "runtime/scene/theme.h"
#include "tests/platform/gles/allocations.h"
#include "tests/support/halls.h"
#include "tests/support/reference_data.h"

namespace docent::gles::renderer_test {
namespace {

using ::testing::HasSubstr;

constexpr PixelSize small{320, 180};

struct Rgb {
  int r = 0, g = 0, b = 0;
};

Rgb pixel(const Pixels& picture, std::uint32_t x, std::uint32_t y) {
  const std::byte* p = &picture.rgba[4 * (std::size_t{y} * picture.width + x)];
  return {std::to_integer<int>(p[0]), std::to_integer<int>(p[1]), std::to_integer<int>(p[2])};
}

void expect_near(Rgb actual, Rgb expected, int tolerance, std::string_view where) {
  EXPECT_NEAR(actual.r, expected.r, tolerance) << where;
  EXPECT_NEAR(actual.g, expected.g, tolerance) << where;
  EXPECT_NEAR(actual.b, expected.b, tolerance) << where;
}

constexpr Rgb paper{0xF5, 0xF1, 0xE8};

scene::CameraView looking(Vec3 eye, Vec3 target, PixelSize size) {
  scene::CameraView camera;
  camera.eye = eye;
  camera.target = target;
  camera.view = glm::lookAt(eye, target, Vec3(0, 1, 0));
  camera.projection = glm::perspective(
      camera.vertical_fov, static_cast<float>(size.width) / static_cast<float>(size.height), 0.5F,
      200.0F);
  return camera;
}

/// Where a world point appears, pixels from the top left.
std::array<std::uint32_t, 2> pixel_of(const scene::CameraView& camera, Vec3 world, PixelSize size) {
  const Vec4 clip = camera.projection * camera.view * Vec4(world, 1);
  return {
      static_cast<std::uint32_t>((clip.x / clip.w * 0.5F + 0.5F) * static_cast<float>(size.width)),
      static_cast<std::uint32_t>((0.5F - clip.y / clip.w * 0.5F) *
                                 static_cast<float>(size.height))};
}

/// A body of one box, half a metre wide, bound to one joint.
SkinnedMesh box_body() {
  SkinnedMesh mesh;
  mesh.inverse_bind.assign(1, Mat4(1));
  const Vec3 half{0.25F, 0.8F, 0.25F};
  for (int axis = 0; axis < 3; ++axis)
    for (const float side : {-1.0F, 1.0F}) {
      Vec3 normal{}, u{}, v{};
      normal[axis] = side;
      u[(axis + 1) % 3] = side;
      v[(axis + 2) % 3] = 1;
      const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
      for (const auto& [a, b] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
        SkinnedVertex vertex;
        vertex.position = (normal + u * static_cast<float>(a) + v * static_cast<float>(b)) * half +
                          Vec3(0, 0.8F, 0);
        vertex.normal = normal;
        vertex.weight = {255, 0, 0, 0};
        vertex.material = Material::Coat;
        mesh.vertices.push_back(vertex);
      }
      for (const std::uint32_t i : {0U, 1U, 2U, 0U, 2U, 3U}) mesh.indices.push_back(first + i);
    }
  mesh.figure_end.push_back(static_cast<std::uint32_t>(mesh.indices.size()));
  return mesh;
}

FloorPlan small_hall() {
  return test::HallMaker().room({0, 0}, {12, 9}).block({3, 5}, {4.6, 6}).column({8.5, 6}, 0.3).plan;
}

scene::DrawList view_of_hall(PixelSize size) {
  scene::DrawList list;
  list.camera = looking(to_world({6, -9}, 13), to_world({6, 4.2}, 0), size);
  list.focus = {6, 4};
  list.focus_radius = 100;
  return list;
}

/// The interface alone, on paper.
scene::DrawList paper_only() {
  scene::DrawList list;
  list.floor = 7;  // where no building is
  return list;
}

void add_guide(scene::DrawList& list, Vec2 at, std::uint32_t look = 0) {
  scene::AvatarDraw avatar;
  avatar.look = look;
  avatar.first_matrix = static_cast<std::uint32_t>(list.palette.size());
  avatar.centre = to_world(at, 0.9);
  avatar.feet[0] = avatar.feet[1] = to_world(at);
  list.avatars.push_back(avatar);
  list.palette.push_back(glm::translate(Mat4(1), to_world(at)));
}

void add_way(scene::DrawList& list, RouteKind kind, std::initializer_list<Vec2> points,
             float length) {
  scene::RibbonDraw ribbon;
  ribbon.kind = kind;
  ribbon.first = static_cast<std::uint32_t>(list.ribbon_point.size());
  ribbon.count = static_cast<std::uint32_t>(points.size());
  ribbon.length = length;
  ribbon.revision = 1;
  list.ribbons.push_back(ribbon);
  list.ribbon_point.insert(list.ribbon_point.end(), points);
}

int most_difference(const Pixels& a, const Pixels& b) {
  int most = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i)
    most =
        std::max(most, std::abs(std::to_integer<int>(a.rgba[i]) - std::to_integer<int>(b.rgba[i])));
  return most;
}

class Rendering : public ::testing::Test {
 protected:
  void SetUp() override { open(small); }

  void open(PixelSize size, const RendererOptions& options = {}) {
    holdings_.reset();
    renderer_.reset();
    display_.reset();
    auto display = headless::open_headless(size);
    if (!display) GTEST_SKIP() << display.error().what;
    display_ = std::move(*display);
    auto renderer = make_renderer(options);
    ASSERT_TRUE(renderer.has_value()) << renderer.error().what;
    renderer_.emplace(std::move(*renderer));
    Exhibit vase;
    vase.placement = {{3.8, 5.5}, -1.5708};
    vase.place = ExhibitPlace::InCase;
    const float square = 1;
    Pixels red{1, 1, {std::byte{200}, std::byte{30}, std::byte{30}, std::byte{255}}};
    const auto image = scene::TextureId{1};
    holdings_.emplace();
    holdings_->add_scenery_image(image, {&red, 1});
    const Scenery hall = scenery::make_scenery(small_hall(), {&vase, 1}, {&square, 1}, {});
    while (holdings_->add_scenery(0, hall, {&image, 1})) {
    }
    const SkinnedMesh body = box_body();
    holdings_->set_body(body, scene::levels_of(body));
  }

  Pixels drawn(const scene::DrawList& list) {
    renderer_->draw(list, *holdings_, display_->target());
    Pixels picture;
    display_->read_back(picture);
    return picture;
  }

  std::unique_ptr<headless::HeadlessDisplay> display_;
  // After the display: they go first.
  std::optional<Renderer> renderer_;
  std::optional<Holdings> holdings_;
};

/// A cube of that colour, all of its faces from eight corners.
ObjectMesh cube(std::array<std::uint8_t, 3> colour) {
  ObjectMesh mesh;
  for (unsigned i = 0; i < 8; ++i) {
    ObjectVertex& v = mesh.vertices.emplace_back();
    for (unsigned axis = 0; axis < 3; ++axis) v.position[axis] = (i >> axis & 1U) != 0 ? 65535 : 0;
    v.normal = {0, 127};
    v.colour = colour;
  }
  mesh.triangles = {0, 1, 3, 0, 3, 2, 4, 6, 7, 4, 7, 5, 0, 4, 5, 0, 5, 1,
                    2, 3, 7, 2, 7, 6, 0, 2, 6, 0, 6, 4, 1, 5, 7, 1, 7, 3};
  return mesh;
}

TEST_F(Rendering, DrawsAnObjectOnItsFootAndTurnsItsFront) {
  holdings_->add_object(0, {2, 1, 0.1F}, cube({30, 60, 200}));
  scene::DrawList list = view_of_hall(small);
  list.objects.push_back({.object = 0, .foot = to_world({6, 3}, 0.5)});
  list.objects.push_back({.object = 7});  // which is nowhere
  const auto is_blue = [&](const Pixels& picture, Vec2 at) {
    const auto [x, y] = pixel_of(list.camera, to_world(at, 1.0), small);
    const Rgb it = pixel(picture, x, y);
    return it.b > it.r + 40;
  };
  list.objects[0].heading = 1.5708F;  // it looks north, so it is broad from west to east
  const Pixels north = drawn(list);
  list.objects[0].heading = 0;
  const Pixels east = drawn(list);

  EXPECT_TRUE(is_blue(north, {5.2, 3}));
  EXPECT_TRUE(is_blue(north, {6.8, 3}));
  EXPECT_FALSE(is_blue(north, {6, 3.8}));
  EXPECT_FALSE(is_blue(east, {5.2, 3}));
  EXPECT_TRUE(is_blue(east, {6, 2.4}));
}

TEST_F(Rendering, DrawsAnObjectFromNearbyOnceItsDetailIsThere) {
  holdings_->add_object(0, {2, 2, 2}, cube({200, 40, 30}));
  scene::DrawList list = view_of_hall(small);
  list.objects.push_back({.object = 0, .foot = to_world({6, 3})});
  list.near_object = 0;
  const auto [x, y] = pixel_of(list.camera, to_world({6, 3}, 1.9), small);
  const auto is_red = [&] {
    const Rgb it = pixel(drawn(list), x, y);
    return it.r > it.g + 40;
  };
  ObjectDetail detail;
  detail.mesh = cube({255, 255, 255});
  detail.parts = {{.first_index = 0, .index_count = 36, .picture = 0, .wrap = {}}};
  const Pixels green{1, 1, {std::byte{30}, std::byte{200}, std::byte{30}, std::byte{255}}};

  EXPECT_TRUE(is_red());
  holdings_->begin_object_detail(detail);
  holdings_->add_object_picture(0, {&green, 1});
  EXPECT_TRUE(is_red()) << "it is not whole yet";
  holdings_->show_object_detail(0);
  EXPECT_FALSE(is_red());
  list.near_object.reset();
  EXPECT_TRUE(is_red());
  list.near_object = 0;
  holdings_->drop_object_detail();
  EXPECT_TRUE(is_red());
}

TEST_F(Rendering, ShowsPaperWhereThereIsNothing) {
  const scene::DrawList list = paper_only();

  const Pixels picture = drawn(list);

  for (const auto& [x, y] : {std::pair{0U, 0U}, {160U, 90U}, {319U, 179U}})
    expect_near(pixel(picture, x, y), paper, 1, "empty");
}

TEST_F(Rendering, KeepsTheTableAsPaperFarFromTheBuilding) {
  const Pixels picture = drawn(view_of_hall(small));

  expect_near(pixel(picture, 2, 2), paper, 1, "beyond the table's end");
  expect_near(pixel(picture, 2, 177), paper, 3, "the table's edge");
}

TEST_F(Rendering, DrawsTheFloorDarkerInTheColumnsShadow) {
  const scene::DrawList list = view_of_hall(small);
  const auto [lit_x, lit_y] = pixel_of(list.camera, to_world({6, 3}), small);
  const auto [shade_x, shade_y] = pixel_of(list.camera, to_world({9.3, 5.55}), small);

  const Pixels picture = drawn(list);

  EXPECT_GT(pixel(picture, lit_x, lit_y).g, pixel(picture, shade_x, shade_y).g + 30);
}

TEST_F(Rendering, DrawsTheWayInItsColourAndTheGuideBeforeIt) {
  scene::DrawList list = view_of_hall(small);
  add_way(list, RouteKind::Shortest, {{2, 2}, {10, 2}}, 8);
  add_guide(list, {6, 2});
  const auto [way_x, way_y] = pixel_of(list.camera, to_world({9, 2}), small);
  const auto [body_x, body_y] = pixel_of(list.camera, to_world({6, 1.75}, 0.9), small);

  const Pixels picture = drawn(list);

  const Rgb way = pixel(picture, way_x, way_y);
  EXPECT_GT(way.r, way.g + 80);
  const Rgb coat = pixel(picture, body_x, body_y);
  EXPECT_GT(coat.g, coat.r + 15) << "the coat is teal";
}

TEST_F(Rendering, TellsTheThreeKindsOfWaysApart) {
  scene::DrawList list = view_of_hall(small);
  add_way(list, RouteKind::Shortest, {{2, 1.5}, {10, 1.5}}, 8);
  add_way(list, RouteKind::Skeleton, {{2, 2.5}, {10, 2.5}}, 8);
  add_way(list, RouteKind::Offset, {{2, 3.5}, {10, 3.5}}, 8);
  const Pixels picture = drawn(list);

  std::array<int, 3> covered{};
  for (int kind = 0; kind < 3; ++kind)
    for (double x = 3; x < 9; x += 0.05) {
      const auto [px, py] = pixel_of(list.camera, to_world({x, 1.5 + kind}), small);
      const Rgb c = pixel(picture, px, py);
      const bool has_tone = kind == 0   ? c.r > c.g + 80
                            : kind == 1 ? c.g > c.r + 20
                                        : c.r > c.b + 110;
      covered[static_cast<std::size_t>(kind)] += has_tone ? 1 : 0;
    }

  EXPECT_GT(covered[0], 115) << "solid";
  EXPECT_GT(covered[1], 60) << "long dashes";
  EXPECT_LT(covered[1], 115) << "long dashes have gaps";
  EXPECT_GT(covered[2], 30) << "dots";
}

TEST_F(Rendering, LaysLightIntoADoorwayUnderTheWayThroughIt) {
  scene::DrawList list = view_of_hall(small);
  add_way(list, RouteKind::Shortest, {{2, 2}, {10, 2}}, 8);
  const auto at = [&](const Pixels& picture, Vec2 place) {
    const auto [x, y] = pixel_of(list.camera, to_world(place), small);
    return pixel(picture, x, y);
  };
  const Pixels dark = drawn(list);
  list.markers.push_back({.kind = scene::MarkerDraw::Kind::Doorway,
                          .position = to_world({6, 2}),
                          .radius = 0.9F});  // walked through to the east

  const Pixels lit = drawn(list);

  const auto yellower = [&](Vec2 place) {
    const Rgb before = at(dark, place), now = at(lit, place);
    return before.b - now.b - std::max(before.r - now.r, before.g - now.g);
  };
  EXPECT_GT(yellower({6, 2.5}), 20) << "beside the way";
  EXPECT_LT(std::abs(yellower({6, 3.1})), 3) << "beyond the jamb";
  EXPECT_LT(std::abs(yellower({7.1, 2.5})), 3) << "before the door";
  EXPECT_LT(std::abs(yellower({6, 2})), 3) << "the way lies on the light";
}

TEST_F(Rendering, ThrowsTheGuidesShadowAwayFromTheSun) {
  scene::DrawList list = view_of_hall(small);
  const Pixels without = drawn(list);
  add_guide(list, {6, 2});
  const Pixels with = drawn(list);
  const auto darkening = [&](Vec2 at) {
    const auto [x, y] = pixel_of(list.camera, to_world(at), small);
    return pixel(without, x, y).g - pixel(with, x, y).g;
  };

  EXPECT_GT(darkening({6.9, 1.5}), 25);  // to the lower right
  EXPECT_LT(darkening({4.9, 2.6}), 4);   // towards the sun
}

std::uint32_t look_named(std::string_view name) {
  return static_cast<std::uint32_t>(std::ranges::find(scene::looks, name, &scene::Look::name) -
                                    scene::looks.begin());
}

TEST_F(Rendering, DrawsSeveralGuidesEachInItsOwnLookWithItsOwnTrail) {
  scene::DrawList list = view_of_hall(small);
  add_guide(list, {3, 2}, look_named("navy"));
  add_guide(list, {6, 2}, look_named("saffron"));
  add_guide(list, {9, 2}, look_named("rose"));
  add_way(list, RouteKind::Shortest, {{2, 3.4}, {10, 3.4}}, 8);
  list.ribbons.back().look = look_named("sky");
  const auto seen = [&](const Pixels& picture, Vec2 at, double height) {
    const auto [x, y] = pixel_of(list.camera, to_world(at, height), small);
    return pixel(picture, x, y);
  };

  const Pixels picture = drawn(list);

  const Rgb navy = seen(picture, {2.9, 1.75}, 0.6);
  EXPECT_GT(navy.b, navy.r + 30);
  const Rgb saffron = seen(picture, {5.9, 1.75}, 1.4);
  EXPECT_GT(saffron.r, saffron.b + 80);
  const Rgb rose = seen(picture, {9, 1.75}, 1.5);
  EXPECT_GT(rose.r, rose.g + 25);
  const Rgb trail = seen(picture, {7.5, 3.4}, 0);
  EXPECT_GT(trail.b, trail.r + 40);
}

TEST_F(Rendering, MakesATallerLookTallerAndLeavesItsFeetWhereTheyArePlanted) {
  const PixelSize size{640, 360};
  open(size);
  const scene::CameraView camera = looking(to_world({6, -4}, 2.2), to_world({6, 2}, 0.8), size);
  const auto rows = [&](std::uint32_t look) {
    scene::DrawList list = paper_only();
    list.camera = camera;
    add_guide(list, {6, 2}, look);
    const Pixels picture = drawn(list);
    std::array<int, 2> reach{-1, -1};
    for (std::uint32_t y = 0; y < size.height; ++y)
      if (std::abs(pixel(picture, 320, y).g - paper.g) > 30) {
        if (reach[0] < 0) reach[0] = static_cast<int>(y);
        reach[1] = static_cast<int>(y);
      }
    return reach;
  };

  const auto [top_of_short, sole_of_short] = rows(look_named("rose"));
  const auto [top_of_tall, sole_of_tall] = rows(look_named("vermilion"));

  EXPECT_GE(top_of_short, top_of_tall + 10);
  EXPECT_EQ(sole_of_short, sole_of_tall);
}

TEST_F(Rendering, DrawsEightGuidesAndFortyVisitorsWhereverTheyStand) {
  scene::DrawList list = view_of_hall(small);
  const auto place = [](int i) { return Vec2{1.0 + i % 12 * 0.9, 0.8 + i / 12 * 1.1}; };
  for (int i = 0; i < 48; ++i) add_guide(list, place(i), look_named("navy"));

  const Pixels picture = drawn(list);

  for (int i = 0; i < 48; ++i) {
    const auto [x, y] = pixel_of(list.camera, to_world(place(i), 1.6), small);
    const Rgb coat = pixel(picture, x, y);
    EXPECT_GT(coat.b, coat.r) << i;
  }
}

TEST_F(Rendering, ShowsWhatLooksOutFromBehindAPanelAsIfThereWereNone) {
  scene::DrawList list = view_of_hall(small);
  for (int i = 0; i < 10; ++i) add_guide(list, {1.0 + i * 1.1, 0.8 + 0.7 * i});
  const Pixels open_view = drawn(list);
  scene::Quad panel;
  panel.colour = {0, 0, 0, 1};

  for (const float width : {0.2F, 0.37F, 0.5F, 0.63F, 1.0F}) {
    panel.rect = {0, 0, width, 1};
    list.quads.assign(1, panel);
    const Pixels covered = drawn(list);
    int most = 0;  // the shadows' places in their atlas may be others: rounding
    for (std::uint32_t y = 0; y < covered.height; ++y)
      for (auto x = static_cast<std::uint32_t>(width * static_cast<float>(covered.width)) + 1;
           x < covered.width; ++x) {
        const Rgb now = pixel(covered, x, y), before = pixel(open_view, x, y);
        most = std::max({most, std::abs(now.r - before.r), std::abs(now.g - before.g),
                         std::abs(now.b - before.b)});
      }
    EXPECT_LE(most, 1) << "a panel of " << width;
  }
}

/// What lies behind them takes no fragments: nobody sees where that ends.
TEST_F(Rendering, ShowsTheModelUpToTheRoundCornersOfCards) {
  scene::DrawList list = view_of_hall(small);
  add_guide(list, {4.5, 2});
  for (const float at : {0.1F, 0.3003F, 0.52F, 0.7345F}) {
    scene::Quad card;
    card.rect = {at, at, 0.2F, 0.17F};
    card.corner = 0.03F;
    card.colour = {0.8F, 0.1F, 0.1F, 1};
    list.quads.push_back(card);
  }
  const Pixels opaque = drawn(list);
  for (scene::Quad& card : list.quads) card.colour.a = std::nextafter(1.0F, 0.0F);
  const Pixels all_behind = drawn(list);

  EXPECT_EQ(most_difference(opaque, all_behind), 0);
}

/// A museum's own character may have wings.
TEST_F(Rendering, LeavesNoTraceOfABodyThatReachesFar) {
  SkinnedMesh body = box_body();
  for (SkinnedVertex& vertex : body.vertices) vertex.position.x *= 8;  // two metres to either side
  holdings_->set_body(body, scene::levels_of(body));
  scene::DrawList list = view_of_hall(small);
  add_guide(list, {4.5, 3});
  list.joint.emplace_back(list.avatars[0].centre);
  drawn(list);
  scene::ShownList shown;
  shown.keep(list);

  const Mat4 turn = glm::rotate(Mat4(1), 0.4F, Vec3(0, 1, 0));
  list.palette[0] = list.palette[0] * turn;
  const scene::Change change = shown.change(list, small.height);
  ASSERT_FALSE(change.everything || change.model);
  renderer_->draw(list, *holdings_, display_->target(), change);
  Pixels in_part;
  display_->read_back(in_part);

  EXPECT_EQ(most_difference(in_part, drawn(list)), 0);
}

TEST_F(Rendering, FadesFarGalleriesTowardsPaper) {
  scene::DrawList list = view_of_hall(small);
  const auto [x, y] = pixel_of(list.camera, to_world({11, 2}), small);
  const Rgb near = pixel(drawn(list), x, y);
  list.focus = {-40, 2};
  list.focus_radius = 5;

  const Rgb far = pixel(drawn(list), x, y);

  EXPECT_LT(std::abs(far.b - paper.b), std::abs(near.b - paper.b) / 2);
}

TEST_F(Rendering, LightsTheGoalsGallery) {
  scene::DrawList list = view_of_hall(small);
  const auto [x, y] = pixel_of(list.camera, to_world({6, 3}), small);
  const Rgb before = pixel(drawn(list), x, y);
  list.goal = {6, 3};
  list.goal_radius = 4;

  EXPECT_GT(pixel(drawn(list), x, y).g, before.g + 3);
}

TEST_F(Rendering, SetsTextTexelForPixelAndBlendsItInLinearLight) {
  const std::array<std::uint8_t, 6> coverage{0, 128, 255, 255, 128, 0};
  scene::DrawList list = paper_only();
  scene::Quad text;
  text.fill = scene::QuadFill::Text;
  text.texture = scene::TextureId{2};
  holdings_->add_text(text.texture, 3, 2, coverage);
  text.rect = {100.3F / 320, 49.7F / 180, 0.5F, 0.5F};  // only its place counts
  text.colour = {0, 0, 0, 1};
  list.quads.push_back(text);

  const Pixels picture = drawn(list);

  // Half of paper's light: the sRGB of 0.5 * linear.
  const auto halved = [](int channel) {
    const float light = scene::linear_light(static_cast<float>(channel) / 255) * 127 / 255;
    return static_cast<int>(std::lround(255 * (1.055 * std::pow(light, 1 / 2.4) - 0.055)));
  };
  const Rgb half{halved(paper.r), halved(paper.g), halved(paper.b)};
  expect_near(pixel(picture, 99, 50), paper, 1, "before");
  expect_near(pixel(picture, 100, 50), paper, 1, "uncovered");
  expect_near(pixel(picture, 101, 50), half, 1, "half covered");
  expect_near(pixel(picture, 102, 50), {0, 0, 0}, 1, "covered");
  expect_near(pixel(picture, 100, 51), {0, 0, 0}, 1, "second row");
  expect_near(pixel(picture, 102, 51), paper, 1, "second row, uncovered");
  expect_near(pixel(picture, 103, 50), paper, 1, "after");
}

TEST_F(Rendering, DrawsQuadsInTheirOrderWithRoundCorners) {
  scene::DrawList list = paper_only();
  scene::Quad low;
  low.rect = {0.25F, 0.25F, 0.5F, 0.5F};
  low.colour = scene::srgb(0x1D7874);
  low.corner = 20.0F / 180;
  scene::Quad high = low;
  high.rect = {0.45F, 0.45F, 0.1F, 0.1F};
  high.colour = scene::srgb(0xD2452D);
  high.corner = 0;
  list.quads = {low, high};

  const Pixels picture = drawn(list);

  expect_near(pixel(picture, 81, 46), paper, 1, "the corner is cut");
  expect_near(pixel(picture, 100, 60), {0x1D, 0x78, 0x74}, 1, "inside");
  expect_near(pixel(picture, 80, 90), {0x1D, 0x78, 0x74}, 1, "edge, inside");
  expect_near(pixel(picture, 79, 90), paper, 1, "edge, outside");
  expect_near(pixel(picture, 160, 90), {0xD2, 0x45, 0x2D}, 1, "on top");
}

TEST_F(Rendering, DrawsARingWithAHole) {
  scene::DrawList list = paper_only();
  scene::Quad ring;
  ring.fill = scene::QuadFill::Ring;
  ring.rect = {110.0F / 320, 40.0F / 180, 100.0F / 320, 100.0F / 180};
  ring.softness = 6.0F / 180;
  ring.colour = {0, 0, 0, 1};
  list.quads.push_back(ring);

  const Pixels picture = drawn(list);

  expect_near(pixel(picture, 160, 90), paper, 1, "middle");
  expect_near(pixel(picture, 112, 90), {0, 0, 0}, 2, "on the ring");
  expect_near(pixel(picture, 120, 90), paper, 1, "within the ring");
}

TEST_F(Rendering, LeavesOutWhatWasNeverUploaded) {
  scene::DrawList list = view_of_hall(small);
  scene::Quad text;
  text.fill = scene::QuadFill::Text;
  text.rect = {0, 0, 1, 1};
  text.texture = scene::TextureId{999};
  list.quads.push_back(text);
  list.avatars.emplace_back();  // its matrices are missing
  list.avatars.back().first_matrix = 12;
  scene::RibbonDraw ribbon;
  ribbon.first = 5;
  ribbon.count = 1000;
  list.ribbons.push_back(ribbon);

  const Pixels picture = drawn(list);

  expect_near(pixel(picture, 2, 2), paper, 1, "the text covers nothing");
}

TEST_F(Rendering, DrawsNothingOfATextureThatIsReleasedOrWasNeverKept) {
  const std::array<std::uint8_t, 1> coverage{255};
  scene::DrawList list = paper_only();
  scene::Quad text;
  text.rect = {2.0F / 320, 2.0F / 180, 0.5F, 0.5F};  // only its place counts
  text.fill = scene::QuadFill::Text;
  text.colour = {0, 0, 0, 1};
  const auto drawn_with = [&](scene::TextureId id) {
    text.texture = id;
    list.quads = {text};
    return pixel(drawn(list), 2, 2).r;
  };
  const int bare = drawn_with(scene::TextureId::None);
  holdings_->add_text(scene::TextureId{7}, 1, 1, coverage);

  EXPECT_NE(drawn_with(scene::TextureId{7}), bare);
  EXPECT_EQ(drawn_with(scene::TextureId{8}), bare);
  EXPECT_EQ(drawn_with(scene::TextureId{1'000'000}), bare);
  holdings_->release(scene::TextureId{7});
  holdings_->release(scene::TextureId{7});
  EXPECT_EQ(drawn_with(scene::TextureId{7}), bare);
}

TEST_F(Rendering, DrawsTheOldHoldingsWhileNewOnesAreMade) {
  const std::array<std::uint8_t, 1> inked{255};
  const scene::TextureId id{7};
  scene::DrawList list = view_of_hall(small);
  add_guide(list, {6, 2});
  scene::Quad text;
  text.rect = {2.0F / 320, 2.0F / 180, 0.5F, 0.5F};  // only its place counts
  text.fill = scene::QuadFill::Text;
  text.texture = id;
  list.quads.push_back(text);
  const Pixels before = drawn(list);

  Holdings next;
  next.add_text(id, 1, 1, inked);
  next.set_body({}, {});
  next.add_scenery(0, {}, {});

  EXPECT_EQ(drawn(list).rgba, before.rgba);
  holdings_ = std::move(next);
  const Pixels after = drawn(list);
  EXPECT_NE(pixel(after, 2, 2).r, pixel(before, 2, 2).r);
  const auto [x, y] = pixel_of(list.camera, to_world({6, 2}, 1), small);
  expect_near(pixel(after, x, y), paper, 1, "where hall and guide were");
}

TEST_F(Rendering, CarriesALargeBuildingAMegabyteAtATimeAndDrawsItWhenItIsThere) {
  const scene::DrawList list = view_of_hall(small);
  const Pixels with_hall = drawn(list);
  Scenery large = scenery::make_scenery(small_hall(), {}, {}, {});
  const std::size_t bytes = large.vertices.size() * sizeof(SceneryVertex) +
                            large.indices.size() * sizeof(std::uint32_t) + large.lightmap.size();
  large.vertices.resize(large.vertices.size() + (std::size_t{3} << 20U) / sizeof(SceneryVertex));

  Holdings next;
  int steps = 1;
  while (next.add_scenery(0, large, {})) {
    ++steps;
    EXPECT_EQ(drawn(list).rgba, with_hall.rgba) << "the one that is shown";
  }

  EXPECT_GE(steps, 4);
  EXPECT_LE(steps, static_cast<int>((bytes >> 20U) + 3 + 3)) << "three kinds of bytes";
  holdings_ = std::move(next);
  EXPECT_NE(drawn(list).rgba, with_hall.rgba) << "no vase";
  Scenery hall = scenery::make_scenery(small_hall(), {}, {}, {});
  const Pixels large_hall = drawn(list);
  holdings_ = Holdings();
  while (holdings_->add_scenery(0, hall, {})) {
  }
  EXPECT_EQ(drawn(list).rgba, large_hall.rgba);
}

TEST_F(Rendering, GivesTheSamePictureInOneStripAndInMany) {
  scene::DrawList list = view_of_hall(small);
  add_way(list, RouteKind::Shortest, {{2, 2}, {10, 2}}, 8);
  add_guide(list, {6, 2});
  open(small, {.buffer_bytes = std::size_t{64} << 20});
  const Pixels whole = drawn(list);
  open(small, {.buffer_bytes = 1});
  const Pixels strips = drawn(list);

  int differing = 0;
  for (std::size_t i = 0; i < whole.rgba.size(); ++i)
    if (std::abs(std::to_integer<int>(whole.rgba[i]) - std::to_integer<int>(strips.rgba[i])) > 1)
      ++differing;
  EXPECT_EQ(differing, 0);
}

/// A panel of 320 x 180 pixels, which keeps what it is given.
class Panel {
 public:
  Panel() {
    glGenRenderbuffers(1, &buffer_);
    glBindRenderbuffer(GL_RENDERBUFFER, buffer_);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 320, 180);
    glGenFramebuffers(1, &framebuffer_);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, buffer_);
  }
  Panel(const Panel&) = delete;
  Panel& operator=(const Panel&) = delete;
  ~Panel() {
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteRenderbuffers(1, &buffer_);
  }
  GLuint framebuffer() const { return framebuffer_; }
  Rgb pixel(int x, int y_down) const {
    std::array<unsigned char, 4> p{};
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glReadPixels(x, 179 - y_down, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, p.data());
    return Rgb{p[0], p[1], p[2]};
  }

 private:
  GLuint buffer_ = 0, framebuffer_ = 0;
};

TEST_F(Rendering, TurnsThePictureForAPanelThatHangsTurned) {
  scene::DrawList list = paper_only();
  scene::Quad corner;  // the visitor's upper left
  corner.rect = {0, 0, 0.2F, 0.2F};
  corner.colour = scene::srgb(0xD2452D);
  list.quads.push_back(corner);
  // A panel of 320 x 180 whose upper edge hangs to the right: the visitor sees 180 x 320.
  const Panel panel;

  renderer_->draw(list, *holdings_,
                  {panel.framebuffer(), {180, 320}, Encoding::Plain, Rotation::Quarter});

  // Seen upright, the panel's lower left corner is the visitor's upper left.
  expect_near(panel.pixel(5, 174), {0xD2, 0x45, 0x2D}, 1, "lower left");
  expect_near(panel.pixel(5, 5), paper, 1, "upper left");
  expect_near(panel.pixel(314, 5), paper, 1, "upper right");
  expect_near(panel.pixel(314, 174), paper, 1, "lower right");
}

TEST_F(Rendering, ShiftsThePictureAndDrawsItsEdgeOutToThePanels) {
  scene::DrawList list = paper_only();
  scene::Quad corner;  // to pixel 160 and 90
  corner.rect = {0, 0, 0.5F, 0.5F};
  corner.colour = scene::srgb(0xD2452D);
  list.quads.push_back(corner);
  const Rgb red{0xD2, 0x45, 0x2D};
  const Panel panel;

  renderer_->draw(
      list, *holdings_,
      {.framebuffer = panel.framebuffer(), .size = {320, 180}, .shift_x = 4, .shift_y = 2});

  expect_near(panel.pixel(163, 50), red, 1, "four to the right");
  expect_near(panel.pixel(164, 50), paper, 1, "and no more");
  expect_near(panel.pixel(50, 91), red, 1, "two down");
  expect_near(panel.pixel(50, 92), paper, 1, "and no more");
  expect_near(panel.pixel(0, 0), red, 1, "the edge");
  expect_near(panel.pixel(319, 0), paper, 1, "the other edge");
}

TEST_F(Rendering, AllocatesNothingInAFrame) {
  scene::DrawList list = view_of_hall(small);
  add_way(list, RouteKind::Skeleton, {{2, 2}, {10, 2}}, 8);
  for (int i = 0; i < 48; ++i)
    add_guide(list, {1.0 + i % 12 * 0.9, 0.8 + i / 12 * 1.1}, static_cast<std::uint32_t>(i));
  list.markers.emplace_back();
  scene::Quad panel;
  panel.rect = {0, 0, 0.3F, 1};
  list.quads.push_back(panel);
  renderer_->warm_up(display_->target());
  drawn(list);
  const RenderTarget target = display_->target();

  const long before = test::allocations_of_this_thread();
  for (int frame = 0; frame < 30; ++frame) {
    list.ribbons[0].flow += 0.01F;
    list.ribbons[0].revision = static_cast<std::uint32_t>(frame);
    renderer_->draw(list, *holdings_, target);
    display_->present();
  }

  EXPECT_EQ(test::allocations_of_this_thread() - before, 0);
}

/// The picture that people have looked at; DOCENT_UPDATE_GOLDEN=1 writes it anew. Drivers round
/// differently: a few pixels on edges may differ, the picture may not.
TEST_F(Rendering, ShowsTheSmallHallAsItWasSeenAndApproved) {
  const std::string file = test::source_dir() / "tests/platform/gles/golden/small-hall.png";
  scene::DrawList list = view_of_hall(small);
  add_way(list, RouteKind::Shortest, {{2, 2}, {7, 2}, {7, 6.5}}, 9.5);
  add_guide(list, {4.5, 2});
  scene::MarkerDraw goal;
  goal.position = to_world({7, 6.5});
  list.markers.push_back(goal);
  const Pixels picture = drawn(list);
  if (std::getenv("DOCENT_UPDATE_GOLDEN") != nullptr) {
    ASSERT_TRUE(image::write_png(file, picture).has_value());
  }

  std::ifstream in(file, std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(in), {}};
  const auto golden = image::decode_image(std::as_bytes(std::span(bytes)));
  ASSERT_TRUE(golden.has_value()) << golden.error().what;
  ASSERT_EQ(golden->rgba.size(), picture.rgba.size());
  double sum = 0;
  int far_off = 0;
  for (std::size_t i = 0; i < picture.rgba.size(); ++i) {
    const int difference =
        std::abs(std::to_integer<int>(picture.rgba[i]) - std::to_integer<int>(golden->rgba[i]));
    sum += difference;
    far_off += difference > 24 ? 1 : 0;
  }
  EXPECT_LT(sum / static_cast<double>(picture.rgba.size()), 1.0);
  EXPECT_LT(far_off, static_cast<int>(picture.rgba.size() / 200));
}

TEST(HeadlessDisplay, ThatIsTooLargeTellsWhatIsPossible) {
  const auto display = headless::open_headless({1U << 20, 100});

  ASSERT_FALSE(display.has_value());
  EXPECT_EQ(display.error().code, Errc::Environment);
  EXPECT_THAT(display.error().what, ::testing::AnyOf(HasSubstr("1048576 x 100"), HasSubstr("EGL")));
}

TEST(HeadlessDisplay, WithoutPixelsIsRefused) {
  EXPECT_FALSE(headless::open_headless({0, 100}).has_value());
}

}  // namespace
}  // namespace docent::gles::renderer_test
