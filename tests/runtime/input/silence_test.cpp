#include "runtime/input/silence.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>

#include "runtime/input/event_maker.h"
#include "runtime/input/hid_recording.h"
#include "tests/runtime/input/hid_bytes.h"
#include "tests/support/reference_data.h"

namespace docent::test::silence_test {
namespace {

using namespace std::chrono_literals;
using input::Contact;
using input::Silence;

constexpr Contact finger_at_rest{.id = 1, .x = 0.5F, .y = 0.5F};

/// A device that says `frames` times, every 10 ms, that a finger rests; returns when it ended.
std::chrono::nanoseconds rest(Silence& silence, std::uint32_t frames) {
  std::vector<Contact> before;
  std::chrono::nanoseconds time = 0ms;
  for (std::uint32_t i = 0; i < frames; ++i, time += 10ms) {
    const std::vector<Contact> now{finger_at_rest};
    silence.heard(before, now, time);
    before = now;
  }
  return time - 10ms;
}

TEST(Silence, LiftsWhatADeviceWithAScanTimeForgot) {
  Silence silence(true);
  const auto last = rest(silence, 1);

  EXPECT_FALSE(silence.lifts({&finger_at_rest, 1}, last + 499ms));
  EXPECT_TRUE(silence.lifts({&finger_at_rest, 1}, last + 500ms));
}

TEST(Silence, IsNothingWhereNoFingerIsDown) {
  Silence silence(true);
  rest(silence, 1);

  EXPECT_FALSE(silence.lifts({}, 10s));
}

TEST(Silence, LiftsWhatADeviceForgotThatWasHeardToRepeatItself) {
  Silence silence(false);
  const auto last = rest(silence, 1 + Silence::proof);

  EXPECT_TRUE(silence.reports_always());
  EXPECT_TRUE(silence.lifts({&finger_at_rest, 1}, last + 500ms));
}

TEST(Silence, OfADeviceThatReportsOnlyChangesIsAFingerThatRests) {
  Silence silence(false);
  Contact finger = finger_at_rest;
  std::vector<Contact> before;
  for (int i = 0; i < 100; ++i) {
    finger.x += 0.001F;
    const std::vector<Contact> now{finger};
    silence.heard(before, now, i * 10ms);
    before = now;
  }

  EXPECT_FALSE(silence.lifts(before, 1h));
}

TEST(Silence, IsTrustedNoMoreOnceAFingerComesBackToWhereItWasLifted) {
  Silence silence(true);
  const auto last = rest(silence, 1);
  ASSERT_TRUE(silence.lifts({&finger_at_rest, 1}, last + 500ms));

  silence.heard({}, {&finger_at_rest, 1}, last + 3s);
  EXPECT_FALSE(silence.lifts({&finger_at_rest, 1}, last + 1h));
}

TEST(Silence, IsStillTrustedWhenTheNextFingerComesElsewhere) {
  Silence silence(true);
  const auto last = rest(silence, 1);
  ASSERT_TRUE(silence.lifts({&finger_at_rest, 1}, last + 500ms));
  const Contact elsewhere{.id = 1, .x = 0.1F, .y = 0.1F};

  silence.heard({}, {&elsewhere, 1}, last + 3s);
  EXPECT_TRUE(silence.lifts({&elsewhere, 1}, last + 4s));
}

/// A Windows 8 screen whose last report is lost.
TEST(EventMaker, CancelsTheFingersOfAScreenThatFellSilent) {
  const auto descriptor = input::parse_report_descriptor(
      join({begin_touch_screen(1), finger(), contact_count(), scan_time(), end_collection()}));
  input::EventMaker maker(*descriptor, input::classify(*descriptor), 1000);

  const auto down = maker.take(bytes({1, 1, 7, 0, 0, 0, 0, 1, 1, 0}), 0ms);
  ASSERT_EQ(down.size(), 1U);
  EXPECT_EQ(down[0].contact.id, 1007U);
  EXPECT_TRUE(maker.wait(450ms).empty());
  const auto up = maker.wait(500ms);
  ASSERT_EQ(up.size(), 1U);
  EXPECT_EQ(up[0].kind, input::InputEvent::Kind::Cancel) << "no finger pressed anything";
  EXPECT_EQ(up[0].contact.id, 1007U);
  EXPECT_TRUE(maker.wait(10s).empty()) << "once";
  EXPECT_EQ(maker.take(bytes({1, 1, 7, 0, 0, 0, 0, 1, 2, 0}), 11s).size(), 1U) << "down again";
}

TEST(EventMaker, CancelsTheFingersOfAScreenThatIsPulledOut) {
  const auto descriptor = input::parse_report_descriptor(
      join({begin_touch_screen(1), finger(), contact_count(), scan_time(), end_collection()}));
  input::EventMaker maker(*descriptor, input::classify(*descriptor), 1000);
  maker.take(bytes({1, 1, 7, 0, 0, 0, 0, 1, 1, 0}), 0ms);

  const auto gone = maker.lift_all();
  ASSERT_EQ(gone.size(), 1U);
  EXPECT_EQ(gone[0].kind, input::InputEvent::Kind::Cancel);
  EXPECT_EQ(gone[0].contact.id, 1007U);
  EXPECT_TRUE(maker.lift_all().empty());
}

/// A finger whose device then finds it to be a palm, and one that is lifted in the same report.
TEST(EventMaker, CancelsAPalmAndNoOtherFinger) {
  const auto sure_finger =
      bytes({0x05, 0x0d, 0x09, 0x22, 0xa1, 0x02, 0x09, 0x42, 0x09, 0x47, 0x15, 0x00, 0x25,
             0x01, 0x75, 0x01, 0x95, 0x02, 0x81, 0x02, 0x95, 0x06, 0x81, 0x03, 0x75, 0x08,
             0x95, 0x01, 0x09, 0x51, 0x25, 0x7f, 0x81, 0x02, 0x05, 0x01, 0x26, 0xff, 0x7f,
             0x75, 0x10, 0x09, 0x30, 0x81, 0x02, 0x09, 0x31, 0x81, 0x02, 0xc0});
  const auto descriptor =
      input::parse_report_descriptor(join({begin_touch_screen(1), sure_finger, sure_finger,
                                           contact_count(), scan_time(), end_collection()}));
  input::EventMaker maker(*descriptor, input::classify(*descriptor), 1000);
  maker.take(bytes({1, 3, 7, 0, 0, 0, 0, 3, 8, 0, 0, 0, 0, 2, 1, 0}), 0ms);

  const auto events = maker.take(bytes({1, 1, 7, 0, 0, 0, 0, 2, 8, 0, 0, 0, 0, 2, 2, 0}), 10ms);
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(events[0].contact.id, 1007U);
  EXPECT_EQ(events[0].kind, input::InputEvent::Kind::Cancel);
  EXPECT_EQ(events[1].contact.id, 1008U);
  EXPECT_EQ(events[1].kind, input::InputEvent::Kind::Up);
}

TEST(EventMaker, TellsALateReaderOnlyWhereAFingerEndsUp) {
  using Moves = input::EventMaker::Moves;
  const auto descriptor =
      input::parse_report_descriptor(join({begin_touch_screen(1), finger(), end_collection()}));
  input::EventMaker maker(*descriptor, input::classify(*descriptor), 0);

  EXPECT_EQ(maker.take(bytes({1, 1, 0, 0, 0, 0, 0}), 0ms, Moves::Later).size(), 1U);
  EXPECT_TRUE(maker.take(bytes({1, 1, 0, 0xff, 0x3f, 0, 0}), 1ms, Moves::Later).empty());
  const auto moved = maker.take(bytes({1, 1, 0, 0xff, 0x7f, 0, 0}), 2ms, Moves::All);
  ASSERT_EQ(moved.size(), 1U);
  EXPECT_EQ(moved[0].contact.x, 1.F);
  maker.take(bytes({1, 1, 0, 0, 0, 0, 0}), 3ms, Moves::Later);
  EXPECT_EQ(maker.take(bytes({1, 0, 0, 0, 0, 0, 0}), 4ms, Moves::Later).size(), 1U)
      << "a finger that goes is told at once";
}

/// Plays a recording in its own time and waits as the reader thread does. Returns how often silence
/// lifted fingers of which one then went on where it was.
int silences_by_mistake(const input::HidRecording& recording) {
  const auto descriptor = input::parse_report_descriptor(recording.descriptor);
  input::EventMaker maker(*descriptor, input::classify(*descriptor, recording.id), 0);
  std::map<std::uint32_t, Contact> lifted;
  int mistakes = 0;
  for (std::size_t i = 0; i < recording.reports.size(); ++i) {
    if (i > 0)
      for (auto time = recording.times[i - 1] + 50ms; time < recording.times[i]; time += 50ms)
        for (const input::InputEvent& event : maker.wait(time))
          lifted[event.contact.id] = event.contact;
    for (const input::InputEvent& event : maker.take(recording.reports[i], recording.times[i])) {
      const auto known = lifted.find(event.contact.id);
      if (event.kind != input::InputEvent::Kind::Down || known == lifted.end()) continue;
      if (std::hypot(known->second.x - event.contact.x, known->second.y - event.contact.y) <
          0.01F) {
        ++mistakes;
        lifted.clear();
      }
    }
  }
  return mistakes;
}

TEST(EventMaker, LiftsNoRestingFingerOfTheReferenceDevicesMoreThanOnce) {
  NEEDS_REFERENCE_DATA("hid/mt");
  for (const auto& entry : std::filesystem::directory_iterator(reference_data() / "hid/mt")) {
    if (entry.path().extension() != ".hid") continue;
    std::stringstream text;
    text << std::ifstream(entry.path()).rdbuf();
    const auto recording = input::parse_hid_recording(text.str(), entry.path().string());
    ASSERT_TRUE(recording) << recording.error().what;
    EXPECT_LE(silences_by_mistake(*recording), 1) << entry.path();
  }
}

}  // namespace
}  // namespace docent::test::silence_test
