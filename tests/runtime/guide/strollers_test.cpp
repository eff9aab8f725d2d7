// Visitors on their own in the sample museum: ten minutes of simulated time.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "platform/sqlite/content_reader.h"
#include "runtime/guide/crowd.h"
#include "runtime/guide/strollers.h"
#include "runtime/path/route.h"
#include "tests/support/sample_database.h"
#include "tests/support/sanitized.h"

namespace docent::guide::strollers_test {
namespace {

constexpr double watched_seconds = test::is_sanitized ? 120 : 600;

Museum busy_museum(std::uint32_t count) {
  Museum museum = sqlite::load_museum(test::sample_database()).value();
  museum.ambient.count = count;
  return museum;
}

struct Stroll {
  std::vector<std::vector<Placement>> track;  ///< Per visitor and frame, while it is there.
  double deepest_overlap = -1, least_clearance = 1e9, quickest = 0, longest_held = 0, ways = 0;
  double mean_ms = 0, worst_ms = 0;
};

Stroll stroll(const Museum& museum, double seconds) {
  plan::Planner planner(museum, {}, museum.ambient.count);
  Crowd crowd(museum, planner);
  Strollers strollers(museum);
  strollers.enter(crowd);
  Stroll out;
  out.track.resize(crowd.size());
  std::vector<std::optional<Vec2>> goal(crowd.size());
  const auto frames = static_cast<int>(seconds * 60);
  for (int f = 0; f < frames; ++f) {
    planner.wait();
    const auto began = std::chrono::steady_clock::now();
    crowd.step(1.0 / 60);
    strollers.step(crowd);
    const std::chrono::duration<double, std::milli> taken =
        std::chrono::steady_clock::now() - began;
    out.mean_ms += taken.count() / frames;
    out.worst_ms = std::max(out.worst_ms, taken.count());
    for (std::uint32_t i = 0; i < crowd.size(); ++i) {
      if (!crowd[i].is_here) continue;
      const Placement body = crowd[i].avatar.body;
      if (!out.track[i].empty())
        out.quickest =
            std::max(out.quickest, 60 * glm::distance(out.track[i].back().position, body.position));
      out.track[i].push_back(body);
      out.longest_held = std::max(out.longest_held, crowd[i].blocked_seconds);
      const bool rides = ride_of(crowd[i].avatar) != nullptr;
      if (!rides)
        out.least_clearance =
            std::min(out.least_clearance,
                     path::clearance_at(*planner.maps()[crowd[i].avatar.floor], body.position) -
                         museum.body_radius);
      if (crowd[i].goal && crowd[i].goal->position != goal[i]) {
        goal[i] = crowd[i].goal->position;
        ++out.ways;
      }
      for (std::uint32_t j = 0; j < i; ++j)
        if (crowd[j].is_here && !rides && ride_of(crowd[j].avatar) == nullptr &&
            crowd[j].avatar.floor == crowd[i].avatar.floor)
          out.deepest_overlap = std::max(
              out.deepest_overlap,
              2 * museum.body_radius - glm::distance(crowd[j].avatar.body.position, body.position));
    }
  }
  return out;
}

TEST(Strollers, NeverTouchEachOtherOrAWall) {
  NEEDS_SPEED();
  const Stroll seen = stroll(busy_museum(40), watched_seconds);

  std::printf(
      "40 strollers, %.0f s: overlap %.1f mm, clearance %+.1f mm, held up for %.1f s at most, "
      "%.0f ways, a step %.3f ms (worst %.2f)\n",
      watched_seconds, 1e3 * seen.deepest_overlap, 1e3 * seen.least_clearance, seen.longest_held,
      seen.ways, seen.mean_ms, seen.worst_ms);
  EXPECT_LE(seen.deepest_overlap, 0.005);
  EXPECT_GE(seen.least_clearance, -0.01);
  EXPECT_LT(seen.quickest, 2.2);
  EXPECT_GT(seen.ways, 40 * (watched_seconds - 60) / 60);  // the first minute they come in
  EXPECT_LT(seen.longest_held, 60);
  for (const auto& track : seen.track) EXPECT_FALSE(track.empty());
}

TEST(Strollers, DoTheSameTwice) {
  const Museum museum = busy_museum(12);

  const Stroll first = stroll(museum, 20), second = stroll(museum, 20);

  for (std::size_t i = 0; i < first.track.size(); ++i) {
    ASSERT_EQ(first.track[i].size(), second.track[i].size());
    EXPECT_EQ(first.track[i].back().position, second.track[i].back().position);
  }
}

TEST(Strollers, AreInAQuietMuseumOnlyFromWhenTheyAreToldToComeUntilTheyAreToldToGo) {
  const Museum museum = busy_museum(0);
  plan::Planner planner(museum, {}, Strollers::most(museum));
  Crowd crowd(museum, planner);
  Strollers strollers(museum);
  const auto there_after = [&](int frames) {
    for (int f = 0; f < frames; ++f) {
      planner.wait();
      crowd.step(1.0 / 60);
      strollers.step(crowd);
    }
    return std::ranges::count_if(crowd.members(), &Agent::is_here);
  };

  strollers.enter(crowd);
  EXPECT_EQ(there_after(120), 0);
  for (int again = 0; again < 3; ++again) {
    strollers.come(crowd);
    EXPECT_EQ(there_after(60 * 60), static_cast<std::ptrdiff_t>(crowd.size()));
    EXPECT_EQ(crowd.collisions(), 0U);
    strollers.leave(crowd);
    EXPECT_EQ(there_after(1), 0) << "at once";
    EXPECT_EQ(there_after(60), 0);
  }
}

}  // namespace
}  // namespace docent::guide::strollers_test
