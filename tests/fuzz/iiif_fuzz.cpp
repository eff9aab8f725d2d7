#include <cstddef>
#include <cstdint>
#include <string_view>

#include "content/content_error.h"
#include "content/import/collection/iiif.h"

using namespace docent;

/// Any bytes are a manifest or a collection, or are refused with a sentence.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const import::Collection read =
        import::read_iiif("fuzz.json", {reinterpret_cast<const char*>(data), size});
    for (const import::CollectionDoubt& doubt : read.doubts)
      if (doubt.message.empty() || doubt.line == 0) __builtin_trap();
  } catch (const content::ContentError& error) {
    if (std::string_view(error.what()).empty() || error.code.empty()) __builtin_trap();
  }
  return 0;
}
