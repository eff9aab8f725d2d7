#include "content/compile/own_typefaces.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "config/shown_letters.h"
#include "content/content_error.h"
#include "content/import/font/read_font.h"
#include "content/read_source.h"
#include "runtime/schema/rows.h"
#include "runtime/search/fold.h"

namespace docent::compile {
namespace {

/// How often each letter is read, by the language's tag. A store of schema::tables.
struct LetterCount {
  const Museum& museum;
  std::map<std::string, std::map<char32_t, std::size_t>, std::less<>> of{};

  void row(std::string_view /*table*/, std::size_t /*id*/, const auto& /*value*/) {}
  void rows(std::string_view /*table*/, const auto& /*values*/) {}
  void rows_of(std::string_view /*table*/, std::string_view /*parent*/, std::size_t /*id*/,
               const auto& /*values*/) {}
  void texts(std::string_view subject, std::size_t owner, const auto& texts) {
    if (subject == "museum.reading") return;
    for (const auto& [key, text] : texts)
      count(subject == "language.word" ? museum.languages[owner].tag : key, text);
  }

 private:
  void count(const std::string& tag, std::string_view text) {
    std::map<char32_t, std::size_t>& letters = of[tag];
    while (!text.empty()) {
      const auto [letter, length] = search::decode(text);
      if (letter > U' ') ++letters[letter];
      text.remove_prefix(length);
    }
  }
};

/// What of a language's letters a font has.
struct Coverage {
  std::size_t held = 0, all = 0;
  std::vector<char32_t> missing;

  bool is_at_least(std::size_t percent) const noexcept {
    return all > 0 && 100 * held >= percent * all;
  }
};

Coverage coverage(const std::map<char32_t, std::size_t>& letters,
                  const std::vector<char32_t>& font) {
  Coverage coverage;
  for (const auto& [letter, times] : letters) {
    coverage.all += times;
    if (std::ranges::binary_search(font, letter))
      coverage.held += times;
    else
      coverage.missing.push_back(letter);
  }
  return coverage;
}

std::string some_of(const std::vector<char32_t>& letters) {
  constexpr std::size_t most = 6;
  std::vector<std::string> names;
  for (const char32_t letter : letters)
    if (names.size() < most) names.push_back(fmt::format("U+{:04X}", std::uint32_t{letter}));
  return fmt::format("{}{}", fmt::join(names, ", "), letters.size() > most ? ", ..." : "");
}

class TypefaceReader {
 public:
  TypefaceReader(const config::MuseumConfig& config, Museum& museum, Report& report)
      : config_(config), museum_(museum), report_(report), letters_{museum} {
    schema::tables(letters_, std::as_const(museum));
  }

  void read(const config::Located<config::LocatedList>& files, Typeface& typeface) {
    std::vector<char32_t> letters;
    for (const config::Located<std::string>& file : files.value) {
      if (file.value.empty()) continue;  // told of
      const std::optional<import::Font> font = load(file);
      if (!font || !is_of(typeface.family, *font, file)) continue;
      const bool is_first = typeface.family.empty();
      typeface.family = font->family;
      if (font->forbids_embedding)
        warn(file.place, "font-licence",
             fmt::format("'{}' says that its licence forbids passing it on", file.value),
             "ask who made it, or take one under the SIL Open Font License");
      if (is_first) {
        letters = font->letters;
        continue;
      }
      std::vector<char32_t> both;
      std::ranges::set_intersection(letters, font->letters, std::back_inserter(both));
      letters = std::move(both);
    }
    if (!typeface.family.empty()) find_languages(files.place, letters, typeface);
  }

 private:
  std::optional<import::Font> load(const config::Located<std::string>& file) {
    try {
      const std::string text = content::read_source(config_.folder / file.value, "unreadable-font");
      const auto bytes = std::as_bytes(std::span(text));
      if (bytes.size() > FontFile::largest)
        throw content::ContentError("", 0, 0, "font-large",
                                    fmt::format("this font has {} MB, and may have {}",
                                                bytes.size() >> 20U, FontFile::largest >> 20U),
                                    "install it on the kiosks as a package, or take a smaller one");
      import::Font font = import::read_font(bytes);
      keep(file, bytes);
      return font;
    } catch (const content::ContentError& fault) {
      report_.add(config::diagnostic_at(config_, file.place, fault.code,
                                        fmt::format("'{}': {}", file.value, fault.what()), {},
                                        fault.hint));
      return {};
    }
  }

