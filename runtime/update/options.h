#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "platform/terminal/command_line.h"

namespace docent::update {

/// The command line of `docent-update`. What is not given comes from kiosk.toml.
struct Options {
  std::optional<std::string> source;
  std::filesystem::path config = "/etc/docent/kiosk.toml";
  bool once = false, back = false, starting = false, json = false;
};

terminal::Command program(Options& options, std::function<int()> run);

/// Does what the options say; returns docent-update(1)'s exit code, after every problem has been
/// said.
int run_update(const Options& options);

}  // namespace docent::update
