#include "runtime/kiosk/service_notice.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>

namespace docent::kiosk {
namespace {

/// So often within the manager's patience is a sign given, if there is one.
constexpr int signs_in_patience = 4;
constexpr int patience_in_starts = 3;

/// Lines for the manager are made in place; one that is too long is cut.
using Space = std::array<char, 256>;

std::string_view made_in(const Space& space, const fmt::format_to_n_result<char*>& made) noexcept {
  return {space.data(), std::min(made.size, space.size())};
}

}  // namespace

ServiceNotice ServiceNotice::of_environment(Time started) {
  return {service::NotifySocket(std::getenv("NOTIFY_SOCKET")),
          service::watchdog_patience(std::getenv("WATCHDOG_USEC"), std::getenv("WATCHDOG_PID")),
          started};
}

void ServiceNotice::starts(std::string_view step) noexcept {
  constexpr std::chrono::microseconds for_a_step = std::chrono::minutes(5);
  Space space{};
  manager_.tell(made_in(space, fmt::format_to_n(space.data(), space.size(),
                                                "STATUS=starts: {}\nEXTEND_TIMEOUT_USEC={}", step,
                                                for_a_step.count())));
}

void ServiceNotice::shows(std::string_view museum) noexcept {
  Space space{};
  manager_.tell(
      made_in(space, fmt::format_to_n(space.data(), space.size(), "STATUS=shows {}", museum)));
}

void ServiceNotice::alive(Time now) noexcept {
  if (!manager_.is_there() || now < next_sign_) return;
  if (!is_ready_)
    is_ready_ = tell_ready(now);
  else if (!manager_.tell("WATCHDOG=1"))
    return;  // with the next frame
  if (is_ready_)
    next_sign_ = patience_.count() > 0 ? now + patience_ / signs_in_patience : Time::max();
}

bool ServiceNotice::tell_ready(Time now) noexcept {
  const auto wanted =
      std::chrono::ceil<std::chrono::microseconds>(now - started_) * patience_in_starts;
  if (patience_.count() == 0 || wanted <= patience_) return manager_.tell("READY=1");
  patience_ = wanted;
  Space space{};
  return manager_.tell(
      made_in(space, fmt::format_to_n(space.data(), space.size(), "READY=1\nWATCHDOG_USEC={}",
                                      patience_.count())));
}

}  // namespace docent::kiosk
