#include "config/alike.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace docent::config::alike_test {
namespace {

std::vector<Diagnostic> many(int count) {
  std::vector<Diagnostic> all;
  for (int i = 0; i < count; ++i)
    all.push_back(
        {.code = "no-picture", .message = "exhibit 'x" + std::to_string(i) + "' has none"});
  return all;
}

TEST(Alike, FiveHundredLinesBecomeThreeAndACount) {
  const std::vector<Diagnostic> fewer = without_alike(many(500));

  ASSERT_EQ(fewer.size(), 3U);
  EXPECT_THAT(fewer.back().hint, testing::HasSubstr("and 497 more like this"));
}

TEST(Alike, AFewAreToldOneByOne) {
  EXPECT_EQ(without_alike(many(5)).size(), 5U);
}

TEST(Alike, OtherMistakesAreNotLostAmongThem) {
  std::vector<Diagnostic> all = many(10);
  all.insert(all.begin() + 5, {.code = "no-picture", .message = "something else"});

  EXPECT_THAT(without_alike(all), testing::SizeIs(4));
}

}  // namespace
}  // namespace docent::config::alike_test
