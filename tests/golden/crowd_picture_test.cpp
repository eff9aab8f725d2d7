#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>

#include "platform/gles/renderer.h"
#include "platform/headless/headless_display.h"
#include "runtime/guide/turn_table.h"
#include "runtime/kiosk/exhibition.h"
#include "runtime/scene/camera.h"
#include "runtime/scene/look.h"
#include "tests/golden/pictures.h"
#include "tests/support/sample_database.h"
#include "tests/support/temporary_folder.h"

namespace docent::test::crowd_picture_test {
namespace {

/// A guide on its way: where it set out, where it leads, how far it has come.
struct PosedWalk {
  Placement start;
  std::string_view exhibit;
  RouteKind kind = RouteKind::Shortest;
  double metres = 0;
};

/// Where a guide with that look is after so many metres of its walk.
guide::Avatar walker(kiosk::Exhibition& exhibition, std::uint32_t look, const PosedWalk& errand) {
  const Museum& museum = exhibition.museum;
  const auto exhibit = std::ranges::find(museum.exhibits, errand.exhibit, &Exhibit::id);
  plan::WalkOrder order;
  order.id = look + 1;
  order.kind = errand.kind;
  order.goal = exhibit->viewing_point;
  order.start = errand.start;
  exhibition.planner->ask(order);
  exhibition.planner->wait();
  guide::Avatar avatar = guide::make_avatar(museum, 0, plan::make_standing(museum, errand.start));
  avatar.look = look;
  avatar.plan = exhibition.planner->take_plan();
  while (avatar.along < errand.metres && !guide::has_finished(avatar))
    guide::advance(museum, avatar, 1.0 / 60);
  return avatar;
}

/// Six guides with their trails, as in the paper's Figure 1.
TEST(SixGuides, LookAsTheyWereSeenAndApproved) {
  constexpr PixelSize size{1280, 720};
  auto display = headless::open_headless(size);
  ASSERT_TRUE(display.has_value()) << display.error().what;
  auto renderer = gles::make_renderer();
  ASSERT_TRUE(renderer.has_value()) << renderer.error().what;
  auto loaded = kiosk::load_exhibition(sample_database(), kiosk::Selection{}, {});
  ASSERT_TRUE(loaded.has_value()) << loaded.error().what;
  kiosk::Exhibition& exhibition = **loaded;
  const auto from = [](double x, double y, double degrees) {
    return Placement{{x, y}, glm::radians(degrees)};
  };
  const std::array errands{
      PosedWalk{from(19.3, 4.5, 90), "coin-hoard", RouteKind::Shortest, 5.5},
      PosedWalk{from(9.5, 15.2, 0), "tomb-guardian", RouteKind::Shortest, 4.6},
      PosedWalk{from(21.6, 25.5, 270), "boundary-stone", RouteKind::Shortest, 6.4},
      PosedWalk{from(31, 16.5, 180), "tripod-ding", RouteKind::Offset, 6.2},
      PosedWalk{from(24.2, 12.2, 130), "owl-vessel", RouteKind::Skeleton, 2.2},
      PosedWalk{from(15.4, 18.0, 270), "amphora", RouteKind::Shortest, 4.1},
  };

  scene::DrawList list;
  list.ribbons.reserve(errands.size());
  list.ribbon_point.reserve(4096);
  list.objects.reserve(exhibition.museum.exhibits.size());
  guide::draw_objects(exhibition.museum, 0, {}, {}, list);
  for (std::uint32_t look = 0; look < errands.size(); ++look) {
    const guide::Avatar avatar = walker(exhibition, look, errands[look]);
    guide::draw(exhibition.museum, avatar, list);
    guide::draw_trail(avatar, 0.3F, list);
  }
  scene::CameraRig rig;
  rig.target = to_world({20.2, 14.3});
  rig.yaw = glm::radians(98.0);
  rig.pitch = glm::radians(51.0);
  rig.distance = 28;
  list.camera = scene::view_of(rig, 16.0F / 9);
  list.focus = {20.2, 14.3};
  kiosk::upload(exhibition);
  renderer->draw(list, exhibition.holdings, (*display)->target());
  Pixels drawn;
  (*display)->read_back(drawn);

  const TemporaryFolder folder;
  ASSERT_TRUE(image::write_png(folder.path() / "company.png", drawn).has_value());
  expect_approved(folder.path() / "company.png", "company.png");
}

}  // namespace
}  // namespace docent::test::crowd_picture_test
