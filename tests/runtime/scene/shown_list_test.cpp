#include "runtime/scene/shown_list.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "runtime/scene/camera.h"

namespace docent::scene::shown_list_test {
namespace {

constexpr float high = 1080;

/// A body of two joints under a camera that sees some 40 metres, one of whose pixels is 4 cm.
DrawList a_hall() {
  DrawList list;
  list.camera = view_of({.target = {0, 0, 0}, .distance = 80}, 16.0F / 9);
  list.palette = {Mat4(1), Mat4(1)};
  list.joint = {{0, 1, 0}, {0, 1.5F, 0}};
  list.avatars.push_back({.centre = {0, 1, 0}});
  list.quads.emplace_back();
  list.ribbon_point = {{0, 0}, {1, 0}};
  return list;
}

TEST(ShownList, KnowsNothingAtFirstAndThenWhatWasKept) {
  ShownList shown;
  const DrawList list = a_hall();

  EXPECT_TRUE(shown.differs(list, high));
  shown.keep(list);
  EXPECT_FALSE(shown.differs(list, high));
  shown.forget();
  EXPECT_TRUE(shown.differs(list, high));
}

TEST(ShownList, SeesEverythingButABodyExactly) {
  ShownList shown;
  shown.keep(a_hall());
  const auto differs_after = [&](auto change) {
    DrawList list = a_hall();
    change(list);
    return shown.differs(list, high);
  };

  EXPECT_TRUE(differs_after([](DrawList& l) { l.quads[0].colour.a = 0.99F; }));
  EXPECT_TRUE(differs_after([](DrawList& l) { l.quads[0].rect.x = 1e-4F; }));
  EXPECT_TRUE(differs_after([](DrawList& l) { l.quads.emplace_back(); }));
  EXPECT_TRUE(differs_after([](DrawList& l) { l.camera.view[3].x += 1e-3F; }));
  EXPECT_TRUE(differs_after([](DrawList& l) { l.markers.emplace_back(); }));
  EXPECT_TRUE(differs_after([](DrawList& l) { l.ribbons.emplace_back(); }));
  EXPECT_TRUE(differs_after([](DrawList& l) { l.ribbon_point[1].x = 2; }));
  EXPECT_TRUE(differs_after([](DrawList& l) { l.highlighted_exhibit = 3; }));
  EXPECT_TRUE(differs_after([](DrawList& l) { l.goal_radius = 6; }));
  EXPECT_TRUE(differs_after([](DrawList& l) { l.floor = 1; }));
  EXPECT_TRUE(differs_after([](DrawList& l) { l.walls.level = {1}; }));
  EXPECT_TRUE(differs_after([](DrawList& l) { l.avatars[0].look = 1; }));
  EXPECT_TRUE(differs_after([](DrawList& l) { l.avatars.clear(); }));
}

TEST(ShownList, SeesABodyOnceItHasMovedByAnEighthOfAPixel) {
  ShownList shown;
  const DrawList before = a_hall();
  shown.keep(before);
  const auto differs_at = [&](float metres) {
    DrawList list = before;
    list.joint[1].x += metres;
    list.palette[1] = glm::translate(Mat4(1), Vec3(metres, 0, 0));
    return shown.differs(list, high);
  };

  EXPECT_FALSE(differs_at(0.003F));
  EXPECT_TRUE(differs_at(0.008F));
}

TEST(ShownList, SeesAHeadThatTurns) {
  ShownList shown;
  shown.keep(a_hall());
  DrawList list = a_hall();
  list.palette[1] = glm::rotate(Mat4(1), 0.05F, Vec3(0, 1, 0));

  EXPECT_TRUE(shown.differs(list, high));
}

TEST(ShownList, AddsUpWhatMovesTooLittleToBeSeen) {
  ShownList shown;
  DrawList list = a_hall();
  shown.keep(list);
  int drawn = 0;
  for (int frame = 0; frame < 60; ++frame) {
    list.joint[0].x += 0.001F;
    if (!shown.differs(list, high)) continue;
    shown.keep(list);
    ++drawn;
  }

  EXPECT_GT(drawn, 5);
  EXPECT_LT(drawn, 20);
}

void expect_near(const Rect& rect, const Rect& expected) {
  constexpr float near = 1e-3F;
  EXPECT_NEAR(rect.x, expected.x, near);
  EXPECT_NEAR(rect.y, expected.y, near);
  EXPECT_NEAR(rect.width, expected.width, near);
  EXPECT_NEAR(rect.height, expected.height, near);
}

TEST(ShownList, TellsWhatOfThePictureDiffers) {
  ShownList shown;
  DrawList before = a_hall();
  before.quads.emplace_back().rect = {0.25F, 0.5F, 0.125F, 0.0625F};
  before.ribbons.emplace_back();
  shown.keep(before);

  DrawList list = before;
  list.quads[1].colour.a = 0.5F;
  Change change = shown.change(list, high);
  EXPECT_FALSE(change.everything);
  expect_near(change.interface, {0.25F, 0.5F, 0.125F, 0.0625F});
  EXPECT_TRUE(change.bodies.none());

  list = before;
  list.quads[1].rect.x = 0.5F;
  expect_near(shown.change(list, high).interface, {0.25F, 0.5F, 0.375F, 0.0625F});  // both places

  list = before;
  list.joint[0].x += 1;
  change = shown.change(list, high);
  EXPECT_FALSE(change.everything);
  EXPECT_TRUE(change.bodies.test(0));
  EXPECT_EQ(change.interface.width, 0);

  list = before;
  list.ribbons[0].walked = 2;
  change = shown.change(list, high);
  EXPECT_FALSE(change.everything);
  EXPECT_TRUE(change.ways);
  list.ribbons[0].revision = 7;
  EXPECT_TRUE(shown.change(list, high).model) << "it lies elsewhere";

  list = before;
  list.camera.eye.x += 1;
  list.quads[1].colour.a = 0.5F;
  change = shown.change(list, high);
  EXPECT_FALSE(change.everything) << "the rest of the interface is there";
  EXPECT_TRUE(change.model);
  expect_near(change.interface, {0.25F, 0.5F, 0.125F, 0.0625F});
  shown.keep(list, change);
  EXPECT_FALSE(shown.differs(list, high));
}

TEST(ShownList, SeesWhatShowsATextureThatHasChanged) {
  ShownList shown;
  DrawList list = a_hall();
  list.quads.push_back(list.quads[0]);
  list.quads[1].rect = {0.5F, 0.5F, 0.25F, 0.25F};
  list.quads[1].texture = TextureId{7};
  shown.keep(list);

  shown.forget(TextureId::None);
  EXPECT_FALSE(shown.differs(list, high));
  shown.forget(TextureId{7});
  const Change change = shown.change(list, high);
  EXPECT_FALSE(change.everything);
  expect_near(change.interface, list.quads[1].rect);
  shown.keep(list, change);
  EXPECT_FALSE(shown.differs(list, high));
}

TEST(ShownList, RemembersABodyThatWasNotDrawnWhereItWasDrawn) {
  ShownList shown;
  DrawList list = a_hall();
  list.palette.push_back(Mat4(1));
  list.joint.push_back({5, 1, 0});
  list.avatars.push_back({.first_matrix = 2, .centre = {5, 1, 0}});
  shown.keep(list);
  bool is_seen = false;
  for (int frame = 0; frame < 8 && !is_seen; ++frame) {
    list.joint[0].x += 1;
    list.joint[2].x += 0.001F;  // an eighth of a pixel is 5 mm
    const Change change = shown.change(list, high);
    EXPECT_TRUE(change.bodies.test(0));
    is_seen = change.bodies.test(1);
    shown.keep(list, change);
  }

  EXPECT_TRUE(is_seen);
}

}  // namespace
}  // namespace docent::scene::shown_list_test
