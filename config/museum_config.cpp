#include "config/museum_config.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string_view>
#include <system_error>

#include "config/museum_fields.h"
#include "platform/file/read_file.h"

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

/// The files of a folder that end in .toml, in the order of their names.
std::vector<fs::path> toml_files(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code ignored;  // a folder that is not there, or goes meanwhile, holds no files
  for (fs::directory_iterator entry(folder, ignored); !ignored && entry != fs::directory_iterator();
       entry.increment(ignored))
    if (entry->path().extension() == ".toml") files.push_back(entry->path());
  std::ranges::sort(files);
  return files;
}

class MuseumLoader {
 public:
  explicit MuseumLoader(const fs::path& folder) { config_.folder = folder; }

  Loaded<MuseumConfig> load() && {
    const bool readable =
        read(config_.folder / "museum.toml", [&](auto& visit) { museum_sections(visit, config_); });
    if (!readable) return {.value = std::nullopt, .diagnostics = std::move(diagnostics_)};
    if (!config_.kiosks.empty()) config_.kiosk = config_.kiosks.front();
    for (const fs::path& file : toml_files(config_.folder / "exhibits"))
      read(file, [&](auto& visit) { exhibit_sections(visit, config_); });
    find_languages();
    read_words();
    check_references();
    check_files();
    check_translations();
    sort_diagnostics();
    return {.value = std::move(config_), .diagnostics = std::move(diagnostics_)};
  }

 private:
  FileIndex add_file(const fs::path& file) {
    config_.files.push_back(file.string());
    return static_cast<FileIndex>(config_.files.size() - 1);
  }

  bool read(const fs::path& file, auto&& sections) {
    const FileIndex index = add_file(file);
    const TomlFile toml = read_toml(file, file.string());
    diagnostics_.insert(diagnostics_.end(), toml.diagnostics.begin(), toml.diagnostics.end());
    if (!toml.root) return false;
    SectionReader reader(index, file.string(), diagnostics_);
    SectionVisitor visitor(*toml.root, reader);
    sections(visitor);
    visitor.report_unknown(file.filename().string());
    return true;
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
    config_.languages = config_.museum.languages.value;
    if (!config_.languages.empty()) return;
    std::set<std::string> used;
    const auto add = [&](const Located<LocatedTexts>& texts) {
      for (const auto& [tag, text] : texts.value) used.insert(tag);
    };
    add(config_.museum.title);
    for (const ExhibitSection& exhibit : config_.exhibits) add(exhibit.title);
    if (used.erase("en") > 0 || used.empty()) config_.languages.emplace_back("en");
    config_.languages.insert(config_.languages.end(), used.begin(), used.end());
  }

  void read_words() {
    for (const std::string& tag : config_.languages) {
      const fs::path file = config_.folder / "words" / (tag + ".toml");
      if (!file::is_there(file)) continue;
      Loaded<WordsFile> words = load_words(file, tag);
      diagnostics_.insert(diagnostics_.end(), words.diagnostics.begin(), words.diagnostics.end());
      const FileIndex index = add_file(file);
      if (!words.value) continue;
      words.value->words.place.file = index;
      for (auto& [key, word] : words.value->words.value) word.place.file = index;
      config_.words.push_back(std::move(*words.value));
    }
  }

  void check_references() {
    if (config_.floors.empty())
      error({FileIndex{}, {}}, "missing-field", "museum.toml lacks a [[floor]]", {},
            "[[floor]] with a name and a plan, a GeoJSON file");
    check_unique("floor", "name", config_.floors, &FloorSection::name);
    check_unique("room", "id", config_.rooms, &RoomSection::id);
    check_unique("exhibit", "id", config_.exhibits, &ExhibitSection::id);
    check_kiosks();
    for (const RoomSection& room : config_.rooms) check_floor(room.floor);
    for (const DoorSection& door : config_.doors) check_floor(door.floor);
    for (const ExhibitSection& exhibit : config_.exhibits) check_floor(exhibit.floor);
  }

  void check_kiosks() {
    check_unique("kiosk", "id", config_.kiosks, &KioskSection::id);
    for (const KioskSection& kiosk : config_.kiosks) {
      check_floor(kiosk.floor);
      if (config_.kiosks.size() > 1 && !kiosk.id.given)
        error(kiosk.place, "missing-field", "one of several [[kiosk]] lacks its 'id'", {},
              "id = \"...\", and in that device's kiosk.toml: kiosk = \"...\"");
    }
  }

