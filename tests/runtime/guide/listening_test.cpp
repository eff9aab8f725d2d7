#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "runtime/guide/guide.h"
#include "tests/runtime/guide/simulated.h"
#include "tests/support/sample_as_read.h"

namespace docent::guide::listening_test {
namespace {

constexpr std::string_view title = "The bell is struck";

/// The sample museum; at the nearest exhibit one listens to two sounds, of eight and three seconds.
struct MuseumWithSounds {
  MuseumWithSounds() {
    const auto nearest = std::ranges::min_element(museum.exhibits, {}, [&](const Exhibit& e) {
      return e.floor != museum.kiosk_floor
                 ? 1e9
                 : glm::distance(e.viewing_point.position, museum.kiosk.position);
    });
    exhibit = nearest->id;
    const auto of_it = static_cast<std::uint32_t>(nearest - museum.exhibits.begin());
    museum.sounds = {
        {.exhibit = of_it, .title = {{"en", std::string(title)}}, .description = {{"en", "Deep."}}},
        {.exhibit = of_it, .title = {{"en", "A lute"}}, .description = {{"en", "Quick."}}}};
    museum.sound_cues = {{.begin = 0, .end = 2000, .text = "[A bell]"},
                         {.begin = 6000, .end = 8000, .text = "[It dies away]"}};
    std::erase_if(museum.speech, is_recording);
    for (const std::uint32_t sound : {0U, 1U})
      museum.speech.push_back({.language = 0,
                               .text = std::string(RecordingKey(sound).text()),
                               .made_of = {},
                               .skip = 0,
                               .samples = (sound == 0 ? 8 : 3) * SpeechSound::rate,
                               .packets = {}});
    std::ranges::sort(museum.speech, {},
                      [](const SpeechSound& one) { return std::pair(one.language, one.text); });
  }
  Museum museum = test::sample_museum();
  std::string exhibit;
};

/// A visitor of that museum, in simulated time, who has been led to the exhibit.
class Visitor {
 public:
  explicit Visitor(bool can_sound = true)
      : planner_(museum_.museum, {test::boxes, {}}),
        guide_(museum_.museum, planner_,
               {.shape = {.width = 1920, .height = 1080},
                .idle_reset = Seconds{20},
                .can_sound = can_sound}) {
    run(0.1);
    tap("begin");
    tap("exhibit:" + museum_.exhibit);
    for (int i = 0; i < 120 && !guide_.state().arrived; ++i) run(1);
    run(0.1);
  }
  void run(double seconds) { test::run(planner_, guide_, seconds); }
  void tap(std::string_view name) { test::tap(planner_, guide_, name); }
  void press(input::Key key) {
    guide_.touch({.kind = input::InputEvent::Kind::KeyDown, .contact = {}, .key = key});
    run(1.0 / 60);
  }
  /// Moves the focus to a control, by keys.
  void go_to(std::string_view name) {
    for (int i = 0; i < 40; ++i) {
      press(input::Key::Down);
      if (focus() == name) return;
    }
    FAIL() << name << " is not reached";
  }
  std::string_view focus() const {
    const Saying* said = guide_.voice().saying();
    if (said != nullptr) said_ = std::string(said->control);
    return said_;
  }
  bool has(std::string_view name) const {
    return std::ranges::find(guide_.view()->controls, name, &interface::Control::name) !=
           guide_.view()->controls.end();
  }
  std::string label_of(std::string_view name) const {
    const auto found = std::ranges::find(guide_.view()->controls, name, &interface::Control::name);
    return found == guide_.view()->controls.end() ? "" : found->label.at("en");
  }
  bool reads(std::string_view text) const {
    return std::ranges::any_of(guide_.view()->words, [&](const interface::Words& words) {
      return words.text.find(text) != std::string::npos;
    });
  }
  /// The caption on the glass; empty where none is.
  std::string caption() {
    const interface::View& view = *guide_.view();
    for (const interface::TimedText& cue : view.cues)
      for (const scene::Quad& quad : guide_.draw_list().quads)
        if (quad.texture == cue.quad.texture && quad.rect.width > 0)
          return view.words[static_cast<std::size_t>(cue.words)].text;
    return {};
  }
  Guide& guide() { return guide_; }

