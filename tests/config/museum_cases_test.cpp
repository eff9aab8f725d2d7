#include "config/museum_cases.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/museum_folder.h"

namespace docent::config::museum_cases_test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// The small museum with a case that looks west, in which its disc stands as it is written.
Loaded<MuseumConfig> with_case(const std::string& disc, const std::string& stand = {}) {
  const test::MuseumFolder folder;
  folder.replace("museum.toml", "[[room]]",
                 "[[case]]\nid = \"long-case\"\nposition = [4, 6]\nfacing = 180\n"
                 "size = [2, 0.8]\n" +
                     stand + "[[room]]");
  folder.replace("exhibits/hall.toml", "position = [6.5, 4.5]\nfacing = 270\n", disc + "\n");
  return load_museum_config(folder.path());
}

const ExhibitSection& disc_of(const Loaded<MuseumConfig>& loaded) {
  return loaded.value->exhibits.front();
}

TEST(AnExhibitInACase, StandsInItsMiddleAndLooksAsItDoes) {
  const auto museum = with_case("in = \"long-case\"");

  EXPECT_THAT(museum.diagnostics, IsEmpty());
  EXPECT_EQ(disc_of(museum).position.value, Vec2(4, 6));
  EXPECT_TRUE(disc_of(museum).position.given);
  EXPECT_EQ(disc_of(museum).facing.value, 180);
  EXPECT_EQ(museum.value->cases.front().size.value.deep, 0.8);
}

TEST(AnExhibitInACase, CountsItsPositionFromTheCasesMiddleAndTurnsWithIt) {
  const auto museum = with_case("in = \"long-case\"\nposition = [0.9, 0.3]\nfacing = 90");

  EXPECT_THAT(museum.diagnostics, IsEmpty());
  // Who stands before a front that looks west looks east: right is south.
  EXPECT_NEAR(disc_of(museum).position.value.x, 4 - 0.3, 1e-12);
  EXPECT_NEAR(disc_of(museum).position.value.y, 6 - 0.9, 1e-12);
  EXPECT_EQ(disc_of(museum).facing.value, 90);
}

TEST(AnExhibitInACase, IsToldOnceWhatIsWrongWithIt) {
  const auto unknown = with_case("in = \"longcase\"").diagnostics;
  ASSERT_THAT(unknown, SizeIs(1));
  EXPECT_EQ(unknown[0].code, "unknown-case");
  EXPECT_EQ(unknown[0].hint, "did you mean \"long-case\"?");

  const auto beside = with_case("in = \"long-case\"\nposition = [0.2, 0.6]").diagnostics;
  ASSERT_THAT(beside, SizeIs(1));
  EXPECT_EQ(beside[0].code, "exhibit-beside-case");
  EXPECT_EQ(beside[0].line, 4U);
  EXPECT_THAT(beside[0].hint, HasSubstr("up to 1 m to the right or left and 0.4 m to its front"));

  const auto elsewhere = with_case("in = \"long-case\"", "floor = \"upper\"\n").diagnostics;
  ASSERT_THAT(elsewhere, SizeIs(1));
  EXPECT_EQ(elsewhere[0].code, "unknown-floor") << "of the case, and nothing of what is in it";
}

TEST(AnExhibitInACase, IsOnTheFloorOfItsCase) {
  const auto same = with_case("in = \"long-case\"\nfloor = \"ground\"");
  EXPECT_THAT(same.diagnostics, IsEmpty()) << "the first floor, by its name and by saying none";
}

TEST(ASize, IsOneNumberOrTwo) {
  const auto size_of = [](const std::string& written) {
    return with_case("position = [4, 2]\nfacing = 90\nsize = " + written);
  };

  EXPECT_EQ(disc_of(size_of("1.5")).size.value.across, 1.5);
  EXPECT_EQ(disc_of(size_of("1.5")).size.value.deep, 1.5);
  EXPECT_EQ(disc_of(size_of("[2, 0.5]")).size.value.across, 2);
  EXPECT_EQ(disc_of(size_of("0")).size.value.deep, 0);
  for (const char* wrong : {"\"big\"", "[1, 2, 3]", "-1", "[1, 600]"})
    EXPECT_THAT(size_of(wrong).diagnostics, SizeIs(1)) << wrong;
}

}  // namespace
}  // namespace docent::config::museum_cases_test
