#include "content/compile/add_collections.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include "config/exhibit_media.h"
#include "config/museum_path.h"
#include "config/text_faults.h"
#include "content/content_error.h"
#include "content/import/collection/csv.h"
#include "content/import/collection/iiif.h"
#include "content/import/collection/plain_text.h"
#include "content/import/drawing/lower_case.h"
#include "content/read_source.h"
#include "platform/file/file_kind.h"
#include "platform/file/read_file.h"
#include "platform/terminal/suggest.h"

namespace docent::compile {

namespace {

namespace fs = std::filesystem;
using config::ExhibitSection;
using config::Located;
using config::LocatedTexts;
using config::Place;
using config::SourceSection;
using import::CollectionObject;

using Texts = std::map<std::string, std::string, std::less<>>;

/// What exhibits are found by, and what belongs together by it.
struct Tag {
  std::string_view name;
  Located<LocatedTexts> SourceSection::* columns;
  Located<LocatedTexts> ExhibitSection::* texts;
};
constexpr std::array tags{Tag{"artist", &SourceSection::artist, &ExhibitSection::artist},
                          Tag{"subject", &SourceSection::subject, &ExhibitSection::subject},
                          Tag{"period", &SourceSection::period, &ExhibitSection::period}};

/// An object with what only spreadsheets say of it.
struct Placed {
  CollectionObject object;
  std::array<Texts, tags.size()> tagged;  ///< By language.
  std::optional<Vec2> position;
  std::optional<double> facing;
  std::string floor;
};

/// An id of ours for a museum's own: "G 1912/4" becomes "G-1912-4", the address of a manifest its
/// last telling part.
std::string exhibit_id(std::string_view own) {
  if (own.find("://") != std::string_view::npos) {
    for (const std::string_view end : {"/manifest.json", "/manifest", ".json", "/"})
      if (own.ends_with(end)) own.remove_suffix(end.size());
    own.remove_prefix(std::min(own.rfind('/') + 1, own.size()));
  }
  std::string id;
  for (const char c : own) {
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                          (c >= '0' && c <= '9') || c == '.' || c == '_' || c == '-';
    if (is_plain)
      id += c;
    else if (!id.empty() && id.back() != '-')
      id += '-';
  }
  while (id.ends_with('-')) id.pop_back();
  return id;
}

/// A number as spreadsheets write it: 12.5 or 12,5.
std::optional<double> number_of(std::string text) {
  std::ranges::replace(text, ',', '.');
  double value = 0;
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failed != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return {};
  return value;
}

/// The first of several things in a cell that is not blank.
std::string first_of(const std::string& cell) {
  const std::size_t begin = std::min(cell.find_first_not_of(";| \t\r\n"), cell.size());
  return cell.substr(begin, cell.find_first_of(";|", begin) - begin);
}

/// The first of several pictures in a cell, with slashes.
std::string first_picture(std::string cell) {
  std::ranges::replace(cell, '\\', '/');
  return first_of(cell);
}

/// A tag in one line, with single blanks.
std::string tag_in(const std::string& cell) {
  std::string tag;
  for (const char c : first_of(import::plain_text(cell))) {
    const bool is_blank = c == ' ' || c == '\n' || c == '\t' || c == '\r';
    if (!is_blank)
      tag += c;
    else if (!tag.empty() && tag.back() != ' ')
      tag += ' ';
  }
  while (tag.ends_with(' ')) tag.pop_back();
  return tag;
}

class CollectionAdder {
 public:
  CollectionAdder(config::MuseumConfig& config, Report& report)
      : config_(config), report_(report), paths_(config.folder) {}

  void run() {
    by_hand_ = config_.exhibits.size();
    for (std::size_t i = 0; i < by_hand_; ++i) index_[config_.exhibits[i].id.value] = i;
    for (const SourceSection& source : config_.sources)
      if (source.file.given) add_source(source);
    for (std::size_t i = 0; i < by_hand_; ++i) finish(config_.exhibits[i]);
    drop_incomplete();
    report_.add(config::unknown_exhibits(config_));
  }

 private:
  void tell(Severity severity, const Place& place, std::string code, std::string message,
            std::string hint = {}) {
    Diagnostic diagnostic = config::diagnostic_at(config_, place, std::move(code),
                                                  std::move(message), {}, std::move(hint));
    diagnostic.severity = severity;
    report_.add(std::move(diagnostic));
  }

