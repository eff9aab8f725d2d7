#include "content/draw/plan/plan_style.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "content/draw/svg.h"

namespace docent::draw {

std::string region_colour(std::size_t tint) {
  constexpr std::array<std::pair<std::string_view, double>, region_tints> tints = {
      {{ink::teal, 0.16},
       {ink::ochre, 0.22},
       {ink::stone, 0.36},
       {ink::vermilion, 0.13},
       {ink::oak, 0.30},
       {ink::teal, 0.28},
       {ink::ochre, 0.11},
       {ink::vermilion, 0.21}}};
  const auto [colour, part] = tints[tint % region_tints];
  return mixed(ink::floor, colour, part);
}

std::string door_stroke(const Door& door) {
  return fmt::format(R"(stroke="{}" stroke-width="3"{})", ink::oak,
                     door.closed ? "" : R"( stroke-dasharray="2 6")");
}

std::string wall_site_stroke(std::size_t wall) {
  return fmt::format(R"(stroke="{}" stroke-width="2.4" stroke-linecap="butt")",
                     wall % 2 == 0 ? ink::cut_face : ink::oak);
}

std::string axis_stroke(double wide) {
  return fmt::format(R"(stroke="{}" stroke-width="{:.2f}")",
                     mixed(ink::ochre, ink::teal, std::min(1.0, 1.6 * wide)),
                     std::lerp(1.6, 7.0, wide));
}

std::string way_stroke(const RouteKindInfo& kind, double width) {
  const LinePattern& pattern = kind.pattern;
  const std::string dashes =
      pattern.is_solid() ? std::string()
                         : fmt::format(R"( stroke-dasharray="{:.1f} {:.1f}")",
                                       pattern.drawn_piece * width, pattern.drawn_gap * width);
  return fmt::format(R"(fill="none" stroke="#{:06X}" stroke-width="{:.2f}" )"
                     R"(stroke-linejoin="round" stroke-linecap="round"{})",
                     kind.colour, width, dashes);
}

std::string level_style(std::size_t levels) {
  constexpr double darkest = 0.28;  // Where all levels lie one upon another.
  const double each = 1 - std::pow(1 - darkest, 1.0 / static_cast<double>(std::max(levels, 1UL)));
  return fmt::format(R"(fill="{0}" fill-opacity="{1:.4f}" fill-rule="evenodd" stroke="{0}" )"
                     R"(stroke-opacity="0.5" stroke-width="0.9")",
                     ink::teal, each);
}

}  // namespace docent::draw
