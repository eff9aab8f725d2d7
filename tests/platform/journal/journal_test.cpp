#include "platform/journal/journal.h"

#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>

#include "tests/support/datagrams.h"

namespace docent::journal::journal_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Optional;

TEST(Journal, IsToldInItsOwnForm) {
  const test::Datagrams journal;

  ASSERT_TRUE(send(journal.path().c_str(), Message::DeviceGone, "/dev/hidraw0: is gone"));

  EXPECT_EQ(journal.next().value_or(""),
            "SYSLOG_IDENTIFIER=docent\nMESSAGE_ID=a6976ae455f5480d8aa85fa24c48e646\nPRIORITY=5\n"
            "MESSAGE\n" +
                std::string("\x15\0\0\0\0\0\0\0", 8) + "/dev/hidraw0: is gone\n");
}

TEST(Journal, TakesASentenceOfSeveralLinesForOneMessage) {
  const test::Datagrams journal;

  ASSERT_TRUE(send(journal.path().c_str(), Message::Refused, "one\nPRIORITY=0"));

  EXPECT_THAT(journal.next(),
              Optional(AllOf(HasSubstr("PRIORITY=3\n"), HasSubstr("one\nPRIORITY=0\n"))));
}

TEST(Journal, ThatIsNotThereIsNotWaitedFor) {
  EXPECT_FALSE(send("/there/is/none", Message::Shows, "a museum"));
}

TEST(Journal, IsWhatJournalStreamNames) {
  std::array<int, 2> ends{};
  ASSERT_EQ(pipe(ends.data()), 0);
  struct stat file{};
  ASSERT_EQ(fstat(ends[1], &file), 0);
  const std::string stream = std::to_string(file.st_dev) + ":" + std::to_string(file.st_ino);

  EXPECT_TRUE(is_journal(ends[1], stream.c_str()));
  EXPECT_FALSE(is_journal(ends[1], (stream + "0").c_str()));
  EXPECT_FALSE(is_journal(ends[1], "rubbish"));
  EXPECT_FALSE(is_journal(ends[1], nullptr));
  close(ends[0]);
  close(ends[1]);
}

TEST(Telling, GoesToStandardErrorWhereThatIsNotTheJournal) {
  testing::internal::CaptureStderr();
  tell(Message::Shows, "shows 'A museum'");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "docent: shows 'A museum'\n");
}

TEST(Telling, RemembersTheLastProblem) {
  testing::internal::CaptureStderr();
  tell(Message::Refused, "museum.db: is cut short");
  tell(Message::TakenUp, "has taken up 'A museum'");
  testing::internal::GetCapturedStderr();

  EXPECT_EQ(last_problem(), "museum.db: is cut short");
}

TEST(Telling, RemembersAsMuchOfAProblemAsItHasRoomFor) {
  testing::internal::CaptureStderr();
  tell(Message::Refused, std::string(10'000, 'x'));
  testing::internal::GetCapturedStderr();

  EXPECT_EQ(last_problem(), std::string(512, 'x'));
}

}  // namespace
}  // namespace docent::journal::journal_test
