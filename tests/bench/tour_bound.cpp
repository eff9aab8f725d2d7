#include "tests/bench/tour_bound.h"

#include <algorithm>
#include <vector>

namespace docent::bench {
namespace {

constexpr double no_way = 1e6;
using Costs = std::vector<std::vector<double>>;
/// Per node: which node it is come to from. The root is node 0.
using Parents = std::vector<std::size_t>;

Parents cheapest_parents(const Costs& costs) {
  Parents parents(costs.size(), 0);
  for (std::size_t to = 1; to < costs.size(); ++to)
    for (std::size_t from = 0; from < costs.size(); ++from)
      if (from != to && (parents[to] == to || costs[from][to] < costs[parents[to]][to]))
        parents[to] = from;
  return parents;
}

/// The nodes of a cycle; empty where there is none.
std::vector<std::size_t> cycle_in(const Parents& parents) {
  std::vector<std::size_t> seen(parents.size(), 0);
  for (std::size_t start = 1; start < parents.size(); ++start) {
    std::size_t at = start;
    while (at != 0 && seen[at] == 0) {
      seen[at] = start;
      at = parents[at];
    }
    if (at == 0 || seen[at] != start) continue;
    std::vector<std::size_t> cycle{at};
    for (std::size_t next = parents[at]; next != at; next = parents[next]) cycle.push_back(next);
    return cycle;
  }
  return {};
}

/// The arborescence of least cost: a cycle of cheapest parents is made one node, and opened where
/// the arborescence of the rest comes into it.
Parents arborescence(const Costs& costs) {
  Parents parents = cheapest_parents(costs);
  const std::vector<std::size_t> cycle = cycle_in(parents);
  if (cycle.empty()) return parents;
  const auto in_cycle = [&](std::size_t node) {
    return std::ranges::find(cycle, node) != cycle.end();
  };
  std::vector<std::size_t> rest;
  for (std::size_t node = 0; node < costs.size(); ++node)
    if (!in_cycle(node)) rest.push_back(node);
  const std::size_t one = rest.size();  // the cycle
  Costs smaller(one + 1, std::vector<double>(one + 1, 0));
  Parents enters(one, 0), leaves(one, 0);
  for (std::size_t a = 0; a < one; ++a) {
    for (std::size_t b = 0; b < one; ++b) smaller[a][b] = costs[rest[a]][rest[b]];
    const auto into = [&](std::size_t node) {
      return costs[rest[a]][node] - costs[parents[node]][node];
    };
    const auto out_of = [&](std::size_t node) { return costs[node][rest[a]]; };
    enters[a] = *std::ranges::min_element(cycle, {}, into);
    leaves[a] = *std::ranges::min_element(cycle, {}, out_of);
    smaller[a][one] = into(enters[a]);
    smaller[one][a] = out_of(leaves[a]);
  }
  const Parents found = arborescence(smaller);
  for (std::size_t a = 1; a < one; ++a)
    parents[rest[a]] = found[a] == one ? leaves[a] : rest[found[a]];
  parents[enters[found[one]]] = rest[found[one]];
  return parents;
}

}  // namespace

double lower_bound_of(const path::TourCosts& costs, double known) {
  // An end that costs nothing: then every other node has one successor.
  const std::size_t end = costs.places, nodes = end + 1;
  std::vector<double> price(nodes, 0);
  double best = 0, step = 0.02 * known / static_cast<double>(nodes);
  for (int round = 0; round < 600; ++round, step *= 0.99) {
    Costs priced(nodes, std::vector<double>(nodes, no_way));
    for (std::size_t a = 0; a < end; ++a)
      for (std::size_t b = 1; b < nodes; ++b)
        priced[a][b] = price[a] + (b == end ? 0 : std::min(costs.at(a, b), no_way));
    const Parents parents = arborescence(priced);
    double bound = 0;
    std::vector<int> successors(nodes, 0);
    for (std::size_t b = 1; b < nodes; ++b) {
      bound += priced[parents[b]][b];
      ++successors[parents[b]];
    }
    for (std::size_t a = 0; a < end; ++a) bound -= price[a];
    best = std::max(best, bound);
    for (std::size_t a = 0; a < end; ++a) price[a] += step * (successors[a] - 1);
  }
  return best;
}

}  // namespace docent::bench
