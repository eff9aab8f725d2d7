#include "platform/hid/device_log.h"

#include <algorithm>

namespace docent::hid {

std::optional<std::string> DeviceLog::failed(const std::string& path, const std::string& reason,
                                             Time now) {
  const auto [entry, is_new] = failures_.try_emplace(path, Failure{reason, now});
  Failure& failure = entry->second;
  if (failure.reason != reason) failure = {.reason = reason, .since = now};
  if (failure.said || now - failure.since < patience) return {};
  failure.said = true;
  return reason;
}

void DeviceLog::works(const std::string& path) {
  failures_.erase(path);
}

void DeviceLog::keep(std::span<const std::string> present) {
  std::erase_if(failures_, [&](const auto& failure) {
    return std::ranges::find(present, failure.first) == present.end();
  });
}

}  // namespace docent::hid
