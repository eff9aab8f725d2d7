// Wherever docent-update and docent-content are killed, and wherever the power is cut, the kiosk
// finds the old database or the new one.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <random>

#include "platform/sqlite/content_reader.h"
#include "runtime/update/update.h"
#include "tests/support/recorded_disk.h"
#include "tests/support/release_maker.h"
#include "tests/support/started_program.h"

namespace docent::test {
namespace {

namespace fs = std::filesystem;
using testing::AnyOf;
using testing::HasSubstr;

release::Time now() {
  return std::chrono::duration_cast<std::chrono::seconds>(
             std::chrono::system_clock::now().time_since_epoch())
      .count();
}

std::string shown_in(const fs::path& database) {
  const auto museum = sqlite::load_museum(database);
  return museum ? museum->title.at("en") : museum.error().what;
}

/// A device that shows "old", and a release "new" that it has not taken.
class AnUpdate : public testing::Test {
 protected:
  AnUpdate() {
    fs::create_directories(maker_.folder);
    fs::create_directories(device_);
    std::ofstream(path("museum.pub")) << signature::to_text(signature::public_key(maker_.key));
    std::ofstream(path("kiosk.toml"))
        << "content = \"device/museum.db\"\nkeys = [\"museum.pub\"]\nsource = \""
        << maker_.folder.string() << "\"\n";
    publish(1, "old");
    EXPECT_EQ(run_program("docent-update", arguments()).exit_code, 0);
    EXPECT_EQ(shown_in(device_ / "museum.db"), "old");
    publish(2, "new");
    fs::copy(device_, before_, fs::copy_options::recursive);
  }

  std::string path(const char* name) const { return (folder_.path() / name).string(); }
  std::string arguments() const { return "--once --config " + path("kiosk.toml"); }
  void publish(std::uint64_t version, const std::string& title) const {
    release::Manifest made{.version = version, .issued = now(), .expires = now() + 86400};
    maker_.add(made, signed_museum(title, maker_.key));
    maker_.publish(made);
  }
  void restore() const {
    fs::remove_all(device_);
    fs::copy(before_, device_, fs::copy_options::recursive);
  }
  update::Settings settings(const fs::path& device) const {
    return {.store = {device / "museum.db"},
            .source = {maker_.folder.string()},
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

  TemporaryFolder folder_;
  ReleaseMaker maker_{folder_.path() / "server"};
  const fs::path device_ = folder_.path() / "device", before_ = folder_.path() / "before";
};

TEST_F(AnUpdate, KilledBeforeAnyOfItsOperationsLeavesTheOldOrTheNew) {
  int kills = 0;
  for (;; ++kills) {
    restore();
    const ProgramRun run = run_recorded("docent-update", arguments(), device_,
                                        fmt::format("DOCENT_DISK_KILL={}", kills + 1));
    ASSERT_NO_FATAL_FAILURE(expect_whole(device_, fmt::format("killed at {}", kills + 1)));
    if (run.exit_code == 0) break;
    ASSERT_EQ(run.exit_code, -1) << run.err;
  }
  EXPECT_GT(kills, 20) << "how many operations an update has";
}

/// As many as DOCENT_KILLS says, for a long night.
TEST_F(AnUpdate, KilledAtRandomMomentsLeavesAWholeDatabase) {
  const char* const asked = std::getenv("DOCENT_KILLS");
  const int kills = asked != nullptr ? std::atoi(asked) : 30;
  std::mt19937 random(static_cast<unsigned>(kills));
  int killed = 0;
  std::uint64_t version = 2;
  const auto before = std::chrono::steady_clock::now();
  ASSERT_EQ(run_program("docent-update", arguments()).exit_code, 0);
  const auto whole = std::chrono::duration_cast<std::chrono::microseconds>(
      std::chrono::steady_clock::now() - before);
  publish(++version, "old");
  for (int i = 0; i < kills; ++i) {
    StartedProgram run(program("docent-update"), {"--once", "--config", path("kiosk.toml")},
                       path("said"));
    std::this_thread::sleep_for(std::chrono::microseconds(random() % (2 * whole.count())));
    run.signal(SIGKILL);
    const int end = run.wait();
    killed += end == -SIGKILL ? 1 : 0;
    ASSERT_THAT(shown_in(device_ / "museum.db"), AnyOf("old", "new")) << i;
    ASSERT_TRUE(end == 0 || end == -SIGKILL) << end << text_of(path("said"));
    if (end != 0) continue;
    ++version;
    publish(version, version % 2 == 0 ? "new" : "old");
  }
  EXPECT_GT(killed, kills / 10);
}

TEST_F(AnUpdate, CutOffFromPowerAtAnyMomentLeavesTheOldOrTheNew) {
  RecordedDisk disk(device_);
  const fs::path log = folder_.path() / "log", image = folder_.path() / "image";
  ASSERT_EQ(
      run_recorded("docent-update", arguments(), device_, "DOCENT_DISK_LOG='" + log.string() + "'")
          .exit_code,
      0);
  ASSERT_EQ(shown_in(device_ / "museum.db"), "new");

  int images = 0;
  for (const DiskOperation& operation : read_operations(log)) {
    disk.apply(operation);
    for (std::size_t changes = 0; changes < disk.cuts(); ++changes)
      for (const auto bytes : {RecordedDisk::Bytes::All, RecordedDisk::Bytes::OnlySynced}) {
        disk.write_after_cut(changes, bytes, image);
        ++images;
        ASSERT_NO_FATAL_FAILURE(
            expect_whole(image, fmt::format("after {} {}, with {} changes of names", operation.kind,
                                            operation.path, changes)));
      }
  }
  EXPECT_GT(images, 100);
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

TEST_F(AnUpdate, BackKilledBeforeAnyOfItsOperationsLeavesTheOldOrTheNew) {
  ASSERT_EQ(run_program("docent-update", arguments()).exit_code, 0);
  fs::remove_all(before_);
  fs::copy(device_, before_, fs::copy_options::recursive);
  for (int kill = 1;; ++kill) {
    restore();
    const ProgramRun run = run_recorded("docent-update", "--back --config " + path("kiosk.toml"),
                                        device_, fmt::format("DOCENT_DISK_KILL={}", kill));
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

}  // namespace
}  // namespace docent::test
