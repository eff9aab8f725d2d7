#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "runtime/guide/guide.h"
#include "runtime/guide/stature.h"
#include "runtime/interface/seats.h"
#include "runtime/scene/look.h"
#include "runtime/scene/side.h"
#include "tests/runtime/guide/simulated.h"
#include "tests/support/sample_as_read.h"

namespace docent::guide::table_test {
namespace {

constexpr std::uint32_t seats = 8;

GuideSettings settings() {
  GuideSettings settings{.shape = {.width = 1920, .height = 1080, .diagonal_inches = 55},
                         .idle_reset = Seconds{120},
                         .visitors = seats};
  for (const scene::Side side : scene::all_sides) settings.shape.sides.add(side);
  return settings;
}

/// A table with somebody at each of its edges, in simulated time.
class Table {
 public:
  Table()
      : planner_(test::sample_museum(), {test::boxes, {}},
                 planner_size(test::sample_museum(), settings()).avatars,
                 planner_size(test::sample_museum(), settings()).parts),
        guide_(test::sample_museum(), planner_, settings()) {
    run(0.5);
  }
  void run(double seconds) { test::run(planner_, guide_, seconds); }
  void touch(input::InputEvent::Kind kind, scene::ScreenPoint at) {
    guide_.touch({.kind = kind, .contact = {1, at.x, at.y}});
    run(0.05);
  }
  void tap(scene::ScreenPoint at) {
    touch(input::InputEvent::Kind::Down, at);
    touch(input::InputEvent::Kind::Up, at);
  }
  const interface::View& view(std::uint32_t seat) { return *guide_.view(guide_.part_of(seat)); }
  /// Where a visitor of that seat touches what they see there.
  scene::ScreenPoint place_of(std::uint32_t seat, std::string_view name) {
    for (const interface::Control& control : view(seat).controls)
      if (control.name == name && control.enabled) {
        const scene::Rect at = scene::to_screen(view(seat).side, control.rect);
        return {at.x + at.width / 2, at.y + at.height / 2};
      }
    ADD_FAILURE() << name << " at seat " << seat;
    return {};
  }
  void tap(std::uint32_t seat, std::string_view name) { tap(place_of(seat, name)); }
  void sit_down(std::uint32_t seat) {
    tap(seat, "begin");
    tap(seat, "look:" + std::string(scene::looks[seat - 1].name));
  }
  void set_out(std::uint32_t seat) {
    for (const interface::Control& control : view(seat).controls)
      if (control.role == interface::Role::ListItem && control.rect.width > 0 &&
          control.name.starts_with("exhibit:"))
        return tap(seat, control.name);
    ADD_FAILURE() << "no exhibit at seat " << seat;
  }
  const interface::InterfaceState& at(std::uint32_t seat) {
    return guide_.state(guide_.part_of(seat));
  }
  Guide& guide() { return guide_; }

