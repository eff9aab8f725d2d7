// keygen, sign and verify, as an integrator calls them.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>

#include "content/write/content_writer.h"
#include "platform/signature/key.h"
#include "tests/support/run_program.h"
#include "tests/support/small_museum.h"

namespace docent::test::sign_command_test {
namespace {

using testing::HasSubstr;

class Signing : public testing::Test {
 protected:
  Signing() { write::write_museum(small_museum(), file("museum.db")); }

  std::string file(const std::string& name) const { return (folder_.path() / name).string(); }
  ProgramRun keygen(const std::string& name) const {
    return run_program("docent-content", "keygen -o " + file(name));
  }
  ProgramRun sign(const std::string& key) const {
    return run_program("docent-content", "sign " + file("museum.db") + " --key " + file(key));
  }
  ProgramRun verify(const std::string& key) const {
    return run_program("docent-content", "verify " + file("museum.db") + " --key " + file(key));
  }

  TemporaryFolder folder_;
};

TEST_F(Signing, TakesAPairOfKeysOfWhichOnlyItsOwnerReadsTheSecretOne) {
  ASSERT_EQ(keygen("ours").exit_code, 0);

  struct stat status{};
  ASSERT_EQ(::stat(file("ours.key").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0600U);
  EXPECT_THAT(text_of(file("ours.pub")), HasSubstr("docent-public-key-1 "));
}

TEST_F(Signing, NeverOverwritesAKey) {
  keygen("ours");
  const std::string before = text_of(file("ours.key"));

  const ProgramRun again = keygen("ours");

  EXPECT_EQ(again.exit_code, 3);
  EXPECT_THAT(again.err, HasSubstr("exists already"));
  EXPECT_EQ(text_of(file("ours.key")), before);
  std::filesystem::remove(file("ours.key"));
  EXPECT_EQ(keygen("ours").exit_code, 3);
  EXPECT_FALSE(std::filesystem::exists(file("ours.key"))) << "half a pair";
}

TEST_F(Signing, IsToldByInfoBesideTheKiosksOfTheMuseum) {
  keygen("ours");
  keygen("theirs");
  const auto info = [&](const char* more) {
    return run_program("docent-content", "info " + file("museum.db") + more).out;
  };
  const auto id_of = [&](const char* key) {
    return signature::name_of(signature::id_of(*signature::read_public_key(file(key))));
  };
  EXPECT_THAT(info(" --json"), HasSubstr(R"("signed_with":[],"kiosks":["foyer","cafe"],)"));
  EXPECT_THAT(info(""), HasSubstr("\nsigned with        none\n"));

  sign("ours.key");
  sign("theirs.key");

  EXPECT_THAT(info(" --json"),
              HasSubstr("\"signed_with\":[\"" + id_of("ours.pub") + "\",\"" + id_of("theirs.pub")));
  EXPECT_THAT(info(""), HasSubstr("signed with        " + id_of("ours.pub") + ", "));
  EXPECT_THAT(info(""), HasSubstr("kiosks             foyer, cafe\n"));
}

TEST_F(Signing, IsVerifiedWithThePublicKey) {
  keygen("ours");
  keygen("theirs");
  EXPECT_EQ(verify("ours.pub").exit_code, 1);

  const ProgramRun signed_once = sign("ours.key");

  EXPECT_EQ(signed_once.exit_code, 0) << signed_once.err;
  EXPECT_EQ(verify("ours.pub").exit_code, 0);
  const ProgramRun foreign = verify("theirs.pub");
  EXPECT_EQ(foreign.exit_code, 1);
  EXPECT_THAT(foreign.err, HasSubstr("error[wrong-signature]: is signed with another key"));
  const std::string bytes = text_of(file("museum.db"));
  sign("ours.key");
  EXPECT_EQ(text_of(file("museum.db")), bytes);
  EXPECT_EQ(sign("theirs.key").exit_code, 0);
  EXPECT_EQ(verify("ours.pub").exit_code, 0);
  EXPECT_EQ(verify("theirs.pub").exit_code, 0);
}

TEST_F(Signing, WithTheWrongFileSaysWhichIsMeant) {
  keygen("ours");

  EXPECT_THAT(sign("ours.pub").err, HasSubstr("name the one that ends in .key"));
  EXPECT_THAT(verify("ours.key").err, HasSubstr("name the one that ends in .pub"));
}

}  // namespace
}  // namespace docent::test::sign_command_test
