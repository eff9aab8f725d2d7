#include "runtime/scene/clear_of_boards.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace docent::scene::clear_of_boards_test {
namespace {

constexpr float aspect = 16.0F / 9;
constexpr Rect right_part{0.37F, 0, 0.63F, 1};

/// A case that somebody stands in front of.
constexpr Thing in_case{{10.6F, 0, -10.4F}, {11.4F, 1.5F, -9.6F}};

CameraRig at_the_case() {
  return beside({9.6, 10}, {11, 10}, arrival_turn, 0, right_part, aspect);
}

bool meet(const Rect& a, const Rect& b) {
  return std::max(a.x, b.x) < std::min(a.x + a.width, b.x + b.width) &&
         std::max(a.y, b.y) < std::min(a.y + a.height, b.y + b.height);
}

TEST(ClearOfBoards, LeavesAPictureAsItIsWhereNothingIsCovered) {
  const CameraRig rig = at_the_case();
  const std::array boards{Rect{0.4F, 0.9F, 0.5F, 0.08F}};

  const CameraRig kept = clear_of_boards(rig, std::array{in_case}, boards, right_part, aspect);

  EXPECT_EQ(kept.centre_x, rig.centre_x);
  EXPECT_EQ(kept.centre_y, rig.centre_y);
  EXPECT_EQ(kept.distance, rig.distance);
}

TEST(ClearOfBoards, MovesAThingOutByTheShorterWay) {
  const CameraRig rig = at_the_case();
  const Rect seen = seen_box(view_of(rig, aspect), in_case);
  const std::array boards{Rect{seen.x + 0.9F * seen.width, 0, 0.3F, 0.6F}};

  const CameraRig moved = clear_of_boards(rig, std::array{in_case}, boards, right_part, aspect);

  EXPECT_LT(moved.centre_x, rig.centre_x);
  EXPECT_EQ(moved.centre_y, rig.centre_y);
  EXPECT_EQ(moved.distance, rig.distance);
  EXPECT_FALSE(meet(seen_box(view_of(moved, aspect), in_case), boards[0]));
}

TEST(ClearOfBoards, BacksOffWhereThereIsTooLittleRoom) {
  const CameraRig rig = at_the_case();
  const Rect seen = seen_box(view_of(rig, aspect), in_case);
  const float gap = 0.7F * seen.width + 2 * clear_margin;
  const std::array boards{Rect{right_part.x, 0, right_part.width - gap, 1}};

  const CameraRig moved = clear_of_boards(rig, std::array{in_case}, boards, right_part, aspect);

  EXPECT_GT(moved.distance, rig.distance);
  EXPECT_FALSE(meet(seen_box(view_of(moved, aspect), in_case), boards[0]));
}

TEST(ClearOfBoards, LeavesAPictureAsItIsWhereThereIsNoRoomAtAll) {
  const CameraRig rig = at_the_case();

  const CameraRig kept =
      clear_of_boards(rig, std::array{in_case}, std::array{right_part}, right_part, aspect);

  EXPECT_EQ(kept.centre_x, rig.centre_x);
  EXPECT_EQ(kept.distance, rig.distance);
}

/// Any two boards in corners, anything anywhere near.
RC_GTEST_PROP(ClearOfBoards, CoversNothingWhereCornersAloneAreTaken, ()) {
  const auto share = [](int least, int most) {
    return static_cast<float>(*rc::gen::inRange(least, most)) / 100;
  };
  const float width = share(5, 30), height = share(5, 45);
  const std::array boards{Rect{1 - width, 0, width, height},
                          Rect{right_part.x, 1 - share(5, 30), share(5, 60), 0.4F}};
  const Vec3 low{10 + share(0, 100), 0, -10 + share(0, 100)};
  const std::array things{Thing{low, low + Vec3{share(5, 120), share(5, 200), share(5, 120)}},
                          Thing{{9.3F, 0, -10.3F}, {9.9F, 0, -9.7F}}};
  const CameraRig rig = beside({9.6, 10}, {11, 10}, share(-300, 300), 0, right_part, aspect);

  const CameraView view = view_of(clear_of_boards(rig, things, boards, right_part, aspect), aspect);

  for (const Thing& thing : things)
    for (const Rect& board : boards) RC_ASSERT(!meet(seen_box(view, thing), board));
}

}  // namespace
}  // namespace docent::scene::clear_of_boards_test