  /// What is written by hand and was completed, or not.
  void finish(ExhibitSection& exhibit) {
    report_.add(config::missing_fields(config_, exhibit));
    if (auto missing = config::missing_first_picture(config_, exhibit))
      report_.add(std::move(*missing));
    fill_up("title", exhibit.id.value, exhibit.place, exhibit.title);
    fill_up("text", exhibit.id.value, exhibit.place, exhibit.text);
  }

  Place place_of(const fs::path& file, std::uint32_t line) {
    const std::string name = file.string();
    auto found = std::ranges::find(config_.files, name);
    if (found == config_.files.end()) found = config_.files.insert(found, name);
    return {static_cast<config::FileIndex>(found - config_.files.begin()),
            {.line = line, .column = line == 0 ? 0U : 1U}};
  }

  void add_source(const SourceSection& source) {
    const fs::path file = config_.folder / source.file.value;
    std::vector<fs::path> files{file};
    if (file::is_folder(file)) files = files_in(file);
    if (files.empty())
      tell(Severity::Warning, source.file.place, "no-objects",
           fmt::format("the folder '{}' holds no .json and no .csv file", source.file.value),
           "save the manifests or the spreadsheet in it");
    for (const fs::path& each : files) {
      try {
        add_file(source, each);
      } catch (const content::ContentError& error) {
        report_.add(content::to_diagnostic(error));
      }
    }
  }

  static std::vector<fs::path> files_in(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code failed;
    for (fs::directory_iterator entry(folder, failed); !failed && entry != fs::directory_iterator();
         entry.increment(failed))
      if (const auto ending = entry->path().extension(); ending == ".json" || ending == ".csv")
        files.push_back(entry->path());
    std::ranges::sort(files);
    return files;
  }

  void add_file(const SourceSection& source, const fs::path& file) {
    const std::string bytes = content::read_source(file);
    if (const file::FileKind kind = file::file_kind(bytes); !kind.name.empty())
      return tell(Severity::Error, source.file.place, "not-a-catalogue",
                  fmt::format("'{}' is {}, and no catalogue that can be read",
                              file.lexically_relative(config_.folder).string(), kind.name),
                  kind.remedy.empty() ? "name a CSV file, or IIIF manifests (JSON)"
                                      : std::string(kind.remedy));
    const std::size_t first = bytes.find_first_not_of(" \t\r\n\xef\xbb\xbf");
    const bool is_json = first != std::string::npos && (bytes[first] == '{' || bytes[first] == '[');
    counts_ = {};
    const std::vector<Placed> objects =
        is_json ? objects_of_iiif(file, bytes) : objects_of_csv(source, file, bytes);
    for (const Placed& object : objects) add_object(object, file);
    tell_counts(file, objects.size());
    if (objects.empty() && !report_.has_errors())
      tell(Severity::Warning, source.file.place, "no-objects",
           fmt::format("'{}' holds no object", file.lexically_relative(config_.folder).string()),
           "below the line of the columns' names, each line is an object");
  }

  std::vector<Placed> objects_of_iiif(const fs::path& file, const std::string& bytes) {
    import::Collection collection = import::read_iiif(file.string(), bytes);
    for (const import::CollectionDoubt& doubt : collection.doubts)
      tell(Severity::Warning, place_of(file, doubt.line), "odd-manifest", doubt.message,
           doubt.hint);
    if (!collection.members.empty())
      tell(Severity::Warning, place_of(file, 0), "members-elsewhere",
           fmt::format("holds the addresses of {} manifests, and nothing is fetched from the web",
                       collection.members.size()),
           "save them in a folder, and write file = \"FOLDER\"");
    std::vector<Placed> objects;
    for (CollectionObject& object : collection.objects) {
      Placed placed;
      placed.object = std::move(object);
      objects.push_back(std::move(placed));
    }
    return objects;
  }

  /// The column of a name; reported where there is none. Empty where the field is not given.
  std::optional<std::size_t> column(const import::CsvTable& table, const std::string& name,
                                    const Place& place) {
    if (name.empty()) return {};
    const auto found = std::ranges::find(table.column, name);
    if (found != table.column.end()) return static_cast<std::size_t>(found - table.column.begin());
    const std::vector<std::string_view> names(table.column.begin(), table.column.end());
    const std::string_view meant = terminal::closest(name, names);
    tell(Severity::Error, place, "unknown-column", fmt::format("there is no column '{}'", name),
         meant.empty() ? fmt::format("the columns are: {}", fmt::join(table.column, ", "))
                       : fmt::format("did you mean '{}'?", meant));
    return {};
  }

  std::map<std::string, std::size_t> text_columns(const import::CsvTable& table,
                                                  const LocatedTexts& names) {
    std::map<std::string, std::size_t> columns;
    for (const auto& [language, name] : names)
      if (const auto found = column(table, name.value, name.place)) columns[language] = *found;
    return columns;
  }

