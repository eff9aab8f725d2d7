#pragma once

#include <memory>

#include "runtime/kiosk/options.h"
#include "runtime/model/result.h"

namespace docent::kiosk {

/// The exit code of a kiosk that staff ended on its glass: docent.service does not start it again.
inline constexpr int ended_by_staff = 42;

/// From here on SIGHUP asks for a new database instead of ending the program. The first thing in
/// main(): a console sends SIGHUP too, as soon as another program takes it.
void expect_reloads() noexcept;

/// Runs the guide on the screen and glass that the options name until it is told to stop (SIGTERM,
/// SIGINT, the window's close button, a visit's quit, --seconds). Returns docent(1)'s exit code;
/// every problem has been said on standard error. `started`: when the program began.
int run_kiosk(const Options& options, std::chrono::nanoseconds started);

}  // namespace docent::kiosk
