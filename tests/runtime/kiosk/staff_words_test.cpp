#include "runtime/kiosk/staff_words.h"

#include <gmock/gmock.h>

#include <string>

#include "config/museum_config.h"
#include "runtime/kiosk/staff_page.h"
#include "tests/support/reference_data.h"

namespace docent::kiosk::staff_words_test {
namespace {

using testing::HasSubstr;

Language shipped(const std::string& tag) {
  const auto file = config::load_words(test::source_dir() / "config/words" / (tag + ".toml"), tag);
  Language language{.tag = tag, .name = tag, .right_to_left = false, .words = {}};
  if (!file.value) return language;
  language.right_to_left = file.value->direction.value == "right-to-left";
  for (const auto& [key, word] : file.value->words.value) language.words[key] = word.value;
  return language;
}

Museum speaking(std::initializer_list<Language> languages) {
  Museum museum;
  museum.languages = languages;
  return museum;
}

TEST(StaffWords, AreInEveryWordsFileThatIsShipped) {
  for (const char* tag : {"en", "zh", "ar"}) {
    const Language language = shipped(tag);
    for (std::size_t i = 0; i < staff_words_count; ++i)
      EXPECT_TRUE(language.words.contains(key_of(static_cast<StaffWord>(i))))
          << tag << ' ' << key_of(static_cast<StaffWord>(i));
  }
}

TEST(StaffWords, AreInEnglishWhatTheWordsFileSays) {
  const StaffWords built_in = staff_words(Museum{}, 0);
  const StaffWords from_file = staff_words(speaking({shipped("en")}), 0);

  EXPECT_EQ(built_in.words, from_file.words);
  EXPECT_EQ(built_in.page_of, from_file.page_of);
}

TEST(StaffWords, FollowTheLanguageOnTheGlass) {
  const StaffWords words = staff_words(speaking({shipped("en"), shipped("ar")}), 1);

  EXPECT_EQ(words.language, "ar");
  EXPECT_TRUE(words.right_to_left);
  EXPECT_EQ(words[StaffWord::Title], "للموظفين");
  EXPECT_THAT(words.filled(StaffWord::Wait, {{"n", "12"}}), HasSubstr("١٢"));
  EXPECT_EQ(words.one_of(2, 4), "٢ من ٤");
}

TEST(StaffWords, OfALanguageWithoutThemAreThoseOfTheFirst) {
  Language mute = shipped("zh");
  std::erase_if(mute.words, [](const auto& word) { return word.first.starts_with("staff_"); });

  EXPECT_EQ(staff_words(speaking({shipped("ar"), mute}), 1).language, "ar");
  const StaffWords none = staff_words(speaking({mute}), 0);
  EXPECT_EQ(none.language, "en");
  EXPECT_EQ(none[StaffWord::Exit], "End, and use the keyboard");
}

TEST(StaffPage, IsMirroredForThoseWhoReadFromTheRight) {
  const interface::SetText letters = [](const interface::TextStyle&, std::string_view text,
                                        std::uint32_t) {
    return interface::TextBitmap{
        .width = static_cast<std::uint32_t>(text.size()), .height = 10, .lines = 1, .coverage = {}};
  };
  StaffPageRequest request;
  request.screen = StaffScreen::Diagnose;
  request.facts = {{.label = "label", .value = "value"}};
  const StaffPage from_left = make_staff_page(request, letters);
  request.words.right_to_left = true;
  const StaffPage from_right = make_staff_page(request, letters);

  ASSERT_EQ(from_left.quads.size(), from_right.quads.size());
  for (std::size_t i = 0; i < from_left.quads.size(); ++i) {
    const scene::Rect& a = from_left.quads[i].rect;
    const scene::Rect& b = from_right.quads[i].rect;
    EXPECT_NEAR(a.x + a.width / 2, 1 - (b.x + b.width / 2), 0.001) << i;
  }
}

}  // namespace
}  // namespace docent::kiosk::staff_words_test
