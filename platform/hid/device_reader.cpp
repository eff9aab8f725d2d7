#include "platform/hid/device_reader.h"

#include <utility>

#include "runtime/model/last_catch.h"

namespace docent::hid {
namespace {

using namespace std::chrono_literals;
constexpr auto patience = 50ms;  // how long a thread may overlook that it should stop

std::chrono::nanoseconds now() noexcept {
  return std::chrono::steady_clock::now().time_since_epoch();
}

}  // namespace

void DeviceReader::start(ReportSource source, input::EventMaker maker) {
  reading_ = true;
  thread_ = std::jthread([this, source = std::move(source), maker](
                             const std::stop_token& stop) mutable { read(stop, source, maker); });
}

void DeviceReader::stop() {
  thread_ = {};
}

void DeviceReader::read(const std::stop_token& stop, ReportSource& source,
                        input::EventMaker& maker) noexcept {
  using Moves = input::EventMaker::Moves;
  guarded("reading an input device", [&] {
    while (!stop.stop_requested() && source.is_present()) {
      const auto report = source.read(patience);
      if (report.empty()) {
        deliver(maker.wait(now()), stop);
        continue;
      }
      ++reports_;
      deliver(maker.take(report, now(), queue_.is_half_full() ? Moves::Later : Moves::All), stop);
    }
  });
  deliver(maker.lift_all(), stop);
  reading_ = false;
}

void DeviceReader::deliver(std::span<const input::InputEvent> events,
                           const std::stop_token& stop) noexcept {
  for (const input::InputEvent& event : events)
    while (!queue_.push(event) && !stop.stop_requested()) std::this_thread::sleep_for(1ms);
}

}  // namespace docent::hid
