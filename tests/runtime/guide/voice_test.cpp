#include "runtime/guide/voice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "platform/sqlite/content_reader.h"
#include "runtime/guide/guide.h"
#include "tests/runtime/guide/simulated.h"
#include "tests/support/sample_database.h"
#include "tests/support/shipped_languages.h"

namespace docent::guide::voice_test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

/// Without sounds: where some languages had them, the others would be heard in one of those.
const Museum& museum() {
  static const Museum it = [] {
    Museum all =
        test::in_all_shipped_languages(sqlite::load_museum(test::sample_database()).value());
    all.speech.clear();
    return all;
  }();
  return it;
}

/// A line of what was said, as `docent --speech` writes it.
struct Line {
  double time = 0;
  std::string control, language, text;
  double ends = 0;
};

/// A visitor who hears and presses keys, and sees nothing: all that is known here is `heard`.
class Listener {
 public:
  Listener() : planner_(museum(), {test::boxes, {}}), guide_(museum(), planner_, settings()) {
    run(0.1);
  }

  void run(double seconds) {
    constexpr Seconds frame{1.0F / 60};
    for (long i = 0; i < std::lround(seconds * 60); ++i) {
      planner_.wait();
      guide_.step(frame);
      while (guide_.take_pieces() != nullptr) continue;
      time_ += 1.0 / 60;
      if (const Saying* saying = guide_.voice().saying(); saying != nullptr && saying->utterance)
        heard.push_back({time_, std::string(saying->control), saying->utterance->language,
                         interface::text_of(*saying->utterance),
                         time_ + static_cast<double>(seconds_of(*saying->utterance))});
    }
  }
  void press(input::Key key) {
    ++presses;
    guide_.touch({.kind = input::InputEvent::Kind::KeyDown, .contact = {}, .key = key});
  }
  /// Listens until something is said that holds the text; false where that does not come.
  bool hears(std::string_view text, double patience = 240) {
    const auto has_come = [&] {
      for (; listened_ < heard.size(); ++listened_)
        if (heard[listened_].text.find(text) != std::string::npos) return true;
      return false;
    };
    for (double waited = 0; waited < patience; waited += 0.25) {
      if (has_come()) return true;
      run(0.25);
    }
    return has_come();
  }
  /// Likewise, and not of what collects it, which is said with its name, too, behind what it does.
  bool hears_itself(std::string_view name) {
    while (hears(name)) {
      if (!heard[listened_].control.starts_with("collect:")) return true;
      ++listened_;
    }
    return false;
  }
  /// Presses the key that chooses when a control of that label has been said.
  bool chooses(std::string_view label) {
    constexpr double reaction = 0.8;
    if (!hears_itself(label)) return false;
    run(heard[listened_++].ends + reaction - time_);
    press(input::Key::Enter);
    return true;
  }
  const std::string& last() const { return heard.back().text; }

  Guide& guide() { return guide_; }
  std::vector<Line> heard;
  std::size_t presses = 0;

 private:
  static GuideSettings settings() {
    return {.shape = {.width = 1920, .height = 1080}, .idle_reset = Seconds{60}};
  }
  plan::Planner planner_;
  Guide guide_;
  double time_ = 0;
  std::size_t listened_ = 0;
};

std::string said_as(std::uint32_t language, std::string_view text) {
  interface::Utterance said{.language = museum().languages[language].tag, .pieces = {}};
  interface::append_spoken(said, text);
  return said.pieces.front().text;
}

std::string word_in(std::uint32_t language, std::string_view key) {
  return said_as(language, interface::word(museum(), language, key));
}

/// How many touches a seeing visitor needs for the same.
std::size_t touches_of_who_sees(std::uint32_t language, std::uint32_t exhibit) {
  interface::InterfaceState state;
  std::size_t count = 0;
  const std::uint32_t per_page = interface::exhibits_per_page({.width = 1920, .height = 1080});
  for (const std::string& name : {"language:" + museum().languages[language].tag,
                                  std::string("begin"), "exhibit:" + museum().exhibits[exhibit].id,
                                  std::string("route:skeleton"), std::string("home")}) {
    const auto touches = interface::touches_to(museum(), state, per_page, name);
    EXPECT_FALSE(touches.empty()) << name;
    count += touches.size();
    for (const interface::Control& touch : touches) state = interface::after(state, touch.action);
  }
  return count;
}

class ClosedEyes : public testing::TestWithParam<std::size_t> {};

