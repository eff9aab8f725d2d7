#include "content/compile/compile_floor.h"

#include <fmt/core.h>

#include "content/content_error.h"
#include "content/floor/medial_axis.h"
#include "content/floor/mend.h"
#include "content/floor/sight.h"
#include "content/floor/voronoi.h"
#include "content/parallel.h"
#include "runtime/path/shortest/make_hub_labels.h"
#include "runtime/path/shortest/make_tangent_graph.h"

namespace docent::compile {

namespace {

void report_left_out(const import::ImportedPlan& plan, Report& report) {
  for (const import::LeftOut& left_out : plan.left_out) {
    Diagnostic diagnostic;
    diagnostic.file = plan.files[left_out.place.file];
    diagnostic.line = left_out.place.line;
    diagnostic.column = left_out.place.column;
    diagnostic.severity = Severity::Warning;
    diagnostic.code = "left-out";
    diagnostic.message = fmt::format("a {} is no area and was left out", left_out.what);
    report.add(std::move(diagnostic));
  }
}

/// Reports the mendings even of a plan that is refused: they say what was left out of it, and why.
FloorPlan mend(const import::ImportedPlan& drawn, Report& report) {
  std::vector<Diagnostic> mendings;
  try {
    FloorPlan plan = floor::mend(drawn, mendings);
    report.add(mendings);
    return plan;
  } catch (const content::ContentError&) {
    report.add(mendings);
    throw;
  }
}

/// On floors of fewer walls a search takes a fraction of a millisecond.
constexpr std::size_t worth_telling = 2000;

/// Says which radii have no labels, and what that costs.
void report_searched(const Floor& floor, const std::string& file, Report& report) {
  if (floor.plan.vertex.size() < worth_telling) return;
  for (std::size_t i = 0; i < floor.tangent_graphs.size(); ++i) {
    const TangentGraph& graph = floor.tangent_graphs[i];
    if (graph.arc.empty() || floor.hub_labels[i].has_labels()) continue;
    Diagnostic diagnostic;
    diagnostic.file = file;
    diagnostic.severity = Severity::Warning;
    diagnostic.code = "ways-searched";
    diagnostic.message = fmt::format(
        "the shortest ways of radius {:g} m are too many to prepare: {} corners see each other "
        "along {} "
        "lines; each way is searched when it is asked for, which takes milliseconds and not "
        "microseconds",
        graph.radius, graph.arc.size(), graph.tangent.size() / 2);
    diagnostic.hint = "nothing need be done; a floor in several parts is quicker";
    report.add(std::move(diagnostic));
  }
}

}  // namespace

void plan_floor_stages(Progress& progress) {
  progress.plan("plan", 1);
  progress.plan("voronoi", 6);
  progress.plan("paths", 3);
}

CompiledFloor compile_floor(const std::string& name, std::span<const std::string> files,
                            import::Coordinates coordinates, std::span<const double> radii,
                            Report& report, Progress& progress, unsigned jobs) {
  CompiledFloor compiled;
  Floor& floor = compiled.floor;
  {
    const auto stage = progress.start("plan");
    compiled.drawn = import::read_floor_plan(files, coordinates);
    report_left_out(compiled.drawn, report);
    floor.plan = mend(compiled.drawn, report);
    floor.plan.name = name;
  }
  {
    const auto stage = progress.start("voronoi");
    floor.diagram = floor::voronoi_diagram(floor.plan);
    floor.roadmap = floor::medial_axis(floor.plan, floor.diagram);
  }
  const auto stage = progress.start("paths");
  floor.sight = floor::make_sight_map(floor.plan);
  floor.tangent_graphs.resize(radii.size());
  floor.hub_labels.resize(radii.size());
  content::for_each_index(radii.size(), jobs, [&](std::size_t i) {
    floor.tangent_graphs[i] = path::make_tangent_graph(floor.plan, floor.sight, radii[i]);
    floor.hub_labels[i] = path::make_hub_labels(floor.plan, floor.tangent_graphs[i]);
  });
  report_searched(floor, files.front(), report);
  return compiled;
}

}  // namespace docent::compile
