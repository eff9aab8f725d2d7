#include "runtime/kiosk/change_over.h"

#include <gtest/gtest.h>

#include <chrono>
#include <optional>
#include <thread>
#include <utility>

#include "platform/gles/renderer.h"
#include "platform/headless/headless_display.h"
#include "tests/support/sample_database.h"

namespace docent::kiosk::change_over_test {
namespace {

constexpr PixelSize size{320, 180};
using State = ChangeOver::State;

interface::ScreenShape shape() {
  interface::ScreenShape shape;
  shape.width = size.width;
  shape.height = size.height;
  return shape;
}

ChangeOver::Load sample_museum() {
  return [] { return load_exhibition(test::sample_database(), {}, {.shape = shape()}); };
}

/// A change that was begun at second 10, on a screen of its own.
class AChange : public ::testing::Test {
 protected:
  AChange()
      : display_(headless::open_headless(size).value()), renderer_(gles::make_renderer().value()) {}

  /// Steps until nothing more happens by itself; how often pieces were carried.
  int step_to_the_end(ChangeOver& change) {
    int steps = 0;
    while (change.state() == State::Reading || change.state() == State::Preparing) {
      if (change.state() == State::Preparing) ++steps;
      change.step(shape());
      std::this_thread::sleep_for(std::chrono::milliseconds(2));  // the worker has its time
    }
    return steps;
  }

  Pixels drawn(Exhibition& exhibition) {
    renderer_.draw(exhibition.guide->draw_list(), exhibition.holdings, display_->target());
    Pixels picture;
    display_->read_back(picture);
    return picture;
  }

  std::unique_ptr<headless::HeadlessDisplay> display_;
  gles::Renderer renderer_;
  ChangeOver change_{
      false, {std::chrono::nanoseconds(0), std::chrono::nanoseconds(0)}};  ///< A piece a step.
};

TEST_F(AChange, IsReadyWhenItsFirstViewIsWholeAndLeavesTheOldPictureAsItWas) {
  ChangeOver at_once(true);
  at_once.begin(sample_museum(), 0);
  at_once.step(shape());
  ASSERT_EQ(at_once.state(), State::Ready);
  const auto old = std::move(*at_once.take());
  const Pixels before = drawn(*old);

  change_.begin(sample_museum(), 10);
  EXPECT_GT(step_to_the_end(change_), 35) << "as many as there are pictures";
  ASSERT_EQ(change_.state(), State::Ready);

  EXPECT_EQ(drawn(*old).rgba, before.rgba);
  const auto next = std::move(*change_.take());
  EXPECT_TRUE(next->guide->shows_its_state());
  EXPECT_EQ(drawn(*next).rgba, before.rgba);
}

TEST_F(AChange, IsDueWhileNobodyIsThereOrAfterFiveMinutes) {
  EXPECT_FALSE(change_.is_due(true, 1000)) << "nothing was begun";
  change_.begin(sample_museum(), 10);
  EXPECT_FALSE(change_.is_due(true, 1000)) << "nothing is ready";
  step_to_the_end(change_);

  EXPECT_TRUE(change_.is_due(true, 10));
  EXPECT_FALSE(change_.is_due(false, 309.9));
  EXPECT_TRUE(change_.is_due(false, 310));
}

TEST_F(AChange, ThatIsRefusedSaysWhyAndAnotherCanBegin) {
  change_.begin(
      []() -> Result<std::unique_ptr<Exhibition>> {
        return std::unexpected(Error{Errc::Damaged, "it is damaged"});
      },
      10);
  step_to_the_end(change_);

  ASSERT_EQ(change_.state(), State::Refused);
  EXPECT_FALSE(change_.is_due(true, 1000));
  EXPECT_EQ(change_.take().error().what, "it is damaged");
  EXPECT_EQ(change_.state(), State::Idle);
  change_.begin(sample_museum(), 20);
  step_to_the_end(change_);
  EXPECT_EQ(change_.state(), State::Ready);
}

TEST_F(AChange, TakesTheOldOneApartBeforeItReadsTheNext) {
  for (int i = 0; i < 3; ++i) {
    change_.begin(sample_museum(), 10);
    step_to_the_end(change_);
    change_.retire(std::move(*change_.take()));
    EXPECT_EQ(change_.state(), State::Idle);
  }
}

}  // namespace
}  // namespace docent::kiosk::change_over_test
