#include "content/draw/plan/plan_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>
#include <string_view>
#include <utility>

#include "content/draw/plan/plan_labels.h"
#include "content/draw/plan/plan_legend.h"
#include "content/draw/plan/plan_rings.h"
#include "content/draw/plan/plan_signs.h"
#include "content/draw/plan/plan_style.h"
#include "content/draw/svg.h"
#include "runtime/model/geometry/bisector.h"
#include "runtime/model/geometry/polygon.h"
#include "runtime/model/none.h"

namespace docent::draw {
namespace {

constexpr double margin = 70;   // Pixels.
constexpr double caption = 70;  // Below the plan, for the scale bar.
constexpr double narrowest = 700;
constexpr double label_letter = 17;
constexpr const char* sans = "font-family=\"Inter, Noto Sans, sans-serif\"";

/// What of the floor's frame is drawn, and how large.
struct PageFrame {
  Vec2 low{infinity, infinity}, high{-infinity, -infinity};
  double longer_side = 1800;

  void hold(const FloorPlan& plan) {
    for (const Vec2 vertex : plan.vertex) {
      low = glm::min(low, vertex);
      high = glm::max(high, vertex);
    }
  }
};

/// The floor's frame on the page.
class Page {
 public:
  Page(const PageFrame& frame, double legend_height) {
    Vec2 low = frame.low, high = frame.high;
    if (!(low.x <= high.x)) low = {0, 0}, high = {1, 1};
    const Vec2 size = glm::max(high - low, Vec2{1e-6, 1e-6});
    scale_ = (frame.longer_side - 2 * margin) / std::max(size.x, size.y);
    north_west_ = {low.x, high.y};
    south_east_ = {high.x, low.y};
    // The caption needs a certain width, however narrow the plan is.
    width_ = std::ceil(std::max(scale_ * size.x + 2 * margin, narrowest));
    west_ = (width_ - scale_ * size.x) / 2;
    plan_height_ = scale_ * size.y + 2 * margin;
    height_ = std::ceil(plan_height_ + caption + legend_height);
  }

  [[nodiscard]] double width() const { return width_; }
  [[nodiscard]] double height() const { return height_; }
  [[nodiscard]] double plan_height() const { return plan_height_; }  ///< Without the caption.
  [[nodiscard]] Vec2 north_west() const { return north_west_; }
  [[nodiscard]] Vec2 south_east() const { return south_east_; }
  [[nodiscard]] double pixels(double metres) const { return scale_ * metres; }
  [[nodiscard]] Vec2 at(Vec2 p) const {
    return {west_ + scale_ * (p.x - north_west_.x), margin + scale_ * (north_west_.y - p.y)};
  }

 private:
  double scale_ = 1, width_ = 0, height_ = 0, plan_height_ = 0, west_ = 0;
  Vec2 north_west_{}, south_east_{};
};

/// Draws one floor, layer by layer.
class PlanPainter {
 public:
  PlanPainter(const Museum& museum, std::uint32_t floor, const PageFrame& frame, PlanLegend legend,
              double legend_height)
      : museum_(museum),
        floor_index_(floor),
        floor_(museum.floors[floor]),
        plan_(floor_.plan),
        diagram_(floor_.diagram),
        legend_(std::move(legend)),
        page_(frame, legend_height),
        svg_(page_.width(), page_.height()) {}

  void draw_paper() {
    svg_.rectangle({0, 0}, {page_.width(), page_.height()}, fmt::format("fill=\"{}\"", ink::paper));
  }
  void draw_ground();
  void draw_walls();
  void draw_regions();
  void draw_sites();
  void draw_skeleton();
  void draw_grid();
  void draw_connections();
  void draw_flight(Vec2 from, Vec2 to);
  void draw_exhibits();
  void draw_levels(const std::vector<DrawnLine>& lines);
  void draw_line(const DrawnLine& line);
  void draw_caption();

  [[nodiscard]] const Svg& drawing() const { return svg_; }

 private:
  void add_ring(PathData& path, const Ring& ring) const;
  [[nodiscard]] PathData rings_of(RingRole role) const;
  void add_line(PathData& path, const DrawnLine& line) const;
  void add_edge(PathData& path, const VoronoiEdge& edge, bool forwards) const;
  [[nodiscard]] PathData region_outline(std::uint32_t site) const;
  [[nodiscard]] std::vector<std::uint32_t> neighbours_before(std::uint32_t site) const;
  void draw_kiosk();
  void draw_labels(std::vector<Label>& labels);
  void draw_grid_line(Vec2 from, Vec2 to, double metres, bool thick);

