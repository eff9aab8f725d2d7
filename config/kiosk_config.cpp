#include "config/kiosk_config.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <ranges>
#include <string_view>
#include <utility>
#include <vector>

#include "config/field_manual.h"
#include "config/fields.h"
#include "config/letters.h"
#include "platform/file/read_file.h"
#include "platform/terminal/suggest.h"
#include "runtime/input/key_decoder.h"
#include "runtime/input/keypad_policy.h"

namespace docent::config {

namespace {

struct KioskFile {
  Located<std::string> content, display, size, output, screen_on, theme, night, staff_pin;
  Located<std::int64_t> idle_reset, rotate, visitors, mount_height;
  Located<double> text_scale, screen_inches, same_key_delay;
  Located<bool> mirror, reduced_motion, pixel_shift;
  Located<LocatedList> keys, sides;
  Located<std::string> kiosk, source, group;
};

constexpr std::array<std::pair<std::string_view, GlassEdge>, 4> edges{
    {{"bottom", GlassEdge::Bottom},
     {"left", GlassEdge::Left},
     {"top", GlassEdge::Top},
     {"right", GlassEdge::Right}}};

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
                     "glass; where it is not said, what the screen itself says, or else 24",
                     {5, 120}},
    Field<KioskFile>{
        "mount_height",
        &KioskFile::mount_height,
        Presence::Optional,
        "Millimetres from the floor to the lower edge of the glass, as it hangs: where "
        "it is said, visitors can have all that is touched within reach of who sits, "
        "380 to 1,220 mm above the floor",
        {100, 2000}},
    Field<KioskFile>{"visitors",
                     &KioskFile::visitors,
                     Presence::Optional,
                     "How many visitors may use the glass at the same time; where it is not said "
                     "1, or 8 on a screen of 42 inches and more",
                     {1, most_visitors}},
    Field<KioskFile>{"sides", &KioskFile::sides, Presence::Optional,
                     "At which edges of a glass that several use they stand: any of \"bottom\", "
                     "\"left\", \"top\" and \"right\"; several where it lies as a table, and each "
                     "card is turned to who reads it; [\"bottom\"] where it is not said"},
    Field<KioskFile>{
        "rotate",
        &KioskFile::rotate,
        Presence::Optional,
        "Degrees by which the screen hangs turned: 0, 90, 180 or 270; 0 where it is not said; "
        "what a panel says that is built in turned comes on top",
        {0, 270}},
    Field<KioskFile>{"display", &KioskFile::display, Presence::Optional,
                     "Where to draw: auto, kms, window or headless; auto where it is not said"},
    Field<KioskFile>{"size", &KioskFile::size, Presence::Optional,
                     "Pixels: \"1920x1080\", with a refresh rate \"1920x1080@50\"; what the "
                     "display prefers where it is not said"},
    Field<KioskFile>{"output", &KioskFile::output, Presence::Optional,
                     "The socket of the screen to draw on, as in /sys/class/drm: \"HDMI-A-1\"; the "
                     "first with a screen where it is not said"},
    Field<KioskFile>{"mirror", &KioskFile::mirror, Presence::Optional,
                     "The same picture on every connected screen; false where it is not said; "
                     "the one of output decides the picture's size"},
    Field<KioskFile>{"screen_on", &KioskFile::screen_on, Presence::Optional,
                     "When the screen is lit: \"Mo-Fr 08:30-18:00; Sa,Su 10:00-19:00\", as "
                     "OpenStreetMap's opening_hours, without holidays; always where it is not "
                     "said; a touch lights it until nobody has touched it for idle_reset"},
    Field<KioskFile>{"theme", &KioskFile::theme, Presence::Optional,
                     "The colours of the screen: \"day\", dark letters on pale paper, or "
                     "\"night\", pale letters on dark paper, for rooms that are kept dark; day "
                     "where it is not said"},
    Field<KioskFile>{"night", &KioskFile::night, Presence::Optional,
                     "Hours in which the theme is night: \"Mo-Su 18:00-08:00\", written as those "
                     "of screen_on; none where it is not said"},
    Field<KioskFile>{"pixel_shift", &KioskFile::pixel_shift, Presence::Optional,
                     "Lets the picture wander by up to four pixels, one at a time and a minute "
                     "apart, against burning in; false where it is not said"},
    Field<KioskFile>{"reduced_motion", &KioskFile::reduced_motion, Presence::Optional,
                     "Nothing moves but a guide on its way: the camera cuts, cards appear at once, "
                     "nobody strolls; false where it is not said"},
    Field<KioskFile>{"same_key_delay",
                     &KioskFile::same_key_delay,
                     Presence::Optional,
                     "Seconds after a key of the keypad during which the same key does nothing, "
                     "for hands that tremble; 0 where it is not said",
                     {0, 2}},
    Field<KioskFile>{"staff_pin", &KioskFile::staff_pin, Presence::Optional,
                     "What opens the staff's screens, as docent pin prints it; where it is not "
                     "said nothing opens them"},
};

