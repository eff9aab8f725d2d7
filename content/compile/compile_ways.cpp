#include "content/compile/compile_ways.h"

#include <algorithm>

#include "content/compile/compile_exhibits.h"

namespace docent::compile {

void compile_ways(const config::MuseumConfig& config, Museum& museum, Report& report) {
  for (const config::WaySection& section : config.ways) {
    const auto info = std::ranges::find(way_choices, section.kind.value, &WayChoiceInfo::name);
    if (info != way_choices.end())  // else it is reported already
      museum.ways.push_back({info->choice, plain_texts(section.title.value)});
  }
  const bool has_steps = !std::ranges::all_of(museum.connections, &Connection::step_free);
  if (museum.ways.empty() || !has_steps ||
      std::ranges::find(museum.ways, WayChoice::StepFree, &WayOffer::choice) != museum.ways.end())
    return;
  Diagnostic diagnostic = config::diagnostic_at(
      config, config.ways.front().place, "no-step-free-way",
      "the [[way]] sections offer no step-free way, and the building has stairs or escalators", {},
      "visitors on wheels cannot ask for lifts and ramps: add [[way]] with kind = \"step_free\"");
  diagnostic.severity = Severity::Warning;
  report.add(std::move(diagnostic));
}

}  // namespace docent::compile
