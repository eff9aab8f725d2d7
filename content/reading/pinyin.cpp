#include "content/reading/pinyin.h"

#include <unicode/translit.h>
#include <unicode/uscript.h>

#include <memory>

#include "content/content_error.h"

namespace docent::reading {
namespace {

/// Looked up once: making it takes longer than all that it is used for.
const icu::Transliterator& to_pinyin() {
  static const std::unique_ptr<icu::Transliterator> made = [] {
    UErrorCode status = U_ZERO_ERROR;
    std::unique_ptr<icu::Transliterator> all(icu::Transliterator::createInstance(
        "Han-Latin; Latin-ASCII; Lower", UTRANS_FORWARD, status));
    if (U_FAILURE(status) || !all)
      throw content::ContentError(Errc::Environment, {}, "no-readings",
                                  "ICU has no table of Chinese readings", "install libicu72");
    return all;
  }();
  return *made;
}

bool has_chinese(const icu::UnicodeString& text) {
  for (std::int32_t i = 0; i < text.length(); i = text.moveIndex32(i, 1)) {
    UErrorCode status = U_ZERO_ERROR;
    if (uscript_getScript(text.char32At(i), &status) == USCRIPT_HAN) return true;
  }
  return false;
}

}  // namespace

std::string pinyin_of(std::string_view text) {
  icu::UnicodeString letters = icu::UnicodeString::fromUTF8(
      icu::StringPiece(text.data(), static_cast<std::int32_t>(text.size())));
  if (!has_chinese(letters)) return {};
  to_pinyin().transliterate(letters);
  std::string read;
  letters.toUTF8String(read);
  return read;
}

}  // namespace docent::reading
