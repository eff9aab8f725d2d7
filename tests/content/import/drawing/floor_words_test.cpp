#include "content/import/drawing/floor_words.h"

#include <gtest/gtest.h>

namespace docent::test::floor_words_test {
namespace {

using import::floor_said;

TEST(FloorWords, KnowTheGroundAndTheBasementInManyLanguages) {
  for (const char* text : {"GROUND FLOOR PLAN", "Erdgeschoss", "EG", "rez-de-chaussée", "RDC",
                           "Planta baja", "Piano terra", "museum_ground", "Begane grond"})
    EXPECT_EQ(floor_said(text), 0) << text;
  for (const char* text : {"Basement", "UG", "Kellergeschoss", "Sous-sol", "подвал", "1. UG"})
    EXPECT_EQ(floor_said(text), -1) << text;
  EXPECT_EQ(floor_said("2. UG"), -2);
  EXPECT_EQ(floor_said("B2"), -2);
}

TEST(FloorWords, ReadNumbersAndOrdinals) {
  for (const char* text :
       {"FIRST FLOOR", "1. OG", "Level 1", "Niveau 1", "1er étage", "Planta primera", "piano primo",
        "1 этаж", "level_1", "1st floor", "westport-house-floor-1", "plan-L1"})
    EXPECT_EQ(floor_said(text), 1) << text;
  EXPECT_EQ(floor_said("Level -1"), -1);
  EXPECT_EQ(floor_said("OG 3"), 3);
  EXPECT_EQ(floor_said("第二层平面图 二层"), 2);
}

TEST(FloorWords, DoNotTakeOtherTextsForFloors) {
  for (const char* text : {"Office", "Room 101", "Scale 1:100", "Section A-A",
                           "Level -6.000 m above sea", "house", "cad", "20.5 m2"})
    EXPECT_EQ(floor_said(text), std::nullopt) << text;
}

}  // namespace
}  // namespace docent::test::floor_words_test
