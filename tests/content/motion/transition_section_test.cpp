#include "content/motion/transition_section.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "content/motion/compile_motion.h"
#include "content/motion/paper_search.h"
#include "tests/content/motion/random_graph.h"
#include "tests/content/motion/shipped_clips.h"
#include "tests/support/reference_data.h"

namespace docent::test::transition_section_test {
namespace {

bool stops(const MotionGraph& graph, std::uint32_t clip) {
  return graph.clips[clip].role == ClipRole::Stop;
}

std::vector<motion::offline::PassedTransition> passable_from(
    const MotionGraph& graph, const motion::offline::TransitionSections& sections, ClipFrame at) {
  std::vector<motion::offline::PassedTransition> passages;
  for (std::uint32_t t = 0; t < graph.transitions.size(); ++t)
    if (graph.transitions[t].from.clip == at.clip)
      if (const auto radius = motion::offline::section_radius(graph, sections, t, at.frame))
        passages.push_back({t, *radius});
  return passages;
}

/// Which transitions can be passed by walks that never end but in a stop, found the slow and
/// obvious way: strike out what leads nowhere until nothing changes.
std::vector<bool> passable(const MotionGraph& graph,
                           const motion::offline::TransitionSections& sections) {
  std::vector<bool> alive(graph.transitions.size());
  for (std::size_t t = 0; t < alive.size(); ++t) alive[t] = graph.transitions[t].radius > 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t t = 0; t < alive.size(); ++t) {
      const ClipFrame to = graph.transitions[t].to;
      bool continues = stops(graph, to.clip);
      for (std::size_t n = 0; n < alive.size() && !continues; ++n) {
        const ClipFrame from = graph.transitions[n].from;
        continues = alive[n] && from.clip == to.clip &&
                    to.frame + sections.shortest[t] + sections.shortest[n] <= from.frame;
      }
      changed = changed || (alive[t] && !continues);
      alive[t] = alive[t] && continues;
    }
  }
  return alive;
}

RC_GTEST_PROP(TransitionSection, NeverRunsBackwardsAndNeverLosesItsExits, ()) {
  const MotionGraph graph = *random_graph();
  const motion::offline::TransitionSections sections = motion::offline::measure_sections(graph);
  ClipFrame at{*rc::gen::inRange<std::uint32_t>(0, static_cast<std::uint32_t>(graph.clips.size())),
               0};
  RC_PRE(sections.last_exit[at.clip].has_value());

  for (int step = 0; step < 40; ++step) {
    const std::vector<motion::offline::PassedTransition> passages =
        passable_from(graph, sections, at);
    if (stops(graph, at.clip) && passages.empty()) return;
    RC_ASSERT(!passages.empty());
    const motion::offline::PassedTransition passage = *rc::gen::elementOf(passages);
    const Transition& way = graph.transitions[passage.transition];
    RC_ASSERT(way.from.frame >= at.frame + passage.radius);
    RC_ASSERT(way.to.frame >= passage.radius);
    RC_ASSERT(way.to.frame + passage.radius < frame_count(graph.clips[way.to.clip]));
    at = {way.to.clip, way.to.frame + passage.radius};
  }
}

RC_GTEST_PROP(TransitionSection, IsShortenedOnlyWhereItMustAndNeverBelowHalf, ()) {
  const MotionGraph graph = *random_graph();
  const motion::offline::TransitionSections sections = motion::offline::measure_sections(graph);
  std::uint32_t half = 0;
  for (const Transition& t : graph.transitions) half = std::max(half, (t.radius + 1) / 2);

  for (std::uint32_t t = 0; t < graph.transitions.size(); ++t) {
    const Transition& way = graph.transitions[t];
    const auto at = *rc::gen::inRange<std::uint32_t>(0, way.from.frame + 1);
    const auto radius = motion::offline::section_radius(graph, sections, t, at);
    if (!radius) continue;
    RC_ASSERT(*radius >= std::min(half, way.radius));
    RC_ASSERT(*radius <= way.radius);
    if (*radius == way.radius) continue;
    const bool would_run_backwards = at + *radius + 1 > way.from.frame;
    const auto exit = sections.last_exit[way.to.clip];
    const bool would_miss_exit =
        !stops(graph, way.to.clip) && exit && way.to.frame + *radius + 1 > *exit;
    RC_ASSERT(would_run_backwards || would_miss_exit);
  }
}

RC_GTEST_PROP(TransitionSection, IsBarredExactlyWhereNoWalkGoesOn, ()) {
  const MotionGraph graph = *random_graph();
  const motion::offline::TransitionSections sections = motion::offline::measure_sections(graph);

  const std::vector<bool> expected = passable(graph, sections);

  for (std::size_t t = 0; t < expected.size(); ++t)
    RC_ASSERT((sections.longest[t] > 0) == expected[t]);
}

/// The compiler has done this work: its transitions can be passed with the radius that they say.
void expect_full_radii(const MotionGraph& graph) {
  const motion::offline::TransitionSections sections = motion::offline::measure_sections(graph);
  for (std::size_t t = 0; t < graph.transitions.size(); ++t)
    EXPECT_EQ(sections.longest[t], graph.transitions[t].radius) << "transition " << t;
}

TEST(TransitionSection, OfACompiledGraphKeepsItsRadius) {
  expect_full_radii(shipped_graph());
}

TEST(TransitionSection, OfTheRecordedClipsKeepsItsRadius) {
  NEEDS_REFERENCE_DATA("mocap/cmu-walk");
  std::vector<Diagnostic> problems;
  expect_full_radii(
      motion::offline::compile_motion(reference_data() / "mocap/cmu-walk", {}, problems));
}

}  // namespace
}  // namespace docent::test::transition_section_test
