#include "config/museum_config.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "config/diagnostic_text.h"
#include "runtime/model/exhibit/longer_text.h"
#include "tests/support/museum_folder.h"

namespace docent::config::museum_config_test {
namespace {

using test::MuseumFolder;
using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> codes(const Loaded<MuseumConfig>& loaded) {
  std::vector<std::string> codes;
  for (const Diagnostic& diagnostic : loaded.diagnostics) codes.push_back(diagnostic.code);
  return codes;
}

TEST(MuseumConfig, HoldsWhatStaffWrote) {
  const MuseumFolder museum;

  const auto loaded = load_museum_config(museum.path());

  ASSERT_TRUE(loaded.value.has_value());
  EXPECT_THAT(codes(loaded), ElementsAre());
  EXPECT_THAT(loaded.value->languages, ElementsAre("en", "ar"));
  EXPECT_EQ(loaded.value->museum.title.value.at("ar").value, "متحف صغير");
  EXPECT_EQ(loaded.value->kiosk.position.value, Vec2(2, 2));
  EXPECT_EQ(loaded.value->ambient.count.value, 3);
  EXPECT_EQ(loaded.value->avatar.radius.value, 0.25);
  ASSERT_EQ(loaded.value->exhibits.size(), 2U);
  EXPECT_EQ(loaded.value->exhibits[0].facing.value, 270);
  EXPECT_EQ(loaded.value->exhibits[1].position.place.range.line, 13U);
}

TEST(MuseumConfig, TakesALongerTextFromAFileAsItIsWritten) {
  const MuseumFolder museum;
  museum.write("texts/disc.en.txt", "\xef\xbb\xbfIt was buried.\r\n\r\nIt was found.\r\n");
  museum.replace("exhibits/hall.toml", "text.ar = \"قرص.\"",
                 "text.ar = \"قرص.\"\nmore_file.en = \"texts/disc.en.txt\"\nmore.ar = \"المزيد\"");

  const auto loaded = load_museum_config(museum.path());

  EXPECT_THAT(codes(loaded), ElementsAre());
  EXPECT_EQ(loaded.value->exhibits[0].more.value.at("en").value, "It was buried.\n\nIt was found.");
}

TEST(MuseumConfig, KeepsTheLinesOfATextFromAnOldMac) {
  const MuseumFolder museum;
  museum.write("texts/disc.en.txt", "It was buried.\r\rIt was found.\r");
  museum.replace("exhibits/hall.toml", "text.ar = \"قرص.\"",
                 "text.ar = \"قرص.\"\nmore_file.en = \"texts/disc.en.txt\"\nmore.ar = \"المزيد\"");

  const auto loaded = load_museum_config(museum.path());

  EXPECT_THAT(codes(loaded), ElementsAre());
  EXPECT_EQ(loaded.value->exhibits[0].more.value.at("en").value, "It was buried.\n\nIt was found.");
}

TEST(MuseumConfig, TakesALongerTextOfSoManyLettersAndNoMore) {
  for (const std::size_t beyond : {0U, 7U}) {
    const MuseumFolder museum;
    std::string text;
    while (text.size() < 3 * (longest_more + beyond)) text += "玉";
    museum.replace("exhibits/hall.toml", "text.ar = \"قرص.\"",
                   "text.ar = \"قرص.\"\nmore.en = \"" + text + "\"\nmore.ar = \"المزيد\"");

    const auto loaded = load_museum_config(museum.path());

    if (beyond == 0) {
      EXPECT_THAT(codes(loaded), ElementsAre());
      continue;
    }
    ASSERT_THAT(codes(loaded), ElementsAre("text-too-long"));
    const Diagnostic& told = loaded.diagnostics[0];
    EXPECT_EQ(told.severity, Severity::Error);
    EXPECT_EQ(told.message,
              "the longer text of exhibit 'jade-disc' has 20007 letters in 'en', and a kiosk shows "
              "at most 20000");
    EXPECT_THAT(told.hint, HasSubstr("shorten it by 7 letters"));
  }
}

TEST(MuseumConfig, TakesFurtherPicturesAsAListOrAsTables) {
  const MuseumFolder museum;
  museum.replace("exhibits/hall.toml", "title.en = \"Jade disc\"",
                 "pictures = [{image = \"images/disc.svg\", caption = {en = \"Back\", ar = "
                 "\"الظهر\"}}]\ntitle.en = \"Jade disc\"");

  const auto as_list = load_museum_config(museum.path());

  EXPECT_THAT(codes(as_list), ElementsAre());
  ASSERT_EQ(as_list.value->exhibits[0].pictures.value.size(), 1U);
  EXPECT_EQ(as_list.value->exhibits[0].pictures.value[0].caption.value.at("en").value, "Back");

  const MuseumFolder other;
  other.replace("exhibits/hall.toml", "text.ar = \"قرص.\"",
                "text.ar = \"قرص.\"\n[[exhibit.pictures]]\nimage = \"images/disc.svg\"\n"
                "[[exhibit.pictures]]\nimage = \"images/disc.svg\"");

  EXPECT_EQ(load_museum_config(other.path()).value->exhibits[0].pictures.value.size(), 2U);
}

TEST(MuseumConfig, FindsTheFieldThatATypoMeant) {
  const MuseumFolder museum;
  museum.replace("museum.toml", "facing", "facign");

  const auto loaded = load_museum_config(museum.path());

  ASSERT_THAT(codes(loaded), ElementsAre("unknown-key"));
  EXPECT_EQ(loaded.diagnostics[0].line, 10U);
  EXPECT_EQ(loaded.diagnostics[0].hint, "did you mean 'facing'?");
}

TEST(MuseumConfig, FindsTheTableThatATypoMeant) {
  const MuseumFolder museum;
  museum.replace("museum.toml", "[ambient]", "[ambiant]");

  const auto loaded = load_museum_config(museum.path());

  ASSERT_THAT(codes(loaded), ElementsAre("unknown-key"));
  EXPECT_EQ(loaded.diagnostics[0].hint, "did you mean 'ambient'?");
}

TEST(MuseumConfig, SaysWhichTypeAFieldHas) {
  const MuseumFolder museum;
  museum.replace("museum.toml", "count = 3", "count = \"three\"");
  museum.replace("exhibits/hall.toml", "[6.5, 4.5]", "[6.5, 4.5, 1]");

  const auto loaded = load_museum_config(museum.path());

  ASSERT_THAT(codes(loaded), ElementsAre("wrong-type", "wrong-type"));
  EXPECT_THAT(loaded.diagnostics[0].message, HasSubstr("'count' should be a whole number"));
  EXPECT_THAT(loaded.diagnostics[0].label, HasSubstr("this is a text"));
  EXPECT_THAT(loaded.diagnostics[1].message, HasSubstr("a point: [east, north] in metres"));
}

TEST(MuseumConfig, SaysWhatRangeANumberHas) {
  const MuseumFolder museum;
  museum.replace("museum.toml", "[ambient]", "[avatar]\nradius = 3\n[ambient]");

  const auto loaded = load_museum_config(museum.path());

  ASSERT_THAT(codes(loaded), ElementsAre("out-of-range"));
  EXPECT_THAT(loaded.diagnostics[0].message, HasSubstr("'radius' should be from 0.05 to 2"));
}

/// The diagnostic of a museum whose strolling visitors are written like this.
Diagnostic diagnostic_of_ambient(const std::string& written) {
  const MuseumFolder museum;
  museum.replace("museum.toml", "count = 3", written);
  const auto loaded = load_museum_config(museum.path());
  EXPECT_EQ(loaded.diagnostics.size(), 1U) << written;
  return loaded.diagnostics.empty() ? Diagnostic{} : loaded.diagnostics.front();
}

TEST(MuseumConfig, CountsStrollingVisitorsInWholeNumbersFromNone) {
  EXPECT_EQ(diagnostic_of_ambient("count = 2.5").message, "'count' should be a whole number");
  EXPECT_EQ(diagnostic_of_ambient("count = -1").message, "'count' should be at least 0");
}

TEST(MuseumConfig, LetsStrollingVisitorsComeFromOnePlaceOrSeveral) {
  const MuseumFolder one, several;
  one.replace("museum.toml", "count = 3", "from = [1.5, 2]");
  several.replace("museum.toml", "count = 3", "from = [[1.5, 2],\n        [8, 7]]");

  const auto from_one = load_museum_config(one.path()).value->ambient.from;
  const auto from_several = load_museum_config(several.path()).value->ambient.from;

  ASSERT_EQ(from_one.value.size(), 1U);
  EXPECT_EQ(from_one.value[0].value, Vec2(1.5, 2));
  ASSERT_EQ(from_several.value.size(), 2U);
  EXPECT_EQ(from_several.value[1].value, Vec2(8, 7));
  EXPECT_EQ(from_several.value[1].place.range.line, 13U);
}

TEST(MuseumConfig, WantsPlacesToComeFromToBePoints) {
  for (const char* written :
       {"from = []", "from = 3", "from = [1, 2, 3]", "from = [[1, 2], [3]]"}) {
    const Diagnostic diagnostic = diagnostic_of_ambient(written);
    EXPECT_EQ(diagnostic.code, "wrong-type") << written;
    EXPECT_THAT(diagnostic.message, HasSubstr("'from' should be a point or several")) << written;
  }
}

TEST(MuseumConfig, WantsALookToLastFromALeastToAMostOfSeconds) {
  const Diagnostic reversed = diagnostic_of_ambient("look = [20, 6]");

  EXPECT_EQ(reversed.message, "the least of 'look' is above its most");
  EXPECT_EQ(reversed.hint, "write look = [6, 20]");
  EXPECT_EQ(reversed.line, 12U);
  EXPECT_EQ(diagnostic_of_ambient("look = [-2, 6]").message, "'look' should be from 1 to 600");
  EXPECT_EQ(diagnostic_of_ambient("look = [6, 1e9]").message, "'look' should be from 1 to 600");
  EXPECT_EQ(diagnostic_of_ambient("look = [nan, 6]").code, "out-of-range");
  EXPECT_THAT(diagnostic_of_ambient("look = 6").message, HasSubstr("two numbers: [least, most]"));
}

TEST(MuseumConfig, RefusesNumbersThatAreNone) {
  const MuseumFolder museum;
  museum.replace("exhibits/hall.toml", "[6.5, 4.5]", "[nan, inf]");

  EXPECT_THAT(codes(load_museum_config(museum.path())), ElementsAre("out-of-range"));
}

TEST(MuseumConfig, MissesAFieldThatIsNeeded) {
  const MuseumFolder museum;
  museum.replace("exhibits/hall.toml", "facing = 270\n", "");

  const auto loaded = load_museum_config(museum.path());

  ASSERT_THAT(codes(loaded), ElementsAre("missing-field"));
  EXPECT_THAT(loaded.diagnostics[0].message, HasSubstr("[[exhibit]] lacks 'facing'"));
}

TEST(MuseumConfig, FindsTwoExhibitsWithOneId) {
  const MuseumFolder museum;
  museum.replace("exhibits/hall.toml", "\"portrait\"", "\"jade-disc\"");

  const auto loaded = load_museum_config(museum.path());

  ASSERT_THAT(codes(loaded), ElementsAre("duplicate-id"));
  EXPECT_EQ(loaded.diagnostics[0].line, 12U);
  EXPECT_THAT(loaded.diagnostics[0].hint, HasSubstr("hall.toml:2"));
}

TEST(MuseumConfig, FindsAnImageThatIsNotThere) {
  const MuseumFolder museum;
  museum.replace("exhibits/hall.toml", "images/disc.svg", "images/disk.svg");

  const auto loaded = load_museum_config(museum.path());

  ASSERT_THAT(codes(loaded), ElementsAre("missing-file"));
  EXPECT_EQ(loaded.diagnostics[0].line, 5U);
  EXPECT_THAT(loaded.diagnostics[0].message, HasSubstr("'images/disk.svg'"));
}

TEST(MuseumConfig, ShowsTheOtherLanguagesTextWhereATranslationIsMissing) {
  const MuseumFolder museum;
  museum.replace("exhibits/hall.toml", "text.ar = \"قرص.\"\n", "");

  const auto loaded = load_museum_config(museum.path());

  ASSERT_THAT(codes(loaded), ElementsAre("missing-translation"));
  EXPECT_EQ(loaded.diagnostics[0].line, 8U);
  EXPECT_THAT(loaded.diagnostics[0].message, HasSubstr("'jade-disc' is not translated into 'ar'"));
  EXPECT_THAT(loaded.diagnostics[0].hint, HasSubstr("A disc."));
}

TEST(MuseumConfig, NamesTheFloorsWhereOneIsUnknown) {
  const MuseumFolder museum;
  museum.replace("museum.toml", "[kiosk]\n", "[kiosk]\nfloor = \"first\"\n");

  const auto loaded = load_museum_config(museum.path());

  ASSERT_THAT(codes(loaded), ElementsAre("unknown-floor"));
  EXPECT_EQ(loaded.diagnostics[0].hint, "the floors are: ground");
}

TEST(MuseumConfig, TellsAllMistakesInTheOrderOfTheFiles) {
  const MuseumFolder museum;
  museum.write("exhibits/annex.toml", "[[exhibit\n");
  museum.replace("exhibits/hall.toml", "facing = 270\n", "facing = 1000\n");
  museum.replace("museum.toml", "count = 3", "cuont = 3");

  EXPECT_THAT(codes(load_museum_config(museum.path())),
              ElementsAre("unknown-key", "unreadable-toml", "out-of-range"));
}

TEST(MuseumConfig, SaysThatAFolderIsNoMuseum) {
  const test::TemporaryFolder empty;

  const auto loaded = load_museum_config(empty.path());

  EXPECT_FALSE(loaded.value.has_value());
  ASSERT_THAT(codes(loaded), ElementsAre("missing-file"));
  EXPECT_THAT(loaded.diagnostics[0].file, HasSubstr("museum.toml"));
}

TEST(MuseumConfig, SpeaksTheLanguagesOfItsTextsWhereNoneAreNamed) {
  const MuseumFolder museum;
  museum.replace("museum.toml", "languages = [\"en\", \"ar\"]\n", "");

  const auto loaded = load_museum_config(museum.path());

  ASSERT_TRUE(loaded.value.has_value());
  EXPECT_THAT(loaded.value->languages, ElementsAre("en", "ar"));
}

TEST(MuseumConfig, IsCompleteForTheSampleMuseum) {
  const auto loaded = load_museum_config(test::source_dir() / "config/museum");

  ASSERT_TRUE(loaded.value.has_value());
  EXPECT_THAT(codes(loaded), ElementsAre());
}

TEST(MuseumSchema, IsTheOneThatIsKept) {
  EXPECT_EQ(test::text_of(test::source_dir() / "config/museum.schema.json"), museum_schema())
      << "the fields have changed: docent-content schema > config/museum.schema.json";
}

TEST(DiagnosticText, PointsAtTheCharactersThatAreMeant) {
  const test::TemporaryFolder folder;
  const std::string file = (folder.path() / "bronze.toml").string();
  std::ofstream(file) << "\n名 = [12.40, 3.10]\n";

  Diagnostic diagnostic;
  diagnostic.file = file;
  diagnostic.line = 2;
  diagnostic.column = 5;
  diagnostic.length = 13;
  diagnostic.code = "exhibit-outside-floor";
  diagnostic.message = "exhibit 'tripod-ding' stands outside the building";
  diagnostic.label = "0.18 m outside the floor of 'ground'";
  diagnostic.hint = "the nearest free point is [12.40, 3.45]";

  EXPECT_EQ(to_text(diagnostic),
            file +
                ":2:5: error[exhibit-outside-floor]: exhibit 'tripod-ding' stands outside the "
                "building\n"
                "     2 | 名 = [12.40, 3.10]\n"
                "       |     ^^^^^^^^^^^^^ 0.18 m outside the floor of 'ground'\n"
                "   hint: the nearest free point is [12.40, 3.45]\n");
}

TEST(DiagnosticText, IsOneJsonObjectALine) {
  Diagnostic diagnostic;
  diagnostic.file = "a \"b\".toml";
  diagnostic.line = 3;
  diagnostic.column = 4;
  diagnostic.severity = Severity::Warning;
  diagnostic.code = "left-out";
  diagnostic.message = "broken \xff byte";

  EXPECT_EQ(to_json(diagnostic),
            "{\"file\":\"a \\\"b\\\".toml\",\"line\":3,\"column\":4,\"code\":\"left-out\","
            "\"severity\":\"warning\",\"message\":\"broken \uFFFD byte\",\"hint\":\"\"}");
}

TEST(MuseumConfig, MayHaveSeveralKiosksWhichThenHaveIds) {
  test::MuseumFolder museum;
  museum.replace("museum.toml", "[kiosk]\n",
                 "[[kiosk]]\nid = \"cafe\"\nposition = [3, 2]\n\n[[kiosk]]\n");

  const auto unnamed = load_museum_config(museum.path());
  EXPECT_THAT(unnamed.diagnostics,
              testing::Contains(
                  testing::Field(&Diagnostic::message, "one of several [[kiosk]] lacks its 'id'")));

  museum.replace("museum.toml", "[[kiosk]]\nposition = [2",
                 "[[kiosk]]\nid = \"cafe\"\nposition = [2");
  const auto twice = load_museum_config(museum.path());
  EXPECT_THAT(twice.diagnostics,
              testing::Contains(testing::Field(&Diagnostic::code, "duplicate-id")));

  museum.replace("museum.toml", "id = \"cafe\"\nposition = [2", "id = \"foyer\"\nposition = [2");
  const auto loaded = load_museum_config(museum.path());
  EXPECT_TRUE(loaded.diagnostics.empty());
  ASSERT_EQ(loaded.value->kiosks.size(), 2U);
  EXPECT_EQ(loaded.value->kiosk.id.value, "cafe");
  EXPECT_EQ(loaded.value->kiosks[1].position.value, Vec2(2, 2));
}

}  // namespace
}  // namespace docent::config::museum_config_test
