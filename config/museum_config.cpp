#include "config/museum_config.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <string_view>
#include <system_error>

#include "config/exhibit_media.h"
#include "config/language_tag.h"
#include "config/letters.h"
#include "config/museum_cases.h"
#include "config/museum_fields.h"
#include "config/museum_hours.h"
#include "config/museum_path.h"
#include "config/text_faults.h"
#include "config/toml_folder.h"
#include "platform/file/read_file.h"
#include "platform/terminal/suggest.h"
#include "runtime/model/exhibit/longer_text.h"

namespace docent::config {

namespace {

namespace fs = std::filesystem;

/// Reads the sections of one file's root table, and says which tables it should not hold.
class SectionVisitor {
 public:
  SectionVisitor(const TomlNode& root, SectionReader& reader) : root_(root), reader_(reader) {}

  template <typename T, std::size_t n>
  void one(std::string_view name, std::string_view /*manual*/,
           const std::array<Field<T>, n>& fields, T& section) {
    known_.push_back(name);
    if (const TomlNode* node = find(name))
      reader_.read<T>(*node, fmt::format("[{}]", name), fields, section);
  }

  template <typename T, std::size_t n>
  void many(std::string_view name, std::string_view /*manual*/,
            const std::array<Field<T>, n>& fields, std::vector<T>& sections) {
    known_.push_back(name);
    const TomlNode* node = find(name);
    if (node == nullptr) return;
    if (node->kind != TomlNode::Kind::Array) {
      reader_.wrong_type(*node, name, fmt::format("written [[{}]], once for each", name));
      return;
    }
    for (const TomlNode& item : node->items) {
      T& section = sections.emplace_back();
      section.place = reader_.place(item.range);
      reader_.read<T>(item, fmt::format("[[{}]]", name), fields, section);
    }
  }

  template <typename T, std::size_t n>
  void one_or_many(std::string_view name, std::string_view manual,
                   const std::array<Field<T>, n>& fields, std::vector<T>& sections) {
    const TomlNode* node = find(name);
    if (node != nullptr && node->kind == TomlNode::Kind::Array)
      return many(name, manual, fields, sections);
    known_.push_back(name);
    if (node == nullptr) return;
    T& section = sections.emplace_back();
    section.place = reader_.place(node->range);
    reader_.read<T>(*node, fmt::format("[{}]", name), fields, section);
  }

  void report_unknown(std::string_view file) {
    for (const TomlEntry& entry : root_.entries)
      if (std::ranges::find(known_, entry.key) == known_.end())
        reader_.unknown_key(entry, file, known_);
  }

 private:
  const TomlNode* find(std::string_view name) const {
    const auto entry = std::ranges::find(root_.entries, name, &TomlEntry::key);
    return entry == root_.entries.end() ? nullptr : &entry->value;
  }

  const TomlNode& root_;
  SectionReader& reader_;
  std::vector<std::string_view> known_;
};

class MuseumLoader {
 public:
  explicit MuseumLoader(const fs::path& folder) : paths_(folder) { config_.folder = folder; }

  Loaded<MuseumConfig> load() && {
    const bool readable =
        read(config_.folder / "museum.toml", [&](auto& visit) { museum_sections(visit, config_); });
    if (!readable) return {.value = std::nullopt, .diagnostics = std::move(diagnostics_)};
    if (!config_.kiosks.empty()) config_.kiosk = config_.kiosks.front();
    read_exhibits();
    add(stray_toml_files(config_.folder));
    const std::vector<fs::path> words = toml_files("words");
    find_languages();
    check_languages();
    read_words(words);
    for (CaseSection& stand : config_.cases) check_floor(stand.floor, stand.position);
    stand_in_cases(config_, diagnostics_);
    if (config_.sources.empty())
      for (const ExhibitSection& exhibit : config_.exhibits)
        for (Diagnostic& missing : missing_fields(config_, exhibit))
          diagnostics_.push_back(std::move(missing));
    check_references();
    check_files();
    read_exhibit_media(config_, paths_, diagnostics_);
    check_translations();
    sort_diagnostics();
    return {.value = std::move(config_), .diagnostics = std::move(diagnostics_)};
  }

