#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/model/local_text.h"

namespace docent {

/// A round of exhibits that staff put together, or for who has so much time. Invariant: there is an
/// exhibit, and none twice.
struct Tour {
  std::string id;   ///< Stable: names it in visits.
  LocalText title;  ///< Empty: it is for who has `minutes`, which are more than 0 then.
  std::vector<std::uint32_t> exhibits;  ///< Indices into Museum::exhibits, as they are visited.
  bool fixed = false;  ///< In the order that staff wrote; else in the shortest from the kiosk.
  double seconds = 0;  ///< From the kiosk to the end of the last look.
  std::vector<double> arrives;  ///< Seconds from the kiosk to each exhibit, looks before included.
  double minutes = 0;           ///< What is promised; 0 where nothing is.
};

/// Is it what there is time for in its minutes, rather than what staff have made?
inline bool is_for_time(const Tour& tour) noexcept {
  return tour.title.empty();
}

}  // namespace docent