constexpr std::string_view keypad_name = "keypad";
constexpr std::array keypad_fields{
    Field<KeypadSection>{"device", &KeypadSection::device, Presence::Required,
                         "Its numbers as docent hid list tells them: \"04e7:0022\""},
    Field<KeypadSection>{"descriptor", &KeypadSection::descriptor, Presence::Optional,
                         "The number of its report descriptor, so that no other device of those "
                         "numbers is taken for it"},
    Field<KeypadSection>{
        "keys",
        &KeypadSection::keys,
        Presence::Optional,
        "What its keys mean, where they send others: keys.F23 = \"LEFT\" for each; "
        "UP, DOWN, LEFT, RIGHT, ENTER, BACK, HELP, VOLUME_UP, VOLUME_DOWN, 0 to 9 "
        "and A to Z are heeded; F1 to F24 may be sent, too, and docent hid decode "
        "tells what is",
        {},
        Form::Keys},
};

/// Takes the `[[keypad]]`s out of the file's root and reads them.
std::vector<KeypadSection> read_keypads(TomlNode& root, SectionReader& reader) {
  std::vector<KeypadSection> keypads;
  const auto entry = std::ranges::find(root.entries, keypad_name, &TomlEntry::key);
  if (entry == root.entries.end()) return keypads;
  if (entry->value.kind != TomlNode::Kind::Array)
    reader.wrong_type(entry->value, keypad_name, "written [[keypad]], once for each");
  else
    for (const TomlNode& item : entry->value.items) {
      KeypadSection& keypad = keypads.emplace_back();
      keypad.place = reader.place(item.range);
      reader.read<KeypadSection>(item, "[[keypad]]", keypad_fields, keypad);
    }
  root.entries.erase(entry);
  return keypads;
}

constexpr std::string_view sound_name = "sound";
constexpr std::array sound_fields{
    Field<SoundSection>{
        "device", &SoundSection::device, Presence::Optional,
        "The sound device that speech is heard from, as aplay -L lists them: "
        "\"plughw:1,0\"; \"none\" for silence, \"file:NAME\" for a WAV file; ALSA's "
        "own choice where it is not said"},
    Field<SoundSection>{"volume",
                        &SoundSection::volume,
                        Presence::Optional,
                        "How loud the loudest is that visitors can choose, of what the device "
                        "can; 1 where it is not said",
                        {0, 1}},
};

/// Takes `[sound]` out of the file's root and reads it.
SoundSection read_sound(TomlNode& root, SectionReader& reader) {
  SoundSection sound;
  const auto entry = std::ranges::find(root.entries, sound_name, &TomlEntry::key);
  if (entry == root.entries.end()) return sound;
  reader.read<SoundSection>(entry->value, "[sound]", sound_fields, sound);
  root.entries.erase(entry);
  return sound;
}

bool is_hexadecimal(std::string_view text) {
  return std::ranges::all_of(
      text, [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); });
}

