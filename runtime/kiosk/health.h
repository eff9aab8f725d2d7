#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "runtime/kiosk/daily_counts.h"
#include "runtime/model/result.h"

namespace docent::kiosk {

/// How a kiosk is doing, for whoever watches over many of them. Times are seconds since 1970.
struct Health {
  bool is_up = true;
  std::uint64_t starts = 1;  ///< Since the machine started, this one included.
  std::uint64_t frames = 0, dropped_frames = 0, refused_databases = 0;
  double started = 0, last_frame = 0;
  std::string museum;       ///< What the database on the screen is called.
  double content_time = 0;  ///< When its file was written.
  std::optional<Errc> last_error;
  std::optional<double> free_bytes;   ///< On the disk that holds the database.
  std::optional<double> temperature;  ///< Degrees Celsius, of the hottest sensor.
};

/// As node_exporter's textfile collector reads it; with the counts of the last day that is over.
std::string to_prometheus(const Health& health, const std::optional<PublishedCounts>& last_day);

/// How many starts such a text tells of; 0 where it tells none.
std::uint64_t starts_told_in(std::string_view text) noexcept;

/// The hottest of a folder's thermal_zone*/temp, in degrees Celsius; empty where there is none.
std::optional<double> hottest_sensor(const std::filesystem::path& folder = "/sys/class/thermal");

}  // namespace docent::kiosk