  /// A file that titles and texts share is kept once.
  void keep(const config::Located<std::string>& file, std::span<const std::byte> bytes) {
    if (std::ranges::find(museum_.fonts, file.value, &FontFile::name) != museum_.fonts.end())
      return;
    if (museum_.fonts.size() == Typeface::most_files)
      return report_.add(
          config::diagnostic_at(config_, file.place, "out-of-range",
                                fmt::format("there are more than {} fonts", Typeface::most_files),
                                {}, "regular and semibold of each family are enough"));
    museum_.fonts.push_back({file.value, {bytes.begin(), bytes.end()}});
  }

  bool is_of(const std::string& family, const import::Font& font,
             const config::Located<std::string>& file) {
    if (family.empty() || family == font.family) return true;
    report_.add(config::diagnostic_at(
        config_, file.place, "bad-value",
        fmt::format("'{}' is of the family '{}', and the one before it of '{}'", file.value,
                    font.family, family),
        {}, "name fonts of one family: the house has one for titles and one for texts"));
    return false;
  }

  void find_languages(const config::Place& place, const std::vector<char32_t>& font,
                      Typeface& typeface) {
    constexpr std::size_t enough = 97, half = 50;
    for (std::uint32_t language = 0; language < museum_.languages.size(); ++language) {
      const std::string& tag = museum_.languages[language].tag;
      const Coverage found = coverage(letters_.of[tag], font);
      const bool leads = found.is_at_least(enough);
      if (leads) typeface.languages.push_back(language);
      std::vector<char32_t> nowhere;
      std::ranges::copy_if(found.missing, std::back_inserter(nowhere),
                           [](char32_t letter) { return !config::is_shown(letter); });
      if (!nowhere.empty())
        warn(place, "missing-letters",
             fmt::format("neither '{}' nor the kiosk's own fonts have letters of '{}': {}",
                         typeface.family, tag, some_of(nowhere)),
             "take a font that has them, or write it otherwise");
      if (leads && found.missing.size() > nowhere.size())
        warn(place, "missing-letters",
             fmt::format("'{}' lacks letters of '{}', which come from the kiosk's own fonts: {}",
                         typeface.family, tag, some_of(found.missing)),
             "take a font that has them, or leave it so");
      if (!leads && found.is_at_least(half))
        warn(
            place, "missing-letters",
            fmt::format("'{}' has only {} of 100 letters of '{}', which keeps the kiosk's own "
                        "font; it lacks {}",
                        typeface.family, 100 * found.held / found.all, tag, some_of(found.missing)),
            "take a font that has them, or leave it so");
    }
    if (typeface.languages.empty())
      warn(place, "missing-letters",
           fmt::format("'{}' is used for no language of the museum", typeface.family),
           "take a font with letters of these languages");
  }

  void warn(const config::Place& place, std::string code, std::string message, std::string hint) {
    Diagnostic diagnostic = config::diagnostic_at(config_, place, std::move(code),
                                                  std::move(message), {}, std::move(hint));
    diagnostic.severity = Severity::Warning;
    report_.add(std::move(diagnostic));
  }

  const config::MuseumConfig& config_;
  Museum& museum_;
  Report& report_;
  LetterCount letters_;
};

}  // namespace

void read_typefaces(const config::MuseumConfig& config, Museum& museum, Report& report) {
  const config::LookSection& look = config.look;
  if (look.title_font.value.empty() && look.text_font.value.empty()) return;
  TypefaceReader reader(config, museum, report);
  reader.read(look.title_font, museum.livery.titles);
  reader.read(look.text_font, museum.livery.text);
}

}  // namespace docent::compile