/// A whole number of pixels, 64 to 16384; 0 where the text is none.
int parse_pixels(std::string_view text) {
  int pixels = 0;
  for (const char c : text) {
    if (c < '0' || c > '9' || text.size() > 5) return 0;
    pixels = pixels * 10 + (c - '0');
  }
  return pixels >= 64 && pixels <= 16384 ? pixels : 0;
}

/// A rate of 1 to 500 hertz; 0 where the text is none.
int parse_refresh(std::string_view text) {
  int hertz = 0;
  for (const char c : text) {
    if (c < '0' || c > '9' || text.size() > 3) return 0;
    hertz = hertz * 10 + (c - '0');
  }
  return hertz <= 500 ? hertz : 0;
}

/// Reads "1920x1080" or "1920x1080@50"; false, and nothing changed, where it is not of that form.
bool parse_size(std::string_view text, KioskConfig& config) {
  int refresh = 0;
  if (const std::size_t at = text.find('@'); at != std::string_view::npos) {
    refresh = parse_refresh(text.substr(at + 1));
    if (refresh == 0) return false;
    text = text.substr(0, at);
  }
  const std::size_t cross = text.find('x');
  if (cross == std::string_view::npos) return false;
  const int width = parse_pixels(text.substr(0, cross));
  const int height = parse_pixels(text.substr(cross + 1));
  if (width == 0 || height == 0) return false;
  config.width = width;
  config.height = height;
  config.refresh = refresh;
  return true;
}

/// The size that "1920X1080", "1920 × 1080" or "1080p" stands for; that of most screens where none
/// can be told.
std::string size_meant(std::string_view text) {
  std::string numbers;
  for (const char c : text)
    if (is_digit(c))
      numbers += c;
    else if (!numbers.empty() && is_digit(numbers.back()))
      numbers += 'x';
  KioskConfig any;
  if (parse_size(numbers, any)) return numbers;
  if (numbers.starts_with("2160")) return "3840x2160";
  if (numbers.starts_with("720")) return "1280x720";
  return "1920x1080";
}

std::string display_meant(std::string_view text, const std::vector<std::string_view>& names) {
  const std::string small = in_small_letters(std::string(text));
  if (small.starts_with("hdmi") || small.starts_with("dp") || small.starts_with("vga"))
    return fmt::format("the socket is written output = \"HDMI-A-1\"; leave display out");
  const std::string_view near = terminal::closest(small, names);
  return fmt::format("write display = \"{}\"", near.empty() ? "auto" : near);
}

/// Turns what was written into settings and says what cannot be one.
class KioskSettings {
 public:
  KioskSettings(const std::filesystem::path& file, std::vector<Diagnostic>& diagnostics)
      : file_(file), diagnostics_(diagnostics) {}

  KioskConfig from(const KioskFile& written) {
    KioskConfig config;
    if (written.content.given) config.content = file_.parent_path() / written.content.value;
    for (const Located<std::string>& key : written.keys.value)
      config.keys.push_back(file_.parent_path() / key.value);
    config.kiosk = written.kiosk.value;
    config.source = written.source.value;
    config.group = written.group.value;
    if (config.keys.size() > most_keys)
      bad_value(written.keys.value[most_keys].place, "'keys' should be at most two files",
                "keep the key of today and the one that follows it");
    if (written.idle_reset.given)
      config.idle_reset = std::chrono::seconds(written.idle_reset.value);
    if (written.text_scale.given) config.text_scale = written.text_scale.value;
    if (written.screen_inches.given) config.screen_inches = written.screen_inches.value;
    if (written.mount_height.given)
      config.mount_height = static_cast<int>(written.mount_height.value);
    if (written.visitors.given) config.visitors = static_cast<int>(written.visitors.value);
    if (written.rotate.value % 90 != 0)
      bad_value(written.rotate.place, "'rotate' should be 0, 90, 180 or 270",
                fmt::format("write rotate = {}", (written.rotate.value + 45) / 90 % 4 * 90));
    config.rotate = static_cast<int>(written.rotate.value);
    if (written.size.given && !parse_size(written.size.value, config))
      bad_value(written.size.place, "'size' should be pixels: \"1920x1080\" or \"1920x1080@50\"",
                fmt::format("write size = \"{}\"", size_meant(written.size.value)));
    for (const Located<std::string>& side : written.sides.value) add_side(side, config);
    if (written.display.given) set_display(written.display, config);
    config.output = written.output.value;
    config.mirror = written.mirror.value;
    config.reduced_motion = written.reduced_motion.value;
    config.same_key_delay = written.same_key_delay.value;
    config.pixel_shift = written.pixel_shift.value;
    if (written.screen_on.given) set_hours("screen_on", written.screen_on, config.screen_on);
    if (written.night.given) set_hours("night", written.night, config.night);
    if (written.theme.given) set_theme(written.theme, config);
    if (written.staff_pin.given) set_staff_pin(written.staff_pin, config);
    return config;
  }

