#pragma once

/// Signals are taken between two frames; no handler runs in the middle of one, nor on whichever
/// thread the kernel chooses.
namespace docent::kiosk {

/// From here on a signal waits until it is taken, for this thread and all that it begins later.
void expect_signal(int signal) noexcept;
/// Has an expected signal come since it was last taken? Waits for nothing.
bool take_signal(int signal) noexcept;
/// Would take_signal say so? It stays to be taken. Any thread may ask.
bool is_signal_waiting(int signal) noexcept;

}  // namespace docent::kiosk
