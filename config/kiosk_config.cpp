#include "config/kiosk_config.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <ranges>
#include <string_view>

#include "config/field_manual.h"
#include "config/fields.h"
#include "platform/file/read_file.h"

namespace docent::config {

namespace {

struct KioskFile {
  Located<std::string> content, display, size;
  Located<std::int64_t> idle_reset, rotate, visitors;
  Located<double> text_scale, screen_inches;
  Located<std::vector<std::string>> keys;
  Located<std::string> kiosk, source, group;
};

constexpr double shared_from_inches = 42;
constexpr int most_visitors = 8;
constexpr std::size_t most_keys = 2;  // the one of today, and the one that follows it

constexpr std::array kiosk_file_fields{
    Field<KioskFile>{"content",
                     &KioskFile::content,
                     Presence::Optional,
                     "The compiled museum, relative to this file; /var/lib/docent/museum.db where "
                     "it is not said",
                     {},
                     Form::File},
    Field<KioskFile>{"keys", &KioskFile::keys, Presence::Optional,
                     "Public keys, files relative to this one, at most two: only databases signed "
                     "with one of them are shown; any database where it is not said"},
    Field<KioskFile>{"kiosk",
                     &KioskFile::kiosk,
                     Presence::Optional,
                     "Which of the museum's kiosks this one is, where museum.toml has several; the "
                     "first where it is not said",
                     {},
                     Form::Identifier},
    Field<KioskFile>{"source", &KioskFile::source, Presence::Optional,
                     "Where docent-update finds releases: an https address or a folder"},
    Field<KioskFile>{"group",
                     &KioskFile::group,
                     Presence::Optional,
                     "The group of kiosks that this one is in, for releases that are for some "
                     "groups only",
                     {},
                     Form::Identifier},
    Field<KioskFile>{
        "idle_reset",
        &KioskFile::idle_reset,
        Presence::Optional,
        "Seconds without a touch until the welcome screen returns; 60 where it is not said",
        {10, 600}},
    Field<KioskFile>{"text_scale",
                     &KioskFile::text_scale,
                     Presence::Optional,
                     "How much larger letters are, for every visitor; 1 where it is not said",
                     {1, 2}},
    Field<KioskFile>{"screen_inches",
                     &KioskFile::screen_inches,
                     Presence::Optional,
                     "The screen's diagonal in inches, so that letters have their size on the "
                     "glass; 24 where it is not said",
                     {5, 120}},
    Field<KioskFile>{"visitors",
                     &KioskFile::visitors,
                     Presence::Optional,
                     "How many visitors may use the glass at the same time; where it is not said "
                     "1, or 8 on a screen of 42 inches and more",
                     {1, most_visitors}},
    Field<KioskFile>{
        "rotate",
        &KioskFile::rotate,
        Presence::Optional,
        "Degrees by which the screen hangs turned: 0, 90, 180 or 270; 0 where it is not said",
        {0, 270}},
    Field<KioskFile>{"display", &KioskFile::display, Presence::Optional,
                     "Where to draw: auto, kms, window or headless; auto where it is not said"},
    Field<KioskFile>{"size", &KioskFile::size, Presence::Optional,
                     "Pixels: \"1920x1080\"; what the display prefers where it is not said"},
};

/// A whole number of pixels, 64 to 16384; 0 where the text is none.
int parse_pixels(std::string_view text) {
  int pixels = 0;
  for (const char c : text) {
    if (c < '0' || c > '9' || text.size() > 5) return 0;
    pixels = pixels * 10 + (c - '0');
  }
  return pixels >= 64 && pixels <= 16384 ? pixels : 0;
}

/// Reads "1920x1080"; false, and nothing changed, where it is not of that form.
bool parse_size(std::string_view text, KioskConfig& config) {
  const std::size_t cross = text.find('x');
  if (cross == std::string_view::npos) return false;
  const int width = parse_pixels(text.substr(0, cross));
  const int height = parse_pixels(text.substr(cross + 1));
  if (width == 0 || height == 0) return false;
  config.width = width;
  config.height = height;
  return true;
}

/// Turns what was written into settings and says what cannot be one.
class KioskSettings {
 public:
  KioskSettings(const std::filesystem::path& file, std::vector<Diagnostic>& diagnostics)
      : file_(file), diagnostics_(diagnostics) {}

  KioskConfig from(const KioskFile& written) {
    KioskConfig config;
    if (written.content.given) config.content = file_.parent_path() / written.content.value;
    for (const std::string& key : written.keys.value)
      config.keys.push_back(file_.parent_path() / key);
    config.kiosk = written.kiosk.value;
    config.source = written.source.value;
    config.group = written.group.value;
    if (config.keys.size() > most_keys)
      bad_value(written.keys.place, "'keys' should be at most two files");
    if (written.idle_reset.given)
      config.idle_reset = std::chrono::seconds(written.idle_reset.value);
    if (written.text_scale.given) config.text_scale = written.text_scale.value;
    if (written.screen_inches.given) config.screen_inches = written.screen_inches.value;
    config.visitors = config.screen_inches >= shared_from_inches ? most_visitors : 1;
    if (written.visitors.given) config.visitors = static_cast<int>(written.visitors.value);
    if (written.rotate.value % 90 != 0)
      bad_value(written.rotate.place, "'rotate' should be 0, 90, 180 or 270");
    config.rotate = static_cast<int>(written.rotate.value);
    if (written.size.given && !parse_size(written.size.value, config))
      bad_value(written.size.place, "'size' should be pixels: \"1920x1080\"");
    if (written.display.given) set_display(written.display, config);
    return config;
  }

 private:
  void set_display(const Located<std::string>& written, KioskConfig& config) {
    const auto names = display_kinds | std::views::keys;
    const auto at = std::ranges::find(names, written.value);
    if (at == names.end())
      return bad_value(written.place,
                       fmt::format("'display' should be one of {}", fmt::join(names, ", ")));
    config.display = display_kinds[static_cast<std::size_t>(at - names.begin())].second;
  }

  void bad_value(const Place& place, std::string message) {
    Diagnostic diagnostic;
    diagnostic.file = file_.string();
    diagnostic.line = place.range.line;
    diagnostic.column = place.range.column;
    diagnostic.length = place.range.length;
    diagnostic.code = "bad-value";
    diagnostic.message = std::move(message);
    diagnostics_.push_back(std::move(diagnostic));
  }

  const std::filesystem::path& file_;
  std::vector<Diagnostic>& diagnostics_;
};

}  // namespace

Loaded<KioskConfig> load_kiosk_config(const std::filesystem::path& file) {
  if (!file::is_there(file)) return {.value = KioskConfig{}, .diagnostics = {}};
  TomlFile toml = read_toml(file, file.string());
  if (!toml.root) return {.value = std::nullopt, .diagnostics = std::move(toml.diagnostics)};
  KioskFile written;
  SectionReader reader(FileIndex{}, file.string(), toml.diagnostics);
  reader.read<KioskFile>(*toml.root, file.filename().string(), kiosk_file_fields, written);
  const KioskConfig config = KioskSettings(file, toml.diagnostics).from(written);
  return {.value = config, .diagnostics = std::move(toml.diagnostics)};
}

std::vector<SectionManual> kiosk_manual() {
  return {{.heading = {}, .manual = {}, .fields = manual_of<KioskFile>(kiosk_file_fields)}};
}

}  // namespace docent::config
