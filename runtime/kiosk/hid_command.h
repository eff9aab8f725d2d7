#pragma once

#include <span>

namespace docent::kiosk {

/// `docent hid list [--json]` and `docent hid decode FILE.hid`: what comes after `docent hid`.
/// Prints the answer or what is wrong; returns CONTRACT's exit code.
int run_hid_command(std::span<const char* const> arguments);

}  // namespace docent::kiosk
