#include "platform/service/notify_socket.h"

#include <gmock/gmock.h>

#include "tests/support/datagrams.h"

namespace docent::service::notify_socket_test {
namespace {

using testing::Optional;

TEST(NotifySocket, CarriesLinesToTheManager) {
  const test::Datagrams manager;
  NotifySocket socket(manager.path().c_str());

  EXPECT_TRUE(socket.is_there());
  EXPECT_TRUE(socket.tell("READY=1\nSTATUS=shows a museum"));

  EXPECT_THAT(manager.next(), Optional(std::string("READY=1\nSTATUS=shows a museum")));
  EXPECT_EQ(manager.next(), std::nullopt);
}

TEST(NotifySocket, WithoutAManagerTellsNobody) {
  for (const char* name : {static_cast<const char*>(nullptr), "", "relative", "/there/is/none"}) {
    NotifySocket socket(name);

    EXPECT_FALSE(socket.is_there());
    EXPECT_FALSE(socket.tell("READY=1"));
  }
}

TEST(NotifySocket, DoesNotWaitForAManagerThatReadsNothing) {
  const test::Datagrams manager;
  NotifySocket socket(manager.path().c_str());

  int taken = 0;
  while (taken < 100'000 && socket.tell("WATCHDOG=1")) ++taken;

  EXPECT_GT(taken, 0);
  EXPECT_LT(taken, 100'000);  // its queue was full, and we are here
}

TEST(Watchdog, IsForTheProcessThatTheManagerNames) {
  const std::string own = std::to_string(getpid());

  EXPECT_EQ(watchdog_patience("10000000", own.c_str()), std::chrono::seconds(10));
  EXPECT_EQ(watchdog_patience("10000000", nullptr), std::chrono::seconds(10));
  EXPECT_EQ(watchdog_patience("10000000", "1"), std::chrono::seconds(0));
  EXPECT_EQ(watchdog_patience(nullptr, nullptr), std::chrono::seconds(0));
}

}  // namespace
}  // namespace docent::service::notify_socket_test
