#include "runtime/guide/captions.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <string>

#include "runtime/guide/guide.h"
#include "tests/runtime/guide/simulated.h"
#include "tests/support/sample_as_read.h"

namespace docent::guide::captions_test {
namespace {

GuideSettings settings() {
  return {.shape = {.width = 1280, .height = 720}};
}

struct Listener {
  Listener()
      : planner(test::sample_museum(), {test::boxes, {}},
                planner_size(test::sample_museum(), settings()).avatars,
                planner_size(test::sample_museum(), settings()).parts),
        guide(test::sample_museum(), planner, settings()) {
    test::run(planner, guide, 0.2);
  }
  /// What of the caption is on the glass.
  std::string shown() const {
    std::string text;
    if (guide.caption() == nullptr) return text;
    for (const interface::OnGlass& item : guide.on_glass())
      if (item.role == "text") text = item.label;  // the caption comes last
    return text;
  }
  plan::Planner planner;
  Guide guide;
};

TEST(Captions, ShowWhatIsSaidWhileItSounds) {
  Listener visitor;
  EXPECT_EQ(visitor.guide.caption(), nullptr) << "nobody is read to";
  const std::size_t silent = visitor.guide.draw_list().quads.size();

  visitor.guide.headphones(true);
  std::string said, shown;
  for (int i = 0; i < 60; ++i) {
    test::run(visitor.planner, visitor.guide, 1.0 / 60);
    const Saying* saying = visitor.guide.voice().saying();
    if (saying != nullptr && saying->utterance != nullptr)
      said = interface::text_of(*saying->utterance);
    if (visitor.guide.caption() != nullptr) shown = visitor.shown();
  }
  ASSERT_FALSE(said.empty());
  ASSERT_FALSE(shown.empty());
  EXPECT_TRUE(said.starts_with(shown)) << shown << " of " << said;
  EXPECT_GT(visitor.guide.draw_list().quads.size(), silent);

  visitor.guide.headphones(false);
  test::run(visitor.planner, visitor.guide, 20);
  EXPECT_EQ(visitor.guide.caption(), nullptr);
}

TEST(Captions, TurnTheirPagesAsALongTextGoesOn) {
  Listener visitor;
  visitor.guide.headphones(true);
  std::vector<std::string> pages;
  for (int i = 0; i < 60 * 90; ++i) {
    test::run(visitor.planner, visitor.guide, 1.0 / 60);
    const std::string now = visitor.shown();
    if (!now.empty() && (pages.empty() || pages.back() != now)) pages.push_back(now);
  }

  EXPECT_GT(pages.size(), 5U) << "it reads on from control to control";
}

}  // namespace
}  // namespace docent::guide::captions_test
