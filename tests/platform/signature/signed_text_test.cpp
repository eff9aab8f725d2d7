#include "platform/signature/signed_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace docent::signature::signed_text_test {
namespace {

using testing::HasSubstr;

const SecretKey ours = make_key(), next = make_key();
const std::vector known{public_key(ours)};
constexpr std::string_view text = "a release\nof two lines\n";

Result<std::string> read(std::string_view bytes, std::span<const PublicKey> keys = known) {
  return read_signed_text(bytes, Purpose::Release, keys, "release.txt");
}

TEST(ASignedText, IsReadByThoseWhoKnowOneOfItsKeys) {
  const std::string bytes = to_signed_text(text, Purpose::Release, std::vector{next, ours});

  EXPECT_EQ(read(bytes), text);
  EXPECT_EQ(read(bytes, std::vector{public_key(next)}), text);
  EXPECT_THAT(read(bytes, std::vector{public_key(make_key())}).error().what,
              HasSubstr("release.txt: is signed with another key"));
}

TEST(ASignedText, WithAnyByteChangedOrCutOffIsRefused) {
  const std::string whole = to_signed_text(text, Purpose::Release, std::vector{ours});
  for (std::size_t place = 0; place < whole.size(); ++place) {
    std::string changed = whole;
    changed[place] = changed[place] == 'x' ? 'y' : 'x';

    EXPECT_FALSE(read(changed)) << place;
    EXPECT_FALSE(read(whole.substr(0, place))) << place;
  }
}

TEST(ASignedText, TakesNothingThatWasAddedToIt) {
  const std::string whole = to_signed_text(text, Purpose::Release, std::vector{ours});

  EXPECT_FALSE(read("before\n" + whole));
  EXPECT_FALSE(read(whole + "after\n"));
  EXPECT_THAT(read("").error().what, HasSubstr("is not signed"));
  EXPECT_FALSE(read("\n"));
  EXPECT_FALSE(read(to_signed_text(text, Purpose::Database, std::vector{ours})));
}

}  // namespace
}  // namespace docent::signature::signed_text_test
