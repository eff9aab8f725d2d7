#pragma once

namespace docent::kiosk {

/// Gives back the memory of code that a start needs, and seldom something later: of every large
/// library the pages that nobody writes to. They stay in the system's cache of the file, from which
/// one that is needed after all comes back without waiting for the disk. A software driver's
/// compiler of shaders (LLVM) is 55 MB of such pages, and with its shaders compiled needs next to
/// none of them. Neither allocates nor waits; it costs a frame a millisecond or two.
void give_back_code_of_start() noexcept;

}  // namespace docent::kiosk
