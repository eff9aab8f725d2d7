#pragma once

#include <functional>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "tests/bench/bench_floor.h"
#include "tests/bench/found_path.h"

namespace docent::bench {

/// Somebody who answers queries.
struct Entrant {
  std::string name;
  bool is_exact = true;
  std::function<FoundPath(const Query&)> find;
  double made_in_seconds = 0;
  double megabytes = 0;  ///< What it holds in memory between queries.
};

/// Ours, as the kiosk asks it. Borrows the floor.
Entrant our_entrant(const BenchFloor& floor, double megabytes);

/// How an entrant did. A query's time is the median of its rounds, which leaves out what the rest
/// of the machine did meanwhile.
struct Score {
  double median_us = 0, p99_us = 0;  ///< Over the queries.
  double worst_error = 0;            ///< Relative, of the length, against the first entrant's.
  int other_verdicts = 0;            ///< Queries for which only one of the two found a path.
};

/// Times the same queries with all entrants in turn, in a new random order every round, on one
/// thread; each time is that of the whole path with its points in memory.
std::vector<Score> contest(std::span<const Entrant> entrants, std::span<const Query> queries,
                           int rounds, std::mt19937_64& random);

}  // namespace docent::bench