  void check(const KeypadSection& keypad) {
    const std::string& id = keypad.device.value;
    if (keypad.device.given && (id.size() != 9 || id[4] != ':' ||
                                !is_hexadecimal(id.substr(0, 4)) || !is_hexadecimal(id.substr(5))))
      bad_value(keypad.device.place,
                "'device' should be two numbers as docent hid list tells them: \"04e7:0022\"",
                in_small_letters(id) != id && input::device_id_from(in_small_letters(id))
                    ? fmt::format("write device = \"{}\", in small letters", in_small_letters(id))
                    : "four figures, a colon, four figures: run docent hid list and copy them");
    const std::string& hash = keypad.descriptor.value;
    if (keypad.descriptor.given && (hash.size() != 16 || !is_hexadecimal(hash)))
      bad_value(keypad.descriptor.place,
                "'descriptor' should be the sixteen figures that docent hid list tells",
                "run docent hid list and copy them, or leave the line out");
    for (const auto& [sent, meant] : keypad.keys.value) check_key(sent, meant);
  }

 private:
  void check_key(const std::string& sent, const Located<std::string>& meant) {
    constexpr std::string_view hint =
        "docent hid decode tells what each key sends: UP, ENTER, A, 7, F13, ...";
    if (input::key_from_string(sent).key == input::Key::None)
      bad_value({meant.place.file, meant.key}, fmt::format("'{}' is no key's name", sent),
                std::string(hint));
    const input::Key key = input::key_from_string(meant.value).key;
    if (meant.given && (key == input::Key::None || key == input::Key::Function))
      bad_value(meant.place, fmt::format("'{}' is no key that a kiosk heeds", meant.value),
                "write UP, DOWN, LEFT, RIGHT, ENTER, BACK, HELP, VOLUME_UP, VOLUME_DOWN, a figure "
                "or a letter");
  }
  void add_side(const Located<std::string>& written, KioskConfig& config) {
    const auto names = edges | std::views::keys;
    const auto at = std::ranges::find(names, written.value);
    if (at == names.end()) {
      const std::string_view near = terminal::closest(in_small_letters(std::string(written.value)),
                                                      {names.begin(), names.end()});
      return bad_value(written.place,
                       fmt::format("'sides' should be some of {}", fmt::join(names, ", ")),
                       near.empty() ? "write sides = [\"bottom\", \"top\"] for two long sides"
                                    : fmt::format("write \"{}\"", near));
    }
    const GlassEdge edge = edges[static_cast<std::size_t>(at - names.begin())].second;
    if (std::ranges::find(config.sides, edge) == config.sides.end()) config.sides.push_back(edge);
  }

  void set_display(const Located<std::string>& written, KioskConfig& config) {
    const auto names = display_kinds | std::views::keys;
    const auto at = std::ranges::find(names, written.value);
    if (at == names.end())
      return bad_value(written.place,
                       fmt::format("'display' should be one of {}", fmt::join(names, ", ")),
                       display_meant(written.value, {names.begin(), names.end()}));
    config.display = display_kinds[static_cast<std::size_t>(at - names.begin())].second;
  }