  template <typename T>
  void check_unique(std::string_view what, std::string_view key, const std::vector<T>& sections,
                    Located<std::string> T::* member) {
    std::map<std::string_view, Place> seen;
    for (const T& section : sections) {
      const Located<std::string>& name = section.*member;
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

  void check_floor(const Located<std::string>& floor) {
    if (floor.value.empty()) return;
    std::vector<std::string_view> names;
    names.reserve(config_.floors.size());
    for (const FloorSection& section : config_.floors) names.emplace_back(section.name.value);
    if (std::ranges::find(names, floor.value) == names.end())
      error(floor.place, "unknown-floor", fmt::format("there is no floor '{}'", floor.value), {},
            fmt::format("the floors are: {}", fmt::join(names, ", ")));
  }

  void check_files() {
    for (const FloorSection& floor : config_.floors) check_file(floor.plan);
    for (const ExhibitSection& exhibit : config_.exhibits) check_file(exhibit.image);
    check_file(config_.motion.clips);
  }

  void check_file(const Located<std::string>& file) {
    if (file.value.empty() || file::is_there(config_.folder / file.value)) return;
    error(file.place, "missing-file", fmt::format("there is no file '{}'", file.value), "not found",
          fmt::format("it is looked for in {}", config_.folder.string()));
  }

  void check_translations() {
    check_texts("the museum's title", config_.museum.title);
    check_texts("the museum's welcome", config_.museum.welcome);
    for (const RoomSection& room : config_.rooms)
      check_texts(fmt::format("the title of room '{}'", room.id.value), room.title);
    for (const ExhibitSection& exhibit : config_.exhibits) {
      check_texts(fmt::format("the title of exhibit '{}'", exhibit.id.value), exhibit.title);
      check_texts(fmt::format("the text of exhibit '{}'", exhibit.id.value), exhibit.text);
    }
    for (const WordsFile& words : config_.words) check_words(words);
  }

  /// A text that is given at all is given in every language, and in no other.
  void check_texts(const std::string& what, const Located<LocatedTexts>& texts) {
    if (!texts.given || texts.value.empty()) return;
    const auto& [given_tag, given] = *texts.value.begin();
    for (const std::string& tag : config_.languages)
      if (!texts.value.contains(tag))
        error(given.place, "missing-translation",
              fmt::format("{} is not translated into '{}'", what, tag),
              fmt::format("only here in '{}'", given_tag),
              fmt::format("translate: {}", given.value));
    for (const auto& [tag, text] : texts.value)
      if (std::ranges::find(config_.languages, tag) == config_.languages.end())
        warning(text.place, "unknown-language",
                fmt::format("{} is given in '{}', which the museum does not speak", what, tag),
                fmt::format("the languages are: {}", fmt::join(config_.languages, ", ")));
  }

  /// Every language has the keys of the first.
  void check_words(const WordsFile& words) {
    const LocatedTexts& wanted = config_.words.front().words.value;
    std::vector<std::string_view> keys;
    for (const auto& [key, word] : wanted) {
      keys.emplace_back(key);
      if (!words.words.value.contains(key))
        error(words.words.place, "missing-translation",
              fmt::format("the word '{}' is not translated into '{}'", key, words.tag), {},
              fmt::format("translate: {} = \"{}\"", key, word.value));
    }
    for (const auto& [key, word] : words.words.value) {
      if (wanted.contains(key)) continue;
      SectionReader reader(word.place.file,
                           config_.files[static_cast<std::size_t>(word.place.file)], diagnostics_);
      reader.unknown_key({.key = key, .key_range = word.place.range, .value = {}}, "[words]", keys);
    }
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
  std::vector<Diagnostic> diagnostics_;
};

}  // namespace

Loaded<MuseumConfig> load_museum_config(const fs::path& folder) {
  return MuseumLoader(folder).load();
}

Loaded<WordsFile> load_words(const fs::path& file, const std::string& tag) {
  TomlFile toml = read_toml(file, file.string());
  if (!toml.root) return {.value = std::nullopt, .diagnostics = std::move(toml.diagnostics)};
  WordsFile words;
  words.tag = tag;
  SectionReader reader(FileIndex{}, file.string(), toml.diagnostics);
  reader.read<WordsFile>(*toml.root, file.filename().string(), words_fields, words);
  return {.value = std::move(words), .diagnostics = std::move(toml.diagnostics)};
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
