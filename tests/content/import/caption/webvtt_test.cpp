#include "content/import/caption/webvtt.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

namespace docent::import::webvtt_test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

CaptionFile read(std::string_view text) {
  return read_webvtt(text, "film.en.vtt");
}

/// "1000-4500 Text", or the faults where there are any.
std::vector<std::string> told(std::string_view text) {
  const CaptionFile file = read(text);
  std::vector<std::string> all;
  for (const TimedCaption& one : file.captions)
    all.push_back(fmt::format("{}-{} {}", one.begin, one.end, one.text));
  for (const Diagnostic& fault : file.faults)
    all.push_back(fmt::format("{}:{}:{}: {}: {}", fault.file, fault.line, fault.column, fault.code,
                              fault.message));
  return all;
}

TEST(WebVtt, HasTimesWithAndWithoutHours) {
  EXPECT_THAT(
      told("WEBVTT\n\n00:01.000 --> 00:04.500\nOne\n\n00:00:05.250 --> 01:02:03.004\nTwo\n"),
      ElementsAre("1000-4500 One", "5250-3723004 Two"));
}

TEST(WebVtt, HasAnyLineEndsAndAMarkOfItsBytesOrder) {
  EXPECT_THAT(told("\xEF\xBB\xBFWEBVTT\r\n\r\n00:01.000 --> 00:02.000\r\nOne\r\ntwo\r\n\r\n"
                   "00:03.000 --> 00:04.000\r\nThree"),
              ElementsAre("1000-2000 One two", "3000-4000 Three"));
  EXPECT_THAT(told("WEBVTT\r\r00:01.000 --> 00:02.000\rOne\r\r00:03.000 --> 00:04.000\rTwo\r"),
              ElementsAre("1000-2000 One", "3000-4000 Two"));
}

TEST(WebVtt, LeavesOutWhatIsForOtherPrograms) {
  EXPECT_THAT(told("WEBVTT - by somebody\nKind: captions\nLanguage: en\n\n"
                   "NOTE\nnobody reads this\n\nNOTE nor this\n\n"
                   "STYLE\n::cue { color: lime }\n\nREGION\nid:fred\nwidth:40%\n\n"
                   "first\n00:01.000 --> 00:02.000 line:0 position:20% align:start\n"
                   "<v Fred><i>Hello</i> <00:01.500><c.loud>there</c>\n"),
              ElementsAre("1000-2000 Hello there"));
}

TEST(WebVtt, HasCaptionsInAnyOrderAndOverOneAnother) {
  EXPECT_THAT(told("WEBVTT\n\n00:03.000 --> 00:05.000\nB\n\n00:01.000 --> 00:04.000\nA\n"),
              ElementsAre("3000-5000 B", "1000-4000 A"));
}

TEST(WebVtt, BeginsACaptionAtItsTimesWithoutAnEmptyLine) {
  EXPECT_THAT(told("WEBVTT\n00:01.000 --> 00:02.000\nOne\n00:02.000 --> 00:03.000\nTwo\n"),
              ElementsAre("1000-2000 One", "2000-3000 Two"));
}

TEST(WebVtt, PausesWhereACaptionIsEmpty) {
  EXPECT_THAT(told("WEBVTT\n\n00:01.000 --> 00:02.000\n\n00:02.000 --> 00:03.000\nTwo\n"),
              ElementsAre("2000-3000 Two"));
}

TEST(WebVtt, TellsWhereATimeIsWrongAndReadsOn) {
  EXPECT_THAT(
      told("WEBVTT\n\n00:01,000 --> 00:02,000\nComma\n\n00:01.000 -> 00:02.000\nNo arrow\n\n"
           "00:01.000 --> 00:62.000\nSeconds\n\n00:01.000 -->\nNone\n\n"
           "00:04.000 --> 00:02.000\nBackwards\n\n  00:05.000 --> 6\nShort\n\n"
           "00:07.000 --> 00:08.000\nRight\n"),
      ElementsAre("7000-8000 Right", "film.en.vtt:3:1: bad-caption-time: '00:01,000' is no time",
                  "film.en.vtt:6:1: untimed-caption: this text has no times above it, and nobody "
                  "would read it",
                  "film.en.vtt:9:15: bad-caption-time: '00:62.000' is no time",
                  "film.en.vtt:12:14: bad-caption-time: a time is missing here",
                  "film.en.vtt:15:15: bad-caption-time: this caption ends before it has begun",
                  "film.en.vtt:18:17: bad-caption-time: '6' is no time"));
}

TEST(WebVtt, TellsHowAnotherKindOfFileBecomesOne) {
  const CaptionFile subrip = read("1\n00:00:01,000 --> 00:00:02,000\nHello\n");
  ASSERT_EQ(subrip.faults.size(), 1U);
  EXPECT_EQ(subrip.faults[0].hint, "an SRT file becomes one with: ffmpeg -i NAME.srt NAME.vtt");
  EXPECT_THAT(told("WEBVTTX\n"),
              ElementsAre("film.en.vtt:1:1: unreadable-captions: this is no WebVTT file: its first "
                          "line is not WEBVTT"));
  EXPECT_THAT(told(""), ElementsAre("film.en.vtt:1:1: unreadable-captions: this is no WebVTT file: "
                                    "its first line is not WEBVTT"));
}

TEST(WebVtt, TellsOfAFileWithoutCaptions) {
  EXPECT_THAT(told("WEBVTT\n\nNOTE to come\n"),
              ElementsAre("film.en.vtt:0:0: no-captions: this file has no captions"));
}

TEST(WebVtt, TellsOfACaptionThatNobodyReadsInTime) {
  const std::string longest(most_caption_letters, 'a');
  EXPECT_THAT(read("WEBVTT\n\n00:01.000 --> 00:09.000\n" + longest).faults, IsEmpty());
  EXPECT_THAT(told("WEBVTT\n\nname\n00:01.000 --> 00:09.000\n" + longest + "b"),
              ElementsAre("film.en.vtt:5:1: caption-too-long: this caption has 201 letters, and at "
                          "most 200 can be read in time"));
}

}  // namespace
}  // namespace docent::import::webvtt_test
