#include "content/compile/compile_livery.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "content/compile/load_logo.h"
#include "platform/image/image.h"
#include "platform/sqlite/content_reader.h"
#include "runtime/scene/theme.h"
#include "tests/support/made_font.h"
#include "tests/support/museum_folder.h"

namespace docent::compile::compile_livery_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// The small museum with a [look].
struct MuseumWithLook : test::MuseumFolder {
  explicit MuseumWithLook(const std::string& look) {
    replace("museum.toml", "[ambient]\n", "[look]\n" + look + "[ambient]\n");
  }
  test::ProgramRun check() const {
    return test::run_program("docent-content", "check '" + path().string() + "'");
  }
};

std::string svg(const std::string& shapes) {
  return "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 60'>" + shapes + "</svg>\n";
}

TEST(AMuseumsColours, AreCheckedForTheContrastsOfATheme) {
  const test::ProgramRun pale = MuseumWithLook("accent = \"#E8A090\"\n").check();
  EXPECT_EQ(pale.exit_code, 1);
  EXPECT_THAT(pale.err, AllOf(HasSubstr("museum.toml:12:10: error[low-contrast]: the accent "
                                        "'#E8A090' is told from the paper '#F5F1E8' by 1.9:1, and "
                                        "has to be by 4:1"),
                              HasSubstr("hint: take a darker one, such as accent = \"#")));
  EXPECT_THAT(MuseumWithLook("ink = \"#777777\"\n").check().err, HasSubstr("has to be by 7:1"));
  EXPECT_THAT(MuseumWithLook("focus = \"#E0C000\"\n").check().err, HasSubstr("has to be by 3:1"));
  EXPECT_THAT(MuseumWithLook("paper = \"#204060\"\n").check().err,
              HasSubstr("'#204060' is too dark for paper"));
  const test::ProgramRun good =
      MuseumWithLook("accent = \"#00539B\"\npaper = \"#FFFFFF\"\nink = \"#102030\"\n").check();
  EXPECT_EQ(good.exit_code, 0) << good.err;
}

TEST(AMuseumsColours, WithTheOneThatIsProposedAreGood) {
  for (const std::string look : {"accent = \"#E8A090\"\n", "ink = \"#9A7B4F\"\n",
                                 "focus = \"#FFD400\"\n", "paper = \"#808080\"\n"}) {
    const std::string told = MuseumWithLook(look).check().err;
    const std::size_t hint = told.find("such as ");
    ASSERT_NE(hint, std::string::npos) << told;
    const std::size_t quote = told.find('"', hint);
    const std::string better = look.substr(0, look.find('"')) + told.substr(quote, 9) + "\n";

    const test::ProgramRun again = MuseumWithLook(better).check();
    EXPECT_EQ(again.exit_code, 0) << better << again.err;
  }
}

TEST(AMuseumsColours, AreWrittenAsTheWebDoes) {
  for (const auto& [written, meant] :
       {std::pair{"D2452D", "#D2452D"}, {"#d24", "#DD2244"}, {"rgb(0, 83, 155)", "#00539B"}})
    EXPECT_THAT(MuseumWithLook(std::string("accent = \"") + written + "\"\n").check().err,
                AllOf(HasSubstr("error[bad-value]"),
                      HasSubstr(std::string("write accent = \"") + meant + "\"")));
  EXPECT_THAT(MuseumWithLook("accent = \"tomato\"\n").check().err,
              HasSubstr("write it as the web does"));
}

TEST(AMuseumsLogo, IsKeptWithoutTheMarginAboutIt) {
  const test::TemporaryFolder folder;
  std::ofstream(folder.path() / "a.svg") << svg("<rect x='40' y='20' width='20' height='10'/>");

  const Logo logo = load_logo(folder.path() / "a.svg", "a.svg");

  EXPECT_NEAR(static_cast<float>(logo.image.width) / static_cast<float>(logo.image.height), 2,
              0.05F);
  const auto pixels = image::decode_image(logo.image.bytes);
  ASSERT_TRUE(pixels);
  EXPECT_EQ(pixels->width, logo.image.width);
  EXPECT_TRUE(shows_on(logo, scene::srgb(0xFFFFFF)));
  EXPECT_FALSE(shows_on(logo, scene::srgb(0x1C1A18))) << "black on black";
}

