#include "platform/pin/pin.h"

#include <gmock/gmock.h>

namespace docent::pin::pin_test {
namespace {

using testing::StartsWith;

TEST(Pin, IsKnownAgainByItsHashAndByNoOther) {
  const auto made = hash("471199");
  ASSERT_TRUE(made.has_value());

  EXPECT_THAT(*made, StartsWith("$argon2id$"));
  EXPECT_TRUE(matches("471199", *made));
  EXPECT_FALSE(matches("471198", *made));
  EXPECT_FALSE(matches("", *made));
  EXPECT_NE(*hash("471199"), *made) << "the same PIN of two kiosks does not show";
}

TEST(Pin, IsFourToTwelveFigures) {
  EXPECT_TRUE(is_pin("0000"));
  EXPECT_FALSE(is_pin("123"));
  EXPECT_FALSE(is_pin("1234567890123"));
  EXPECT_FALSE(is_pin("12 34"));
  EXPECT_EQ(hash("12a4").error().code, Errc::InvalidInput);
}

TEST(Pin, OfABrokenHashIsNone) {
  for (const char* broken : {"", "$argon2id$", "$argon2id$v=19$m=16384,t=3,p=1$AAAA$AAAA", "1234"})
    EXPECT_FALSE(matches("1234", broken)) << broken;
  EXPECT_FALSE(matches("1234", std::string(5000, '$')));
}

}  // namespace
}  // namespace docent::pin::pin_test
