#pragma once

#include <cstdint>

namespace docent::kiosk {

/// Calls of operator new on one thread since it began.
struct Allocations {
  std::uint64_t all = 0;
  std::uint64_t own = 0;  ///< Those made by this program's own code, not by a library.
};

/// The kiosk replaces the global operator new to count its calls: a frame must not add any.
Allocations allocations_on_this_thread() noexcept;

enum class Phase : std::uint8_t { Start, Frames };

/// Tells glibc's allocator what is to come, so that it gives back most of what starting takes.
void prepare_allocator_for(Phase phase) noexcept;

/// Gives back to the system what was freed. Any thread; takes a few milliseconds, for which others
/// may have to wait with their allocations, so call when nobody looks on.
void give_back_freed_memory() noexcept;

}  // namespace docent::kiosk