 private:
  void read_exhibits() {
    for (const fs::path& file : without_copies(toml_files("exhibits"))) {
      const std::size_t before = config_.exhibits.size();
      if (!read(file, [&](auto& visit) { exhibit_sections(visit, config_); }))
        unread_exhibits_.push_back(file);
      else if (config_.exhibits.size() == before)
        about_file(file, "empty-file", "holds no exhibit",
                   "write a [[exhibit]] into it, or remove it");
    }
    if (config_.exhibits.empty() && config_.sources.empty() && !has_errors()) {
      about_file(config_.folder / "exhibits", "no-exhibits", "there are no exhibits",
                 "write a [[exhibit]] into a file of this folder: exhibits/NAME.toml");
      const bool are_wanted = std::ranges::any_of(
          config_.tours, [](const TourSection& tour) { return !tour.exhibits.value.empty(); });
      if (are_wanted) diagnostics_.back().severity = Severity::Error;
    }
  }

  /// Copies of files, as file managers make them, are told and not read: of the same bytes the one
  /// of the shortest name is read.
  std::vector<fs::path> without_copies(std::vector<fs::path> files) {
    std::map<std::string, fs::path> first;
    std::vector<fs::path> by_length = files;
    std::ranges::stable_sort(by_length, {},
                             [](const fs::path& file) { return file.string().size(); });
    for (const fs::path& file : by_length) {
      Result<std::string> text = file::read_file(file, largest_toml);
      if (!text || text->empty()) continue;
      const auto [same, is_new] = first.emplace(std::move(*text), file);
      if (is_new) continue;
      about_file(file, "duplicate-file",
                 fmt::format("holds the same as {}", same->second.filename().string()),
                 "remove one of them");
      diagnostics_.back().severity = Severity::Error;
      diagnostics_.back().line = diagnostics_.back().column = 1;
      std::erase(files, file);
    }
    return files;
  }

  void add(std::vector<Diagnostic> diagnostics) {
    std::ranges::move(diagnostics, std::back_inserter(diagnostics_));
  }

  bool has_errors() const {
    return std::ranges::any_of(diagnostics_,
                               [](const Diagnostic& d) { return d.severity == Severity::Error; });
  }

  void about_file(const fs::path& file, std::string code, std::string message, std::string hint) {
    diagnostics_.push_back({.file = file.string(),
                            .severity = Severity::Warning,
                            .code = std::move(code),
                            .message = std::move(message),
                            .hint = std::move(hint)});
  }

  /// The files of one of the museum's folders that end in .toml, in the order of their names.
  std::vector<fs::path> toml_files(const std::string& name) {
    TomlFolder folder = list_toml_files(config_.folder, name, paths_);
    for (const Diagnostic& diagnostic : folder.diagnostics)
      if (name == "exhibits") unread_exhibits_.emplace_back(diagnostic.file);
    add(std::move(folder.diagnostics));
    return std::move(folder.files);
  }

  FileIndex add_file(const fs::path& file) {
    config_.files.push_back(file.string());
    return static_cast<FileIndex>(config_.files.size() - 1);
  }

  bool read(const fs::path& file, auto&& sections) {
    const FileIndex index = add_file(file);
    if (!may_be_read(file)) return false;
    TomlFile toml = read_toml(file, file.string());
    add(std::move(toml.diagnostics));
    if (!toml.root) return false;
    SectionReader reader(index, file.string(), diagnostics_);
    SectionVisitor visitor(*toml.root, reader);
    sections(visitor);
    visitor.report_unknown(file.filename().string());
    return true;
  }

  /// A file that is no file of the museum's folder is told, and nobody opens it.
  bool may_be_read(const fs::path& file) {
    const std::string name = file.lexically_relative(config_.folder).string();
    auto fault = paths_.fault(name, Wanted::Text);
    if (!fault) return true;
    if (const std::string nested = paths_.elsewhere(name);
        fault->code == "missing-file" && nested.find('/') != std::string::npos)
      fault->hint = fmt::format("name the folder in which there is one: {}",
                                (config_.folder / nested).parent_path().string());
    else if (fault->hint.starts_with("it is looked for"))
      fault->hint += ": name the museum's folder, in which museum.toml lies";
    diagnostics_.push_back({.file = file.string(),
                            .code = std::move(fault->code),
                            .message = std::move(fault->message),
                            .hint = std::move(fault->hint)});
    return false;
  }

  void error(const Place& place, std::string code, std::string message, std::string label = {},
             std::string hint = {}) {
    diagnostics_.push_back(diagnostic_at(config_, place, std::move(code), std::move(message),
                                         std::move(label), std::move(hint)));
  }

  void warning(const Place& place, std::string code, std::string message, std::string hint) {
    error(place, std::move(code), std::move(message), {}, std::move(hint));
    diagnostics_.back().severity = Severity::Warning;
  }

  /// The languages that were asked for, else those in which anything is written.
  void find_languages() {
    for (const Located<std::string>& tag : config_.museum.languages.value)
      config_.languages.push_back(tag.value);
    if (!config_.languages.empty()) return;
    std::set<std::string> used = used_tags();
    if (used.erase("en") > 0 || used.empty()) config_.languages.emplace_back("en");
    config_.languages.insert(config_.languages.end(), used.begin(), used.end());
  }

