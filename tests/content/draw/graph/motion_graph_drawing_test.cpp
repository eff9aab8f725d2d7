#include "content/draw/graph/motion_graph_drawing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace docent::test::motion_graph_drawing_test {
namespace {

using testing::HasSubstr;
using testing::Not;

MotionClip clip_of(const std::string& name, ClipRole role, std::uint32_t frames) {
  MotionClip clip;
  clip.name = name;
  clip.role = role;
  clip.root.resize(frames);
  clip.plants.resize(frames, {.left = true, .right = false});
  return clip;
}

MotionGraph two_clips() {
  MotionGraph graph;
  graph.clips = {clip_of("setting out", ClipRole::Start, 240),
                 clip_of("a < b & c", ClipRole::TurnLeft, 120)};
  graph.transitions = {
      {.from = {0, 200}, .to = {1, 30}, .radius = 10, .distance = 0.02f, .alignment = {}},
      {.from = {1, 60}, .to = {0, 100}, .radius = 10, .distance = 0.05f, .alignment = {}},
      {.from = {1, 90}, .to = {1, 20}, .radius = 10, .distance = 0.03f, .alignment = {}}};
  return graph;
}

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t times = 0;
  for (auto at = text.find(word); at != text.npos; at = text.find(word, at + 1)) ++times;
  return times;
}

TEST(MotionGraphDrawing, HasALineForEachClipAndADotForEachTransition) {
  const std::string svg = draw::draw_motion_graph(two_clips());

  EXPECT_THAT(svg, HasSubstr("setting out"));
  EXPECT_THAT(svg, HasSubstr("turn left"));
  EXPECT_THAT(svg, HasSubstr("2 clips, 3.0 seconds of motion, 3 transitions"));
  EXPECT_EQ(count(svg, "<circle"), 3U);
}

TEST(MotionGraphDrawing, NamesTheClassesWhereThereAreSeveral) {
  MotionGraph graph = two_clips();
  EXPECT_THAT(draw::draw_motion_graph(graph), Not(HasSubstr("turn left,")));
  graph.clips[0].motion_class = "walk";
  graph.clips[1].motion_class = "jog";
  graph.classes = {{.name = "walk", .coefficient = {0, 2}}, {.name = "jog", .coefficient = {2, 0}}};

  EXPECT_THAT(draw::draw_motion_graph(graph), HasSubstr("turn left, jog"));
}

TEST(MotionGraphDrawing, SaysWhatItsColoursMean) {
  const std::string svg = draw::draw_motion_graph(two_clips());

  EXPECT_THAT(svg, HasSubstr("2.0 cm"));
  EXPECT_THAT(svg, HasSubstr("5.0 cm"));
  EXPECT_THAT(svg, HasSubstr("#1D7874"));  // the cheapest is teal
  EXPECT_THAT(svg, HasSubstr("#D2452D"));  // the dearest vermilion
}

TEST(MotionGraphDrawing, WritesNamesAsWords) {
  const std::string svg = draw::draw_motion_graph(two_clips());

  EXPECT_THAT(svg, HasSubstr("a &lt; b &amp; c"));
  EXPECT_THAT(svg, Not(HasSubstr("a < b")));
}

TEST(MotionGraphDrawing, OfOneClipWithoutTransitionsIsStillAPicture) {
  MotionGraph graph = two_clips();
  graph.transitions.clear();

  EXPECT_EQ(count(draw::draw_motion_graph(graph), "</svg>"), 1U);
}

}  // namespace
}  // namespace docent::test::motion_graph_drawing_test
