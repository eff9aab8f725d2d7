#include "platform/signature/digest.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string_view>

#include "tests/support/temporary_folder.h"

namespace docent::signature::digest_test {
namespace {

std::string digest_of_parts(std::string_view first, std::string_view second) {
  Digest digest;
  digest.add(std::as_bytes(std::span(first)));
  digest.add(std::as_bytes(std::span(second)));
  return digest.finish();
}

TEST(Digest, IsTheBlake2bThatOtherToolsMake) {
  // printf abc | b2sum -l 256
  EXPECT_EQ(digest_of_parts("a", "bc"),
            "bddd813c634239723171ef3fee98579b94964e3bb1cb3e427262c8c068d52319");
}

TEST(Digest, OfAFileIsThatOfItsBytes) {
  const test::TemporaryFolder folder;
  std::ofstream(folder.path() / "a") << "abc";

  EXPECT_EQ(digest_of(folder.path() / "a"), digest_of_parts("abc", ""));
  EXPECT_FALSE(digest_of(folder.path() / "b"));
}

}  // namespace
}  // namespace docent::signature::digest_test
