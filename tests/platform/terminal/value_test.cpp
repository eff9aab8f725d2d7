#include "platform/terminal/value.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace docent::terminal::value_test {
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
    EXPECT_EQ(take(value, {bad}), fmt::format("'{}' is not 2 numbers with a comma between", bad));
}

TEST(Value, OfAListReplacesWhatWasThereBefore) {
  std::vector<std::string> layers{"walls"};

  EXPECT_EQ(take(list("NAME,...", layers), {"a,b", "c"}), "");

  EXPECT_THAT(layers, ElementsAre("a", "b", "c"));
}

TEST(Value, OfANumberSaysWhatItHasToBe) {
  double any = 0;
  EXPECT_THAT(take(number("N", {}, any), {"x"}), HasSubstr("is not a number"));
  EXPECT_EQ(take(number("N", not_negative, any), {"-0.1"}), "'-0.1' is not a number of 0 or more");
  EXPECT_EQ(take(number("N", positive, any), {"0"}), "'0' is not a number of more than 0");
  EXPECT_EQ(take(number("N", {.least = 0, .most = 10}, any), {"11"}),
            "'11' is not a number between 0 and 10");
  EXPECT_EQ(take(number("N", not_negative, any), {"+1e2"}), "");
  EXPECT_EQ(any, 100);
}

TEST(Value, OfANumberIsPlainFiniteDigitsAndNothingElse) {
  double radius = 0.25;
  for (const char* bad :
       {"nan",  "NAN",   "nan(1)", "-nan", "inf", "-inf", "infinity", "1e400", "-1",  "0x10",
        "0.5m", "1_000", "1e",     "",     " ",   " 1",   "1 ",       "+-1",   "++1", "."})
    EXPECT_EQ(take(number("R", not_negative, radius), {bad}),
              fmt::format("'{}' is not a number of 0 or more", bad));
  EXPECT_EQ(radius, 0.25);
}

TEST(Value, OfANumberWithACommaSaysHowItIsWritten) {
  double radius = 0;
  EXPECT_EQ(take(number("R", not_negative, radius), {"0,25"}),
            "'0,25' is not a number of 0 or more; did you mean 0.25?");
  EXPECT_EQ(take(number("R", not_negative, radius), {"-0,25"}),
            "'-0,25' is not a number of 0 or more");
}

TEST(Value, OfANegativeZeroIsZero) {
  double radius = 1;
  EXPECT_EQ(take(number("R", not_negative, radius), {"-0"}), "");
  EXPECT_FALSE(std::signbit(radius));
}

}  // namespace
}  // namespace docent::terminal::value_test
