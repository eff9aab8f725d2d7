#include "runtime/input/contact_decoder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/input/hid_device_kind.h"
#include "tests/runtime/input/hid_bytes.h"

namespace docent::test::contact_decoder_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

MATCHER_P3(FingerAt, id, x, y, "") {
  return arg.id == static_cast<std::uint32_t>(id) && std::abs(arg.x - x) < 1e-4 &&
         std::abs(arg.y - y) < 1e-4;
}

input::ContactDecoder decoder_for(const std::vector<std::byte>& descriptor_bytes) {
  const auto descriptor = input::parse_report_descriptor(descriptor_bytes);
  const auto layout = input::find_touch_screen(*descriptor);
  return {*descriptor, *layout};
}

/// Two fingers a report and a count.
input::ContactDecoder hybrid_screen() {
  return decoder_for(
      join({begin_touch_screen(1), finger(), finger(), contact_count(), end_collection()}));
}

TEST(Contacts, OneFingerAtTheCentreOfTheGlass) {
  input::ContactDecoder screen = hybrid_screen();

  EXPECT_TRUE(screen.take(bytes({1, 1, 7, 0x00, 0x40, 0x00, 0x40, 0, 0, 0, 0, 0, 0, 1})));
  EXPECT_THAT(screen.contacts(), ElementsAre(FingerAt(7, 0.5F, 0.5F)));
}

TEST(Contacts, AFrameOfThreeFingersSpansTwoReports) {
  input::ContactDecoder screen = hybrid_screen();

  EXPECT_FALSE(screen.take(bytes({1, 1, 0, 0, 0, 0, 0, 1, 1, 0xff, 0x7f, 0, 0, 3})));
  EXPECT_THAT(screen.contacts(), IsEmpty()) << "a frame counts when it is whole";
  EXPECT_TRUE(screen.take(bytes({1, 1, 2, 0, 0, 0xff, 0x7f, 0, 0, 0, 0, 0, 0, 0})));
  EXPECT_THAT(screen.contacts(),
              ElementsAre(FingerAt(0, 0.F, 0.F), FingerAt(1, 1.F, 0.F), FingerAt(2, 0.F, 1.F)));
}

TEST(Contacts, AFingerGoesWhenItsTipIsUp) {
  input::ContactDecoder screen = hybrid_screen();
  screen.take(bytes({1, 1, 4, 0, 0, 0, 0, 1, 5, 0, 0, 0, 0, 2}));

  screen.take(bytes({1, 0, 4, 0, 0, 0, 0, 1, 5, 0, 0, 0, 0, 2}));
  EXPECT_THAT(screen.contacts(), ElementsAre(FingerAt(5, 0.F, 0.F)));
}

TEST(Contacts, AFingerThatIsLeftOutOnceIsNotGone) {
  input::ContactDecoder screen = hybrid_screen();
  screen.take(bytes({1, 1, 4, 0, 0, 0, 0, 1, 5, 0, 0, 0, 0, 2}));
  const auto only_four = bytes({1, 1, 4, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1});

  screen.take(only_four);
  EXPECT_EQ(screen.contacts().size(), 2U);
  for (int i = 0; i < 10; ++i) screen.take(only_four);
  EXPECT_THAT(screen.contacts(), ElementsAre(FingerAt(4, 0.F, 0.F)));
}

TEST(Contacts, WhatIsBehindTheCountedOnesIsALiftButNotWhereItIsAllZero) {
  input::ContactDecoder screen = hybrid_screen();
  screen.take(bytes({1, 1, 0, 0xff, 0x7f, 0, 0, 1, 5, 0, 0, 0, 0, 2}));

  screen.take(bytes({1, 1, 5, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1}));
  EXPECT_EQ(screen.contacts().size(), 2U) << "finger 0 was left out, and the rest is padding";
  screen.take(bytes({1, 1, 5, 0, 0, 0, 0, 0, 0, 0xff, 0x7f, 0, 0, 1}));
  EXPECT_THAT(screen.contacts(), ElementsAre(FingerAt(5, 0.F, 0.F)));
}

TEST(Contacts, AWindows8ScreenLeavesOutOnlyFingersThatHaveGone) {
  input::ContactDecoder screen = decoder_for(join(
      {begin_touch_screen(1), finger(), finger(), contact_count(), scan_time(), end_collection()}));
  screen.take(bytes({1, 1, 4, 0, 0, 0, 0, 1, 5, 0, 0, 0, 0, 2, 0, 0}));

  screen.take(bytes({1, 1, 4, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 0}));
  EXPECT_THAT(screen.contacts(), ElementsAre(FingerAt(4, 0.F, 0.F)));
}

