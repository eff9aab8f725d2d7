#include "content/import/drawing/unit.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <utility>

namespace docent::import {
namespace {

constexpr double narrowest_leaf = 0.55, widest_leaf = 1.35;  ///< Metres, of most doors.
constexpr double smallest_plan = 3, largest_plan = 2000;     ///< Metres across.
constexpr double largest_guess = 400;                        ///< Where no unit is stated.

struct Unit {
  std::string_view name, plural;
  double metres;
};
constexpr std::array units = {Unit{"mm", "millimetres", 0.001}, Unit{"cm", "centimetres", 0.01},
                              Unit{"m", "metres", 1.0}, Unit{"inch", "inches", 0.0254},
                              Unit{"foot", "feet", 0.3048}};

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

/// The middle four fifths of all ends, across; strays do not count.
double size_of(const Drawing& drawing) {
  std::vector<double> x, y;
  for (const DrawnSegment& segment : drawing.segments) {
    x.push_back(segment.a.x);
    y.push_back(segment.a.y);
  }
  if (x.empty()) return 0;
  const auto spread = [](std::vector<double>& values) {
    std::ranges::sort(values);
    return values[values.size() * 9 / 10] - values[values.size() / 10];
  };
  return std::max(spread(x), spread(y));
}

std::string in_words(double metres) {
  return metres < 0.1 ? fmt::format("{:.0f} mm", 1000 * metres) : fmt::format("{:.2f} m", metres);
}

/// How many of the leaves are doors in this unit.
std::size_t doors_in(const std::vector<double>& leaves, double metres) {
  return static_cast<std::size_t>(std::ranges::count_if(leaves, [&](double leaf) {
    return leaf * metres >= narrowest_leaf && leaf * metres <= widest_leaf;
  }));
}

/// The unit in which at least two leaves are doors, and twice as many as in any other, and in which
/// the plan is a building.
const Unit* likely_unit(const std::vector<double>& leaves, double size) {
  const Unit* best = nullptr;
  std::size_t most = 0, second = 0;
  for (const Unit& unit : units) {
    if (size * unit.metres < smallest_plan || size * unit.metres > largest_guess) continue;
    const std::size_t doors = doors_in(leaves, unit.metres);
    if (doors > most) {
      second = std::exchange(most, doors);
      best = &unit;
    } else {
      second = std::max(second, doors);
    }
  }
  return most >= 2 && most >= 2 * second ? best : nullptr;
}

/// The middle width of the leaves that are doors in this unit.
std::string doors_in_words(const std::vector<double>& leaves, double metres) {
  std::vector<double> doors;
  for (const double leaf : leaves)
    if (leaf * metres >= narrowest_leaf && leaf * metres <= widest_leaf) doors.push_back(leaf);
  return in_words(median(doors) * metres);
}

/// `M 1:50`, `Scale 1:100`: 50, 100.
std::optional<double> scale_said(std::string_view text) {
  for (std::size_t at = text.find("1:"); at != std::string_view::npos;
       at = text.find("1:", at + 2)) {
    if (at > 0 && std::isdigit(static_cast<unsigned char>(text[at - 1])) != 0) continue;
    std::string_view rest = text.substr(at + 2);
    while (rest.starts_with(' ')) rest.remove_prefix(1);
    double scale = 0;
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), scale);
    if (error == std::errc{} && scale >= 5 && scale <= 5000) return scale;
  }
  return std::nullopt;
}

/// A drawing at the size of its paper, in millimetres, of which a text says the scale and the doors
/// agree.
std::optional<double> scale_of_paper(const Drawing& drawing, const std::vector<double>& leaves,
                                     double size) {
  for (const DrawnText& text : drawing.texts)
    if (const auto scale = scale_said(text.text)) {
      const double metres = *scale / 1000;
      if (size * metres > smallest_plan && size * metres < largest_guess &&
          2 * doors_in(leaves, metres) > leaves.size())
        return scale;
    }
  return std::nullopt;
}

}  // namespace