  const Museum& museum_;
  std::uint32_t floor_index_;
  const Floor& floor_;
  const FloorPlan& plan_;
  const VoronoiDiagram& diagram_;
  PlanLegend legend_;
  Page page_;
  Svg svg_;
};

void PlanPainter::add_ring(PathData& path, const Ring& ring) const {
  for (std::uint32_t i = 0; i < ring.count; ++i) {
    const Vec2 p = page_.at(plan_.vertex[ring.first + i]);
    if (i == 0)
      path.move_to(p);
    else
      path.line_to(p);
  }
  path.close();
}

/// Continues a path, which is at one end of the edge, to the other end.
void PlanPainter::add_edge(PathData& path, const VoronoiEdge& edge, bool forwards) const {
  const Vec2 from = diagram_.vertex[edge.from], to = diagram_.vertex[edge.to];
  const Vec2 end = page_.at(forwards ? to : from);
  if (!edge.parabola) {
    path.line_to(end);
    return;
  }
  const Parabola parabola = parabola_of(plan_, diagram_, edge);
  path.curve_to(
      page_.at(control_point(parabola, parameter_at(parabola, from), parameter_at(parabola, to))),
      end);
}

PathData PlanPainter::rings_of(RingRole role) const {
  PathData path;
  for (const Ring& ring : plan_.ring)
    if (role_of(plan_, ring) == role) add_ring(path, ring);
  return path;
}

/// What is no floor, and the floor over it: so a room within a block, or within a case, is seen.
void PlanPainter::draw_ground() {
  const auto filled = [](std::string_view paint) { return fmt::format("fill=\"{}\"", paint); };
  // Walls are cut through. Half of the stroke lies on the floor's side and is covered by the floor.
  const double thickness = std::clamp(page_.pixels(0.35), 5.0, 30.0);
  const std::string cut = fmt::format(
      "stroke=\"{}\" stroke-width=\"{:.2f}\" stroke-linejoin=\"miter\" stroke-miterlimit=\"3\"",
      ink::cut_face, 2 * thickness);
  if (has_role(plan_, RingRole::Block)) {
    svg_.hatch(block_hatch, ink::plaster, ink::stone);
    svg_.path(rings_of(RingRole::Block), filled(fmt::format("url(#{})", block_hatch)));
    svg_.path(rings_of(RingRole::Block), "fill=\"none\" " + cut);
  }
  svg_.path(rings_of(RingRole::Case), filled(ink::plaster));
  svg_.path(rings_of(RingRole::Partition), filled(ink::cut_face));
  svg_.path(rings_of(RingRole::Outline), "fill=\"none\" " + cut);
  PathData floor;
  for (const Ring& ring : plan_.ring) add_ring(floor, ring);
  svg_.path(floor, filled(ink::floor) + " fill-rule=\"evenodd\"");
}

/// The edges of all that is no floor, and doors.
void PlanPainter::draw_walls() {
  PathData edges;
  for (const Ring& ring : plan_.ring) add_ring(edges, ring);
  svg_.path(edges, fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"1.6\" "
                               "stroke-linejoin=\"round\"",
                               ink::cut_face));
  for (const Door& door : plan_.doors)
    svg_.path(PathData().move_to(page_.at(door.a)).line_to(page_.at(door.b)), door_stroke(door));
}

PathData PlanPainter::region_outline(std::uint32_t site) const {
  PathData path;
  const auto [kind, index] = diagram_.site[site];
  if (kind == Site::Kind::Wall)
    path.move_to(page_.at(wall_start(plan_, index))).line_to(page_.at(wall_end(plan_, index)));
  else
    path.move_to(page_.at(plan_.vertex[index]));
  for (std::uint32_t i = diagram_.region_first[site]; i < diagram_.region_first[site + 1]; ++i) {
    const VoronoiEdge& edge = diagram_.edge[diagram_.region_edge[i]];
    add_edge(path, edge, edge.left == site);
  }
  return path.close();
}

std::vector<std::uint32_t> PlanPainter::neighbours_before(std::uint32_t site) const {
  std::vector<std::uint32_t> neighbours;
  for (std::uint32_t i = diagram_.region_first[site]; i < diagram_.region_first[site + 1]; ++i) {
    const VoronoiEdge& edge = diagram_.edge[diagram_.region_edge[i]];
    const std::uint32_t other = edge.left == site ? edge.right : edge.left;
    if (other < site) neighbours.push_back(other);
  }
  return neighbours;
}

void PlanPainter::draw_regions() {
  // One soft tint per region, unlike those of the neighbours that have theirs already. The search
  // begins at another tint each time, so that all are used.
  std::vector<std::size_t> tint(diagram_.site.size(), 0);
  for (std::uint32_t site = 0; site < diagram_.site.size(); ++site) {
    std::array<bool, region_tints> taken{};
    for (const std::uint32_t other : neighbours_before(site)) taken[tint[other]] = true;
    tint[site] = site * 5 % region_tints;
    for (std::size_t i = 0; i < region_tints && taken[tint[site]]; ++i)
      tint[site] = (tint[site] + 1) % region_tints;
    const std::string fill = region_colour(tint[site]);
    svg_.path(region_outline(site),
              fmt::format("fill=\"{0}\" stroke=\"{0}\" stroke-width=\"0.5\"", fill));
  }
  PathData borders, wall_and_own_corner;
  for (const VoronoiEdge& edge : diagram_.edge) {
    PathData& path = edge.on_medial_axis ? borders : wall_and_own_corner;
    path.move_to(page_.at(diagram_.vertex[edge.from]));
    add_edge(path, edge, true);
  }
  const auto draw = [this](const PathData& path, double darkness, double width) {
    svg_.path(path, fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"",
                                mixed(ink::floor, ink::quiet, darkness), width));
  };
  draw(wall_and_own_corner, 0.3, 0.7);
  draw(borders, 0.65, 1.1);
}

