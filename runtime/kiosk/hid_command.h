#pragma once

#include <span>
#include <vector>

#include "config/kiosk_config.h"
#include "platform/terminal/command_line.h"
#include "runtime/input/keypad_policy.h"
#include "runtime/kiosk/staff_page.h"

namespace docent::kiosk {

/// The devices that are present, each with what it is taken for, for the staff's page.
std::vector<StaffFact> device_facts(std::span<const input::NamedKeypad> keypads,
                                    const StaffWords& words);

/// The keypads that kiosk.toml names.
std::vector<input::NamedKeypad> named_keypads(const config::KioskConfig& config);

/// `docent hid list [--json]` and `docent hid decode FILE.hid`: which devices there are and what
/// each is taken for, and what the kiosk makes of a recording.
terminal::Command hid_command();

}  // namespace docent::kiosk
