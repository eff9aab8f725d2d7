#include "platform/hid/device_reader.h"

#include <gmock/gmock.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <memory>
#include <vector>

#include "tests/runtime/input/hid_bytes.h"

namespace docent::hid::device_reader_test {
namespace {

using namespace std::chrono_literals;
using test::bytes;
using test::join;

/// Stands for a touch screen: what is sent at one end is a report at the other. A report that the
/// reader leaves lying is lost, as the kernel loses it.
class StandIn {
 public:
  StandIn() {
    if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_NONBLOCK | SOCK_CLOEXEC, 0, ends_.data()) != 0)
      throw std::runtime_error("no socket pair");
  }
  StandIn(const StandIn&) = delete;
  StandIn& operator=(const StandIn&) = delete;
  ~StandIn() {
    unplug();
    close(ends_[1]);
  }

  /// False where it was lost.
  bool send(const std::vector<std::byte>& report) {
    return ::send(ends_[0], report.data(), report.size(), MSG_NOSIGNAL) ==
           static_cast<ssize_t>(report.size());
  }
  void unplug() {
    if (ends_[0] >= 0) close(ends_[0]);
    ends_[0] = -1;
  }

  ReportSource source() {
    return {.read = [this](std::chrono::milliseconds patience) { return read(patience); },
            .is_present = [this] { return present_; }};
  }

 private:
  std::span<const std::byte> read(std::chrono::milliseconds patience) {
    pollfd waiting{.fd = ends_[1], .events = POLLIN, .revents = 0};
    if (poll(&waiting, 1, static_cast<int>(patience.count())) <= 0) return {};
    const ssize_t size = recv(ends_[1], buffer_.data(), buffer_.size(), 0);
    if (size <= 0) present_ = false;
    return std::span(buffer_).first(size > 0 ? static_cast<std::size_t>(size) : 0);
  }

  std::array<int, 2> ends_{-1, -1};
  std::array<std::byte, 256> buffer_{};
  bool present_ = true;
};

constexpr int fingers = 5;

input::EventMaker five_fingers(std::uint32_t first_id) {
  const auto descriptor = input::parse_report_descriptor(
      join({test::begin_touch_screen(1), test::finger(), test::finger(), test::finger(),
            test::finger(), test::finger(), test::contact_count(), test::end_collection()}));
  return {*descriptor, input::classify(*descriptor), first_id};
}

/// All five fingers down at x, of 32767, or up.
std::vector<std::byte> report(bool down, int x) {
  std::vector<std::byte> out = bytes({1});
  for (int finger = 0; finger < fingers; ++finger)
    out = join({out, bytes({down ? 1 : 0, finger, x & 0xff, x >> 8, finger, 0})});
  return join({out, bytes({fingers})});
}

/// What the frame loop has been told.
struct Told {
  int downs = 0, ups = 0, moves = 0;
  float last_x = -1;

  void take(DeviceReader& reader) {
    for (input::InputEvent event; reader.pop(event);) {
      downs += event.kind == input::InputEvent::Kind::Down ? 1 : 0;
      ups +=
          event.kind == input::InputEvent::Kind::Up || event.kind == input::InputEvent::Kind::Cancel
              ? 1
              : 0;
      moves += event.kind == input::InputEvent::Kind::Move ? 1 : 0;
      last_x = event.contact.x;
    }
  }
};

void wait_until(const std::function<bool()>& done) {
  for (const auto end = std::chrono::steady_clock::now() + 60s;
       !done() && std::chrono::steady_clock::now() < end;)
    std::this_thread::sleep_for(1ms);
}

TEST(DeviceReader, LosesNoneOfAThousandReportsASecondFromEachOfFourDevices) {
  constexpr int per_device = 1000;
  std::array<StandIn, 4> devices;
  std::array<DeviceReader, 4> readers;
  std::array<Told, 4> told;
  for (std::size_t i = 0; i < devices.size(); ++i)
    readers[i].start(devices[i].source(), five_fingers(static_cast<std::uint32_t>(i) << 20U));

  int lost = 0;
  const auto begin = std::chrono::steady_clock::now();
  for (int sent = 0; sent < per_device; ++sent) {
    std::this_thread::sleep_until(begin + sent * 1ms);
    // each touch lasts ten reports
    for (StandIn& device : devices) lost += device.send(report(sent % 10 != 9, sent)) ? 0 : 1;
    if (sent % 16 == 0)  // a frame
      for (std::size_t i = 0; i < devices.size(); ++i) told[i].take(readers[i]);
  }
  wait_until([&] {
    return std::ranges::all_of(readers,
                               [](const DeviceReader& r) { return r.reports() == per_device; });
  });

  EXPECT_EQ(lost, 0);
  for (std::size_t i = 0; i < devices.size(); ++i) {
    readers[i].stop();
    told[i].take(readers[i]);
    EXPECT_EQ(readers[i].reports(), static_cast<std::uint64_t>(per_device));
    EXPECT_EQ(told[i].downs, per_device / 10 * fingers);
    EXPECT_EQ(told[i].ups, per_device / 10 * fingers);
    EXPECT_GT(told[i].moves, 0);
  }
}

TEST(DeviceReader, NeverWaitsForAFrameLoopThatIsStuckWhileFingersMove) {
  constexpr int moves = 5000;  // of five fingers: 24 times what the queue holds
  StandIn device;
  DeviceReader reader;
  reader.start(device.source(), five_fingers(0));
  for (int i = 0; i < moves; ++i) wait_until([&] { return device.send(report(true, i)); });

  wait_until([&] { return reader.reports() == moves; });
  EXPECT_EQ(reader.reports(), static_cast<std::uint64_t>(moves));
  Told told;
  told.take(reader);
  EXPECT_EQ(told.downs, fingers);
  device.send(report(true, 32767));
  wait_until([&] { return reader.reports() == moves + 1; });
  reader.stop();
  told.take(reader);
  EXPECT_EQ(told.ups, fingers) << "those that are down when the reading ends";
  EXPECT_EQ(told.last_x, 1.F) << "it is told where they ended up";
}

TEST(DeviceReader, LiftsAllFingersOfADeviceThatIsPulledOut) {
  StandIn device;
  DeviceReader reader;
  reader.start(device.source(), five_fingers(0));
  device.send(report(true, 100));
  wait_until([&] { return reader.reports() == 1; });

  device.unplug();
  wait_until([&] { return !reader.is_reading(); });
  EXPECT_FALSE(reader.is_reading());
  Told told;
  told.take(reader);
  EXPECT_EQ(told.downs, fingers);
  EXPECT_EQ(told.ups, fingers);
}

}  // namespace
}  // namespace docent::hid::device_reader_test