  std::vector<Placed> objects_of_csv(const SourceSection& source, const fs::path& file,
                                     const std::string& bytes) {
    const import::CsvForm form{.encoding = source.encoding.value,
                               .separator = source.separator.value.empty() ? '\0'
                                            : source.separator.value == "tab"
                                                ? '\t'
                                                : source.separator.value.front()};
    const import::CsvTable table = import::read_csv(bytes, form);
    for (const import::CsvDoubt& doubt : table.doubts)
      tell(Severity::Warning, place_of(file, doubt.line), "odd-row", doubt.message, doubt.hint);
    if (table.encoding != "UTF-8" && source.encoding.value.empty())
      tell(Severity::Warning, source.file.place, "guessed-encoding",
           fmt::format("'{}' is not UTF-8 and was read as {}", source.file.value, table.encoding),
           fmt::format("if that is right, write encoding = \"{}\"; else save the file as UTF-8",
                       table.encoding == "UTF-16" ? "utf-16" : "windows-1252"));
    if (!source.id.given) {
      tell(Severity::Error, source.place, "missing-field", "[source] lacks 'id'",
           fmt::format("name a column: {}", fmt::join(table.column, ", ")));
      return {};
    }
    return rows(source, file, table);
  }

  std::vector<Placed> rows(const SourceSection& source, const fs::path& file,
                           const import::CsvTable& table) {
    const auto id = column(table, source.id.value, source.id.place);
    const auto image = column(table, source.image.value, source.image.place);
    const auto floor = column(table, source.floor.value, source.floor.place);
    const auto facing = column(table, source.facing.value, source.facing.place);
    const auto title = text_columns(table, source.title.value);
    const auto text = text_columns(table, source.text.value);
    std::array<std::map<std::string, std::size_t>, tags.size()> tagged;
    for (std::size_t i = 0; i < tags.size(); ++i)
      tagged[i] = text_columns(table, (source.*tags[i].columns).value);
    std::vector<std::optional<std::size_t>> position;
    for (const Located<std::string>& name : source.position.value)
      position.push_back(column(table, name.value, name.place));
    if (source.position.given && position.size() != 2)
      tell(Severity::Error, source.position.place, "bad-value", "'position' names two columns",
           "write position = [\"east\", \"north\"]");
    if (!id) return {};
    std::vector<Placed> objects;
    objects.reserve(table.record.size());
    for (const import::CsvRecord& record : table.record) {
      Placed& placed = objects.emplace_back();
      placed.object.file = file.string();
      placed.object.line = record.line;
      placed.object.id = record.cell[*id];
      for (const auto& [language, cell] : title)
        placed.object.title[language] = import::plain_text(record.cell[cell]);
      for (const auto& [language, cell] : text)
        placed.object.text[language] = import::plain_text(record.cell[cell]);
      for (std::size_t i = 0; i < tags.size(); ++i)
        for (const auto& [language, cell] : tagged[i])
          placed.tagged[i][language] = tag_in(record.cell[cell]);
      if (image) placed.object.image = first_picture(record.cell[*image]);
      if (floor) placed.floor = record.cell[*floor];
      if (facing) placed.facing = number_of(record.cell[*facing]);
      if (position.size() == 2 && position[0] && position[1]) {
        const auto x = number_of(record.cell[*position[0]]),
                   y = number_of(record.cell[*position[1]]);
        if (x && y) placed.position = Vec2{*x, *y};
      }
    }
    return objects;
  }

  void add_object(const Placed& placed, const fs::path& file) {
    const Place place = place_of(file, std::max<std::uint32_t>(placed.object.line, 1));
    const std::string id = exhibit_id(placed.object.id);
    if (id.empty())
      return tell(Severity::Warning, place, "object-without-id", "this object has no number",
                  "give it one in the catalogue");
    if (!seen_.insert(id).second)
      return tell(Severity::Warning, place, "duplicate-id",
                  fmt::format("there are two objects with the id '{}', and the first is taken", id),
                  "give each a number of its own in the catalogue");
    const auto known = index_.find(id);
    if (known == index_.end() && !placed.position) {
      ++counts_.without_place;
      return;
    }
    const bool is_new = known == index_.end();
    if (is_new) start_exhibit(id, place);
    ExhibitSection& exhibit =
        config_.exhibits[is_new ? config_.exhibits.size() - 1 : known->second];
    take_place(placed, place, exhibit);
    merge_texts("title", id, placed.object.title, place, exhibit.title);
    merge_texts("text", id, placed.object.text, place, exhibit.text);
    for (std::size_t i = 0; i < tags.size(); ++i)
      take_tags(tags[i], placed.tagged[i], place, exhibit);
    take_image(placed.object, place, exhibit);
  }