TEST(Contacts, OfASerialScreenAreNewsReportByReportWhateverItCounts) {
  for (const int count : {0, 1, 2}) {
    input::ContactDecoder screen =
        decoder_for(join({begin_touch_screen(1), finger(), contact_count(), end_collection()}));

    EXPECT_TRUE(screen.take(bytes({1, 1, 0, 0, 0, 0, 0, count})));
    EXPECT_EQ(screen.contacts().size(), 1U);
    EXPECT_TRUE(screen.take(bytes({1, 1, 1, 0, 0, 0, 0, count})));
    EXPECT_EQ(screen.contacts().size(), 2U);
    screen.take(bytes({1, 0, 0, 0, 0, 0, 0, count}));
    EXPECT_THAT(screen.contacts(), ElementsAre(FingerAt(1, 0.F, 0.F)));
  }
}

TEST(Contacts, AHybridScreenMayRepeatTheCountInEveryReportOfAFrame) {
  input::ContactDecoder screen = hybrid_screen();

  EXPECT_FALSE(screen.take(bytes({1, 1, 0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 4})));
  EXPECT_TRUE(screen.take(bytes({1, 1, 2, 0, 0, 0, 0, 1, 3, 0, 0, 0, 0, 4})));
  EXPECT_EQ(screen.contacts().size(), 4U);
}

TEST(Contacts, ShortAndForeignReportsChangeNothing) {
  input::ContactDecoder screen = hybrid_screen();
  screen.take(bytes({1, 1, 7, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1}));

  EXPECT_FALSE(screen.take(bytes({})));
  EXPECT_FALSE(screen.take(bytes({1, 1})));
  EXPECT_FALSE(screen.take(bytes({2, 0, 7, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1})));
  EXPECT_THAT(screen.contacts(), ElementsAre(FingerAt(7, 0.F, 0.F)));
}

TEST(Contacts, APromiseOfMoreContactsThanThereAreDoesNotBlockTheNextFrame) {
  input::ContactDecoder screen = hybrid_screen();

  EXPECT_FALSE(screen.take(bytes({1, 1, 0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 0x7f})));
  EXPECT_TRUE(screen.take(bytes({1, 1, 9, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1})));
  EXPECT_EQ(screen.contacts().size(), 3U) << "what did come of the broken frame is true";
  for (int i = 0; i < 11; ++i) screen.take(bytes({1, 1, 9, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1}));
  EXPECT_THAT(screen.contacts(), ElementsAre(FingerAt(9, 0.F, 0.F)));
}

TEST(Contacts, ACountOfNoneOverNothingButZerosLiftsThemAll) {
  input::ContactDecoder screen = hybrid_screen();
  screen.take(bytes({1, 1, 4, 0, 0, 0, 0, 1, 5, 0, 0, 0, 0, 2}));

  EXPECT_TRUE(screen.take(bytes({1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0})));
  EXPECT_THAT(screen.contacts(), IsEmpty());
}

TEST(Contacts, ACountThatIsAlwaysNoneIsNotBelieved) {
  input::ContactDecoder screen = hybrid_screen();

  EXPECT_TRUE(screen.take(bytes({1, 1, 4, 0, 0, 0, 0, 1, 5, 0xff, 0x7f, 0, 0, 0})));
  EXPECT_THAT(screen.contacts(), ElementsAre(FingerAt(4, 0.F, 0.F), FingerAt(5, 1.F, 0.F)));
  EXPECT_TRUE(screen.take(bytes({1, 1, 4, 0, 0, 0, 0, 0, 5, 0xff, 0x7f, 0, 0, 0})));
  EXPECT_THAT(screen.contacts(), ElementsAre(FingerAt(4, 0.F, 0.F)));
}

/// Two fingers a report, a count and a scan time: a Windows 8 screen.
input::ContactDecoder windows_8_screen() {
  return decoder_for(join(
      {begin_touch_screen(1), finger(), finger(), contact_count(), scan_time(), end_collection()}));
}

