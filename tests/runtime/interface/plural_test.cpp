#include "runtime/interface/plural.h"

#include <gtest/gtest.h>
#include <unicode/locid.h>
#include <unicode/plurrule.h>
#include <unicode/ures.h>

#include <memory>
#include <span>
#include <string>

namespace docent::interface::plural_test {
namespace {

std::span<const icu::Locale> locales() {
  std::int32_t count = 0;
  const icu::Locale* first = icu::Locale::getAvailableLocales(count);
  return {first, static_cast<std::size_t>(count)};
}

std::string tag_of(const icu::Locale& locale) {
  UErrorCode status = U_ZERO_ERROR;
  return locale.toLanguageTag<std::string>(status);
}

/// The languages that CLDR has rules for, as ICU carries them.
class KnownLanguages {
 public:
  bool has(const char* language) const {
    UErrorCode status = U_ZERO_ERROR;
    std::int32_t length = 0;
    ures_getStringByKey(languages_.get(), language, &length, &status);
    return U_SUCCESS(status) != 0;
  }

 private:
  using Resource = std::unique_ptr<UResourceBundle, decltype(&ures_close)>;
  static Resource languages() {
    UErrorCode status = U_ZERO_ERROR;
    const Resource plurals(ures_openDirect(nullptr, "plurals", &status), ures_close);
    return {ures_getByKey(plurals.get(), "locales", nullptr, &status), ures_close};
  }
  Resource languages_ = languages();
};

TEST(PluralForm, OfEachNumberIsWhatIcuSaysInEachLanguageThatCldrKnows) {
  const KnownLanguages known;
  std::size_t compared = 0;
  for (const icu::Locale& locale : locales()) {
    if (!known.has(locale.getLanguage())) continue;
    ++compared;
    UErrorCode status = U_ZERO_ERROR;
    const std::unique_ptr<icu::PluralRules> rules(icu::PluralRules::forLocale(locale, status));
    ASSERT_TRUE(U_SUCCESS(status)) << locale.getName();
    const std::string tag = tag_of(locale);
    for (std::int32_t n = 0; n <= 2200; ++n) {
      std::string form;
      rules->select(n).toUTF8String(form);
      ASSERT_EQ(plural_form(tag, n), form) << tag << ' ' << n;
    }
  }
  EXPECT_GT(compared, 600U);
}

TEST(PluralForm, OfALanguageThatNobodyKnowsIsThatOfMost) {
  EXPECT_EQ(plural_form("tlh", 1), "one");
  EXPECT_EQ(plural_form("tlh", 7), "other");
  EXPECT_EQ(plural_form("", 1), "one");
}

}  // namespace
}  // namespace docent::interface::plural_test
