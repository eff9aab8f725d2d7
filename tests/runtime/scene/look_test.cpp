#include "runtime/scene/look.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <span>
#include <string>

namespace docent::scene::look_test {
namespace {

using Rgb = glm::dvec3;  // linear light

Rgb linear(std::uint32_t hex) {
  const Colour c = srgb(hex);
  return {c.r, c.g, c.b};
}

/// CIE 1976 L*a*b* of linear sRGB, white D65.
glm::dvec3 lab(Rgb c) {
  c = glm::clamp(c, 0.0, 1.0);
  const glm::dvec3 xyz{
      (0.4124564 * c.r + 0.3575761 * c.g + 0.1804375 * c.b) / 0.95047,
      0.2126729 * c.r + 0.7151522 * c.g + 0.0721750 * c.b,
      (0.0193339 * c.r + 0.1191920 * c.g + 0.9503041 * c.b) / 1.08883,
  };
  const auto f = [](double t) {
    return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116;
  };
  return {116 * f(xyz.y) - 16, 500 * (f(xyz.x) - f(xyz.y)), 200 * (f(xyz.y) - f(xyz.z))};
}

/// How someone sees: what their cones make of linear sRGB. Machado, Oliveira and Fernandes 2009, "A
/// physiologically-based model for simulation of color vision deficiency", table 1, severity 1.
struct Eyes {
  const char* name;
  std::array<Rgb, 3> rows;

  Rgb see(Rgb c) const {
    return {glm::dot(rows[0], c), glm::dot(rows[1], c), glm::dot(rows[2], c)};
  }
};

constexpr std::array<Eyes, 4> everybody{{
    {"all cones", {Rgb{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
    {"protanopia",
     {Rgb{0.152286, 1.052583, -0.204868},
      {0.114503, 0.786281, 0.099216},
      {-0.003882, -0.048116, 1.051998}}},
    {"deuteranopia",
     {Rgb{0.367322, 0.860646, -0.227968},
      {0.280085, 0.672501, 0.047413},
      {-0.011820, 0.042940, 0.968881}}},
    {"tritanopia",
     {Rgb{1.255528, -0.076749, -0.178779},
      {-0.078411, 0.930809, 0.147602},
      {0.004733, 0.691367, 0.303900}}},
}};

double apart(const Eyes& eyes, std::uint32_t a, std::uint32_t b) {
  return glm::distance(lab(eyes.see(linear(a))), lab(eyes.see(linear(b))));
}

double lightness(std::uint32_t hex) {
  return lab(linear(hex)).x;
}

constexpr std::span<const Look> guides = std::span(looks).first(guide_look_count);

/// Calls `check` for every two guides.
template <typename Check>
void every_two_guides(Check check) {
  for (std::size_t i = 0; i < guides.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) check(guides[i], guides[j]);
}

TEST(ALook, OfAGuideHasAColourThatNobodyTakesForAnothers) {
  constexpr double clearly_apart = 15;  // 2.3 is just noticeable side by side
  for (const Eyes& eyes : everybody)
    every_two_guides([&](const Look& a, const Look& b) {
      EXPECT_GE(apart(eyes, a.coat, b.coat), clearly_apart)
          << a.name << " and " << b.name << " with " << eyes.name;
    });
}

TEST(ALook, OfAGuideLeavesATrailThatEverybodySeesOnOakAndStone) {
  constexpr std::uint32_t oak = 0xB98F62, stone = 0xBDB6A8;
  for (const Eyes& eyes : everybody)
    for (const Look& look : guides)
      for (const std::uint32_t floor : {oak, stone})
        EXPECT_GE(apart(eyes, look.coat, floor), 15) << look.name << " with " << eyes.name;
}

TEST(ALook, OfAGuideIsToldApartWithoutAnyColour) {
  every_two_guides([](const Look& a, const Look& b) {
    EXPECT_NE(a.outline.crown, b.outline.crown) << a.name << " and " << b.name;
    EXPECT_NE(a.figure, b.figure) << a.name << " and " << b.name;
  });
}

TEST(ALook, OfAGuideShowsItsTurbanOrScarfInGrey) {
  for (const Look& look : guides)
    if (look.outline.crown == Crown::Turban || look.outline.crown == Crown::Scarf) {
      EXPECT_GE(std::abs(lightness(look.coat) - lightness(look.second)), 20) << look.name;
    }
}

TEST(ALook, OfAStrollingVisitorIsQuieterThanAnyGuides) {
  const auto chroma = [](const Look& look) {
    const glm::dvec3 c = lab(linear(look.coat));
    return std::hypot(c.y, c.z);
  };
  const auto strolling = std::span(looks).subspan(guide_look_count);

  for (const Look& look : strolling) EXPECT_LT(chroma(look), 15) << look.name;
}

TEST(ALook, StretchesNobodyBeyondWhatAPersonIs) {
  for (const Look& look : looks) {
    EXPECT_GE(look.height, 0.94F) << look.name;
    EXPECT_LE(look.height, 1.06F) << look.name;
    EXPECT_GE(look.outline.shoulders, 0.85F) << look.name;
    EXPECT_LE(look.outline.shoulders, 1.2F) << look.name;
  }
}

TEST(ALook, HasANameOfItsOwn) {
  for (std::size_t i = 0; i < looks.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(looks[i].name, looks[j].name);
}

}  // namespace
}  // namespace docent::scene::look_test
