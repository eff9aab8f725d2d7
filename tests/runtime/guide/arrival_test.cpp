#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "platform/sqlite/content_reader.h"
#include "runtime/guide/stage.h"
#include "runtime/guide/step_aside.h"
#include "runtime/guide/turn_table.h"
#include "runtime/interface/layout.h"
#include "runtime/scene/clear_of_boards.h"
#include "tests/support/sample_database.h"
#include "tests/support/sanitized.h"
#include "tests/support/shipped_languages.h"

namespace docent::guide::arrival_test {
namespace {

constexpr std::array glasses{std::tuple{1024U, 768U, 24.0F},  std::tuple{768U, 1024U, 24.0F},
                             std::tuple{1280U, 720U, 24.0F},  std::tuple{1920U, 1080U, 24.0F},
                             std::tuple{1920U, 1080U, 43.0F}, std::tuple{1080U, 1920U, 24.0F},
                             std::tuple{1080U, 1920U, 43.0F}, std::tuple{3840U, 2160U, 65.0F},
                             std::tuple{2160U, 3840U, 55.0F}};

/// Letters of six tenths of their size, in lines.
interface::TextBitmap in_lines(const interface::TextStyle& style, std::string_view text,
                               std::uint32_t width) {
  const auto letters = std::ranges::count_if(
      text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; });
  const float whole = std::max(1.0F, static_cast<float>(letters) * style.size * 0.6F);
  const float room = width == 0 ? whole : static_cast<float>(width);
  interface::TextBitmap bitmap;
  bitmap.lines = static_cast<std::uint32_t>(std::ceil(whole / room));
  bitmap.width = static_cast<std::uint32_t>(std::min(whole, room));
  bitmap.height = bitmap.lines * static_cast<std::uint32_t>(style.size * style.line_height);
  bitmap.coverage.resize(std::size_t{bitmap.width} * bitmap.height, 255);
  return bitmap;
}

bool meet(const scene::Rect& a, const scene::Rect& b) {
  return std::max(a.x, b.x) < std::min(a.x + a.width, b.x + b.width) &&
         std::max(a.y, b.y) < std::min(a.y + a.height, b.y + b.height);
}

/// What is drawn of an exhibit.
scene::Thing thing_of(const ExhibitShape& shape) {
  const Vec3 a = to_world(shape.low, shape.middle.y), b = to_world(shape.high, shape.middle.y);
  const Vec3 up{0, shape.half_height, 0};
  return {glm::min(a, b) - up, glm::max(a, b) + up};
}

/// A guide who stands aside.
scene::Thing body_at(Vec2 place, double height) {
  const Vec3 feet = to_world(place, height);
  return {feet - Vec3{0.25F, 0, 0.25F}, feet + Vec3{0.25F, 1.75F, 0.25F}};
}

TEST(Arrival, HasTheExhibitUnderNoBoardOnAnyGlassInAnyLanguage) {
  NEEDS_SPEED();
  const Museum museum =
      test::in_all_shipped_languages(sqlite::load_museum(test::sample_database()).value());
  const std::vector<ExhibitShape> shapes = exhibit_shapes(museum);
  interface::ShownWay way;
  way.directions.parts.emplace_back();
  std::size_t boards = 0;
  for (const auto& [width, height, inches] : glasses)
    for (const float scale : {1.0F, 2.0F})
      for (std::uint32_t language = 0; language < museum.languages.size(); ++language) {
        interface::PieceCache cache({in_lines, {}}, 1, 1 << 20);
        for (std::uint32_t i = 0; i < museum.exhibits.size(); ++i) {
          interface::ViewRequest request;
          request.shape = {.width = width, .height = height, .diagonal_inches = inches};
          request.shape.text_scale = scale;
          request.state.screen = interface::Screen::Arrived;
          request.state.arrived = true;
          request.state.exhibit = i;
          request.state.language = language;
          way.floor = museum.exhibits[i].floor;
          const auto view = interface::make_view(museum, request, cache, {}, &way);
          const float aspect = interface::aspect_ratio(request.shape);
          Avatar leader;
          leader.floor = leader.shown_floor = way.floor;
          leader.body = museum.exhibits[i].viewing_point;
          leader.height = museum.floors[way.floor].plan.height;
          Stage stage(museum, shapes, true);

          stage.enter(request.state, {view->free, view->boards}, aspect, leader);

          boards += view->boards.size();
          std::vector things{thing_of(shapes[i])};
          if (museum.exhibits[i].object < 0) {
            const auto goal = interface::goal_of(museum, request.state);
            things.push_back(body_at(about_aside(*goal, leader.body.position), leader.height));
          }
          for (const scene::Thing& thing : things) {
            const scene::Rect seen = scene::seen_box(scene::view_of(stage.rig(), aspect), thing);
            const std::string where =
                fmt::format("{} on {} x {}, {} inches, letters {}, {}", museum.exhibits[i].id,
                            width, height, inches, scale, museum.languages[language].tag);
            for (const scene::Rect& board : view->boards) EXPECT_FALSE(meet(seen, board)) << where;
            EXPECT_GE(seen.x, view->free.x) << where;
            EXPECT_GE(seen.y, view->free.y) << where;
            EXPECT_LE(seen.x + seen.width, view->free.x + view->free.width) << where;
          }
        }
      }
  EXPECT_GT(boards, 1000U);
}

}  // namespace
}  // namespace docent::guide::arrival_test
