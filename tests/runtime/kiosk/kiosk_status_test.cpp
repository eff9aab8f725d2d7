#include "runtime/kiosk/kiosk_status.h"

#include <gmock/gmock.h>

#include <thread>

#include "runtime/kiosk/allocations.h"
#include "tests/support/temporary_folder.h"

namespace docent::kiosk::kiosk_status_test {
namespace {

using testing::HasSubstr;

KioskStatus some_status() {
  return {.version = "1.2",
          .started = 1763900000,
          .uptime_seconds = 61.25,
          .restarts = 2,
          .display = "a screen",
          .content = {.path = "/var/lib/docent/museum.db",
                      .museum = "The \"Rose\"",
                      .checksum = "00ff",
                      .schema = 7},
          .counts = {.frames = 10, .dropped_frames = 1, .touches = 5, .routes = 3, .visits = 2},
          .refusals = {.count = 1, .last = Errc::Damaged},
          .devices = {{"/dev/hidraw0", "Glass\n", "touch screen", true},
                      {"/dev/hidraw1", "Keys", "keypad", false}},
          .last_error = "",
          .free_bytes = 5'000'000};
}

TEST(Status, IsOneJsonObject) {
  EXPECT_EQ(to_json(some_status()), R"({
  "version": "1.2",
  "uptime_s": 61.2,
  "restarts": 2,
  "display": "a screen",
  "content": {"path": "/var/lib/docent/museum.db", "museum": "The \"Rose\"", "checksum": "00ff", "schema": 7, "signature": "none"},
  "frames": 10,
  "dropped_frames": 1,
  "visits": 2,
  "touches": 5,
  "routes": 3,
  "refused_databases": 1,
  "devices": [{"path": "/dev/hidraw0", "name": "Glass\u000a", "kind": "touch screen", "used": true}, {"path": "/dev/hidraw1", "name": "Keys", "kind": "keypad", "used": false}],
  "last_error": null,
  "free_bytes": 5000000
}
)");
}

TEST(Status, SaysNothingOfWhatIsNotKnown) {
  KioskStatus status = some_status();
  status.restarts.reset();
  status.last_error = "a \\ and a \"";

  EXPECT_THAT(to_json(status), HasSubstr("\"restarts\": null,"));
  EXPECT_THAT(to_json(status), HasSubstr(R"("last_error": "a \\ and a \"",)"));
}

TEST(Status, IsTextForPeople) {
  EXPECT_EQ(to_text(some_status()),
            "docent 1.2, for 61 s, restarted 2 times, on a screen\n"
            "shows 'The \"Rose\"', from /var/lib/docent/museum.db (schema 7, checksum 00ff, "
            "signature: none)\n"
            "10 frames, 1 dropped; 2 visits, 5 touches, 3 routes\n"
            "/dev/hidraw0: Glass\n, touch screen\n"
            "/dev/hidraw1: Keys, keypad, not used\n"
            "no error since it started\n"
            "5 MB free where the database lies\n");
}

TEST(StatusBoard, TellsTheLastCountsHoweverOftenItIsAsked) {
  StatusBoard board(std::chrono::nanoseconds(0), "memory");
  board.shows({.path = "/tmp/a.db", .museum = "A"});
  board.counts({.frames = 1});
  board.counts({.frames = 2});

  EXPECT_EQ(board.read().counts.frames, 2U);
  EXPECT_EQ(board.read().counts.frames, 2U);
  EXPECT_EQ(board.read().content.museum, "A");
  EXPECT_GT(board.read().free_bytes.value_or(0), 0);
}

TEST(StatusBoard, TakesCountsOfAFrameWithoutAllocating) {
  StatusBoard board(std::chrono::nanoseconds(0), "memory");
  const std::uint64_t before = allocations_on_this_thread().all;

  for (std::uint64_t frame = 0; frame < 600; ++frame) board.counts({.frames = frame});

  EXPECT_EQ(allocations_on_this_thread().all, before);
}

TEST(StatusBoard, NeverMixesTheCountsOfTwoFrames) {
  StatusBoard board(std::chrono::nanoseconds(0), "memory");
  std::jthread frames([&](const std::stop_token& stop) {
    for (std::uint64_t n = 0; !stop.stop_requested(); ++n)
      board.counts({.frames = n, .dropped_frames = n, .touches = n, .routes = n, .visits = n});
  });

  const auto look = [&] {
    for (int i = 0; i < 100; ++i) {
      const StatusCounts counts = board.read().counts;
      EXPECT_EQ(counts.frames, counts.visits);
      EXPECT_EQ(counts.frames, counts.routes);
    }
  };
  std::jthread another(look);
  look();
}

TEST(StatusBoard, CountsWhatWasRefusedAndKnowsWhy) {
  StatusBoard board(std::chrono::nanoseconds(0), "memory");
  EXPECT_FALSE(board.read().refusals.last.has_value());

  board.refused(Errc::NotFound);
  board.refused(Errc::Damaged);

  EXPECT_EQ(board.read().refusals.count, 2U);
  EXPECT_EQ(board.read().refusals.last, Errc::Damaged);
}

TEST(Restarts, AreCountedInTheServicesFolder) {
  const test::TemporaryFolder folder;

  EXPECT_EQ(count_start(folder.path().c_str()), 0U);
  EXPECT_EQ(count_start(folder.path().c_str()), 1U);
  EXPECT_EQ(count_start(folder.path().c_str()), 2U);
  EXPECT_EQ(count_start(nullptr), std::nullopt);
  EXPECT_EQ(count_start("/there/is/none"), std::nullopt);
}

}  // namespace
}  // namespace docent::kiosk::kiosk_status_test
