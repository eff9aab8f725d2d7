#include <gtest/gtest.h>

#include <array>
#include <string>
#include <tuple>

#include "platform/pango/text_setter.h"
#include "runtime/interface/layout.h"
#include "tests/support/sample_museum.h"
#include "tests/support/sanitized.h"
#include "tests/support/shipped_languages.h"

namespace docent::pango::titles_test {
namespace {

using interface::Screen;

constexpr std::array glasses{std::tuple{1024U, 768U, 24.0F},  std::tuple{768U, 1024U, 24.0F},
                             std::tuple{1280U, 720U, 24.0F},  std::tuple{1920U, 1080U, 24.0F},
                             std::tuple{1080U, 1920U, 24.0F}, std::tuple{1920U, 1080U, 32.0F},
                             std::tuple{1080U, 1920U, 43.0F}};

/// With a long name in every language, in their own letters.
Museum named_in_all_languages() {
  Museum museum = test::in_all_shipped_languages(test::sample_museum_without_walls());
  museum.exhibits[2].title = {{"en", "Bronze tripod of the Shang dynasty"},
                              {"zh", "商代饕餮纹三足青铜鼎"},
                              {"ar", "المرجل البرونزي ثلاثي القوائم"},
                              {"ja", "殷王朝の三本足の青銅の鼎"},
                              {"ko", "상나라의 세 발 달린 청동 솥"},
                              {"he", "קדרת הברונזה בעלת שלוש הרגליים"},
                              {"hi", "शांग राजवंश का तीन पैरों वाला काँस्य पात्र"},
                              {"th", "หม้อสามขาสำริดแห่งราชวงศ์ซาง"},
                              {"de", "Dreibeiniger Bronzekessel der Shang-Dynastie"},
                              {"fr", "Chaudron tripode en bronze de la dynastie Shang"},
                              {"es", "Caldero trípode de bronce de la dinastía Shang"},
                              {"ru", "Бронзовый треножник династии Шан"}};
  return museum;
}

TEST(Titles, AreSeenWholeBeforeAnythingScrollsOnAnyGlassInAnyLanguage) {
  NEEDS_SPEED();
  const Museum museum = named_in_all_languages();
  const auto set_text = make_text_setter();
  ASSERT_TRUE(set_text.has_value());
  interface::ShownWay way;
  way.directions.parts.emplace_back();
  std::size_t seen = 0;
  for (const auto& [width, height, inches] : glasses) {
    interface::PieceCache cache({*set_text, {}}, 1, 1 << 24);
    for (const float scale : {1.0F, 1.5F, 2.0F})
      for (std::uint32_t language = 0; language < museum.languages.size(); ++language)
        for (const Screen screen : {Screen::Walking, Screen::Arrived}) {
          interface::ViewRequest request;
          request.shape = {.width = width, .height = height, .diagonal_inches = inches};
          request.shape.text_scale = scale;
          request.state.screen = screen;
          request.state.arrived = screen == Screen::Arrived;
          request.state.exhibit = 2;
          request.state.language = language;
          request.route_summary =
              interface::RouteSummary{path::RouteStatus::Ok, 42.4, 55, std::nullopt};
          const auto view = interface::make_view(museum, request, cache, {}, &way);
          const std::string& title = museum.exhibits[2].title.at(museum.languages[language].tag);
          for (const interface::Element& element : view->elements) {
            if (element.words < 0 ||
                view->words[static_cast<std::size_t>(element.words)].text != title)
              continue;
            ++seen;
            const scene::Rect& rect = element.quad.rect;
            const scene::Rect& area = view->scroll.rect;
            const float bottom = element.scrolls ? area.y + area.height : 1;
            EXPECT_LE(rect.y + rect.height, bottom + 1e-4F)
                << "on " << width << " x " << height << ", " << inches << " inches, letters "
                << scale << ", screen " << static_cast<int>(screen) << ", "
                << museum.languages[language].tag;
          }
        }
  }
  EXPECT_GT(seen, 400U);
}

}  // namespace
}  // namespace docent::pango::titles_test
