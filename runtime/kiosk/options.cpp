#include "runtime/kiosk/options.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string_view>
#include <utility>

#include "platform/journal/journal.h"
#include "runtime/kiosk/check_command.h"
#include "runtime/kiosk/counts_command.h"
#include "runtime/kiosk/hid_command.h"
#include "runtime/kiosk/pin_command.h"
#include "runtime/kiosk/status_command.h"

namespace docent::kiosk {
namespace {

std::optional<PixelSize> parse_size(const std::string& text) {
  PixelSize size;
  const char* const end = text.data() + text.size();
  const auto [cross, bad_width] = std::from_chars(text.data(), end, size.width);
  if (bad_width != std::errc{} || cross == end || *cross != 'x') return std::nullopt;
  const auto [rest, bad_height] = std::from_chars(cross + 1, end, size.height);
  if (bad_height != std::errc{} || rest != end) return std::nullopt;
  constexpr std::uint32_t least = 64, most = 16384;
  const bool fits =
      std::min(size.width, size.height) >= least && std::max(size.width, size.height) <= most;
  return fits ? std::optional(size) : std::nullopt;
}

terminal::Value size_value(std::optional<PixelSize>& size) {
  return {.name = "WxH", .take = [&size](terminal::Words words) {
            size = parse_size(words.back());
            return size ? std::string() : "'" + words.back() + "' is not a size like 1920x1080";
          }};
}

std::vector<terminal::Option> options_of(Options& options) {
  using terminal::Times;
  return {
      {"--content", terminal::file("DB", options.content), "The compiled museum", Times::AtMostOnce,
       "what kiosk.toml says, else /var/lib/docent/museum.db"},
      {"--config", terminal::file("FILE", options.config), "This device's settings",
       Times::AtMostOnce, default_config},
      {"--display",
       terminal::one_of<config::DisplayKind>(
           {config::display_kinds.begin(), config::display_kinds.end()}, options.display),
       "Where to draw; auto takes KMS on a free console, a window where there is a desktop, else "
       "headless",
       Times::AtMostOnce, "what kiosk.toml says, else auto"},
      {"--size", size_value(options.size), "Pixels, such as 1920x1080", Times::AtMostOnce,
       "what kiosk.toml says, else what the display prefers"},
      {"--rotate",
       terminal::one_of<Rotation>({{"0", static_cast<Rotation>(0)},
                                   {"90", static_cast<Rotation>(1)},
                                   {"180", static_cast<Rotation>(2)},
                                   {"270", static_cast<Rotation>(3)}},
                                  options.rotation),
       "Degrees by which the screen hangs turned", Times::AtMostOnce,
       "what kiosk.toml says, else 0"},
      {"--today", terminal::file("FILE", options.today),
       "What is closed just now; taken up within a second of its being replaced", Times::AtMostOnce,
       "today.toml beside the database"},
      {"--visit", terminal::file("FILE", options.visit), "Play a scripted visit"},
      {"--record", terminal::folder("DIR", options.record),
       "Write frames as PNG and states.csv into this folder"},
      {"--states", terminal::file("FILE", options.states),
       "Write the states.csv of a recording alone, without drawing every frame"},
      {"--seconds", terminal::number("S", terminal::not_negative, options.seconds),
       "End after so many seconds"},
      {"--stats", terminal::file("FILE", options.stats), "Write measurements as JSON at the end"},
      {"--speech", terminal::file("FILE", options.speech),
       "Write at the end all that was spoken, as CSV: time, control, language, text"},
      {"--health", terminal::file("FILE", options.health),
       "Write every 15 seconds how the kiosk is doing, as node_exporter's textfile collector reads "
       "it"},
      {"--counts", terminal::folder("DIR", options.counts),
       "Keep anonymous counts of visits in this folder, a file for each day that is over; what has "
       "fewer than 5 visits is left out"},
      {"--hid", terminal::file("PATH", options.hid),
       "A hidraw device to use, instead of all touch screens and keypads", Times::AnyNumber},
  };
}

terminal::Section files() {
  return {.title = "files",
          .rows = {{"/etc/docent/kiosk.toml",
                    "This device's settings; without it those of a new device hold"},
                   {"/var/lib/docent/museum.db", "The compiled museum"},
                   {"/run/docent/docent.prom", "How the kiosk is doing, where the service runs it"},
                   {"/var/lib/docent-counts", "Anonymous counts by day, likewise"}}};
}

terminal::Section signals() {
  return {.title = "signals",
          .rows = {{"SIGTERM, SIGINT", "End cleanly within a second"},
                   {"SIGHUP",
                    "Take up a new database as soon as nobody is being guided, and after five "
                    "minutes in any case"}}};
}

terminal::Section exit_codes() {
  terminal::Section codes = terminal::exit_codes();
  codes.rows.emplace_back("42", "Staff ended it on its glass: it is not started again by itself");
  return codes;
}

}  // namespace

terminal::Command program(Options& options, std::function<int()> run) {
  return {.name = "docent",
          .manual = "the museum's guide: a visitor touches an exhibit, and it walks there",
          .options = options_of(options),
          .run = std::move(run),
          .commands = {check_command(), counts_command(), hid_command(), pin_command(),
                       status_command()},
          .sections = {files(), signals(), exit_codes()}};
}

int say(const Error& error, journal::Message message) {
  journal::tell(message, error.what);
  return exit_code(error.code);
}

}  // namespace docent::kiosk
