// Exhibits that come from a museum's catalogue.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "platform/sqlite/content_reader.h"
#include "tests/support/museum_folder.h"

namespace docent::compile::add_collections_test {
namespace {

using test::MuseumFolder;
using test::ProgramRun;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// The small museum with a catalogue of three objects, two of which have a place.
void add_catalogue(const MuseumFolder& museum, const std::string& rows = {}) {
  museum.write("objects.csv",
               "\xEF\xBB\xBFNr;Title;Titel ar;Text;Picture;x;y\r\n"
               "G 1912/4;\"Vase \"\"Lotus\"\"\";مزهرية;<p>Old.</p>;images\\disc.svg;3,5;5\r\n"
               "G 1912/5;Jug;;;;4.5;5\r\n"
               "G 1912/6;Lost;;;;;\r\n" +
                   rows);
  museum.replace(
      "museum.toml", "[[room]]",
      "[source]\nfile = \"objects.csv\"\nid = \"Nr\"\ntitle.en = \"Title\"\ntitle.ar = "
      "\"Titel ar\"\ntext.en = \"Text\"\nimage = \"Picture\"\nposition = [\"x\", \"y\"]\n"
      "[[room]]");
}

ProgramRun check(const MuseumFolder& museum) {
  return test::run_program("docent-content", "check '" + museum.path().string() + "' --no-motion");
}

TEST(Collections, BecomeExhibitsByATableOfColumns) {
  const MuseumFolder museum;
  add_catalogue(museum);

  ASSERT_EQ(museum.compile().exit_code, 0) << museum.compile().err;

  EXPECT_THAT(
      test::run_program("docent-content", "info '" + museum.database().string() + "' --json").out,
      AllOf(HasSubstr("\"G-1912-4\""), HasSubstr("\"G-1912-5\""), HasSubstr("\"jade-disc\""),
            Not(HasSubstr("G-1912-6"))));
}

TEST(Collections, TellWhatTheyLack) {
  const MuseumFolder museum;
  add_catalogue(museum, "G 1912/4;Twice;;;;1;1\r\n;None;;;;1;1\r\nG 7;;;;;2;5\r\n");

  const ProgramRun run = check(museum);

  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(
      run.err,
      AllOf(HasSubstr(
                "objects.csv: warning[no-place]: 1 of 6 objects have no place in the museum and "
                "are left out"),
            HasSubstr(
                "objects.csv:3:1: warning[missing-translation]: the title of exhibit 'G-1912-5' is "
                "not translated into 'ar', and is shown in 'en'"),
            HasSubstr("objects.csv:5:1: warning[duplicate-id]"),
            HasSubstr("objects.csv:6:1: warning[object-without-id]"),
            HasSubstr(
                "objects.csv:7:1: warning[object-without-title]: object 'G-7' has no title and is "
                "left out"),
            HasSubstr("found 4 exhibits")));
}

TEST(Collections, WhatStaffWroteByHandWinsAndIsSaid) {
  const MuseumFolder museum;
  add_catalogue(museum);
  museum.write("exhibits/mine.toml",
               "[[exhibit]]\nid = \"G-1912-6\"\nposition = [2, 6]\nfacing = 270\n[[exhibit]]\nid = "
               "\"G-1912-4\"\ntitle.en = \"The Lotus\"\n");

  const ProgramRun run = check(museum);

  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.err,
              AllOf(HasSubstr("mine.toml:7:12: warning[written-by-hand]: the title of exhibit "
                              "'G-1912-4' in 'en' is written by hand, and wins"),
                    HasSubstr("objects.csv:2 says: Vase \"Lotus\""), HasSubstr("found 5 exhibits")))
      << "the third object has a place now";
}

/// Thousands of exhibits get their tags from the catalogue, and nobody writes them by hand.
TEST(Collections, GiveExhibitsTheTagsByWhichTheyAreFound) {
  const MuseumFolder museum;
  museum.write("objects.csv",
               "Nr,Title,Maker,Theme,Thema ar,Dynasty,x,y\n"
               "1,Vase,\"Ōta, Ren\",Sea;Trade,بحر,Ming,3.5,5\n"
               "2,Jug,,<i>sea</i>,,Ming ,4.5,5\n"
               "3,Bowl,,,,,5,5\n");
  museum.replace("museum.toml", "[[room]]",
                 "[source]\nfile = \"objects.csv\"\nid = \"Nr\"\ntitle.en = \"Title\"\n"
                 "artist.en = \"Maker\"\nsubject.en = \"Theme\"\nsubject.ar = \"Thema ar\"\n"
                 "period.en = \"Dynasty\"\nposition = [\"x\", \"y\"]\n[[room]]");

  const ProgramRun run = museum.compile();
  ASSERT_EQ(run.exit_code, 0) << run.err;

  EXPECT_THAT(run.err, HasSubstr("objects.csv:3:1: warning[tag-spelt-otherwise]: the subject 'sea' "
                                 "is taken for 'Sea'"));
  const auto read = sqlite::load_museum(museum.database());
  ASSERT_TRUE(read.has_value()) << read.error().what;
  const auto exhibit = [&](std::string_view id) -> const Exhibit& {
    return *std::ranges::find(read->exhibits, id, &Exhibit::id);
  };
  EXPECT_EQ(exhibit("1").artist, (LocalText{{"en", "Ōta, Ren"}}));
  EXPECT_EQ(exhibit("1").subject, (LocalText{{"en", "Sea"}, {"ar", "بحر"}}));
  EXPECT_EQ(exhibit("2").subject, (LocalText{{"en", "Sea"}}));
  EXPECT_EQ(exhibit("1").period, exhibit("2").period);
  EXPECT_TRUE(exhibit("3").subject.empty());
}

TEST(Collections, ATagIsTheFirstThatIsNotBlankAndItsEntitiesAreLetters) {
  const MuseumFolder museum;
  museum.write("objects.csv",
               "Nr,Title,Maker,Theme,x,y\n"
               "1,Helmet,; Ren|Li,Arms &amp; armour;War,3.5,5\n");
  museum.replace("museum.toml", "[[room]]",
                 "[source]\nfile = \"objects.csv\"\nid = \"Nr\"\ntitle.en = \"Title\"\n"
                 "artist.en = \"Maker\"\nsubject.en = \"Theme\"\nposition = [\"x\", \"y\"]\n"
                 "[[room]]");

  const ProgramRun run = museum.compile();
  ASSERT_EQ(run.exit_code, 0) << run.err;

  const auto read = sqlite::load_museum(museum.database());
  ASSERT_TRUE(read.has_value()) << read.error().what;
  const Exhibit& helmet = *std::ranges::find(read->exhibits, "1", &Exhibit::id);
  EXPECT_EQ(helmet.subject, (LocalText{{"en", "Arms & armour"}}));
  EXPECT_EQ(helmet.artist, (LocalText{{"en", "Ren"}}));
}

/// Visitors would begin at a blank card, "Picture 1 of 2".
TEST(Collections, FurtherPicturesNeedAFirstOneByHandOrFromTheCatalogue) {
  const std::string by_hand =
      "[[exhibit]]\nid = \"G-1912-5\"\npictures = [{image = \"images/disc.svg\"}]\n";
  const MuseumFolder without;
  add_catalogue(without);
  without.write("exhibits/mine.toml", by_hand);

  const ProgramRun refused = check(without);

  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.err,
              AllOf(HasSubstr("mine.toml:3:12: error[missing-field]: exhibit 'G-1912-5' has "
                              "further pictures and no first one"),
                    HasSubstr("hint: write image = \"images/disc.svg\"")));