  /// The languages of the titles, as they are written.
  std::set<std::string> used_tags() const {
    std::set<std::string> used;
    const auto note = [&](const Located<LocatedTexts>& texts) {
      for (const auto& [tag, text] : texts.value) used.insert(tag);
    };
    note(config_.museum.title);
    for (const ExhibitSection& exhibit : config_.exhibits) note(exhibit.title);
    return used;
  }

  void read_words(const std::vector<fs::path>& files) {
    for (const fs::path& file : files) {
      const std::string tag = file.stem().string();
      if (std::ranges::find(config_.languages, tag) == config_.languages.end())
        about_file(file, "not-read",
                   fmt::format("is not read: the museum does not speak '{}'", tag),
                   words_hint(tag));
    }
    for (const std::string& tag : config_.languages) {
      const fs::path file = config_.folder / "words" / (tag + ".toml");
      if (std::ranges::find(files, file) == files.end()) continue;
      Loaded<WordsFile> words = load_words(file, tag);
      add(std::move(words.diagnostics));
      const FileIndex index = add_file(file);
      if (!words.value) continue;
      for (Place* place :
           {&words.value->words.place, &words.value->name.place, &words.value->direction.place})
        place->file = index;
      for (auto& [key, word] : words.value->words.value) word.place.file = index;
      config_.words.push_back(std::move(*words.value));
    }
  }

  /// What may be meant by a file of words that no language of the museum has.
  std::string words_hint(const std::string& tag) const {
    const std::string meant = is_language_tag(tag) ? "" : meant_language(tag);
    if (std::ranges::find(config_.languages, meant) != config_.languages.end())
      return fmt::format("call it {}.toml", meant);
    if (is_language_tag(tag))
      return fmt::format(
          "write languages = [..., \"{}\"] in museum.toml, or move the file elsewhere", tag);
    return fmt::format("the languages are: {}", fmt::join(config_.languages, ", "));
  }

  void check_references() {
    if (config_.floors.empty())
      error({FileIndex{}, {}}, "missing-field", "museum.toml lacks a [[floor]]", {},
            "[[floor]] with a name and a plan, a GeoJSON file");
    check_unique("floor", "name", config_.floors, &FloorSection::name);
    check_unique("room", "id", config_.rooms, &RoomSection::id);
    check_unique("exhibit", "id", config_.exhibits, &ExhibitSection::id);
    check_unique("case", "id", config_.cases, &CaseSection::id);
    check_unique("connection", "id", config_.connections, &ConnectionSection::id);
    check_unique("place", "id", config_.places, &PlaceSection::id);
    check_unique("way", "kind", config_.ways, &WaySection::kind);
    check_floors();
    check_kiosks();
    for (PlaceSection& place : config_.places) check_floor(place.floor, place.position);
    for (RoomSection& room : config_.rooms) {
      check_floor(room.floor, room.outline);
      if (!room.outline.given) room.outline.value.clear();
    }
    for (DoorSection& door : config_.doors) check_door(door);
    check_unique("door", "name", config_.doors, &DoorSection::called);
    check_hours(config_, diagnostics_);
    for (ExhibitSection& exhibit : config_.exhibits) check_floor(exhibit.floor, exhibit.position);
    for (ConnectionSection& connection : config_.connections) check_stops(connection);
    check_unique("tour", "id", config_.tours, &TourSection::id);
    for (const TourSection& tour : config_.tours) check_tour(tour);
    if (config_.sources.empty()) check_exhibits_of_tours();
    for (const SpeechSection& speech : config_.speech)
      if (!speech.recording.given && !speech.reading.given)
        error(speech.place, "missing-field", "[[speech]] has neither a recording nor a reading", {},
              "recording = \"speech/FILE.opus\", or reading = what the voice is to read");
  }

  /// Floors stand over one another as their ordinals say.
  void check_floors() {
    if (config_.floors.size() < 2) return;
    for (std::size_t i = 0; i < config_.floors.size(); ++i) {
      const FloorSection& floor = config_.floors[i];
      if (!floor.title.given && !floor.short_name.given &&
          floor.title.place.range == floor.place.range)
        warning(floor.place, "no-title",
                fmt::format("floor '{}' has no title, and visitors see a number", floor.name.value),
                fmt::format("write title.{} = \"...\", and short = \"...\" for the lift's button",
                            config_.languages.front()));
      for (std::size_t j = 0; j < i; ++j) check_pair(config_.floors[j], floor);
    }
  }

