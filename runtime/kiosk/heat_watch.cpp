#include "runtime/kiosk/heat_watch.h"

#include <fmt/format.h>

#include <algorithm>
#include <condition_variable>
#include <fstream>
#include <mutex>
#include <string>
#include <utility>

#include "platform/journal/journal.h"

namespace docent::kiosk {
namespace {

constexpr long cooler_by = 3000;  ///< Thousandths of a degree.

std::optional<long> read_number(const std::filesystem::path& file) {
  std::ifstream in(file);
  long number = 0;
  return in >> number ? std::optional(number) : std::nullopt;
}

/// The lowest passive trip point of a zone.
std::optional<long> passive_trip_of(const std::filesystem::path& zone) {
  constexpr int most_trips = 16;
  std::optional<long> lowest;
  for (int i = 0; i < most_trips; ++i) {
    std::ifstream type_file(zone / fmt::format("trip_point_{}_type", i));
    std::string type;
    if (!(type_file >> type)) break;
    if (type != "passive") continue;
    const auto trip = read_number(zone / fmt::format("trip_point_{}_temp", i));
    if (trip && *trip > 0 && (!lowest || *trip < *lowest)) lowest = trip;
  }
  return lowest;
}

}  // namespace

std::vector<ThermalZone> read_thermal_zones(const std::filesystem::path& folder) {
  std::vector<ThermalZone> zones;
  std::error_code none;
  for (std::filesystem::directory_iterator entry(folder, none), end; !none && entry != end;
       entry.increment(none)) {
    const auto trip = passive_trip_of(entry->path());
    if (!trip) continue;
    if (const auto temperature = read_number(entry->path() / "temp"))
      zones.push_back({*temperature, *trip});
  }
  return zones;
}

bool is_too_hot(std::span<const ThermalZone> zones, bool was_too_hot) noexcept {
  const long margin = was_too_hot ? cooler_by : 0;
  return std::ranges::any_of(zones, [margin](const ThermalZone& zone) {
    return zone.temperature >= zone.passive_trip - margin;
  });
}

HeatWatch::HeatWatch(std::filesystem::path folder, std::chrono::milliseconds look_every)
    : thread_([this, folder = std::move(folder), look_every](const std::stop_token& stop) {
        watch(stop, folder, look_every);
      }) {}

void HeatWatch::watch(const std::stop_token& stop, const std::filesystem::path& folder,
                      std::chrono::milliseconds look_every) {
  std::mutex mutex;
  std::unique_lock lock(mutex);
  std::condition_variable_any stopped;
  while (!stop.stop_requested()) {
    const bool was = is_too_hot();
    const bool is = kiosk::is_too_hot(read_thermal_zones(folder), was);
    is_too_hot_.store(is, std::memory_order_relaxed);
    if (is && !was)
      journal::tell(journal::Message::TooHot,
                    "the machine is too hot; 30 frames a second until it has cooled down. Is its "
                    "air free?");
    if (was && !is)
      journal::tell(journal::Message::CooledDown,
                    "the machine has cooled down; 60 frames a second");
    stopped.wait_for(lock, stop, look_every, [] { return false; });
  }
}

}  // namespace docent::kiosk
