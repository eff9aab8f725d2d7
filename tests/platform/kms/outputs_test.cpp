#include "platform/kms/outputs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace docent::kms::outputs_test {
namespace {

using testing::DoubleNear;
using testing::Optional;

constexpr PixelSize full_hd{1920, 1080}, ultra_hd{3840, 2160}, xga{1024, 768};

Mode preferred(PixelSize size, std::uint32_t hertz = 60) {
  return {.size = size, .refresh_mhz = hertz * 1000, .is_preferred = true};
}
Mode other(PixelSize size, std::uint32_t hertz = 60) {
  return {.size = size, .refresh_mhz = hertz * 1000};
}

Connector screen(std::string name, std::vector<Mode> modes) {
  return {.id = 0,
          .name = std::move(name),
          .is_connected = !modes.empty(),
          .crtcs = 0b11,
          .modes = std::move(modes)};
}

/// Two CRTCs, each with a plane of its own.
CardState card_with(std::vector<Connector> connectors) {
  CardState card{
      .connectors = std::move(connectors), .crtcs = {50, 51}, .planes = {{60, 1}, {61, 2}}};
  for (std::uint32_t i = 0; i < card.connectors.size(); ++i) card.connectors[i].id = 40 + i;
  return card;
}

std::vector<std::string> screens_of(const CardState& card, const OutputPlan& plan) {
  std::vector<std::string> names;
  for (const Route& route : plan.routes) names.push_back(card.connectors[route.connector].name);
  return names;
}

TEST(BestMode, IsThePreferredOneWhereNothingIsWanted) {
  EXPECT_EQ(best_mode(std::vector{other(ultra_hd), preferred(full_hd), other(xga)}, {}, 0), 1U);
}

TEST(BestMode, IsTheLargestWhereTheScreenPrefersNone) {
  EXPECT_EQ(best_mode(std::vector{other(xga), other(full_hd)}, {}, 0), 1U);
}

TEST(BestMode, KeepsTheSizeAndTakesTheWantedRefresh) {
  const std::vector modes{preferred(full_hd, 60), other(full_hd, 50), other(xga, 50)};

  EXPECT_EQ(best_mode(modes, {}, 50), 1U);
  EXPECT_EQ(best_mode(modes, full_hd, 0), 0U);
  EXPECT_EQ(best_mode(modes, {1000, 760}, 0), 2U);
}

TEST(BestMode, IsInterlacedOnlyWhereNothingElseHasTheSize) {
  Mode interlaced = other(full_hd);
  interlaced.is_interlaced = true;

  EXPECT_EQ(best_mode(std::vector{interlaced, other(full_hd, 50)}, full_hd, 0), 1U);
  EXPECT_EQ(best_mode(std::vector{interlaced, other(xga)}, full_hd, 0), 0U);
  interlaced.is_preferred = true;
  EXPECT_EQ(best_mode(std::vector{interlaced, other(full_hd)}, {}, 0), 1U);
  EXPECT_EQ(best_mode(std::vector{interlaced}, {}, 0), 0U);
}

TEST(OutputPlans, DriveTheFirstConnectedScreen) {
  const CardState card = card_with({screen("DP-1", {}), screen("HDMI-A-1", {preferred(full_hd)}),
                                    screen("HDMI-A-2", {preferred(ultra_hd)})});
  const std::vector<OutputPlan> plans = output_plans(card, {});

  ASSERT_EQ(plans.size(), 1U);
  EXPECT_EQ(plans[0].picture, full_hd);
  EXPECT_THAT(screens_of(card, plans[0]), testing::ElementsAre("HDMI-A-1"));
}

TEST(OutputPlans, DriveTheNamedScreenAndNoOther) {
  const CardState card = card_with(
      {screen("HDMI-A-1", {preferred(full_hd)}), screen("HDMI-A-2", {preferred(ultra_hd)})});

  EXPECT_EQ(output_plans(card, {.connector = "HDMI-A-2"})[0].picture, ultra_hd);
  EXPECT_TRUE(output_plans(card, {.connector = "DP-7"}).empty());
}

TEST(OutputPlans, AreNoneWithoutAScreen) {
  EXPECT_TRUE(output_plans(card_with({screen("HDMI-A-1", {})}), {}).empty());
  EXPECT_TRUE(output_plans({}, {}).empty());
}

TEST(OutputPlans, MirrorAtTheNamedScreensSizeThenInOneModeThenAlone) {
  const CardState card = card_with({screen("HDMI-A-1", {preferred(xga)}),
                                    screen("HDMI-A-2", {preferred(ultra_hd), other(xga)})});
  const std::vector<OutputPlan> plans =
      output_plans(card, {.connector = "HDMI-A-2", .mirror = true});

  ASSERT_EQ(plans.size(), 3U);
  EXPECT_EQ(plans[0].picture, ultra_hd);
  EXPECT_THAT(screens_of(card, plans[0]), testing::ElementsAre("HDMI-A-2", "HDMI-A-1"));
  EXPECT_EQ(plans[0].routes[1].place, (PixelRect{0, 96, 1024, 576}));
  EXPECT_EQ(plans[1].picture, xga);
  EXPECT_EQ(plans[1].routes[0].mode, 1U);
  EXPECT_EQ(plans[2].routes.size(), 1U);
}

TEST(OutputPlans, MirrorInNoLargerModeThanTheFirstScreenLikesWhereThereIsOne) {
  constexpr PixelSize small{640, 480}, own{320, 200};
  CardState card = card_with({screen("A", {preferred(full_hd), other(ultra_hd), other(small)}),
                              screen("B", {preferred(xga), other(ultra_hd), other(small)})});
  EXPECT_EQ(output_plans(card, {.mirror = true})[1].picture, small);

  card.connectors[0].modes[0] = preferred(own);
  EXPECT_EQ(output_plans(card, {.mirror = true})[1].picture, small) << "the smallest of the larger";
}

TEST(OutputPlans, FindACrtcForBothWhereTheFirstChoiceWouldLeaveNone) {
  CardState card =
      card_with({screen("A", {preferred(full_hd)}), screen("B", {preferred(full_hd)})});
  card.connectors[1].crtcs = 0b01;

  const OutputPlan plan = output_plans(card, {.mirror = true})[0];
  ASSERT_EQ(plan.routes.size(), 2U);
  EXPECT_EQ(plan.routes[0].crtc, 1U);
  EXPECT_EQ(plan.routes[1].crtc, 0U);
}

CardState any_card() {
  CardState card;
  const auto crtcs = *rc::gen::inRange(0, 4), planes = *rc::gen::inRange(0, 4);
  for (int i = 0; i < crtcs; ++i) card.crtcs.push_back(static_cast<std::uint32_t>(50 + i));
  for (int i = 0; i < planes; ++i)
    card.planes.push_back({static_cast<std::uint32_t>(60 + i), *rc::gen::inRange(0U, 16U)});
  const auto connectors = *rc::gen::inRange(0, 5);
  for (int i = 0; i < connectors; ++i) {
    Connector one = screen("C-" + std::to_string(i), {});
    one.is_connected = *rc::gen::arbitrary<bool>();
    one.crtcs = *rc::gen::inRange(0U, 16U);
    for (int modes = *rc::gen::inRange(0, 4); modes > 0; --modes)
      one.modes.push_back({.size = {*rc::gen::inRange(1U, 5000U), *rc::gen::inRange(1U, 5000U)},
                           .refresh_mhz = *rc::gen::inRange(0U, 240000U),
                           .is_preferred = *rc::gen::arbitrary<bool>(),
                           .is_interlaced = *rc::gen::arbitrary<bool>()});
    card.connectors.push_back(one);
  }
  return card;
}

RC_GTEST_PROP(OutputPlans, NeverShareACrtcOrAPlaneAndStayWithinTheirReach, ()) {
  const CardState card = any_card();
  const WantedOutput wanted{.connector = *rc::gen::element<std::string>("", "C-1"),
                            .mirror = *rc::gen::arbitrary<bool>()};
  for (const OutputPlan& plan : output_plans(card, wanted)) {
    RC_ASSERT(!plan.routes.empty());
    std::set<std::size_t> crtcs, planes, connectors;
    for (const Route& route : plan.routes) {
      const Connector& connector = card.connectors[route.connector];
      const PixelSize size = connector.modes[route.mode].size;
      RC_ASSERT(connector.is_connected);
      RC_ASSERT((connector.crtcs >> route.crtc & 1U) == 1U);
      RC_ASSERT((card.planes[route.plane].crtcs >> route.crtc & 1U) == 1U);
      RC_ASSERT(route.place.x + route.place.width <= size.width);
      RC_ASSERT(route.place.y + route.place.height <= size.height);
      crtcs.insert(route.crtc);
      planes.insert(route.plane);
      connectors.insert(route.connector);
    }
    RC_ASSERT(crtcs.size() == plan.routes.size());
    RC_ASSERT(planes.size() == plan.routes.size());
    RC_ASSERT(connectors.size() == plan.routes.size());
    RC_ASSERT(wanted.mirror || plan.routes.size() == 1U);
  }
}

RC_GTEST_PROP(OutputPlans, AreThereWheneverAConnectedScreenCanBeFed, ()) {
  const CardState card = any_card();
  const bool can_be_fed = std::ranges::any_of(card.connectors, [&](const Connector& one) {
    return one.is_connected && !one.modes.empty() &&
           std::ranges::any_of(card.planes, [&](const PrimaryPlane& plane) {
             const std::uint32_t there = (1U << card.crtcs.size()) - 1;
             return (plane.crtcs & one.crtcs & there) != 0;
           });
  });

  RC_ASSERT(output_plans(card, {}).empty() == !can_be_fed);
  RC_ASSERT(output_plans(card, {.mirror = true}).empty() == !can_be_fed);
}

TEST(OutputPlans, ThatAreNoneHaveAReason) {
  Connector mute = screen("DP-1", {});
  mute.is_connected = true;

  EXPECT_THAT(why_none(card_with({mute}), {}),
              testing::HasSubstr("the screen at DP-1 offers no mode"));
  EXPECT_THAT(why_none(card_with({screen("DP-1", {})}), {}),
              testing::HasSubstr("no screen is connected;"));
  EXPECT_THAT(why_none(card_with({mute, screen("DP-2", {})}), {.connector = "DP-2"}),
              testing::HasSubstr("no screen is connected to DP-2"));
}

TEST(Letterbox, KeepsThePicturesProportions) {
  EXPECT_EQ(letterbox(full_hd, full_hd), (PixelRect{0, 0, 1920, 1080}));
  EXPECT_EQ(letterbox(full_hd, xga), (PixelRect{0, 96, 1024, 576}));
  EXPECT_EQ(letterbox(xga, full_hd), (PixelRect{240, 0, 1440, 1080}));
}

TEST(Diagonal, IsBelievedOnlyWhereItCanBe) {
  EXPECT_THAT(diagonal_inches(527, 296, full_hd), Optional(DoubleNear(23.8, 0.05)));
  EXPECT_THAT(diagonal_inches(1210, 680, ultra_hd), Optional(DoubleNear(54.6, 0.05)));
  EXPECT_EQ(diagonal_inches(0, 0, full_hd), std::nullopt);
  EXPECT_EQ(diagonal_inches(0, 296, full_hd), std::nullopt);
  EXPECT_EQ(diagonal_inches(160, 90, full_hd), std::nullopt) << "proportions";
  EXPECT_EQ(diagonal_inches(16, 9, full_hd), std::nullopt) << "proportions";
  EXPECT_EQ(diagonal_inches(296, 527, full_hd), std::nullopt) << "upright, and the mode is not";
  EXPECT_EQ(diagonal_inches(9000, 5000, full_hd), std::nullopt) << "a wall";
  EXPECT_EQ(diagonal_inches(50, 28, full_hd), std::nullopt) << "a watch";
}

}  // namespace
}  // namespace docent::kms::outputs_test
