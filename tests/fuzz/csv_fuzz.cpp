#include <cstddef>
#include <cstdint>
#include <string_view>

#include "content/import/collection/csv.h"
#include "content/import/collection/plain_text.h"
#include "platform/file/text_encoding.h"

using namespace docent;

/// The first byte chooses the encoding, the second the separator; the rest is a file. Whatever it
/// says, every row has as many cells as there are columns, and every cell is UTF-8.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2) return 0;
  constexpr const char* encodings[] = {"", "utf-8", "windows-1252", "utf-16"};
  constexpr char separators[] = {'\0', ',', ';', '\t'};
  const import::CsvForm form{.encoding = encodings[data[0] % 4],
                             .separator = separators[data[1] % 4]};
  const import::CsvTable table =
      import::read_csv({reinterpret_cast<const char*>(data) + 2, size - 2}, form);
  std::uint32_t line = 0;
  for (const import::CsvRecord& record : table.record) {
    if (record.cell.size() != table.column.size() || record.line <= line) __builtin_trap();
    line = record.line;
    for (const std::string& cell : record.cell)
      if (file::shown_as_utf8(cell) != cell || import::plain_text(cell).size() > cell.size())
        __builtin_trap();
  }
  return 0;
}