void PlanPainter::draw_sites() {
  for (std::uint32_t wall = 0; wall < plan_.next.size(); ++wall)
    svg_.path(PathData()
                  .move_to(page_.at(wall_start(plan_, wall)))
                  .line_to(page_.at(wall_end(plan_, wall))),
              wall_site_stroke(wall));
  for (const Site& site : diagram_.site)
    if (site.kind == Site::Kind::Corner)
      svg_.circle(page_.at(plan_.vertex[site.index]), 3.2,
                  fmt::format("fill=\"{}\"", ink::vermilion));
}

void PlanPainter::draw_skeleton() {
  double widest = 1e-9;
  for (const double clearance : floor_.roadmap.clearance) widest = std::max(widest, clearance);
  svg_.begin_group("fill=\"none\" stroke-linecap=\"round\"");
  for (const RoadmapEdge& edge : floor_.roadmap.edges) {
    const VoronoiEdge& shape = diagram_.edge[edge.voronoi_edge];
    PathData path;
    path.move_to(page_.at(diagram_.vertex[shape.from]));
    add_edge(path, shape, true);
    const double wide = std::sqrt(edge.clearance / widest);
    svg_.path(path, axis_stroke(wide));
  }
  svg_.end_group();
}

void PlanPainter::draw_exhibits() {
  std::vector<Label> labels;
  for (const Exhibit& exhibit : museum_.exhibits) {
    if (exhibit.floor != floor_index_) continue;
    const Vec2 object = page_.at(exhibit.placement.position);
    const Vec2 viewer = page_.at(exhibit.viewing_point.position);
    svg_.path(PathData().move_to(object).line_to(viewer),
              fmt::format("stroke=\"{}\" stroke-width=\"1.2\" stroke-dasharray=\"1 5\" "
                          "stroke-linecap=\"round\"",
                          ink::quiet));
    svg_.circle(
        viewer, 4.5,
        fmt::format("fill=\"{}\" stroke=\"{}\" stroke-width=\"1.6\"", ink::floor, ink::quiet));
    svg_.circle(
        object, 6.5,
        fmt::format("fill=\"{}\" stroke=\"{}\" stroke-width=\"1.5\"", ink::vermilion, ink::floor));
    labels.push_back({exhibit.id, object, {}});
  }
  draw_labels(labels);
  if (museum_.kiosk_floor == floor_index_ && !museum_.exhibits.empty()) draw_kiosk();
}