  void check_pair(const FloorSection& first, const FloorSection& second) {
    if (first.plan.given && second.plan.given && first.plan.value == second.plan.value)
      warning(second.plan.place, "same-plan",
              fmt::format("floors '{}' and '{}' have the same plan", first.name.value,
                          second.name.value),
              "give each floor the plan of its own storey");
    if (!first.ordinal.given || !second.ordinal.given || !first.height.given ||
        !second.height.given)
      return;
    constexpr double one_storey = 2;  // metres: half-floors are less apart
    const double higher = second.height.value - first.height.value;
    const auto above = second.ordinal.value - first.ordinal.value;
    const bool turned = above != 0 && higher * static_cast<double>(above) <= 0;
    if (turned || (above == 0 && std::abs(higher) >= one_storey))
      warning(second.ordinal.place, "odd-storey",
              fmt::format("floor '{}' is {} by its ordinal and {:g} m {} by its height",
                          second.name.value, storeys(above, first.name.value), std::abs(higher),
                          higher > 0 ? "above it" : "below it"),
              "ordinal counts storeys from 0 on the ground; height is in metres");
  }

  static std::string storeys(std::int64_t above, const std::string& floor) {
    if (above == 0) return fmt::format("the same storey as '{}'", floor);
    return fmt::format("{} storey{} {} '{}'", std::abs(above), std::abs(above) == 1 ? "" : "s",
                       above > 0 ? "above" : "below", floor);
  }

  void check_tour(const TourSection& tour) {
    const Located<LocatedList>& exhibits = tour.exhibits;
    if (exhibits.value.empty() && !tour.minutes.given)
      return error(exhibits.given ? exhibits.place : tour.place, "missing-field",
                   fmt::format("tour '{}' has neither exhibits nor minutes", tour.id.value), {},
                   "exhibits = [\"...\", \"...\"], or minutes = 30 for the best in that time");
    std::set<std::string_view> seen;
    for (const Located<std::string>& id : exhibits.value)
      if (!seen.insert(id.value).second)
        error(id.place, "bad-value",
              fmt::format("tour '{}' names exhibit '{}' twice", tour.id.value, id.value), {},
              "a tour visits each exhibit once: take one of them out");
  }

  /// A file of exhibits that cannot be read is told once, and not again for each tour.
  void check_exhibits_of_tours() {
    const bool may_be_unread = std::ranges::any_of(diagnostics_, [&](const Diagnostic& d) {
      return d.severity == Severity::Error &&
             std::ranges::find(unread_exhibits_, fs::path(d.file)) != unread_exhibits_.end();
    });
    const bool lacks_an_id = std::ranges::any_of(
        config_.exhibits, [](const ExhibitSection& exhibit) { return !exhibit.id.given; });
    if (may_be_unread || lacks_an_id || config_.exhibits.empty()) return;
    std::vector<Diagnostic> unknown = unknown_exhibits(config_);
    if (!unread_exhibits_.empty())
      for (Diagnostic& diagnostic : unknown)
        diagnostic.hint +=
            fmt::format("; is it in {}, which is not read?", unread_exhibits_.front().string());
    add(std::move(unknown));
  }

  void check_door(DoorSection& door) {
    check_floor(door.floor, door.a);
    if (!door.id.given && !door.name.given)
      error(door.place, "missing-field", "[[door]] lacks 'id'", {},
            "write id = \"...\", a short name that stays, or name = \"...\", what staff call it");
    if (door.a.given && door.b.given && door.a.value == door.b.value)
      error(door.b.place, "bad-value",
            fmt::format("both ends of door '{}' are the same point", door.called().value), {},
            "write the two sides of the doorway: a = [12.5, 4.0] and b = [13.5, 4.0]");
  }

  void check_stops(ConnectionSection& connection) {
    std::map<std::string_view, Place> seen;
    for (StopSection& stop : connection.stops.value) {
      check_floor(stop.floor, stop.position);
      const auto [first, is_new] = seen.emplace(stop.floor.value, stop.floor.place);
      if (!is_new)
        error(stop.floor.place, "bad-value",
              fmt::format("connection '{}' stops twice on floor '{}'", connection.id.value,
                          stop.floor.value),
              {},
              fmt::format("the first is in line {}; where a floor has two entrances, write a "
                          "connection for each",
                          first->second.range.line));
    }
    if (connection.stops.given && connection.stops.value.size() < 2)
      error(
          connection.stops.place, "bad-value",
          fmt::format("connection '{}' has {} stop{}", connection.id.value,
                      connection.stops.value.size(), connection.stops.value.size() == 1 ? "" : "s"),
          {}, "it joins floors: name two or more, each with the place where one goes in");
  }

