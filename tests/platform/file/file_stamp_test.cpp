#include "platform/file/file_stamp.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/temporary_folder.h"

namespace docent::file::file_stamp_test {
namespace {

TEST(AFileStamp, IsAnotherOnceTheFileIsAnother) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "a", other = folder.path() / "b";
  EXPECT_EQ(stamp_of(file), FileStamp{});

  std::ofstream(file) << "one";
  const FileStamp first = stamp_of(file);
  EXPECT_NE(first, FileStamp{});
  EXPECT_EQ(stamp_of(file), first);

  std::ofstream(file) << "longer";
  const FileStamp second = stamp_of(file);
  EXPECT_NE(second, first);

  std::ofstream(other) << "longer";
  std::filesystem::last_write_time(other, std::filesystem::last_write_time(file));
  std::filesystem::rename(other, file);
  EXPECT_NE(stamp_of(file), second);
}

}  // namespace
}  // namespace docent::file::file_stamp_test
