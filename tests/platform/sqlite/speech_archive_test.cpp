#include "platform/sqlite/speech_archive.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "content/write/content_writer.h"
#include "tests/support/small_museum.h"
#include "tests/support/temporary_folder.h"

namespace docent::sqlite {
namespace {

class ASpeechArchive : public testing::Test {
 protected:
  ASpeechArchive() { write::write_museum(museum_, file_); }

  test::TemporaryFolder folder_;
  std::filesystem::path file_ = folder_.path() / "museum.db";
  Museum museum_ = test::small_museum();
};

TEST_F(ASpeechArchive, HoldsTheSoundsOfItsFileByTheirNumbers) {
  ASSERT_FALSE(museum_.speech.empty());
  const auto archive = open_speech_archive(file_, museum_.speech);
  ASSERT_NE(archive, nullptr);
  for (int round = 0; round < 2; ++round)
    for (std::uint32_t i = 0; i < museum_.speech.size(); ++i) {
      const auto packets = archive->packets(i);
      EXPECT_TRUE(std::ranges::equal(packets, museum_.speech[i].packets)) << i;
    }
  EXPECT_TRUE(archive->packets(static_cast<std::uint32_t>(museum_.speech.size())).empty());
}

TEST_F(ASpeechArchive, KeepsToItsFileWhenAnotherTakesTheName) {
  const auto archive = open_speech_archive(file_, museum_.speech);
  ASSERT_NE(archive, nullptr);
  std::ofstream(folder_.path() / "next.db") << "another release";
  std::filesystem::rename(folder_.path() / "next.db", file_);
  EXPECT_TRUE(std::ranges::equal(archive->packets(0), museum_.speech[0].packets));
}

TEST_F(ASpeechArchive, OfAFileWithOtherSpeechIsNone) {
  museum_.speech.front().made_of += "!";
  EXPECT_EQ(open_speech_archive(file_, museum_.speech), nullptr);
  museum_.speech = test::small_museum().speech;
  museum_.speech.pop_back();
  EXPECT_EQ(open_speech_archive(file_, museum_.speech), nullptr);
  EXPECT_EQ(open_speech_archive(folder_.path() / "missing.db", museum_.speech), nullptr);
  std::ofstream(folder_.path() / "text.db") << "this is no database at all, but long enough";
  EXPECT_EQ(open_speech_archive(folder_.path() / "text.db", museum_.speech), nullptr);
}

}  // namespace
}  // namespace docent::sqlite
