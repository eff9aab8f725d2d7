#include "runtime/kiosk/staff_lock.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "platform/pin/pin.h"

namespace docent::kiosk {

void StaffLock::try_pin(std::string pin, double time) {
  if (!has_pin() || is_checking() || pause_left(time) > 0) return;
  checking_ = std::async(std::launch::async,
                         [pin = std::move(pin), hash = hash_] { return pin::matches(pin, hash); });
}

std::optional<bool> StaffLock::answer(double time) {
  if (!checking_.valid() ||
      checking_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
    return std::nullopt;
  const bool right = checking_.get();
  wrong_ = right ? 0 : wrong_ + 1;
  if (!right) next_try_ = time + std::min(longest_pause, std::exp2(std::min(wrong_, 20) - 1));
  return right;
}

void StaffLock::wait() const {
  if (checking_.valid()) checking_.wait();
}

}  // namespace docent::kiosk
