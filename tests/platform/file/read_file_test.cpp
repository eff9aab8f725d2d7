#include "platform/file/read_file.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <fstream>
#include <thread>

#include "tests/support/temporary_folder.h"

namespace docent::file::read_file_test {
namespace {

using testing::HasSubstr;

TEST(ReadFile, GivesEveryByte) {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "bytes";
  std::string bytes(200000, 'x');
  bytes[7] = '\0';
  std::ofstream(file, std::ios::binary) << bytes;

  const Result<std::string> read = read_file(file);

  ASSERT_TRUE(read.has_value()) << read.error().what;
  EXPECT_EQ(*read, bytes);
}

TEST(ReadFile, OfAFolderSaysThatItIsOne) {
  const test::TemporaryFolder folder;

  const Result<std::string> read = read_file(folder.path());

  ASSERT_FALSE(read.has_value());
  EXPECT_THAT(read.error().what, HasSubstr(folder.path().string() + ": is a folder"));
}

TEST(ReadFile, OfAMissingFileSaysSo) {
  const Result<std::string> read = read_file("/nonexistent/file");

  ASSERT_FALSE(read.has_value());
  EXPECT_EQ(read.error().code, Errc::NotFound);
  EXPECT_THAT(read.error().what, HasSubstr("/nonexistent/file"));
}

// As with a node of sysfs whose device goes between opening and reading: here the first page of
// this process's memory, which nobody can read.
TEST(ReadFile, ThatFailsInTheMiddleIsASentenceAndNotAnException) {
  const Result<std::string> read = read_file("/proc/self/mem");

  ASSERT_FALSE(read.has_value());
  EXPECT_EQ(read.error().code, Errc::Environment);
  EXPECT_THAT(read.error().what, HasSubstr("cannot be read to its end"));
}

TEST(ReadFile, StopsAtTheMostThatIsWanted) {
  const Result<std::string> read = read_file("/dev/zero", 1000000);

  ASSERT_FALSE(read.has_value());
  EXPECT_THAT(read.error().what, HasSubstr("larger than 1000000 bytes"));
}

TEST(ReadFile, TakesAPipe) {
  const test::TemporaryFolder folder;
  const std::filesystem::path pipe = folder.path() / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const std::jthread writer([&] { std::ofstream(pipe) << "through a pipe"; });

  EXPECT_EQ(read_file(pipe).value_or(""), "through a pipe");
}

}  // namespace
}  // namespace docent::file::read_file_test