  void start_exhibit(const std::string& id, const Place& place) {
    ExhibitSection exhibit;
    exhibit.place = place;
    exhibit.id = {id, place, true};
    for (Place* each :
         {&exhibit.floor.place, &exhibit.position.place, &exhibit.facing.place, &exhibit.view.place,
          &exhibit.image.place, &exhibit.title.place, &exhibit.text.place})
      *each = place;
    config_.exhibits.push_back(std::move(exhibit));
  }

  void take_place(const Placed& placed, const Place& place, ExhibitSection& exhibit) {
    if (!exhibit.position.given && placed.position)
      exhibit.position = {*placed.position, place, true};
    if (!exhibit.facing.given && exhibit.facing.place.range == exhibit.place.range)
      exhibit.facing = {placed.facing.value_or(270), place, true};
    if (exhibit.floor.given || placed.floor.empty()) return;
    const bool is_known = std::ranges::any_of(
        config_.floors,
        [&](const config::FloorSection& floor) { return floor.name.value == placed.floor; });
    if (is_known)
      exhibit.floor = {placed.floor, place, true};
    else
      tell(Severity::Error, place, "unknown-floor",
           fmt::format("there is no floor '{}'", placed.floor), "write it as in museum.toml");
  }

  /// Adds the texts of a catalogue where nothing is written by hand.
  void merge_texts(std::string_view what, const std::string& id,
                   const std::map<std::string, std::string, std::less<>>& texts, const Place& place,
                   Located<LocatedTexts>& out) {
    for (const auto& [tag, text] : texts) {
      if (text.empty()) continue;
      const std::string& language = tag == "und" ? config_.languages.front() : tag;
      if (std::ranges::find(config_.languages, language) == config_.languages.end()) continue;
      const auto [entry, is_new] =
          out.value.try_emplace(language, Located<std::string>{text, place, true});
      out.given = true;
      if (!is_new && entry->second.value != text && entry->second.place.file != place.file)
        tell(Severity::Warning, entry->second.place, "written-by-hand",
             fmt::format("the {} of exhibit '{}' in '{}' is written by hand, and wins", what, id,
                         language),
             fmt::format("{}:{} says: {}", config_.files[static_cast<std::size_t>(place.file)],
                         place.range.line, shortened(text)));
    }
    if (!index_.contains(id)) fill_up(what, id, place, out);
  }

  /// Where nothing is written by hand. What belongs together has the same words: other capitals are
  /// taken for a slip. A tag need not be written in every language.
  void take_tags(const Tag& tag, const Texts& texts, const Place& place, ExhibitSection& exhibit) {
    Located<LocatedTexts>& out = exhibit.*tag.texts;
    if (out.given && out.place.file != place.file) return;
    LocatedTexts taken;
    for (const auto& [language, text] : texts) {
      if (text.empty()) continue;
      if (std::ranges::find(config_.languages, language) == config_.languages.end()) continue;
      const auto [usual, is_new] =
          spelt_.try_emplace({tag.name, language, import::lower_case(text)}, text, place);
      const auto& [words, first] = usual->second;
      if (words != text)
        tell(Severity::Warning, place, "tag-spelt-otherwise",
             fmt::format("the {} '{}' is taken for '{}'", tag.name, text, words),
             fmt::format("write it as in line {}", first.range.line));
      taken.emplace(language, Located<std::string>{words, place, true});
    }
    if (taken.empty()) return;
    for (const auto& [language, text] : taken)
      for (const config::TextFault& fault :
           config::faults_of(text.value, config::fonts_of(config_), config::room_for_title))
        tell(Severity::Warning, place, fault.code,
             fmt::format("the {} of exhibit '{}' {} in '{}'{}", tag.name, exhibit.id.value,
                         fault.what, language, fault.why),
             fault.hint);
    out = {std::move(taken), place, true};
  }

  static std::string shortened(std::string text) {
    constexpr std::size_t longest = 80;
    std::ranges::replace(text, '\n', ' ');
    if (text.size() <= longest) return text;
    std::size_t end = longest;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
    return text.substr(0, end) + "...";
  }

