#include "runtime/interface/pictures.h"

#include <gmock/gmock.h>

#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

#include "runtime/interface/layout.h"
#include "tests/runtime/interface/boxes.h"
#include "tests/support/sample_museum.h"

namespace docent::interface::pictures_test {
namespace {

using testing::Contains;
using testing::Not;

/// The images of which there is anything on the glass.
std::set<std::uint32_t> seen(const Museum& museum, const ViewRequest& request) {
  std::set<std::uint32_t> decoded;
  const auto note = [&](std::uint32_t image, std::uint32_t width, std::uint32_t height) {
    decoded.insert(image);
    return Pixels{width, height, std::vector<std::byte>(std::size_t{4} * width * height)};
  };
  PieceCache cache({test::boxes, note}, 1, 1 << 20);
  make_view(museum, request, cache);
  return decoded;
}

TEST(AnExhibitWithoutAnyPicture, LeavesNoBlankOneOnTheWayNorOnArrival) {
  Museum museum = test::sample_museum_without_walls();
  const std::uint32_t image = museum.exhibits[0].image;
  const auto take = [&](bool is_given) {
    museum.images[image].name = is_given ? "images/jar.svg" : "";
  };
  for (const Screen screen : {Screen::Walking, Screen::Arrived})
    for (const bool is_upright : {false, true})
      for (const bool is_shared : {false, true}) {
        ViewRequest request;
        request.shape.width = is_upright ? 1080 : 1920;
        request.shape.height = is_upright ? 1920 : 1080;
        request.state.screen = screen;
        request.state.arrived = screen == Screen::Arrived;
        request.state.exhibit = 0;
        request.route_summary = RouteSummary{path::RouteStatus::Ok, 25, 20};
        if (is_shared) {
          request.state.glass = Glass::Busy;
          request.state.seats = 2;
          request.state.seat = 1;
          request.state.look = 1;
          request.shape.diagonal_inches = 55;
        }
        take(true);
        EXPECT_THAT(seen(museum, request), Contains(image)) << is_upright << is_shared;
        take(false);
        EXPECT_THAT(seen(museum, request), Not(Contains(image))) << is_upright << is_shared;
      }
}

}  // namespace
}  // namespace docent::interface::pictures_test
