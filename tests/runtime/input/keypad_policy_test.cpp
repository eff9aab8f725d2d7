#include "runtime/input/keypad_policy.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/runtime/input/hid_bytes.h"

namespace docent::test::keypad_policy_test {
namespace {

using input::KeypadCandidate;
using testing::HasSubstr;

constexpr input::HidDeviceId ours{0x04e7, 0x0022}, theirs{0x05ac, 0x0256};

constexpr KeypadCandidate keypad{.id = ours, .descriptor = 7, .has_keys = true};
constexpr KeypadCandidate keyboard{
    .id = theirs, .descriptor = 8, .has_keys = true, .is_keyboard = true};
constexpr KeypadCandidate music_keys{.id = theirs, .descriptor = 9, .has_keys = true};
constexpr KeypadCandidate glass{.id = theirs, .descriptor = 10};

std::vector<input::ReportField> keys_of(const std::vector<std::byte>& descriptor) {
  return input::find_keys(*input::parse_report_descriptor(descriptor));
}

TEST(KeypadPolicy, TakesADeviceWithAllLettersForAKeyboard) {
  // keys 1 to 9, 0 and the arrows, each a bit
  const auto figures = bytes({0x05, 0x01, 0x09, 0x07, 0xa1, 0x01, 0x05, 0x07, 0x15, 0x00, 0x25,
                              0x01, 0x75, 0x01, 0x19, 0x1e, 0x29, 0x27, 0x95, 0x0a, 0x81, 0x02,
                              0x19, 0x4f, 0x29, 0x52, 0x95, 0x04, 0x81, 0x02, 0xc0});

  EXPECT_TRUE(input::has_all_letters(keys_of(boot_keyboard())));
  EXPECT_FALSE(keys_of(figures).empty());
  EXPECT_FALSE(input::has_all_letters(keys_of(figures)));
}

TEST(KeypadPolicy, LetsKeypadsInAndNoKeyboardWhereNobodyIsNamed) {
  const std::vector<KeypadCandidate> present{keypad, keyboard, music_keys, glass};

  EXPECT_EQ(input::refusal(keypad, present, {}), "");
  EXPECT_EQ(input::refusal(glass, present, {}), "") << "it has no keys to refuse";
  EXPECT_THAT(input::refusal(keyboard, present, {}), HasSubstr("a keyboard"));
  EXPECT_THAT(input::refusal(music_keys, present, {}), HasSubstr("belongs to a keyboard"));
}

TEST(KeypadPolicy, LetsThoseInThatAreNamedAndNobodyElse) {
  const std::vector<KeypadCandidate> present{keypad, keyboard};
  const std::vector<input::NamedKeypad> named{{theirs, {}}};

  EXPECT_EQ(input::refusal(keyboard, present, named), "") << "staff may name a keyboard";
  EXPECT_THAT(input::refusal(keypad, present, named), HasSubstr("none of the keypads"));
}

TEST(KeypadPolicy, LetsANamedDeviceInOnlyWithTheDescriptorThatWasNamed) {
  EXPECT_EQ(input::refusal(keypad, {}, std::vector<input::NamedKeypad>{{ours, 7}}), "");
  EXPECT_NE(input::refusal(keypad, {}, std::vector<input::NamedKeypad>{{ours, 8}}), "");
}

TEST(KeypadPolicy, GivesKeysTheMeaningsOfTheKeypadThatIsNamed) {
  const std::vector<input::KeyMeaning> left{{{input::Key::Function, 23}, {input::Key::Left}}};
  const std::vector<input::NamedKeypad> named{{theirs, {}, {}}, {ours, 7, left}};

  EXPECT_EQ(input::meanings_of(keypad, named), left);
  EXPECT_TRUE(input::meanings_of(keyboard, named).empty());
  EXPECT_TRUE(input::meanings_of(keypad, {}).empty());
}

TEST(KeypadPolicy, ReadsTheNumbersThatTheListTells) {
  EXPECT_EQ(input::device_id_from("04e7:0022"), ours);
  EXPECT_FALSE(input::device_id_from("4e7:22"));
  EXPECT_FALSE(input::device_id_from("04e7-0022"));
  EXPECT_FALSE(input::device_id_from("04e7:002g"));
  EXPECT_EQ(input::descriptor_hash_from("00000000000000ff"), 255U);
  EXPECT_FALSE(input::descriptor_hash_from("ff"));
  EXPECT_FALSE(input::descriptor_hash_from(""));
}

TEST(KeypadPolicy, TellsDescriptorsApart) {
  EXPECT_EQ(input::descriptor_hash({}), 0xcbf29ce484222325ULL);
  EXPECT_NE(input::descriptor_hash(bytes({1, 2})), input::descriptor_hash(bytes({2, 1})));
}

}  // namespace
}  // namespace docent::test::keypad_policy_test
