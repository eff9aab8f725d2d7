#include "runtime/crowd/cells.h"

#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include "runtime/crowd/contact.h"
#include "runtime/model/geometry/bisector.h"
#include "runtime/path/floor_map.h"

namespace docent::crowd {
namespace {

constexpr double most_squares = 1 << 20;

std::uint32_t root_of(std::vector<std::uint32_t>& parent, std::uint32_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

template <class T>
void sort_out(std::vector<T>& values) {
  std::ranges::sort(values);
  values.erase(std::ranges::unique(values).begin(), values.end());
}

}  // namespace

/// Which regions are in which squares, and which two of them meet there.
struct WalkableCells::Cut {
  using Piece = std::pair<std::uint32_t, std::uint32_t>;  ///< Square, region.
  struct Border {
    std::uint32_t square = 0, left = 0, right = 0;
  };
  const WalkableCells& cells;
  std::vector<Piece> piece;
  std::vector<Border> border;

  template <class Visitor>
  void visit_squares(Vec2 low, Vec2 high, Visitor visit) const {
    const auto columns = static_cast<std::uint32_t>(cells.columns_);
    const std::uint32_t first = cells.square_at(low - Vec2{margin, margin});
    const std::uint32_t last = cells.square_at(high + Vec2{margin, margin});
    for (std::uint32_t y = first / columns; y <= last / columns; ++y)
      for (std::uint32_t x = first % columns; x <= last % columns; ++x) visit(y * columns + x);
  }
  /// The squares that a segment passes.
  template <class Visitor>
  void visit_squares_along(Vec2 from, Vec2 to, Visitor visit) const {
    const Vec2 along = to - from;
    const double length = std::sqrt(dot(along, along));
    const Vec2 normal = length > 0 ? left_of(along) / length : Vec2{0, 0};
    const double beside = margin + (std::abs(normal.x) + std::abs(normal.y)) * cells.size_ / 2;
    visit_squares(glm::min(from, to), glm::max(from, to), [&](std::uint32_t square) {
      const Vec2 centre = cells.centre_of_square(square);
      if (std::abs(dot(normal, centre - from)) <= beside) visit(square);
    });
  }

