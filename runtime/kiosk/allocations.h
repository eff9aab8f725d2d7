#pragma once

#include <cstdint>

namespace docent {

/// Calls of operator new on this thread since it began. The kiosk replaces the global operator new
/// to count them: a frame must not add any.
std::uint64_t allocations_on_this_thread() noexcept;

}  // namespace docent
