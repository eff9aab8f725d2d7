#include "runtime/interface/text.h"

#include <gtest/gtest.h>
#include <malloc.h>

#include <algorithm>
#include <numeric>
#include <stop_token>
#include <thread>
#include <vector>

#include "platform/pango/text_setter.h"

namespace docent::pango::text_setter_test {
namespace {

interface::TextStyle style(std::string_view language, bool right_to_left = false) {
  interface::TextStyle it;
  it.size = 30;
  it.language = language;
  it.right_to_left = right_to_left;
  it.max_lines = 4;
  return it;
}

/// Coverage of a column range, to see where the ink is.
std::uint64_t ink(const interface::TextBitmap& bitmap, std::uint32_t from, std::uint32_t to) {
  std::uint64_t sum = 0;
  for (std::uint32_t y = 0; y < bitmap.height; ++y)
    for (std::uint32_t x = from; x < to; ++x)
      sum += bitmap.coverage[std::size_t{y} * bitmap.width + x];
  return sum;
}

TEST(TextSetter, SetsAllThreeLanguages) {
  const auto set_text = make_text_setter();
  ASSERT_TRUE(set_text.has_value());

  for (const auto& [language, text] :
       {std::pair{"en", "Bronze tripod"}, {"zh", "青铜鼎"}, {"ar", "المرجل البرونزي"}}) {
    const interface::TextBitmap bitmap =
        (*set_text)(style(language, std::string_view(language) == "ar"), text, 0);
    EXPECT_GT(ink(bitmap, 0, bitmap.width), 10000U) << language;
    EXPECT_EQ(bitmap.lines, 1U);
  }
}

TEST(TextSetter, BreaksLinesAtTheWidthAndSpacesThemAsAsked) {
  const auto set_text = make_text_setter();
  interface::TextStyle body = style("en");
  body.line_height = 1.5F;

  const interface::TextBitmap bitmap =
      (*set_text)(body, "A cooking pot that became a crown of the land", 260);

  EXPECT_LE(bitmap.width, 262U);
  EXPECT_GE(bitmap.lines, 2U);
  EXPECT_EQ(bitmap.height, bitmap.lines * 45);
  EXPECT_FALSE(bitmap.cut);
}

TEST(TextSetter, EndsInAnEllipsisWhereTheLinesRunOut) {
  const auto set_text = make_text_setter();
  interface::TextStyle title = style("en");
  title.max_lines = 1;

  const interface::TextBitmap bitmap = (*set_text)(title, "A very long title that cannot fit", 150);

  EXPECT_TRUE(bitmap.cut);
  EXPECT_EQ(bitmap.lines, 1U);
}

TEST(TextSetter, PutsTheShortLineOfAnArabicParagraphAtTheRight) {
  const auto set_text = make_text_setter();

  const interface::TextBitmap bitmap =
      (*set_text)(style("ar", true), "المراجل البرونزية العظيمة ملك", 250);

  ASSERT_EQ(bitmap.lines, 2U);
  interface::TextBitmap last = bitmap;
  const std::uint32_t line = bitmap.height / bitmap.lines;
  last.height = line;
  last.coverage.assign(bitmap.coverage.end() - static_cast<std::ptrdiff_t>(line) * bitmap.width,
                       bitmap.coverage.end());
  EXPECT_EQ(ink(last, 0, bitmap.width / 8), 0U);
  EXPECT_GT(ink(last, bitmap.width * 4 / 5, bitmap.width), 0U);
}

/// From the first pixel with ink to the last.
std::uint32_t inked_width(const interface::TextBitmap& bitmap) {
  std::uint32_t first = bitmap.width, last = 0;
  for (std::uint32_t x = 0; x < bitmap.width; ++x)
    if (ink(bitmap, x, x + 1) > 0) {
      first = std::min(first, x);
      last = x + 1;
    }
  return last - std::min(first, last);
}

TEST(TextSetter, LeavesNoCharacterAloneOnTheLastLineWhereAnyMayBeginOne) {
  const auto set_text = make_text_setter();
  for (const auto& [language, text] :
       {std::pair{"ja", "青銅の鼎は煮炊きの器から国の宝になりました。"},
        {"ja", "三本足の鼎コレクション"},
        {"zh", "从炊具到国之重器的青铜鼎"},
        {"zh", "想看哪一件？\n我带您走过去。"},
        {"ko", "솥에서 나라의 보물이 된 청동 세발솥입니다"}})
    for (std::uint32_t width = 70; width < 800; width += 3) {
      interface::TextStyle title = style(language);
      title.max_lines = 0;
      const std::uint32_t lines = (*set_text)(title, text, width).lines;
      if (lines < 2) continue;
      title.first_line = static_cast<std::uint16_t>(lines - 1);
      title.line_count = 1;

      const interface::TextBitmap last = (*set_text)(title, text, width);

      EXPECT_GT(static_cast<float>(inked_width(last)), 1.3F * title.size)
          << text << " in " << width << " pixels";
    }
}

TEST(TextSetter, GivesTheSamePixelsTwice) {
  const auto set_text = make_text_setter();

  EXPECT_EQ((*set_text)(style("en"), "Chime Bells", 0).coverage,
            (*set_text)(style("en"), "Chime Bells", 0).coverage);
}

/// Sets a line in each of forty sizes, as a month's visitors would in time.
std::uint64_t ink_in_forty_sizes(const interface::SetText& set_text) {
  std::uint64_t sum = 0;
  for (int size = 10; size < 50; ++size) {
    interface::TextStyle of_size = style("en");
    of_size.size = static_cast<float>(size);
    const interface::TextBitmap bitmap = set_text(of_size, "The quick brown fox jumps over it", 0);
    sum += ink(bitmap, 0, bitmap.width);
  }
  return sum;
}

TEST(TextSetter, SetsLettersThatItHasForgottenAsItDidBefore) {
  const auto set_text = make_text_setter();
  const std::uint64_t before = ink_in_forty_sizes(*set_text);

  for (int again = 0; again < 3; ++again) {
    forget_letters();
    EXPECT_EQ(ink_in_forty_sizes(*set_text), before);
  }
}

TEST(TextSetter, GivesBackTheMemoryOfLettersThatItForgets) {
  const auto in_use = [] { return mallinfo2().uordblks; };
  const std::size_t without = in_use();
  if (const std::vector<std::byte> block(5000); in_use() <= without)
    GTEST_SKIP() << "the allocator is not glibc's";
  const auto set_text = make_text_setter();
  ink_in_forty_sizes(*set_text);
  forget_letters();

  const std::size_t before = in_use();
  ink_in_forty_sizes(*set_text);
  const std::size_t learnt = in_use() - before;
  forget_letters();

  EXPECT_GT(learnt, 500'000U);
  EXPECT_LT(in_use(), before + learnt / 10);
}

TEST(TextSetter, MayForgetWhileOthersAreSet) {
  const auto set_text = make_text_setter();
  const std::uint64_t before = ink_in_forty_sizes(*set_text);
  std::jthread other([&set_text](const std::stop_token& stop) {
    while (!stop.stop_requested()) (*set_text)(style("zh"), "青铜鼎", 0);
  });

  for (int again = 0; again < 3; ++again) {
    forget_letters();
    EXPECT_EQ(ink_in_forty_sizes(*set_text), before);
  }
}

TEST(TextSetter, SurvivesWhatIsNoText) {
  const auto set_text = make_text_setter();

  EXPECT_EQ((*set_text)(style("en"), "", 100).width, 0U);
  EXPECT_NO_FATAL_FAILURE((*set_text)(style("en"), "\xff\xfe broken", 100));
}

}  // namespace
}  // namespace docent::pango::text_setter_test
