#include "content/import/drawing/label.h"

#include <gtest/gtest.h>

namespace docent::test::label_test {
namespace {

import::RoomLabel label_of(std::initializer_list<std::string> lines) {
  std::vector<import::DrawnText> texts;
  double y = 0;
  for (const std::string& line : lines) texts.push_back({line, {0, y -= 1}, 0.3, 0});
  return import::label_of(std::move(texts));
}

TEST(RoomLabel, JoinsNumberAndNameAndReadsTheArea) {
  const import::RoomLabel label = label_of({"A002", "Salle TD", "71,25 m²"});

  EXPECT_EQ(label.name, "A002 Salle TD");
  ASSERT_TRUE(label.area);
  EXPECT_DOUBLE_EQ(*label.area, 71.25);
}

TEST(RoomLabel, TakesHeightsAxesAndSizesOfDoorsForNoNames) {
  EXPECT_EQ(label_of({"+3.00", "2668", "A", "h=2.70", "5050 XO", "1200"}).name, "");
  EXPECT_EQ(label_of({"WC"}).name, "WC");
  EXPECT_EQ(label_of({"101"}).name, "101");
}

TEST(RoomLabel, PrefersTallLettersToNotes) {
  const import::RoomLabel label = import::label_of(
      {{"GARAGE", {0, 2}, 0.4, 0}, {"PROVIDE SELF CLOSING DOOR", {0, 1}, 0.15, 0}});

  EXPECT_EQ(label.name, "GARAGE");
}

TEST(RoomLabel, TellsCorridorsStairsAndToilets) {
  EXPECT_EQ(import::kind_of_room("015 Flur Keller West"), "corridor");
  EXPECT_EQ(import::kind_of_room("Buero"), "");
  EXPECT_EQ(import::connection_of_room("ESCALIER C"), "stairs");
  EXPECT_EQ(import::place_of_room("009 WC Damen"), "toilets");
}

}  // namespace
}  // namespace docent::test::label_test
