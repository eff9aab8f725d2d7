#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "runtime/kiosk/staff_page.h"
#include "runtime/kiosk/staff_words.h"
#include "runtime/kiosk/statistics.h"
#include "runtime/model/museum.h"

namespace docent::kiosk {

/// What runs, as the kiosk knows it.
struct RunningKiosk {
  const Museum& museum;
  const Statistics& statistics;
  std::filesystem::path database;
  std::string screen;  ///< In words.
  std::uint64_t touches = 0;
};

/// What staff are told of it.
std::vector<StaffFact> facts_of(const RunningKiosk& kiosk, const StaffWords& words);

}  // namespace docent::kiosk
