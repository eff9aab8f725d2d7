#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "runtime/kiosk/daily_counts.h"
#include "runtime/kiosk/kiosk_status.h"

namespace docent::kiosk {

/// How a kiosk is doing, for whoever watches over many of them.
struct Health {
  KioskStatus status;
  bool is_up = true;
  std::uint64_t starts = 1;           ///< Since the machine started, this one included.
  std::optional<double> temperature;  ///< Degrees Celsius, of the hottest sensor.
};

/// As node_exporter's textfile collector reads it; with the counts of the last day that is over.
std::string to_prometheus(const Health& health, const std::optional<PublishedCounts>& last_day);

/// How many starts such a text tells of; 0 where it tells none.
std::uint64_t starts_told_in(std::string_view text) noexcept;

/// The hottest of a folder's thermal_zone*/temp, in degrees Celsius; empty where there is none.
std::optional<double> hottest_sensor(const std::filesystem::path& folder = "/sys/class/thermal");

}  // namespace docent::kiosk