 private:
  plan::Planner planner_;
  Guide guide_;
};

scene::Rect card_on_screen(std::uint32_t seat) {
  const interface::ScreenShape shape = settings().shape;
  return scene::to_screen(interface::side_of(shape, seats, seat),
                          interface::card_of(shape, seats, seat));
}

TEST(ATable, HasSeatsAtEachOfItsEdges) {
  std::array<int, 4> at{};
  for (std::uint32_t seat = 1; seat <= seats; ++seat)
    ++at[static_cast<std::size_t>(interface::side_of(settings().shape, seats, seat))];

  EXPECT_EQ(at, (std::array{3, 1, 3, 1})) << "bottom, left, top, right";
}

TEST(ATable, TakesTouchesAsTheyAreSeenFromEachSide) {
  Table table;
  for (std::uint32_t seat = 1; seat <= seats; ++seat) table.sit_down(seat);

  for (std::uint32_t seat = 1; seat <= seats; ++seat) {
    EXPECT_EQ(table.at(seat).screen, interface::Screen::Choosing) << seat;
    EXPECT_EQ(table.at(seat).look, seat - 1) << seat;
  }
}

TEST(ATable, IsSearchedByEachVisitorForThemselvesOnKeysThatLieOnTheirCard) {
  Table table;
  for (std::uint32_t seat = 1; seat <= seats; ++seat) table.sit_down(seat);

  for (std::uint32_t seat = 1; seat <= seats; ++seat) table.tap(seat, "search");
  table.tap(2, "key:j");
  table.tap(2, "key:a");
  table.tap(5, "key:f");
  table.tap(2, "key:d");
  table.run(0.5);

  for (std::uint32_t seat = 1; seat <= seats; ++seat)
    EXPECT_EQ(table.at(seat).screen, interface::Screen::Searching) << seat;
  EXPECT_EQ(table.at(2).typed.letters(), u"jad");
  EXPECT_EQ(table.at(5).typed.letters(), u"f");
  EXPECT_EQ(table.at(4).typed.count, 0);
  table.tap(2, "exhibit:jade-disc");
  EXPECT_EQ(table.at(2).screen, interface::Screen::Walking);
  EXPECT_EQ(table.at(5).screen, interface::Screen::Searching);
}

TEST(ATable, SetsEveryTextUprightForWhoReadsItAndInsideTheirCard) {
  Table table;
  for (std::uint32_t seat = 1; seat <= seats; ++seat) table.sit_down(seat);
  table.run(1);

  std::array<int, 4> texts{};
  for (const scene::Quad& quad : table.guide().draw_list().quads) {
    if (quad.fill != scene::QuadFill::Text) continue;
    for (std::uint32_t seat = 1; seat <= seats; ++seat) {
      const scene::Rect card = card_on_screen(seat);
      if (!scene::contains(card, quad.rect.x + quad.rect.width / 2,
                           quad.rect.y + quad.rect.height / 2))
        continue;
      EXPECT_EQ(quad.side, interface::side_of(settings().shape, seats, seat)) << seat;
      EXPECT_GE(quad.rect.x, card.x - 1e-3F) << seat;
      EXPECT_LE(quad.rect.x + quad.rect.width, card.x + card.width + 1e-3F) << seat;
      ++texts[static_cast<std::size_t>(quad.side)];
    }
  }
  for (const int count : texts) EXPECT_GT(count, 5);
}

TEST(ATable, ListsWhatLiesOnItInTheScreensFrameAndNothingCoversAnything) {
  Table table;
  for (std::uint32_t seat = 1; seat <= seats; ++seat) table.sit_down(seat);
  table.run(1);

  const std::vector<interface::OnGlass> all = table.guide().on_glass();
  EXPECT_TRUE(interface::outside(all, settings().shape).empty());
  std::vector<interface::OnGlass> controls;
  for (const interface::OnGlass& item : all)
    if (item.role != "text" && item.role != "spot") controls.push_back(item);
  EXPECT_GT(controls.size(), std::size_t{8 * seats});
  EXPECT_TRUE(interface::overlaps(controls, settings().shape).empty());
}

TEST(ATable, ShowsGuidesOfAtLeastTwentyFiveMillimetresThatNoCardCovers) {
  Table table;
  for (std::uint32_t seat = 1; seat <= seats; ++seat) table.sit_down(seat);
  for (std::uint32_t seat = 1; seat <= seats; ++seat) table.set_out(seat);

  const interface::ScreenShape shape = settings().shape;
  const float mm = interface::measures_of(shape).mm;
  for (int second = 0; second < 20; ++second) {
    table.run(1);
    const scene::DrawList& list = table.guide().draw_list();
    ASSERT_EQ(list.avatars.size(), scene::guide_look_count);
    for (const scene::AvatarDraw& avatar : list.avatars) {
      const Vec3 ground{avatar.centre.x, avatar.feet[0].y, avatar.centre.z};
      const auto feet = scene::project(list.camera, ground);
      const auto head = scene::project(list.camera, ground + Vec3(0, 1.6F * avatar.scale, 0));
      ASSERT_TRUE(feet && head);
      EXPECT_GE((feet->y - head->y) * 1080, 0.95F * least_stature_mm * mm) << avatar.look;
      for (std::uint32_t seat = 1; seat <= seats; ++seat) {
        const scene::Rect card = card_on_screen(seat);
        EXPECT_FALSE(scene::contains(card, feet->x, feet->y)) << avatar.look << " by " << seat;
        EXPECT_FALSE(scene::contains(card, head->x, head->y)) << avatar.look << " by " << seat;
      }
    }
  }
}

TEST(ATable, ShowsEachVisitorTheirGoalAndTakesTheModelFromNobody) {
  Table table;
  table.sit_down(1);
  table.sit_down(6);
  const scene::CameraView before = table.guide().draw_list().camera;
  table.set_out(6);
  table.run(3);

  EXPECT_EQ(table.at(6).screen, interface::Screen::Walking);
  EXPECT_GT(table.view(6).inset.board.width, 0) << "the way on its card";
  EXPECT_EQ(table.guide().draw_list().camera, before);
  EXPECT_EQ(table.at(1).screen, interface::Screen::Choosing);
}

TEST(ATable, GivesATouchOfTheModelToWhoStandsNearestAtTheirSide) {
  Table table;
  table.sit_down(2);
  table.sit_down(6);
  const scene::Rect model = interface::model_of(settings().shape);

  table.tap({0.5F, model.y + 0.05F});
  EXPECT_EQ(table.guide().part_of({}), table.guide().part_of(6));
  table.tap({0.5F, model.y + model.height - 0.05F});
  EXPECT_EQ(table.guide().part_of({}), table.guide().part_of(2));
}

TEST(AGlassOfOne, HasNoSidesWhateverIsSaid) {
  GuideSettings alone = settings();
  alone.visitors = 1;
  plan::Planner planner(test::sample_museum(), {test::boxes, {}},
                        planner_size(test::sample_museum(), alone).avatars,
                        planner_size(test::sample_museum(), alone).parts);
  const Guide guide(test::sample_museum(), planner, alone);

  EXPECT_EQ(guide.seats(), 1U);
  EXPECT_EQ(guide.shape().sides.count(), 0);
}

}  // namespace
}  // namespace docent::guide::table_test
