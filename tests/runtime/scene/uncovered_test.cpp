#include "runtime/scene/uncovered.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vector>

namespace docent::scene::uncovered_test {
namespace {

Quad board(Rect rect) {
  Quad quad;
  quad.rect = rect;
  quad.colour = {0.5F, 0.5F, 0.5F, 1};
  return quad;
}

TEST(Uncovered, IsTheWholeScreenWithoutAnInterface) {
  EXPECT_EQ(uncovered({}), (Rect{0, 0, 1, 1}));
}

TEST(Uncovered, EndsWhereAPanelCoversAnEdge) {
  EXPECT_EQ(uncovered(std::vector{board({0, 0, 0.25F, 1})}), (Rect{0.25F, 0, 0.75F, 1}));
  EXPECT_EQ(uncovered(std::vector{board({0.75F, -0.5F, 0.5F, 2})}), (Rect{0, 0, 0.75F, 1}));
  EXPECT_EQ(uncovered(std::vector{board({0, 0.5F, 1, 0.5F})}), (Rect{0, 0, 1, 0.5F}));
}

TEST(Uncovered, EndsAtAPanelThatCoversWhatAnotherLeavesOfAnEdge) {
  EXPECT_EQ(uncovered(std::vector{board({0.25F, 0.75F, 0.75F, 0.25F}), board({0, 0, 0.25F, 1})}),
            (Rect{0.25F, 0, 0.75F, 0.75F}));
}

TEST(Uncovered, IsAllThatIsSeenThroughOrBesideARectangle) {
  const Rect all{0, 0, 1, 1}, panel{0, 0, 0.25F, 1};
  Quad pale = board(panel), round = board(panel), text = board(panel), scrolls = board(panel);
  pale.colour.a = 0.99F;
  round.corner = 0.01F;
  text.fill = QuadFill::Text;
  scrolls.clip.top = 0.1F;

  EXPECT_EQ(uncovered(std::vector{pale, round, text, scrolls}), all);
  EXPECT_EQ(uncovered(std::vector{board({0.25F, 0, 0.25F, 1})}), all) << "beside the edge";
  EXPECT_EQ(uncovered(std::vector{board({0, 0, 0.25F, 0.9F})}), all) << "not to its end";
}

TEST(Uncovered, IsNothingWhereAllIsCovered) {
  EXPECT_EQ(uncovered(std::vector{board({0, 0, 1, 1})}).width, 0);
  EXPECT_EQ(uncovered(std::vector{board({0, 0, 0.5F, 1}), board({0.5F, 0, 0.5F, 1})}).width, 0);
}

/// Every point outside is under one of the rectangles.
RC_GTEST_PROP(Uncovered, LeavesOutOnlyWhatIsCovered, ()) {
  const auto share = [] { return static_cast<float>(*rc::gen::inRange(-2, 11)) / 8; };
  std::vector<Quad> quads;
  for (int i = *rc::gen::inRange(0, 6); i > 0; --i) {
    const float left = share(), top = share();
    quads.push_back(board({left, top, share() + 1 - left, share() + 1 - top}));
    if (quads.back().rect.width <= 0 || quads.back().rect.height <= 0) quads.pop_back();
  }
  const Rect seen = uncovered(quads);
  for (float y = 1.0F / 16; y < 1; y += 1.0F / 8)
    for (float x = 1.0F / 16; x < 1; x += 1.0F / 8) {
      bool is_covered = false;
      for (const Quad& quad : quads) is_covered = is_covered || contains(quad.rect, x, y);
      RC_ASSERT(is_covered || contains(seen, x, y));
    }
}

}  // namespace
}  // namespace docent::scene::uncovered_test
