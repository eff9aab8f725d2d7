#include "content/object/agree.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "content/import/object/read_object.h"

namespace docent::object::agree_test {
namespace {

/// Two by one by four metres, each face outwards.
Shape box() {
  const std::string text =
      "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nv 0 0 4\nv 2 0 4\nv 2 1 4\nv 0 1 4\n"
      "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
  std::vector<std::string> notes;
  return shape_of(import::object::parse_object(text, "box.obj", {}).model, "box.obj", notes);
}

void turn(Shape& shape, std::size_t triangle) {
  std::swap(shape.indices[3 * triangle + 1], shape.indices[3 * triangle + 2]);
}

float room_in(const Shape& shape) {
  float room = 0;
  for (std::size_t k = 0; k + 2 < shape.indices.size(); k += 3) {
    const auto corner = [&](std::size_t c) {
      return shape.vertices[shape.indices[k + c]].position;
    };
    room += glm::dot(corner(0), glm::cross(corner(1), corner(2))) / 6;
  }
  return room;
}

TEST(TrianglesOfASurface, FaceOutwardsHoweverManyWereTurned) {
  for (std::size_t turned = 1; turned < 12; ++turned) {
    Shape shape = box();
    for (std::size_t triangle = 0; triangle < turned; ++triangle) turn(shape, triangle);

    EXPECT_EQ(agree(shape), turned);

    EXPECT_NEAR(room_in(shape), 8, 1e-4);
  }
}

TEST(TrianglesOfASurface, ThatAgreeStayAsTheyAreWhicheverWayTheyFace) {
  Shape outwards = box(), inwards = box();
  for (std::size_t triangle = 0; triangle < 12; ++triangle) turn(inwards, triangle);

  EXPECT_EQ(agree(outwards), 0U);
  EXPECT_EQ(agree(inwards), 0U);

  EXPECT_NEAR(room_in(inwards), -8, 1e-4);
}

TEST(TrianglesOfASurface, AreTurnedByItselfWhereThereAreSeveral) {
  Shape two = box();
  const Shape other = box();
  const auto first = static_cast<std::uint32_t>(two.vertices.size());
  for (ShapeVertex vertex : other.vertices) {
    vertex.position.x += 10;
    two.vertices.push_back(vertex);
  }
  for (const std::uint32_t corner : other.indices) two.indices.push_back(first + corner);
  turn(two, 3);
  turn(two, 20);

  EXPECT_EQ(agree(two), 2U);
}

TEST(TrianglesOfASurface, MayShareASideWithAnyNumber) {
  Shape fan;
  fan.vertices.resize(5);
  for (std::uint32_t i = 0; i < 5; ++i)
    fan.vertices[i].position = {static_cast<float>(i % 2), static_cast<float>(i), 1.0F};
  fan.indices = {0, 1, 2, 0, 1, 3, 0, 1, 4, 2, 2, 3, 0, 0, 0};

  EXPECT_EQ(agree(fan), 0U);
  Shape none;
  EXPECT_EQ(agree(none), 0U);
}

}  // namespace
}  // namespace docent::object::agree_test
