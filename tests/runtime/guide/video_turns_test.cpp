#include "runtime/guide/video_turns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "runtime/guide/guide.h"
#include "runtime/interface/seats.h"
#include "runtime/scene/look.h"
#include "runtime/scene/side.h"
#include "tests/runtime/guide/simulated.h"
#include "tests/support/sample_as_read.h"

namespace docent::guide::video_turns_test {
namespace {

constexpr std::uint32_t seats = 8;

/// The sample museum; the second picture of each of its exhibits is the same video.
Museum museum_with_videos() {
  Museum museum = test::sample_museum();
  museum.images.push_back(
      {.name = "images/turning.webm", .width = 320, .height = 180, .bytes = {}});
  const auto image = static_cast<std::uint32_t>(museum.images.size() - 1);
  museum.pictures.clear();
  museum.cues.clear();
  for (std::uint32_t i = 0; i < museum.exhibits.size(); ++i) {
    museum.pictures.push_back({.exhibit = i, .image = image});
    museum.cues.push_back({.picture = i, .begin = 1000, .end = 30000, .text = "It turns."});
  }
  return museum;
}

Pixels grey(std::uint32_t, std::uint32_t width, std::uint32_t height) {
  return {width, height, std::vector<std::byte>(std::size_t{4} * width * height, std::byte{128})};
}

enum class Motion : std::uint8_t { Usual, Reduced };

GuideSettings settings(Motion motion) {
  GuideSettings settings{.shape = {.width = 1920, .height = 1080, .diagonal_inches = 55},
                         .idle_reset = Seconds{300},
                         .visitors = seats,
                         .reduced_motion = motion == Motion::Reduced};
  for (const scene::Side side : scene::all_sides) settings.shape.sides.add(side);
  return settings;
}

/// A table in simulated time, at whose first seats visitors have been led to the nearest exhibits,
/// one each.
class Table {
 public:
  explicit Table(std::uint32_t visitors, Motion motion = Motion::Usual)
      : museum_(museum_with_videos()),
        planner_(museum_, {test::boxes, grey}, planner_size(museum_, settings(motion)).avatars,
                 planner_size(museum_, settings(motion)).parts),
        guide_(museum_, planner_, settings(motion)) {
    run(0.5);
    for (std::uint32_t seat = 1; seat <= visitors; ++seat) {
      tap(seat, "begin");
      tap(seat, "look:" + std::string(scene::looks[seat - 1].name));
      set_out(seat);
    }
    for (int i = 0; i < 240 && !are_there(visitors); ++i) run(1);
    EXPECT_TRUE(are_there(visitors));
    run(0.1);
  }
  void run(double seconds) { test::run(planner_, guide_, seconds); }
  const interface::View& view(std::uint32_t seat) { return *guide_.view(guide_.part_of(seat)); }
  const interface::InterfaceState& at(std::uint32_t seat) {
    return guide_.state(guide_.part_of(seat));
  }
  void tap(std::uint32_t seat, std::string_view name) {
    for (const interface::Control& control : view(seat).controls) {
      if (control.name != name || !control.enabled || control.rect.width <= 0) continue;
      const scene::Rect on = scene::to_screen(view(seat).side, control.rect);
      const input::Contact finger{1, on.x + on.width / 2, on.y + on.height / 2};
      for (const auto kind : {input::InputEvent::Kind::Down, input::InputEvent::Kind::Up}) {
        guide_.touch({.kind = kind, .contact = finger});
        run(0.05);
      }
      return;
    }
    ADD_FAILURE() << name << " at seat " << seat;
  }
  /// What is shown in the texture of that visitor's card; nothing while no player has it.
  std::optional<ShownVideo> shown(std::uint32_t seat) {
    for (std::size_t player = 0; player < guide_.players(); ++player)
      if (const auto video = guide_.video(player);
          video && video->texture == view(seat).video && video->texture != scene::TextureId::None)
        return video;
    return {};
  }
  bool plays(std::uint32_t seat) {
    const auto video = shown(seat);
    return video && video->plays && at(seat).plays;
  }
  int playing() {
    int count = 0;
    for (std::uint32_t seat = 1; seat <= seats; ++seat) count += plays(seat) ? 1 : 0;
    return count;
  }
  Guide& guide() { return guide_; }

 private:
  void set_out(std::uint32_t seat) {
    for (int page = 0; page < 4; ++page) {
      for (const interface::Control& control : view(seat).controls)
        if (control.role == interface::Role::ListItem && control.rect.width > 0 &&
            control.name.starts_with("exhibit:") && gone_to_.insert(control.name).second)
          return tap(seat, control.name);
      tap(seat, "page:next");
    }
    ADD_FAILURE() << "no exhibit at seat " << seat;
  }
  bool are_there(std::uint32_t visitors) {
    for (std::uint32_t seat = 1; seat <= visitors; ++seat)
      if (!at(seat).arrived) return false;
    return true;
  }

