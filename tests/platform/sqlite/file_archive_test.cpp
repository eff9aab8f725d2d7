#include "platform/sqlite/file_archive.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <vector>

#include "content/write/content_writer.h"
#include "platform/sqlite/database.h"
#include "tests/support/small_museum.h"
#include "tests/support/temporary_folder.h"

namespace docent::sqlite::file_archive_test {
namespace {

class AFileArchive : public testing::Test {
 protected:
  AFileArchive() {
    write::write_museum(museum_, file_);
    checksum_ = checksum_text(open_database(file_).value());
  }

  test::TemporaryFolder folder_;
  std::filesystem::path file_ = folder_.path() / "museum.db";
  Museum museum_ = test::small_museum();
  std::string checksum_;
};

TEST_F(AFileArchive, HoldsSoundsAndPicturesByTheirIndices) {
  ASSERT_FALSE(museum_.speech.empty());
  ASSERT_FALSE(museum_.images.empty());
  const auto sounds = open_archive(file_, Archived::Speech, checksum_);
  const auto pictures = open_archive(file_, Archived::Images, checksum_);
  ASSERT_NE(sounds, nullptr);
  ASSERT_NE(pictures, nullptr);
  for (int round = 0; round < 2; ++round) {
    for (std::uint32_t i = 0; i < museum_.speech.size(); ++i)
      EXPECT_TRUE(std::ranges::equal(sounds->read(i), museum_.speech[i].packets)) << i;
    for (std::uint32_t i = 0; i < museum_.images.size(); ++i)
      EXPECT_TRUE(std::ranges::equal(pictures->read(i), museum_.images[i].bytes)) << i;
  }
  EXPECT_TRUE(sounds->read(static_cast<std::uint32_t>(museum_.speech.size())).empty());
}

TEST_F(AFileArchive, ReadsPartsOfALongOneInAnyOrder) {
  std::vector<std::byte> bytes(300'000);
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = std::byte(i * 2654435761U >> 13U);
  museum_.images.push_back({.name = "b.webm", .width = 2, .height = 3, .bytes = bytes});
  write::write_museum(museum_, file_);
  const auto number = static_cast<std::uint32_t>(museum_.images.size() - 1);
  const auto archive =
      open_archive(file_, Archived::Images, checksum_text(open_database(file_).value()));
  ASSERT_NE(archive, nullptr);
  std::vector<std::byte> part(1000);
  for (const std::size_t from : {0U, 299'000U, 4090U, 150'000U}) {
    ASSERT_TRUE(archive->read_part(number, from, part));
    EXPECT_TRUE(std::ranges::equal(part, std::span(bytes).subspan(from, 1000))) << from;
  }
  EXPECT_FALSE(archive->read_part(number, 299'001, part)) << "beyond its end";
  EXPECT_FALSE(archive->read_part(number, std::size_t{1} << 40U, part));
  EXPECT_FALSE(archive->read_part(number + 1, 0, part)) << "there is none";
  EXPECT_TRUE(std::ranges::equal(archive->read(0), museum_.images[0].bytes)) << "another, whole";
  EXPECT_TRUE(archive->read_part(number, 0, part));
  archive->let_go();
  EXPECT_TRUE(archive->read_part(number, 0, part));
}

TEST_F(AFileArchive, KeepsToItsFileWhenAnotherTakesTheName) {
  const auto archive = open_archive(file_, Archived::Speech, checksum_);
  ASSERT_NE(archive, nullptr);
  std::ofstream(folder_.path() / "next.db") << "another release";
  std::filesystem::rename(folder_.path() / "next.db", file_);
  EXPECT_TRUE(std::ranges::equal(archive->read(0), museum_.speech[0].packets));
}

TEST_F(AFileArchive, ReadsAFileWithSignaturesBehindIt) {
  std::ofstream(file_, std::ios::app | std::ios::binary) << std::string(333, 's');
  const auto archive = open_archive(file_, Archived::Images, checksum_);
  ASSERT_NE(archive, nullptr);
  EXPECT_TRUE(std::ranges::equal(archive->read(0), museum_.images[0].bytes));
}

TEST_F(AFileArchive, OfAFileThatCannotBeWrittenIsRead) {
  std::filesystem::permissions(file_, std::filesystem::perms::owner_read);
  std::filesystem::permissions(
      folder_.path(), std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
  EXPECT_NE(open_archive(file_, Archived::Images, checksum_), nullptr);
  std::filesystem::permissions(folder_.path(), std::filesystem::perms::owner_all);
}

TEST_F(AFileArchive, OfAnotherFileIsNone) {
  museum_.title["en"] += "!";
  write::write_museum(museum_, file_);
  EXPECT_EQ(open_archive(file_, Archived::Images, checksum_), nullptr);
  EXPECT_EQ(open_archive(file_, Archived::Images, ""), nullptr);
  EXPECT_EQ(open_archive(folder_.path() / "missing.db", Archived::Images, checksum_), nullptr);
  std::ofstream(folder_.path() / "text.db") << "this is no database at all, but long enough";
  EXPECT_EQ(open_archive(folder_.path() / "text.db", Archived::Images, checksum_), nullptr);
}

TEST_F(AFileArchive, GivesNothingOfAFileThatWasCutShortSince) {
  const auto archive = open_archive(file_, Archived::Images, checksum_);
  ASSERT_NE(archive, nullptr);
  std::filesystem::resize_file(file_, 4096);
  archive->read(0);  // whatever that is, nothing breaks
  EXPECT_TRUE(archive->read(70'000).empty());
}

}  // namespace
}  // namespace docent::sqlite::file_archive_test
