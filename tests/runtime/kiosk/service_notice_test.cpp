#include "runtime/kiosk/service_notice.h"

#include <gmock/gmock.h>

#include <csignal>

#include "runtime/kiosk/allocations.h"
#include "tests/support/datagrams.h"
#include "tests/support/run_program.h"
#include "tests/support/sample_database.h"
#include "tests/support/started_program.h"

namespace docent::kiosk::service_notice_test {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;
using testing::Optional;
using testing::StartsWith;

class AServiceNotice : public testing::Test {
 protected:
  ServiceNotice notice(std::chrono::microseconds patience = 10s) const {
    return {service::NotifySocket(manager_.path().c_str()), patience, 100s};
  }
  std::optional<std::string> told() const { return manager_.next(); }
  int signs() const {
    int count = 0;
    while (told() == "WATCHDOG=1") ++count;
    return count;
  }

  test::Datagrams manager_;
};

TEST_F(AServiceNotice, SaysReadyWithTheFirstFrameAndNotBefore) {
  ServiceNotice notice = this->notice();
  notice.starts("reads the database");
  EXPECT_THAT(told(), Optional(StartsWith("STATUS=starts: reads the database\n")));

  notice.frame_presented(101s);

  EXPECT_EQ(told(), "READY=1");
  EXPECT_TRUE(notice.was_ready());
}

TEST_F(AServiceNotice, GivesASignOfLifeFourTimesWithinTheManagersPatience) {
  ServiceNotice notice = this->notice(10s);
  notice.frame_presented(101s);
  ASSERT_EQ(told(), "READY=1");

  for (auto frame = 0ms; frame < 10s; frame += 16ms) notice.frame_presented(101s + frame);

  EXPECT_EQ(signs(), 3);  // the first was that it is ready
}

TEST_F(AServiceNotice, GivesNoSignWhileNoFrameIsPresented) {
  ServiceNotice notice = this->notice(10s);
  notice.frame_presented(101s);
  ASSERT_EQ(told(), "READY=1");

  EXPECT_EQ(told(), std::nullopt);
  notice.frame_presented(120s);
  EXPECT_EQ(told(), "WATCHDOG=1");
}

TEST_F(AServiceNotice, TakesADeliberateIdlenessForLife) {
  ServiceNotice notice = this->notice(10s);

  notice.idle(101s);  // there is no screen
  EXPECT_EQ(told(), "READY=1");
  notice.idle(104s);
  EXPECT_EQ(told(), "WATCHDOG=1");
}

TEST_F(AServiceNotice, AsksForMorePatienceOnASlowMachine) {
  ServiceNotice notice = this->notice(10s);

  notice.frame_presented(100s + 40s);
  EXPECT_EQ(told(), "READY=1\nWATCHDOG_USEC=120000000");

  notice.frame_presented(140s + 29s);
  EXPECT_EQ(told(), std::nullopt);
  notice.frame_presented(140s + 30s);
  EXPECT_EQ(told(), "WATCHDOG=1");
}

TEST_F(AServiceNotice, GivesNoSignToAManagerThatDoesNotWatch) {
  ServiceNotice notice = this->notice(0s);
  for (auto time = 101s; time < 1000s; time += 1s) notice.frame_presented(time);

  EXPECT_EQ(told(), "READY=1");
  EXPECT_EQ(told(), std::nullopt);
}

TEST_F(AServiceNotice, AllocatesNothing) {
  ServiceNotice notice = this->notice(10s);
  const std::uint64_t before = allocations_on_this_thread().all;

  notice.starts("reads the database");
  for (auto time = 101s; time < 200s; time += 1s) notice.frame_presented(time);
  notice.shows(std::string_view("a museum"));

  EXPECT_EQ(allocations_on_this_thread().all, before);
}

TEST_F(AServiceNotice, CutsATitleThatIsTooLong) {
  ServiceNotice notice = this->notice();
  notice.shows(std::string(1000, 'x'));

  EXPECT_THAT(told(), Optional(testing::SizeIs(256)));
}

/// The lines that a kiosk tells its manager in a run without a screen.
TEST_F(AServiceNotice, TellsOfAWholeRun) {
  setenv("NOTIFY_SOCKET", manager_.path().c_str(), 1);
  setenv("WATCHDOG_USEC", "1000", 1);  // so short that every frame gives a sign
  const test::TemporaryFolder folder;
  test::StartedProgram kiosk(test::program("docent"),
                             {"--content", test::sample_database(), "--display", "headless",
                              "--size", "64x64", "--seconds", "10000"},
                             folder.path() / "said");
  unsetenv("NOTIFY_SOCKET");
  unsetenv("WATCHDOG_USEC");

  std::string all;
  EXPECT_TRUE(kiosk.runs_until([&] {
    while (const auto line = told()) all += *line + '\n';
    return all.find("\nWATCHDOG=1\n") != std::string::npos;
  }));
  kiosk.signal(SIGTERM);
  EXPECT_EQ(kiosk.wait(), 0);
  while (const auto line = told()) all += *line + '\n';

  const auto place = [&](const char* line) { return all.find(line); };
  EXPECT_LT(place("STATUS=starts: opens the screen"), place("STATUS=starts: reads the database"));
  EXPECT_LT(place("STATUS=starts: reads the database"), place("STATUS=shows '"));
  EXPECT_LT(place("STATUS=shows '"), place("READY=1"));
  EXPECT_LT(place("READY=1"), place("\nWATCHDOG=1\n"));
  EXPECT_THAT(all, HasSubstr("STOPPING=1\n"));
}

/// The manager starts it again at once, so the program itself waits for what may come.
TEST_F(AServiceNotice, OfAStartThatFailsComesWithAPause) {
  setenv("NOTIFY_SOCKET", manager_.path().c_str(), 1);
  const test::TemporaryFolder folder;
  const auto begun = std::chrono::steady_clock::now();
  test::StartedProgram kiosk(
      test::program("docent"),
      {"--content", "/there/is/none.db", "--display", "headless", "--size", "64x64"},
      folder.path() / "said");
  unsetenv("NOTIFY_SOCKET");

  EXPECT_EQ(kiosk.wait(), 3);
  EXPECT_GE(std::chrono::steady_clock::now() - begun, 2s);
  EXPECT_THAT(test::text_of(folder.path() / "said"), HasSubstr("there is no such database"));
  while (const auto line = told()) EXPECT_EQ(line->find("READY=1"), std::string::npos) << *line;
}

}  // namespace
}  // namespace docent::kiosk::service_notice_test