void PlanPainter::draw_labels(std::vector<Label>& labels) {
  place_labels(labels, label_letter, {page_.width(), page_.plan_height()});
  for (const Label& label : labels)
    svg_.text(label.baseline, label.words,
              fmt::format("{} font-size=\"{:.0f}\" fill=\"{}\" stroke=\"{}\" stroke-width=\"4\" "
                          "stroke-linejoin=\"round\" paint-order=\"stroke\"",
                          sans, label_letter, ink::black, ink::floor));
}

/// A line at a whole number of metres east (downwards) or north, with the number where it begins.
void PlanPainter::draw_grid_line(Vec2 from, Vec2 to, double metres, bool thick) {
  svg_.path(PathData().move_to(from).line_to(to),
            fmt::format("stroke=\"{}\" stroke-opacity=\"{}\" stroke-width=\"1\"", ink::quiet,
                        thick ? 0.4 : 0.18));
  const bool downwards = from.x == to.x;
  const Vec2 beside = downwards ? Vec2{0, -6} : Vec2{-6, 5};
  svg_.text(from + beside, fmt::format("{:g}", metres + 0.0),
            fmt::format("{} font-size=\"14\" fill=\"{}\" text-anchor=\"{}\"", sans, ink::quiet,
                        downwards ? "middle" : "end"));
}

void PlanPainter::draw_grid() {
  constexpr double closest = 60;  // Pixels between two lines.
  constexpr double beyond = 30;   // Pixels that they reach beyond the plan.
  double step = 1;
  for (const double next : {2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0, 1e4, 1e5})
    if (page_.pixels(step) < closest) step = next;
  const Vec2 low{page_.north_west().x, page_.south_east().y};
  const Vec2 high{page_.south_east().x, page_.north_west().y};
  const Vec2 corner = page_.at(page_.north_west()) - Vec2{beyond, beyond};
  const Vec2 opposite = page_.at(page_.south_east()) + Vec2{beyond, beyond};
  const auto is_round = [step](double metres) {
    return std::abs(std::remainder(metres, 5 * step)) < 1e-6 * step;
  };
  for (double x = step * std::ceil(low.x / step); x <= high.x; x += step) {
    const double at = page_.at({x, 0}).x;
    draw_grid_line({at, corner.y}, {at, opposite.y}, x, is_round(x));
  }
  for (double y = step * std::ceil(low.y / step); y <= high.y; y += step) {
    const double at = page_.at({0, y}).y;
    draw_grid_line({corner.x, at}, {opposite.x, at}, y, is_round(y));
  }
}

/// The hole that a straight flight between two stops lies in: no block, but steps.
void PlanPainter::draw_flight(Vec2 from, Vec2 to) {
  constexpr double tread = 0.27;  // Metres.
  const Vec2 along = (to - from) / std::max(glm::distance(from, to), 1e-9);
  for (const Ring& ring : plan_.ring) {
    const auto corners = std::span(plan_.vertex).subspan(ring.first, ring.count);
    if (role_of(plan_, ring) == RingRole::Outline || !contains(corners, (from + to) / 2.0))
      continue;
    PathData outline, steps;
    add_ring(outline, ring);
    for (double at = 0; at < glm::distance(from, to); at += tread) {
      std::vector<Vec2> ends;
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 a = corners[i], b = corners[(i + 1) % corners.size()];
        const double left = dot(a - from, along) - at, right = dot(b - from, along) - at;
        if ((left < 0) != (right < 0)) ends.push_back(a + (b - a) * (left / (left - right)));
      }
      if (ends.size() == 2) steps.move_to(page_.at(ends[0])).line_to(page_.at(ends[1]));
    }
    const std::string line = fmt::format("stroke=\"{}\" stroke-width=\"1.6\"", ink::cut_face);
    // Over the thick edge of what looked like a block.
    svg_.path(outline, fmt::format("fill=\"{0}\" stroke=\"{0}\" stroke-width=\"{1:.2f}\"",
                                   ink::floor, page_.pixels(0.3)));
    svg_.path(outline, fmt::format("fill=\"{}\" {}", ink::plaster, line));
    svg_.path(steps, "fill=\"none\" " + line);
  }
}