TEST(AMuseumsLogo, ThatIsHardlySeenOrHasAGroundIsTold) {
  MuseumWithLook pale("logo = \"images/logo.svg\"\n");
  pale.write("images/logo.svg", svg("<circle cx='50' cy='30' r='20' fill='#FFF4C0'/>"));
  EXPECT_THAT(pale.check().err, AllOf(HasSubstr("warning[logo-pale]"),
                                      HasSubstr("'images/logo.svg' is hardly told from paper")));
  pale.write("images/logo.svg", svg("<rect width='100' height='60' fill='white'/>"
                                    "<circle cx='50' cy='30' r='20'/>"));
  EXPECT_THAT(pale.check().err, AllOf(HasSubstr("warning[logo-ground]"),
                                      HasSubstr("a ground of its own, '#FFFFFF'")));
  for (const std::string sign :
       {"<circle cx='50' cy='30' r='20'/>", "<rect width='100' height='60' fill='#B0126B'/>"}) {
    pale.write("images/logo.svg", svg(sign));
    EXPECT_THAT(pale.check().err, Not(HasSubstr("warning[logo"))) << sign;
  }
}

TEST(AMuseumsLogo, ThatIsNoneIsAnErrorInItsLine) {
  MuseumWithLook museum("logo = \"images/logo.svg\"\n");
  museum.write("images/logo.svg", svg(""));
  EXPECT_THAT(museum.check().err, HasSubstr("museum.toml:12:8: error[unreadable-image]: "
                                            "'images/logo.svg': nothing can be seen"));
  EXPECT_THAT(MuseumWithLook("logo_at_night = \"images/disc.svg\"\n").check().err,
              HasSubstr("there is a logo for the night, and none for the day"));
  EXPECT_THAT(MuseumWithLook("logo = \"images/lost.svg\"\n").check().err,
              HasSubstr("museum.toml:12:8: error[missing-file]"));
}

TEST(AMuseumsLetters, LeadInTheLanguagesThatTheyHave) {
  MuseumWithLook museum("title_font = [\"house.ttf\"]\n");
  museum.write("house.ttf", test::make_font({.letters = test::latin_letters()}));
  ASSERT_EQ(museum.compile().exit_code, 0);

  const Result<Museum> museum_read = sqlite::load_museum(museum.database());

  ASSERT_TRUE(museum_read) << museum_read.error().what;
  const Museum& read = *museum_read;
  EXPECT_EQ(read.livery.titles.family, "House");
  EXPECT_THAT(read.livery.titles.languages, testing::ElementsAre(0U)) << "English, not Arabic";
  EXPECT_TRUE(read.livery.text.family.empty());
  ASSERT_EQ(read.fonts.size(), 1U);
  EXPECT_EQ(read.fonts[0].name, "house.ttf");
}

TEST(AMuseumsLetters, ThatLackAFewAreToldWhich) {
  MuseumWithLook museum("title_font = [\"house.ttf\"]\n");
  std::u32string letters = test::latin_letters();
  std::erase(letters, U'J');
  museum.write("house.ttf", test::make_font({.letters = letters}));

  EXPECT_THAT(museum.check().err, AllOf(HasSubstr("warning[missing-letters]: 'House' lacks letters "
                                                  "of 'en', which come from the kiosk's own fonts"),
                                        HasSubstr("U+004A")));
}

TEST(AMuseumsLetters, AreOfOneFamilyAndWhole) {
  MuseumWithLook museum("text_font = [\"a.ttf\", \"b.ttf\"]\n");
  museum.write("a.ttf", test::make_font({.family = "A", .letters = test::latin_letters()}));
  museum.write("b.ttf", test::make_font({.family = "B", .letters = test::latin_letters()}));
  EXPECT_THAT(museum.check().err,
              HasSubstr("'b.ttf' is of the family 'B', and the one before it of 'A'"));
  museum.write("b.ttf", "<html>404</html>");
  EXPECT_THAT(museum.check().err, HasSubstr("museum.toml:12:23: error[unreadable-font]: 'b.ttf': "
                                            "this is no font"));
  constexpr std::uint16_t restricted = 2;
  museum.write(
      "b.ttf",
      test::make_font({.family = "A", .letters = test::latin_letters(), .embedding = restricted}));
  EXPECT_THAT(museum.check().err, HasSubstr("warning[font-licence]"));
}

}  // namespace
}  // namespace docent::compile::compile_livery_test
