#include "runtime/kiosk/visit_counter.h"

#include <algorithm>
#include <string>
#include <utility>

#include "runtime/model/route_kind.h"

namespace docent::kiosk {

VisitCounter::VisitCounter(const guide::Guide& guide)
    : exhibits_(guide.museum().exhibits.size()), touches_(guide.counters().touches) {
  for (const Exhibit& exhibit : guide.museum().exhibits)
    cells_.push_back({CountedCell::Kind::Exhibit, exhibit.id});
  for (const RouteKindInfo& kind : route_kinds)
    cells_.push_back({CountedCell::Kind::Route, std::string(kind.name)});
  for (const Language& language : guide.museum().languages)
    cells_.push_back({CountedCell::Kind::Language, language.tag});
  tally_.visits.resize(cells_.size());
  // Part 0 of a shared glass is the model, which nobody sits at.
  visits_.resize(guide.seats() > 1 ? guide.seats() + 1 : 1);
  for (UnderWay& visit : visits_) visit.does.resize(cells_.size());
}

void VisitCounter::follow(const guide::Guide& guide) noexcept {
  tally_.touches += guide.counters().touches - std::exchange(touches_, guide.counters().touches);
  for (std::size_t part = visits_.size() > 1 ? 1 : 0; part < visits_.size(); ++part)
    follow(guide.state(part), visits_[part]);
}

void VisitCounter::follow(const interface::InterfaceState& state, UnderWay& visit) noexcept {
  if (state.screen == interface::Screen::Welcome) return end(visit);
  visit.is_there = true;
  visit.language = state.language;
  if (!state.exhibit || state.arrived || *state.exhibit >= exhibits_) return;
  visit.does[*state.exhibit] = 1;
  visit.does[exhibits_ + static_cast<std::size_t>(state.kind)] = 1;
}

void VisitCounter::end(UnderWay& visit) noexcept {
  if (!std::exchange(visit.is_there, false)) return;
  const std::size_t language = exhibits_ + route_kinds.size() + visit.language;
  if (language < visit.does.size()) visit.does[language] = 1;
  for (std::size_t cell = 0; cell < visit.does.size(); ++cell)
    tally_.visits[cell] += std::exchange(visit.does[cell], std::uint8_t{0});
}

DailyCounts counts_of(const VisitTally& tally, const std::vector<CountedCell>& cells) {
  DailyCounts counts{.day = {}, .touches = tally.touches, .visits = {}};
  for (std::size_t i = 0; i < std::min(cells.size(), tally.visits.size()); ++i)
    if (tally.visits[i] > 0) counts.visits[cells[i]] += tally.visits[i];
  return counts;
}

}  // namespace docent::kiosk
