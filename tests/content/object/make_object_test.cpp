#include "content/object/make_object.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include <fmt/format.h>

#include "content/content_error.h"
#include "content/object/crease.h"
#include "content/object/pack.h"
#include "runtime/schema/object_blob.h"
#include "tests/content/object/silhouette.h"
#include "tests/support/sanitized.h"

namespace docent::object::make_object_test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A ball of radius 1 as an OBJ file, turned from a profile of `rows` and `columns`.
std::string ball(int rows, int columns, float scale = 1) {
  std::string obj;
  for (int r = 0; r <= rows; ++r)
    for (int c = 0; c < columns; ++c) {
      const float polar = 3.14159265F * static_cast<float>(r) / static_cast<float>(rows);
      const float turn = 6.2831853F * static_cast<float>(c) / static_cast<float>(columns);
      obj += fmt::format("v {} {} {}\n", scale * std::sin(polar) * std::cos(turn),
                         scale * std::cos(polar), scale * std::sin(polar) * std::sin(turn));
    }
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c) {
      const int a = r * columns + c + 1, b = r * columns + (c + 1) % columns + 1;
      obj += fmt::format("f {} {} {} {}\n", a, b, b + columns, a + columns);
    }
  return obj;
}

import::object::ObjectFile read(const std::string& text, const std::string& name = "made.obj") {
  return import::object::parse_object(text, name, {});
}

MadeObject made(const std::string& text, const ObjectWish& wish = {}) {
  return make_object(read(text), "made.obj", wish);
}

ObjectDetail detail_of(const MadeObject& object) {
  ObjectDetail detail;
  EXPECT_TRUE(schema::decode(object.object.detail, detail));
  return detail;
}

constexpr const char* box =
    "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nv 0 0 4\nv 2 0 4\nv 2 1 4\nv 0 1 4\n"
    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

TEST(MakeObject, StandsInMetresOnItsBase) {
  const MadeObject it = made(box);
  const ObjectDetail detail = detail_of(it);

  EXPECT_EQ(it.object.size, (Vec3{2, 1, 4}));
  EXPECT_EQ(detail.mesh.triangles.size(), 36U);
  EXPECT_EQ(detail.mesh.vertices.size(), 24U) << "its edges are sharp";
  EXPECT_THAT(it.warnings, IsEmpty());
}

TEST(MakeObject, IsAsHighAsStaffSay) {
  EXPECT_NEAR(made(box, {.height = 0.25, .up = {}}).object.size.y, 0.25, 1e-6);
  EXPECT_NEAR(made(box, {.height = 0.25, .up = {}}).object.size.z, 1, 1e-5);
}

TEST(MakeObject, IsTurnedUprightWhereStaffSayWhichWayIsUp) {
  EXPECT_EQ(made(box, {.height = {}, .up = import::object::UpAxis::Z}).object.size,
            (Vec3{2, 4, 1}));
}

TEST(MakeObject, OfHundredsOfUnitsIsInMillimetresAndSaysSo) {
  const MadeObject it = made(ball(12, 24, 150));

  EXPECT_NEAR(it.object.size.y, 0.3, 1e-4);
  EXPECT_THAT(it.notes, ::testing::Contains(HasSubstr("millimetres")));
}

