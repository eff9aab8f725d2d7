#include "runtime/interface/finder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/sample_museum.h"
#include "tests/support/shipped_languages.h"

namespace docent::interface::finder_test {
namespace {

using testing::Contains;
using testing::ElementsAre;

/// With a gallery of bronzes: the tripod and two that are not called so.
const Museum& museum() {
  static const Museum it = [] {
    Museum all = test::in_all_shipped_languages(test::sample_museum_without_walls());
    all.rooms.push_back({.id = "bronzes", .title = {{"en", "Bronze"}}, .outline = {}});
    for (const std::size_t exhibit : {5, 6, 7})
      all.exhibits[exhibit].room = static_cast<std::uint32_t>(all.rooms.size() - 1);
    return all;
  }();
  return it;
}

/// Names of what is found, as controls bear them.
std::vector<std::string> found(std::u16string_view letters, std::uint32_t language = 0) {
  InterfaceState state;
  state.language = language;
  state = after(state, {Action::Kind::Search});
  for (const char16_t letter : letters) state = after(state, {Action::Kind::Type, letter});
  Finder finder(museum());
  finder.look_up(state);
  std::vector<std::string> names;
  for (const Control& control : controls_of(museum(), state, 60))
    if (control.role == Role::ListItem) names.push_back(control.name);
  return names;
}

TEST(AFinder, FindsAnExhibitByItsTitleInAnyLanguageThatStaffWrote) {
  EXPECT_THAT(found(u"tripod"), ElementsAre("exhibit:tripod-ding"));
  EXPECT_THAT(found(u"tripdo"), Contains("exhibit:tripod-ding"));
  EXPECT_EQ(found(u"鼎").front(), "exhibit:tripod-ding");
}

TEST(AFinder, FindsAnExhibitByItsNumber) {
  EXPECT_EQ(found(u"6").front(), "exhibit:" + museum().exhibits[5].id);
}

TEST(AFinder, FindsAllOfAGalleryAfterWhatIsCalledSo) {
  const auto names = found(u"bronze");

  EXPECT_EQ(names.front(), "exhibit:tripod-ding") << "Bronze Tripod, in the gallery Bronze";
  EXPECT_EQ(names.size(), 3U);
}

TEST(AFinder, FindsByArtistSubjectAndPeriodAndByHowATextIsRead) {
  Museum tagged = museum();
  tagged.exhibits[2].artist = {{"en", "Émile Gallé"}};
  tagged.exhibits[3].subject = tagged.exhibits[4].subject = {{"en", "Hunting"}, {"de", "Jagd"}};
  tagged.exhibits[4].period = {{"en", "Baroque"}};
  tagged.exhibits[7].title["zh"] = "鸮尊";
  tagged.readings["鸮尊"] = "xiao zun";
  Finder finder(tagged);
  const auto first = [&](std::u16string_view letters) {
    InterfaceState state;
    for (const char16_t letter : letters) state = after(state, {Action::Kind::Type, letter});
    finder.look_up(state);
    return std::vector(state.found.entry.begin(), state.found.entry.begin() + state.found.count);
  };

  EXPECT_THAT(first(u"galle"), ElementsAre(2));
  EXPECT_THAT(first(u"hunt"), ElementsAre(3, 4));
  EXPECT_EQ(first(u"jagd").front(), 3U) << "before jade, which has a letter wrong";
  EXPECT_THAT(first(u"hunting baro"), ElementsAre(4));
  EXPECT_THAT(first(u"xiaozun"), ElementsAre(7));
  EXPECT_THAT(first(u"xz"), ElementsAre(7));
}

TEST(AFinder, FindsKindsOfPlacesInTheWordsOfTheLanguage) {
  EXPECT_THAT(found(u"toi"), Contains("place:toilets"));
  const auto german = std::ranges::find(museum().languages, "de", &Language::tag);
  const auto language = static_cast<std::uint32_t>(german - museum().languages.begin());
  EXPECT_THAT(found(u"ausg", language), Contains("place:exit"));
}

TEST(AFinder, ShowsGalleriesSubjectsAndPeriodsBeforeALetterIsTypedAndWhatBelongsToThem) {
  Museum tagged = museum();
  tagged.exhibits[3].subject = tagged.exhibits[9].subject = {{"en", "Hunting"}};
  tagged.exhibits[9].period = {{"en", "Baroque"}};
  Finder finder(tagged);
  InterfaceState state = after({}, {Action::Kind::Search});
  finder.look_up(state);
  std::vector<std::string> names;
  Action hunting;
  for (const Control& control : controls_of(tagged, state, 60)) {
    if (control.role != Role::ListItem) continue;
    names.push_back(control.name);
    if (control.name.starts_with("subject:")) hunting = control.action;
  }
  EXPECT_THAT(names, Contains("gallery:bronzes"));
  EXPECT_THAT(names, Contains("subject:" + tagged.exhibits[3].id));
  EXPECT_THAT(names, Contains("period:" + tagged.exhibits[9].id));

  state = after(state, hunting);
  finder.look_up(state);

  EXPECT_THAT(std::vector(state.found.entry.begin(), state.found.entry.begin() + state.found.count),
              ElementsAre(3, 9));
  state = after(state, {Action::Kind::Clear});
  EXPECT_FALSE(state.browses);
}

TEST(AFinder, ForgetsWhatItFoundForALetterThatIsTakenBack) {
  InterfaceState state = after({}, {Action::Kind::Search});
  state = after(state, {Action::Kind::Type, u'b'});
  Finder finder(museum());
  finder.look_up(state);
  ASSERT_GT(state.found.total, 0U);

  state = after(state, {Action::Kind::Erase});

  EXPECT_EQ(state.found.count, 0);
  EXPECT_FALSE(state.found.is_current);
  EXPECT_EQ(state.typed, Typed{});
}

TEST(Searching, LeavesNothingForTheNextVisitor) {
  InterfaceState state = after({}, {Action::Kind::Search});
  for (const char16_t letter : std::u16string_view(u"bronze"))
    state = after(state, {Action::Kind::Type, letter});
  state = after(state, {Action::Kind::TypeNumbers, 1});
  Finder(museum()).look_up(state);
  ASSERT_EQ(state.screen, Screen::Searching);

  state = after(state, {Action::Kind::Home});
  state.can_resume = false;

  EXPECT_EQ(state, InterfaceState{});
}

TEST(Searching, GoesWhereWhatWasFoundIsAndComesBackToTheSameLetters) {
  InterfaceState state = after({}, {Action::Kind::Search});
  state = after(state, {Action::Kind::Type, u'b'});
  Finder(museum()).look_up(state);
  const Typed typed = state.typed;

  state = after(state, meant_by(museum(), state.found.entry[0]));
  EXPECT_EQ(state.screen, Screen::Walking);
  state = after(after(state, {Action::Kind::ShowExhibits}), {Action::Kind::Search});

  EXPECT_EQ(state.screen, Screen::Searching);
  EXPECT_EQ(state.typed, typed);
}

TEST(Searching, TakesNoMoreLettersThanItHasRoomFor) {
  InterfaceState state = after({}, {Action::Kind::Search});
  for (int i = 0; i < 100; ++i) state = after(state, {Action::Kind::Type, u'a'});

  EXPECT_EQ(state.typed.count, Typed::most);
}

}  // namespace
}  // namespace docent::interface::finder_test
