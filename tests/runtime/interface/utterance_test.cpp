#include "runtime/interface/utterance.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "runtime/interface/control.h"
#include "tests/support/sample_museum.h"
#include "tests/support/shipped_languages.h"

namespace docent::interface::utterance_test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::Not;

TEST(Utterance, IsMadeOfWhatStandsBetweenTheHolesOfASentence) {
  Utterance said{.language = "en", .pieces = {}};
  append_spoken(said, "through “" + apart("Bronze") + "”, then " + apart("the second door") + ".");
  append_spoken(said, "”.");

  EXPECT_THAT(said.pieces,
              ElementsAre(SpokenPiece{"through"}, SpokenPiece{"Bronze"}, SpokenPiece{"then"},
                          SpokenPiece{.text = "the second door", .pause = true}));
  EXPECT_EQ(text_of(said), "through Bronze then the second door.");
}

TEST(Utterance, SaysDistancesInThePluralsOfEachLanguage) {
  const Museum museum = test::sample_museum_without_walls();  // English, Chinese, Arabic

  EXPECT_EQ(spoken_distance(museum, 0, 0.2), "1 metre");
  EXPECT_EQ(spoken_distance(museum, 0, 17.3), "17 metres");
  EXPECT_EQ(spoken_distance(museum, 0, 63), "65 metres");
  EXPECT_EQ(spoken_distance(museum, 0, 1e12), "2000 metres");
  EXPECT_EQ(spoken_distance(museum, 1, 42), "40米");
  EXPECT_EQ(spoken_distance(museum, 2, 4), "4 أمتار");
}

/// What is said of a longer text has its sound, however long its paragraphs are.
TEST(SpokenPieces, HaveNoQuotationMarkOrBlankToSayInAnyLanguage) {
  const Museum museum = test::in_all_shipped_languages(test::sample_museum_without_walls());

  for (std::uint32_t language = 0; language < museum.languages.size(); ++language)
    for (const std::string& piece : spoken_pieces(museum, language))
      for (const std::string_view mark : {"‘", "’", "“", "”", "„", "«", "»", "\u00a0", "\u202f"})
        EXPECT_FALSE(piece.starts_with(mark) || piece.ends_with(mark))
            << museum.languages[language].tag << ": '" << piece << "'";
}

TEST(SpokenPieces, HoldTheShortPartsOfALongParagraph) {
  Museum museum = test::sample_museum_without_walls();
  std::string more;
  for (int i = 0; i < 400; ++i) more += "It was found in well " + std::to_string(i) + ". ";
  museum.exhibits[0].more = {{"en", more}};

  Utterance said;
  append_paragraphs(said, more);

  const std::vector<std::string> pieces = spoken_pieces(museum, 0);
  EXPECT_GT(said.pieces.size(), 8U);
  for (const SpokenPiece& piece : said.pieces) {
    EXPECT_LE(piece.text.size(), 1000U);
    EXPECT_THAT(pieces, Contains(piece.text));
  }
}

TEST(SpokenPieces, HoldWhateverIsFilledIn) {
  const Museum museum = test::sample_museum_without_walls();

  for (std::uint32_t language = 0; language < museum.languages.size(); ++language) {
    const std::vector<std::string> pieces = spoken_pieces(museum, language);
    EXPECT_TRUE(std::ranges::is_sorted(pieces));
    EXPECT_EQ(std::ranges::adjacent_find(pieces), pieces.end());
    for (const std::string& piece : pieces) {
      EXPECT_FALSE(piece.empty());
      EXPECT_EQ(piece.find_first_of("{}\x1f"), std::string::npos) << piece;
    }
    for (double metres = 0.1; metres < 5000; metres *= 1.05)
      EXPECT_THAT(pieces, Contains(spoken_distance(museum, language, metres)));
    for (double seconds = 1; seconds < 1e5; seconds *= 1.05)
      EXPECT_THAT(pieces, Contains(spoken_time(museum, language, seconds)));
    Utterance texts;
    for (const Exhibit& exhibit : museum.exhibits)
      append_spoken(texts, in_language(museum, language, exhibit.text));
    for (const SpokenPiece& piece : texts.pieces) EXPECT_THAT(pieces, Contains(piece.text));
    EXPECT_THAT(pieces, Not(Contains(std::string(word(museum, language, "staff_title")))));
  }
}

}  // namespace
}  // namespace docent::interface::utterance_test
