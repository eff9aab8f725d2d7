#include "runtime/kiosk/edges.h"

#include <gtest/gtest.h>

namespace docent::kiosk::edges_test {
namespace {

/// A panel that was built in turned, as it says itself.
class TurnedPanel final : public Display {
 public:
  explicit TurnedPanel(Rotation panel) : panel_(panel) {}
  DisplayState wait_for_page_flip() noexcept override { return DisplayState::Open; }
  RenderTarget target() const noexcept override { return {.size = {800, 480}, .rotation = panel_}; }
  void present() noexcept override {}
  std::string description() const override { return "a panel"; }

 private:
  Rotation panel_;
};

Edges edges_on(Rotation panel, Rotation mounted) {
  Edges edges;
  edges.display = std::make_unique<TurnedPanel>(panel);
  edges.rotation = mounted;
  return edges;
}

TEST(Edges, TurnThePictureByPanelAndMounting) {
  const RenderTarget target = target_of(edges_on(Rotation::Quarter, Rotation::Half));

  EXPECT_EQ(target.rotation, Rotation::ThreeQuarters);
  EXPECT_EQ(target.size, (PixelSize{480, 800}));
  EXPECT_EQ(target_of(edges_on(Rotation::Quarter, Rotation::ThreeQuarters)).rotation,
            Rotation::None);
}

TEST(Edges, TurnATouchAsThePictureIs) {
  // Hung turned clockwise by a quarter, the panel's own top left is at the visitor's top right.
  const input::Contact quarter = turned({1, 0, 0}, Rotation::Quarter);
  const input::Contact half = turned({1, 0, 0}, Rotation::Half);

  EXPECT_EQ(quarter.x, 1);
  EXPECT_EQ(quarter.y, 0);
  EXPECT_EQ(half.x, 1);
  EXPECT_EQ(half.y, 1);
}

TEST(Edges, ShiftThePictureAndTheTouchWithIt) {
  Edges edges = edges_on(Rotation::None, Rotation::None);
  edges.shift = {4, 2};
  const RenderTarget target = target_of(edges);
  const input::Contact contact = shifted_back({1, 0.5F, 0.5F}, target);

  EXPECT_EQ(target.shift_x, 4);
  EXPECT_EQ(target.shift_y, 2);
  EXPECT_FLOAT_EQ(contact.x, 0.5F - 4.0F / 800);
  EXPECT_FLOAT_EQ(contact.y, 0.5F - 2.0F / 480);
  EXPECT_EQ(shifted_back({1, 0, 0}, target).x, 0) << "the picture's edge was drawn out to here";
}

}  // namespace
}  // namespace docent::kiosk::edges_test
