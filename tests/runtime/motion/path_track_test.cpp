#include "runtime/motion/path_track.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace docent::motion::path_track_test {
namespace {

std::vector<Vec2> circle(double radius) {
  std::vector<Vec2> out;
  for (int i = 0; i <= 360; ++i) {
    const double a = i * std::numbers::pi / 180;
    out.push_back({radius * std::sin(a), radius - radius * std::cos(a)});
  }
  return out;
}

TEST(PathTrack, KeepsBothEndsOfThePath) {
  const std::vector<Vec2> path{{1, 2}, {4, 2}, {4, 6}};

  const PathTrack track = make_path_track(path, {});

  EXPECT_LT(glm::distance(track.position.front(), path.front()), 1e-9);
  EXPECT_LT(glm::distance(track.position.back(), path.back()), 1e-9);
  EXPECT_NEAR(track.length(), 7, 1e-9);
}

TEST(PathTrack, LeavesACircleOfHalfAMetreByAboutACentimetre) {
  const PathTrack track = make_path_track(circle(0.5), {});

  for (const Vec2 p : track.position) EXPECT_NEAR(glm::distance(p, {0, 0.5}), 0.5, 0.012);
}

TEST(PathTrack, RoundsARightAngleOnItsInside) {
  const PathTrack track = make_path_track(std::vector<Vec2>{{0, 0}, {3, 0}, {3, 3}}, {});

  for (const Vec2 p : track.position) {
    EXPECT_LT(p.x, 3 + 1e-9);
    EXPECT_GT(p.y, -1e-9);
    EXPECT_LT(std::min(std::abs(p.y), std::abs(p.x - 3)), 0.07);
  }
}

TEST(PathTrack, TurnsRoundWithoutALeapOfTheHeading) {
  const PathTrack track = make_path_track(std::vector<Vec2>{{0, 0}, {3, 0}, {0, 0}}, {});

  EXPECT_NEAR(std::abs(track.heading.back() - track.heading.front()), std::numbers::pi, 1e-6);
  for (std::size_t i = 1; i < track.heading.size(); ++i)
    EXPECT_LT(std::abs(track.heading[i] - track.heading[i - 1]), 0.2);
}

TEST(PathTrack, TakesShorterStridesInASharpCornerOnly) {
  const PathTrack track = make_path_track(std::vector<Vec2>{{0, 0}, {3, 0}, {3, 3}}, {});

  EXPECT_LT(track.stride[track.stride.size() / 2], 0.95);
  EXPECT_NEAR(track.stride[track.stride.size() / 8], 1, 1e-6);
  EXPECT_GT(track.effort.back(), track.length());
}

TEST(PathTrack, KeepsTheCadenceInASharpCorner) {
  const PathTrack track = make_path_track(std::vector<Vec2>{{0, 0}, {3, 0}, {3, 3}}, {});

  for (const double cadence : track.cadence) EXPECT_GT(cadence, 0.94);
  EXPECT_LT(track.stride[track.stride.size() / 2], 0.6);
}

TEST(PathTrack, SurvivesRepeatedAndNearlyRepeatedPoints) {
  const PathTrack track =
      make_path_track(std::vector<Vec2>{{0, 0}, {0, 0}, {1, 0}, {1 + 1e-7, 1e-7}, {1, 1}}, {});

  for (std::size_t i = 0; i < track.position.size(); ++i) {
    EXPECT_TRUE(std::isfinite(track.position[i].x + track.position[i].y + track.heading[i]));
    if (i > 0) {
      EXPECT_GT(track.effort[i], track.effort[i - 1]);
    }
  }
}

TEST(PathTrack, IsFoundAgainByEffort) {
  const PathTrack track = make_path_track(std::vector<Vec2>{{0, 0}, {2, 0}}, {});
  std::size_t hint = 0;

  EXPECT_NEAR(at_effort(track, 0.5, hint).placement.position.x, 0.5, 1e-6);
  EXPECT_NEAR(at_effort(track, 1.5, hint).along, 1.5, 1e-6);
  EXPECT_NEAR(at_effort(track, 0.25, hint).along, 0.25, 1e-6);
  EXPECT_NEAR(at_effort(track, 99, hint).along, 2, 1e-9);
  EXPECT_NEAR(at_effort(track, -1, hint).along, 0, 1e-9);
}

TEST(FirstPart, EndsWhereItShould) {
  const std::vector<Vec2> part = first_part(std::vector<Vec2>{{0, 0}, {1, 0}, {1, 5}}, 1.5);

  EXPECT_NEAR(polyline_length(part), 1.5, 1e-12);
  EXPECT_EQ(part.back(), Vec2(1, 0.5));
}

}  // namespace
}  // namespace docent::motion::path_track_test
