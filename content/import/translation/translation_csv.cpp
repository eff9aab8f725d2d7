#include <fmt/format.h>

#include <algorithm>

#include "content/content_error.h"
#include "content/import/collection/csv.h"
#include "content/import/translation/translation.h"

namespace docent::import {

std::string write_translation_csv(const Translation& translation) {
  std::string text = fmt::format("\xEF\xBB\xBFid,{},{}\r\n", translation.from, translation.to);
  for (const TranslationUnit& unit : translation.units)
    text += fmt::format("{},{},{}\r\n", csv_cell(unit.id), csv_cell(unit.source),
                        csv_cell(unit.target));
  return text;
}

Translation read_translation_csv(const std::string& file, std::string_view bytes) {
  const CsvTable table = read_csv(bytes);
  if (table.column.size() < 3 || table.column[0] != "id")
    throw content::ContentError(
        file, 1, 1, "unreadable-translation",
        fmt::format("the columns are {}, and should be id and two languages",
                    fmt::join(table.column, ", ")),
        "send back the file that docent-content translate --out wrote, with its first line");
  Translation translation{.from = table.column[1], .to = table.column[2], .units = {}};
  for (const CsvRecord& record : table.record)
    translation.units.push_back({.id = record.cell[0],
                                 .source = record.cell[1],
                                 .target = record.cell[2],
                                 .line = record.line});
  return translation;
}

}  // namespace docent::import
