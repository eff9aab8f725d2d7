#include "runtime/input/calibration.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace docent::test::calibration_test {
namespace {

using input::Calibration;
using input::TouchedMark;
using testing::HasSubstr;

/// The four marks, as touched on a glass of which `truth` is the right calibration.
std::vector<TouchedMark> touches_of(const Calibration& truth) {
  const double det = truth.a * truth.e - truth.b * truth.d;
  std::vector<TouchedMark> touched;
  for (const auto& [x, y] : input::calibration_marks) {
    const double u = x - truth.c, v = y - truth.f;
    touched.push_back({x, y, static_cast<float>((truth.e * u - truth.b * v) / det),
                       static_cast<float>((truth.a * v - truth.d * u) / det)});
  }
  return touched;
}

TEST(Calibration, OfAGlassThatIsRightChangesNothing) {
  const auto found = input::fit(touches_of({}));

  ASSERT_TRUE(found.has_value());
  const input::Contact at = input::calibrated(*found, {1, 0.3F, 0.7F});
  EXPECT_NEAR(at.x, 0.3F, 1e-5);
  EXPECT_NEAR(at.y, 0.7F, 1e-5);
}

TEST(Calibration, FindsWhereAGlassWasGluedOn) {
  const Calibration truth{1.05, 0.02, -0.03, -0.01, 0.97, 0.04};
  const auto found = input::fit(touches_of(truth));

  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(found->a, truth.a, 1e-4);
  EXPECT_NEAR(found->b, truth.b, 1e-4);
  EXPECT_NEAR(found->c, truth.c, 1e-4);
  EXPECT_NEAR(found->d, truth.d, 1e-4);
  EXPECT_NEAR(found->e, truth.e, 1e-4);
  EXPECT_NEAR(found->f, truth.f, 1e-4);
}

TEST(Calibration, IsNoneWhereOneMarkWasNotTouched) {
  auto touched = touches_of({});
  touched[2].touched_x = 0.5F;
  EXPECT_FALSE(input::fit(touched));
  for (TouchedMark& t : touched) t.touched_x = t.touched_y = 0.5F;
  EXPECT_FALSE(input::fit(touched)) << "all at one place";
  EXPECT_FALSE(input::fit({}));
}

TEST(Calibration, IsNoneThatWouldMirrorTheGlassOrLeaveItsCornersOut) {
  EXPECT_FALSE(input::fit(touches_of({-1, 0, 1, 0, 1, 0})));
  EXPECT_FALSE(input::fit(touches_of({1, 0, 0.4, 0, 1, 0})));
  EXPECT_FALSE(input::is_plausible({std::nan(""), 0, 0, 0, 1, 0}));
}

TEST(Calibration, KeepsContactsOnTheScreen) {
  const input::Contact at = input::calibrated({1, 0, 0.2, 0, 1, -0.2}, {7, 0.95F, 0.05F});

  EXPECT_EQ(at.id, 7U);
  EXPECT_EQ(at.x, 1.F);
  EXPECT_EQ(at.y, 0.F);
}

TEST(Calibration, ComesBackFromItsText) {
  const Calibration truth{1.05, 0.02, -0.03, -0.01, 0.97, 0.04};

  EXPECT_EQ(input::parse_calibration(input::to_text(truth), "glass"), truth);
}

TEST(Calibration, InOtherTextIsASentence) {
  for (const char* text :
       {"", "docent calibration 1\n", "docent calibration 1\n1 0 0 0 1\n",
        "docent calibration 2\n1 0 0 0 1 0\n", "docent calibration 1\n1 0 0 0 1 0 0\n",
        "docent calibration 1\nnan 0 0 0 1 0\n", "docent calibration 1\n9 0 0 0 1 0\n"}) {
    const auto read = input::parse_calibration(text, "/var/glass");
    ASSERT_FALSE(read.has_value()) << text;
    EXPECT_THAT(read.error().what, HasSubstr("/var/glass"));
  }
}

}  // namespace
}  // namespace docent::test::calibration_test