std::optional<double> metres_of(std::string_view unit) {
  static constexpr std::array<std::pair<std::string_view, double>, 15> names = {
      {{"mm", 0.001},
       {"cm", 0.01},
       {"dm", 0.1},
       {"m", 1},
       {"km", 1000},
       {"in", 0.0254},
       {"inch", 0.0254},
       {"inches", 0.0254},
       {"ft", 0.3048},
       {"foot", 0.3048},
       {"feet", 0.3048},
       {"yard", 0.9144},
       {"millimetres", 0.001},
       {"centimetres", 0.01},
       {"metres", 1}}};
  for (const auto& [name, metres] : names)
    if (name == unit) return metres;
  double metres = 0;
  if (unit.starts_with("1:")) {  // Millimetres of paper.
    if (const auto scale = scale_said(unit)) return *scale / 1000;
    return std::nullopt;
  }
  const auto [end, error] = std::from_chars(unit.data(), unit.data() + unit.size(), metres);
  if (error != std::errc{} || end != unit.data() + unit.size()) return std::nullopt;
  if (!(metres > 1e-6) || metres > 1e6) return std::nullopt;
  return metres;
}

UnitFound find_unit(const Drawing& drawing, const std::vector<double>& leaves,
                    std::string_view by_staff) {
  if (!by_staff.empty()) {
    const auto metres = metres_of(by_staff);
    if (!metres)
      return {
          .said = "", .doubt = "", .refused = fmt::format("'{}' is no unit of length", by_staff)};
    return {*metres, fmt::format("by --unit: {}", by_staff), "", ""};
  }
  const double size = size_of(drawing);
  const double leaf = leaves.empty() ? 0 : median(leaves);
  const std::string seen =
      leaf > 0 ? fmt::format("{} door swings are {:.4g} units wide", leaves.size(), leaf)
               : fmt::format("the drawing is {:.4g} units across", size);
  if (drawing.metres_per_unit) {
    const double metres = *drawing.metres_per_unit;
    const bool doors_fit =
        leaf == 0 || (leaf * metres > 0.4 && leaf * metres < 2) || doors_in(leaves, metres) >= 2;
    const bool size_fits = size * metres > smallest_plan && size * metres < largest_plan;
    if (doors_fit && size_fits) return {metres, "stated: " + drawing.unit, "", ""};
    const std::string wrong =
        doors_fit
            ? fmt::format("the file says its unit is {}, but then the plan is {:.4g} m across",
                          drawing.unit, size * metres)
            : fmt::format("the file says its unit is {}, but then its doors are {} wide",
                          drawing.unit, in_words(leaf * metres));
    if (const auto scale = scale_of_paper(drawing, leaves, size))
      return {*scale / 1000, fmt::format("found: millimetres of paper at 1:{:g}", *scale),
              fmt::format("{}; read as drawn at 1:{:g}, as a text says, where they are {}", wrong,
                          *scale, doors_in_words(leaves, *scale / 1000)),
              ""};
    if (const Unit* likely = likely_unit(leaves, size))
      return {likely->metres,
              fmt::format("found: {}, by {} doors", likely->name, doors_in(leaves, likely->metres)),
              fmt::format("{}; read as {}, where they are {}", wrong, likely->plural,
                          doors_in_words(leaves, likely->metres)),
              ""};
    return {.said = "", .doubt = "", .refused = wrong};
  }
  if (const auto scale = scale_of_paper(drawing, leaves, size))
    return {
        *scale / 1000, fmt::format("found: millimetres of paper at 1:{:g}", *scale),
        fmt::format("the file states no unit; read as drawn at 1:{:g}, as a text says, where its "
                    "doors are {} wide",
                    *scale, doors_in_words(leaves, *scale / 1000)),
        ""};
  if (const Unit* likely = likely_unit(leaves, size))
    return {likely->metres,
            fmt::format("found: {}, by {} doors", likely->name, doors_in(leaves, likely->metres)),
            fmt::format("the file states no unit; read as {}, where its doors are {} wide",
                        likely->plural, doors_in_words(leaves, likely->metres)),
            ""};
  return {.said = "",
          .doubt = "",
          .refused = fmt::format("the file states no unit of length, and {}", seen)};
}

void scale(Drawing& drawing, double metres) {
  for (DrawnSegment& segment : drawing.segments) {
    segment.a *= metres;
    segment.b *= metres;
  }
  for (DrawnArc& arc : drawing.arcs) {
    arc.centre *= metres;
    arc.start *= metres;
    arc.end *= metres;
    arc.radius *= metres;
  }
  for (DrawnRing& ring : drawing.rings)
    for (Vec2& corner : ring.corners) corner *= metres;
  for (DrawnText& text : drawing.texts) {
    text.at *= metres;
    text.height *= metres;
  }
}

}  // namespace docent::import