  Museum museum_;
  plan::Planner planner_;
  Guide guide_;
  std::set<std::string, std::less<>> gone_to_;
};

/// Is the caption of that seat's video read on its card, from its side?
bool is_captioned(Table& table, std::uint32_t seat) {
  const interface::View& view = table.view(seat);
  const scene::Rect card = scene::to_screen(view.side, view.panel);
  return std::ranges::any_of(table.guide().draw_list().quads, [&](const scene::Quad& quad) {
    const scene::Rect& at = quad.rect;
    return !view.cues.empty() && quad.texture == view.cues.front().quad.texture && at.width > 0 &&
           quad.side == view.side && scene::contains(card, at.x, at.y) &&
           scene::contains(card, at.x + at.width, at.y + at.height);
  });
}

TEST(VideoTurns, PlayAVideoOnACardAtEachEdgeOfATable) {
  Table table(4);
  std::set<scene::Side> sides;
  for (std::uint32_t seat = 1; seat <= 4; ++seat) {
    table.tap(seat, "picture:next");
    sides.insert(table.view(seat).side);
  }
  table.run(2);

  std::set<scene::TextureId> textures;
  for (std::uint32_t seat = 1; seat <= 4; ++seat) {
    ASSERT_TRUE(table.plays(seat)) << seat;
    EXPECT_GT(table.shown(seat)->seconds, 1.5F) << seat;
    textures.insert(table.shown(seat)->texture);
    EXPECT_TRUE(is_captioned(table, seat)) << seat;
  }
  EXPECT_GT(sides.size(), 1U);
  EXPECT_EQ(textures.size(), 4U) << "each sees theirs, though it is the same video";
}

TEST(VideoTurns, StopAndGoOnAsAVisitorTouchesTheirCard) {
  Table table(1);
  table.tap(1, "picture:next");
  table.run(2);
  table.tap(1, "video:stop");
  const float stopped = table.shown(1)->seconds;
  table.run(3);
  EXPECT_FALSE(table.plays(1));
  EXPECT_EQ(table.shown(1)->seconds, stopped);

  table.tap(1, "video:play");
  table.run(1);
  EXPECT_TRUE(table.plays(1));
  EXPECT_NEAR(table.shown(1)->seconds, stopped + 1, 0.2);
}

TEST(VideoTurns, LeaveAVideoStillThatIsLeafedToWhileAllPlayersPlay) {
  Table table(5);
  for (std::uint32_t seat = 1; seat <= 5; ++seat) table.tap(seat, "picture:next");
  table.run(2);

  for (std::uint32_t seat = 1; seat <= 4; ++seat) EXPECT_TRUE(table.plays(seat)) << seat;
  EXPECT_FALSE(table.at(5).plays) << "its card offers to play it";
  EXPECT_NE(table.view(5).video, scene::TextureId::None) << "its first picture is there";
  ASSERT_FALSE(table.view(5).cues.empty());
  for (const scene::Quad& quad : table.guide().draw_list().quads)
    if (quad.texture == table.view(5).cues.front().quad.texture &&
        quad.side == table.view(5).side) {
      EXPECT_EQ(quad.uv.width, 0) << "nobody's caption lies where it is not read";
    }
}

TEST(VideoTurns, GiveWhoAsksThePlayerThatHasPlayedLongest) {
  Table table(8);
  for (const std::uint32_t seat : {2U, 1U, 3U, 4U, 5U}) {
    table.tap(seat, "picture:next");
    table.run(1);
  }
  ASSERT_TRUE(table.plays(2));
  const float before = table.shown(2)->seconds;

  table.tap(5, "video:play");
  table.run(1);
  EXPECT_TRUE(table.plays(5));
  EXPECT_FALSE(table.at(2).plays) << "theirs was begun first";
  EXPECT_EQ(table.playing(), 4);

  table.tap(2, "video:play");
  table.run(0.5);
  EXPECT_TRUE(table.plays(2));
  EXPECT_NEAR(table.shown(2)->seconds, before + 0.6, 0.3) << "it goes on where it was";
  EXPECT_FALSE(table.at(1).plays);
  EXPECT_EQ(table.playing(), 4);

  for (const std::uint32_t seat : {6U, 7U, 8U, 1U}) {
    if (seat != 1) table.tap(seat, "picture:next");
    table.tap(seat, "video:play");
    table.run(0.5);
    EXPECT_TRUE(table.plays(seat)) << "whoever asks sees it move: seat " << seat;
    EXPECT_EQ(table.playing(), 4);
  }
}

TEST(VideoTurns, FreeAPlayerWhoseVisitorLooksAtSomethingElse) {
  Table table(5);
  for (std::uint32_t seat = 1; seat <= 4; ++seat) table.tap(seat, "picture:next");
  table.run(1);
  table.tap(3, "choose");
  table.run(0.5);
  table.tap(5, "picture:next");
  table.run(1);

  EXPECT_TRUE(table.plays(5));
  EXPECT_EQ(table.playing(), 4);
}

TEST(VideoTurns, LetNothingMoveByItselfWhereMotionIsReduced) {
  Table table(1, Motion::Reduced);
  table.tap(1, "picture:next");
  table.run(2);
  EXPECT_FALSE(table.plays(1));

  table.tap(1, "video:play");
  table.run(1);
  EXPECT_TRUE(table.plays(1));
}

}  // namespace
}  // namespace docent::guide::video_turns_test
