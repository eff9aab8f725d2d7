#include "runtime/input/key_decoder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/runtime/input/hid_bytes.h"

namespace docent::test::key_decoder_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<input::KeyEdge> edges(input::KeyDecoder& decoder,
                                  const std::vector<std::byte>& report) {
  std::array<input::KeyEdge, 32> out;
  const std::size_t count = decoder.take(report, out);
  return {out.begin(), out.begin() + static_cast<std::ptrdiff_t>(count)};
}

input::KeyDecoder decoder_for(const std::vector<std::byte>& descriptor_bytes) {
  const auto descriptor = input::parse_report_descriptor(descriptor_bytes);
  return {*descriptor, input::find_keys(*descriptor)};
}

TEST(Keys, GoDownAndUpOnce) {
  input::KeyDecoder keypad = decoder_for(boot_keyboard());
  constexpr int up_arrow = 0x52;

  EXPECT_THAT(edges(keypad, bytes({0, 0, up_arrow, 0, 0, 0, 0, 0})),
              ElementsAre(input::KeyEdge{{input::Key::Up}, true}));
  EXPECT_THAT(edges(keypad, bytes({0, 0, up_arrow, 0, 0, 0, 0, 0})), IsEmpty());
  EXPECT_THAT(edges(keypad, bytes({0, 0, 0, 0, 0, 0, 0, 0})),
              ElementsAre(input::KeyEdge{{input::Key::Up}, false}));
}

TEST(Keys, SecondKeyMayOverlapTheFirst) {
  input::KeyDecoder keypad = decoder_for(boot_keyboard());
  edges(keypad, bytes({0, 0, 0x70, 0, 0, 0, 0, 0}));

  EXPECT_THAT(edges(keypad, bytes({0, 0, 0x70, 0x6f, 0, 0, 0, 0})),
              ElementsAre(input::KeyEdge{{input::Key::Function, 20}, true}));
  EXPECT_THAT(edges(keypad, bytes({0, 0, 0x6f, 0, 0, 0, 0, 0})),
              ElementsAre(input::KeyEdge{{input::Key::Function, 21}, false}));
}

TEST(Keys, RollOverKeepsWhatWasDown) {
  input::KeyDecoder keypad = decoder_for(boot_keyboard());
  edges(keypad, bytes({0, 0, 0x28, 0, 0, 0, 0, 0}));

  EXPECT_THAT(edges(keypad, bytes({0, 0, 1, 1, 1, 1, 1, 1})), IsEmpty());
  EXPECT_THAT(edges(keypad, bytes({0, 0, 0, 0, 0, 0, 0, 0})),
              ElementsAre(input::KeyEdge{{input::Key::Enter}, false}));
}

TEST(Keys, ShortReportsSayNothing) {
  input::KeyDecoder keypad = decoder_for(boot_keyboard());
  edges(keypad, bytes({0, 0, 0x28, 0, 0, 0, 0, 0}));

  EXPECT_THAT(edges(keypad, bytes({})), IsEmpty());
}

TEST(Keys, ThatAreHeldGoUpOnceWhenTheDeviceGoes) {
  input::KeyDecoder keypad = decoder_for(boot_keyboard());
  edges(keypad, bytes({0, 0, 0x28, 0x52, 0, 0, 0, 0}));
  std::array<input::KeyEdge, 8> out;

  const std::size_t count = keypad.release(out);

  EXPECT_THAT(std::span(out).first(count),
              testing::UnorderedElementsAre(input::KeyEdge{{input::Key::Enter}, false},
                                            input::KeyEdge{{input::Key::Up}, false}));
  EXPECT_EQ(keypad.release(out), 0U);
  EXPECT_THAT(edges(keypad, bytes({0, 0, 0x28, 0, 0, 0, 0, 0})),
              ElementsAre(input::KeyEdge{{input::Key::Enter}, true}))
      << "held when it was plugged in again";
}

/// A keyboard of the keys Enter, Escape and Backspace, a bit each, whose reports have this id.
std::vector<std::byte> three_keys(int report_id) {
  return bytes({0x05, 0x01, 0x09, 0x06, 0xa1, 0x01, 0x85, report_id, 0x05, 0x07, 0x15, 0x00, 0x25,
                0x01, 0x75, 0x01, 0x95, 0x08, 0x19, 0x28, 0x29,      0x2f, 0x81, 0x02, 0xc0});
}

TEST(Keys, ThatTwoReportsNameGoDownWithTheFirstAndUpWithTheLast) {
  input::KeyDecoder keypad = decoder_for(join({three_keys(1), three_keys(2)}));

  EXPECT_THAT(edges(keypad, bytes({1, 1})), ElementsAre(input::KeyEdge{{input::Key::Enter}, true}));
  EXPECT_THAT(edges(keypad, bytes({2, 1})), IsEmpty());
  EXPECT_THAT(edges(keypad, bytes({1, 0})), IsEmpty());
  EXPECT_THAT(edges(keypad, bytes({2, 0})),
              ElementsAre(input::KeyEdge{{input::Key::Enter}, false}));
}

TEST(Keys, NamesComeBackFromTheirText) {
  for (int i = 1; i < 256; ++i) {
    const input::KeyName key = input::key_of(input::usage(0x07, static_cast<std::uint16_t>(i)));
    if (key.key != input::Key::None) {
      EXPECT_EQ(input::key_from_string(input::to_string(key)), key) << i;
    }
  }
  EXPECT_EQ(input::key_from_string("F0").key, input::Key::None);
  EXPECT_EQ(input::key_from_string("F25").key, input::Key::None);
  EXPECT_EQ(input::key_from_string("ESCAPE").key, input::Key::None);
}

}  // namespace
}  // namespace docent::test::key_decoder_test
