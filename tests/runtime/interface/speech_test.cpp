#include "runtime/interface/speech.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "runtime/interface/layout.h"
#include "tests/runtime/interface/any_request.h"
#include "tests/support/sample_museum.h"
#include "tests/support/shipped_languages.h"

namespace docent::interface::speech_test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

const Museum& museum() {
  static const Museum it = [] {
    Museum all = test::in_all_shipped_languages(test::sample_museum_without_walls());
    all.floors.front().title = {{"en", "Ground floor"}};
    Floor above = all.floors.front();
    above.plan.name = "upper";
    above.title = {{"en", "Upper floor"}};
    all.floors.push_back(above);
    add_pictures_and_more(all);
    return all;
  }();
  return it;
}

Speech speech_in(const ViewRequest& request, const ShownWay* way = nullptr) {
  return speech_of(museum(), request, controls_of(museum(), request.state, 6), {}, way);
}

/// All pieces of each language, made once.
const std::set<std::string>& prepared(const std::string& tag) {
  static const std::map<std::string, std::set<std::string>> all = [] {
    std::map<std::string, std::set<std::string>> by_language;
    for (std::uint32_t i = 0; i < museum().languages.size(); ++i)
      for (std::string& piece : spoken_pieces(museum(), i))
        by_language[museum().languages[i].tag].insert(std::move(piece));
    return by_language;
  }();
  return all.at(tag);
}

void expect_prepared(const Utterance& said) {
  for (const SpokenPiece& piece : said.pieces) {
    RC_LOG() << said.language << ": " << piece.text << "\n";
    RC_ASSERT(prepared(said.language).contains(piece.text));
  }
}

/// A museum that says one word in some of its languages.
Museum that_speaks(std::vector<std::uint32_t> languages) {
  Museum speaking = museum();
  for (const std::uint32_t language : languages)
    speaking.speech.push_back({.language = language,
                               .text = "x",
                               .made_of = {},
                               .skip = 0,
                               .samples = 480,
                               .packets = {}});
  return speaking;
}

std::string language_of_help(const Museum& of, std::uint32_t language) {
  ViewRequest request;
  request.state.language = language;
  return speech_of(of, request, controls_of(of, request.state, 6), {}, nullptr).help.language;
}

TEST(Speech, IsHeardInALanguageThatHasSoundsByThoseWhoseOwnHasNone) {
  const std::string read = museum().languages[3].tag;

  EXPECT_EQ(language_of_help(that_speaks({0, 3}), 3), read);
  EXPECT_EQ(language_of_help(that_speaks({0}), 3), museum().languages[0].tag);
  EXPECT_EQ(language_of_help(that_speaks({1, 2}), 3), museum().languages[1].tag);
  EXPECT_EQ(language_of_help(that_speaks({}), 3), read) << "there is nothing to fall back to";
}

TEST(Speech, IsNotHeardInALanguageInWhichASoundOfTheMuseumIsAll) {
  Museum speaking = that_speaks({0, 3});
  speaking.speech.back().text = RecordingKey(0).text();

  EXPECT_EQ(language_of_help(speaking, 3), museum().languages[0].tag);
}

TEST(Speech, IsMadeOfPreparedPiecesAloneInEveryLanguage) {
  EXPECT_TRUE(rc::check("screens, ways and languages", [] {
    const ViewRequest request = any_request(museum());
    const ShownWay way{.directions = any_directions(museum()), .line = {}};
    const Speech speech = speech_in(request, *rc::gen::arbitrary<bool>() ? &way : nullptr);

    expect_prepared(speech.opening);
    expect_prepared(speech.help);
    expect_prepared(speech.ended);
    for (const Utterance& control : speech.controls) expect_prepared(control);
    for (const CountedUtterance& counted : speech.remaining) expect_prepared(counted.said);
    for (const Utterance& volume : speech.volumes) expect_prepared(volume);
    for (const Utterance& speed : speech.speeds) expect_prepared(speed);
    RC_ASSERT(!speech.opening.empty());
    RC_ASSERT(!speech.help.empty());
  }));
}

/// Every screen, on a glass of one's own and on a card.
std::vector<ViewRequest> every_screen() {
  std::vector<ViewRequest> all;
  for (const Screen screen : {Screen::Welcome, Screen::Picking, Screen::Choosing, Screen::Walking,
                              Screen::Arrived, Screen::Searching})
    for (const bool is_on_card : {false, true}) {
      ViewRequest request;
      request.state.screen = screen;
      if (screen == Screen::Walking || screen == Screen::Arrived) request.state.exhibit = 0;
      request.state.arrived = screen == Screen::Arrived;
      if (is_on_card) {
        request.state.glass = Glass::Busy;
        request.state.seats = 2;
        request.state.seat = 1;
        request.state.look = 1;
      }
      for (const Listed lists : {Listed::Exhibits, Listed::Places, Listed::Languages}) {
        if (lists != Listed::Exhibits && screen != Screen::Choosing) continue;
        request.state.lists = lists;
        all.push_back(request);
      }
    }
  return all;
}

