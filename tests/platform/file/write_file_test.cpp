#include "platform/file/write_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <span>
#include <string_view>

#include "tests/support/run_program.h"

namespace docent::file::write_file_test {
namespace {

using testing::HasSubstr;

std::span<const std::byte> bytes_of(std::string_view text) {
  return std::as_bytes(std::span(text));
}

std::ptrdiff_t files_in(const std::filesystem::path& folder) {
  return std::distance(std::filesystem::directory_iterator(folder), {});
}

TEST(ReplacingAFile, PutsTheNewBytesInItsPlace) {
  const test::TemporaryFolder folder;
  const auto name = folder.path() / "a";

  EXPECT_TRUE(replace_file(name, bytes_of("old")));
  EXPECT_TRUE(replace_file(name, bytes_of("new")));

  EXPECT_EQ(test::text_of(name), "new");
  EXPECT_EQ(files_in(folder.path()), 1);
}

TEST(ReplacingAFile, LeavesTheOldOneWhereTheDiskRefuses) {
  const test::TemporaryFolder folder;
  const auto occupied = folder.path() / "occupied";
  std::filesystem::create_directories(occupied / "not-empty");

  const auto replaced = replace_file(occupied, bytes_of("new"));

  ASSERT_FALSE(replaced.has_value());
  EXPECT_EQ(replaced.error().code, Errc::Environment);
  EXPECT_THAT(replaced.error().what, HasSubstr("occupied: cannot be written"));
  EXPECT_EQ(files_in(folder.path()), 1) << "left a temporary file behind";
}

TEST(CreatingAFile, NeverTouchesOneThatIsThere) {
  const test::TemporaryFolder folder;
  const auto name = folder.path() / "a.key";
  EXPECT_TRUE(create_file(name, bytes_of("first"), 0600));

  const auto second = create_file(name, bytes_of("second"));

  ASSERT_FALSE(second.has_value());
  EXPECT_THAT(second.error().what, HasSubstr("a.key: exists already"));
  EXPECT_EQ(test::text_of(name), "first");
  struct stat status{};
  ASSERT_EQ(::stat(name.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0600U);
}

}  // namespace
}  // namespace docent::file::write_file_test