TEST(Contacts, OfAWindows8FrameWithTheEmptyRestOfItStayDown) {
  input::ContactDecoder screen = windows_8_screen();
  screen.take(bytes({1, 1, 4, 0, 0, 0, 0, 1, 5, 0, 0, 0, 0, 2, 9, 0}));

  EXPECT_FALSE(screen.take(bytes({1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 9, 0})));
  EXPECT_EQ(screen.contacts().size(), 2U);
  EXPECT_TRUE(screen.take(bytes({1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 10, 0})));
  EXPECT_THAT(screen.contacts(), IsEmpty());
}

TEST(Contacts, AWindows8ScreenThatNamesAFingerTwiceMeansTheFirst) {
  input::ContactDecoder screen = windows_8_screen();

  screen.take(bytes({1, 1, 4, 0xff, 0x7f, 0, 0, 0, 4, 0, 0, 0, 0, 2, 1, 0}));
  EXPECT_THAT(screen.contacts(), ElementsAre(FingerAt(4, 1.F, 0.F)));
}

TEST(Contacts, AWindows8FrameEndsWithItsScanTimeEvenWhereContactsAreMissing) {
  input::ContactDecoder screen = windows_8_screen();

  EXPECT_FALSE(screen.take(bytes({1, 1, 1, 0, 0, 0, 0, 1, 2, 0, 0, 0, 0, 3, 1, 0})));
  EXPECT_FALSE(screen.take(bytes({1, 1, 1, 0, 0, 0, 0, 1, 2, 0, 0, 0, 0, 3, 2, 0})))
      << "the same count with another time is another frame";
  EXPECT_TRUE(screen.take(bytes({1, 1, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0})));
  EXPECT_EQ(screen.contacts().size(), 3U);
}

TEST(Contacts, WithoutATipSwitchAreDownWhileInRange) {
  input::ContactDecoder screen = decoder_for(
      bytes({0x05, 0x0d, 0x09, 0x04, 0xa1, 0x01, 0x09, 0x22, 0xa1, 0x02, 0x09, 0x32, 0x15,
             0x00, 0x25, 0x01, 0x75, 0x08, 0x95, 0x01, 0x81, 0x02, 0x05, 0x01, 0x26, 0xff,
             0x00, 0x09, 0x30, 0x81, 0x02, 0x09, 0x31, 0x81, 0x02, 0xc0, 0xc0}));

  screen.take(bytes({1, 0xff, 0}));
  EXPECT_THAT(screen.contacts(), ElementsAre(FingerAt(0, 1.F, 0.F)));
  screen.take(bytes({0, 0xff, 0}));
  EXPECT_THAT(screen.contacts(), IsEmpty());
}

/// A Windows 8 screen of one finger, which says how sure it is: tip switch, in range and confidence
/// in the first three bits.
input::ContactDecoder confident_screen() {
  const auto sure_finger =
      bytes({0x05, 0x0d, 0x09, 0x22, 0xa1, 0x02, 0x09, 0x42, 0x09, 0x32, 0x09, 0x47, 0x15,
             0x00, 0x25, 0x01, 0x75, 0x01, 0x95, 0x03, 0x81, 0x02, 0x95, 0x05, 0x81, 0x03,
             0x75, 0x08, 0x95, 0x01, 0x09, 0x51, 0x25, 0x7f, 0x81, 0x02, 0x05, 0x01, 0x26,
             0xff, 0x7f, 0x75, 0x10, 0x09, 0x30, 0x81, 0x02, 0x09, 0x31, 0x81, 0x02, 0xc0});
  return decoder_for(
      join({begin_touch_screen(1), sure_finger, scan_time(), contact_count(), end_collection()}));
}
constexpr int on_glass = 7, hovering = 6, palm = 3, lifted = 0;
std::vector<std::byte> sure_report(int state, int time) {
  return bytes({1, state, 4, 0, 0, 0, 0, time, 0, 1});
}

TEST(Contacts, ThatHoverAreNone) {
  input::ContactDecoder screen = confident_screen();

  screen.take(sure_report(hovering, 1));
  EXPECT_THAT(screen.contacts(), IsEmpty());
  screen.take(sure_report(on_glass, 2));
  EXPECT_THAT(screen.contacts(), ElementsAre(FingerAt(4, 0.F, 0.F)));
  screen.take(sure_report(hovering, 3));
  EXPECT_THAT(screen.contacts(), IsEmpty());
}