std::string_view role_of(Role role) {
  switch (role) {
    case Role::Button:
      return "role_button";
    case Role::ListItem:
      return "role_item";
    case Role::Spot:
      return "role_spot";
    case Role::Choice:
      return "role_choice";
  }
  return {};
}

TEST(Speech, SaysNameRoleAndStateOfEveryControl) {
  for (ViewRequest request : every_screen())
    for (std::uint32_t language = 0; language < museum().languages.size(); ++language) {
      request.state.language = language;
      const auto controls = controls_of(museum(), request.state, 6);
      const Speech speech = speech_of(museum(), request, controls, {}, nullptr);
      ASSERT_EQ(speech.controls.size(), controls.size());
      for (std::size_t i = 0; i < controls.size(); ++i) {
        const Control& control = controls[i];
        const Utterance& said = speech.controls[i];
        ASSERT_GE(said.pieces.size(), 2U) << control.name << " has a name and a role";
        EXPECT_TRUE(said.pieces.back().pause);
        const std::uint32_t heard_in =
            control.action.kind == Action::Kind::Speak ? control.action.argument : language;
        const auto says = [&](std::string_view key) {
          return std::ranges::find(said.pieces.begin() + 1, said.pieces.end(),
                                   word(museum(), heard_in, key),
                                   &SpokenPiece::text) != said.pieces.end();
        };
        EXPECT_EQ(says("state_selected"), control.selected) << control.name;
        EXPECT_EQ(says("state_disabled"), !control.enabled) << control.name;
        for (const Role role : {Role::Button, Role::ListItem, Role::Spot, Role::Choice}) {
          const bool is_called_so = word(museum(), heard_in, role_of(role)) ==
                                    word(museum(), heard_in, role_of(control.role));
          EXPECT_EQ(says(role_of(role)), is_called_so) << control.name << " in " << said.language;
        }
      }
    }
}

TEST(Speech, TellsButtonsThatDoNotDoTheSameApart) {
  for (ViewRequest request : every_screen()) {
    const auto controls = controls_of(museum(), request.state, 6);
    const Speech speech = speech_of(museum(), request, controls, {}, nullptr);
    std::map<std::string, std::string> heard;
    for (std::size_t i = 0; i < controls.size(); ++i) {
      if (!is_collect(controls[i])) continue;
      const std::string said = text_of(speech.controls[i]);
      EXPECT_TRUE(heard.emplace(said, controls[i].name).second)
          << said << " is " << heard[said] << " and " << controls[i].name;
    }
  }
}

TEST(Speech, NamesEachLanguageInThatLanguage) {
  const Speech speech = speech_in({});
  const auto controls = controls_of(museum(), {}, 6);
  for (std::size_t i = 0; i < controls.size(); ++i) {
    if (controls[i].action.kind != Action::Kind::Speak) continue;
    const Language& language = museum().languages[controls[i].action.argument];
    EXPECT_EQ(speech.controls[i].language, language.tag);
    EXPECT_EQ(speech.controls[i].pieces.front().text, language.name);
  }
}

TEST(Speech, DescribesThePictureAfterTheTitle) {
  Museum described = museum();
  described.exhibits[0].title = {{"en", "Jar"}};
  described.exhibits[0].description = {{"en", "A red jar with two handles."}};
  described.exhibits[0].text = {{"en", "It held millet."}};
  ViewRequest request;
  request.state.screen = Screen::Arrived;
  request.state.arrived = true;
  request.state.exhibit = 0;

  EXPECT_EQ(text_of(speech_of(described, request, {}, {}, nullptr).opening),
            "Jar. A red jar with two handles. It held millet.");
  EXPECT_THAT(spoken_pieces(described, 0), Contains("A red jar with two handles"));
}

TEST(Speech, SaysOnArrivalThatItMayBeTouchedInEveryLanguage) {
  Museum touched = museum();
  touched.exhibits[0].title = {{"en", "Jar"}};
  touched.exhibits[0].description = {};
  touched.exhibits[0].text = {{"en", "It held millet."}};
  ViewRequest request;
  request.state.screen = Screen::Arrived;
  request.state.arrived = true;
  request.state.exhibit = 0;
  const auto opening = [&] {
    return text_of(speech_of(touched, request, {}, {}, nullptr).opening);
  };
  EXPECT_EQ(opening(), "Jar. It held millet.");
  touched.exhibits[0].place = ExhibitPlace::ToTouch;
  EXPECT_EQ(opening(), "Jar. You may touch this one. It held millet.");

  std::set<std::string_view> words;
  for (std::uint32_t i = 0; i < touched.languages.size(); ++i) {
    words.insert(word(touched, i, "may_touch"));
    request.state.language = i;
    const Utterance said = speech_of(touched, request, {}, {}, nullptr).opening;
    ASSERT_GE(said.pieces.size(), 3U) << said.language;
    EXPECT_TRUE(prepared(said.language).contains(said.pieces[1].text)) << said.pieces[1].text;
  }
  EXPECT_EQ(words.size(), touched.languages.size());
  EXPECT_FALSE(words.contains(""));
}

