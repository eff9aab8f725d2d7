#include "content/compile/compile_floor.h"

#include <fmt/core.h>

#include "content/content_error.h"
#include "content/floor/footprint.h"
#include "content/floor/medial_axis.h"
#include "content/floor/mend.h"
#include "content/floor/open_doors.h"
#include "content/floor/sight.h"
#include "content/floor/voronoi.h"
#include "content/import/geojson/indoor_geojson.h"
#include "content/parallel.h"
#include "content/read_source.h"
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

/// The point is read as the standard has it; but whoever wrote a decimal comma meant another.
void report_doubtful_heights(const import::ImportedPlan& plan, Report& report) {
  for (const import::SourcePlace& place : plan.doubtful_heights)
    report.add(
        {.file = plan.files[place.file],
         .line = place.line,
         .column = place.column,
         .severity = Severity::Warning,
         .code = "doubtful-height",
         .message = "a point of 3 numbers among points of 2: the third is taken for a height",
         .hint = "if it is none: decimals are written with a full stop, [0.5, 4.0] and not "
                 "[0,5, 4.0]"});
}

/// A plan of rooms is no plan of a floor: where rooms touch there are walls, which a union of their
/// insides would lose without a word. Import gives them a thickness, and doors.
void refuse_plan_of_rooms(std::span<const std::string> files) {
  for (const std::string& file : files) {
    const std::string text = content::read_source(file, "missing-file");
    if (text.find("\"indoor\"") == std::string::npos) continue;
    const std::size_t rooms = import::count_rooms(
        import::read_geojson_features(file, file::without_byte_order_mark(text)));
    if (rooms < 2) continue;
    throw content::ContentError(
        file, 0, 0, "plan-of-rooms",
        fmt::format(
            "this is a plan of {} rooms (indoor=room and the like), and a floor is one area "
            "to walk on: the walls between them would be lost",
            rooms),
        fmt::format("make a museum of it: docent-content import {} -o MUSEUM, then compile MUSEUM",
                    file));
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

/// Finds out what the exhibits stand on, and makes obstacles of what takes floor.
FloorPlan furnish(std::vector<Standing> things, CompiledFloor& compiled) {
  std::vector<floor::Footprint> cases, free;
  for (const Standing& thing : things)
    if (thing.kind == Standing::Kind::Case && takes_floor(thing)) cases.push_back(thing.footprint);
  compiled.with_cases = floor::with_obstacles(compiled.walls, cases);
  const path::WallGrid grid(compiled.walls, 0);
  for (Standing& thing : things) {
    if (thing.kind != Standing::Kind::Exhibit) continue;
    thing.place = what_it_stands_on(grid, compiled.drawn.polygons, cases, thing.footprint.centre);
    if (takes_floor(thing)) free.push_back(thing.footprint);
  }
  compiled.standing = std::move(things);
  return floor::with_obstacles(compiled.with_cases, free);
}

/// The labels of the first radius, which is 0 and the quickest, tell whether those of the others
/// are worth trying.
void make_labels(Floor& floor, unsigned jobs, std::size_t most_entries) {
  if (floor.tangent_graphs.empty()) return;
  path::MadeLabels first =
      path::try_hub_labels(floor.plan, floor.tangent_graphs.front(), {}, most_entries);
  floor.hub_labels.front() = std::move(first.labels);
  if (first.far_too_many) return;
  content::for_each_index(floor.hub_labels.size() - 1, jobs, [&](std::size_t i) {
    floor.hub_labels[i + 1] =
        path::make_hub_labels(floor.plan, floor.tangent_graphs[i + 1], {}, most_entries);
  });
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
                            Report& report, Progress& progress, unsigned jobs,
                            FloorContents contents, std::size_t most_entries) {
  CompiledFloor compiled;
  Floor& floor = compiled.floor;
  {
    const auto stage = progress.start("plan");
    refuse_plan_of_rooms(files);
    compiled.drawn = import::read_floor_plan(files, coordinates);
    report_left_out(compiled.drawn, report);
    report_doubtful_heights(compiled.drawn, report);
    floor::open_doors(compiled.drawn, contents.doors);
    compiled.gaps = plan_gaps(compiled.drawn);
    report.add(dangling_doorways(compiled.drawn));
    compiled.walls =
        floor::close_doors(mend(compiled.drawn, report), contents.doors, compiled.door_faults);
    compiled.walls.doors = std::move(contents.doors);
    compiled.walls.name = name;
    floor.plan = furnish(std::move(contents.standing), compiled);
  }
  {
    const auto stage = progress.start("voronoi");
    floor.diagram = floor::voronoi_diagram(floor.plan);
    floor.roadmap = floor::medial_axis(floor.plan, floor.diagram);
  }
  const auto stage = progress.start("paths");
  floor.sight = floor::make_sight_map(floor.plan, floor.diagram);
  floor.tangent_graphs.resize(radii.size());
  floor.hub_labels.resize(radii.size());
  content::for_each_index(radii.size(), jobs, [&](std::size_t i) {
    floor.tangent_graphs[i] = path::make_tangent_graph(floor.plan, floor.sight, radii[i]);
  });
  make_labels(floor, jobs, most_entries);
  report_searched(floor, files.front(), report);
  return compiled;
}

}  // namespace docent::compile
