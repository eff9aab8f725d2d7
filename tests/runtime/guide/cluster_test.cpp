// Discs of the model that would cover each other are one that opens.
#include <gtest/gtest.h>

#include <algorithm>

#include "platform/sqlite/content_reader.h"
#include "runtime/guide/guide.h"
#include "runtime/guide/label_placement.h"
#include "tests/runtime/guide/simulated.h"
#include "tests/support/sample_database.h"

namespace docent::guide::cluster_test {
namespace {

/// The sample museum with 300 exhibits, a dozen where one was.
const Museum& crowded_museum() {
  static const Museum it = [] {
    Museum museum = sqlite::load_museum(test::sample_database()).value();
    const std::vector<Exhibit> originals = museum.exhibits;
    while (museum.exhibits.size() < 300) {
      const std::size_t n = museum.exhibits.size();
      Exhibit one = originals[n % originals.size()];
      one.id += "-" + std::to_string(n);
      one.placement.position += Vec2{0.2 * static_cast<double>(n / originals.size()), 0.3};
      museum.exhibits.push_back(std::move(one));
    }
    return museum;
  }();
  return it;
}

struct Kiosk {
  Kiosk() { run(1); }
  void run(double seconds) { test::run(planner, guide, seconds); }
  void touch(float x, float y) {
    guide.touch({.kind = input::InputEvent::Kind::Down, .contact = {1, x, y}});
    run(0.05);
    guide.touch({.kind = input::InputEvent::Kind::Up, .contact = {1, x, y}});
    run(0.05);
  }
  void touch(const scene::Rect& at) { touch(at.x + at.width / 2, at.y + at.height / 2); }
  const interface::View& view() const { return *guide.view(); }
  /// A label that stands for several.
  std::int32_t head() const {
    const auto& labels = view().labels;
    const auto it = std::ranges::find_if(labels, [](const auto& one) { return one.held > 0; });
    return it == labels.end() ? -1 : static_cast<std::int32_t>(it - labels.begin());
  }
  const scene::Rect& rect_of(std::int32_t label) const {
    const std::int32_t control = view().labels[static_cast<std::size_t>(label)].control;
    return view().controls[static_cast<std::size_t>(control)].rect;
  }

  GuideSettings settings{.shape = {.width = 1920, .height = 1080, .text_scale = 1.4F}};
  plan::Planner planner{crowded_museum(), {test::boxes, {}}};
  Guide guide{crowded_museum(), planner, settings};
};

TEST(ACluster, OpensByATouchAndEachExhibitInItCanBeChosen) {
  Kiosk kiosk;
  const std::int32_t head = kiosk.head();
  ASSERT_GE(head, 0) << "300 exhibits have no room for a disc each";

  kiosk.touch(kiosk.rect_of(head));
  EXPECT_EQ(kiosk.guide.state().screen, interface::Screen::Welcome) << "nothing is chosen yet";
  ASSERT_EQ(kiosk.view().open, head);
  EXPECT_GT(kiosk.view().cluster.width, 0);
  const auto& labels = kiosk.view().labels;
  const auto member = std::ranges::find(labels, head, &interface::FloorLabel::head);
  ASSERT_NE(member, labels.end());
  const auto control = static_cast<std::size_t>(member->control);
  const std::uint32_t exhibit = kiosk.view().controls[control].action.argument;

  kiosk.touch(kiosk.view().controls[control].rect);
  EXPECT_EQ(kiosk.guide.state().exhibit, exhibit);
}

TEST(ACluster, IsPutAwayByATouchBesideItAndByTime) {
  Kiosk kiosk;
  const std::int32_t head = kiosk.head();
  ASSERT_GE(head, 0);
  const scene::Rect at = kiosk.rect_of(head);

  kiosk.touch(at);
  ASSERT_EQ(kiosk.view().open, head);
  kiosk.touch(0.05F, 0.05F);
  EXPECT_EQ(kiosk.view().open, -1);
  EXPECT_EQ(kiosk.guide.state().screen, interface::Screen::Welcome) << "and nothing else";
  EXPECT_EQ(kiosk.rect_of(head), at) << "all is where it was";

  kiosk.touch(at);
  ASSERT_EQ(kiosk.view().open, head);
  kiosk.run(21);
  EXPECT_EQ(kiosk.view().open, -1);
}

TEST(ACluster, LeavesNoExhibitWithoutADiscOfItsOwnOrOne) {
  Kiosk kiosk;
  for (const interface::FloorLabel& label : kiosk.view().labels)
    if (label.on_disc && label.anchor_x >= 0) {
      EXPECT_NE(label.rect.width > 0, label.head >= 0);
    }
}

}  // namespace
}  // namespace docent::guide::cluster_test
