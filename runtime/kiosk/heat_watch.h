#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <thread>
#include <vector>

namespace docent::kiosk {

/// A part of the machine that reports its temperature, in thousandths of a degree Celsius.
struct ThermalZone {
  long temperature = 0;
  long passive_trip = 0;  ///< From here on the machine should work less.
};

/// Reads the thermal zones that have a passive trip point (Linux,
/// Documentation/driver-api/thermal); `folder` holds one folder for each zone. Empty where there is
/// none.
std::vector<ThermalZone> read_thermal_zones(const std::filesystem::path& folder);

/// Should the machine work less? It goes on so until every zone is three degrees below its trip.
bool is_too_hot(std::span<const ThermalZone> zones, bool was_too_hot) noexcept;

/// Looks at the machine's temperature every few seconds, on a thread of its own, and says in the
/// journal when it gets too hot and when that is over.
class HeatWatch {
 public:
  explicit HeatWatch(std::filesystem::path folder = "/sys/class/thermal",
                     std::chrono::milliseconds look_every = std::chrono::seconds(5));

  bool is_too_hot() const noexcept { return is_too_hot_.load(std::memory_order_relaxed); }
  /// May this frame, counted from the start, be shown? In the heat only every other one.
  bool lets_show(std::uint64_t frame) const noexcept { return !is_too_hot() || frame % 2 == 0; }

 private:
  void watch(const std::stop_token& stop, const std::filesystem::path& folder,
             std::chrono::milliseconds look_every);

  std::atomic<bool> is_too_hot_ = false;
  std::jthread thread_;
};

}  // namespace docent::kiosk
