#include "content/import/drawing/arrangement.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "content/import/drawing/inscribed.h"

namespace docent::test::arrangement_test {
namespace {

using import::WallLine;

std::vector<WallLine> rectangle(Vec2 low, Vec2 high) {
  return {{low, {high.x, low.y}},
          {{high.x, low.y}, high},
          {high, {low.x, high.y}},
          {{low.x, high.y}, low}};
}

TEST(Arrangement, CutsTwoCrossingRectanglesIntoThreeFaces) {
  std::vector<WallLine> lines = rectangle({0, 0}, {2, 2});
  std::ranges::copy(rectangle({1, 1}, {3, 3}), std::back_inserter(lines));

  const auto arrangement = import::arrange(lines);

  ASSERT_TRUE(arrangement);
  std::vector<double> areas;
  for (const import::Face& face : import::trace_faces(*arrangement).face)
    areas.push_back(face.area);
  EXPECT_THAT(areas, testing::UnorderedElementsAre(testing::DoubleNear(3, 1e-9),
                                                   testing::DoubleNear(1, 1e-9),
                                                   testing::DoubleNear(3, 1e-9)));
}

TEST(Arrangement, KnowsWhatStandsFreeInAFaceAsItsHole) {
  std::vector<WallLine> lines = rectangle({0, 0}, {10, 10});
  std::ranges::copy(rectangle({4, 4}, {6, 6}), std::back_inserter(lines));

  const import::Faces faces = import::trace_faces(*import::arrange(lines));

  ASSERT_EQ(faces.face.size(), 2U);
  const auto outer =
      std::ranges::find_if(faces.face, [](const auto& face) { return !face.holes.empty(); });
  ASSERT_NE(outer, faces.face.end());
  EXPECT_NEAR(outer->area, 96, 1e-9);
}

TEST(Arrangement, TakesAwayWhatEndsInNothing) {
  std::vector<WallLine> lines = rectangle({0, 0}, {2, 2});
  lines.push_back({{1, 0}, {1, 1}});
  lines.push_back({{1, 1}, {1.5, 1}});
  import::Arrangement arrangement = *import::arrange(lines);

  EXPECT_EQ(import::remove_loose_pieces(arrangement), 2U);
  EXPECT_EQ(import::trace_faces(arrangement).face.size(), 1U);
}

TEST(Arrangement, PutsEndsThatNearlyMeetOnOneAnother) {
  const std::vector<WallLine> lines = {
      {{0, 0}, {2, 0}}, {{2.004, 0.003}, {2, 2}}, {{2, 2}, {0, 2.005}}, {{0, 2}, {0.001, 0.001}}};

  const import::Arrangement arrangement = *import::arrange(lines);

  EXPECT_GT(arrangement.snapped, 0U);
  ASSERT_EQ(import::trace_faces(arrangement).face.size(), 1U);
  EXPECT_NEAR(import::trace_faces(arrangement).face.front().area, 4, 0.05);
}

TEST(Arrangement, LetsALineWithoutLengthCrossNothing) {
  std::vector<WallLine> lines = rectangle({0, 0}, {2, 2});
  lines.push_back({{1, 1}, {1, 1}});
  lines.push_back({{2, 1}, {2, 1}});

  const auto arrangement = import::arrange(lines);

  ASSERT_TRUE(arrangement);
  for (const Vec2 p : arrangement->vertex) EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y));
  EXPECT_NEAR(import::trace_faces(*arrangement).face.at(0).area, 4, 1e-9);
}

/// Euler: faces of a plane drawing are edges - vertices + parts, the outside not counted.
RC_GTEST_PROP(Arrangement, KeepsEulersFormula, ()) {
  const auto count = *rc::gen::inRange<std::size_t>(1, 40);
  std::vector<WallLine> lines;
  for (std::size_t i = 0; i < count; ++i) {
    const auto coordinate = [] { return *rc::gen::inRange(0, 2000) / 100.0; };
    const Vec2 a{coordinate(), coordinate()}, b{coordinate(), coordinate()};
    if (a != b) lines.push_back({a, b});
  }
  const auto arrangement = import::arrange(lines);
  RC_ASSERT(arrangement.has_value());

  std::vector<std::uint32_t> part(arrangement->vertex.size());
  std::vector<bool> used(part.size(), false);
  for (std::uint32_t v = 0; v < part.size(); ++v) part[v] = v;
  const auto root = [&](std::uint32_t v) {
    while (part[v] != v) v = part[v];
    return v;
  };
  for (const auto& edge : arrangement->edge) {
    part[root(edge.from)] = root(edge.to);
    used[edge.from] = used[edge.to] = true;
  }
  long vertices = 0, parts = 0;
  for (std::uint32_t v = 0; v < part.size(); ++v) {
    vertices += used[v];
    parts += used[v] && root(v) == v;
  }
  RC_ASSERT(static_cast<long>(import::trace_faces(*arrangement).face.size()) ==
            static_cast<long>(arrangement->edge.size()) - vertices + parts);
}

TEST(InscribedCircle, IsHalfAsWideAsACorridor) {
  const std::vector<std::vector<Vec2>> corridor{{{0, 0}, {30, 0}, {30, 2}, {0, 2}}};

  EXPECT_NEAR(import::inscribed_circle(corridor).radius, 1, 0.03);
}

}  // namespace
}  // namespace docent::test::arrangement_test
