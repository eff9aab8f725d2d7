#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "runtime/input/decode_recording.h"
#include "tests/support/reference_data.h"

namespace docent::test::hid_recording_test {
namespace {

using testing::HasSubstr;

constexpr const char* keypad =
    "R: 42 05 01 09 06 a1 01 05 07 19 e0 29 e7 15 00 25 01 75 01 95 08 81 02 95 01 75 08 81 01 95 "
    "06 15 00 26 ff 00 19 00 29 ff 81 00 c0\n"
    "N: A keypad\nI: 3 1209 0001\nE: 0.0 8 00 00 28 00 00 00 00 00\nE: 0.1 8 00 00 00 00 00 00 00 "
    "00\n";

TEST(Recording, OfAKeypadBecomesKeyEdges) {
  const auto recording = input::parse_hid_recording(keypad, "keypad.hid");
  ASSERT_TRUE(recording) << recording.error().what;

  EXPECT_EQ(recording->name, "A keypad");
  EXPECT_EQ(*input::decode_recording(*recording),
            "report,kind,id,x,y,state\n0,key,ENTER,,,down\n1,key,ENTER,,,up\n");
}

TEST(Recording, SaysWhichLineIsBroken) {
  EXPECT_THAT(input::parse_hid_recording("N: x\nR: 3 05 01\n", "a.hid").error().what,
              HasSubstr("a.hid:2:"));
  EXPECT_THAT(input::parse_hid_recording("R: 1 c0\nE: 0.0 2 zz 00\n", "a.hid").error().what,
              HasSubstr("a.hid:2:"));
  EXPECT_THAT(input::parse_hid_recording("hello\n", "a.hid").error().what,
              HasSubstr("no report descriptor"));
}

TEST(Recording, OfEveryReferenceDeviceIsReadWithoutComplaint) {
  NEEDS_REFERENCE_DATA("hid/mt");
  for (const auto& entry : std::filesystem::directory_iterator(reference_data() / "hid/mt")) {
    if (entry.path().extension() != ".hid") continue;
    std::stringstream text;
    text << std::ifstream(entry.path()).rdbuf();
    const auto recording = input::parse_hid_recording(text.str(), entry.path().string());
    ASSERT_TRUE(recording) << recording.error().what;
    EXPECT_TRUE(input::decode_recording(*recording)) << entry.path();
  }
}

}  // namespace
}  // namespace docent::test::hid_recording_test
