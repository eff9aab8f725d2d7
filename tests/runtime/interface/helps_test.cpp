#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <tuple>

#include "runtime/interface/layout.h"
#include "runtime/interface/on_glass.h"
#include "tests/runtime/interface/boxes.h"
#include "tests/support/sample_museum.h"
#include "tests/support/shipped_languages.h"

namespace docent::interface::helps_test {
namespace {

/// With stairs and an escalator, so that there is all that helps.
Museum in_all_languages() {
  Museum museum = test::in_all_shipped_languages(test::sample_museum_without_walls());
  for (const ConnectionKind kind : {ConnectionKind::Stairs, ConnectionKind::Escalator})
    museum.connections.emplace_back().kind = kind;
  return museum;
}

constexpr std::array glasses{std::tuple{1024U, 768U, 24.0F},  std::tuple{768U, 1024U, 24.0F},
                             std::tuple{1280U, 720U, 24.0F},  std::tuple{1920U, 1080U, 24.0F},
                             std::tuple{1920U, 1080U, 32.0F}, std::tuple{1080U, 1920U, 24.0F},
                             std::tuple{1080U, 1920U, 43.0F}, std::tuple{3840U, 2160U, 65.0F},
                             std::tuple{2160U, 3840U, 55.0F}};

/// Calls `take` with every view that has helps, on every glass, in every language.
template <typename Take>
void for_each_view(const Museum& museum, const Take& take) {
  for (const auto& [width, height, inches] : glasses)
    for (const float scale : {1.0F, 1.5F, 2.0F})
      for (const bool is_low : {false, true})
        for (std::uint32_t language = 0; language < museum.languages.size(); ++language)
          for (const Screen screen : {Screen::Welcome, Screen::Choosing, Screen::Searching,
                                      Screen::Walking, Screen::Arrived}) {
            ViewRequest request;
            request.shape = {.width = width, .height = height, .diagonal_inches = inches};
            request.shape.text_scale = scale;
            request.shape.mount_mm = is_low ? 700 : 0;
            request.state.can_lower = can_be_lowered(request.shape);
            request.state.low_reach = request.state.can_lower;
            if (is_low && !request.state.low_reach) continue;
            request.state.screen = screen;
            request.state.language = language;
            request.state.lists = Listed::Places;
            if (screen == Screen::Walking || screen == Screen::Arrived) request.state.exhibit = 2;
            request.state.arrived = screen == Screen::Arrived;
            PieceCache cache({test::boxes, {}}, 1, 1 << 20);
            take(request, *make_view(museum, request, cache));
          }
}

TEST(Helps, AreSaidInWordsOnEveryGlassInEveryLanguage) {
  const Museum museum = in_all_languages();
  std::size_t said = 0;
  for_each_view(museum, [&](const ViewRequest& request, const View& view) {
    const scene::Rect model = free_part_of(shape_for(request.shape, request.state), false);
    float top = 1e9F, bottom = 0;
    for (std::size_t i = 0; i < view.controls.size(); ++i) {
      const Control& control = view.controls[i];
      constexpr std::array<std::string_view, 6> helps{"step-free", "no-escalators", "search",
                                                      "toilets",   "places",        "exhibits"};
      if (std::ranges::find(helps, control.name) == helps.end() || control.rect.width <= 0)
        continue;
      ++said;
      top = std::min(top, control.rect.y);
      bottom = std::max(bottom, control.rect.y + control.rect.height);
      EXPECT_TRUE(std::ranges::any_of(view.elements,
                                      [&](const Element& element) {
                                        return element.control == static_cast<std::int32_t>(i) &&
                                               element.words >= 0;
                                      }))
          << control.name << " on " << request.shape.width << " x " << request.shape.height << ", "
          << request.shape.diagonal_inches << " inches, letters " << request.shape.text_scale
          << (request.state.low_reach ? ", lowered" : "") << ", screen "
          << static_cast<int>(request.state.screen) << ", "
          << museum.languages[request.state.language].tag;
    }
    const ReachableBand band =
        request.state.low_reach ? low_reach_of(request.shape) : ReachableBand{};
    const float height = (bottom - top) / (band.bottom - band.top) / model.height;
    EXPECT_LE(height, 0.45F) << "the model is still seen";
  });
  EXPECT_GT(said, 1000U);
}

}  // namespace
}  // namespace docent::interface::helps_test
