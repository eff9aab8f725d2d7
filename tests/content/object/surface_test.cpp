#include "content/object/surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include <glm/geometric.hpp>

namespace docent::object::surface_test {
namespace {

class Places {
 public:
  Vec3 next() { return {number(), number(), number()}; }

 private:
  float number() { return static_cast<float>(engine_() % 2048) / 1024 - 1; }
  std::mt19937 engine_{7};
};

/// Of many places of it, the nearest.
float tried(Vec3 place, const Corners& triangle) {
  constexpr int steps = 200;
  float least = 1e9F;
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; i + j <= steps; ++j) {
      const float b = static_cast<float>(i) / steps, c = static_cast<float>(j) / steps;
      least = std::min(least, glm::distance(place, triangle[0] + b * (triangle[1] - triangle[0]) +
                                                       c * (triangle[2] - triangle[0])));
    }
  return least;
}

TEST(DistanceOfATriangle, IsThatOfItsNearestPlace) {
  Places places;
  for (int i = 0; i < 60; ++i) {
    const Corners triangle{places.next(), places.next(), places.next()};
    const Vec3 place = 1.5F * places.next();
    EXPECT_NEAR(std::sqrt(squared_distance(place, triangle)), tried(place, triangle), 0.01);
  }
}

TEST(DistanceOfATriangle, WithoutAnAreaIsThatOfItsLineOrPlace) {
  Places places;
  for (int i = 0; i < 30; ++i) {
    const Vec3 a = places.next(), b = places.next(), place = 1.5F * places.next();
    for (const Corners& line : {Corners{a, b, b}, Corners{b, a, b}, Corners{a, b, (a + b) / 2.0F}})
      EXPECT_NEAR(std::sqrt(squared_distance(place, line)), tried(place, line), 0.01);
    EXPECT_NEAR(std::sqrt(squared_distance(place, {a, a, a})), glm::distance(place, a), 1e-5);
  }
}

class ASurface : public ::testing::Test {
 protected:
  ASurface() {
    for (int i = 0; i < 500; ++i) {
      const Vec3 near = places_.next();
      triangles_.push_back({near, near + 0.1F * places_.next(), near + 0.1F * places_.next()});
    }
  }

  float least_of_all(Vec3 place) const {
    float least = 1e9F;
    for (const Corners& triangle : triangles_)
      least = std::min(least, squared_distance(place, triangle));
    return least;
  }

  Places places_;
  std::vector<Corners> triangles_;
};

TEST_F(ASurface, IsAsFarAsTheNearestOfItsTriangles) {
  Surface surface(triangles_);
  for (int i = 0; i < 500; ++i) {
    const Vec3 place = 1.2F * places_.next();
    EXPECT_EQ(surface.squared_distance_from(place, 0, 100), least_of_all(place));
  }
}

TEST_F(ASurface, IsNotSearchedForMoreThanIsEnough) {
  Surface surface(triangles_);
  for (int i = 0; i < 500; ++i) {
    const Vec3 place = places_.next();
    const float least = least_of_all(place), most = 0.01F, enough = 0.002F;
    const float told = surface.squared_distance_from(place, enough, most);
    if (least >= most) {
      EXPECT_EQ(told, most);
    } else if (least > enough) {
      EXPECT_EQ(told, least);
    } else {
      EXPECT_LE(told, enough);
    }
  }
}

TEST(ASurfaceOfOneTriangle, ThatIsThereAThousandTimesIsFound) {
  Surface surface(std::vector<Corners>(1000, Corners{Vec3{0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}}));

  EXPECT_EQ(surface.squared_distance_from({0.25F, 0.25F, 2}, 0, 100), 4);
}

}  // namespace
}  // namespace docent::object::surface_test
