#include "content/compile/add_languages.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/museum_folder.h"

namespace docent::compile::add_languages_test {
namespace {

using test::MuseumFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* own_english =
    "name = \"English\"\ndirection = \"left-to-right\"\n[words]\nbegin = \"Begin here\"\n";

struct Added {
  Museum museum;
  std::vector<Diagnostic> told;
};

Added added(const MuseumFolder& folder) {
  Added added;
  const auto loaded = config::load_museum_config(folder.path());
  Report report;
  report.add(loaded.diagnostics);
  if (loaded.value) add_languages(*loaded.value, added.museum, report);
  added.told = report.in_order();
  return added;
}

TEST(AddLanguages, TakesFromTheShippedWordsWhatAMuseumLeavesOut) {
  const MuseumFolder museum;
  museum.write("words/en.toml", own_english);

  const auto [made, told] = added(museum);

  EXPECT_THAT(told, IsEmpty());
  ASSERT_EQ(made.languages.size(), 2U);
  EXPECT_EQ(made.languages[0].words.at("begin"), "Begin here");
  EXPECT_EQ(made.languages[0].words.at("welcome"), "Welcome");
  EXPECT_EQ(made.languages[1].words.size(), made.languages[0].words.size());
}

TEST(AddLanguages, WantsEveryWordOfALanguageThatIsNotShipped) {
  const MuseumFolder museum;
  museum.replace("museum.toml", "\"ar\"]", "\"ar\", \"fi\"]");
  museum.write(
      "words/fi.toml",
      "name = \"suomi\"\ndirection = \"left-to-right\"\n[words]\nwelcom = \"Tervetuloa\"\n");

  const auto [made, told] = added(museum);

  const auto code = [&](std::string_view wanted) {
    return std::ranges::find_if(
        told, [&](const Diagnostic& d) { return d.code == wanted && d.file.ends_with("fi.toml"); });
  };
  ASSERT_NE(code("unknown-key"), told.end());
  EXPECT_EQ(code("unknown-key")->message, "no screen says the word 'welcom'");
  EXPECT_EQ(code("unknown-key")->hint, "did you mean 'welcome'?");
  EXPECT_EQ(code("unknown-key")->line, 4U);
  EXPECT_EQ(code("unknown-key")->column, 1U);
  ASSERT_NE(code("missing-translation"), told.end());
  EXPECT_THAT(code("missing-translation")->hint, HasSubstr("translate from 'en': after_noon = "));
}

TEST(AddLanguages, LooksAtTheWordsThemselves) {
  struct Row {
    const char *old, *with, *code, *message;
  };
  for (const Row& row :
       {Row{"\"Begin here\"", "\" \"", "empty-text", "the word 'begin' is empty in 'en'"},
        Row{"begin = \"Begin here\"", "distance = \"{m} m\"", "wrong-placeholder",
            "the word 'distance' holds {m}, which nothing fills in"},
        Row{"begin = \"Begin here\"", "distance = \"metres\"", "wrong-placeholder",
            "the word 'distance' lacks {n}"},
        Row{"begin = \"Begin here\"", "digits = \"012345678\"", "bad-value",
            "'digits' holds 9 figures, and there are ten"},
        Row{"\"Begin here\"", "\"Begin 👋\"", "unshown-letter",
            "the word 'begin' holds the emoji U+1F44B in 'en', which a kiosk has no letters for"},
        Row{"left-to-right", "right-to-left", "odd-direction",
            "'en' is written from left to right"}}) {
    const MuseumFolder museum;
    museum.write("words/en.toml", own_english);
    museum.replace("words/en.toml", row.old, row.with);

    const auto [made, told] = added(museum);

    ASSERT_EQ(told.size(), 1U) << row.message;
    EXPECT_EQ(told[0].code, row.code);
    EXPECT_EQ(told[0].message, row.message);
    EXPECT_THAT(told[0].file, HasSubstr("words/en.toml"));
    EXPECT_GT(told[0].line, 0U);
    EXPECT_NE(told[0].hint, "");
  }
}

TEST(AddLanguages, TakesAClockOfTwentyFourHoursForOneOfTwiceTwelve) {
  const MuseumFolder museum;
  museum.write("words/en.toml", own_english);
  museum.replace("words/en.toml", "begin = \"Begin here\"", "clock = \"{hour_of_day}.{minute}\"");

  EXPECT_TRUE(added(museum).told.empty());
}

/// Whether the words of a language that is not shipped are complained about, and how.
std::string told_of(const std::string& tag, std::string_view key, const std::string& line = "") {
  const MuseumFolder museum;
  museum.replace("museum.toml", "\"ar\"]", "\"ar\", \"" + tag + "\"]");
  museum.write("words/" + tag + ".toml",
               "name = \"x\"\ndirection = \"left-to-right\"\n[words]\n" + line + "\n");
  std::string all;
  for (const Diagnostic& d : added(museum).told)
    if (d.message.find("'" + std::string(key) + "'") != std::string::npos) all += d.message + '\n';
  return all;
}

TEST(AddLanguages, WantsThePluralFormsOfTheLanguageAndNoOthers) {
  for (const auto* form : {"metres_one", "metres_few", "metres_many", "time_21"})
    EXPECT_THAT(told_of("uk", form), HasSubstr("is not translated")) << form;
  EXPECT_EQ(told_of("uk", "metres_two") + told_of("uk", "metres_other"), "");
  EXPECT_EQ(told_of("pl", "time_21") + told_of("fi", "metres_few"), "");
  EXPECT_THAT(told_of("fi", "metres_other"), HasSubstr("is not translated"));
}

TEST(AddLanguages, TakesTheFormOfZeroWhereALanguageHasIt) {
  EXPECT_EQ(told_of("lv", "metres_zero", "metres_zero = \"{n} metru\""), "");
  EXPECT_THAT(told_of("fi", "metres_zero", "metres_zero = \"{n}\""), HasSubstr("no screen says"));
}

TEST(AddLanguages, LetsANumberBeWrittenOutWhereItsFormIsThatNumbersAlone) {
  EXPECT_EQ(told_of("pl", "metres_one", "metres_one = \"jeden metr\""), "");
  EXPECT_EQ(told_of("sl", "time_two", "time_two = \"dve minuti\""), "");
  EXPECT_THAT(told_of("uk", "metres_one", "metres_one = \"один метр\""), HasSubstr("lacks {n}"));
}

TEST(AddLanguages, TakesEachShippedLanguageAsAMuseumsOwn) {
  for (const std::string tag : {"ar", "de", "es", "fr", "he", "hi", "ja", "ko", "ru", "th", "zh"}) {
    const MuseumFolder museum;
    museum.write("words/" + tag + ".toml",
                 test::text_of(test::source_dir() / "config/words" / (tag + ".toml")));
    if (tag != "ar") museum.replace("museum.toml", "\"ar\"]", "\"ar\", \"" + tag + "\"]");

    for (const Diagnostic& d : added(museum).told)
      EXPECT_NE(d.code, "wrong-placeholder") << tag << ' ' << d.message;
  }
}

TEST(AddLanguages, ReadsWordsWhoseHeadingWasForgotten) {
  const MuseumFolder museum;
  museum.write("words/en.toml",
               "name = \"English\"\ndirection = \"left-to-right\"\nbegin = \"A\"\nwelcome = "
               "\"B\"\nhome = \"C\"\n");

  const auto [made, told] = added(museum);

  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0].line, 3U);
  EXPECT_EQ(told[0].hint, "write [words] in the line above");
}

}  // namespace
}  // namespace docent::compile::add_languages_test
