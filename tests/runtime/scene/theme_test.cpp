#include "runtime/scene/theme.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>

#include "runtime/scene/look.h"

namespace docent::scene::theme_test {
namespace {

constexpr float of_what_is_touched = 3;

constexpr std::array nights{false, true}, contrasts{false, true};

void expect_to_be_read(const Livery& livery) {
  for (const bool is_night : nights)
    for (const bool is_high : contrasts) {
      const Theme theme = theme_of(livery, is_high, is_night);
      EXPECT_GE(contrast(theme.ink, theme.paper), least_of_text);
      EXPECT_GE(contrast(theme.quiet_ink, theme.paper), least_of_text);
      EXPECT_GE(contrast(theme.ink, theme.plaster), least_of_text) << "what is chosen";
      EXPECT_GE(contrast(theme.invitation, theme.paper), least_of_invitation);
      EXPECT_GE(contrast(theme.focus, theme.paper), least_of_focus);
    }
}

TEST(AThemesLetters, AreToldFromItsPaperAndItsFills) {
  expect_to_be_read({});
}

/// A colour that content/compile/compile_livery.cpp takes.
std::uint32_t any_colour(const Colour& paper, float least) {
  const auto colour = *rc::gen::inRange<std::uint32_t>(0, 0x1000000);
  const float most = 0.97F * ((luminance(paper) + 0.05F) / least - 0.05F);
  return hex_of(deepened(srgb(colour), most));
}

RC_GTEST_PROP(AThemesLetters, AreToldInEveryMuseumsOwnColours, ()) {
  Livery livery;
  const auto colour = *rc::gen::inRange<std::uint32_t>(0, 0x1000000);
  livery.paper = hex_of(lifted(srgb(colour), 1.02F * least_paper));
  const Colour paper = srgb(livery.paper);
  livery.ink = any_colour(paper, least_of_text);
  livery.accent = any_colour(paper, least_of_invitation);
  livery.focus = any_colour(paper, least_of_focus);

  expect_to_be_read(livery);
  RC_ASSERT(!testing::Test::HasFailure());
}

Livery in_colours(std::uint32_t paper, std::uint32_t ink) {
  Livery livery;
  livery.paper = paper;
  livery.ink = ink;
  return livery;
}

TEST(ALightPaper, IsOneOnWhichWaysAndGuidesAreTold) {
  const Colour darkest{least_paper, least_paper, least_paper};
  for (const RouteKindInfo& kind : route_kinds)
    if (kind.kind != RouteKind::Offset) {  // which has an edge: way_panel.cpp
      EXPECT_GE(contrast(srgb(kind.colour), darkest), of_what_is_touched) << kind.name;
    }
}

TEST(AMuseumsColours, AreLeftToWhoSeesLittleAsBlackOnWhite) {
  const Theme theme = theme_of(in_colours(0xFFE0E0, 0x400000), true, false);
  EXPECT_EQ(theme.paper, srgb(0xFFFFFF));
  EXPECT_EQ(theme.ink, srgb(0x000000));
}

TEST(AMuseumsColours, ChangePlacesAtNight) {
  const Theme night = theme_of(in_colours(0xE0ECFF, 0x0A1A4A), false, true);
  EXPECT_GT(night.paper.b, 2 * night.paper.r) << "the blue of its ink";
  EXPECT_GT(night.ink.b, night.ink.r) << "and of its paper";
  EXPECT_LT(luminance(night.paper), 0.02F);
}

/// gles/shaders/light.glsl: what level ground shows. `sky` and `sun` are the shares that arrive.
float shown_floor(const Colour& albedo, const Light& light, float sky, float sun) {
  const auto channel = [&](float own, float sky_light, float sun_light, float bounced) {
    const float occluded = sky * (1 + bounced * (1 - sky));
    const float c = own * (sky_light * occluded + sun_light * sun) + 0.004F;
    return c * (1 + c * 0.16F) / (1 + c * 0.30F);
  };
  return luminance({channel(albedo.r, light.sky.r, light.sun.r, 0.30F),
                    channel(albedo.g, light.sky.g, light.sun.g, 0.24F),
                    channel(albedo.b, light.sky.b, light.sun.b, 0.16F)});
}

TEST(AWayAtNight, IsToldFromEveryFloorInLightAndInShade) {
  constexpr float darkest = 0.78F;  // of its own light, in the shade: ribbon.frag
  constexpr float soap = 0.08F, lightest_plank = 1.12F;
  const Light& night = light_of({}, true);
  const Theme house;
  const Colour oak = mixed(house.oak, house.plaster, soap);
  for (const Colour& floor : {oak, house.stone})
    for (const float sun : {0.0F, 1.0F})
      for (const RouteKindInfo& kind : route_kinds) {
        const float ground = lightest_plank * shown_floor(floor, night, 1, sun);
        const float way = luminance(lifted(route_colour(kind.kind), night.least_way)) *
                          (darkest + (1 - darkest) * sun);
        EXPECT_GE(contrast(way, ground), of_what_is_touched) << kind.name << " sun " << sun;
      }
}

TEST(AWayAtNight, HasOnThePanelTheColourThatItHasOnTheFloor) {
  for (std::size_t look = 0; look < guide_look_count; ++look)
    EXPECT_EQ(lifted(trail_colour(look), theme_of({}, false, true).least_way),
              lifted(trail_colour(look), light_of({}, true).least_way));
  for (const RouteKindInfo& kind : route_kinds) {
    const Colour way = lifted(route_colour(kind.kind), theme_of({}, false, true).least_way);
    EXPECT_GE(contrast(luminance(way), luminance(theme_of({}, false, true).paper)),
              of_what_is_touched);
    EXPECT_GE(contrast(luminance(way), luminance(theme_of({}, false, true).plaster)),
              of_what_is_touched);
  }
}

TEST(AColourThatIsLifted, IsAsBrightAsItIsWantedAndKeepsItsHueWhereItCan) {
  for (const std::uint32_t hex : {0xD2452DU, 0x1D7874U, 0xC0841AU, 0x223276U, 0x000000U}) {
    const Colour bright = lifted(srgb(hex), 0.27F);
    EXPECT_NEAR(luminance(bright), std::max(0.27F, luminance(srgb(hex))), 1e-3F);
  }
  EXPECT_EQ(lifted(srgb(0xF0E8DA), 0.27F), srgb(0xF0E8DA));
  EXPECT_EQ(hex_of(srgb(0x1D7874)), 0x1D7874U);
}

TEST(ALight, IsBetweenTwoOthersWhereItIsAskedFor) {
  const Light &day = light_of({}, false), &night = light_of({}, true);

  EXPECT_EQ(mixed(day, night, 0), day);
  EXPECT_EQ(mixed(day, night, 1), night);
  EXPECT_LT(luminance(mixed(day, night, 0.5F).paper), luminance(day.paper));
}

}  // namespace
}  // namespace docent::scene::theme_test
