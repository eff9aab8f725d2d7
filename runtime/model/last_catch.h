#pragma once

#include <chrono>
#include <cstdio>
#include <exception>
#include <stop_token>
#include <string_view>
#include <thread>

namespace docent {

/// The last catch of a thread: calls `work`, and what it throws (no memory, a library's exception)
/// becomes a line in the journal that begins with `what`, instead of the end of the program.
/// Returns whether the work ended by itself.
bool guarded(std::string_view what, auto&& work) noexcept {
  const auto say = [what](const char* why) {
    std::fprintf(stderr, "docent: %.*s failed (%s); it goes on\n", static_cast<int>(what.size()),
                 what.data(), why);
  };
  try {
    work();
    return true;
  } catch (const std::exception& error) {
    say(error.what());
  } catch (...) {
    say("unknown reason");
  }
  return false;
}

/// Calls `work` until it ends by itself or the thread is asked to stop. What it throws becomes a
/// line in the journal, and a second later the work is begun again.
void keep_running(std::string_view what, const std::stop_token& stop, auto&& work) noexcept {
  constexpr auto step = std::chrono::milliseconds(50);  // how long a stop may be overlooked
  constexpr int steps = 20;
  while (!stop.stop_requested() && !guarded(what, work))
    for (int i = 0; i < steps && !stop.stop_requested(); ++i) std::this_thread::sleep_for(step);
}

}  // namespace docent
