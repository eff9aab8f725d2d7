#include <gtest/gtest.h>

#include <algorithm>

#include "runtime/guide/guide.h"
#include "tests/runtime/guide/simulated.h"
#include "tests/support/sample_as_read.h"

namespace docent::guide::watching_test {
namespace {

/// The sample museum; the nearest exhibit's second picture is a video.
struct MuseumWithVideo {
  MuseumWithVideo() {
    museum.images.push_back(
        {.name = "images/turning.webm", .width = 320, .height = 180, .bytes = {}});
    const auto nearest = std::ranges::min_element(museum.exhibits, {}, [&](const Exhibit& e) {
      return e.floor != museum.kiosk_floor
                 ? 1e9
                 : glm::distance(e.viewing_point.position, museum.kiosk.position);
    });
    exhibit = nearest->id;
    museum.pictures = {{.exhibit = static_cast<std::uint32_t>(nearest - museum.exhibits.begin()),
                        .image = static_cast<std::uint32_t>(museum.images.size() - 1)}};
  }
  Museum museum = test::sample_museum();
  std::string exhibit;
};

Pixels grey(std::uint32_t, std::uint32_t width, std::uint32_t height) {
  return {width, height, std::vector<std::byte>(std::size_t{4} * width * height, std::byte{128})};
}

/// A visitor of that museum, in simulated time, who has been led to the exhibit.
class Visitor {
 public:
  explicit Visitor(interface::SetPicture set_picture = grey)
      : planner_(museum_.museum, {test::boxes, std::move(set_picture)}),
        guide_(museum_.museum, planner_,
               {.shape = {.width = 1920, .height = 1080}, .idle_reset = Seconds{20}}) {
    run(0.1);
    tap("begin");
    tap("exhibit:" + museum_.exhibit);
    run_until_there();
  }
  void run(double seconds) { test::run(planner_, guide_, seconds); }
  void tap(std::string_view name) { test::tap(planner_, guide_, name); }
  void run_until_there() {
    for (int i = 0; i < 120 && !guide_.state().arrived; ++i) run(1);
    run(0.1);
    ASSERT_TRUE(guide_.state().arrived);
  }
  const Guide& guide() const { return guide_; }

 private:
  MuseumWithVideo museum_;
  plan::Planner planner_;
  Guide guide_;
};

TEST(Watching, BeginsWhereAVisitorLeafsToAVideo) {
  Visitor visitor;
  EXPECT_FALSE(visitor.guide().video());

  visitor.tap("picture:next");
  visitor.run(1);

  ASSERT_TRUE(visitor.guide().video());
  EXPECT_GT(visitor.guide().video()->seconds, 0.5F);
  const interface::View& view = *visitor.guide().view();
  const auto shown =
      std::ranges::find(view.elements, view.video,
                        [](const interface::Element& element) { return element.quad.texture; });
  ASSERT_NE(shown, view.elements.end());
  EXPECT_EQ(shown->quad.fill, scene::QuadFill::Image);
}

TEST(Watching, TakesNobodysTimeWhereThePictureIsNotThere) {
  Visitor visitor{{}};

  visitor.tap("picture:next");
  visitor.run(1);

  EXPECT_EQ(visitor.guide().view()->video, scene::TextureId::None);
  EXPECT_FALSE(visitor.guide().video());
  visitor.run(25);
  EXPECT_TRUE(visitor.guide().is_vacant()) << "a glass that nobody touches is made ready";
}

TEST(Watching, DoesNotBeginForWhoeverComesBack) {
  Visitor visitor;
  visitor.tap("picture:next");
  visitor.run(0.5);
  visitor.tap("home");
  visitor.tap("resume");
  visitor.run_until_there();

  ASSERT_TRUE(visitor.guide().video()) << "the same picture is there";
  EXPECT_FALSE(visitor.guide().state().plays);
  EXPECT_EQ(visitor.guide().video()->seconds, 0);
}

}  // namespace
}  // namespace docent::guide::watching_test