/// Flights, a sign at each stop, and a dotted line to where it leads on the plan.
void PlanPainter::draw_connections() {
  constexpr double sign = 26;  // Pixels.
  for (const Connection& connection : museum_.connections)
    for (std::size_t i = 1; i < connection.stops.size(); ++i) {
      const ConnectionStop &low = connection.stops[i - 1], &high = connection.stops[i];
      if (connection.kind != ConnectionKind::Lift &&
          (low.floor == floor_index_ || high.floor == floor_index_))
        draw_flight(low.placement.position, high.placement.position);
    }
  std::vector<Label> labels;
  for (const Connection& connection : museum_.connections) {
    for (std::size_t i = 0; i < connection.stops.size(); ++i) {
      const ConnectionStop& stop = connection.stops[i];
      if (stop.floor != floor_index_) continue;
      const Vec2 at = page_.at(stop.placement.position);
      for (const std::size_t other : {i - 1, i + 1})
        if (other < connection.stops.size())
          svg_.path(
              PathData().move_to(at).line_to(page_.at(connection.stops[other].placement.position)),
              fmt::format("stroke=\"{}\" stroke-width=\"3\" stroke-dasharray=\"1 7\" "
                          "stroke-linecap=\"round\"",
                          connection.closed ? ink::vermilion : ink::teal));
      draw_sign(svg_, connection, at, sign);
      labels.push_back({words_at_stop(museum_, connection, i), at, {}});
    }
  }
  draw_labels(labels);
}

/// "You are here": a disc with a beak in the direction of the visitor's look.
void PlanPainter::draw_kiosk() {
  const Vec2 at = museum_.kiosk.position;
  const Vec2 ahead{std::cos(museum_.kiosk.heading), std::sin(museum_.kiosk.heading)};
  const double size = 16 / page_.pixels(1);
  svg_.path(PathData()
                .move_to(page_.at(at + 1.5 * size * ahead))
                .line_to(page_.at(at + 0.7 * size * left_of(ahead)))
                .line_to(page_.at(at - 0.7 * size * left_of(ahead)))
                .close(),
            fmt::format("fill=\"{}\"", ink::black));
  svg_.circle(page_.at(at), 12, fmt::format("fill=\"{}\"", ink::black));
  svg_.circle(page_.at(at), 4.5, fmt::format("fill=\"{}\"", ink::paper));
}

void PlanPainter::add_line(PathData& path, const DrawnLine& line) const {
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    if (i == 0)
      path.move_to(page_.at(line.points[i]));
    else
      path.line_to(page_.at(line.points[i]));
  }
  if (line.closed) path.close();
}

void PlanPainter::draw_levels(const std::vector<DrawnLine>& lines) {
  std::map<double, PathData> levels;
  for (const DrawnLine& line : lines)
    if (!line.kind) add_line(levels[line.clearance], line);
  for (const auto& [clearance, path] : levels) svg_.path(path, level_style(levels.size()));
}

void PlanPainter::draw_line(const DrawnLine& line) {
  if (line.points.empty()) return;
  PathData path;
  add_line(path, line);
  if (line.closed) {
    svg_.path(path, fmt::format("fill=\"none\" stroke=\"#{:06X}\" stroke-width=\"3\" "
                                "stroke-linejoin=\"round\"",
                                info_of(*line.kind).colour));
    return;
  }
  const double width = std::clamp(page_.pixels(0.25), 4.0, 11.0);
  svg_.path(path, fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"{:.2f}\" "
                              "stroke-linejoin=\"round\" stroke-linecap=\"round\"",
                              ink::floor, width + 5));  // Sets it off from what lies below.
  svg_.path(path, way_stroke(info_of(*line.kind), width));
  for (const Vec2 end : {line.points.front(), line.points.back()})
    svg_.circle(
        page_.at(end), 1.1 * width,
        fmt::format("fill=\"{}\" stroke=\"{}\" stroke-width=\"3\"", ink::black, ink::floor));
}

