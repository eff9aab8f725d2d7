// Wherever docent-update and docent-content are killed, and wherever the power is cut, the kiosk
// finds the old database or the new one.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>

#include "content/write/zchunk.h"
#include "platform/sqlite/content_reader.h"
#include "runtime/update/update.h"
#include "tests/support/recorded_disk.h"
#include "tests/support/release_maker.h"
#include "tests/support/static_server.h"

namespace docent::test::crash_test {
namespace {

namespace fs = std::filesystem;
using testing::AnyOf;
using testing::HasSubstr;

release::Time now() {
  return std::chrono::duration_cast<std::chrono::seconds>(
             std::chrono::system_clock::now().time_since_epoch())
      .count();
}

/// `.ci/kills` takes its time.
bool is_long_night() {
  return std::getenv("DOCENT_KILLS") != nullptr;
}

std::string shown_in(const fs::path& database) {
  const auto museum = sqlite::load_museum(database);
  return museum ? museum->title.at("en") : museum.error().what;
}

enum class From : std::uint8_t { Folder, Server };

/// A device that shows "old", and a release "new" that it has not taken.
class AnUpdate : public testing::Test {
 protected:
  explicit AnUpdate(From from = From::Folder) : from_(from) {
    fs::create_directories(device_);
    std::ofstream(path("museum.pub")) << signature::to_text(signature::public_key(maker_.key));
    std::ofstream(path("kiosk.toml"))
        << "content = \"device/museum.db\"\nkeys = [\"museum.pub\"]\nsource = \"" << source()
        << "\"\n";
    publish(1, "old");
    EXPECT_EQ(run_program("docent-update", arguments()).exit_code, 0);
    EXPECT_EQ(shown_in(device_ / "museum.db"), "old");
    publish(2, "new");
    fs::copy(device_, before_, fs::copy_options::recursive);
  }

  static fs::path made(const fs::path& folder) {
    fs::create_directories(folder);
    return folder;
  }
  std::string path(const char* name) const { return (folder_.path() / name).string(); }
  std::string source() const {
    return from_ == From::Folder ? maker_.folder.string() : server_.url();
  }
  std::string arguments() const { return "--once --config " + path("kiosk.toml"); }
  void publish(std::uint64_t version, const std::string& title) const {
    release::Manifest made{.version = version, .issued = now(), .expires = now() + 86400};
    maker_.add(made, signed_museum(title, maker_.key));
    if (from_ == From::Server) write::write_zchunk(maker_.folder / made.files[0].name);
    maker_.publish(made);
  }
  void restore() const {
    fs::remove_all(device_);
    fs::copy(before_, device_, fs::copy_options::recursive);
  }
  update::Settings settings(const fs::path& device) const {
    return {.store = {device / "museum.db"},
            .source = {source()},
            .keys = {signature::public_key(maker_.key)},
            .device = {.program = "0.1.0", .schema = schema::version, .group = {}}};
  }
  /// Old or new as it lies there, after the kiosk's start, and new after the next look.
  void expect_whole(const fs::path& device, const std::string& when) const {
    ASSERT_THAT(shown_in(device / "museum.db"), AnyOf("old", "new")) << when;
    const auto started = update::prepare_start(settings(device), now() + 3600);
    ASSERT_TRUE(started.has_value()) << when << ": " << started.error().what;
    ASSERT_THAT(shown_in(device / "museum.db"), AnyOf("old", "new")) << when;
    const auto looked = update::update(settings(device), now());
    ASSERT_TRUE(looked.has_value()) << when << ": " << looked.error().what;
    ASSERT_EQ(shown_in(device / "museum.db"), "new") << when;
  }
  /// Kills it before every so many-th of its operations; returns how often.
  int kill_before_each(int every) const {
    for (int kills = 0;; ++kills) {
      restore();
      const int at = 1 + kills * every;
      const ProgramRun run = run_recorded("docent-update", arguments(), device_,
                                          fmt::format("DOCENT_DISK_KILL={}", at));
      expect_whole(device_, fmt::format("killed at {}", at));
      if (run.exit_code == 0 || HasFatalFailure()) return kills;
      EXPECT_EQ(run.exit_code, -1) << run.err;
    }
  }
  /// Cuts it off at every so many-th moment; returns how often.
  int cut_off_at_each(int every) const;
  /// The third start within ten minutes of the update to "new" goes back to "old".
  void start_twice() const {
    ASSERT_EQ(run_program("docent-update", arguments()).exit_code, 0);
    for (int start = 0; start < 2; ++start)
      ASSERT_EQ(run_program("docent-update", starting()).exit_code, 0);
    ASSERT_EQ(shown_in(device_ / "museum.db"), "new");
    fs::remove_all(before_);
    fs::copy(device_, before_, fs::copy_options::recursive);
  }
  std::string starting() const { return "--starting --config " + path("kiosk.toml"); }