  void check_kiosks() {
    if (config_.kiosks.empty())
      about_file(
          config_.files.front(), "no-kiosk",
          "does not say where the kiosk stands, and it is taken to stand where there is most room",
          "write [kiosk] and below it position = [12.5, 4.0], facing = 90 and floor = \"...\"");
    check_unique("kiosk", "id", config_.kiosks, &KioskSection::id);
    for (KioskSection& kiosk : config_.kiosks) {
      check_floor(kiosk.floor, kiosk.position);
      if (config_.kiosks.size() > 1 && !kiosk.id.given)
        error(kiosk.place, "missing-field", "one of several [[kiosk]] lacks its 'id'", {},
              "id = \"...\", and in that device's kiosk.toml: kiosk = \"...\"");
    }
  }

  /// `name_of`: the member that is a section's name, or the function that chooses it.
  template <typename T, typename NameOf>
  void check_unique(std::string_view what, std::string_view key, const std::vector<T>& sections,
                    NameOf name_of) {
    std::map<std::string_view, Place> seen;
    for (const T& section : sections) {
      const Located<std::string>& name = std::invoke(name_of, section);
      if (name.value.empty()) continue;
      const auto [first, is_new] = seen.emplace(name.value, name.place);
      if (is_new) continue;
      const std::string& file = config_.files[static_cast<std::size_t>(first->second.file)];
      error(name.place, "duplicate-id",
            fmt::format("there are two {}s with the {} '{}'", what, key, name.value), {},
            fmt::format("the first is at {}:{}; give this one another {}", file,
                        first->second.range.line, key));
    }
  }

  /// What stands on a floor that is not there stands nowhere.
  void check_floor(const Located<std::string>& floor, auto& where) {
    if (floor.value.empty()) return;
    std::vector<std::string_view> names;
    names.reserve(config_.floors.size());
    for (const FloorSection& section : config_.floors) names.emplace_back(section.name.value);
    if (std::ranges::find(names, floor.value) != names.end()) return;
    where.given = false;
    const std::string_view near = terminal::closest(in_small_letters(floor.value), names);
    error(floor.place, "unknown-floor", fmt::format("there is no floor '{}'", floor.value), {},
          fmt::format("{}the floors are: {}",
                      near.empty() ? "" : fmt::format("did you mean \"{}\"? Otherwise ", near),
                      fmt::join(names, ", ")));
  }

  void check_files() {
    for (FloorSection& floor : config_.floors) check_file(floor.plan);
    for (ExhibitSection& exhibit : config_.exhibits) {
      check_file(exhibit.image);
      for (PictureSection& picture : exhibit.pictures.value) check_file(picture.image);
      for (ExhibitSoundSection& sound : exhibit.sounds.value) check_file(sound.recording);
      check_file(exhibit.model);
    }
    for (SourceSection& source : config_.sources) check_file(source.file, Wanted::FileOrFolder);
    check_file(config_.motion.clips, Wanted::FileOrFolder);
    check_file(config_.avatar.model);
    for (SpeechSection& speech : config_.speech) check_file(speech.recording);
    for (Located<std::string>* logo : {&config_.look.logo, &config_.look.logo_at_night})
      check_file(*logo);
    for (Located<LocatedList>* fonts : {&config_.look.title_font, &config_.look.text_font})
      for (Located<std::string>& font : fonts->value) check_file(font);
  }

  /// A file that cannot be taken is told, and nobody opens it.
  void check_file(Located<std::string>& file, Wanted wanted = Wanted::File) {
    if (file.value.empty()) return;
    auto fault = paths_.fault(file.value, wanted);
    if (!fault) return;
    error(file.place, std::move(fault->code), std::move(fault->message), std::move(fault->label),
          std::move(fault->hint));
    file.value.clear();
    file.given = false;
  }

  /// A tag that is none is told once, and taken for the one that was meant.
  void check_languages() {
    const Located<LocatedList>& asked = config_.museum.languages;
    if (asked.given && asked.value.empty())
      error(asked.place, "bad-value", "the museum speaks no language", "an empty list",
            "write languages = [\"en\"], or leave the line out");
    std::vector<std::string> known;
    const auto take = [&](const std::string& tag) {
      if (std::ranges::find(known, tag) != known.end()) return false;
      known.push_back(tag);
      return true;
    };
    for (const Located<std::string>& tag : asked.value) {
      if (is_language_tag(tag.value)) {
        if (!take(tag.value))
          error(tag.place, "bad-value",
                fmt::format("the language '{}' is written twice", tag.value), {},
                "keep one of them");
        continue;
      }
      error(tag.place, "unknown-language", fmt::format("there is no language tag '{}'", tag.value),
            {}, language_hint(tag.value));
      for (const std::string& word : words_of(tag.value))
        if (const std::string meant = language_of_word(word); used_tags().contains(meant))
          take(meant);
    }
    if (!known.empty()) config_.languages = std::move(known);
  }