/// Name, scale bar, north arrow and legend.
void PlanPainter::draw_caption() {
  double bar = 1;  // Metres: 1, 2 or 5 times a power of ten, about a fifth of the page.
  for (const double next : {2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0, 1e4, 1e5})
    if (page_.pixels(next) < 0.22 * page_.width()) bar = next;
  const double y = page_.plan_height() + 0.2 * caption;
  const double length = page_.pixels(bar);
  const Vec2 left{margin, y};
  for (int i = 0; i < 4; ++i)
    svg_.rectangle(left + Vec2{0.25 * i * length, -4}, {0.25 * length, 8},
                   fmt::format("fill=\"{0}\" stroke=\"{1}\" stroke-width=\"1.2\"",
                               i % 2 == 0 ? ink::cut_face : ink::floor, ink::cut_face));
  const std::string words = fmt::format("{} font-size=\"20\" fill=\"{}\"", sans, ink::quiet);
  svg_.text(left + Vec2{length + 16, 7}, fmt::format("{:g} m", bar), words);

  const Vec2 north{page_.width() - margin - 10, y};
  svg_.path(PathData()
                .move_to(north + Vec2{0, -22})
                .line_to(north + Vec2{8, 14})
                .line_to(north + Vec2{0, 8})
                .line_to(north + Vec2{-8, 14})
                .close(),
            fmt::format("fill=\"{}\"", ink::cut_face));
  svg_.text(north + Vec2{-36, 8}, "N", words);
  svg_.text({page_.width() / 2, y + 8}, plan_.name,
            fmt::format("font-family=\"Noto Serif, serif\" font-size=\"26\" fill=\"{}\" "
                        "text-anchor=\"middle\"",
                        ink::black));
  legend_.draw(svg_, {margin, page_.plan_height() + 0.75 * caption}, page_.width() - 2 * margin);
}

struct PlanPicture {
  const Museum& museum;
  std::uint32_t floor = 0;
  const PlanLayers& layers;
  const std::vector<DrawnLine>& lines;

  [[nodiscard]] PlanLegend legend() const { return {museum.floors[floor].plan, layers, lines}; }
};

Svg painted(const PlanPicture& it, const PageFrame& frame, double legend_height) {
  PlanPainter painter(it.museum, it.floor, frame, it.legend(), legend_height);
  painter.draw_paper();
  if (it.layers.walls) painter.draw_ground();
  if (it.layers.regions) painter.draw_regions();
  if (it.layers.grid) painter.draw_grid();
  painter.draw_levels(it.lines);
  if (it.layers.walls) painter.draw_walls();
  if (it.layers.skeleton) painter.draw_skeleton();
  for (const DrawnLine& line : it.lines)
    if (line.kind) painter.draw_line(line);
  if (it.layers.sites) painter.draw_sites();
  if (it.layers.connections) painter.draw_connections();
  if (it.layers.exhibits) painter.draw_exhibits();
  painter.draw_caption();
  return painter.drawing();
}

/// Pixels that the legend needs below a plan in this frame.
double legend_height(const PlanPicture& it, const PageFrame& frame) {
  return it.legend().height(Page(frame, 0).width() - 2 * margin);
}

}  // namespace

std::string draw_plan(const Museum& museum, std::uint32_t floor, const PlanLayers& layers,
                      const std::vector<DrawnLine>& lines) {
  const PlanPicture picture{museum, floor, layers, lines};
  PageFrame frame;
  frame.hold(museum.floors[floor].plan);
  return painted(picture, frame, legend_height(picture, frame)).document();
}

std::string draw_building(const Museum& museum, const std::vector<DrawnFloor>& floors,
                          const PlanLayers& layers) {
  constexpr double floors_side = 1300;  // Pixels.
  constexpr std::size_t in_a_row = 4;
  PageFrame frame{.longer_side = floors_side};
  for (const DrawnFloor& one : floors) frame.hold(museum.floors[one.floor].plan);
  double legend = 0;
  for (const DrawnFloor& one : floors)
    legend = std::max(legend, legend_height({museum, one.floor, layers, one.lines}, frame));
  const Page page(frame, legend);
  const std::size_t columns = std::clamp<std::size_t>(floors.size(), 1, in_a_row);
  const std::size_t rows = (floors.size() + columns - 1) / columns;
  Svg sheet(page.width() * static_cast<double>(columns), page.height() * static_cast<double>(rows));
  sheet.rectangle({0, 0}, sheet.size(), fmt::format("fill=\"{}\"", ink::paper));
  for (std::size_t i = 0; i < floors.size(); ++i) {
    const std::size_t row = i / columns, column = i % columns;
    sheet.embed(
        painted({museum, floors[i].floor, layers, floors[i].lines}, frame, legend),
        {page.width() * static_cast<double>(column), page.height() * static_cast<double>(row)});
  }
  return sheet.document();
}

}  // namespace docent::draw
