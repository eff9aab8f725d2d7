/// Larger letters, high contrast, and all within reach: for one visitor, and normal for the next.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "runtime/guide/guide.h"
#include "tests/runtime/guide/simulated.h"
#include "tests/support/sample_as_read.h"

namespace docent::guide::senses_test {
namespace {

/// A tall screen of 43 inches, whose lower edge is 700 mm above the floor.
interface::ScreenShape high_glass() {
  return {.width = 1080, .height = 1920, .diagonal_inches = 43, .mount_mm = 700};
}

struct Kiosk {
  explicit Kiosk(const interface::ScreenShape& shape)
      : planner(test::sample_museum(), {test::boxes, {}}),
        guide(test::sample_museum(), planner, {.shape = shape, .idle_reset = Seconds{20}}) {
    run(0.1);
  }
  void run(double seconds) { test::run(planner, guide, seconds); }
  void tap(std::string_view name) {
    const auto& controls = guide.view()->controls;
    const auto control = std::ranges::find(controls, name, &interface::Control::name);
    ASSERT_NE(control, controls.end()) << name;
    const scene::Rect at = control->rect;
    const input::Contact finger{1, at.x + at.width / 2, at.y + at.height / 2};
    for (const auto kind : {input::InputEvent::Kind::Down, input::InputEvent::Kind::Up}) {
      guide.touch({.kind = kind, .contact = finger});
      run(0.05);
    }
  }
  bool offers(std::string_view name) const {
    const auto& controls = guide.view()->controls;
    return std::ranges::find(controls, name, &interface::Control::name) != controls.end();
  }

  plan::Planner planner;
  Guide guide;
};

float above_floor(const interface::ScreenShape& shape, float y) {
  const auto width = static_cast<float>(shape.width), height = static_cast<float>(shape.height);
  return shape.mount_mm +
         (1 - y) * shape.diagonal_inches * 25.4F * height / std::hypot(width, height);
}

TEST(Senses, AreAsOneVisitorWantsThemAndNormalForTheNext) {
  Kiosk kiosk({.width = 1920, .height = 1080});
  const float letters = kiosk.guide.view()->words.front().capitals_px;

  kiosk.tap("larger");
  kiosk.tap("contrast");
  EXPECT_TRUE(kiosk.guide.state().large_letters);
  EXPECT_TRUE(kiosk.guide.state().high_contrast);
  EXPECT_EQ(kiosk.guide.state().screen, interface::Screen::Welcome);
  EXPECT_GT(kiosk.guide.view()->words.front().capitals_px, 1.2F * letters);
  kiosk.tap("contrast");
  EXPECT_FALSE(kiosk.guide.state().high_contrast);
  kiosk.tap("begin");
  EXPECT_TRUE(kiosk.guide.state().large_letters);
  kiosk.run(30);

  EXPECT_EQ(kiosk.guide.state(), interface::InterfaceState{});
}

TEST(Senses, ThatAreOnHaveAFrame) {
  Kiosk kiosk({.width = 1920, .height = 1080});
  const auto has_frame = [&](std::string_view name) {
    const interface::View& view = *kiosk.guide.view();
    return std::ranges::any_of(view.elements, [&](const interface::Element& element) {
      return element.quad.fill == scene::QuadFill::Frame && element.control >= 0 &&
             view.controls[static_cast<std::size_t>(element.control)].name == name;
    });
  };
  EXPECT_FALSE(has_frame("contrast"));
  kiosk.tap("contrast");
  EXPECT_TRUE(has_frame("contrast"));
  EXPECT_FALSE(has_frame("larger"));
  kiosk.tap("contrast");
  EXPECT_FALSE(has_frame("contrast"));
}

TEST(Senses, OfferLowReachWhereTheGlassHangsHigh) {
  EXPECT_FALSE(Kiosk({.width = 1920, .height = 1080}).offers("lower"));
  EXPECT_FALSE(Kiosk({.width = 1920, .height = 1080, .mount_mm = 800}).offers("lower"));
  EXPECT_TRUE(Kiosk(high_glass()).offers("lower"));
}

TEST(Senses, BringAllThatIsTouchedWithinReachOfAWheelchairSpotsIncluded) {
  Kiosk kiosk(high_glass());
  kiosk.tap("lower");
  ASSERT_TRUE(kiosk.guide.state().low_reach);
  for (const char* next : {"begin", "exhibit:boundary-stone"}) {
    kiosk.tap(next);
    kiosk.run(3);
    std::size_t spots = 0;
    for (const interface::OnGlass& item : kiosk.guide.on_glass()) {
      if (item.role == "text") continue;
      spots += item.role == "spot" ? 1 : 0;
      EXPECT_LE(above_floor(high_glass(), item.rect.y), 1221) << item.name;
      EXPECT_GE(above_floor(high_glass(), item.rect.y + item.rect.height), 379) << item.name;
    }
    EXPECT_EQ(spots > 0, kiosk.guide.state().screen == interface::Screen::Choosing);
  }
}

}  // namespace
}  // namespace docent::guide::senses_test