  /// The tag that a word is, or is meant as: "zh-cn" as "zh" where texts are given in that.
  std::string language_of_word(const std::string& word) const {
    std::string meant = is_language_tag(word) ? word : meant_language(word);
    const std::string language = meant.substr(0, meant.find('-'));
    const std::set<std::string> used = used_tags();
    return !used.contains(meant) && used.contains(language) ? language : meant;
  }

  /// The words of "en, zh, ar".
  static std::vector<std::string> words_of(const std::string& text) {
    std::vector<std::string> words(1);
    for (const char c : text)
      if (c == ',' || c == ';' || c == ' ')
        words.emplace_back();
      else
        words.back() += c;
    std::erase(words, std::string());
    return words;
  }

  std::string language_hint(const std::string& tag) const {
    const std::vector<std::string> words = words_of(tag);
    if (words.size() > 1 && std::ranges::all_of(words, is_language_tag))
      return fmt::format("write [\"{}\"]", fmt::join(words, "\", \""));
    const std::string meant = language_of_word(words.empty() ? tag : words.front());
    if (!meant.empty()) return fmt::format("did you mean \"{}\"?", meant);
    return "write the language's code of ISO 639: \"en\", \"de\", \"zh\"";
  }

  void check_translations() {
    check_texts("the museum's title", config_.museum.title);
    check_texts("the museum's welcome", config_.museum.welcome, room_for_text / 2);
    for (const FloorSection& floor : config_.floors)
      check_texts(fmt::format("the title of floor '{}'", floor.name.value), floor.title);
    for (const RoomSection& room : config_.rooms)
      check_texts(fmt::format("the title of room '{}'", room.id.value), room.title);
    for (const PlaceSection& place : config_.places)
      check_texts(fmt::format("the title of place '{}'", place.id.value), place.title);
    for (const ExhibitSection& exhibit : config_.exhibits) {
      const bool is_completed = !config_.sources.empty();  // by the objects of a [source]
      check_texts(fmt::format("the title of exhibit '{}'", exhibit.id.value), exhibit.title,
                  room_for_title, is_completed);
      check_texts(fmt::format("the text of exhibit '{}'", exhibit.id.value), exhibit.text,
                  room_for_text, is_completed);
      check_texts(fmt::format("the description of exhibit '{}'", exhibit.id.value),
                  exhibit.description, room_for_text, is_completed);
      check_texts(fmt::format("the longer text of exhibit '{}'", exhibit.id.value), exhibit.more,
                  std::numeric_limits<std::size_t>::max());
      check_length_of_more(exhibit);
      for (std::size_t i = 0; i < exhibit.pictures.value.size(); ++i) {
        const PictureSection& picture = exhibit.pictures.value[i];
        const std::string which =
            fmt::format("picture {} of exhibit '{}'", i + 2, exhibit.id.value);
        check_texts("the caption of " + which, picture.caption, room_for_text);
        check_texts("the description of " + which, picture.description, room_for_text);
      }
      for (std::size_t i = 0; i < exhibit.sounds.value.size(); ++i) {
        const ExhibitSoundSection& sound = exhibit.sounds.value[i];
        const std::string which = fmt::format("sound {} of exhibit '{}'", i + 1, exhibit.id.value);
        check_texts("the title of " + which, sound.title);
        check_texts("the description of " + which, sound.description, room_for_text);
      }
      // A name or a tag may be the same in several languages: it need not be written in each.
      for (const auto& [name, texts] :
           {std::pair{"artist", &exhibit.artist}, std::pair{"subject", &exhibit.subject},
            std::pair{"period", &exhibit.period}})
        check_texts(fmt::format("the {} of exhibit '{}'", name, exhibit.id.value), *texts,
                    room_for_title, true);
    }
    for (const WaySection& way : config_.ways)
      check_texts(fmt::format("the title of way '{}'", way.kind.value), way.title);
    for (const TourSection& tour : config_.tours)
      check_texts(fmt::format("the title of tour '{}'", tour.id.value), tour.title);
  }

  void check_length_of_more(const ExhibitSection& exhibit) {
    for (const auto& [tag, text] : exhibit.more.value)
      if (const std::size_t letters = count_letters(text.value); letters > longest_more)
        error(text.place, "text-too-long",
              fmt::format("the longer text of exhibit '{}' has {} letters in '{}', and a kiosk "
                          "shows at most {}",
                          exhibit.id.value, letters, tag, longest_more),
              {},
              fmt::format("shorten it by {} letters: nobody reads so much standing",
                          letters - longest_more));
  }

