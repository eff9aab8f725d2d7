#include "runtime/update/options.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>
#include <utility>

#include "config/diagnostic_text.h"
#include "config/kiosk_config.h"
#include "runtime/schema/schema.h"
#include "runtime/update/update.h"

namespace docent::update {
namespace {

/// Without --once, and as the timer of the package has it.
constexpr std::chrono::hours between_looks{1};

release::Time now() {
  return std::chrono::duration_cast<std::chrono::seconds>(
             std::chrono::system_clock::now().time_since_epoch())
      .count();
}

int say(const Options& options, const Result<Outcome>& outcome) {
  const int code = outcome ? 0 : exit_code(outcome.error().code);
  const std::string& sentence = outcome ? outcome->sentence : outcome.error().what;
  if (options.json) {
    nlohmann::ordered_json json;
    json["status"] = outcome ? outcome->status : code == 1 ? "refused" : "failed";
    if (outcome) json["release"] = outcome->release;
    json["message"] = sentence;
    fmt::print("{}\n", json.dump());
  } else {
    fmt::print(outcome ? stdout : stderr, "docent-update: {}\n", sentence);
  }
  std::fflush(stdout);
  return code;
}

Result<Settings> settings_of(const Options& options, const config::KioskConfig& config) {
  Result<std::vector<signature::PublicKey>> keys = signature::read_public_keys(config.keys);
  if (!keys) return std::unexpected(keys.error());
  return Settings{
      .store = {config.content},
      .source = {.place = options.source.value_or(config.source),
                 .session =
                     std::filesystem::path(config.content).replace_filename("update.session")},
      .keys = std::move(*keys),
      .device = {.program = std::string(terminal::version()),
                 .schema = schema::version,
                 .group = config.group}};
}

/// Releases are taken only where it is known whose they have to be.
Result<void> check_whence(const Options& options, const Settings& settings) {
  const auto lacks = [&](const char* what) {
    return std::unexpected(
        Error{Errc::InvalidInput, fmt::format("{}: {}", options.config.string(), what)});
  };
  if (settings.keys.empty())
    return lacks("names no key, and only signed releases are taken; add keys = [\"museum.pub\"]");
  if (settings.source.place.empty())
    return lacks("names no source of releases; add source = \"https://...\", or give --source");
  return {};
}

int run_with(const Options& options, const Settings& settings) {
  become_owner(settings.store);
  if (options.starting) return say(options, prepare_start(settings, now()));
  if (options.back) return say(options, go_back(settings, now()));
  if (const Result<void> known = check_whence(options, settings); !known)
    return say(options, std::unexpected(known.error()));
  for (;;) {
    const int code = say(options, update(settings, now()));
    if (options.once) return code;
    std::this_thread::sleep_for(between_looks);
  }
}

}  // namespace

terminal::Command program(Options& options, std::function<int()> run) {
  using terminal::Times;
  return {.name = "docent-update",
          .manual = "brings new content to a kiosk: fetches, verifies and installs signed releases",
          .options =
              {{"--source", terminal::text("URL|DIR", options.source, terminal::Offers::Folders),
                "Where releases are: the address of a folder on a web server, or a folder",
                Times::AtMostOnce, "what kiosk.toml says"},
               {"--config", terminal::file("FILE", options.config), "This device's settings",
                Times::AtMostOnce, "/etc/docent/kiosk.toml"},
               {"--once", terminal::flag(options.once),
                "Look once and end, instead of once an hour for ever"},
               {"--back", terminal::flag(options.back),
                "Return to the release before the one shown, which is not taken again"},
               {"--starting", terminal::flag(options.starting),
                "The kiosk is about to start: return to the release before where it starts for the "
                "third time within ten minutes of an update, and change to a kept release that the "
                "program can show where it cannot show the present one"},
               {"--json", terminal::flag(options.json), "Say what came of it as JSON"}},
          .run = std::move(run),
          .sections = {
              {.title = "files",
               .rows = {{"/etc/docent/kiosk.toml", "keys, source and group; content says where"},
                        {"/var/lib/docent/museum.db", "The database that is shown"},
                        {"/var/lib/docent/releases", "The last three releases"},
                        {"/var/lib/docent/update.state", "What this device remembers of releases"},
                        {"/var/lib/docent/update.session",
                         "By what the web server knows this device again, which saves "
                         "certificates; a secret"},
                        {"/var/lib/docent/update.prom",
                         "What it tells of them, for node_exporter's textfile collector"}}},
              terminal::exit_codes()}};
}

int run_update(const Options& options) {
  const config::Loaded<config::KioskConfig> config = config::load_kiosk_config(options.config);
  config::tell(config.diagnostics);
  if (!config.value || !config.diagnostics.empty()) return 1;
  const Result<Settings> settings = settings_of(options, *config.value);
  if (!settings) return say(options, std::unexpected(settings.error()));
  return run_with(options, *settings);
}

}  // namespace docent::update
