#include "runtime/interface/keyboard.h"

#include <gtest/gtest.h>

#include <set>

#include "runtime/search/fold.h"
#include "tests/support/shipped_languages.h"

namespace docent::interface::keyboard_test {
namespace {

/// What can be typed there, folded: a letter's parts, and those of each of its forms.
std::set<char16_t> typable(const Keyboard& keyboard) {
  std::set<char16_t> letters{u' '};
  for (const std::u16string_view row : keyboard.rows)
    for (const char16_t letter : search::folded(row)) letters.insert(letter);
  for (const char16_t digit : digit_keys) letters.insert(digit);
  return letters;
}

TEST(AKeyboard, HasAKeyForEveryLetterOfItsLanguagesWords) {
  for (const std::string_view tag : test::shipped_languages) {
    if (tag == "zh" || tag == "ja") continue;  // typed as they are read
    const std::set<char16_t> letters = typable(keyboard_of(tag));
    const Museum museum = test::in_all_shipped_languages({});
    const auto language = std::ranges::find(museum.languages, tag, &Language::tag);
    for (const auto& [key, word] : language->words) {
      if (!key.starts_with("place_") && !key.starts_with("month_")) continue;
      if (word.find('{') != std::string::npos) continue;
      for (const char16_t letter : search::folded(word))
        EXPECT_TRUE(letters.contains(letter))
            << tag << " cannot type " << word << ": " << static_cast<int>(letter);
    }
  }
}

TEST(AKeyboard, HasNoLetterTwiceAndAllOfThemSomethingToSay) {
  for (const std::string_view tag : test::shipped_languages) {
    std::set<char16_t> seen;
    for (const std::u16string_view row : keyboard_of(tag).rows)
      for (const char16_t letter : row) {
        EXPECT_TRUE(seen.insert(letter).second) << tag << ' ' << label_of(letter);
        EXPECT_FALSE(said_of(letter).empty());
        EXPECT_FALSE(label_of(letter).empty());
      }
    EXPECT_GT(seen.size(), 20U) << tag;
  }
}

TEST(AKeyboard, OfALanguageWithoutOneIsThatOfEnglish) {
  EXPECT_EQ(keyboard_of("sw").language, "en");
  EXPECT_EQ(keyboard_of("zh-Hant").language, "zh");
}

}  // namespace
}  // namespace docent::interface::keyboard_test
