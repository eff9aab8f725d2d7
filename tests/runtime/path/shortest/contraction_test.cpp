#include "runtime/path/shortest/contraction.h"
#include "runtime/model/none.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "runtime/model/geometry/vec2.h"

namespace docent::test::contraction_test {
namespace {

using Row = std::vector<double>;

std::vector<path::Link> random_links(std::uint32_t nodes) {
  std::vector<path::Link> links;
  for (int k = *rc::gen::inRange(0, 60); k > 0; --k)
    links.push_back({*rc::gen::inRange(0U, nodes), *rc::gen::inRange(0U, nodes),
                     *rc::gen::inRange(0, 50) / 4.0, static_cast<std::uint32_t>(links.size())});
  return links;
}

/// Floyd and Warshall.
std::vector<Row> all_distances(std::uint32_t nodes, const std::vector<path::Link>& links) {
  std::vector<Row> distance(nodes, Row(nodes, infinity));
  for (std::uint32_t i = 0; i < nodes; ++i) distance[i][i] = 0;
  for (const path::Link& link : links)
    distance[link.from][link.to] = std::min(distance[link.from][link.to], link.length);
  for (std::uint32_t k = 0; k < nodes; ++k)
    for (Row& row : distance)
      for (std::uint32_t j = 0; j < nodes; ++j) row[j] = std::min(row[j], row[k] + distance[k][j]);
  return distance;
}

/// What a search upwards finds from a node, in the order of the ranks.
Row climb(const path::Hierarchy& hierarchy,
          const std::vector<std::vector<path::Hierarchy::Arc>>& arcs, std::uint32_t start) {
  Row distance(hierarchy.rank.size(), infinity);
  distance[start] = 0;
  std::vector<std::uint32_t> by_rank(hierarchy.rank.size());
  for (std::uint32_t i = 0; i < by_rank.size(); ++i) by_rank[hierarchy.rank[i]] = i;
  for (const std::uint32_t node : by_rank)
    for (const path::Hierarchy::Arc& arc : arcs[node])
      distance[arc.node] = std::min(distance[arc.node], distance[node] + arc.length);
  return distance;
}

/// The shortest way into the core from one node's climb, through it, and to the other's.
double through_core(const path::Hierarchy& hierarchy, const path::CoreLabels& labels, const Row& up,
                    const Row& down) {
  double found = infinity;
  for (std::uint32_t i = 0; i < hierarchy.core.size(); ++i)
    for (std::uint32_t k = 0; k < hierarchy.core.size(); ++k)
      for (const auto& leaving : labels.leaving[i])
        if (const auto* arriving = path::CoreLabels::find(labels.arriving[k], leaving.hub))
          found = std::min(found, up[hierarchy.core[i]] + leaving.length + arriving->length +
                                      down[hierarchy.core[k]]);
  return found;
}

RC_GTEST_PROP(Contraction, KeepsEveryDistanceAsAWayUpThroughTheCoreAndDown, ()) {
  const std::uint32_t nodes = *rc::gen::inRange(1U, 14U);
  const std::vector<path::Link> links = random_links(nodes);
  const auto most_added = *rc::gen::inRange<std::size_t>(0, 8);

  const auto contracted = path::contract(nodes, links, static_cast<std::uint32_t>(links.size()),
                                         most_added, std::stop_token{});

  RC_ASSERT(contracted.has_value());
  const path::Hierarchy& hierarchy = *contracted;
  const auto core = path::make_core_labels(hierarchy.core_graph, 100'000, std::stop_token{});
  RC_ASSERT(core.has_value());

  const std::vector<Row> expected = all_distances(nodes, links);
  for (std::uint32_t from = 0; from < nodes; ++from)
    for (std::uint32_t to = 0; to < nodes; ++to) {
      const Row up = climb(hierarchy, hierarchy.up, from);
      const Row down = climb(hierarchy, hierarchy.down, to);
      double found = through_core(hierarchy, *core, up, down);
      for (std::uint32_t k = 0; k < nodes; ++k) found = std::min(found, up[k] + down[k]);
      RC_ASSERT(found == expected[from][to]);
    }
}

RC_GTEST_PROP(CoreLabels, LeadToTheirHubsNodeByNode, ()) {
  const std::uint32_t nodes = *rc::gen::inRange(1U, 14U);
  const std::vector<path::Link> links = random_links(nodes);
  path::CoreGraph graph{.out = std::vector<std::vector<path::CoreGraph::Arc>>(nodes),
                        .in = std::vector<std::vector<path::CoreGraph::Arc>>(nodes)};
  for (const path::Link& link : links) {
    graph.out[link.from].push_back({link.to, link.name, link.length});
    graph.in[link.to].push_back({link.from, link.name, link.length});
  }

  const auto labels = path::make_core_labels(graph, 100'000, std::stop_token{});

  RC_ASSERT(labels.has_value());
  for (std::uint32_t node = 0; node < nodes; ++node)
    for (const auto& entry : labels->leaving[node]) {
      double walked = 0;
      std::uint32_t at = node;
      while (at != labels->node_of_hub[entry.hub]) {
        const auto* step = path::CoreLabels::find(labels->leaving[at], entry.hub);
        RC_ASSERT(step != nullptr);
        RC_ASSERT(links[step->link].from == at && links[step->link].to == step->next);
        walked += links[step->link].length;
        at = step->next;
      }
      RC_ASSERT(walked == entry.length);
    }
}

TEST(Contraction, IsGivenUpWhenItIsAskedToStop) {
  std::stop_source source;
  source.request_stop();
  const std::vector<path::Link> links{{0, 1, 1, 0}, {1, 2, 1, 1}, {2, 0, 1, 2}, {0, 2, 1, 3}};

  EXPECT_FALSE(path::contract(3, links, 4, 8, source.get_token()).has_value());
  EXPECT_TRUE(path::contract(3, links, 4, 8, std::stop_token{}).has_value());
}

TEST(CoreLabels, AreGivenUpWhenTheyWouldBeTooManyAndWhenAskedToStop) {
  const path::CoreGraph graph{.out = {{{1, 0, 1}}, {}}, .in = {{}, {{0, 0, 1}}}};
  std::stop_source source;
  source.request_stop();

  EXPECT_FALSE(path::make_core_labels(graph, 2, std::stop_token{}).has_value());
  EXPECT_GT(path::make_core_labels(graph, 2, std::stop_token{}).error(), 2U);
  EXPECT_FALSE(path::make_core_labels(graph, 100, source.get_token()).has_value());
  EXPECT_TRUE(path::make_core_labels(graph, 100, std::stop_token{}).has_value());
}

/// Points at random in a square, each joined with those that are near.
path::CoreGraph crowded_graph(std::uint32_t nodes, double reach) {
  std::mt19937 random(5);
  std::vector<Vec2> point;
  for (std::uint32_t i = 0; i < nodes; ++i)
    point.emplace_back(static_cast<double>(random() % 10'000) / 10'000,
                       static_cast<double>(random() % 10'000) / 10'000);
  path::CoreGraph graph{.out = std::vector<std::vector<path::CoreGraph::Arc>>(nodes),
                        .in = std::vector<std::vector<path::CoreGraph::Arc>>(nodes)};
  std::uint32_t link = 0;
  for (std::uint32_t i = 0; i < nodes; ++i)
    for (std::uint32_t k = 0; k < nodes; ++k) {
      const double length = glm::distance(point[i], point[k]);
      if (i == k || length > reach) continue;
      graph.out[i].push_back({k, link, length});
      graph.in[k].push_back({i, link, length});
      ++link;
    }
  return graph;
}

TEST(CoreLabels, AreGivenUpEarlyAndNeverWhereThereIsRoomForThem) {
  for (const double reach : {0.07, 0.15, 0.4}) {
    const path::CoreGraph graph = crowded_graph(800, reach);
    const auto labels = path::make_core_labels(graph, 10'000'000, std::stop_token{});
    ASSERT_TRUE(labels.has_value());
    std::size_t entries = 0;
    for (const auto* side : {&labels->leaving, &labels->arriving})
      for (const auto& label : *side) entries += label.size();

    EXPECT_TRUE(path::make_core_labels(graph, entries, std::stop_token{}).has_value()) << reach;
    const auto too_many = path::make_core_labels(graph, entries / 3, std::stop_token{});
    ASSERT_FALSE(too_many.has_value()) << reach;
    EXPECT_GT(too_many.error(), entries / 3);
    EXPECT_LE(too_many.error(), entries) << "it is told that there would be at least so many";
  }
}

}  // namespace
}  // namespace docent::test::contraction_test
