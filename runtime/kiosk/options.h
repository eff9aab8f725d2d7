#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "platform/display.h"

namespace docent::kiosk {

enum class DisplayKind : std::uint8_t { Auto, Kms, Window, Headless };

/// The command line of `docent`. What is not given comes from kiosk.toml.
struct Options {
  std::optional<std::filesystem::path> content;
  std::filesystem::path config = "/etc/docent/kiosk.toml";
  bool config_given = false;
  std::optional<DisplayKind> display;
  std::optional<PixelSize> size;
  std::optional<Rotation> rotation;
  std::filesystem::path visit, record, stats;  ///< Empty where not asked for.
  std::optional<double> seconds;
  std::vector<std::string> hid;
};

/// What to do with a command line: run with these options, or leave with this exit code because
/// everything there was to say (help, version, what is wrong) has been said.
struct CommandLine {
  Options options;
  std::optional<int> exit;
};
/// The display of that name; Auto for any other.
DisplayKind display_named(std::string_view name) noexcept;

CommandLine parse_command_line(int argc, const char* const* argv);

}  // namespace docent::kiosk