/// At an exhibit with three pictures and a longer text.
struct CloserLook {
  CloserLook() {
    Exhibit& jar = shown.exhibits[0];
    jar.title = {{"en", "Jar"}};
    jar.description = {{"en", "A red jar with two handles."}};
    jar.text = {{"en", "It held millet."}};
    jar.more = {{"en", "It was buried.\n\nIt was found."}};
    shown.pictures = {{.exhibit = 0,
                       .image = shown.exhibits[1].image,
                       .caption = {{"en", "The mouth"}},
                       .description = {{"en", "A ring of soot."}}},
                      {.exhibit = 0, .image = shown.exhibits[2].image}};
    state.screen = Screen::Arrived;
    state.arrived = true;
    state.exhibit = 0;
  }
  /// What is said once the control of that name has been pressed.
  std::string press(std::string_view name) {
    for (const Control& control : controls_of(shown, state, 6))
      if (control.name == name) {
        state = after(state, control.action);
        return said();
      }
    return "there is no such control";
  }
  [[nodiscard]] std::string said() const {
    ViewRequest request;
    request.state = state;
    return text_of(speech_of(shown, request, {}, {}, nullptr).opening);
  }

  Museum shown = museum();
  InterfaceState state;
};

TEST(ACloserLook, LeafsRoundAndRoundThroughThePicturesAndSaysWhichOneIsSeen) {
  CloserLook look;

  EXPECT_EQ(look.said(), "Jar. Picture 1 of 3. A red jar with two handles. It held millet.");
  EXPECT_EQ(look.press("picture:next"), "Picture 2 of 3. The mouth. A ring of soot.");
  EXPECT_EQ(look.press("picture:next"), "Picture 3 of 3.");
  EXPECT_EQ(look.press("picture:next"), "Picture 1 of 3. A red jar with two handles.");
  EXPECT_EQ(look.press("picture:previous"), "Picture 3 of 3.");
}

TEST(ACloserLook, KeepsTheFocusWhereOneLeafs) {
  CloserLook look;
  const auto keeps_focus = [&] {
    ViewRequest request;
    request.state = look.state;
    return speech_of(look.shown, request, {}, {}, nullptr).keeps_focus;
  };

  EXPECT_FALSE(keeps_focus()) << "the exhibit is read from its beginning";
  look.press("picture:next");
  EXPECT_TRUE(keeps_focus());
}

TEST(ACloserLook, ReadsTheLongerTextLineByLineAndComesBack) {
  CloserLook look;

  look.press("picture:next");
  EXPECT_EQ(look.press("more"), "Jar. It was buried. It was found.");
  EXPECT_THAT(spoken_pieces(look.shown, 0), Contains("It was found"));
  EXPECT_EQ(look.press("picture:next"), "there is no such control");
  EXPECT_EQ(look.press("less"), "Jar. Picture 1 of 3. A red jar with two handles. It held millet.");
}

TEST(ACloserLook, BeginsAtTheFirstPictureOfTheNextExhibit) {
  CloserLook look;
  look.press("picture:next");
  look.press("more");

  look.state = after(look.state, {Action::Kind::Choose, 1});

  EXPECT_FALSE(look.state.picture);
  EXPECT_FALSE(look.state.tells_more);
}

TEST(Speech, TellsOnTheWayTheThreeSentencesAndThenTheText) {
  ViewRequest request;
  request.state.screen = Screen::Walking;
  request.state.exhibit = 0;
  ShownWay way;
  way.directions.parts.push_back(
      {.room = 0,
       .doors = {{.from = 0, .to = 1, .side = directions::Side::Right, .nth = 2, .of = 3}},
       .turns = {}});
  way.directions.goal = {
      .room = 1, .setting = directions::Setting::InCase, .where = directions::Where::Left};
  way.directions.metres = 32.4;
  way.directions.seconds = 30;

  const Speech walking = speech_in(request, &way);
  EXPECT_THAT(text_of(walking.opening), HasSubstr("the second door on the right"));
  EXPECT_THAT(text_of(walking.opening), HasSubstr("in a glass case on your left"));
  EXPECT_THAT(text_of(walking.opening), HasSubstr("30 metres about half a minute step-free"));
  ASSERT_GE(walking.remaining.size(), 2U);
  EXPECT_EQ(text_of(walking.remaining.front().said), "30 metres to go.");
  EXPECT_EQ(text_of(walking.remaining.back().said), "Nearly there.");

  request.state.screen = Screen::Arrived;
  request.state.arrived = true;
  const std::string text = museum().exhibits[0].text.at("en");
  EXPECT_THAT(text_of(speech_in(request).opening), HasSubstr(text.substr(0, text.size() - 1)));
}

TEST(Speech, SaysWhyThereIsNoWay) {
  ViewRequest request;
  request.state.screen = Screen::Walking;
  request.state.exhibit = 0;
  request.route_summary =
      RouteSummary{.status = path::RouteStatus::NoRoute, .hindrance = Hindrance::Door};

  EXPECT_THAT(text_of(speech_in(request).opening), HasSubstr("A door on the way there is closed"));
  EXPECT_THAT(text_of(speech_in(request).opening), Not(HasSubstr("Follow me")));
}

}  // namespace
}  // namespace docent::interface::speech_test
