#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace docent::import {

/// A text and its translation.
struct TranslationUnit {
  std::string id;      ///< "jade-disc.title".
  std::string source;  ///< As it was when it went out.
  std::string target;  ///< Empty: not translated yet.
  std::uint32_t line = 0;
  bool is_partial = false;  ///< Some of its segments have no target.
};

/// What goes to a translator and comes back.
struct Translation {
  std::string from, to;  ///< Languages (BCP 47).
  std::vector<TranslationUnit> units;
};

/// XLIFF 2.0, which tools of translators read.
std::string write_xliff(const Translation& translation);

/// Reads XLIFF 2.0, 2.1 and 1.2: of inline elements their text. Segments of a unit are joined.
/// Throws ContentError with file and line for what is no XML or no XLIFF.
Translation read_xliff(const std::string& file, std::string_view text);

/// A spreadsheet with the columns id, source language and target language, with a byte order mark
/// so that spreadsheets take it as UTF-8.
std::string write_translation_csv(const Translation& translation);

/// Reads such a spreadsheet, in any encoding and with any separator. Throws ContentError where the
/// three columns are missing.
Translation read_translation_csv(const std::string& file, std::string_view bytes);

}  // namespace docent::import
