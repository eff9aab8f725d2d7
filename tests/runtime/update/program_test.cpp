// docent-update as it is called, with releases as docent-content makes them.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "content/write/content_writer.h"
#include "tests/support/run_program.h"
#include "tests/support/small_museum.h"

namespace docent::test::program_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class DocentUpdate : public testing::Test {
 protected:
  DocentUpdate() {
    std::filesystem::create_directories(folder_.path() / "device");
    EXPECT_EQ(run_program("docent-content", "keygen -o " + file("device/museum")).exit_code, 0);
    std::ofstream(file("device/kiosk.toml"))
        << "content = \"museum.db\"\nkeys = [\"museum.pub\"]\nsource = \"" << file("server")
        << "\"\n";
  }

  std::string file(const std::string& name) const { return (folder_.path() / name).string(); }
  ProgramRun release(const std::string& title, const std::string& more = "") const {
    Museum museum = small_museum();
    museum.title["en"] = title;
    write::write_museum(museum, file("museum.db"));
    return run_program("docent-content", "release " + file("museum.db") + " -o " + file("server") +
                                             " --key " + file("device/museum.key") + " " + more);
  }
  ProgramRun update(const std::string& arguments) const {
    return run_program("docent-update", "--config " + file("device/kiosk.toml") + " " + arguments);
  }

  TemporaryFolder folder_;
};

TEST_F(DocentUpdate, TakesWhatDocentContentReleased) {
  ASSERT_EQ(release("first").exit_code, 0);

  const ProgramRun taken = update("--once --json");

  EXPECT_EQ(taken.exit_code, 0) << taken.err;
  EXPECT_THAT(taken.out, AllOf(HasSubstr("\"status\":\"taken\""), HasSubstr("\"release\":1")));
  EXPECT_EQ(run_program("docent-content", "verify " + file("device/museum.db") + " --key " +
                                              file("device/museum.pub"))
                .exit_code,
            0);
  EXPECT_THAT(update("--once").out, HasSubstr("release 1 is shown already"));
  ASSERT_EQ(release("second").exit_code, 0);
  EXPECT_THAT(update("--once").out, HasSubstr("release 2 is taken"));
  EXPECT_THAT(update("--back").out, HasSubstr("went back from release 2 to release 1"));
  EXPECT_EQ(update("--starting").exit_code, 0);
}

TEST_F(DocentUpdate, FindsWhatZchunkMadeBesideTheDatabaseOfARelease) {
  if (std::system("command -v zck >/dev/null") != 0)  // NOLINT(bugprone-command-processor)
    GTEST_SKIP() << "needs the package zchunk";
  ASSERT_EQ(release("first").exit_code, 0);

  std::size_t databases = 0, zchunks = 0;
  for (const auto& entry : std::filesystem::directory_iterator(file("server"))) {
    databases += entry.path().extension() == ".db" ? 1 : 0;
    zchunks += entry.path().extension() == ".zck" ? 1 : 0;
  }
  EXPECT_EQ(databases, 1U);
  EXPECT_EQ(zchunks, 1U);
}

TEST_F(DocentUpdate, CalledByRootLeavesWhatTheUserOfTheTimerCanChange) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can become somebody else";
  constexpr unsigned nobody = 65534;
  ASSERT_EQ(release("first").exit_code, 0);
  std::filesystem::permissions(folder_.path(), std::filesystem::perms(0755));
  ASSERT_EQ(::chown(file("device").c_str(), nobody, nobody), 0);

  ASSERT_EQ(update("--once").exit_code, 0);

  for (const char* name : {"museum.db", "update.state", "update.lock", "releases"}) {
    struct stat status{};
    ASSERT_EQ(::stat(file(std::string("device/") + name).c_str(), &status), 0) << name;
    EXPECT_EQ(status.st_uid, nobody) << name;
  }
}

TEST_F(DocentUpdate, SaysWhatIsMissing) {
  const ProgramRun none = update("--once");
  EXPECT_EQ(none.exit_code, 3);
  EXPECT_THAT(none.err, HasSubstr("there is no release; 'docent-content release' makes one"));

  EXPECT_EQ(update("--back").exit_code, 1);
  std::ofstream(file("device/kiosk.toml")) << "content = \"museum.db\"\n";
  const ProgramRun keyless = update("--once --source " + file("server"));
  EXPECT_EQ(keyless.exit_code, 1);
  EXPECT_THAT(keyless.err, HasSubstr("kiosk.toml: names no key"));
  EXPECT_EQ(update("--wat").exit_code, 2);
}

TEST_F(DocentUpdate, SaysThatAServerIsAway) {
  const ProgramRun away = update("--once --json --source http://127.0.0.1:9/kiosks");

  EXPECT_EQ(away.exit_code, 3);
  EXPECT_THAT(away.out, HasSubstr("\"status\":\"failed\""));
  EXPECT_THAT(away.out, HasSubstr("http://127.0.0.1:9/kiosks/release.txt: cannot be fetched"));
}

TEST_F(DocentUpdate, LinksNoGraphics) {
  const TemporaryFolder folder;
  const auto needed = [&](const char* name) {
    const std::string out = (folder.path() / "out").string();
    const std::string command = "readelf --dynamic '" + program(name).string() + "' >'" + out + "'";
    EXPECT_EQ(std::system(command.c_str()), 0);  // NOLINT(bugprone-command-processor)
    return text_of(out);
  };
  EXPECT_THAT(needed("docent-update"),
              AllOf(HasSubstr("libcurl"), Not(HasSubstr("libEGL")), Not(HasSubstr("libGLES")),
                    Not(HasSubstr("libpango"))));
}

TEST_F(DocentUpdate, WillNotMakeAReleaseOlderThanTheOneThere) {
  ASSERT_EQ(release("first", "--release 7").exit_code, 0);

  const ProgramRun older = release("second", "--release 7");

  EXPECT_EQ(older.exit_code, 1);
  EXPECT_THAT(older.err, HasSubstr("holds release 7 already"));
  EXPECT_THAT(release("second").out, HasSubstr("release 8"));
}

}  // namespace
}  // namespace docent::test::program_test
