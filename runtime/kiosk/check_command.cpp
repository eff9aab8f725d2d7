#include "runtime/kiosk/check_command.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>

#include "config/diagnostic_text.h"
#include "config/kiosk_config.h"
#include "runtime/kiosk/exhibition.h"
#include "runtime/kiosk/options.h"

namespace docent::kiosk {
namespace {

struct CheckOptions {
  std::string database;
  std::filesystem::path config{default_config};
};

int check(const CheckOptions& options) {
  const config::Loaded<config::KioskConfig> config = config::load_kiosk_config(options.config);
  config::tell(config.diagnostics);
  if (!config.value || !config.diagnostics.empty()) return 1;
  const Result<Selection> selection = selection_of(*config.value);
  if (!selection) return say(selection.error());
  const std::string& database = options.database;
  const Result<ReadMuseum> read = read_museum(database, *selection);
  if (!read) return say(read.error(), journal::Message::Refused);
  fmt::print("{}: can be shown: {}\n", database, summary(read->museum));
  return 0;
}

}  // namespace

terminal::Command check_command() {
  const auto options = std::make_shared<CheckOptions>();
  return {.name = "check",
          .manual = "says whether a database can be shown, or why not",
          .options = {{"DB", terminal::file("DB", options->database), "The compiled museum",
                       terminal::Times::Once},
                      {"--config", terminal::file("FILE", options->config),
                       "This device's settings: its keys, and which kiosk it is",
                       terminal::Times::AtMostOnce, default_config}},
          .run = [options] { return check(*options); }};
}

}  // namespace docent::kiosk