TEST_P(ClosedEyes, MakeAWholeVisitByTheTranscriptAlone) {
  const auto language = static_cast<std::uint32_t>(GetParam());
  constexpr std::uint32_t exhibit = 3;
  const auto title = said_as(
      language, interface::in_language(museum(), language, museum().exhibits[exhibit].title));
  const auto text = said_as(
      language, interface::in_language(museum(), language, museum().exhibits[exhibit].text));
  Listener visitor;

  visitor.guide().headphones(true);
  ASSERT_TRUE(visitor.hears(word_in(0, "help_keys")));
  ASSERT_TRUE(visitor.chooses(museum().languages[language].name));
  ASSERT_TRUE(visitor.chooses(word_in(language, "say_begin")));
  ASSERT_TRUE(visitor.chooses(word_in(language, "route_skeleton")));
  ASSERT_TRUE(visitor.chooses(title));
  ASSERT_TRUE(visitor.hears(word_in(language, "follow")));
  EXPECT_EQ(visitor.guide().state().kind, RouteKind::Skeleton);
  ASSERT_TRUE(visitor.hears(text));
  const std::size_t at_goal = visitor.heard.size();
  ASSERT_TRUE(visitor.chooses(word_in(language, "home")));
  ASSERT_TRUE(visitor.hears(word_in(language, "welcome")));

  EXPECT_LE(visitor.presses, 2 * touches_of_who_sees(language, exhibit));
  EXPECT_GT(at_goal, 0U);
  for (std::size_t i = visitor.heard.size(); i-- > at_goal;)
    EXPECT_EQ(visitor.heard[i].language == museum().languages[language].tag ||
                  visitor.heard[i].control.starts_with("language:"),
              true);
}

INSTANTIATE_TEST_SUITE_P(InEveryLanguage, ClosedEyes,
                         testing::Range<std::size_t>(0, test::shipped_languages.size()));

TEST(Voice, IsSilentUntilSomebodyWantsToHear) {
  Listener visitor;
  visitor.press(input::Key::Down);
  visitor.press(input::Key::VolumeUp);
  visitor.run(3);
  EXPECT_THAT(visitor.heard, IsEmpty());

  visitor.press(input::Key::Help);
  visitor.run(0.2);
  ASSERT_EQ(visitor.heard.size(), 1U);
  EXPECT_THAT(visitor.last(), HasSubstr("Press the Enter key"));
}

TEST(Voice, SaysWhatTheFocusComesToInTheSameFrame) {
  Listener visitor;
  visitor.press(input::Key::Help);
  visitor.run(0.2);
  visitor.press(input::Key::Down);
  visitor.run(1.0 / 60);

  EXPECT_THAT(visitor.last(), StartsWith("Begin. button"));
  const std::size_t said = visitor.heard.size();
  visitor.run(20);
  EXPECT_EQ(visitor.heard.size(), said);  // who goes by themselves is read to no further
}

TEST(Voice, IsLouderFasterAndSaysItAgainByKeys) {
  Listener visitor;
  visitor.press(input::Key::Help);
  visitor.run(0.2);
  visitor.press(input::Key::Down);
  visitor.run(0.2);
  const std::string control = visitor.last();

  visitor.press(input::Key::VolumeUp);
  visitor.run(0.2);
  EXPECT_EQ(visitor.last(), "Volume 6.");
  for (int i = 0; i < 12; ++i) visitor.press(input::Key::VolumeUp);
  visitor.run(0.2);
  EXPECT_EQ(visitor.last(), "Volume 10.");
  EXPECT_EQ(visitor.guide().voice().volume(), 10U);
  visitor.press(input::Key::Right);
  visitor.run(0.2);
  EXPECT_EQ(visitor.last(), "Faster.");
  EXPECT_EQ(visitor.guide().voice().speed(), 1.25F);
  visitor.press(input::Key::Left);
  visitor.run(0.2);
  EXPECT_EQ(visitor.last(), control);
  visitor.press(input::Key::Help);
  visitor.run(0.2);
  EXPECT_THAT(visitor.last(), StartsWith("This is the welcome screen"));

  visitor.guide().headphones(true);
  visitor.guide().headphones(false);
  visitor.run(0.2);
  EXPECT_EQ(visitor.last(), "Reading aloud is off.");
  EXPECT_EQ(visitor.guide().voice().volume(), interface::usual_volume);
  EXPECT_EQ(visitor.guide().voice().speed(), 1.0F);
  EXPECT_EQ(visitor.guide().state(), interface::InterfaceState{});
}

TEST(Voice, IsBackToNormalForTheNextVisitor) {
  Listener visitor;
  visitor.press(input::Key::Help);
  visitor.run(0.2);
  visitor.press(input::Key::VolumeDown);
  visitor.press(input::Key::Enter);
  visitor.run(0.2);
  ASSERT_EQ(visitor.guide().state().screen, interface::Screen::Choosing);
  visitor.press(input::Key::Down);
  visitor.run(120);

  EXPECT_EQ(visitor.guide().state(), interface::InterfaceState{});
  EXPECT_EQ(visitor.guide().voice().volume(), interface::usual_volume);
}

TEST(Voice, WaitsForWhoeverPlaysIt) {
  Listener visitor;
  visitor.guide().heard(false);
  visitor.press(input::Key::Help);
  visitor.run(1);
  for (int i = 0; i < 40; ++i) {
    visitor.guide().heard(true);
    visitor.run(1);
  }
  EXPECT_EQ(visitor.heard.size(), 1U);
  visitor.guide().heard(false);
  visitor.run(2);
  EXPECT_EQ(visitor.heard.size(), 2U);
}

}  // namespace
}  // namespace docent::guide::voice_test
