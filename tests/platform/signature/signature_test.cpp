#include "platform/signature/signature.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <span>
#include <string_view>
#include <vector>

namespace docent::signature::signature_test {
namespace {

using testing::HasSubstr;

std::span<const std::byte> bytes_of(std::string_view text) {
  return std::as_bytes(std::span(text));
}

const SecretKey ours = make_key(), theirs = make_key();
const std::vector<PublicKey> known{public_key(ours)};

TEST(Signature, IsOfItsMessageKeyAndPurpose) {
  const std::vector signatures{sign(Purpose::Database, bytes_of("a museum"), ours)};

  EXPECT_TRUE(is_signed(Purpose::Database, bytes_of("a museum"), signatures, known));
  EXPECT_FALSE(is_signed(Purpose::Database, bytes_of("b museum"), signatures, known));
  EXPECT_FALSE(is_signed(Purpose::Release, bytes_of("a museum"), signatures, known));
  EXPECT_FALSE(is_signed(Purpose::Database, bytes_of("a museum"), {}, known));
  EXPECT_FALSE(is_signed(Purpose::Database, bytes_of("a museum"), signatures, {}));
}

TEST(Signature, IsTheSameEveryTime) {
  EXPECT_EQ(sign(Purpose::Release, bytes_of("7"), ours),
            sign(Purpose::Release, bytes_of("7"), ours));
}

RC_GTEST_PROP(Signature, WithAFlippedBitIsWrong, ()) {
  const auto message = *rc::gen::arbitrary<std::string>();
  Signature signature = sign(Purpose::Release, bytes_of(message), ours);
  signature.bytes[*rc::gen::inRange<std::size_t>(0, 64)] ^=
      static_cast<std::byte>(1U << *rc::gen::inRange(0U, 8U));

  RC_ASSERT(!is_signed(Purpose::Release, bytes_of(message), {&signature, 1}, known));
}

TEST(Signatures, OfTwoKeysServeKiosksThatKnowEither) {
  std::vector<Signature> signatures;
  put(sign(Purpose::Database, bytes_of("m"), ours), signatures);
  put(sign(Purpose::Database, bytes_of("m"), theirs), signatures);
  put(sign(Purpose::Database, bytes_of("m"), ours), signatures);

  EXPECT_EQ(signatures.size(), 2U);
  EXPECT_TRUE(is_signed(Purpose::Database, bytes_of("m"), signatures, known));
  EXPECT_TRUE(
      is_signed(Purpose::Database, bytes_of("m"), signatures, std::vector{public_key(theirs)}));
}

TEST(Signatures, ThatDoNotSufficeAreExplained) {
  const std::vector foreign{sign(Purpose::Database, bytes_of("m"), theirs)};
  std::vector wrong{sign(Purpose::Database, bytes_of("m"), ours)};
  wrong[0].bytes[0] ^= std::byte{1};

  EXPECT_EQ(why_not_signed({}, known), "is not signed");
  EXPECT_EQ(why_not_signed(wrong, known), "has a wrong signature");
  EXPECT_THAT(why_not_signed(foreign, known),
              HasSubstr("is signed with another key (" + name_of(foreign[0].key)));
}

}  // namespace
}  // namespace docent::signature::signature_test