TEST(Contacts, ThatAreAPalmAreNone) {
  input::ContactDecoder screen = confident_screen();
  screen.take(sure_report(on_glass, 1));
  screen.take(sure_report(palm, 2));

  EXPECT_THAT(screen.contacts(), IsEmpty());
  EXPECT_THAT(screen.turned_to_palms(), ElementsAre(4U));
  screen.take(sure_report(lifted, 3));
  screen.take(sure_report(palm, 4));
  EXPECT_THAT(screen.contacts(), IsEmpty());
  EXPECT_THAT(screen.turned_to_palms(), IsEmpty()) << "it was none before";
}

TEST(Contacts, OfAScreenThatIsNeverSureAreFingers) {
  input::ContactDecoder screen = confident_screen();
  screen.take(sure_report(palm, 1));
  EXPECT_THAT(screen.contacts(), ElementsAre(FingerAt(4, 0.F, 0.F)));
}

TEST(Contacts, ThatGoWithoutConfidenceHaveBeenLifted) {
  input::ContactDecoder screen = confident_screen();
  screen.take(sure_report(on_glass, 1));
  screen.take(sure_report(lifted, 2));

  EXPECT_THAT(screen.contacts(), IsEmpty());
  EXPECT_THAT(screen.turned_to_palms(), IsEmpty());
}

TEST(Contacts, OfAScreenThatTellsPressureAloneAreDownWhileTheyPress) {
  const auto pressing =
      bytes({0x05, 0x0d, 0x09, 0x22, 0xa1, 0x02, 0x09, 0x30, 0x15, 0x00, 0x26, 0xff,
             0x00, 0x75, 0x08, 0x95, 0x01, 0x81, 0x02, 0x05, 0x01, 0x26, 0xff, 0x7f,
             0x75, 0x10, 0x09, 0x30, 0x81, 0x02, 0x09, 0x31, 0x81, 0x02, 0xc0});
  input::ContactDecoder screen =
      decoder_for(join({begin_touch_screen(1), pressing, end_collection()}));

  screen.take(bytes({1, 40, 0xff, 0x7f, 0, 0}));
  EXPECT_THAT(screen.contacts(), ElementsAre(FingerAt(0, 1.F, 0.F)));
  screen.take(bytes({1, 0, 0xff, 0x7f, 0, 0}));
  EXPECT_THAT(screen.contacts(), IsEmpty());
}

TEST(Contacts, OfTwelveBitsFromBelowZeroCoverTheWholeGlass) {
  // tip (1 bit), padding (7), X and Y of 12 bits each, -1000 to 1000; no report id
  input::ContactDecoder screen =
      decoder_for(bytes({0x05, 0x0d, 0x09, 0x04, 0xa1, 0x01, 0x09, 0x22, 0xa1, 0x02, 0x09, 0x42,
                         0x15, 0x00, 0x25, 0x01, 0x75, 0x01, 0x95, 0x01, 0x81, 0x02, 0x95, 0x07,
                         0x81, 0x03, 0x05, 0x01, 0x16, 0x18, 0xfc, 0x26, 0xe8, 0x03, 0x75, 0x0c,
                         0x95, 0x01, 0x09, 0x30, 0x81, 0x02, 0x09, 0x31, 0x81, 0x02, 0xc0, 0xc0}));

  screen.take(bytes({1, 0x18, 0x8c, 0x3e}));  // X -1000 (0xc18), Y 1000 (0x3e8)
  EXPECT_THAT(screen.contacts(), ElementsAre(FingerAt(0, 0.F, 1.F)));
  screen.take(bytes({1, 0, 0, 0}));
  EXPECT_THAT(screen.contacts(), ElementsAre(FingerAt(0, 0.5F, 0.5F)));
}

TEST(Contacts, WithALeastValueOverNoneBeginAtTheEdge) {
  input::ContactDecoder screen = decoder_for(
      bytes({0x05, 0x0d, 0x09, 0x04, 0xa1, 0x01, 0x09, 0x22, 0xa1, 0x02, 0x09, 0x42, 0x15,
             0x00, 0x25, 0x01, 0x75, 0x08, 0x95, 0x01, 0x81, 0x02, 0x05, 0x01, 0x15, 0x64,
             0x26, 0xc8, 0x00, 0x09, 0x30, 0x81, 0x02, 0x09, 0x31, 0x81, 0x02, 0xc0, 0xc0}));

  screen.take(bytes({1, 100, 150}));
  EXPECT_THAT(screen.contacts(), ElementsAre(FingerAt(0, 0.F, 0.5F)));
  screen.take(bytes({1, 99, 201}));
  EXPECT_THAT(screen.contacts(), ElementsAre(FingerAt(0, 0.F, 1.F))) << "beyond it is the edge";
}

