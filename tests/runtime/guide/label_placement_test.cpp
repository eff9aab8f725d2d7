#include "runtime/guide/label_placement.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>

#include "runtime/scene/side.h"

namespace docent::guide::label_placement_test {
namespace {

/// A floor of 40 by 30 metres, seen whole.
scene::CameraView overview() {
  const std::array<Vec2, 4> outline{{{0, 0}, {40, 0}, {40, 30}, {0, 30}}};
  return scene::view_of(scene::overview_of(outline, 0, 1.57, {0.37F, 0, 0.63F, 1}, 16.0F / 9),
                        16.0F / 9);
}

interface::View view_of(std::size_t exhibits, std::size_t signs, std::uint32_t spread) {
  interface::View view;
  view.pixel_width = 1920;
  view.pixel_height = 1080;
  view.panel = {0, 0, 0.37F, 1};
  view.free = {0.37F, 0, 0.63F, 1};
  for (std::size_t i = 0; i < exhibits + signs; ++i) {
    const auto n = static_cast<std::uint32_t>(i);
    view.controls.push_back({.name = std::to_string(i),
                             .role = interface::Role::Spot,
                             .label = {},
                             .action = {},
                             .rect = {}});
    view.labels.push_back(
        {.position = {1 + n * 7919U % spread / 10.0, 1 + n * 104729U % 280 / 10.0},
         .height = 2.3F,
         .width_px = 20,
         .height_px = 28,
         .control = static_cast<std::int32_t>(i),
         .on_disc = i < exhibits,
         .is_sign = i >= exhibits,
         .rect = {}});
  }
  for (int i = 0; i < 9; ++i) {
    const Vec2 least{13.0 * (i % 3), 10.0 * (i / 3)};
    view.labels.push_back({.position = least + Vec2{6, 5},
                           .width_px = 150,
                           .height_px = 28,
                           .least = least,
                           .most = least + Vec2{13, 10},
                           .rect = {}});
  }
  return view;
}

bool overlap(const scene::Rect& a, const scene::Rect& b) {
  constexpr float slack = 1e-5F;  // of a float's last digits
  return a.width > 0 && b.width > 0 && a.x + slack < b.x + b.width && b.x + slack < a.x + a.width &&
         a.y + slack < b.y + b.height && b.y + slack < a.y + a.height;
}

TEST(PlacedLabels, CoverNeitherEachOtherNorThePanel) {
  EXPECT_TRUE(rc::check("1 to 5,000 exhibits, near and far", [] {
    interface::View view =
        view_of(*rc::gen::element<std::size_t>(1, 25, 100, 300, 5000),
                *rc::gen::inRange<std::size_t>(0, 20), *rc::gen::inRange(1U, 380U));
    view.readers.bits = static_cast<std::uint8_t>(*rc::gen::inRange(0, 16));
    place_labels(view, overview(), 0);
    std::vector<scene::Rect> grounds;
    for (const interface::FloorLabel& label : view.labels)
      if (label.rect.width > 0) grounds.push_back(ground_of(view, label));
    for (std::size_t i = 0; i < grounds.size(); ++i) {
      RC_ASSERT(grounds[i].x >= view.free.x - 1e-4F);
      RC_ASSERT(grounds[i].x + grounds[i].width <= 1.0001F);
      for (std::size_t j = 0; j < i; ++j) RC_ASSERT(!overlap(grounds[i], grounds[j]));
    }
    for (std::size_t i = 0; i < view.controls.size(); ++i)
      for (std::size_t j = 0; j < i && i < 300; ++j)
        RC_ASSERT(!overlap(view.controls[i].rect, view.controls[j].rect));
  }));
}

/// Does a line from one point to another pass through a rectangle?
bool crosses(const Leader& line, const scene::Rect& rect) {
  for (int i = 0; i <= 400; ++i) {
    const float share = static_cast<float>(i) / 400;
    if (scene::contains(rect, std::lerp(line.from.x, line.to.x, share),
                        std::lerp(line.from.y, line.to.y, share)))
      return true;
  }
  return false;
}

bool cross(const Leader& a, const Leader& b) {
  const auto side = [](const Leader& line, scene::ScreenPoint p) {
    return (line.to.x - line.from.x) * (p.y - line.from.y) -
           (line.to.y - line.from.y) * (p.x - line.from.x);
  };
  return side(a, b.from) * side(a, b.to) < 0 && side(b, a.from) * side(b, a.to) < 0;
}

/// Signs and names that find no room at their place, in a museum as crowded as it likes.
TEST(PlacedLabels, ThatLieFurtherAwayHaveALineThatCrossesNothing) {
  EXPECT_TRUE(rc::check("1 to 300 exhibits, near and far, up to 60 places", [] {
    interface::View view =
        view_of(*rc::gen::element<std::size_t>(1, 25, 100, 300),
                *rc::gen::inRange<std::size_t>(0, 60), *rc::gen::inRange(1U, 380U));
    view.unit_px = *rc::gen::element(8.0F, 11.0F);
    view.readers.bits = static_cast<std::uint8_t>(*rc::gen::inRange(0, 16));
    place_labels(view, overview(), 0);
    for (std::size_t i = 0; i < view.labels.size(); ++i) {
      const interface::FloorLabel& led = view.labels[i];
      if (!led.is_led) continue;
      RC_ASSERT(led.rect.width > 0 && !led.on_disc);
      RC_ASSERT(std::abs(led.rect.width * view.pixel_width - led.lying_width()) < 0.01F);
      Leader line = leader_of(view, led);
      // Its beginning may lie below what has taken its place.
      const Leader whole = line;
      line.from = {std::midpoint(line.from.x, line.to.x), std::midpoint(line.from.y, line.to.y)};
      for (std::size_t j = 0; j < view.labels.size(); ++j) {
        const interface::FloorLabel& other = view.labels[j];
        if (j == i || other.rect.width <= 0) continue;
        RC_ASSERT(!crosses(line, ground_of(view, other)));
        if (other.is_led && j < i) {
          Leader seen = leader_of(view, other);
          seen.from = {std::midpoint(seen.from.x, seen.to.x),
                       std::midpoint(seen.from.y, seen.to.y)};
          RC_ASSERT(!cross(line, seen));
        }
      }
      RC_ASSERT(!crosses(whole, view.panel));
    }
  }));
}

/// 36 exhibits stand close together, and six places in their midst.
interface::View crowded() {
  interface::View view = view_of(36, 6, 380);
  for (std::size_t i = 0; i < 36; ++i)
    view.labels[i].position = {10 + 0.6 * static_cast<double>(i % 6),
                               10 + 0.6 * static_cast<double>(i / 6)};
  for (std::size_t i = 36; i < 42; ++i)
    view.labels[i].position = {11 + 0.3 * static_cast<double>(i - 36), 12.0};
  return view;
}

TEST(PlacedLabels, ThatFindNoRoomAtTheirPlaceGoWhereThereIsSome) {
  interface::View view = crowded();
  place_labels(view, overview(), 0);

  std::size_t led = 0;
  for (const interface::FloorLabel& label : view.labels) {
    if (label.on_disc) continue;
    EXPECT_GT(label.rect.width, 0) << label.position.x << ", " << label.position.y;
    led += label.is_led ? 1 : 0;
  }
  EXPECT_GT(led, 0U) << "else this says nothing";
}

TEST(PlacedLabels, LieWhereTheyLayWhenTheSamePictureIsLaidOutAgain) {
  interface::View view = crowded();
  place_labels(view, overview(), 0);
  const interface::View before = view;

  place_labels(view, overview(), 0);

  for (std::size_t i = 0; i < view.labels.size(); ++i) {
    EXPECT_EQ(view.labels[i].rect.x, before.labels[i].rect.x);
    EXPECT_EQ(view.labels[i].rect.y, before.labels[i].rect.y);
  }
}

/// A museum of 300 exhibits with large letters: every exhibit is seen, or in a cluster that opens.
TEST(PlacedLabels, ThatFindNoRoomAreInAClusterThatShowsThemAll) {
  interface::View view = view_of(300, 12, 380);
  view.unit_px = 11;
  for (interface::FloorLabel& label : view.labels)
    if (label.on_disc) label.width_px = 44;
  place_labels(view, overview(), 0);
  std::size_t seen = 0, gathered = 0, heads = 0, held = 0;
  for (const interface::FloorLabel& label : view.labels) {
    if (!label.on_disc) continue;
    seen += label.rect.width > 0 ? 1 : 0;
    gathered += label.head >= 0 ? 1 : 0;
    heads += label.held > 0 ? 1 : 0;
    held += label.held;
    EXPECT_NE(label.rect.width > 0, label.head >= 0);
  }
  EXPECT_EQ(seen + gathered, 300U);
  EXPECT_EQ(held, gathered);
  ASSERT_GT(heads, 3U);

  for (std::size_t i = 0; i < 300; ++i) {
    interface::View opened = view;
    if (opened.labels[i].held == 0) continue;
    EXPECT_TRUE(stands_for_several(opened, static_cast<std::int32_t>(i)));
    opened.open = static_cast<std::int32_t>(i);
    place_labels(opened, overview(), 0);
    ASSERT_GT(opened.cluster.width, 0);
    EXPECT_FALSE(overlap(opened.cluster, opened.panel));
    std::size_t shown = 0;
    std::vector<scene::Rect> targets;
    for (std::size_t j = 0; j < opened.controls.size(); ++j) {
      const scene::Rect& target = opened.controls[j].rect;
      if (target.width <= 0) continue;
      const bool is_in = j == i || view.labels[j].head == static_cast<std::int32_t>(i);
      EXPECT_EQ(is_in, overlap(target, opened.cluster));
      shown += is_in ? 1 : 0;
      for (const scene::Rect& other : targets) EXPECT_FALSE(overlap(target, other));
      targets.push_back(target);
    }
    EXPECT_EQ(shown, 1U + view.labels[i].held);
  }
}

TEST(PlacedLabels, AreInNoClusterWhereThereIsRoom) {
  interface::View view = view_of(20, 6, 380);
  place_labels(view, overview(), 0);

  for (std::size_t i = 0; i < 20; ++i)
    EXPECT_FALSE(stands_for_several(view, static_cast<std::int32_t>(i)));
}

TEST(PlacedLabels, AreAllShownWhereThereIsRoom) {
  interface::View view = view_of(40, 6, 380);
  place_labels(view, overview(), 0);

  for (const interface::FloorLabel& label : view.labels) EXPECT_GT(label.rect.width, 0);
}

TEST(PlacedLabels, AreReadFromTheNearestEdgeAtWhichPeopleStand) {
  using scene::Side;
  for (const unsigned sides : {0b0000U, 0b0001U, 0b0101U, 0b1111U, 0b1010U}) {
    interface::View view = view_of(40, 5, 380);
    view.panel = {};
    view.free = {0, 0, 1, 1};
    view.readers.bits = static_cast<std::uint8_t>(sides);
    place_labels(view, overview(), 0);

    for (const interface::FloorLabel& label : view.labels) {
      if (label.anchor_x < 0) continue;
      const auto from_edge = [&](Side side) {
        return 1 - scene::as_seen_from(side, {label.anchor_x, label.anchor_y}).y;
      };
      EXPECT_TRUE(sides == 0 ? label.side == Side::Bottom : view.readers.has(label.side));
      for (const Side side : scene::all_sides)
        EXPECT_TRUE(!view.readers.has(side) || from_edge(label.side) <= from_edge(side));
      if (label.rect.width <= 0) continue;
      EXPECT_NEAR(label.rect.width * 1920,
                  scene::is_at_end(label.side) ? label.height_px : label.width_px, 0.1);
    }
  }
}

TEST(PlacedLabels, AreNotTurnedToTheEndsWhereTheyWouldReachIntoTheNextGallery) {
  interface::View view = view_of(0, 0, 380);
  view.panel = {};
  view.free = {0, 0, 1, 1};
  const auto has_turned = [&] {
    place_labels(view, overview(), 0);
    return std::ranges::any_of(view.labels, [](const interface::FloorLabel& label) {
      return scene::is_at_end(label.side);
    });
  };

  view.readers.bits = 0b1111;
  EXPECT_TRUE(has_turned());
  for (interface::FloorLabel& label : view.labels) label.width_px = 700;
  EXPECT_FALSE(has_turned());
  view.readers.bits = 0b1010;
  EXPECT_TRUE(has_turned()) << "where nobody else is there";
}

TEST(PlacedLabels, StayWhereTheyAreWhenNothingIsInTheWay) {
  interface::View view = view_of(1, 0, 380);
  place_labels(view, overview(), 0);

  const interface::FloorLabel& label = view.labels.front();
  EXPECT_NEAR(label.rect.x + label.rect.width / 2, label.anchor_x, 1e-5);
  EXPECT_NEAR(label.rect.y + label.rect.height / 2, label.anchor_y, 1e-5);
}

}  // namespace
}  // namespace docent::guide::label_placement_test
