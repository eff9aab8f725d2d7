#include "content/avatar/distance_field.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace docent::avatar::distance_field_test {
namespace {

Vec3 some_point(int reach) {
  const auto coordinate = [&] {
    return 0.01F * static_cast<float>(*rc::gen::inRange(-reach, reach));
  };
  return {coordinate(), coordinate(), coordinate()};
}

RC_GTEST_PROP(TaperedCapsule, IsAsFarAsTheNearestOfItsManyBalls, ()) {
  const Vec3 a = some_point(50);
  const Vec3 b = some_point(50);
  const float radius_a = 0.01F * static_cast<float>(*rc::gen::inRange(1, 20));
  const float radius_b = 0.01F * static_cast<float>(*rc::gen::inRange(1, 20));
  RC_PRE(glm::length(b - a) > std::abs(radius_a - radius_b) + 0.05F);
  const Vec3 p = some_point(100);

  float nearest = 10;
  for (int k = 0; k <= 2000; ++k) {
    const float t = static_cast<float>(k) / 2000;
    nearest = std::min(nearest, sphere(p, glm::mix(a, b, t), glm::mix(radius_a, radius_b, t)));
  }
  RC_ASSERT(std::abs(tapered_capsule(p, a, b, radius_a, radius_b) - nearest) < 0.002F);
}

RC_GTEST_PROP(Join, IsAtMostTheUnionAndFillsNoMoreThanAQuarterOfItsWidth, ()) {
  const float a = some_point(50).x;
  const float b = some_point(50).x;
  constexpr float width = 0.1F;

  const float joined = join(a, b, width);
  RC_ASSERT(joined <= std::min(a, b));
  RC_ASSERT(joined >= std::min(a, b) - 0.25F * width - 1e-6F);
  if (std::abs(a - b) >= width) RC_ASSERT(joined == std::min(a, b));
}

TEST(Ellipsoid, IsZeroOnItsSurface) {
  const Vec3 radius{0.1F, 0.2F, 0.3F};
  const Vec3 centre{1, 2, 3};

  for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{0.6F, 0, 0.8F}})
    EXPECT_NEAR(ellipsoid(centre + axis * radius, centre, radius), 0, 1e-6F);
  EXPECT_LT(ellipsoid(centre, centre, radius), 0);
}

}  // namespace
}  // namespace docent::avatar::distance_field_test
