// Everything that a visitor reads or hears comes out of the words of their language, and fits in
// one that is half as long again and may run from the right.

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cctype>

#include "runtime/interface/layout.h"
#include "runtime/interface/on_glass.h"
#include "runtime/interface/speech.h"
#include "tests/runtime/interface/any_request.h"
#include "tests/runtime/interface/boxes.h"
#include "tests/runtime/interface/pseudo_language.h"
#include "tests/support/sample_museum.h"

namespace docent::interface::pseudo_language_test {
namespace {

using test::boxes;
using test::Pseudo;

/// Has this been translated? English letters were not.
bool is_translated(std::string_view text) {
  return std::ranges::none_of(text,
                              [](unsigned char c) { return std::isalpha(c) != 0 && c < 128; });
}

Museum museum_in(Pseudo kind) {
  Museum museum = test::in_pseudo_language(test::sample_museum_without_walls(), kind);
  museum.floors.push_back(museum.floors.front());
  museum.floors.back().title = {
      {museum.languages.front().tag, test::in_pseudo(kind, "Upper floor")}};
  museum.floors.front().title = {
      {museum.languages.front().tag, test::in_pseudo(kind, "Ground floor")}};
  return museum;
}

class PseudoLanguage : public testing::TestWithParam<Pseudo> {
 protected:
  Museum museum_ = museum_in(GetParam());
};

TEST_P(PseudoLanguage, IsAllThatIsShown) {
  EXPECT_TRUE(rc::check("every screen", [this] {
    ViewRequest request = any_request(museum_);
    const ShownWay way{.directions = any_directions(museum_), .line = {}};
    PieceCache cache({boxes, {}}, 1, 1 << 20);
    const auto view =
        make_view(museum_, request, cache, {}, request.route_summary ? &way : nullptr);
    for (const OnGlass& item : on_glass(museum_, *view, request.shape, 30, -1)) {
      RC_LOG() << item.name << ": " << item.label << '\n';
      RC_ASSERT(is_translated(item.label));
    }
  }));
}

TEST_P(PseudoLanguage, TellsWhatWasForgotten) {
  museum_.tours.clear();  // so that the exhibit is first
  museum_.exhibits.front().title.begin()->second = "forgotten";
  ViewRequest request;
  request.state.screen = Screen::Choosing;
  PieceCache cache({boxes, {}}, 1, 1 << 20);
  const auto view = make_view(museum_, request, cache);
  const auto items = on_glass(museum_, *view, request.shape, 30, -1);
  const auto forgotten =
      std::ranges::count_if(items, [](const OnGlass& item) { return !is_translated(item.label); });
  EXPECT_GT(forgotten, 0);
  EXPECT_LT(forgotten, 4) << "in the list, on the model, and nowhere else";
}

TEST_P(PseudoLanguage, IsAllThatIsSaid) {
  EXPECT_TRUE(rc::check("every screen", [this] {
    const ViewRequest request = any_request(museum_);
    const ShownWay way{.directions = any_directions(museum_), .line = {}};
    const Speech speech = speech_of(museum_, request, controls_of(museum_, request.state, 6), {},
                                    *rc::gen::arbitrary<bool>() ? &way : nullptr);
    const auto check = [](const Utterance& said) {
      for (const SpokenPiece& piece : said.pieces) {
        RC_LOG() << piece.text << '\n';
        RC_ASSERT(is_translated(piece.text));
      }
    };
    check(speech.opening);
    check(speech.help);
    check(speech.ended);
    for (const Utterance& control : speech.controls) check(control);
    for (const CountedUtterance& counted : speech.remaining) check(counted.said);
    for (const Utterance& volume : speech.volumes) check(volume);
    for (const Utterance& speed : speech.speeds) check(speed);
  }));
}

TEST_P(PseudoLanguage, FitsOnEveryScreen) {
  EXPECT_TRUE(rc::check("every screen and size", [this] {
    ViewRequest request = any_request(museum_);
    const auto [width, height] =
        *rc::gen::element(std::pair{1024U, 768U}, std::pair{1920U, 1080U}, std::pair{1080U, 1920U});
    request.shape = {.width = width, .height = height, .diagonal_inches = 32};
    request.state.large_letters = *rc::gen::arbitrary<bool>();
    PieceCache cache({boxes, {}}, 1, 1 << 20);
    const auto view = make_view(museum_, request, cache);
    const auto items = on_glass(museum_, *view, request.shape, 1e6F, -1);
    for (const auto& [a, b] : overlaps(items, request.shape))
      RC_LOG() << items[a].name << " '" << items[a].label << "' and " << items[b].name << " '"
               << items[b].label << "'\n";
    RC_ASSERT(overlaps(items, request.shape).empty());
    RC_ASSERT(outside(items, request.shape).empty());
  }));
}

INSTANTIATE_TEST_SUITE_P(Both, PseudoLanguage,
                         testing::Values(Pseudo::Accented, Pseudo::RightToLeft),
                         [](const auto& kind) {
                           return kind.param == Pseudo::Accented ? "Accented" : "RightToLeft";
                         });

}  // namespace
}  // namespace docent::interface::pseudo_language_test