  void set_staff_pin(const Located<std::string>& written, KioskConfig& config) {
    constexpr std::string_view argon2 = "$argon2id$";
    if (!written.value.starts_with(argon2))
      return bad_value(written.place, "'staff_pin' should be what docent pin prints, no PIN itself",
                       "run docent pin, type the PIN, and copy the line that it prints");
    config.staff_pin = written.value;
  }

  void set_theme(const Located<std::string>& written, KioskConfig& config) {
    config.is_night = written.value == "night";
    if (!config.is_night && written.value != "day")
      bad_value(written.place, "'theme' should be day or night",
                "write theme = \"night\" for light letters on dark paper");
  }

  void set_hours(std::string_view key, const Located<std::string>& written,
                 std::optional<WeeklyHours>& into) {
    auto hours = parse_weekly_hours(written.value);
    if (!hours)
      return bad_value(written.place, fmt::format("'{}': {}", key, hours.error()),
                       "weekdays are Mo, Tu, We, Th, Fr, Sa, Su, and times are written 09:30");
    into = std::move(*hours);
  }

  void bad_value(const Place& place, std::string message, std::string hint) {
    Diagnostic diagnostic;
    diagnostic.file = file_.string();
    diagnostic.line = place.range.line;
    diagnostic.column = place.range.column;
    diagnostic.length = place.range.length;
    diagnostic.code = "bad-value";
    diagnostic.message = std::move(message);
    diagnostic.hint = std::move(hint);
    diagnostics_.push_back(std::move(diagnostic));
  }

  const std::filesystem::path& file_;
  std::vector<Diagnostic>& diagnostics_;
};

}  // namespace

double screen_inches(const KioskConfig& config, std::optional<double> said_by_screen) noexcept {
  constexpr double usual = 24;
  return config.screen_inches.value_or(said_by_screen.value_or(usual));
}

int visitors(const KioskConfig& config, double inches) noexcept {
  return config.visitors.value_or(inches >= shared_from_inches ? most_visitors : 1);
}

Loaded<KioskConfig> load_kiosk_config(const std::filesystem::path& file) {
  if (!file::is_there(file)) return {.value = KioskConfig{}, .diagnostics = {}};
  TomlFile toml = read_toml(file, file.string());
  if (!toml.root) return {.value = std::nullopt, .diagnostics = std::move(toml.diagnostics)};
  KioskFile written;
  SectionReader reader(FileIndex{}, file.string(), toml.diagnostics);
  std::vector<KeypadSection> keypads = read_keypads(*toml.root, reader);
  const SoundSection sound = read_sound(*toml.root, reader);
  reader.read<KioskFile>(*toml.root, file.filename().string(), kiosk_file_fields, written);
  KioskSettings settings(file, toml.diagnostics);
  KioskConfig config = settings.from(written);
  for (const KeypadSection& keypad : keypads) settings.check(keypad);
  config.keypads = std::move(keypads);
  if (sound.device.given) config.sound_device = sound.device.value;
  if (sound.volume.given) config.sound_volume = sound.volume.value;
  return {.value = config, .diagnostics = std::move(toml.diagnostics)};
}

std::vector<SectionManual> kiosk_manual() {
  return {{.heading = {}, .manual = {}, .fields = manual_of<KioskFile>(kiosk_file_fields)},
          {.heading = "[[keypad]]",
           .manual = "A keypad for visitors, once for each; where there is none, every keypad that "
                     "cannot write all letters is listened to",
           .fields = manual_of<KeypadSection>(keypad_fields)},
          {.heading = "[sound]",
           .manual = "How the kiosk is heard by those who do not see it",
           .fields = manual_of<SoundSection>(sound_fields)}};
}

}  // namespace docent::config