TEST(Contacts, OfAScreenBehindAMouseAndAPenAreFound) {
  const auto mouse =
      bytes({0x05, 0x01, 0x09, 0x02, 0xa1, 0x01, 0x85, 0x02, 0x05, 0x09, 0x09, 0x01, 0x15,
             0x00, 0x25, 0x01, 0x75, 0x08, 0x95, 0x01, 0x81, 0x02, 0x05, 0x01, 0x26, 0xff,
             0x0f, 0x75, 0x10, 0x95, 0x02, 0x09, 0x30, 0x09, 0x31, 0x81, 0x02, 0xc0});
  const auto pen = bytes({0x05, 0x0d, 0x09, 0x02, 0xa1, 0x01, 0x85, 0x03, 0x09, 0x42, 0x15, 0x00,
                          0x25, 0x01, 0x75, 0x08, 0x95, 0x01, 0x81, 0x02, 0x05, 0x01, 0x26, 0xff,
                          0x0f, 0x75, 0x10, 0x09, 0x30, 0x81, 0x02, 0x09, 0x31, 0x81, 0x02, 0xc0});
  input::ContactDecoder screen = decoder_for(join(
      {mouse, pen, begin_touch_screen(1), finger(), finger(), contact_count(), end_collection()}));

  EXPECT_FALSE(screen.take(bytes({2, 1, 0xff, 0x0f, 0xff, 0x0f})));
  EXPECT_FALSE(screen.take(bytes({3, 1, 0xff, 0x0f, 0xff, 0x0f})));
  EXPECT_TRUE(screen.take(bytes({1, 1, 7, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1})));
  EXPECT_EQ(screen.contacts().size(), 1U);
}

TEST(Contacts, OfTwoScreensInOneDeviceDoNotLiftEachOther) {
  input::ContactDecoder screen =
      decoder_for(join({begin_touch_screen(1), finger(), end_collection(), begin_touch_screen(2),
                        finger(), end_collection()}));

  EXPECT_TRUE(screen.take(bytes({1, 1, 3, 0, 0, 0, 0})));
  EXPECT_TRUE(screen.take(bytes({2, 1, 3, 0xff, 0x7f, 0, 0})));
  ASSERT_EQ(screen.contacts().size(), 2U);
  EXPECT_NE(screen.contacts()[0].id, screen.contacts()[1].id);
  EXPECT_TRUE(screen.take(bytes({1, 0, 3, 0, 0, 0, 0})));
  EXPECT_THAT(screen.contacts(), ElementsAre(FingerAt(4096 + 3, 1.F, 0.F)));
}

TEST(Contacts, BeyondTheMostThatAreKeptAreLeftOutAndTheRestGoOn) {
  input::ContactDecoder screen =
      decoder_for(join({begin_touch_screen(1), finger(), end_collection()}));

  for (int id = 0; id < 100; ++id) screen.take(bytes({1, 1, id, 0, 0, 0, 0}));
  EXPECT_EQ(screen.contacts().size(), input::max_contacts);
  for (int id = 0; id < 100; ++id) screen.take(bytes({1, 0, id, 0, 0, 0, 0}));
  EXPECT_THAT(screen.contacts(), IsEmpty());
}

/// The hybrid screen as the maker of a quirk sells it.
input::ContactDecoder hybrid_screen_with(input::TouchRules rules) {
  const auto descriptor = input::parse_report_descriptor(
      join({begin_touch_screen(1), finger(), finger(), contact_count(), end_collection()}));
  auto layout = input::find_touch_screen(*descriptor);
  layout->rules = rules;
  return {*descriptor, *layout};
}

TEST(Quirks, AFingerThatIsLeftOutHasGoneWhateverIsCounted) {
  input::ContactDecoder screen = hybrid_screen_with(input::quirk_of(0x2453, 0x0100)->rules);

  screen.take(bytes({1, 1, 4, 0, 0, 0, 0, 1, 5, 0, 0, 0, 0, 1}));
  EXPECT_EQ(screen.contacts().size(), 2U);
  screen.take(bytes({1, 1, 5, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1}));
  EXPECT_THAT(screen.contacts(), ElementsAre(FingerAt(5, 0.F, 0.F)));
}