  /// Languages that lack the text show it in the first that has it.
  void fill_up(std::string_view what, const std::string& id, const Place& place,
               Located<LocatedTexts>& texts) {
    if (texts.value.empty()) return;
    const auto first = std::ranges::find_if(config_.languages, [&](const std::string& language) {
      return texts.value.contains(language);
    });
    if (first == config_.languages.end()) return;
    const Located<std::string> shown = texts.value.at(*first);
    for (const std::string& language : config_.languages) {
      if (!texts.value.try_emplace(language, shown).second) continue;
      tell(Severity::Warning, place, "missing-translation",
           fmt::format("the {} of exhibit '{}' is not translated into '{}', and is shown in '{}'",
                       what, id, language, *first),
           "docent-content translate writes what is missing for translators");
    }
    check_letters(what, id, place, texts.value);
  }

  /// What is written by hand is looked at already.
  void check_letters(std::string_view what, const std::string& id, const Place& place,
                     const LocatedTexts& texts) {
    const std::size_t room = what == "title" ? config::room_for_title : config::room_for_text;
    for (const auto& [tag, text] : texts) {
      if (text.place.file != place.file) continue;
      for (const config::TextFault& fault :
           config::faults_of(text.value, config::fonts_of(config_), room))
        tell(Severity::Warning, text.place, fault.code,
             fmt::format("the {} of exhibit '{}' {} in '{}'{}", what, id, fault.what, tag,
                         fault.why),
             fault.hint);
    }
  }

  void take_image(const CollectionObject& object, const Place& place, ExhibitSection& exhibit) {
    const bool by_hand =
        !exhibit.image.value.empty() || exhibit.image.place.range != exhibit.place.range;
    if (by_hand || object.image.empty()) return;
    if (object.image.find("://") != std::string::npos) {
      ++counts_.in_the_web;
      return;
    }
    const std::string beside =
        fs::path(object.file).parent_path().lexically_relative(config_.folder).string();
    std::string hint;
    for (const std::string& folder : {beside, std::string(), std::string("images")}) {
      const std::string name = (fs::path(folder) / object.image).lexically_normal().string();
      const auto fault = paths_.fault(name);
      if (!fault) {
        exhibit.image = {name, place, true};
        return;
      }
      if (fault->hint.starts_with("it is called") || fault->hint.starts_with("did you mean"))
        hint = fault->hint;
    }
    tell(Severity::Warning, place, "missing-file",
         fmt::format("there is no picture '{}'", object.image),
         hint.empty() ? "put it beside the catalogue or into images/" : hint);
  }

  void tell_counts(const fs::path& file, std::size_t objects) {
    if (counts_.without_place > 0)
      tell(Severity::Warning, place_of(file, 0), "no-place",
           fmt::format("{} of {} objects have no place in the museum and are left out",
                       counts_.without_place, objects),
           "write position = [\"east\", \"north\"] in [source], or a [[exhibit]] with the id and "
           "its "
           "position");
    if (counts_.in_the_web > 0)
      tell(Severity::Warning, place_of(file, 0), "picture-in-the-web",
           fmt::format("{} pictures are in the web, and nothing is fetched from there",
                       counts_.in_the_web),
           "save them beside the catalogue or in images/, and name those files");
  }

  /// A title is all that a screen has of an exhibit.
  void drop_incomplete() {
    const auto lacks_title = [&](const ExhibitSection& exhibit) {
      return exhibit.title.value.empty();
    };
    for (std::size_t i = by_hand_; i < config_.exhibits.size(); ++i)
      if (lacks_title(config_.exhibits[i]))
        tell(Severity::Warning, config_.exhibits[i].place, "object-without-title",
             fmt::format("object '{}' has no title and is left out", config_.exhibits[i].id.value),
             "give it one in the catalogue");
    const auto first = config_.exhibits.begin() + static_cast<std::ptrdiff_t>(by_hand_);
    config_.exhibits.erase(std::remove_if(first, config_.exhibits.end(), lacks_title),
                           config_.exhibits.end());
  }

  struct Counts {
    std::size_t without_place = 0, in_the_web = 0;
  };

  config::MuseumConfig& config_;
  Report& report_;
  config::MuseumPaths paths_;
  std::size_t by_hand_ = 0;
  std::map<std::string, std::size_t, std::less<>> index_;  ///< Exhibits that are written by hand.
  std::set<std::string> seen_;
  /// How a tag is written, and where for the first time; by its name, its language, and its words
  /// in lower case.
  std::map<std::tuple<std::string_view, std::string, std::string>, std::pair<std::string, Place>>
      spelt_;
  Counts counts_;
};

}  // namespace

void add_collections(config::MuseumConfig& config, Report& report) {
  if (!config.sources.empty()) CollectionAdder(config, report).run();
}

}  // namespace docent::compile
