#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "runtime/guide/guide.h"
#include "runtime/scene/shown_list.h"
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
    nearest->object = -1;  // it hangs as a picture: the guide stands beside it, in view
    museum.pictures = {{.exhibit = static_cast<std::uint32_t>(nearest - museum.exhibits.begin()),
                        .image = static_cast<std::uint32_t>(museum.images.size() - 1)}};
    museum.cues = {{.begin = 2000, .end = 4000, .text = "It turns."},
                   {.begin = 6000, .end = 7000, .text = "It stands."}};
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
  Guide& guide() { return guide_; }
  const Guide& guide() const { return guide_; }

  /// What is drawn anew in some seconds of frames.
  struct Drawn {
    int models = 0, bodies = 0;
    float farthest = 0;  ///< The most that a joint moves from one frame to the next, metres.
  };
  Drawn draw(double seconds) {
    Drawn drawn;
    scene::ShownList shown;
    shown.keep(guide_.draw_list());
    std::vector<Vec3> before = guide_.draw_list().joint;
    for (int frame = 0; frame < std::lround(60 * seconds); ++frame) {
      run(1.0 / 60);
      const scene::DrawList& list = guide_.draw_list();
      const scene::Change change = shown.change(list, 1080);
      drawn.models += change.model || change.everything ? 1 : 0;
      drawn.bodies += change.bodies.any() ? 1 : 0;
      shown.keep(list, change);
      for (std::size_t j = 0; j < std::min(before.size(), list.joint.size()); ++j)
        drawn.farthest = std::max(drawn.farthest, glm::distance(before[j], list.joint[j]));
      before = list.joint;
    }
    return drawn;
  }

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

/// The caption that is read now; empty where none is.
std::string read_by(Guide& guide) {
  const interface::View& view = *guide.view();
  for (const interface::TimedText& cue : view.cues)
    for (const scene::Quad& quad : guide.draw_list().quads)
      if (quad.texture == cue.quad.texture && quad.rect.width > 0)
        return view.words[static_cast<std::size_t>(cue.words)].text;
  return {};
}

TEST(Watching, HasTheCaptionsReadAtTheirTimes) {
  Visitor visitor;
  visitor.tap("picture:next");
  std::vector<std::string> read;
  std::vector<float> changed;
  for (int frame = 0; frame < 9 * 60; ++frame) {
    visitor.run(1.0 / 60);
    const std::string now = read_by(visitor.guide());
    if (!read.empty() && now == read.back()) continue;
    read.push_back(now);
    changed.push_back(visitor.guide().video()->seconds);
  }

  ASSERT_EQ(read, (std::vector<std::string>{"", "It turns.", "", "It stands.", ""}));
  for (const auto& [at, seconds] : {std::pair{1U, 2.0F}, {2U, 4.0F}, {3U, 6.0F}, {4U, 7.0F}})
    EXPECT_NEAR(changed[at], seconds, 1.5 / 60);
}

/// Letters are drawn as large as their texture's part is, whatever rectangle they are given.
TEST(Watching, ShowsNoLetterOfACaptionBeforeItsTime) {
  Visitor visitor;
  visitor.tap("picture:next");
  visitor.run(1);
  ASSERT_EQ(read_by(visitor.guide()), "");

  for (const interface::TimedText& cue : visitor.guide().view()->cues)
    for (const scene::Quad& quad : visitor.guide().draw_list().quads)
      if (quad.texture == cue.quad.texture) {
        EXPECT_EQ(quad.uv.width, 0);
      }
}

TEST(Watching, KeepsTheCaptionOfAVideoThatIsStoppedAndHasNoneAtItsBeginning) {
  Visitor visitor;
  visitor.tap("picture:next");
  visitor.run(3);
  visitor.tap("video:stop");
  visitor.run(3);
  EXPECT_EQ(read_by(visitor.guide()), "It turns.");

  visitor.guide().video_ended();
  visitor.run(1);
  EXPECT_EQ(read_by(visitor.guide()), "");
}

/// Captions come and go without anything else being drawn.
TEST(Watching, DrawsNothingAnewButTheCaptionWhereOneChanges) {
  Visitor visitor;
  visitor.guide().spare_videos(true);
  visitor.tap("picture:next");
  visitor.run(1.8);
  const interface::TimedText cue = visitor.guide().view()->cues.front();
  scene::ShownList shown;
  shown.keep(visitor.guide().draw_list());
  visitor.run(0.3);
  const scene::Rect drawn = shown.change(visitor.guide().draw_list(), 1080).interface;

  EXPECT_EQ(read_by(visitor.guide()), "It turns.");
  EXPECT_GT(drawn.width, 0);
  EXPECT_LT(drawn.width, cue.ground.rect.width + 0.01F);
  EXPECT_LT(drawn.height, cue.ground.rect.height + 0.01F);
}

/// Where a machine has no time for more, the frames are the video's: of those in which nothing else
/// happens none draws the model.
TEST(Watching, LeavesTheVideoAllFramesWhereTheModelIsToBeSpared) {
  Visitor visitor;
  visitor.guide().spare_videos(true);
  EXPECT_GT(visitor.draw(8).bodies, 0) << "until a video plays the guide breathes";

  visitor.tap("picture:next");
  visitor.run(10);  // it ends what it does, and its card has come
  ASSERT_TRUE(visitor.guide().video());
  ASSERT_TRUE(visitor.guide().state().plays);
  const Visitor::Drawn drawn = visitor.draw(30);

  EXPECT_EQ(drawn.models, 0);
  EXPECT_EQ(drawn.bodies, 0);
  EXPECT_EQ(drawn.farthest, 0);
}

TEST(Watching, LetsTheGuideLiveWhereThereIsTime) {
  Visitor visitor;
  visitor.tap("picture:next");
  visitor.run(10);

  EXPECT_GT(visitor.draw(30).bodies, 30);
}

/// Nobody sees the guide jerk when it comes to rest, or when it lives on.
TEST(Watching, BringsTheGuideToRestAndBackToLifeWithoutAJerk) {
  Visitor lively;
  lively.tap("picture:next");
  const float at_most = lively.draw(40).farthest;
  Visitor visitor;
  visitor.tap("picture:next");
  visitor.run(3);
  visitor.guide().spare_videos(true);
  const float falling_asleep = visitor.draw(12).farthest;
  ASSERT_EQ(visitor.draw(1).bodies, 0);

  visitor.tap("video:stop");
  const Visitor::Drawn awake = visitor.draw(10);
  EXPECT_GT(awake.bodies, 0) << "it breathes on";
  EXPECT_LE(falling_asleep, at_most);
  EXPECT_LE(awake.farthest, at_most);
}

TEST(Watching, LetsTheGuideGoOnWhereAVisitorSendsItMeanwhile) {
  Visitor visitor;
  visitor.guide().spare_videos(true);
  visitor.tap("picture:next");
  visitor.run(12);
  ASSERT_EQ(visitor.draw(1).bodies, 0);

  visitor.tap("home");
  EXPECT_GT(visitor.draw(5).bodies, 0);
}

}  // namespace
}  // namespace docent::guide::watching_test
