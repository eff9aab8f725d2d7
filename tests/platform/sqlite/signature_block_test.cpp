#include "platform/sqlite/signature_block.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <span>
#include <vector>

#include "content/write/content_writer.h"
#include "content/write/replace_file.h"
#include "platform/sqlite/content_reader.h"
#include "tests/support/small_museum.h"
#include "tests/support/temporary_folder.h"

namespace docent::sqlite::signature_block_test {
namespace {

using signature::make_key;
using signature::public_key;
using signature::SecretKey;
using testing::HasSubstr;

using File = std::vector<std::byte>;

class ASignedDatabase : public testing::Test {
 protected:
  Result<Database> open(const File& bytes) const {
    write::replace_file(name_, bytes);
    return open_database(name_);
  }
  File sign(const File& bytes, const SecretKey& key) const {
    return signed_file(open(bytes).value(), name_, key).value();
  }
  Result<void> check(const File& bytes, const SecretKey& key) const {
    return check_signature(open(bytes).value(), name_, std::vector{public_key(key)});
  }

  const File unsigned_ = write::encode_museum(test::small_museum());
  const SecretKey ours_ = make_key(), theirs_ = make_key();
  test::TemporaryFolder folder_;
  const std::filesystem::path name_ = folder_.path() / "museum.db";
};

TEST_F(ASignedDatabase, IsTheUnsignedOneAndABlockAfterIt) {
  const File file = sign(unsigned_, ours_);

  EXPECT_TRUE(std::equal(unsigned_.begin(), unsigned_.end(), file.begin()));
  EXPECT_EQ(file.size(), unsigned_.size() + 16 + 1 + 72 + 16);
  EXPECT_TRUE(check(file, ours_).has_value());
  EXPECT_TRUE(load_museum(name_).has_value());
}

TEST_F(ASignedDatabase, IsTheSameHoweverOftenItIsSigned) {
  const File once = sign(unsigned_, ours_);

  EXPECT_EQ(sign(once, ours_), once);
}

TEST_F(ASignedDatabase, MayCarrySeveralSignaturesWhileKeysAreRotated) {
  const File both = sign(sign(unsigned_, ours_), theirs_);

  EXPECT_TRUE(check(both, ours_).has_value());
  EXPECT_TRUE(check(both, theirs_).has_value());
  const auto fifth =
      signed_file(open(sign(sign(both, make_key()), make_key())).value(), name_, make_key());
  ASSERT_FALSE(fifth.has_value());
  EXPECT_THAT(fifth.error().what, HasSubstr("holds 4 signatures already"));
}

TEST_F(ASignedDatabase, IsRefusedByThoseWhoKnowAnotherKey) {
  EXPECT_THAT(check(unsigned_, ours_).error().what, HasSubstr("museum.db: is not signed"));
  EXPECT_THAT(check(sign(unsigned_, theirs_), ours_).error().what,
              HasSubstr("is signed with another key"));
}

TEST_F(ASignedDatabase, CannotLendItsSignatureToOtherContent) {
  Museum other = test::small_museum();
  other.title["en"] = "Another museum";
  const File mine = sign(unsigned_, ours_);
  File forged = write::encode_museum(other);
  forged.insert(forged.end(), mine.begin() + static_cast<std::ptrdiff_t>(unsigned_.size()),
                mine.end());

  EXPECT_THAT(check(forged, ours_).error().what, HasSubstr("has a wrong signature"));
}

TEST_F(ASignedDatabase, WithAnyByteOfItsBlockChangedIsDamaged) {
  const File whole = sign(unsigned_, ours_);
  for (std::size_t place = unsigned_.size(); place < whole.size(); ++place) {
    File file = whole;
    file[place] ^= std::byte{0x40};

    const auto opened = open(file);

    ASSERT_FALSE(opened.has_value()) << place;
    EXPECT_EQ(opened.error().code, Errc::Damaged);
  }
}

TEST_F(ASignedDatabase, ThatIsCutShortIsDamagedOrUnsigned) {
  const File whole = sign(unsigned_, ours_);
  for (std::size_t size = unsigned_.size() + 1; size < whole.size(); ++size)
    EXPECT_FALSE(open({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)}));

  EXPECT_EQ(check(unsigned_, ours_).error().code, Errc::InvalidInput);
}

}  // namespace
}  // namespace docent::sqlite::signature_block_test
