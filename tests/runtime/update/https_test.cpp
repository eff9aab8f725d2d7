// Releases over HTTP, as a static server gives them.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <random>

#include "platform/https/fetch.h"
#include "platform/sqlite/content_reader.h"
#include "runtime/update/update.h"
#include "tests/support/release_maker.h"
#include "tests/support/static_server.h"

namespace docent::update::https_test {
namespace {

namespace fs = std::filesystem;
using Mood = test::StaticServer::Mood;
using testing::HasSubstr;

constexpr release::Time noon = 1'700'000'000;

class AServer : public testing::Test {
 protected:
  AServer() { fs::create_directories(folder_.path() / "device"); }

  static fs::path made(const fs::path& folder) {
    fs::create_directories(folder);
    return folder;
  }
  void publish(std::uint64_t version) const {
    release::Manifest manifest{
        .version = version, .issued = noon + static_cast<int>(version), .expires = noon + 86400};
    maker_.add(manifest, test::signed_museum(std::to_string(version), maker_.key));
    maker_.publish(manifest);
  }
  Result<Outcome> look() const { return update(settings_, noon + 100); }
  std::string shown() const {
    const auto museum = sqlite::load_museum(settings_.store.database);
    return museum ? museum->title.at("en") : museum.error().what;
  }

  test::TemporaryFolder folder_;
  test::ReleaseMaker maker_{made(folder_.path() / "server")};
  test::StaticServer server_{maker_.folder};
  Settings settings_{.store = {folder_.path() / "device/museum.db"},
                     .source = {server_.url()},
                     .keys = {signature::public_key(maker_.key)},
                     .device = {.program = "0.1.0", .schema = schema::version, .group = {}}};
};

TEST_F(AServer, GivesAReleaseAsAFolderDoes) {
  publish(1);
  ASSERT_EQ(look().value().status, "taken");
  EXPECT_EQ(shown(), "1");
}

TEST_F(AServer, IsAskedForUnder2KilobytesWhetherAnythingHasChanged) {
  publish(1);
  ASSERT_TRUE(look().has_value());
  const std::size_t before = server_.bytes(), requests = server_.requests();

  EXPECT_EQ(look().value().status, "current");

  EXPECT_EQ(server_.requests() - requests, 1U);
  EXPECT_LT(server_.bytes() - before, 400U);
  publish(2);
  EXPECT_EQ(look().value().status, "taken");
  EXPECT_EQ(shown(), "2");
}

TEST_F(AServer, ThatIsAwayOrBreaksOffChangesNothing) {
  publish(1);
  ASSERT_TRUE(look().has_value());
  publish(2);
  for (const Mood mood : {Mood::Away, Mood::Half}) {
    server_.set_mood(mood);
    const auto outcome = look();
    ASSERT_FALSE(outcome.has_value());
    EXPECT_EQ(outcome.error().code, Errc::Environment);
    EXPECT_THAT(outcome.error().what, HasSubstr("cannot be fetched"));
    EXPECT_EQ(shown(), "1");
  }
  server_.set_mood(Mood::Well);
  EXPECT_EQ(look().value().status, "taken");
}

TEST_F(AServer, CannotSendTheKioskToAFileOfItsOwn) {
  server_.set_mood(Mood::Redirecting);

  EXPECT_THAT(look().error().what, HasSubstr("cannot be fetched"));
}

TEST_F(AServer, MaySendTheKioskToAnotherAddress) {
  publish(1);
  server_.set_mood(Mood::Moved);

  EXPECT_EQ(look().value().status, "taken");

  EXPECT_EQ(shown(), "1");
}

TEST_F(AServer, IsAskedThroughTheProxyThatTheEnvironmentNames) {
  publish(1);
  ::setenv("http_proxy", server_.url().c_str(), 1);
  settings_.source = {"http://kiosks.example"};
  const auto outcome = look();
  ::unsetenv("http_proxy");

  ASSERT_TRUE(outcome.has_value()) << outcome.error().what;
  EXPECT_EQ(shown(), "1");
}

TEST_F(AServer, ThatSendsMoreThanItShouldIsNotListenedTo) {
  write::replace_file(maker_.folder / "release.txt", std::vector<std::byte>(20'000));

  EXPECT_THAT(look().error().what, HasSubstr("it has more than 16384 bytes"));
}

/// A database with a few hundred kilobytes that do not shrink, as a museum's walls and walks are.
std::vector<std::byte> large_museum(const std::string& title, const signature::SecretKey& key) {
  Museum museum = test::small_museum();
  museum.title["en"] = title;
  std::mt19937 random(7);
  museum.images[0].bytes.resize(1'000'000);
  for (std::byte& byte : museum.images[0].bytes) byte = static_cast<std::byte>(random());
  return test::signed_museum(museum, key);
}

TEST_F(AServer, GivesOnlyWhatDiffersWhereThereIsZchunk) {
  if (std::system("command -v zck >/dev/null") != 0)  // NOLINT(bugprone-command-processor)
    GTEST_SKIP() << "needs the package zchunk";
  const auto publish_large = [&](std::uint64_t version) {
    release::Manifest manifest{
        .version = version, .issued = noon + static_cast<int>(version), .expires = noon + 86400};
    maker_.add(manifest, large_museum(std::to_string(version), maker_.key));
    const std::string file = (maker_.folder / manifest.files[0].name).string();
    const std::string zck = "zck -o '" + file + ".zck' '" + file + "'";
    EXPECT_EQ(std::system(zck.c_str()), 0);  // NOLINT(bugprone-command-processor)
    fs::remove(file);                        // so that nothing else can be fetched
    maker_.publish(manifest);
  };
  publish_large(1);
  ASSERT_EQ(look().value().status, "taken");
  const std::size_t before = server_.bytes();
  publish_large(2);

  ASSERT_EQ(look().value().status, "taken");

  EXPECT_EQ(shown(), "2");
  EXPECT_LT(server_.bytes() - before, 200'000U) << "of a megabyte";
}

TEST_F(AServer, WhoseZchunkIsRubbishIsAskedForTheWholeFile) {
  publish(1);
  for (const auto& entry : fs::directory_iterator(maker_.folder))
    if (entry.path().extension() == ".db")
      std::ofstream(entry.path().string() + ".zck") << "rubbish";

  EXPECT_EQ(look().value().status, "taken");
  EXPECT_EQ(shown(), "1");
}

TEST_F(AServer, ThatHasNoReleaseSaysSo) {
  EXPECT_THAT(look().error().what, HasSubstr("there is no release"));
}

}  // namespace
}  // namespace docent::update::https_test
