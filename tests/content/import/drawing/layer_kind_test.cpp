#include "content/import/drawing/layer_kind.h"

#include <gtest/gtest.h>

namespace docent::test::layer_kind_test {
namespace {

using import::kind_of_layer;
using import::LayerKind;

TEST(LayerKind, KnowsWallsInSeveralLanguages) {
  for (const char* name : {"A-WALL", "xref-House$0$A-WALL", "Wände tragend", "WAND_INNEN", "Murs",
                           "muri_esterni", "A—墙体", "СТЕНЫ", "Стены", "gips"})
    EXPECT_EQ(kind_of_layer(name), LayerKind::Wall) << name;
}

TEST(LayerKind, KnowsWhatDrawsNoRoom) {
  for (const char* name :
       {"A-DIMS-1", "Furniture", "S-STEM-WALL", "AXIS", "txt", "hatch", "Meubles"})
    EXPECT_EQ(kind_of_layer(name), LayerKind::Other) << name;
  EXPECT_EQ(kind_of_layer("0"), LayerKind::Unknown);
}

TEST(LayerKind, KnowsDoorsAndWindows) {
  EXPECT_EQ(kind_of_layer("doors"), LayerKind::Door);
  EXPECT_EQ(kind_of_layer("Tueren"), LayerKind::Door);
  EXPECT_EQ(kind_of_layer("A-GLAZ"), LayerKind::Window);
  EXPECT_EQ(kind_of_layer("A—门窗"), LayerKind::Window);
}

TEST(LayerKind, IsWhatStaffSay) {
  const std::map<std::string, std::string> said{{"wall", "Plan-*,L7"}, {"door", "L9"}};

  EXPECT_EQ(kind_of_layer("plan-north", said), LayerKind::Wall);
  EXPECT_EQ(kind_of_layer("L9", said), LayerKind::Door);
  EXPECT_EQ(kind_of_layer("A-WALL", said), LayerKind::Other);
}

}  // namespace
}  // namespace docent::test::layer_kind_test
