// Programs killed at random moments while content is compiled, fetched, installed and taken up: the
// kiosk finds the old database or the new one. As many times as DOCENT_KILLS says, a quarter of
// them each; a few in an ordinary run.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <random>
#include <string>

#include "content/write/zchunk.h"
#include "platform/sqlite/content_reader.h"
#include "runtime/update/update.h"
#include "tests/support/release_maker.h"
#include "tests/support/started_program.h"
#include "tests/support/static_server.h"

namespace docent::test::kill_test {
namespace {

namespace fs = std::filesystem;
using testing::AnyOf;

int kills(int usually) {
  const char* const asked = std::getenv("DOCENT_KILLS");
  return asked != nullptr ? std::max(std::atoi(asked) / 4, 1) : usually;
}

std::string shown_in(const fs::path& database) {
  const auto museum = sqlite::load_museum(database);
  return museum ? museum->title.at("en") : museum.error().what;
}

using Clock = std::chrono::steady_clock;
std::chrono::microseconds since(Clock::time_point begun) {
  return std::chrono::duration_cast<std::chrono::microseconds>(Clock::now() - begun);
}

/// A device, and releases in a folder and on a server.
class Killed : public testing::Test {
 protected:
  Killed() {
    fs::create_directories(folder_.path() / "device");
    std::ofstream(path("museum.pub")) << signature::to_text(signature::public_key(maker_.key));
  }

  static fs::path made(const fs::path& folder) {
    fs::create_directories(folder);
    return folder;
  }
  std::string path(const char* name) const { return (folder_.path() / name).string(); }
  void configure(const std::string& source) const {
    std::ofstream(path("kiosk.toml"))
        << "content = \"device/museum.db\"\nkeys = [\"museum.pub\"]\nsource = \"" << source
        << "\"\n";
  }
  std::vector<std::string> look() const { return {"--once", "--config", path("kiosk.toml")}; }
  /// The next release: "old" and "new" in turn.
  void publish() {
    const release::Time now = std::chrono::duration_cast<std::chrono::seconds>(
                                  std::chrono::system_clock::now().time_since_epoch())
                                  .count();
    release::Manifest made{.version = ++version_, .issued = now, .expires = now + 86400};
    maker_.add(made, signed_museum(version_ % 2 == 0 ? "new" : "old", maker_.key));
    write::write_zchunk(maker_.folder / made.files[0].name);
    maker_.publish(made);
  }
  void expect_whole() const { ASSERT_THAT(shown_in(database_), AnyOf("old", "new")); }
  /// Runs `program` and kills it at a random moment, until it has died of that so many times;
  /// `go_on` is told whether it ended first. How long it takes is measured each time that it ends:
  /// the first run may have been the slowest by far.
  void kill_often(const char* name, const std::vector<std::string>& arguments, int times,
                  std::chrono::microseconds whole, const std::function<void(bool ended)>& go_on) {
    int killed = 0;
    for (int i = 0; killed < times; ++i) {
      ASSERT_LT(i, 50 * times) << name << " ends before it can be killed";
      const Clock::time_point begun = Clock::now();
      StartedProgram run(program(name), arguments, path("said"));
      std::this_thread::sleep_for(some_of(whole + whole / 4));
      run.signal(SIGKILL);
      const int end = run.wait();
      ASSERT_TRUE(end == 0 || end == -SIGKILL) << end << text_of(path("said"));
      if (end == 0)
        whole = std::min(whole, since(begun));
      else
        ++killed;
      ASSERT_NO_FATAL_FAILURE(go_on(end == 0)) << "after run " << i;
    }
  }
  /// Takes releases and is killed meanwhile, so many times.
  void update_and_kill(int times) {
    publish();
    const Clock::time_point begun = Clock::now();
    ASSERT_EQ(StartedProgram(program("docent-update"), look()).wait(), 0);
    const auto whole = since(begun);
    publish();
    kill_often("docent-update", look(), times, whole, [&](bool ended) {
      ASSERT_NO_FATAL_FAILURE(expect_whole());
      if (ended) publish();
    });
  }
  std::chrono::microseconds some_of(std::chrono::microseconds whole) {
    return std::chrono::microseconds(random_() % static_cast<unsigned>(whole.count()));
  }

  TemporaryFolder folder_;
  ReleaseMaker maker_{made(folder_.path() / "server")};
  StaticServer server_{maker_.folder};
  const fs::path database_ = folder_.path() / "device/museum.db";
  std::uint64_t version_ = 0;
  std::mt19937 random_{20261125};
};

TEST_F(Killed, WhileAReleaseIsInstalledFromAFolder) {
  configure(maker_.folder.string());
  update_and_kill(kills(20));
}

TEST_F(Killed, WhileAReleaseIsFetched) {
  configure(server_.url());
  update_and_kill(kills(10));
}

TEST_F(Killed, WhileAMuseumIsCompiled) {
  const fs::path plan = folder_.path() / "hall.geojson";
  const auto write_plan = [&](int side) {
    std::ofstream(plan) << R"({"type":"Polygon","coordinates":[[[0,0],[)" << side << ",0],[" << side
                        << ',' << side << "],[0," << side << "],[0,0]]]}";
  };
  const std::vector<std::string> compile{"compile",          plan.string(), "-o",
                                         database_.string(), "--no-motion", "--quiet"};
  write_plan(10);
  const Clock::time_point begun = Clock::now();
  ASSERT_EQ(StartedProgram(program("docent-content"), compile).wait(), 0);
  const auto whole = since(begun);
  int side = 10;
  kill_often("docent-content", compile, kills(10), whole, [&](bool) {
    ASSERT_TRUE(sqlite::load_museum(database_).has_value());
    write_plan(side = 21 - side);
  });
}

/// The kiosk and docent-update at once, both killed: the next kiosk shows a museum.
TEST_F(Killed, WhileAReleaseIsTakenUp) {
  configure(maker_.folder.string());
  publish();
  ASSERT_EQ(StartedProgram(program("docent-update"), look()).wait(), 0);
  const std::vector<std::string> show{
      "--display",        "headless", "--size",       "64x64",     "--config",
      path("kiosk.toml"), "--health", path("health"), "--seconds", "1e6"};
  const auto is_there = [&] { return fs::exists(path("health")); };
  const auto takes_up = [&] { return text_of(path("said")).contains("has taken up"); };
  std::chrono::microseconds whole{};
  const int times = kills(4);
  for (int i = -1; i < times; ++i) {
    publish();
    fs::remove(path("health"));
    StartedProgram kiosk(program("docent"), show, path("said"));
    ASSERT_TRUE(kiosk.runs_until(is_there)) << text_of(path("said"));
    const Clock::time_point begun = Clock::now();
    kiosk.signal(SIGHUP);
    StartedProgram update(program("docent-update"), look());
    if (i < 0) {  // how long it takes
      ASSERT_TRUE(kiosk.runs_until(takes_up)) << text_of(path("said"));
      whole = since(begun);
    } else {
      std::this_thread::sleep_for(some_of(2 * whole));
    }
    update.signal(SIGKILL);
    kiosk.signal(SIGHUP);
    kiosk.signal(SIGKILL);
    update.wait();
    ASSERT_EQ(kiosk.wait(), -SIGKILL) << text_of(path("said"));
    ASSERT_NO_FATAL_FAILURE(expect_whole()) << "after kill " << i;
    std::vector<std::string> once = show;
    once.back() = "0.05";
    ASSERT_EQ(StartedProgram(program("docent"), once, path("said")).wait(), 0)
        << text_of(path("said"));
  }
}

}  // namespace
}  // namespace docent::test::kill_test
