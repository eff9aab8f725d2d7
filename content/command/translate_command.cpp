#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <span>

#include "config/diagnostic_text.h"
#include "config/language_tag.h"
#include "content/command/commands.h"
#include "content/command/museum_texts.h"
#include "content/compile/add_collections.h"
#include "content/content_error.h"
#include "content/import/translation/translation.h"
#include "content/read_source.h"
#include "content/write/replace_file.h"
#include "content/write/toml_edit.h"
#include "platform/file/read_file.h"
#include "runtime/model/result.h"

namespace docent::command {

namespace {

namespace fs = std::filesystem;
using write::TomlEdit;

struct TranslateRequest {
  std::string museum, out, in, from, to;
};

config::MuseumConfig load(const std::string& museum) {
  config::Loaded<config::MuseumConfig> loaded = config::load_museum_config(museum);
  if (!loaded.value) {
    config::tell(loaded.diagnostics);
    throw content::ContentError(museum, 0, 0, "unusable-museum", "this museum cannot be read",
                                "docent-content check says more");
  }
  compile::Report ignored;  // `check` tells
  compile::add_collections(*loaded.value, ignored);
  return std::move(*loaded.value);
}

std::string as_csv_or_xliff(const std::string& file, const import::Translation& translation) {
  return file.ends_with(".csv") ? import::write_translation_csv(translation)
                                : import::write_xliff(translation);
}

int write_out(const TranslateRequest& request) {
  const config::MuseumConfig config = load(request.museum);
  import::Translation translation{
      .from = request.from.empty() ? config.languages.front() : request.from,
      .to = request.to,
      .units = {}};
  if (!config::is_language_tag(translation.to))
    throw content::ContentError(
        Errc::WrongUsage, "--to", "unknown-language",
        fmt::format("there is no language tag '{}'", translation.to),
        fmt::format("did you mean {}?", config::meant_language(translation.to)));
  std::size_t missing = 0;
  for (const MuseumText& text : museum_texts(config)) {
    const auto* source = written_in(text, translation.from);
    if (source == nullptr) continue;
    const auto* target = written_in(text, translation.to);
    missing += target == nullptr ? 1 : 0;
    translation.units.push_back({.id = text.id,
                                 .source = source->value,
                                 .target = target == nullptr ? std::string() : target->value});
  }
  const std::string bytes = as_csv_or_xliff(request.out, translation);
  write::replace_file(request.out, std::as_bytes(std::span(bytes)));
  fmt::print(stderr, "wrote {}: {} texts, {} of them not translated yet\n", request.out,
             translation.units.size(), missing);
  return 0;
}

/// Takes translations in: edits the museum's own files, and says what it could not.
class TakingIn {
 public:
  TakingIn(const TranslateRequest& request, const config::MuseumConfig& config,
           const import::Translation& translation)
      : request_(request), config_(config), translation_(translation) {}

  int run() {
    std::map<std::string, MuseumText, std::less<>> texts;
    for (MuseumText& text : museum_texts(config_)) texts.emplace(text.id, std::move(text));
    for (const import::TranslationUnit& unit : translation_.units) {
      const auto known = texts.find(unit.id);
      if (known == texts.end())
        warn(unit, "unknown-text", fmt::format("the museum has no text '{}'", unit.id),
             "it was renamed or removed since the file was written");
      else
        take(unit, known->second);
    }
    write_files();
    config::tell(doubts_);
    fmt::print(stderr, "{} texts taken in in '{}', {} were so already, {} are not translated\n",
               taken_, translation_.to, same_, untranslated_);
    return 0;
  }

 private:
  void warn(const import::TranslationUnit& unit, std::string code, std::string message,
            std::string hint) {
    doubts_.push_back({.file = request_.in,
                       .line = unit.line,
                       .column = unit.line > 0 ? 1U : 0U,
                       .severity = Severity::Warning,
                       .code = std::move(code),
                       .message = std::move(message),
                       .hint = std::move(hint)});
  }

  void take(const import::TranslationUnit& unit, const MuseumText& text) {
    if (unit.is_partial)
      return warn(
          unit, "partly-translated",
          fmt::format("only a part of '{}' is translated, and it is left as it is", unit.id),
          "translate its other sentences, too");
    if (unit.target.find_first_not_of(" \t\r\n") == std::string::npos) {
      ++untranslated_;
      return;
    }
    const auto* source = written_in(text, translation_.from);
    if (source != nullptr && !unit.source.empty() && source->value != unit.source)
      warn(unit, "outdated-translation",
           fmt::format("'{}' has changed since it went to the translator", unit.id),
           fmt::format("the translation is taken; look whether it still fits: {}", source->value));
    const auto* target = written_in(text, translation_.to);
    if (target != nullptr && target->value == unit.target)
      ++same_;
    else
      edit(unit, text, source, target);
  }

  [[nodiscard]] bool is_toml(const config::Place& place) const {
    return config_.files[static_cast<std::size_t>(place.file)].ends_with(".toml");
  }