  const MuseumFolder with;
  add_catalogue(with);
  with.replace("objects.csv", "Jug;;;;", "Jug;;;images/disc.svg;");
  with.write("exhibits/mine.toml", by_hand);

  EXPECT_EQ(check(with).exit_code, 0) << check(with).err;
}

TEST(Collections, ATagThatStaffWroteByHandWins) {
  const MuseumFolder museum;
  museum.write("objects.csv", "Nr,Title,Theme,x,y\n1,Vase,Sea,3.5,5\n");
  museum.replace("museum.toml", "[[room]]",
                 "[source]\nfile = \"objects.csv\"\nid = \"Nr\"\ntitle.en = \"Title\"\n"
                 "subject.en = \"Theme\"\nposition = [\"x\", \"y\"]\n[[room]]");
  museum.write("exhibits/mine.toml", "[[exhibit]]\nid = \"1\"\nsubject.en = \"Ships\"\n");

  ASSERT_EQ(museum.compile().exit_code, 0) << museum.compile().err;

  const auto read = sqlite::load_museum(museum.database());
  ASSERT_TRUE(read.has_value()) << read.error().what;
  EXPECT_EQ(std::ranges::find(read->exhibits, "1", &Exhibit::id)->subject,
            (LocalText{{"en", "Ships"}}));
}

TEST(Collections, AColumnThatIsNotThereIsTold) {
  const MuseumFolder museum;
  add_catalogue(museum);
  museum.replace("museum.toml", "\"Title\"", "\"Titel\"");

  const ProgramRun run = check(museum);

  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err,
              AllOf(HasSubstr("museum.toml:16:12: error[unknown-column]: there is no column "
                              "'Titel'"),
                    HasSubstr("hint: did you mean")));
}

TEST(Collections, AnEncodingThatWasGuessedIsSaid) {
  const MuseumFolder museum;
  add_catalogue(museum);
  museum.write("objects.csv",
               "Nr;Title;Titel ar;Text;Picture;x;y\r\n1;M\xe4"
               "dchen;M;;;3;5\r\n");

  EXPECT_THAT(
      check(museum).err,
      AllOf(HasSubstr("warning[guessed-encoding]: 'objects.csv' is not UTF-8 and was read as "
                      "Windows-1252"),
            HasSubstr("write encoding = \"windows-1252\"")));
}

TEST(Collections, ManifestsOfIiifNeedNoColumns) {
  const MuseumFolder museum;
  museum.write("iiif/a.json",
               R"({"id": "https://m.example/iiif/vase-7/manifest.json", "type": "Manifest",
                  "label": {"en": ["Vase"], "ar": ["مزهرية"]}, "items": []})");
  museum.replace("museum.toml", "[[room]]", "[source]\nfile = \"iiif\"\n[[room]]");
  museum.write("exhibits/mine.toml",
               "[[exhibit]]\nid = \"vase-7\"\nposition = [2, 6]\nfacing = 270\n");

  const ProgramRun run = check(museum);

  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.err,
              AllOf(HasSubstr("a.json:1:1: warning[odd-manifest]"), HasSubstr("found 3 exhibits")));
}

TEST(Collections, TheSameCatalogueGivesTheSameBytes) {
  const MuseumFolder museum;
  add_catalogue(museum);

  ASSERT_EQ(museum.compile().exit_code, 0);
  const std::string first = test::text_of(museum.database());
  ASSERT_EQ(museum.compile().exit_code, 0);

  EXPECT_EQ(test::text_of(museum.database()), first);
}

}  // namespace
}  // namespace docent::compile::add_collections_test
