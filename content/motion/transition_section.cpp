#include "content/motion/transition_section.h"

#include <algorithm>

namespace docent::motion::offline {
namespace {

using Frame = std::uint32_t;

/// The radius with which a section ends in front of its destination's last exit; 0 for none.
Frame radius_before_exit(const MotionGraph& graph, const TransitionSections& sections,
                         std::size_t t) {
  const Transition& way = graph.transitions[t];
  if (graph.clips[way.to.clip].role == ClipRole::Stop) return way.radius;
  const std::optional<Frame> exit = sections.last_exit[way.to.clip];
  if (!exit || way.to.frame + sections.shortest[t] > *exit) return 0;
  return std::min(way.radius, *exit - way.to.frame);
}

void find_last_exits(const MotionGraph& graph, TransitionSections& sections) {
  sections.last_exit.assign(graph.clips.size(), std::nullopt);
  for (std::size_t t = 0; t < graph.transitions.size(); ++t) {
    if (sections.longest[t] == 0) continue;
    const ClipFrame from = graph.transitions[t].from;
    std::optional<Frame>& last = sections.last_exit[from.clip];
    last = std::max(last, std::optional(from.frame - sections.shortest[t]));
  }
}

}  // namespace

TransitionSections measure_sections(const MotionGraph& graph) {
  Frame longest = 0;
  for (const Transition& t : graph.transitions) longest = std::max(longest, t.radius);
  TransitionSections sections;
  for (const Transition& t : graph.transitions) {
    sections.longest.push_back(t.radius);
    sections.shortest.push_back(std::clamp<Frame>((longest + 1) / 2, 1, std::max(t.radius, 1U)));
  }
  find_last_exits(graph, sections);
  // A transition that turns out to be no exit takes its clip's last exit forward, which may shorten
  // or bar those that lead there.
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t t = 0; t < graph.transitions.size(); ++t) {
      const Frame radius = radius_before_exit(graph, sections, t);
      changed = changed || radius != sections.longest[t];
      sections.longest[t] = radius;
    }
    find_last_exits(graph, sections);
  }
  return sections;
}

std::optional<std::uint32_t> section_radius(const MotionGraph& graph,
                                            const TransitionSections& sections, std::uint32_t t,
                                            std::uint32_t at) noexcept {
  const std::uint32_t middle = graph.transitions[t].from.frame;
  if (sections.longest[t] == 0 || at + sections.shortest[t] > middle) return std::nullopt;
  return std::min(sections.longest[t], middle - at);
}

}  // namespace docent::motion::offline
