#include "runtime/path/shortest/savings.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

#include "tests/runtime/path/floors.h"

namespace docent::test::savings_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double turn_along(const TangentGraph& graph, std::uint32_t side, double angle) {
  const TangentArc& arc = graph.arc[side / 2];
  return side % 2 == 0 ? angle - arc.begin : arc.end - angle;
}

/// How long a disc's way is at least that leaves a side and arrives at each other one, without the
/// rolls at both ends: Dijkstra over the tangents.
std::vector<double> lengths_from(const TangentGraph& graph, std::uint32_t start) {
  std::vector<double> to_side(2 * graph.arc.size(), infinity), by(graph.tangent.size(), infinity);
  using Arrival = std::pair<double, std::uint32_t>;
  std::priority_queue<Arrival, std::vector<Arrival>, std::greater<>> queue;
  const auto take = [&](std::uint32_t k, double so_far) {
    const double length = so_far + graph.tangent[k].length;
    if (length >= by[k]) return;
    by[k] = length;
    queue.emplace(length, k);
  };
  for (std::uint32_t k = graph.side_first[start]; k < graph.side_first[start + 1]; ++k) take(k, 0);
  while (!queue.empty()) {
    const auto [length, k] = queue.top();
    queue.pop();
    const Tangent& tangent = graph.tangent[k];
    const std::uint32_t side = tangent.arrive_side;
    to_side[side] = std::min(to_side[side], length);
    if (length > by[k] || tangent.onward == TangentGraph::no_tangent) continue;
    for (std::uint32_t next = tangent.onward; next < graph.side_first[side + 1]; ++next)
      take(next, length + graph.radius * (turn_along(graph, side, graph.tangent[next].leave_angle) -
                                          turn_along(graph, side, tangent.arrive_angle)));
  }
  return to_side;
}

RC_GTEST_PROP(Savings, AreWhatAPointsWayIsLongerAtMost, ()) {
  const auto plan = random_hall();
  RC_PRE(plan.has_value());
  const double radius = 0.01 * *rc::gen::inRange(5, 60);
  const Floor floor = floor_of(*plan, {0, radius});
  const TangentGraph& graph = floor.tangent_graphs.at(1);
  RC_PRE(!graph.tangent.empty());
  const std::vector<double> saved = path::savings(graph);
  std::vector<Vec2> corner;
  for (const TangentArc& arc : graph.arc) corner.push_back(plan->vertex[arc.vertex]);

  const auto from = *rc::gen::inRange<std::uint32_t>(0, static_cast<std::uint32_t>(saved.size()));
  const std::vector<double> disc = lengths_from(graph, from);
  const std::vector<double> point = brute_force_lengths(*plan, corner[from / 2], corner);
  for (std::uint32_t to = 0; to < saved.size(); ++to)
    if (disc[to] < infinity)
      RC_ASSERT(point[to / 2] <= disc[to] + saved[from] + saved[to ^ 1U] + 1e-7);
}

TEST(Savings, AreSmallBesideLongTangents) {
  // No way round one box changes its sense, and its sides are 2 m long.
  const Floor floor = floor_of(hall_with_a_box(), {0, 0.25});

  for (const double saved : path::savings(floor.tangent_graphs.at(1))) EXPECT_LT(saved, 0.04);
}

TEST(Savings, AreTheRadiusAtMost) {
  // Between two posts that a disc just passes, its ways change their sense within millimetres.
  const Floor floor = floor_of(drawn({{0, 0}, {8, 0}, {8, 6}, {0, 6}},
                                     {rectangle({3, 1}, {4, 2.7}), rectangle({4.02, 3.2}, {5, 5})}),
                               {0, 0.25});
  const std::vector<double> saved = path::savings(floor.tangent_graphs.at(1));

  EXPECT_GT(*std::ranges::max_element(saved), 0.1);
  for (const double metres : saved) EXPECT_LE(metres, 0.25);
}

}  // namespace
}  // namespace docent::test::savings_test