TEST(Quirks, WithoutIdentifiersThePlaceInTheReportTellsFingersApart) {
  input::ContactDecoder screen = hybrid_screen_with(input::quirk_of(0x093a, 0x8001)->rules);

  screen.take(bytes({1, 1, 9, 0, 0, 0, 0, 1, 9, 0xff, 0x7f, 0, 0, 2}));
  EXPECT_THAT(screen.contacts(), ElementsAre(FingerAt(0, 0.F, 0.F), FingerAt(1, 1.F, 0.F)));
}

TEST(Quirks, AreNeverLookedUpForAWindows8Screen) {
  const auto seven = input::parse_report_descriptor(
      join({begin_touch_screen(1), finger(), finger(), contact_count(), end_collection()}));
  const auto eight = input::parse_report_descriptor(join(
      {begin_touch_screen(1), finger(), finger(), contact_count(), scan_time(), end_collection()}));
  const input::HidDeviceId id{0x2453, 0x0100};

  EXPECT_EQ(input::classify(*seven, id).touch->rules.valid, input::TouchRules::Valid::WithTip);
  EXPECT_EQ(input::classify(*eight, id).touch->rules.valid, input::TouchRules::Valid::Always);
  EXPECT_EQ(input::classify(*seven, {1, 2}).touch->rules.valid, input::TouchRules::Valid::Always);
}

TEST(Quirks, AllSayWhy) {
  for (const input::TouchQuirk& quirk : input::known_quirks())
    EXPECT_STRNE(quirk.why, "") << quirk.vendor << ':' << quirk.product;
}

TEST(Contacts, AMouseWithAbsoluteAxesIsOneFinger) {
  input::ContactDecoder screen = decoder_for(
      bytes({0x05, 0x01, 0x09, 0x02, 0xa1, 0x01, 0x05, 0x09, 0x19, 0x01, 0x29, 0x08, 0x15,
             0x00, 0x25, 0x01, 0x75, 0x01, 0x95, 0x08, 0x81, 0x02, 0x05, 0x01, 0x26, 0xff,
             0x0f, 0x75, 0x10, 0x95, 0x02, 0x09, 0x30, 0x09, 0x31, 0x81, 0x02, 0xc0}));

  EXPECT_TRUE(screen.take(bytes({1, 0xff, 0x0f, 0, 0})));
  EXPECT_THAT(screen.contacts(), ElementsAre(FingerAt(0, 1.F, 0.F)));
  EXPECT_TRUE(screen.take(bytes({0, 0xff, 0x0f, 0, 0})));
  EXPECT_THAT(screen.contacts(), IsEmpty());
}

TEST(Contacts, ARelativeMouseIsNoTouchScreen) {
  const auto descriptor = input::parse_report_descriptor(
      bytes({0x05, 0x01, 0x09, 0x02, 0xa1, 0x01, 0x05, 0x09, 0x09, 0x01, 0x15, 0x00,
             0x25, 0x01, 0x75, 0x08, 0x95, 0x01, 0x81, 0x02, 0x05, 0x01, 0x15, 0x81,
             0x25, 0x7f, 0x95, 0x02, 0x09, 0x30, 0x09, 0x31, 0x81, 0x06, 0xc0}));

  EXPECT_FALSE(input::find_touch_screen(*descriptor));
}

TEST(ContactEvents, TellDownMoveAndUpApart) {
  const std::vector<input::Contact> before{{1, 0.1F, 0.1F}, {2, 0.2F, 0.2F}};
  const std::vector<input::Contact> after{{2, 0.3F, 0.2F}, {3, 0.5F, 0.5F}};
  std::array<input::InputEvent, 8> events;

  const std::size_t count = input::contact_events(before, after, events);
  ASSERT_EQ(count, 3U);
  EXPECT_EQ(events[0].kind, input::InputEvent::Kind::Up);
  EXPECT_EQ(events[0].contact.id, 1U);
  EXPECT_EQ(events[1].kind, input::InputEvent::Kind::Move);
  EXPECT_EQ(events[2].kind, input::InputEvent::Kind::Down);
  EXPECT_EQ(events[2].contact.id, 3U);
}

}  // namespace
}  // namespace docent::test::contact_decoder_test
