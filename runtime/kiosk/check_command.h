#pragma once

#include "platform/terminal/command_line.h"

namespace docent::kiosk {

/// `docent check DB`: would the kiosk take up this database? It is read as the kiosk reads it,
/// with the keys of kiosk.toml.
terminal::Command check_command();

}  // namespace docent::kiosk
