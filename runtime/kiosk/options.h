#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "config/display_kind.h"
#include "platform/display.h"
#include "platform/journal/message.h"
#include "platform/terminal/command_line.h"
#include "runtime/model/result.h"

namespace docent::kiosk {

/// This device's settings, where the command line names no other.
inline constexpr std::string_view default_config = "/etc/docent/kiosk.toml";

/// The command line of `docent`. What is not given comes from kiosk.toml.
struct Options {
  std::optional<std::filesystem::path> content;
  std::optional<std::filesystem::path> config;
  std::optional<config::DisplayKind> display;
  std::optional<PixelSize> size;
  std::optional<Rotation> rotation;
  std::filesystem::path visit, record, states, stats, speech;  ///< Empty where not asked for.
  std::filesystem::path health, counts;                        ///< Likewise.
  std::optional<std::filesystem::path> today;
  std::optional<double> seconds;
  std::vector<std::string> hid;
};

/// The command line of `docent`: stores what it says in `options` and then calls `run`, or one of
/// the commands that come instead.
terminal::Command program(Options& options, std::function<int()> run);

/// Says an error on standard error, for an operator; returns the exit code for it.
int say(const Error& error, journal::Message message = journal::Message::CannotStart);

}  // namespace docent::kiosk
