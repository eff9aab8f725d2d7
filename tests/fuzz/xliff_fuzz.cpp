#include <cstddef>
#include <cstdint>
#include <string_view>

#include "content/content_error.h"
#include "content/import/translation/translation.h"

using namespace docent;

/// Any bytes are a translation, or are refused with a sentence; what is read and written again
/// keeps its units.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const import::Translation read = import::read_xliff("fuzz.xlf", text);
    for (const import::TranslationUnit& unit : read.units)
      if (unit.id.empty() || unit.line == 0) __builtin_trap();
    (void)import::write_xliff(read);
  } catch (const content::ContentError& error) {
    if (std::string_view(error.what()).empty() || error.code.empty()) __builtin_trap();
  }
  return 0;
}
