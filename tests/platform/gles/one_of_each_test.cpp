#include "platform/gles/one_of_each.h"

#include <gtest/gtest.h>

#include <set>

#include "platform/gles/holdings_parts.h"
#include "platform/headless/headless_display.h"

namespace docent::gles::one_of_each_test {
namespace {

/// Needs a context for the holdings.
class OneOfEachThing : public testing::Test {
 protected:
  std::unique_ptr<headless::HeadlessDisplay> display_ = headless::open_headless({64, 64}).value();
  OneOfEach each_ = one_of_each();
};

TEST_F(OneOfEachThing, HoldsWhatItsListNames) {
  const Holdings::Parts& held = each_.holdings.parts();

  for (const scene::Quad& quad : each_.list.quads)
    EXPECT_NE(each_.holdings.size_of(quad.texture), Holdings::Size{});
  EXPECT_NE(held.building(each_.list.floor), nullptr);
  EXPECT_NE(held.objects.shape_of(each_.list.objects.at(0).object, false), nullptr);
  ASSERT_EQ(held.body.figure.size(), 1U);
  for (const scene::BodyLevels::Run& level : held.body.figure[0]) EXPECT_EQ(level.size, 3U);
}

TEST_F(OneOfEachThing, HasEverySurfaceAndAPictureThatHangsBesideOneThatStands) {
  const Building* building = each_.holdings.parts().building(0);
  ASSERT_NE(building, nullptr);

  std::set<Surface> surfaces;
  std::set<bool> pictures_hang;
  for (const SceneryPart& part : building->scenery.parts) {
    surfaces.insert(part.surface);
    if (part.surface == Surface::Picture)
      pictures_hang.insert(building->hangs.at(static_cast<std::size_t>(part.exhibit)));
  }

  EXPECT_EQ(surfaces.size(), static_cast<std::size_t>(Surface::Count));
  EXPECT_EQ(pictures_hang.size(), 2U);
}

TEST_F(OneOfEachThing, ShowsALeafAWayAMarkAnAvatarAndWallsThatSink) {
  EXPECT_FALSE(each_.list.leaves.empty());
  EXPECT_FALSE(each_.list.ribbons.empty());
  EXPECT_FALSE(each_.list.markers.empty());
  EXPECT_FALSE(each_.list.avatars.empty());
  EXPECT_TRUE(each_.list.walls.any);
}

}  // namespace
}  // namespace docent::gles::one_of_each_test
