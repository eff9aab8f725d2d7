#include "content/draw/plan/plan_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>

#include "content/draw/plan/plan_labels.h"
#include "content/draw/plan/plan_legend.h"
#include "content/draw/plan/plan_rings.h"
#include "content/draw/plan/plan_style.h"
#include "content/draw/svg.h"
#include "runtime/model/geometry/bisector.h"
#include "runtime/model/none.h"

namespace docent::draw {
namespace {

constexpr double longer_side = 1800;  // Pixels.
constexpr double margin = 70;
constexpr double caption = 70;  // Below the plan, for the scale bar.
constexpr double narrowest = 700;
constexpr double label_letter = 17;
constexpr const char* sans = "font-family=\"Inter, Noto Sans, sans-serif\"";

/// The floor's frame on the page.
class Page {
 public:
  Page(const FloorPlan& plan, const PlanLegend& legend) {
    Vec2 low{infinity, infinity}, high{-infinity, -infinity};
    for (const Vec2 vertex : plan.vertex) {
      low = glm::min(low, vertex);
      high = glm::max(high, vertex);
    }
    if (plan.vertex.empty()) low = {0, 0}, high = {1, 1};
    const Vec2 size = glm::max(high - low, Vec2{1e-6, 1e-6});
    scale_ = (longer_side - 2 * margin) / std::max(size.x, size.y);
    north_west_ = {low.x, high.y};
    // The caption needs a certain width, however narrow the plan is.
    width_ = std::ceil(std::max(scale_ * size.x + 2 * margin, narrowest));
    west_ = (width_ - scale_ * size.x) / 2;
    plan_height_ = scale_ * size.y + 2 * margin;
    height_ = std::ceil(plan_height_ + caption + legend.height(width_ - 2 * margin));
  }

  [[nodiscard]] double width() const { return width_; }
  [[nodiscard]] double height() const { return height_; }
  [[nodiscard]] double plan_height() const { return plan_height_; }  ///< Without the caption.
  [[nodiscard]] double pixels(double metres) const { return scale_ * metres; }
  [[nodiscard]] Vec2 at(Vec2 p) const {
    return {west_ + scale_ * (p.x - north_west_.x), margin + scale_ * (north_west_.y - p.y)};
  }

 private:
  double scale_ = 1, width_ = 0, height_ = 0, plan_height_ = 0, west_ = 0;
  Vec2 north_west_{};
};

/// Draws one floor, layer by layer.
class PlanPainter {
 public:
  PlanPainter(const Museum& museum, std::uint32_t floor, PlanLegend legend)
      : museum_(museum),
        floor_index_(floor),
        floor_(museum.floors[floor]),
        plan_(floor_.plan),
        diagram_(floor_.diagram),
        legend_(std::move(legend)),
        page_(plan_, legend_),
        svg_(page_.width(), page_.height()) {}

  void draw_paper() {
    svg_.rectangle({0, 0}, {page_.width(), page_.height()}, fmt::format("fill=\"{}\"", ink::paper));
  }
  void draw_ground();
  void draw_walls();
  void draw_regions();
  void draw_sites();
  void draw_skeleton();
  void draw_exhibits();
  void draw_levels(const std::vector<DrawnLine>& lines);
  void draw_line(const DrawnLine& line);
  void draw_caption();

  [[nodiscard]] std::string document() const { return svg_.document(); }

 private:
  void add_ring(PathData& path, const Ring& ring) const;
  [[nodiscard]] PathData rings_of(RingRole role) const;
  void add_line(PathData& path, const DrawnLine& line) const;
  void add_edge(PathData& path, const VoronoiEdge& edge, bool forwards) const;
  [[nodiscard]] PathData region_outline(std::uint32_t site) const;
  [[nodiscard]] std::vector<std::uint32_t> neighbours_before(std::uint32_t site) const;
  void draw_kiosk();

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
  place_labels(labels, label_letter, {page_.width(), page_.plan_height()});
  for (const Label& label : labels)
    svg_.text(label.baseline, label.words,
              fmt::format("{} font-size=\"{:.0f}\" fill=\"{}\" stroke=\"{}\" stroke-width=\"4\" "
                          "stroke-linejoin=\"round\" paint-order=\"stroke\"",
                          sans, label_letter, ink::black, ink::floor));
  if (museum_.kiosk_floor == floor_index_ && !museum_.exhibits.empty()) draw_kiosk();
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

}  // namespace

std::string draw_plan(const Museum& museum, std::uint32_t floor, const PlanLayers& layers,
                      const std::vector<DrawnLine>& lines) {
  PlanPainter painter(museum, floor, PlanLegend(museum.floors[floor].plan, layers, lines));
  painter.draw_paper();
  if (layers.walls) painter.draw_ground();
  if (layers.regions) painter.draw_regions();
  painter.draw_levels(lines);
  if (layers.walls) painter.draw_walls();
  if (layers.skeleton) painter.draw_skeleton();
  for (const DrawnLine& line : lines)
    if (line.kind) painter.draw_line(line);
  if (layers.sites) painter.draw_sites();
  if (layers.exhibits) painter.draw_exhibits();
  painter.draw_caption();
  return painter.document();
}

}  // namespace docent::draw