  /// A text that is given at all is given in every language, and in no other.
  void check_texts(const std::string& what, const Located<LocatedTexts>& texts,
                   std::size_t room = room_for_title, bool is_completed = false) {
    if (!texts.given) return;
    if (texts.value.empty())
      return error(texts.place, "missing-translation",
                   fmt::format("{} is given in no language", what), {},
                   fmt::format("the languages are: {}", fmt::join(config_.languages, ", ")));
    const auto [given_tag, given] = first_given(texts.value);
    for (const std::string& tag : config_.languages)
      if (!texts.value.contains(tag) && !is_completed && !is_meant_by_another(texts.value, tag))
        error(given->place, "missing-translation",
              fmt::format("{} is not translated into '{}'", what, tag), given_in(texts.value),
              fmt::format("translate from '{}': {}", given_tag, given->value));
    for (const auto& [tag, text] : texts.value)
      if (text.given)
        check_text(what, tag, text, room, !is_completed && !texts.value.contains(meant_by(tag)));
  }

  /// The museum's language that a wrong tag is meant as; empty where there is none.
  std::string meant_by(const std::string& tag) const {
    const std::string meant = is_language_tag(tag) ? "" : meant_language(tag);
    const bool is_spoken = std::ranges::find(config_.languages, meant) != config_.languages.end();
    return is_spoken ? meant : "";
  }

  /// title.EN is told as such, and not as a missing title.en.
  bool is_meant_by_another(const LocatedTexts& texts, const std::string& tag) const {
    return std::ranges::any_of(texts,
                               [&](const auto& entry) { return meant_by(entry.first) == tag; });
  }

  /// `is_needed`: there is no other text in the language that its tag is meant as.
  void check_text(const std::string& what, const std::string& tag, const Located<std::string>& text,
                  std::size_t room, bool is_needed) {
    if (std::ranges::find(config_.languages, tag) == config_.languages.end())
      tell_unknown_language(what, tag, text, is_needed);
    if (text.value.find_first_not_of(" \t\r\n") == std::string::npos)
      return error(text.place, "empty-text", fmt::format("{} is empty in '{}'", what, tag), {},
                   "write it, or leave out the text in every language");
    for (const TextFault& fault : faults_of(text.value, fonts_of(config_), room))
      warning(text.place, fault.code,
              fmt::format("{} {} in '{}'{}", what, fault.what, tag, fault.why), fault.hint);
  }

  void tell_unknown_language(const std::string& what, const std::string& tag,
                             const Located<std::string>& text, bool is_needed) {
    const Place key{text.place.file, text.key};
    if (is_language_tag(tag))
      return warning(
          key, "unknown-language",
          fmt::format("{} is given in '{}', which the museum does not speak", what, tag),
          fmt::format("write languages = [..., \"{}\"] in museum.toml, or remove it; the "
                      "languages are: {}",
                      tag, fmt::join(config_.languages, ", ")));
    const std::string meant = meant_by(tag);
    warning(key, "unknown-language",
            fmt::format("{} is given in '{}', which is no language tag", what, tag),
            fmt::format("{}he languages are: {}",
                        meant.empty() ? "t" : fmt::format("did you mean '{}'? T", meant),
                        fmt::join(config_.languages, ", ")));
    if (!meant.empty() && is_needed) diagnostics_.back().severity = Severity::Error;
  }

  /// The first of the museum's languages in which a text is given, else any.
  std::pair<std::string, const Located<std::string>*> first_given(const LocatedTexts& texts) const {
    for (const std::string& tag : config_.languages)
      if (const auto found = texts.find(tag); found != texts.end()) return {tag, &found->second};
    return {texts.begin()->first, &texts.begin()->second};
  }

  static std::string given_in(const LocatedTexts& texts) {
    std::vector<std::string> tags;
    for (const auto& [tag, text] : texts)
      if (text.given) tags.push_back(fmt::format("'{}'", tag));
    return fmt::format("here in {}", fmt::join(tags, ", "));
  }

  /// In the order in which the files were read, and of the lines within each.
  void sort_diagnostics() {
    const auto position = [&](const Diagnostic& d) {
      const auto file = std::ranges::find(config_.files, d.file) - config_.files.begin();
      return std::tuple(file, d.line, d.column);
    };
    std::ranges::stable_sort(diagnostics_, {}, position);
  }