  void add_wall(std::uint32_t region, Vec2 from, Vec2 to) {
    visit_squares_along(from, to,
                        [&](std::uint32_t square) { piece.emplace_back(square, region); });
  }
  void add_border(const VoronoiEdge& edge, std::uint32_t square) {
    piece.emplace_back(square, edge.left);
    piece.emplace_back(square, edge.right);
    border.push_back({square, edge.left, edge.right});
  }
  void add_edge(const FloorPlan& plan, const VoronoiDiagram& diagram, const VoronoiEdge& edge) {
    const Vec2 from = diagram.vertex[edge.from], to = diagram.vertex[edge.to];
    const auto add = [&](std::uint32_t square) { add_border(edge, square); };
    if (!edge.parabola) return visit_squares_along(from, to, add);
    // In arcs of half a square at most; each lies in the triangle of its ends and control point.
    const Parabola parabola = parabola_of(plan, diagram, edge);
    const double begin = parameter_at(parabola, from), end = parameter_at(parabola, to);
    const int arcs = 1 + static_cast<int>(arc_length(parabola, begin, end) / (cells.size_ / 2));
    for (int i = 0; i < arcs; ++i) {
      const double u = begin + (end - begin) * i / arcs, v = begin + (end - begin) * (i + 1) / arcs;
      const Vec2 p = point_at(parabola, u), q = point_at(parabola, v);
      const Vec2 middle = control_point(parabola, u, v);
      visit_squares(glm::min(glm::min(p, q), middle), glm::max(glm::max(p, q), middle), add);
    }
  }
};

WalkableCells::WalkableCells(const path::FloorMap& map, double size) : map_(map) {
  const FloorPlan& plan = map.plan();
  const VoronoiDiagram& diagram = map.floor().diagram;
  Vec2 low{}, high{};
  if (!plan.vertex.empty()) low = high = plan.vertex.front();
  for (const Vec2 v : plan.vertex) low = glm::min(low, v), high = glm::max(high, v);
  origin_ = low - Vec2{margin, margin};
  const Vec2 extent = high - low + Vec2{2 * margin, 2 * margin};
  size_ = std::max({size, std::sqrt(extent.x * extent.y / most_squares),
                    std::max(extent.x, extent.y) / most_squares});
  per_metre_ = 1 / size_;
  columns_ = 1 + static_cast<std::int32_t>(extent.x * per_metre_);
  rows_ = 1 + static_cast<std::int32_t>(extent.y * per_metre_);

  Cut cut{*this, {}, {}};
  for (const VoronoiEdge& edge : diagram.edge) cut.add_edge(plan, diagram, edge);
  for (std::uint32_t region = 0; region < diagram.site.size(); ++region) {
    const Site site = diagram.site[region];
    const bool is_wall = site.kind == Site::Kind::Wall;
    cut.add_wall(region, plan.vertex[site.index],
                 is_wall ? wall_end(plan, site.index) : plan.vertex[site.index]);
  }
  // What is left are the squares inside a region.
  const auto squares = static_cast<std::uint32_t>(columns_ * rows_);
  for (std::uint32_t square = 0; square < squares && !plan.vertex.empty(); ++square)
    if (const Vec2 centre = centre_of_square(square); map.is_inside(centre))
      cut.piece.emplace_back(square, map.site_at(centre));
  sort_out(cut.piece);
  join_pieces(cut);
  link_cells();
  join_cells();
  sort_walls();
  sort_corners();
}

void WalkableCells::join_pieces(const Cut& cut) {
  const std::size_t squares = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  square_first_.assign(squares + 1, 0);
  for (const auto& [square, region] : cut.piece) {
    ++square_first_[square + 1];
    piece_.push_back({region, 0});
  }
  std::partial_sum(square_first_.begin(), square_first_.end(), square_first_.begin());

  std::vector<std::uint32_t> parent(piece_.size());
  std::iota(parent.begin(), parent.end(), 0U);
  const auto index_of = [&](std::uint32_t square, std::uint32_t region) {
    return static_cast<std::uint32_t>(
        std::ranges::lower_bound(cut.piece, Cut::Piece{square, region}) - cut.piece.begin());
  };
  for (const auto& [square, left, right] : cut.border)
    parent[root_of(parent, index_of(square, left))] = root_of(parent, index_of(square, right));

  std::vector<std::uint32_t> bay_of_root(piece_.size(), none);
  for (std::uint32_t i = 0; i < piece_.size(); ++i) {
    std::uint32_t& cell = bay_of_root[root_of(parent, i)];
    if (cell == none) {
      cell = static_cast<std::uint32_t>(centre_.size());
      square_.push_back(cut.piece[i].first);
      centre_.push_back(centre_of_square(square_.back()));
    }
    piece_[i].cell = cell;
  }
}

void WalkableCells::link_cells() {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> links;
  const auto link = [&](std::uint32_t square, std::uint32_t other) {
    for (std::uint32_t i = square_first_[square]; i < square_first_[square + 1]; ++i) {
      const std::uint32_t cell = cell_at(other, piece_[i].region);
      if (cell == none) continue;
      links.emplace_back(piece_[i].cell, cell);
      links.emplace_back(cell, piece_[i].cell);
    }
  };
  const auto columns = static_cast<std::uint32_t>(columns_),
             rows = static_cast<std::uint32_t>(rows_);
  for (std::uint32_t y = 0; y < rows; ++y)
    for (std::uint32_t x = 0; x < columns; ++x) {
      const std::uint32_t square = y * columns + x;
      if (x + 1 < columns) link(square, square + 1);
      if (y + 1 < rows) link(square, square + columns);
    }
  sort_out(links);
  next_first_.assign(count() + 1, 0);
  for (const auto& [cell, other] : links) {
    ++next_first_[cell + 1];
    next_.push_back(other);
  }
  std::partial_sum(next_first_.begin(), next_first_.end(), next_first_.begin());
}

/// Two cells of one square are joined if a way leads from one to the other through the squares
/// about it.
void WalkableCells::join_cells() {
  std::vector<std::uint32_t> parent(count());
  std::iota(parent.begin(), parent.end(), 0U);
  std::vector<std::uint32_t> reached;
  for (std::uint32_t cell = 0; cell < count(); ++cell) {
    const auto is_about = [&](std::uint32_t other) {
      const Vec2 apart = glm::abs(centre_[other] - centre_[cell]);
      return std::max(apart.x, apart.y) < 1.5 * size_;
    };
    reached.assign(1, cell);
    for (std::size_t done = 0; done < reached.size(); ++done)
      for (const std::uint32_t next : next_to(reached[done]))
        if (is_about(next) && std::ranges::find(reached, next) == reached.end())
          reached.push_back(next);
    for (const std::uint32_t other : reached)
      if (square_[other] == square_[cell]) parent[root_of(parent, other)] = root_of(parent, cell);
  }

  std::vector<std::uint32_t> number(count(), none), squares_of;
  for (std::uint32_t cell = 0; cell < count(); ++cell) {
    std::uint32_t& joined = number[root_of(parent, cell)];
    if (joined == none) {
      joined = static_cast<std::uint32_t>(squares_of.size());
      squares_of.push_back(square_[cell]);
    }
    if (cell != root_of(parent, cell)) number[cell] = joined;
  }
  for (Piece& piece : piece_) piece.cell = number[root_of(parent, piece.cell)];
  square_ = std::move(squares_of);
  centre_.clear();
  for (const std::uint32_t at : square_) centre_.push_back(centre_of_square(at));
  next_.clear();
  link_cells();

  const std::size_t squares = square_first_.size() - 1;
  only_cell_.assign(squares, none);
  for (std::size_t square = 0; square < squares; ++square) {
    const auto pieces = std::span(piece_).subspan(
        square_first_[square], square_first_[square + 1] - square_first_[square]);
    const auto is_other = [&](const Piece& piece) { return piece.cell != pieces.front().cell; };
    if (!pieces.empty() && std::ranges::none_of(pieces, is_other))
      only_cell_[square] = pieces.front().cell;
  }
}

void WalkableCells::sort_walls() {
  const FloorPlan& plan = map_.plan();
  const auto columns = static_cast<std::uint32_t>(columns_ * tiles);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> sorted;
  for (std::uint32_t wall = 0; wall < plan.vertex.size(); ++wall) {
    const Vec2 from = wall_start(plan, wall), to = wall_end(plan, wall);
    const Vec2 normal = left_of(glm::normalize(to - from));
    const double beside = margin + (std::abs(normal.x) + std::abs(normal.y)) * size_ / tiles / 2;
    const auto [left, bottom] = tile_at(glm::min(from, to) - margin);
    const auto [right, top] = tile_at(glm::max(from, to) + margin);
    for (std::uint32_t y = bottom; y <= top; ++y)
      for (std::uint32_t x = left; x <= right; ++x) {
        const Vec2 centre = origin_ + size_ / tiles * Vec2{x + 0.5, y + 0.5};
        if (std::abs(dot(normal, centre - from)) <= beside)
          sorted.emplace_back(y * columns + x, wall);
      }
  }
  sort_out(sorted);
  wall_first_.assign(
      static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows_) * tiles + 1, 0);
  for (const auto& [tile, wall] : sorted) {
    ++wall_first_[tile + 1];
    wall_.push_back({wall_start(plan, wall), wall_end(plan, wall)});
  }
  std::partial_sum(wall_first_.begin(), wall_first_.end(), wall_first_.begin());
}

void WalkableCells::sort_corners() {
  const auto columns = static_cast<std::uint32_t>(columns_ * tiles);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> sorted;
  for (const Site site : map_.floor().diagram.site) {
    if (site.kind != Site::Kind::Corner) continue;
    const auto [x, y] = tile_at(map_.plan().vertex[site.index]);
    sorted.emplace_back(y * columns + x, site.index);
  }
  sort_out(sorted);
  corner_first_.assign(wall_first_.size(), 0);
  for (const auto& [tile, vertex] : sorted) {
    ++corner_first_[tile + 1];
    corner_.push_back(map_.plan().vertex[vertex]);
  }
  std::partial_sum(corner_first_.begin(), corner_first_.end(), corner_first_.begin());
}

}  // namespace docent::crowd
