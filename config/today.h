#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "config/located.h"
#include "runtime/model/museum.h"
#include "runtime/model/today.h"

namespace docent::config {

/// Reads a today.toml: what is closed just now.
///
///     [[closed]]
///     door = "east-gate"              # or room, connection, exhibit
///     until = 2026-12-24T18:00:00     # by the museum's clock; a day alone: until its end
///     reason.en = "A filming"
///
/// Whatever it names has to be in the museum. A file in which anything is wrong has no value.
Loaded<Today> load_today(const std::filesystem::path& file, const Museum& museum);

/// The same for text in memory. `name` is what diagnostics call it.
Loaded<Today> parse_today(std::string_view text, const std::string& name, const Museum& museum);

}  // namespace docent::config