 private:
  MuseumWithSounds museum_;
  plan::Planner planner_;
  Guide guide_;
  mutable std::string said_;
};

TEST(Listening, BeginsByATouchAndEndsBySelfWithItsCaptionsReadMeanwhile) {
  Visitor visitor;
  EXPECT_FALSE(visitor.guide().sound());
  EXPECT_EQ(visitor.label_of("sound:1"), "Listen: The bell is struck");

  visitor.tap("sound:1");
  ASSERT_TRUE(visitor.guide().sound()) << "in the frame of the touch";
  visitor.run(1);

  EXPECT_EQ(visitor.label_of("sound:1"), "Stop: The bell is struck");
  EXPECT_EQ(visitor.caption(), "[A bell]");
  visitor.run(2);
  EXPECT_EQ(visitor.caption(), "");
  visitor.run(4);
  EXPECT_EQ(visitor.caption(), "[It dies away]");
  visitor.run(2);
  EXPECT_FALSE(visitor.guide().sound());
  EXPECT_EQ(visitor.caption(), "");
  EXPECT_EQ(visitor.label_of("sound:1"), "Listen: The bell is struck");
}

TEST(Listening, EndsByASecondTouchAndBeginsAnewByTheNext) {
  Visitor visitor;
  visitor.tap("sound:1");
  visitor.run(3);
  visitor.tap("sound:1");
  EXPECT_FALSE(visitor.guide().sound());

  visitor.tap("sound:1");
  ASSERT_TRUE(visitor.guide().sound());
  EXPECT_LT(visitor.guide().sound()->seconds, 0.1F);
}

TEST(Listening, IsToOneSoundAtATime) {
  Visitor visitor;
  visitor.tap("sound:1");
  const auto first = visitor.guide().sound()->number;
  visitor.run(1);
  visitor.tap("sound:2");

  ASSERT_TRUE(visitor.guide().sound());
  EXPECT_NE(visitor.guide().sound()->number, first);
  EXPECT_EQ(visitor.guide().sound()->sound, 1U);
  visitor.run(3.5);
  EXPECT_FALSE(visitor.guide().sound()) << "of three seconds";
}

TEST(Listening, EndsWithTheCardOnWhichItBegan) {
  for (const char* leaves : {"home", "choose", "language:zh"}) {
    Visitor visitor;
    visitor.tap("sound:1");
    ASSERT_TRUE(visitor.guide().sound());
    visitor.tap(leaves);
    EXPECT_FALSE(visitor.guide().sound()) << leaves;
  }
  Visitor visitor;
  visitor.tap("sound:1");
  visitor.tap("larger");
  EXPECT_TRUE(visitor.guide().sound()) << "larger letters take nothing away";
}

TEST(Listening, DoesNotCountAsBeingAway) {
  Visitor visitor;
  visitor.run(14);
  visitor.tap("sound:1");
  visitor.run(8);
  EXPECT_FALSE(visitor.guide().state().asks_to_stay);
  visitor.run(25);
  EXPECT_TRUE(visitor.guide().is_vacant()) << "a glass that nobody touches is made ready";
}

TEST(Listening, IsOfferedNowhereWhereNothingCanBeHeardAndIsReadInstead) {
  Visitor visitor(false);

  EXPECT_FALSE(visitor.has("sound:1"));
  EXPECT_TRUE(visitor.reads(title));
  EXPECT_TRUE(visitor.reads("Deep."));
  EXPECT_TRUE(visitor.reads("[It dies away]"));

  visitor.guide().can_sound(true);  // somebody plugs the loudspeaker in
  visitor.run(0.2);
  EXPECT_TRUE(visitor.has("sound:1"));
  EXPECT_FALSE(visitor.reads("[It dies away]"));
}

TEST(Listening, GoesOnByTheClockWhereTheLoudspeakerIsPulledOutAndIsThenOfferedNoMore) {
  Visitor visitor;
  visitor.tap("sound:1");
  visitor.run(1);
  for (int i = 0; i < 6 * 60; ++i) {
    visitor.guide().can_sound(false);
    visitor.run(1.0 / 60);
  }
  EXPECT_EQ(visitor.caption(), "[It dies away]");

  visitor.run(3);
  visitor.guide().can_sound(false);
  visitor.run(0.2);
  EXPECT_FALSE(visitor.has("sound:1"));
}

TEST(Listening, IsLouderAndSofterByTheKeysWithoutAWord) {
  Visitor visitor;
  const std::size_t before = visitor.guide().voice().volume();
  visitor.press(input::Key::VolumeUp);
  EXPECT_EQ(visitor.guide().voice().volume(), before) << "nothing sounds";
  visitor.tap("sound:1");
  visitor.press(input::Key::VolumeUp);
  visitor.press(input::Key::VolumeUp);
  visitor.press(input::Key::VolumeDown);
  EXPECT_EQ(visitor.guide().voice().volume(), before + 1);
  EXPECT_TRUE(visitor.guide().sound());

  visitor.tap("home");
  EXPECT_EQ(visitor.guide().voice().volume(), before) << "for the next visitor";
}

/// What somebody hears who sees nothing: one thing at a time.
TEST(Listening, WithClosedEyesIsToTheSoundAloneUntilItEnds) {
  Visitor visitor;
  visitor.guide().headphones(true);
  visitor.run(0.2);
  visitor.go_to("sound:1");
  ASSERT_NE(visitor.guide().voice().saying(), nullptr);
  EXPECT_EQ(interface::text_of(*visitor.guide().voice().saying()->utterance),
            "Listen. The bell is struck. button.");

  visitor.press(input::Key::Enter);
  ASSERT_TRUE(visitor.guide().sound());
  for (int i = 0; i < 8 * 60; ++i) {
    visitor.run(1.0 / 60);
    const Saying* said = visitor.guide().voice().saying();
    ASSERT_TRUE(said == nullptr || said->utterance == nullptr)
        << interface::text_of(*said->utterance);
  }
  ASSERT_TRUE(visitor.guide().sound());

  std::string after;
  for (int i = 0; i < 60 && after.empty(); ++i) {
    visitor.run(1.0 / 60);
    const Saying* said = visitor.guide().voice().saying();
    if (said != nullptr && said->utterance != nullptr) after = interface::text_of(*said->utterance);
  }
  EXPECT_EQ(after, "Listen. The bell is struck. button.") << "where they are, now that it is over";
}

TEST(Listening, WithClosedEyesEndsForWhateverIsSaid) {
  for (const auto key : {input::Key::Enter, input::Key::Down, input::Key::Left, input::Key::Help,
                         input::Key::Right, input::Key::Back}) {
    Visitor visitor;
    visitor.guide().headphones(true);
    visitor.run(0.2);
    visitor.go_to("sound:1");
    visitor.press(input::Key::Enter);
    visitor.run(1);
    ASSERT_TRUE(visitor.guide().sound());

    visitor.press(key);
    visitor.run(0.1);
    EXPECT_FALSE(visitor.guide().sound()) << static_cast<int>(key);
  }
}

TEST(Listening, IsForNobodyOnASharedGlass) {
  MuseumWithSounds museum;
  const GuideSettings settings{.shape = {.width = 3840, .height = 2160, .diagonal_inches = 55},
                               .visitors = 4,
                               .can_sound = true};
  const PlannerSize size = planner_size(museum.museum, settings);
  plan::Planner planner(museum.museum, {test::boxes, {}}, size.avatars, size.parts);
  Guide guide(museum.museum, planner, settings);
  ASSERT_GT(guide.seats(), 1U);
  test::run(planner, guide, 0.2);

  for (std::size_t part = 0; part <= guide.seats(); ++part)
    EXPECT_FALSE(guide.state(part).can_sound);
}

}  // namespace
}  // namespace docent::guide::listening_test
