#include "runtime/kiosk/options.h"

#include <CLI/CLI.hpp>
#include <charconv>
#include <string_view>

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

}  // namespace

DisplayKind display_named(std::string_view name) noexcept {
  if (name == "kms") return DisplayKind::Kms;
  if (name == "window") return DisplayKind::Window;
  return name == "headless" ? DisplayKind::Headless : DisplayKind::Auto;
}

CommandLine parse_command_line(int argc, const char* const* argv) {
  CommandLine line;
  Options& options = line.options;
  std::filesystem::path content;
  std::string size;
  std::string display;
  int rotate = 0;
  double seconds = 0;

  CLI::App app("docent: the museum's guide. A visitor touches an exhibit, and it walks there.",
               "docent");
  app.set_version_flag("--version", "docent 0.1.0");
  auto* content_option = app.add_option("--content", content, "The compiled museum (museum.db)");
  auto* config_option = app.add_option("--config", options.config, "This device's settings");
  auto* display_option = app.add_option("--display", display, "Where to draw")
                             ->check(CLI::IsMember({"auto", "kms", "window", "headless"}))
                             ->option_text("auto|kms|window|headless");
  auto* size_option =
      app.add_option("--size", size, "Pixels, such as 1920x1080")
          ->option_text("WxH")
          ->check([](const std::string& text) {
            return parse_size(text) ? std::string() : "'" + text + "' is not a size like 1920x1080";
          });
  auto* rotate_option = app.add_option("--rotate", rotate, "How far the screen hangs turned")
                            ->check(CLI::IsMember({0, 90, 180, 270}))
                            ->option_text("0|90|180|270");
  app.add_option("--visit", options.visit, "Play a scripted visit")->option_text("FILE");
  app.add_option("--record", options.record, "Write frames and states.csv there")
      ->option_text("DIR");
  auto* seconds_option = app.add_option("--seconds", seconds, "End after so many seconds")
                             ->check(CLI::NonNegativeNumber)
                             ->option_text("S");
  app.add_option("--stats", options.stats, "Write measurements as JSON at exit")
      ->option_text("FILE");
  app.add_option("--hid", options.hid, "A hidraw device to use; repeat for more")
      ->option_text("PATH");
  app.footer(
      "docent hid list [--json]       the touch screens and keypads present\n"
      "docent hid decode FILE.hid     what a recorded device said, as CSV");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    constexpr int wrong_usage = 2;
    line.exit = app.exit(error) == 0 ? 0 : wrong_usage;
    return line;
  }
  options.config_given = config_option->count() > 0;
  if (content_option->count() > 0) options.content = content;
  if (display_option->count() > 0) options.display = display_named(display);
  if (size_option->count() > 0) options.size = parse_size(size);
  if (rotate_option->count() > 0) options.rotation = static_cast<Rotation>(rotate / 90);
  if (seconds_option->count() > 0) options.seconds = seconds;
  return line;
}

}  // namespace docent::kiosk
