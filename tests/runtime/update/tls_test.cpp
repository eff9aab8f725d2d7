// What a look at a release costs over TLS, and what is kept for that.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdlib>

#include "runtime/update/update.h"
#include "tests/support/release_maker.h"
#include "tests/support/static_server.h"
#include "tests/support/tls_server.h"

namespace docent::update::tls_test {
namespace {

namespace fs = std::filesystem;

constexpr release::Time noon = 1'700'000'000;
/// Without a stray acknowledgement: twelve packets with time stamps, of which two have options.
constexpr std::size_t tcp_and_ip = 12 * 52 + 16;

const test::Certificates& certificates(const std::string& keys) {
  static const test::TemporaryFolder folder;
  static const test::Certificates rsa(folder.path() / "rsa", "rsa:2048"),
      ec(folder.path() / "ec", "ec -pkeyopt ec_paramgen_curve:P-256");
  return keys == "rsa" ? rsa : ec;
}

/// A device that has taken release 1.
struct TlsDevice {
  explicit TlsDevice(const std::string& keys, int newest = TLS1_3_VERSION)
      : server(certificates(keys), behind.port(), newest) {
    fs::create_directories(folder.path() / "device");
    ::setenv("SSL_CERT_FILE", certificates(keys).root().c_str(), 1);
    release::Manifest manifest{.version = 1, .issued = noon, .expires = noon + 86400};
    maker.add(manifest, test::signed_museum("1", maker.key));
    maker.publish(manifest);
    EXPECT_EQ(look(), "taken");
  }
  ~TlsDevice() { ::unsetenv("SSL_CERT_FILE"); }
  TlsDevice(const TlsDevice&) = delete;
  TlsDevice& operator=(const TlsDevice&) = delete;

  std::string look() const {
    const auto outcome = update(settings, noon + 100);
    return outcome ? outcome->status : outcome.error().what;
  }
  static fs::path made(const fs::path& folder) {
    fs::create_directories(folder);
    return folder;
  }

  test::TemporaryFolder folder;
  fs::path session = folder.path() / "device/update.session";
  test::ReleaseMaker maker{made(folder.path() / "server")};
  test::StaticServer behind{maker.folder};
  test::TlsServer server;
  Settings settings{.store = {folder.path() / "device/museum.db"},
                    .source = {.place = server.url(), .session = session},
                    .keys = {signature::public_key(maker.key)},
                    .device = {.program = "0.1.0", .schema = schema::version, .group = {}}};
};

class Tls : public testing::TestWithParam<const char*> {};

TEST_P(Tls, IsAskedForUnder2KilobytesWhetherAnythingHasChanged) {
  const TlsDevice device(GetParam());
  for (int hour = 0; hour < 3; ++hour) {
    const std::size_t before = device.server.bytes(), resumed = device.server.resumed();

    EXPECT_EQ(device.look(), "current");

    EXPECT_EQ(device.server.resumed() - resumed, 1U);
    EXPECT_LT(device.server.bytes() - before + tcp_and_ip, 2000U) << "in hour " << hour;
  }
}

TEST_P(Tls, ServerThatWasStartedAgainShowsItsCertificatesAgain) {
  TlsDevice device(GetParam());
  device.server.forget_sessions();
  const std::size_t resumed = device.server.resumed();

  EXPECT_EQ(device.look(), "current");

  EXPECT_EQ(device.server.resumed(), resumed);
  EXPECT_EQ(device.look(), "current");
  EXPECT_EQ(device.server.resumed(), resumed + 1);
}

INSTANTIATE_TEST_SUITE_P(Update, Tls, testing::Values("rsa", "ec"));

TEST(TlsSession, IsASecretOfTheOwner) {
  const TlsDevice device("ec");

  struct stat status{};
  ASSERT_EQ(::stat(device.session.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 07777U, 0600U);
}

TEST(TlsSession, IsOfferedToTheHostThatGaveItOnly) {
  const TlsDevice device("ec");
  std::string kept = test::text_of(device.session);
  ASSERT_TRUE(kept.starts_with("localhost\n"));
  std::ofstream(device.session) << kept.replace(0, 9, "elsewhere");
  const std::size_t resumed = device.server.resumed();

  EXPECT_EQ(device.look(), "current");

  EXPECT_EQ(device.server.resumed(), resumed);
  EXPECT_TRUE(test::text_of(device.session).starts_with("localhost\n"));
}

TEST(TlsSession, ThatIsNotUnderstoodCostsOneMoreConnection) {
  TlsDevice device("ec");
  device.server.refuse_sessions();
  const std::size_t before = device.server.connections();

  EXPECT_EQ(device.look(), "current");

  EXPECT_EQ(device.server.connections(), before + 2);
}

TEST(TlsSession, ThatIsRubbishIsNone) {
  const TlsDevice device("ec");
  for (const char* rubbish : {"", "\n", "localhost", "localhost\n", "localhost\nrubbish"}) {
    std::ofstream(device.session) << rubbish;

    EXPECT_EQ(device.look(), "current") << rubbish;
  }
}

TEST(TlsSession, IsKeptOfServersOfTls12Too) {
  const TlsDevice device("rsa", TLS1_2_VERSION);
  const std::size_t before = device.server.bytes(), resumed = device.server.resumed();

  EXPECT_EQ(device.look(), "current");

  EXPECT_EQ(device.server.resumed() - resumed, 1U);
  EXPECT_LT(device.server.bytes() - before + tcp_and_ip, 2000U);
}

TEST(TlsServer, CannotSendTheKioskToWhereAnybodyCanListen) {
  TlsDevice device("ec");
  device.behind.set_mood(test::StaticServer::Mood::Moved);

  EXPECT_THAT(device.look(), testing::HasSubstr("cannot be fetched"));
}

TEST(TlsServer, WhoseNameNobodyHasSignedIsNotListenedTo) {
  const TlsDevice device("ec");
  fs::remove(device.session);
  ::setenv("SSL_CERT_FILE", certificates("rsa").root().c_str(), 1);

  EXPECT_THAT(device.look(), testing::HasSubstr("cannot be fetched"));
  EXPECT_FALSE(fs::exists(device.session));
}

}  // namespace
}  // namespace docent::update::tls_test
