#include "platform/terminal/value.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace docent::terminal {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string take(const Value& value, const std::vector<std::string>& words) {
  return value.take(words);
}

TEST(Value, OfAFewWordsStandsForOneAndSuggestsIt) {
  int legs = 0;
  const Value animal = one_of<int>({{"horse", 4}, {"goose", 2}}, legs);

  EXPECT_EQ(animal.name, "horse|goose");
  EXPECT_EQ(take(animal, {"goose"}), "");
  EXPECT_EQ(legs, 2);
  EXPECT_EQ(take(animal, {"hrose"}), "'hrose' is none of horse, goose; did you mean 'horse'?");
  EXPECT_EQ(legs, 2);
}

TEST(Value, OfNumbersWithCommasHasAllOfThemAndTheyAreFinite) {
  std::optional<std::array<double, 2>> point;
  const Value value = numbers("X,Y", point);

  EXPECT_EQ(take(value, {"1.5,-2"}), "");
  EXPECT_THAT(*point, ElementsAre(1.5, -2));
  for (const char* bad : {"1", "1,2,3", "1;2", "nan,1", "1,inf", "", "1,"})
    EXPECT_EQ(take(value, {bad}),
              "'" + std::string(bad) + "' is not 2 numbers with a comma between");
}

TEST(Value, OfAListReplacesWhatWasThereBefore) {
  std::vector<std::string> layers{"walls"};

  EXPECT_EQ(take(list("NAME,...", layers), {"a,b", "c"}), "");

  EXPECT_THAT(layers, ElementsAre("a", "b", "c"));
}

TEST(Value, OfANumberSaysWhatItHasToBe) {
  double any = 0;
  EXPECT_THAT(take(number("N", {}, any), {"x"}), HasSubstr("is not a number"));
  EXPECT_THAT(take(number("N", not_negative, any), {"-0.1"}), HasSubstr("of at least 0"));
  EXPECT_EQ(take(number("N", not_negative, any), {"+1e2"}), "");
  EXPECT_EQ(any, 100);
}

}  // namespace
}  // namespace docent::terminal
