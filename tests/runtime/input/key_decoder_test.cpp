#include "runtime/input/key_decoder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/runtime/input/hid_bytes.h"

namespace docent::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<KeyEdge> edges(KeyDecoder& decoder, const std::vector<std::byte>& report) {
  std::array<KeyEdge, 32> out;
  const std::size_t count = decoder.take(report, out);
  return {out.begin(), out.begin() + static_cast<std::ptrdiff_t>(count)};
}

KeyDecoder decoder_for(const std::vector<std::byte>& descriptor_bytes) {
  const auto descriptor = parse_report_descriptor(descriptor_bytes);
  return {*descriptor, find_keys(*descriptor)};
}

TEST(Keys, GoDownAndUpOnce) {
  KeyDecoder keypad = decoder_for(boot_keyboard());
  constexpr int up_arrow = 0x52;

  EXPECT_THAT(edges(keypad, bytes({0, 0, up_arrow, 0, 0, 0, 0, 0})),
              ElementsAre(KeyEdge{{Key::Up}, true}));
  EXPECT_THAT(edges(keypad, bytes({0, 0, up_arrow, 0, 0, 0, 0, 0})), IsEmpty());
  EXPECT_THAT(edges(keypad, bytes({0, 0, 0, 0, 0, 0, 0, 0})),
              ElementsAre(KeyEdge{{Key::Up}, false}));
}

TEST(Keys, SecondKeyMayOverlapTheFirst) {
  KeyDecoder keypad = decoder_for(boot_keyboard());
  edges(keypad, bytes({0, 0, 0x70, 0, 0, 0, 0, 0}));

  EXPECT_THAT(edges(keypad, bytes({0, 0, 0x70, 0x6f, 0, 0, 0, 0})),
              ElementsAre(KeyEdge{{Key::Function, 20}, true}));
  EXPECT_THAT(edges(keypad, bytes({0, 0, 0x6f, 0, 0, 0, 0, 0})),
              ElementsAre(KeyEdge{{Key::Function, 21}, false}));
}

TEST(Keys, RollOverKeepsWhatWasDown) {
  KeyDecoder keypad = decoder_for(boot_keyboard());
  edges(keypad, bytes({0, 0, 0x28, 0, 0, 0, 0, 0}));

  EXPECT_THAT(edges(keypad, bytes({0, 0, 1, 1, 1, 1, 1, 1})), IsEmpty());
  EXPECT_THAT(edges(keypad, bytes({0, 0, 0, 0, 0, 0, 0, 0})),
              ElementsAre(KeyEdge{{Key::Enter}, false}));
}

TEST(Keys, ShortReportsSayNothing) {
  KeyDecoder keypad = decoder_for(boot_keyboard());
  edges(keypad, bytes({0, 0, 0x28, 0, 0, 0, 0, 0}));

  EXPECT_THAT(edges(keypad, bytes({})), IsEmpty());
}

TEST(Keys, NamesComeBackFromTheirText) {
  for (int i = 1; i < 256; ++i) {
    const KeyName key = key_of(usage(0x07, static_cast<std::uint16_t>(i)));
    if (key.key != Key::None) {
      EXPECT_EQ(key_from_string(to_string(key)), key) << i;
    }
  }
  EXPECT_EQ(key_from_string("F0").key, Key::None);
  EXPECT_EQ(key_from_string("F25").key, Key::None);
  EXPECT_EQ(key_from_string("ESCAPE").key, Key::None);
}

}  // namespace
}  // namespace docent::test
