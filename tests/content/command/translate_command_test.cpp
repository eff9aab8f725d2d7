#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/museum_folder.h"

namespace docent::command::translate_command_test {
namespace {

using test::MuseumFolder;
using test::ProgramRun;
using testing::AllOf;
using testing::HasSubstr;

ProgramRun translate(const MuseumFolder& museum, const std::string& options) {
  return test::run_program("docent-content",
                           "translate '" + museum.path().string() + "' " + options);
}

std::string file(const MuseumFolder& museum, const char* name) {
  return "'" + (museum.path() / name).string() + "'";
}

TEST(TranslateCommand, WritesWhatIsMissingForTranslators) {
  const MuseumFolder museum;

  const ProgramRun run = translate(museum, "--to fr --out " + file(museum, "t.xlf"));

  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("5 texts, 5 of them not translated yet"));
  EXPECT_THAT(
      test::text_of(museum.path() / "t.xlf"),
      AllOf(HasSubstr("srcLang=\"en\" trgLang=\"fr\""), HasSubstr("<unit id=\"jade-disc.text\">"),
            HasSubstr("<source>A disc.</source>")));
}

TEST(TranslateCommand, TakesTranslationsIntoTheFilesOfStaffAndLeavesTheRest) {
  const MuseumFolder museum;
  const std::string before = test::text_of(museum.path() / "exhibits/hall.toml");
  museum.write("t.csv",
               "id;en;fr\r\nportrait.title;Portrait;\"Un \"\"portrait\"\"\"\r\n"
               "gone.title;Gone;Parti\r\njade-disc.text;Another disc.;Un disque.\r\n"
               "jade-disc.title;Jade disc;\r\n");

  const ProgramRun run = translate(museum, "--in " + file(museum, "t.csv"));

  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.err,
              AllOf(HasSubstr("t.csv:3:1: warning[unknown-text]"),
                    HasSubstr("t.csv:4:1: warning[outdated-translation]: 'jade-disc.text' has "
                              "changed since it went to the translator"),
                    HasSubstr("2 texts taken in in 'fr', 0 were so already, 1 are not")));
  std::string after = before;
  after.insert(after.find("title.ar = \"صورة\""), "title.fr = \"Un \\\"portrait\\\"\"\n");
  after.insert(after.find("text.ar"), "text.fr = \"Un disque.\"\n");
  EXPECT_EQ(test::text_of(museum.path() / "exhibits/hall.toml"), after);
  EXPECT_THAT(translate(museum, "--in " + file(museum, "t.csv")).err,
              HasSubstr("0 texts taken in"));
}

TEST(TranslateCommand, OfACatalogueTheTranslationsGetAFileOfTheirOwn) {
  const MuseumFolder museum;
  museum.write("o.csv", "id,t,x,y\nv1,Vase,3,5\n");
  museum.replace(
      "museum.toml", "[[room]]",
      "[source]\nfile = \"o.csv\"\nid = \"id\"\ntitle.en = \"t\"\nposition = [\"x\", \"y\"]\n"
      "[[room]]");
  museum.write("t.csv", "id,en,ar\nv1.title,Vase,مزهرية\n");

  ASSERT_EQ(translate(museum, "--in " + file(museum, "t.csv")).exit_code, 0);

  EXPECT_THAT(test::text_of(museum.path() / "exhibits/translations.toml"),
              HasSubstr("[[exhibit]]\nid = \"v1\"\ntitle.ar = \"مزهرية\"\n"));
  EXPECT_EQ(museum.compile().exit_code, 0);
}

TEST(TranslateCommand, SaysWhatItWants) {
  const MuseumFolder museum;

  EXPECT_EQ(translate(museum, "").exit_code, 2);
  EXPECT_EQ(translate(museum, "--out x.xlf").exit_code, 2);
  EXPECT_THAT(translate(museum, "--to english --out x.xlf").err, HasSubstr("did you mean en"));
}

}  // namespace
}  // namespace docent::command::translate_command_test