  const From from_;
  TemporaryFolder folder_;
  ReleaseMaker maker_{made(folder_.path() / "server")};
  StaticServer server_{maker_.folder};
  const fs::path device_ = folder_.path() / "device", before_ = folder_.path() / "before";
};

/// One from a server, which gives the differences where there is zchunk.
class AFetch : public AnUpdate {
 protected:
  AFetch() : AnUpdate(From::Server) {}
};

TEST_F(AnUpdate, KilledBeforeAnyOfItsOperationsLeavesTheOldOrTheNew) {
  EXPECT_GT(kill_before_each(1), 20) << "how many operations an update has";
}

TEST_F(AFetch, KilledBeforeAnyOfItsOperationsLeavesTheOldOrTheNew) {
  const int every = is_long_night() ? 1 : 5;
  EXPECT_GT(kill_before_each(every), 20 / every);
}

/// What a power cut leaves of a folder in which a program has run, at any moment of it: calls
/// `look` with each such folder and when it was. Every so many-th of them; returns how many.
int cut_power(RecordedDisk disk, const fs::path& log, const fs::path& image, int every,
              const std::function<void(const fs::path&, const std::string&)>& look) {
  int moments = 0, images = 0;
  for (const DiskOperation& operation : read_operations(log)) {
    disk.apply(operation);
    for (std::size_t changes = 0; changes < disk.cuts(); ++changes)
      for (const auto bytes : {RecordedDisk::Bytes::All, RecordedDisk::Bytes::OnlySynced}) {
        if (moments++ % every != 0) continue;
        disk.write_after_cut(changes, bytes, image);
        ++images;
        look(image, fmt::format("after {} {}, with {} changes of names", operation.kind,
                                operation.path, changes));
        if (testing::Test::HasFatalFailure()) return images;
      }
  }
  return images;
}

int AnUpdate::cut_off_at_each(int every) const {
  const RecordedDisk disk(device_);
  const fs::path log = folder_.path() / "log";
  EXPECT_EQ(
      run_recorded("docent-update", arguments(), device_, "DOCENT_DISK_LOG='" + log.string() + "'")
          .exit_code,
      0);
  EXPECT_EQ(shown_in(device_ / "museum.db"), "new");
  return cut_power(
      disk, log, folder_.path() / "image", every,
      [&](const fs::path& device, const std::string& when) { expect_whole(device, when); });
}

TEST_F(AnUpdate, CutOffFromPowerAtAnyMomentLeavesTheOldOrTheNew) {
  const int images = cut_off_at_each(1);
  EXPECT_GT(images, 100);
  RecordProperty("images", images);
}

TEST_F(AFetch, CutOffFromPowerAtAnyMomentLeavesTheOldOrTheNew) {
  const int every = is_long_night() ? 1 : 8;
  const int images = cut_off_at_each(every);
  EXPECT_GT(images, 200 / every)
      << "how many moments a fetch has; how many writes differs by build";
  RecordProperty("images", images);
}

TEST_F(AnUpdate, CutOffFromPowerWhileItGoesBackLeavesTheOldOrTheNew) {
  ASSERT_NO_FATAL_FAILURE(start_twice());
  const RecordedDisk disk(device_);
  const fs::path log = folder_.path() / "log";
  ASSERT_EQ(
      run_recorded("docent-update", starting(), device_, "DOCENT_DISK_LOG='" + log.string() + "'")
          .exit_code,
      0);
  ASSERT_EQ(shown_in(device_ / "museum.db"), "old");

  const int images = cut_power(
      disk, log, folder_.path() / "image", 1, [&](const fs::path& device, const std::string& when) {
        ASSERT_THAT(shown_in(device / "museum.db"), AnyOf("old", "new")) << when;
        const auto started = update::prepare_start(settings(device), now());
        ASSERT_TRUE(started.has_value()) << when << ": " << started.error().what;
        ASSERT_EQ(shown_in(device / "museum.db"), "old") << when;
      });
  EXPECT_GT(images, 20);
  RecordProperty("images", images);
}

TEST_F(AnUpdate, ThatFindsTheDiskFullSaysSoAndLosesNothing) {
  int refusals = 0;
  for (int full = 1;; ++full) {
    restore();
    const ProgramRun run = run_recorded("docent-update", arguments(), device_,
                                        fmt::format("DOCENT_DISK_FULL={}", full));
    ASSERT_NO_FATAL_FAILURE(expect_whole(device_, fmt::format("full at {}", full)));
    if (run.exit_code == 0 && refusals > 0) break;
    if (run.exit_code == 0) continue;
    ASSERT_EQ(run.exit_code, 3) << run.err;
    ASSERT_THAT(run.err, HasSubstr("No space left on device"));
    ++refusals;
  }
  EXPECT_GT(refusals, 3);
}

TEST_F(AnUpdate, ThatHasNoRoomForTheNewFetchesNothing) {
  const ProgramRun run =
      run_recorded("docent-update", arguments(), device_, "DOCENT_DISK_FREE=1000000");

  EXPECT_EQ(run.exit_code, 3);
  EXPECT_THAT(run.err, HasSubstr("releases: has 0 MB of room, and release 2 needs"));
  EXPECT_EQ(shown_in(device_ / "museum.db"), "old");
  EXPECT_EQ(run_program("docent-update", arguments()).exit_code, 0);
  EXPECT_EQ(shown_in(device_ / "museum.db"), "new");
}

TEST_F(AnUpdate, BackKilledBeforeAnyOfItsOperationsLeavesTheOldOrTheNew) {
  ASSERT_NO_FATAL_FAILURE(start_twice());
  for (const std::string& back : {"--back --config " + path("kiosk.toml"), starting()})
    for (int kill = 1;; ++kill) {
      restore();
      const ProgramRun run =
          run_recorded("docent-update", back, device_, fmt::format("DOCENT_DISK_KILL={}", kill));
      ASSERT_THAT(shown_in(device_ / "museum.db"), AnyOf("old", "new")) << kill;
      ASSERT_TRUE(update::prepare_start(settings(device_), now() + 3600).has_value()) << kill;
      ASSERT_THAT(shown_in(device_ / "museum.db"), AnyOf("old", "new")) << kill;
      if (run.exit_code == 0) break;
    }
  EXPECT_EQ(shown_in(device_ / "museum.db"), "old");
}

TEST(SigningADatabase, KilledBeforeAnyOfItsOperationsLeavesTheUnsignedOrTheSigned) {
  const TemporaryFolder folder;
  const std::string database = (folder.path() / "museum.db").string();
  const std::string key = (folder.path() / "museum").string();
  ASSERT_EQ(run_program("docent-content", "keygen -o " + key).exit_code, 0);
  for (int kill = 1;; ++kill) {
    write::write_museum(small_museum(), database);
    const ProgramRun run =
        run_recorded("docent-content", "sign " + database + " --key " + key + ".key", folder.path(),
                     fmt::format("DOCENT_DISK_KILL={}", kill));
    ASSERT_TRUE(sqlite::load_museum(database).has_value()) << kill;
    if (run.exit_code == 0) break;
    ASSERT_EQ(run.exit_code, -1);
  }
}

/// Writes a square hall as the plan of a floor.
void write_hall(const fs::path& file, double side) {
  std::ofstream(file) << fmt::format(
      R"({{"type":"FeatureCollection","features":[{{"type":"Feature","properties":{{}},)"
      R"("geometry":{{"type":"Polygon","coordinates":[[[0,0],[{0},0],[{0},{0}],[0,{0}],[0,0]]]}}}}]}})",
      side);
}

TEST(Compiling, KilledBeforeAnyOfItsOperationsLeavesTheOldOrTheNew) {
  const TemporaryFolder folder;
  const fs::path database = folder.path() / "out/museum.db", plan = folder.path() / "hall.geojson";
  fs::create_directories(folder.path() / "out");
  const std::string compile =
      "compile " + plan.string() + " -o " + database.string() + " --no-motion --quiet";
  write_hall(plan, 10);
  ASSERT_EQ(run_program("docent-content", compile).exit_code, 0);
  const std::string old = text_of(database);
  write_hall(plan, 12);
  for (int kill = 1;; ++kill) {
    std::ofstream(database, std::ios::binary) << old;
    const ProgramRun run = run_recorded("docent-content", compile, folder.path() / "out",
                                        fmt::format("DOCENT_DISK_KILL={}", kill));
    ASSERT_TRUE(sqlite::load_museum(database).has_value()) << kill;
    if (run.exit_code == 0) break;
    ASSERT_EQ(run.exit_code, -1) << run.err;
  }
  EXPECT_NE(text_of(database), old);
}

TEST(Compiling, CutOffFromPowerAtAnyMomentLeavesTheOldOrTheNew) {
  const TemporaryFolder folder;
  const fs::path out = folder.path() / "out", plan = folder.path() / "hall.geojson";
  const fs::path log = folder.path() / "log";
  fs::create_directories(out);
  const std::string compile =
      "compile " + plan.string() + " -o " + (out / "museum.db").string() + " --no-motion --quiet";
  write_hall(plan, 10);
  ASSERT_EQ(run_program("docent-content", compile).exit_code, 0);
  const RecordedDisk disk(out);
  write_hall(plan, 12);
  ASSERT_EQ(run_recorded("docent-content", compile, out, "DOCENT_DISK_LOG='" + log.string() + "'")
                .exit_code,
            0);

  const int images = cut_power(disk, log, folder.path() / "image", 1,
                               [&](const fs::path& image, const std::string& when) {
                                 const auto museum = sqlite::load_museum(image / "museum.db");
                                 ASSERT_TRUE(museum.has_value()) << when << museum.error().what;
                               });
  EXPECT_GT(images, 5);
}

TEST(Releasing, KilledBeforeAnyOfItsOperationsLeavesTheOldReleaseOrTheNew) {
  const TemporaryFolder folder;
  const auto file = [&](const char* name) { return (folder.path() / name).string(); };
  ASSERT_EQ(run_program("docent-content", "keygen -o " + file("museum")).exit_code, 0);
  std::ofstream(file("kiosk.toml")) << "content = \"device/museum.db\"\nkeys = [\"museum.pub\"]\n"
                                    << "source = \"" << file("server") << "\"\n";
  const std::string release =
      "release " + file("museum.db") + " -o " + file("server") + " --key " + file("museum.key");
  const std::string update = "--once --config " + file("kiosk.toml");
  const auto write_titled = [&](const char* title) {
    Museum museum = small_museum();
    museum.title["en"] = title;
    write::write_museum(museum, file("museum.db"));
  };
  write_titled("old");
  ASSERT_EQ(run_program("docent-content", release).exit_code, 0);
  fs::copy(file("server"), file("before"), fs::copy_options::recursive);
  write_titled("new");
  for (int kill = 1;; ++kill) {
    fs::remove_all(file("server"));
    fs::copy(file("before"), file("server"), fs::copy_options::recursive);
    fs::remove_all(file("device"));
    fs::create_directories(file("device"));
    const ProgramRun run = run_recorded("docent-content", release, file("server"),
                                        fmt::format("DOCENT_DISK_KILL={}", kill));
    const ProgramRun taken = run_program("docent-update", update);
    ASSERT_EQ(taken.exit_code, 0) << kill << taken.err;
    ASSERT_THAT(shown_in(file("device/museum.db")), AnyOf("old", "new")) << kill;
    if (run.exit_code == 0) break;
    ASSERT_EQ(run.exit_code, -1) << run.err;
  }
  EXPECT_EQ(shown_in(file("device/museum.db")), "new");
}

}  // namespace
}  // namespace docent::test::crash_test
