// How long does a report take to become a contact: through the decoder alone, and through a reader
// thread to the thread that takes events?

#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>
#include <vector>

#include "platform/hid/device_reader.h"
#include "runtime/input/hid_recording.h"

using namespace docent;
using namespace std::chrono_literals;

namespace {

using Clock = std::chrono::steady_clock;

struct Played {
  std::string name;
  input::ReportDescriptor descriptor;
  input::HidDeviceKind kind;
  input::HidRecording recording;
};

std::vector<Played> recordings_in(const std::filesystem::path& folder) {
  std::vector<Played> out;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".hid") continue;
    std::stringstream text;
    text << std::ifstream(entry.path()).rdbuf();
    auto recording = input::parse_hid_recording(text.str(), entry.path().string());
    if (!recording) continue;
    auto descriptor = input::parse_report_descriptor(recording->descriptor);
    if (!descriptor) continue;
    auto kind = input::classify(*descriptor, recording->id);
    out.push_back({entry.path().stem().string(), *descriptor, kind, std::move(*recording)});
  }
  return out;
}

/// Prints median, 99 % and the longest, in microseconds.
void print(std::string_view what, std::vector<double>& micros) {
  std::ranges::sort(micros);
  const auto at = [&](double share) {
    return micros[static_cast<std::size_t>(share * static_cast<double>(micros.size() - 1))];
  };
  fmt::print("{:<44} {:>8} reports  p50 {:.2f} us  p99 {:.2f} us  longest {:.1f} us\n", what,
             micros.size(), at(0.5), at(0.99), micros.back());
}

/// Every report of every recording, by the decoder and the maker of events.
void decode_all(const std::vector<Played>& recordings, int rounds) {
  std::vector<double> micros;
  std::size_t events = 0;
  for (const Played& device : recordings) {
    input::EventMaker maker(device.descriptor, device.kind, 0);
    for (int round = 0; round < rounds; ++round)
      for (const auto& report : device.recording.reports) {
        const auto begin = Clock::now();
        events += maker.take(report, begin.time_since_epoch()).size();
        micros.push_back(std::chrono::duration<double, std::micro>(Clock::now() - begin).count());
      }
  }
  print("report to events, in memory", micros);
  fmt::print("{:<44} {:>8} events\n", "", events);
}

/// The way through the kernel, the reader thread and the queue, as the frame thread sees it.
void through_a_thread(const Played& device, int rounds) {
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0) return;
  std::array<std::byte, 4096> buffer{};
  const auto read = [&](std::chrono::milliseconds patience) -> std::span<const std::byte> {
    pollfd waiting{.fd = ends[1], .events = POLLIN, .revents = 0};
    if (poll(&waiting, 1, static_cast<int>(patience.count())) <= 0) return {};
    const ssize_t size = recv(ends[1], buffer.data(), buffer.size(), 0);
    return std::span(buffer).first(size > 0 ? static_cast<std::size_t>(size) : 0);
  };
  hid::DeviceReader reader;
  reader.start({.read = read, .is_present = [] { return true; }},
               input::EventMaker(device.descriptor, device.kind, 0));
  input::EventMaker expected(device.descriptor, device.kind, 0);
  std::vector<double> micros;
  for (int round = 0; round < rounds; ++round)
    for (const auto& report : device.recording.reports) {
      const auto begin = Clock::now();
      const std::size_t owed = expected.take(report, begin.time_since_epoch()).size();
      const auto sent = Clock::now();
      if (send(ends[0], report.data(), report.size(), MSG_NOSIGNAL) < 0) return;
      input::InputEvent event;
      std::size_t got = 0;
      while (got < owed)
        if (reader.pop(event)) ++got;
      if (owed > 0)
        micros.push_back(std::chrono::duration<double, std::micro>(Clock::now() - sent).count());
      std::this_thread::sleep_for(200us);
    }
  reader.stop();
  close(ends[0]);
  close(ends[1]);
  print("report to event in another thread, by socket", micros);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("How long does a report take to become a contact?");
  std::filesystem::path folder = DOCENT_REFERENCE_DATA "/hid/mt";
  int rounds = 100;
  app.add_option("--recordings", folder, "Recordings of hid-recorder");
  app.add_option("--rounds", rounds, "How often each is played");
  CLI11_PARSE(app, argc, argv);

  const std::vector<Played> recordings = recordings_in(folder);
  if (recordings.empty()) {
    fmt::print(stderr, "{}: no recordings\n", folder.string());
    return 1;
  }
  decode_all(recordings, rounds);
  through_a_thread(recordings.front(), std::max(1, rounds / 10));
  return 0;
}
