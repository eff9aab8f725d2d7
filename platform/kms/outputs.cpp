#include "platform/kms/outputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

namespace docent::kms {
namespace {

std::uint64_t area(PixelSize size) noexcept {
  return std::uint64_t{size.width} * size.height;
}

std::uint64_t apart(std::uint32_t a, std::uint32_t b) noexcept {
  return a > b ? a - b : b - a;
}

/// The size that a screen likes best.
PixelSize own_size(std::span<const Mode> modes) noexcept {
  const auto preferred = std::ranges::find_if(modes, &Mode::is_preferred);
  if (preferred != modes.end()) return preferred->size;
  return std::ranges::max_element(modes, {}, [](const Mode& m) { return area(m.size); })->size;
}

/// A CRTC and a plane for each connector of a list.
struct Feeds {
  const CardState& card;
  std::vector<std::pair<std::size_t, std::size_t>> taken{};  ///< CRTC and plane, by connector.

  bool is_free(std::size_t crtc, std::size_t plane) const {
    return std::ranges::none_of(
        taken, [&](const auto& feed) { return feed.first == crtc || feed.second == plane; });
  }

  /// Tries every CRTC and plane for the connectors from taken.size() on; a card has a handful.
  bool find(std::span<const std::size_t> connectors) {
    if (taken.size() == connectors.size()) return true;
    const std::uint32_t reach = card.connectors[connectors[taken.size()]].crtcs;
    for (std::size_t crtc = 0; crtc < card.crtcs.size() && crtc < 32; ++crtc) {
      const std::uint32_t bit = 1U << crtc;
      if ((reach & bit) == 0) continue;
      for (std::size_t plane = 0; plane < card.planes.size(); ++plane) {
        if ((card.planes[plane].crtcs & bit) == 0 || !is_free(crtc, plane)) continue;
        taken.emplace_back(crtc, plane);
        if (find(connectors)) return true;
        taken.pop_back();
      }
    }
    return false;
  }
};

bool may_be_driven(const Connector& connector, const WantedOutput& wanted) {
  return wanted.mirror || wanted.connector.empty() || connector.name == wanted.connector;
}

bool is_wanted(const Connector& connector, const WantedOutput& wanted) {
  return connector.is_connected && !connector.modes.empty() && may_be_driven(connector, wanted);
}

/// The connectors to drive, the one that decides the picture's size first, as many as the card can
/// feed at the same time.
std::vector<std::size_t> driven_connectors(const CardState& card, const WantedOutput& wanted) {
  std::vector<std::size_t> there, driven;
  for (std::size_t i = 0; i < card.connectors.size(); ++i)
    if (is_wanted(card.connectors[i], wanted)) there.push_back(i);
  std::ranges::stable_partition(
      there, [&](std::size_t i) { return card.connectors[i].name == wanted.connector; });
  for (const std::size_t i : there) {
    driven.push_back(i);
    if (!Feeds{card}.find(driven)) driven.pop_back();
    if (!wanted.mirror && driven.size() == 1) break;
  }
  return driven;
}

/// The connectors in these modes, with a picture of this size.
OutputPlan planned(const CardState& card, std::span<const std::size_t> connectors,
                   std::span<const std::size_t> modes, PixelSize picture) {
  Feeds feeds{card};
  feeds.find(connectors);
  OutputPlan plan{.picture = picture, .routes = {}};
  for (std::size_t i = 0; i < connectors.size(); ++i)
    plan.routes.push_back(
        {.connector = connectors[i],
         .mode = modes[i],
         .crtc = feeds.taken[i].first,
         .plane = feeds.taken[i].second,
         .place = letterbox(picture, card.connectors[connectors[i]].modes[modes[i]].size)});
  return plan;
}

bool has_size(const Connector& connector, PixelSize size) {
  return std::ranges::find(connector.modes, size, &Mode::size) != connector.modes.end();
}

/// A size in which all of them have a mode: the largest that has no more pixels than `wanted`, else
/// the smallest. Screens take more than they can show, which would be drawn for nothing.
std::optional<PixelSize> common_size(const CardState& card, std::span<const std::size_t> connectors,
                                     PixelSize wanted) {
  std::optional<PixelSize> best;
  const auto is_better = [&](PixelSize size) {
    if (!best) return true;
    const bool fits = area(size) <= area(wanted), best_fits = area(*best) <= area(wanted);
    if (fits != best_fits) return fits;
    return fits ? area(size) > area(*best) : area(size) < area(*best);
  };
  for (const Mode& mode : card.connectors[connectors[0]].modes)
    if (is_better(mode.size) && std::ranges::all_of(connectors, [&](std::size_t i) {
          return has_size(card.connectors[i], mode.size);
        }))
      best = mode.size;
  return best;
}

/// Each connector's best mode of one size, or else its own best.
std::vector<std::size_t> modes_of_size(const CardState& card,
                                       std::span<const std::size_t> connectors, PixelSize size,
                                       std::uint32_t refresh_hz) {
  std::vector<std::size_t> modes;
  for (const std::size_t i : connectors) {
    const Connector& connector = card.connectors[i];
    modes.push_back(
        best_mode(connector.modes, has_size(connector, size) ? size : PixelSize{}, refresh_hz));
  }
  return modes;
}

}  // namespace

std::size_t best_mode(std::span<const Mode> modes, PixelSize size,
                      std::uint32_t refresh_hz) noexcept {
  const PixelSize wanted = size == PixelSize{} ? own_size(modes) : size;
  const auto strangeness = [&](const Mode& mode) {
    const std::uint64_t off =
        apart(mode.size.width, wanted.width) + apart(mode.size.height, wanted.height);
    const double refresh_off =
        refresh_hz == 0 ? 0 : std::abs(mode.refresh_mhz / 1000.0 - refresh_hz);
    // 59.94 is 60 to whoever asks for 60, should there be no better one.
    return std::tuple(off, refresh_off, mode.is_interlaced, !mode.is_preferred,
                      -static_cast<double>(mode.refresh_mhz));
  };
  return static_cast<std::size_t>(std::ranges::min_element(modes, {}, strangeness) - modes.begin());
}

std::vector<OutputPlan> output_plans(const CardState& card, const WantedOutput& wanted) {
  const std::vector<std::size_t> connectors = driven_connectors(card, wanted);
  if (connectors.empty()) return {};
  const std::vector<Mode>& modes = card.connectors[connectors[0]].modes;
  const PixelSize picture = modes[best_mode(modes, wanted.size, wanted.refresh_hz)].size;
  const auto in_size = [&](PixelSize size, std::size_t how_many) {
    const auto some = std::span(connectors).first(how_many);
    return planned(card, some, modes_of_size(card, some, size, wanted.refresh_hz), size);
  };
  std::vector<OutputPlan> plans{in_size(picture, connectors.size())};
  if (connectors.size() == 1) return plans;
  if (const auto common = common_size(card, connectors, picture); common && *common != picture)
    plans.push_back(in_size(*common, connectors.size()));
  plans.push_back(in_size(picture, 1));
  return plans;
}

std::string why_none(const CardState& card, const WantedOutput& wanted) {
  for (const Connector& connector : card.connectors)
    if (connector.is_connected && connector.modes.empty() && may_be_driven(connector, wanted))
      return fmt::format(
          "the screen at {} offers no mode that this graphics card has; the guide appears as soon "
          "as another one is connected",
          connector.name);
  if (wanted.connector.empty() || wanted.mirror)
    return "no screen is connected; the guide appears as soon as one is";
  return fmt::format("no screen is connected to {}; the guide appears as soon as one is",
                     wanted.connector);
}

PixelRect letterbox(PixelSize picture, PixelSize screen) noexcept {
  if (picture == screen || area(picture) == 0) return {0, 0, screen.width, screen.height};
  PixelRect place{.width = screen.width, .height = screen.height};
  const std::uint64_t wide = std::uint64_t{picture.width} * screen.height;
  const std::uint64_t high = std::uint64_t{picture.height} * screen.width;
  if (wide > high)
    place.height = static_cast<std::uint32_t>(high / picture.width);
  else
    place.width = static_cast<std::uint32_t>(wide / picture.height);
  place.x = (screen.width - place.width) / 2;
  place.y = (screen.height - place.height) / 2;
  return place;
}

std::optional<double> diagonal_inches(std::uint32_t width_mm, std::uint32_t height_mm,
                                      PixelSize mode) noexcept {
  // Proportions where the size should be: what televisions and adapters write (E-EDID 1.4, 3.6.2).
  constexpr std::array<std::pair<std::uint32_t, std::uint32_t>, 8> proportions{
      {{16, 9}, {16, 10}, {160, 90}, {160, 100}, {1600, 900}, {1600, 1000}, {40, 30}, {400, 300}}};
  constexpr double smallest = 5, largest = 120, least_likely = 0.75, mm_per_inch = 25.4;
  if (width_mm == 0 || height_mm == 0 || area(mode) == 0) return std::nullopt;
  if (std::ranges::find(proportions, std::pair(width_mm, height_mm)) != proportions.end())
    return std::nullopt;
  const double stretch =
      (static_cast<double>(width_mm) / height_mm) / (static_cast<double>(mode.width) / mode.height);
  if (stretch < least_likely || stretch > 1 / least_likely) return std::nullopt;
  const double inches = std::hypot(width_mm, height_mm) / mm_per_inch;
  if (inches < smallest || inches > largest) return std::nullopt;
  return inches;
}

}  // namespace docent::kms
