#include "runtime/search/index.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "runtime/search/fold.h"
#include "tests/runtime/search/made_title.h"

namespace docent::search::index_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Titles of which each is an entry.
Index index_of(std::initializer_list<std::string_view> titles) {
  IndexBuilder builder(static_cast<std::uint32_t>(titles.size()));
  std::uint32_t entry = 0;
  for (const std::string_view title : titles) builder.add(entry++, 0, 0, title);
  return std::move(builder).build();
}

std::vector<std::uint32_t> found(const Index& index, std::u16string_view typed,
                                 std::uint8_t language = 0) {
  SearchDesk desk;
  std::vector<std::uint32_t> entries;
  for (const Hit& hit : find(index, folded(typed), language, desk)) entries.push_back(hit.entry);
  return entries;
}

TEST(ASearch, FindsWhatBeginsSoBeforeWhatHoldsAWordThatBeginsSo) {
  const Index index = index_of({"The bronze mirror", "Bronze", "Bronze tripod", "A jade disc"});

  EXPECT_THAT(found(index, u"bronze"), ElementsAre(1, 2, 0));
  EXPECT_THAT(found(index, u"bro"), ElementsAre(1, 2, 0));
  EXPECT_THAT(found(index, u"BRÖNZE tri"), ElementsAre(2));
  EXPECT_THAT(found(index, u""), IsEmpty());
  EXPECT_THAT(found(index, u" "), IsEmpty());
}

TEST(ASearch, FindsWhatIsMisspelledAfterWhatIsNot) {
  const Index index = index_of({"Bonze", "Bronze tripod", "Caravaggio", "Boots"});

  EXPECT_THAT(found(index, u"bronz"), ElementsAre(1, 0));
  EXPECT_THAT(found(index, u"tirp"), ElementsAre(1)) << "neighbours swapped are one mistake";
  EXPECT_THAT(found(index, u"tripdo"), ElementsAre(1));
  EXPECT_THAT(found(index, u"carravagio"), ElementsAre(2)) << "two in a long word";
  EXPECT_THAT(found(index, u"bxx"), IsEmpty()) << "none in a short one";
}

TEST(ASearch, FindsInTheMiddleOfACompoundWhereNothingBeginsSo) {
  const Index index = index_of({"Bronzegefäß", "Glasschale"});

  EXPECT_THAT(found(index, u"gefas"), ElementsAre(0));
}

TEST(ASearch, FindsHangulByHalfASyllableAndByFirstConsonants) {
  const Index index = index_of({"세발 청동솥", "옥 원반", "청자 병"});

  EXPECT_THAT(found(index, u"ㅊㅓㅇ"), ElementsAre(2, 0));
  EXPECT_THAT(found(index, u"ㅊㅓㅇㄷ"), ElementsAre(0, 2)) << "the other has a letter wrong";
  EXPECT_THAT(found(index, u"ㅅㅗㅌ"), ElementsAre(0));
  EXPECT_THAT(found(index, u"ㅊㅈㅂ"), ElementsAre(2));
  EXPECT_THAT(found(index, u"ㅅㅂㅊㄷ"), ElementsAre(0));
}

TEST(ASearch, FindsChineseByPinyinAndItsInitials) {
  IndexBuilder builder(2);
  builder.add(0, 0, 0, "青铜鼎");
  builder.add_reading(0, 0, 0, "qīng tóng dǐng");
  builder.add(1, 0, 0, "玉璧");
  builder.add_reading(1, 0, 0, "yù bì");
  const Index index = std::move(builder).build();

  for (const std::u16string_view typed :
       {u"qingtong", u"qing tong", u"qtd", u"ding", u"qi", u"tongding", u"青", u"铜鼎"})
    EXPECT_THAT(found(index, typed), ElementsAre(0));
  EXPECT_THAT(found(index, u"yb"), ElementsAre(1));
  EXPECT_THAT(found(index, u"qintong"), ElementsAre(0)) << "n and ng";
}

TEST(ASearch, FindsWordsBehindArticlesAndWhereThereAreNoSpaces) {
  const Index index = index_of({"المرآة البرونزية", "L’Annonciation", "กระจกสำริด", "どうのかがみ"});

  EXPECT_THAT(found(index, u"برونز"), ElementsAre(0));
  EXPECT_THAT(found(index, u"annon"), ElementsAre(1));
  EXPECT_THAT(found(index, u"lann"), ElementsAre(1));
  EXPECT_THAT(found(index, u"สำริด"), ElementsAre(2));
  EXPECT_THAT(found(index, u"かかみ"), ElementsAre(3));
}

TEST(ASearch, FindsNumbersWhateverStandsBetweenTheirParts) {
  const Index index = index_of({"MET-2014.77", "17"});

  EXPECT_THAT(found(index, u"met 2014 77"), ElementsAre(0));
  EXPECT_THAT(found(index, u"2014"), ElementsAre(0));
  EXPECT_THAT(found(index, u"17"), ElementsAre(1));
}

TEST(ASearch, FindsAllOfAGroupAfterWhatHasTheName) {
  IndexBuilder builder(3);
  builder.add(0, 0, 0, "Mirror");
  builder.add(1, 0, 0, "Tripod");
  builder.add(2, 0, 0, "Bronze coin");
  builder.add(builder.add_group(std::array{0U, 1U}), 0, 10, "Bronze");
  const Index index = std::move(builder).build();

  EXPECT_THAT(found(index, u"bronze"), ElementsAre(2, 0, 1));
  EXPECT_THAT(found(index, u"bronze tri"), ElementsAre(1));
}

TEST(ASearch, PrefersTheVisitorsLanguage) {
  IndexBuilder builder(2);
  builder.add(0, 0, 0, "Vase");
  builder.add(1, 1, 0, "Vase");
  const Index index = std::move(builder).build();

  EXPECT_THAT(found(index, u"va", 0), ElementsAre(0, 1));
  EXPECT_THAT(found(index, u"va", 1), ElementsAre(1, 0));
}

TEST(ASearch, FindsEveryNameByEachOfItsBeginningsAndWithALetterWrong) {
  std::mt19937 random(7);
  constexpr std::uint32_t count = 300;
  IndexBuilder builder(count);
  std::vector<std::string> titles;
  for (std::uint32_t i = 0; i < count; ++i) {
    titles.push_back(test::made_title(random, static_cast<int>(i % 5)));
    builder.add(i, 0, 0, titles.back());
  }
  const Index index = std::move(builder).build();

  for (std::uint32_t i = 0; i < count; ++i) {
    const std::u16string whole = folded(titles[i]);
    for (std::size_t length = 1; length <= std::min<std::size_t>(whole.size(), 30); ++length)
      EXPECT_THAT(found(index, whole.substr(0, length)), testing::Contains(i)) << titles[i];
    std::u16string first = whole.substr(0, whole.find(u' '));
    if (first.size() < 4) continue;
    first[first.size() / 2] = first[first.size() / 2] == u'a' ? u'b' : u'a';
    EXPECT_THAT(found(index, first), testing::Contains(i)) << titles[i];
  }
}

}  // namespace
}  // namespace docent::search::index_test