  MuseumConfig config_;
  MuseumPaths paths_;
  std::vector<Diagnostic> diagnostics_;
  std::vector<fs::path> unread_exhibits_;  ///< Files in which exhibits may be that nobody knows.
};

}  // namespace

Loaded<MuseumConfig> load_museum_config(const fs::path& folder) {
  return MuseumLoader(folder).load();
}

namespace {

/// Words that stand in the file without their heading [words] are told once, and read.
void gather_words(const fs::path& file, TomlNode& root, std::vector<Diagnostic>& diagnostics) {
  const auto is_word = [](const TomlEntry& entry) {
    return entry.value.kind == TomlNode::Kind::Text && entry.key != "name" &&
           entry.key != "direction";
  };
  constexpr std::ptrdiff_t several = 3;
  if (std::ranges::find(root.entries, "words", &TomlEntry::key) != root.entries.end() ||
      std::ranges::count_if(root.entries, is_word) < several)
    return;
  const auto first = std::ranges::find_if(root.entries, is_word);
  TomlEntry words{.key = "words", .key_range = first->key_range, .value = {}};
  words.value.range = first->key_range;
  diagnostics.push_back({.file = file.string(),
                         .line = first->key_range.line,
                         .column = first->key_range.column,
                         .length = first->key_range.length,
                         .code = "missing-field",
                         .message = "the words stand here without their heading",
                         .hint = "write [words] in the line above"});
  std::ranges::copy_if(root.entries, std::back_inserter(words.value.entries), is_word);
  std::erase_if(root.entries, is_word);
  root.entries.push_back(std::move(words));
}

}  // namespace

Loaded<WordsFile> load_words(const fs::path& file, const std::string& tag) {
  TomlFile toml = read_toml(file, file.string());
  if (!toml.root) return {.value = std::nullopt, .diagnostics = std::move(toml.diagnostics)};
  WordsFile words;
  words.tag = tag;
  gather_words(file, *toml.root, toml.diagnostics);
  SectionReader reader(FileIndex{}, file.string(), toml.diagnostics);
  reader.read<WordsFile>(*toml.root, file.filename().string(), words_fields, words);
  return {.value = std::move(words), .diagnostics = std::move(toml.diagnostics)};
}

std::vector<Diagnostic> missing_fields(const MuseumConfig& config, const ExhibitSection& exhibit) {
  std::vector<Diagnostic> missing;
  SectionReader reader(exhibit.place.file,
                       config.files[static_cast<std::size_t>(exhibit.place.file)], missing);
  for (const Field<ExhibitSection>& field : exhibit_fields) {
    if (field.presence != Presence::UnlessSource) continue;
    // Where it was written, it has a place of its own, and what is wrong with it is told.
    const bool is_written = std::visit(
        [&](auto member) {
          return (exhibit.*member).given || (exhibit.*member).place.range != exhibit.place.range;
        },
        field.member);
    if (!is_written)
      reader.missing(exhibit.place, "[[exhibit]]", field.key, field.manual, example_of(field));
  }
  return missing;
}

std::vector<Diagnostic> unknown_exhibits(const MuseumConfig& config) {
  std::vector<std::string_view> known;
  for (const ExhibitSection& exhibit : config.exhibits) known.emplace_back(exhibit.id.value);
  const std::set<std::string_view> ids(known.begin(), known.end());
  std::vector<Diagnostic> unknown;
  for (const TourSection& tour : config.tours)
    for (const Located<std::string>& id : tour.exhibits.value) {
      if (ids.contains(id.value)) continue;
      const std::string_view near = terminal::closest(in_small_letters(id.value), known);
      unknown.push_back(
          diagnostic_at(config, id.place, "unknown-exhibit",
                        fmt::format("tour '{}' names an exhibit that is not there: '{}'",
                                    tour.id.value, id.value),
                        {},
                        near.empty() ? "the ids are in the files of exhibits/"
                                     : fmt::format("did you mean '{}'?", near)));
    }
  return unknown;
}

std::size_t floor_index(const MuseumConfig& config, const std::string& name) {
  for (std::size_t i = 0; i < config.floors.size(); ++i)
    if (config.floors[i].name.value == name) return i;
  return 0;
}

Diagnostic diagnostic_at(const MuseumConfig& config, const Place& place, std::string code,
                         std::string message, std::string label, std::string hint) {
  return {.file = config.files[static_cast<std::size_t>(place.file)],
          .line = place.range.line,
          .column = place.range.column,
          .length = place.range.length,
          .severity = Severity::Error,
          .code = std::move(code),
          .message = std::move(message),
          .label = std::move(label),
          .hint = std::move(hint)};
}

}  // namespace docent::config
