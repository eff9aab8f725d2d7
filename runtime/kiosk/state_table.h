#pragma once

#include <string>

#include "runtime/guide/guide.h"

namespace docent::kiosk {

/// Where everybody is and what they do, as docent(1) says of states.csv.
class StateTable {
 public:
  /// Adds a row for each avatar. `time`: seconds since the first frame.
  void add(double time, const guide::Guide& guide);
  const std::string& csv() const noexcept { return csv_; }

 private:
  std::string csv_ = "time,avatar,x,y,heading,state\n";
};

}  // namespace docent::kiosk