  void edit(const import::TranslationUnit& unit, const MuseumText& text,
            const config::Located<std::string>* source,
            const config::Located<std::string>* target) {
    if (target != nullptr && is_toml(target->place))
      return add(target->place, TomlEdit::Kind::Replace, write::toml_text(unit.target));
    if (source != nullptr && is_toml(source->place)) {
      const std::string key = key_of(source->place);
      if (key.ends_with(translation_.from))
        return add(source->place, TomlEdit::Kind::InsertAfter,
                   key.substr(0, key.size() - translation_.from.size()) + quoted_tag() + " = " +
                       write::toml_text(unit.target));
    }
    if (text.exhibit.empty())
      return warn(unit, "not-taken", fmt::format("'{}' could not be written by itself", unit.id),
                  fmt::format("write it by hand: {}", unit.target));
    if (is_toml(text.owner))
      return add(text.owner, TomlEdit::Kind::InsertAfter, line_of(unit, text));
    std::string& table = new_[text.exhibit];
    table += line_of(unit, text) + "\n";
    ++taken_;
  }

  [[nodiscard]] std::string quoted_tag() const { return translation_.to; }

  [[nodiscard]] std::string line_of(const import::TranslationUnit& unit,
                                    const MuseumText& text) const {
    return fmt::format("{}.{} = {}", text.what, translation_.to, write::toml_text(unit.target));
  }

  [[nodiscard]] std::string key_of(const config::Place& place) {
    return write::key_before(text_of(place.file), place.range.line, place.range.column);
  }

  const std::string& text_of(config::FileIndex file) {
    const auto [entry, is_new] = originals_.try_emplace(file);
    if (is_new)
      entry->second = content::read_text_source(config_.files[static_cast<std::size_t>(file)]);
    return entry->second;
  }

  void add(const config::Place& place, TomlEdit::Kind kind, std::string with) {
    edits_[place.file].push_back({kind, place.range.line, place.range.column, std::move(with)});
    ++taken_;
  }

  void write_files() {
    for (auto& [file, edits] : edits_)
      replace(config_.files[static_cast<std::size_t>(file)],
              write::edited(text_of(file), std::move(edits)));
    if (new_.empty()) return;
    const fs::path file = config_.folder / "exhibits" / "translations.toml";
    std::string text = file::is_there(file)
                           ? content::read_text_source(file)
                           : "# Translations of exhibits that come from [source]; written by "
                             "docent-content translate, and yours to change.\n";
    for (const auto& [id, lines] : new_)
      text += fmt::format("\n[[exhibit]]\nid = \"{}\"\n{}", id, lines);
    std::error_code exists;
    fs::create_directories(file.parent_path(), exists);
    replace(file, text);
  }

  static void replace(const fs::path& file, const std::string& text) {
    write::replace_file(file, std::as_bytes(std::span(text)));
  }

  const TranslateRequest& request_;
  const config::MuseumConfig& config_;
  const import::Translation& translation_;
  std::map<config::FileIndex, std::string> originals_;
  std::map<config::FileIndex, std::vector<TomlEdit>> edits_;
  std::map<std::string, std::string> new_;  ///< Lines of exhibits that no TOML file has, by id.
  std::vector<Diagnostic> doubts_;
  std::size_t taken_ = 0, same_ = 0, untranslated_ = 0;
};

int take_in(const TranslateRequest& request) {
  const std::string bytes = content::read_source(request.in);
  import::Translation translation = request.in.ends_with(".csv")
                                        ? import::read_translation_csv(request.in, bytes)
                                        : import::read_xliff(request.in, bytes);
  if (!request.to.empty()) translation.to = request.to;
  if (translation.to.empty())
    throw content::ContentError(request.in, 1, 1, "unreadable-translation",
                                "the file does not say into which language it is translated",
                                "name it: --to LANGUAGE");
  return TakingIn(request, load(request.museum), translation).run();
}

int run_translate(const TranslateRequest& request) {
  const bool writes = !request.out.empty();
  if (writes == !request.in.empty() || (writes && request.to.empty()))
    throw content::ContentError(Errc::WrongUsage, "docent-content translate", "wrong-usage",
                                "either --out FILE --to LANGUAGE or --in FILE is wanted",
                                "docent-content translate --help says more");
  return writes ? write_out(request) : take_in(request);
}

}  // namespace

terminal::Command translate_command() {
  using terminal::Times;
  const auto request = std::make_shared<TranslateRequest>();
  return {.name = "translate",
          .manual = "writes a museum's texts for translators, and takes translations in",
          .options = {{"MUSEUM", terminal::folder("MUSEUM", request->museum), "A museum's folder",
                       Times::Once},
                      {"--out", terminal::file("FILE", request->out),
                       "Write the texts: XLIFF 2.0, or CSV where the name ends in .csv"},
                      {"--in", terminal::file("FILE", request->in),
                       "Take translations in: XLIFF 1.2 or 2, or CSV where the name ends in .csv; "
                       "the museum's files are changed where they say something else"},
                      {"--from", terminal::text("LANGUAGE", request->from),
                       "The language to translate from", Times::AtMostOnce, "the museum's first"},
                      {"--to", terminal::text("LANGUAGE", request->to),
                       "The language to translate into; files that come in say it themselves"}},
          .run = [request] { return run_translate(*request); }};
}

}  // namespace docent::command