TEST(MakeObject, OfManyTrianglesKeepsItsOutlineWithinAPixel) {
  NEEDS_SPEED();
  const import::object::ObjectFile source = read(ball(200, 400));
  const MadeObject it = make_object(source, "made.obj");
  const ObjectDetail detail = detail_of(it);
  std::vector<std::string> notes;
  Shape shape = shape_of(source.model, "made.obj", notes);
  stand_up(source, {}, shape, notes);
  Shape drawn;
  for (const ObjectVertex& v : detail.mesh.vertices) {
    Vec3 share{0};
    for (int axis = 0; axis < 3; ++axis)
      share[axis] = static_cast<float>(v.position[static_cast<std::size_t>(axis)]) / 65535;
    drawn.vertices.emplace_back().position = it.object.size * (share - Vec3{0.5F, 0, 0.5F});
  }
  drawn.indices.assign(detail.mesh.triangles.begin(), detail.mesh.triangles.end());

  EXPECT_GT(it.triangles, 150'000U);
  EXPECT_LE(detail.mesh.triangles.size() / 3, ObjectDetail::most_triangles);
  EXPECT_GT(detail.mesh.triangles.size() / 3, ObjectDetail::most_triangles / 2);
  EXPECT_LE(it.object.distant.triangles.size() / 3, ExhibitObject::most_distant_triangles);
  EXPECT_LE(test::silhouette_error(shape, drawn, 2), 1);
}

TEST(MakeObject, OfLooseTrianglesStaysWithinItsBudgetToo) {
  std::string obj;
  for (int i = 0; i < 60'000; ++i) {
    const float x = static_cast<float>(i % 250) / 100, z = static_cast<float>(i / 250) / 100;
    obj += fmt::format("v {} 0 {}\nv {} 0.01 {}\nv {} 0 {}\nf -3 -2 -1\n", x, z, x, z, x + 0.005F,
                       z + 0.005F);
  }
  const MadeObject it = made(obj);
  const ObjectDetail detail = detail_of(it);

  EXPECT_LE(detail.mesh.triangles.size() / 3, ObjectDetail::most_triangles);
  EXPECT_LE(it.object.detail.size(), ExhibitObject::most_bytes);
  EXPECT_LE(it.object.distant.triangles.size() / 3, ExhibitObject::most_distant_triangles);
}

TEST(MakeObject, OfTheSameTrianglesAThousandTimesHasThemOnce) {
  std::string text = box;
  for (int i = 0; i < 6000; ++i)
    text += "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

  EXPECT_EQ(detail_of(made(text)).mesh.triangles.size() / 3, 12U);
}

TEST(MakeObject, OfManyTrianglesAboutOnePointIsMadeInTime) {
  NEEDS_SPEED();
  constexpr int columns = 60'000;  // to collapse edges about it would take an hour
  std::string text = "v 0 1 0\n";
  for (int c = 0; c < columns; ++c) {
    const float turn = 6.2831853F * static_cast<float>(c) / columns;
    text += fmt::format("v {} 0 {}\n", std::cos(turn), std::sin(turn));
  }
  for (int c = 0; c < columns; ++c)
    text += fmt::format("f 1 {} {}\n", 2 + (c + 1) % columns, 2 + c);

  const std::size_t triangles = detail_of(made(text)).mesh.triangles.size() / 3;

  EXPECT_GT(triangles, 1000U);
  EXPECT_LE(triangles, ObjectDetail::most_triangles);
}

TEST(MakeObject, GivesTheSameBytesTwice) {
  NEEDS_SPEED();
  const std::string text = ball(90, 180);

  EXPECT_EQ(made(text).object.detail, made(text).object.detail);
}

TEST(MakeObject, IsDarkInItsFolds) {
  // Two walls that nearly touch, on a plate.
  const MadeObject it = made(
      "v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nf 4 3 2 1\n"
      "v 0.45 0 0\nv 0.45 1 0\nv 0.45 1 1\nv 0.45 0 1\nf 5 6 7 8\nf 8 7 6 5\n"
      "v 0.55 0 0\nv 0.55 1 0\nv 0.55 1 1\nv 0.55 0 1\nf 9 10 11 12\nf 12 11 10 9\n");
  const ObjectDetail detail = detail_of(it);
  std::map<bool, int> darkest{{false, 255}, {true, 255}};
  for (const ObjectVertex& v : detail.mesh.vertices) {
    const bool is_within = v.position[0] > 20'000 && v.position[0] < 45'000 && v.position[1] == 0;
    darkest[is_within] = std::min<int>(darkest[is_within], v.occlusion);
  }

  EXPECT_LT(darkest[true], darkest[false]);
}

TEST(MakeObject, OfWhichAllIsClearIsRefused) {
  import::object::ObjectFile source = read(box);
  source.model.materials.emplace_back();
  source.model.materials[0].base.w = 0.1F;
  source.model.materials[0].alpha = import::gltf::AlphaMode::Blend;
  source.model.meshes[0].primitives[0].material = 0;

  try {
    make_object(source, "made.obj");
    FAIL() << "was taken";
  } catch (const content::ContentError& error) {
    EXPECT_THAT(error.what(), HasSubstr("clear"));
  }
}

TEST(Octahedral, KeepsDirectionsToADegreeAndAHalf) {
  for (int i = 0; i < 500; ++i) {
    const float y = 1 - (static_cast<float>(i) + 0.5F) / 250, turn = 2.4F * static_cast<float>(i);
    const float r = std::sqrt(1 - y * y);
    const Vec3 unit{r * std::cos(turn), y, r * std::sin(turn)};
    const std::array<std::int8_t, 2> bytes = octahedral(unit);
    const float u = static_cast<float>(bytes[0]) / 127, v = static_cast<float>(bytes[1]) / 127;
    Vec3 back{u, v, 1 - std::abs(u) - std::abs(v)};
    if (back.z < 0) {
      const float x = (1 - std::abs(v)) * (u < 0 ? -1.0F : 1.0F);
      back.y = (1 - std::abs(u)) * (v < 0 ? -1.0F : 1.0F);
      back.x = x;
    }
    const float length = std::sqrt(back.x * back.x + back.y * back.y + back.z * back.z);
    EXPECT_GT((unit.x * back.x + unit.y * back.y + unit.z * back.z) / length, 0.99965F);
  }
}

}  // namespace
}  // namespace docent::object::make_object_test
