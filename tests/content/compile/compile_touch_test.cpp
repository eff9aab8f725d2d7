#include "content/compile/compile_touch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "runtime/schema/invariants.h"
#include "tests/content/compile/thing_folder.h"
#include "tests/support/sanitized.h"

namespace docent::compile::compile_touch_test {
namespace {

using test_things::Compiled;
using test_things::Folder;
using ::testing::Contains;

using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* vitrine =
    "[[case]]\nid = \"vitrine\"\nposition = [3.0, 6.0]\nfacing = 270\nsize = [1.6, 0.7]\n";

/// As GeoJSON, clockwise: a round pedestal; a large one is low.
std::string round_hole(Vec2 middle, double radius) {
  constexpr int corners = 24;
  std::string ring;
  for (int i = 0; i <= corners; ++i) {
    const double angle = -2 * std::numbers::pi * (i % corners) / corners;
    ring += fmt::format("{}[{:.4f}, {:.4f}]", i > 0 ? ", " : "[",
                        middle.x + radius * std::cos(angle), middle.y + radius * std::sin(angle));
  }
  return ring + "]";
}

const Exhibit& thing(const Museum& museum) {
  return *std::ranges::find(museum.exhibits, "thing", &Exhibit::id);
}

TEST(CompileTouch, MarksWhatStandsFreeOrHangs) {
  const Compiled free = Folder("position = [3.0, 6.0]\ntouch = true\n").compiled(false, false);
  const Compiled hung = Folder("position = [5.0, 8.0]\ntouch = true\n").compiled(false, false);
  const Compiled plain = Folder("position = [3.0, 6.0]\ntouch = false\n").compiled(false, false);

  ASSERT_TRUE(free.museum && hung.museum && plain.museum);
  EXPECT_EQ(thing(*free.museum).place, ExhibitPlace::ToTouch);
  EXPECT_EQ(thing(*hung.museum).place, ExhibitPlace::OnWallToTouch);
  EXPECT_EQ(thing(*plain.museum).place, ExhibitPlace::OnFloor);
  EXPECT_EQ(schema::broken_invariant(*free.museum), "");
  EXPECT_EQ(schema::broken_invariant(*hung.museum), "");
}

TEST(CompileTouch, TellsOfWhatIsUnderGlassInACheckToo) {
  Folder folder("in = \"vitrine\"\ntouch = true\n");
  folder.it.replace("museum.toml", "[ambient]", std::string(vitrine) + "[ambient]");
  for (const bool only_check : {false, true}) {
    const Compiled cased = folder.compiled(false, only_check);

    ASSERT_TRUE(cased.museum);
    EXPECT_EQ(thing(*cased.museum).place, ExhibitPlace::InCase);
    EXPECT_THAT(cased.told,
                Contains("touch-out-of-reach: the guide does not touch exhibit 'thing', and points "
                         "at it: it stands under glass"));
  }
}

TEST(WhatStandsOnAPedestal, IsNotSaidToBeInAGlassCase) {
  Folder folder("position = [2.6, 5.8]\n");
  folder.it.replace("ground.geojson", "[[6, 4],", round_hole({2.6, 5.8}, 0.6) + ",\n  [[6, 4],");
  for (const bool only_check : {false, true}) {
    const Compiled stands = folder.compiled(false, only_check);

    ASSERT_TRUE(stands.museum) << ::testing::PrintToString(stands.told);
    EXPECT_EQ(thing(*stands.museum).place, ExhibitPlace::OnFloor);
  }
}

TEST(CompileTouch, FindsTheSameInACheckAsWhenAllIsMade) {
  NEEDS_SPEED();
  const Folder folder("position = [3.0, 5.0]\ntouch = true\n");
  const Compiled made = folder.compiled(true, false), checked = folder.compiled(true, true);

  ASSERT_TRUE(made.museum && checked.museum);
  EXPECT_FALSE(thing(*made.museum).touches.empty());
  EXPECT_EQ(schema::encode(thing(*checked.museum).touches),
            schema::encode(thing(*made.museum).touches));
  EXPECT_EQ(schema::broken_invariant(*made.museum), "");
  EXPECT_THAT(made.told, Not(Contains(HasSubstr("touch-out-of-reach"))));
  EXPECT_EQ(checked.told, made.told);
}

TEST(CompileTouch, TakesEachOfTwoOnOnePedestalForWhatItIs) {
  Folder two("position = [2.3, 5.8]\nheight = 0.1\ntouch = true\n");
  two.it.replace("ground.geojson", "[[6, 4],", round_hole({2.6, 5.8}, 1.1) + ",\n  [[6, 4],");
  two.it.write("exhibits/other.toml",
               "[[exhibit]]\nid = \"other\"\nfacing = 270\ntitle.en = \"Other\"\n"
               "title.ar = \"آخر\"\nimage = \"images/disc.svg\"\nposition = [2.9, 5.8]\n"
               "touch = true\n");

  EXPECT_THAT(two.compiled(false, true).told, Not(Contains(HasSubstr("glass"))));
}

TEST(CompileTouch, TellsInACheckOfWhatNoHandGetsTo) {
  const Compiled deep = Folder("position = [3.5, 5.0]\nsize = 2.4\nheight = 0.1\ntouch = true\n")
                            .compiled(true, true);
  ASSERT_TRUE(deep.museum) << ::testing::PrintToString(deep.told);
  EXPECT_THAT(deep.told, Contains(HasSubstr("from where the guide, 0.50 m wide, can stand beside "
                                            "it, its arm is too short")));
  EXPECT_EQ(thing(*deep.museum).place, ExhibitPlace::ToTouch) << "visitors may, all the same";
  EXPECT_TRUE(thing(*deep.museum).touches.empty());

  Folder low("position = [2.6, 5.8]\nheight = 0.1\ntouch = true\n");
  low.it.replace("ground.geojson", "[[6, 4],", round_hole({2.6, 5.8}, 1.1) + ",\n  [[6, 4],");
  const Compiled lies = low.compiled(true, true);
  ASSERT_TRUE(lies.museum) << ::testing::PrintToString(lies.told);
  EXPECT_THAT(lies.told, Contains(HasSubstr("its top is only 0.46 m above the floor")));
}

}  // namespace
}  // namespace docent::compile::compile_touch_test
