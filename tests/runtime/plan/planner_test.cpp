#include "runtime/plan/planner.h"

#include <gmock/gmock.h>

#include <new>

#include "tests/support/sample_museum.h"

namespace docent::plan::planner_test {
namespace {

interface::ViewRequest welcome(std::uint64_t id) {
  return {.id = id, .state = {}, .shape = {.width = 640, .height = 360}, .route_summary = {}};
}

TEST(APlanner, WhoseTypeSetterRunsOutOfMemoryOnceGoesOnWithTheNextView) {
  const Museum museum = test::sample_museum_without_walls();
  bool has_memory = false;
  const interface::SetText set_text = [&](const interface::TextStyle&, std::string_view,
                                          std::uint32_t width) {
    if (!has_memory) throw std::bad_alloc();
    return interface::TextBitmap{.width = width, .height = 8, .lines = 1, .coverage = {}};
  };
  Planner planner(museum, {set_text, {}});

  testing::internal::CaptureStderr();
  planner.ask(welcome(1));
  planner.wait();
  EXPECT_EQ(planner.take_view(), nullptr);
  EXPECT_THAT(testing::internal::GetCapturedStderr(), testing::HasSubstr("planning failed"));

  has_memory = true;
  planner.ask(welcome(2));
  planner.wait();
  const std::unique_ptr<interface::View> view = planner.take_view();
  ASSERT_NE(view, nullptr);
  EXPECT_EQ(view->request, 2U);
}

TEST(APlanner, LetsTheMakersOfPiecesRestOnceTheGlassIsNobodys) {
  const Museum museum = test::sample_museum_without_walls();
  int rests = 0;
  const interface::SetText set_text = [](const interface::TextStyle&, std::string_view,
                                         std::uint32_t) { return interface::TextBitmap{}; };
  Planner planner(museum, {set_text, {}, [&rests] { ++rests; }});
  const auto ask = [&planner](interface::Screen screen) {
    interface::ViewRequest request = welcome(1);
    request.state.screen = screen;
    planner.ask(request);
    planner.wait();
  };

  ask(interface::Screen::Choosing);
  EXPECT_EQ(rests, 0);
  ask(interface::Screen::Welcome);
  EXPECT_EQ(rests, 1);
}

}  // namespace
}  // namespace docent::plan::planner_test
