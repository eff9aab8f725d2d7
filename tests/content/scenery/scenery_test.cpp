#include "content/scenery/scenery.h"

#include <gmock/gmock.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

#include "content/scenery/furniture.h"
#include "runtime/model/geometry/polygon.h"
#include "tests/support/halls.h"

namespace docent::scenery::scenery_test {
namespace {

using test::HallMaker;

Exhibit exhibit_at(Vec2 position, double heading, ExhibitPlace place) {
  Exhibit exhibit;
  exhibit.placement = {position, heading};
  exhibit.place = place;
  return exhibit;
}

Scenery scenery_of(const FloorPlan& plan, std::span<const Exhibit> exhibits = {},
                   std::span<const PavedArea> paving = {}, double texel = 0.1) {
  const std::vector<float> aspects(exhibits.size(), 1.0F);
  return make_scenery(plan, exhibits, aspects, paving, {.texel = texel});
}

struct Triangle {
  Vec3 a, b, c, normal;
};

std::vector<Triangle> triangles_of(const Scenery& scenery, Surface surface) {
  std::vector<Triangle> out;
  for (const SceneryPart& part : scenery.parts) {
    if (part.surface != surface) continue;
    for (std::uint32_t i = 0; i < part.index_count; i += 3) {
      const auto vertex = [&](std::uint32_t k) {
        return scenery.vertices[scenery.indices[part.first_index + i + k]];
      };
      out.push_back({vertex(0).position, vertex(1).position, vertex(2).position, vertex(0).normal});
    }
  }
  return out;
}

double area_from_above(std::span<const Triangle> triangles) {
  double area = 0;
  for (const Triangle& t : triangles)
    area += cross(to_floor(t.b) - to_floor(t.a), to_floor(t.c) - to_floor(t.a)) / 2;
  return area;
}

std::byte texel(const Scenery& scenery, Vec2 at, std::size_t channel) {
  const Vec2 size(scenery.lightmap_width, scenery.lightmap_height);
  const Vec2 cell =
      (at - scenery.lightmap_min) / (scenery.lightmap_max - scenery.lightmap_min) * size;
  return scenery.lightmap[(static_cast<std::size_t>(cell.y) * scenery.lightmap_width +
                           static_cast<std::size_t>(cell.x)) *
                              Scenery::lightmap_channels +
                          channel];
}

TEST(Scenery, OfAPlanWithoutInteriorIsEmpty) {
  const Scenery scenery = scenery_of({});

  EXPECT_TRUE(scenery.vertices.empty());
  EXPECT_TRUE(scenery.parts.empty());
}

TEST(Scenery, CoversTheWholeFloorAndGoesOnUnderTheCases) {
  const HallMaker hall = HallMaker().room({0, 0}, {10, 6}).block({3, 2}, {4.6, 3});

  EXPECT_NEAR(area_from_above(triangles_of(scenery_of(hall.plan), Surface::Floor)), 60, 1e-3);
}

TEST(Scenery, LeavesTheFloorOutWhereAPartitionStands) {
  const HallMaker hall = HallMaker().room({0, 0}, {10, 6}).block({3, 1}, {3.3, 5});

  EXPECT_NEAR(area_from_above(triangles_of(scenery_of(hall.plan), Surface::Floor)), 60 - 1.2, 1e-3);
}

TEST(Scenery, LaysStoneWhereAnAreaAsksForIt) {
  const HallMaker hall = HallMaker().room({0, 0}, {10, 6});
  const PavedArea half{{{0, 0}, {5, 0}, {5, 6}, {0, 6}}, Paving::Stone};

  const Scenery scenery = scenery_of(hall.plan, {}, {&half, 1});

  constexpr double grown = 0.2;  // half a wall, so that two stone rooms meet in their doorway
  EXPECT_NEAR(area_from_above(triangles_of(scenery, Surface::Stone)), (5 + grown) * 6, 1e-3);
  EXPECT_NEAR(area_from_above(triangles_of(scenery, Surface::Floor)), (5 - grown) * 6, 1e-3);
}

TEST(Scenery, TintsTheFloorOfAGalleryAndNoOther) {
  const HallMaker hall = HallMaker().room({0, 0}, {10, 6});
  const PavedArea half{{{0, 0}, {5, 0}, {5, 6}, {0, 6}}, Paving::Oak, 3};

  const Scenery scenery = scenery_of(hall.plan, {}, {&half, 1});

  int tinted = 0;
  for (const SceneryPart& part : scenery.parts)
    for (std::uint32_t i = 0; part.surface == Surface::Floor && i < part.index_count; ++i) {
      const SceneryVertex& vertex = scenery.vertices[scenery.indices[part.first_index + i]];
      if (to_floor(vertex.position).x < 5) {
        EXPECT_EQ(vertex.sky, 3);
        ++tinted;
      }
      if (to_floor(vertex.position).x > 5.5) {
        EXPECT_EQ(vertex.sky, no_floor_tint);
      }
    }
  EXPECT_GT(tinted, 0);
}

TEST(Scenery, PutsWallsOutsideOfTheWalkableFloorOnly) {
  EXPECT_TRUE(rc::check("no wall stands where one can walk", [] {
    const double width = *rc::gen::inRange(2, 30);
    const double depth = *rc::gen::inRange(2, 30);
    const double notch = *rc::gen::inRange(1, static_cast<int>(width));
    const Vec2 points[] = {{0, 0},
                           {width, 0},
                           {width, depth / 2},
                           {width - notch / 2, depth / 2},
                           {width - notch / 2, depth},
                           {0, depth}};
    const Outline room(std::begin(points), std::end(points));
    const HallMaker hall = HallMaker().ring(points);

    const Scenery scenery = scenery_of(hall.plan, {}, {}, 0.5);
    for (const Surface surface : {Surface::Plaster, Surface::CutFace})
      for (const Triangle& t : triangles_of(scenery, surface)) {
        const Vec2 middle = (to_floor(t.a) + to_floor(t.b) + to_floor(t.c)) / 3.0;
        const Vec2 outward = 1e-4 * to_floor(t.normal);  // a face of the wall lies on its edge
        RC_ASSERT(!contains(room, middle - outward));
      }
  }));
}

TEST(Scenery, HasEveryFaceCounterClockwiseSeenFromItsNormal) {
  const HallMaker hall =
      HallMaker().room({0, 0}, {12, 9}).block({3, 2}, {4.6, 3}).column({8, 5}, 0.3);
  const Exhibit exhibits[] = {exhibit_at({3.8, 2.5}, -1.57, ExhibitPlace::InCase),
                              exhibit_at({0, 5}, 0, ExhibitPlace::OnWall),
                              exhibit_at({6, 7}, 2, ExhibitPlace::OnFloor)};
  const Scenery scenery = scenery_of(hall.plan, exhibits);

  for (int s = 0; s < static_cast<int>(Surface::Count); ++s)
    for (const Triangle& t : triangles_of(scenery, static_cast<Surface>(s))) {
      const Vec3 facing = glm::cross(t.b - t.a, t.c - t.a);
      if (glm::dot(facing, facing) < 1e-12F) continue;
      EXPECT_GT(glm::dot(facing, t.normal), 0) << "surface " << s;
    }
}

TEST(Scenery, ShowsEveryExhibitsPictureAtItsPlace) {
  const HallMaker hall = HallMaker().room({0, 0}, {12, 9}).block({3, 2}, {4.6, 3});
  const Exhibit exhibits[] = {exhibit_at({3.8, 2.5}, -1.57, ExhibitPlace::InCase),
                              exhibit_at({0, 5}, 0, ExhibitPlace::OnWall),
                              exhibit_at({6, 7}, 2, ExhibitPlace::OnFloor)};
  const Scenery scenery = scenery_of(hall.plan, exhibits);

  for (std::int32_t e = 0; e < 3; ++e) {
    const auto part = std::find_if(
        scenery.parts.begin(), scenery.parts.end(),
        [&](const SceneryPart& p) { return p.surface == Surface::Picture && p.exhibit == e; });
    ASSERT_NE(part, scenery.parts.end()) << e;
    const Vec3 corner = scenery.vertices[scenery.indices[part->first_index]].position;
    const Vec2 away = to_floor(corner) - exhibits[e].placement.position;
    EXPECT_LT(std::hypot(away.x, away.y), 1.5) << e;
  }
}

TEST(Scenery, LeavesExhibitsOfOtherFloorsOut) {
  const HallMaker hall = HallMaker().room({0, 0}, {12, 9});
  Exhibit upstairs = exhibit_at({6, 7}, 2, ExhibitPlace::OnFloor);
  upstairs.floor = 1;

  EXPECT_TRUE(triangles_of(scenery_of(hall.plan, {&upstairs, 1}), Surface::Picture).empty());
}

TEST(Scenery, IsDarkerInACornerThanInTheMiddleOfTheRoom) {
  const Scenery scenery = scenery_of(HallMaker().room({0, 0}, {10, 10}).plan);

  EXPECT_LT(texel(scenery, {0.1, 0.1}, 0), texel(scenery, {0.1, 5}, 0));
  EXPECT_LT(texel(scenery, {0.1, 5}, 0), texel(scenery, {5, 5}, 0));
}

TEST(Scenery, ThrowsShadowsToTheLowerRightOfThePicture) {
  const Scenery scenery = scenery_of(HallMaker().room({0, 0}, {10, 10}).column({5, 5}, 0.3).plan);

  EXPECT_LT(texel(scenery, {5.6, 4.65}, 1), std::byte{40});
  EXPECT_GT(texel(scenery, {4.4, 5.35}, 1), std::byte{250});
}

TEST(Scenery, IsTheSameEveryTime) {
  const HallMaker hall =
      HallMaker().room({0, 0}, {12, 9}).block({3, 2}, {4.6, 3}).column({8, 5}, 0.3);

  const Scenery once = scenery_of(hall.plan);
  const Scenery again = scenery_of(hall.plan);

  EXPECT_EQ(once.lightmap, again.lightmap);
  EXPECT_EQ(once.indices, again.indices);
  ASSERT_EQ(once.vertices.size(), again.vertices.size());
  EXPECT_TRUE(std::equal(once.vertices.begin(), once.vertices.end(), again.vertices.begin(),
                         [](const SceneryVertex& a, const SceneryVertex& b) {
                           return a.position == b.position && a.normal == b.normal &&
                                  a.uv == b.uv && a.sky == b.sky && a.sun == b.sun;
                         }));
}

TEST(Scenery, StandsAtTheHeightOfItsFloor) {
  HallMaker hall = HallMaker().room({0, 0}, {5, 5});
  hall.plan.height = 4;

  for (const Triangle& t : triangles_of(scenery_of(hall.plan), Surface::Floor)) EXPECT_EQ(t.a.y, 4);
}

}  // namespace
}  // namespace docent::scenery::scenery_test
