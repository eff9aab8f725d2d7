#include "config/language_tag.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace docent::config::language_tag_test {
namespace {

TEST(LanguageTag, KnowsLanguagesScriptsAndRegions) {
  for (const char* tag : {"en", "zh", "zh-Hant", "pt-BR", "es-419", "tlh", "sr-Latn-RS"})
    EXPECT_TRUE(is_language_tag(tag)) << tag;
  for (const char* tag :
       {"", "EN", "english", "klingon", "xx", "pt_BR", "pt-br", "zh-hant", "e", "-"})
    EXPECT_FALSE(is_language_tag(tag)) << tag;
}

TEST(LanguageTag, GuessesWhatWasMeant) {
  EXPECT_EQ(meant_language("EN"), "en");
  EXPECT_EQ(meant_language("pt_br"), "pt-BR");
  EXPECT_EQ(meant_language("zh-hant"), "zh-Hant");
  EXPECT_EQ(meant_language("English"), "en");
  EXPECT_EQ(meant_language("germn"), "de");
  EXPECT_EQ(meant_language("cz"), "cs");
  EXPECT_EQ(meant_language("klingon"), "tlh");
  EXPECT_EQ(meant_language("qqqqqqq"), "");
}

RC_GTEST_PROP(LanguageTag, WhatIsOfferedIsATag, (const std::string& word)) {
  const std::string meant = meant_language(word);
  RC_ASSERT(meant.empty() || is_language_tag(meant));
}

}  // namespace
}  // namespace docent::config::language_tag_test
