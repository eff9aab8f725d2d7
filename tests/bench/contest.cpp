#include "tests/bench/contest.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tests/bench/measure.h"

namespace docent::bench {
namespace {

/// What one entrant said and how long it took, by query.
struct Notes {
  std::vector<double> length;
  std::vector<std::vector<double>> microseconds;
};

void ask_all(const Entrant& entrant, std::span<const Query> queries,
             std::span<const std::size_t> order, Notes& notes) {
  for (const std::size_t i : order) {
    const double begin = now();
    const FoundPath path = entrant.find(queries[i]);
    notes.microseconds[i].push_back((now() - begin) * 1e6);
    notes.length[i] = path.length;
  }
}

Score score_of(const Notes& notes, const Notes& first) {
  Score score;
  std::vector<double> times;
  for (std::size_t i = 0; i < notes.length.size(); ++i) {
    times.push_back(median(notes.microseconds[i]));
    const double length = notes.length[i], wanted = first.length[i];
    if (std::isfinite(length) != std::isfinite(wanted)) {
      ++score.other_verdicts;
    } else if (std::isfinite(length)) {
      const double error = std::abs(length - wanted) / std::max(wanted, 1e-3);
      score.worst_error = std::max(score.worst_error, error);
    }
  }
  score.median_us = median(times);
  score.p99_us = quantile(times, 0.99);
  return score;
}

}  // namespace

Entrant our_entrant(const BenchFloor& floor, double megabytes) {
  const auto find = [&floor](const Query& query) {
    path::Way way = path::route(
        *floor.map,
        {.from = query.from, .to = query.to, .radius = query.radius, .tell_clearance = false});
    if (way.status != path::RouteStatus::Ok) return FoundPath{};
    return FoundPath{way.length, std::move(way.points)};
  };
  return {"docent", true, find, floor.compile_seconds, megabytes};
}

std::vector<Score> contest(std::span<const Entrant> entrants, std::span<const Query> queries,
                           int rounds, std::mt19937_64& random) {
  const Notes blank{std::vector<double>(queries.size()),
                    std::vector<std::vector<double>>(queries.size())};
  std::vector<Notes> notes(entrants.size(), blank);
  std::vector<std::size_t> order(queries.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (int round = 0; round < rounds; ++round) {
    std::ranges::shuffle(order, random);
    for (std::size_t e = 0; e < entrants.size(); ++e)
      ask_all(entrants[e], queries, order, notes[e]);
  }
  std::vector<Score> scores;
  for (const Notes& each : notes) scores.push_back(score_of(each, notes.front()));
  return scores;
}

}  // namespace docent::bench
