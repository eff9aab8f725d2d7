#include "platform/service/status_socket.h"

#include <gmock/gmock.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>
#include <fstream>
#include <stdexcept>

#include "tests/support/temporary_folder.h"

namespace docent::service::status_socket_test {
namespace {

using testing::HasSubstr;

class AStatusSocket : public testing::Test {
 protected:
  std::filesystem::path path() const { return folder_.path() / "docent" / "status"; }

  /// Connects and says nothing.
  int silent_asker() const {
    const int descriptor = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::strcpy(address.sun_path, path().c_str());
    EXPECT_EQ(connect(descriptor, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    return descriptor;
  }

  test::TemporaryFolder folder_;
};

TEST_F(AStatusSocket, AnswersWhoeverAsks) {
  const auto socket = StatusSocket::open(
      path(), [](std::string_view question) { return "you ask " + std::string(question); });
  ASSERT_TRUE(socket) << socket.error().what;

  EXPECT_EQ(ask(path(), "json"), "you ask json");
  EXPECT_EQ(ask(path(), "text"), "you ask text");
}

TEST_F(AStatusSocket, CarriesAnAnswerOfAnyLength) {
  const std::string answer(3'000'000, 'x');
  const auto socket = StatusSocket::open(path(), [&](std::string_view) { return answer; });
  ASSERT_TRUE(socket);

  EXPECT_EQ(ask(path(), "json"), answer);
}

TEST_F(AStatusSocket, IsForItsOwnerAndGroup) {
  const auto socket = StatusSocket::open(path(), [](std::string_view) { return "yes"; });
  ASSERT_TRUE(socket);

  struct stat file{};
  ASSERT_EQ(stat(path().c_str(), &file), 0);
  EXPECT_EQ(file.st_mode & 0777U, 0660U);
}

TEST_F(AStatusSocket, GoesWithItsProgram) {
  {
    const auto socket = StatusSocket::open(path(), [](std::string_view) { return "yes"; });
  }

  const auto answer = ask(path(), "json");

  ASSERT_FALSE(answer);
  EXPECT_EQ(answer.error().code, Errc::NotFound);
  EXPECT_FALSE(std::filesystem::exists(path()));
}

TEST_F(AStatusSocket, ThatAKilledProgramLeftBehindIsReplaced) {
  std::filesystem::create_directories(path().parent_path());
  const int left = ::socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::strcpy(address.sun_path, path().c_str());
  ASSERT_EQ(bind(left, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  close(left);

  EXPECT_EQ(ask(path(), "json").error().code, Errc::NotFound);
  const auto socket = StatusSocket::open(path(), [](std::string_view) { return "yes"; });
  ASSERT_TRUE(socket) << socket.error().what;
  EXPECT_EQ(ask(path(), "json"), "yes");
}

TEST_F(AStatusSocket, OfAProgramThatIsStillThereIsLeftToIt) {
  const auto first = StatusSocket::open(path(), [](std::string_view) { return "first"; });
  const auto second = StatusSocket::open(path(), [](std::string_view) { return "second"; });

  ASSERT_FALSE(second);
  EXPECT_THAT(second.error().what, HasSubstr("another kiosk"));
  EXPECT_EQ(ask(path(), "json"), "first");
}

TEST_F(AStatusSocket, GoesOnAfterAskersThatSayNothingOrLeave) {
  const auto socket = StatusSocket::open(path(), [](std::string_view) { return "yes"; });
  ASSERT_TRUE(socket);

  const int silent = silent_asker();
  close(silent_asker());

  EXPECT_EQ(ask(path(), "json"), "yes");
  close(silent);
}

TEST_F(AStatusSocket, GoesOnAfterAnAnswerThatFailed) {
  const auto socket = StatusSocket::open(path(), [](std::string_view question) -> std::string {
    if (question == "bad") throw std::runtime_error("no memory");
    return "yes";
  });
  ASSERT_TRUE(socket);

  EXPECT_FALSE(ask(path(), "bad"));
  EXPECT_EQ(ask(path(), "json"), "yes");
}

TEST_F(AStatusSocket, ThatCannotBeMadeIsASentence) {
  std::ofstream(folder_.path() / "docent") << "a file, where a folder is wanted";
  const auto socket = StatusSocket::open(path(), [](std::string_view) { return "yes"; });

  ASSERT_FALSE(socket);
  EXPECT_THAT(socket.error().what, HasSubstr("cannot be made (Not a directory)"));
}

}  // namespace
}  // namespace docent::service::status_socket_test
