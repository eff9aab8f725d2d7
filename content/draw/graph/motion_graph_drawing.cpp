#include "content/draw/graph/motion_graph_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "content/draw/svg.h"

namespace docent::draw {
namespace {

constexpr double width = 1800, margin = 72, label_width = 300;
constexpr double top = 190, row_height = 132, foot_note = 130;
constexpr std::string_view sans = R"(font-family="Inter, Noto Sans, sans-serif")";
constexpr std::string_view serif = R"(font-family="Noto Serif, serif")";

std::string type(std::string_view family, int size, std::string_view colour,
                 std::string_view more = "") {
  return fmt::format(R"({} font-size="{}" fill="{}" {})", family, size, colour, more);
}

double seconds_of(const MotionClip& clip) {
  return frame_count(clip) / clip.frame_rate;
}

/// Teal for what is nearly one motion, ochre between, vermilion for the dearest transition.
std::string colour_use_of(double part) {
  return part < 0.5 ? mixed(ink::teal, ink::ochre, 2 * part)
                    : mixed(ink::ochre, ink::vermilion, 2 * part - 1);
}

const char* title_of(ClipRole role) {
  switch (role) {
    case ClipRole::Walk:
      return "walk";
    case ClipRole::Start:
      return "start";
    case ClipRole::Stop:
      return "stop";
    case ClipRole::TurnLeft:
      return "turn left";
    case ClipRole::TurnRight:
      return "turn right";
    case ClipRole::Other:
      break;
  }
  return "other";
}

class GraphDrawing {
 public:
  explicit GraphDrawing(const MotionGraph& graph)
      : graph_(graph),
        height_(top + row_height * static_cast<double>(graph.clips.size()) + foot_note),
        svg_(width, height_) {
    double longest = 1;
    for (const MotionClip& clip : graph.clips) longest = std::max(longest, seconds_of(clip));
    pixels_a_second_ = (width - 2 * margin - label_width) / longest;
    if (graph.transitions.empty()) return;
    const auto [least, most] =
        std::ranges::minmax(graph.transitions, {}, [](const Transition& t) { return t.distance; });
    cheapest_ = least.distance;
    dearest_ = most.distance;
  }

  std::string draw() {
    svg_.rectangle({0, 0}, {width, height_}, fmt::format(R"(fill="{}")", ink::paper));
    draw_title();
    draw_seconds();
    draw_transitions();
    for (std::size_t c = 0; c < graph_.clips.size(); ++c) draw_clip(c);
    draw_key();
    return svg_.document();
  }

 private:
  Vec2 at(std::size_t clip, double frame) const {
    return {margin + label_width + frame / graph_.clips[clip].frame_rate * pixels_a_second_,
            top + row_height * (static_cast<double>(clip) + 0.5)};
  }
  Vec2 at(ClipFrame place) const { return at(place.clip, place.frame); }

  void draw_title() {
    double seconds = 0;
    for (const MotionClip& clip : graph_.clips) seconds += seconds_of(clip);
    svg_.text({margin, 92}, "Motion graph", type(serif, 44, ink::black));
    svg_.text({margin, 132},
              fmt::format("{} clips, {:.1f} seconds of motion, {} transitions", graph_.clips.size(),
                          seconds, graph_.transitions.size()),
              type(sans, 20, ink::quiet));
  }

  void draw_seconds() {
    const double bottom = top + row_height * static_cast<double>(graph_.clips.size());
    const double right = width - margin;
    for (int s = 0; margin + label_width + s * pixels_a_second_ <= right; ++s) {
      const double x = margin + label_width + s * pixels_a_second_;
      svg_.path(PathData().move_to({x, top - 8}).line_to({x, bottom}),
                fmt::format(R"(stroke="{}" stroke-width="1.5")", ink::plaster));
      svg_.text({x, top - 18}, s == 0 ? "0 s" : fmt::format("{}", s),
                type(sans, 15, ink::quiet, R"(text-anchor="middle")"));
    }
  }

  void draw_clip(std::size_t c) {
    const MotionClip& clip = graph_.clips[c];
    const Vec2 begin = at(c, 0), end = at(c, frame_count(clip) - 1.0);
    draw_plants(c, &FootPlants::left, -9);
    draw_plants(c, &FootPlants::right, 5);
    svg_.path(PathData().move_to(begin).line_to(end),
              fmt::format(R"(stroke="{}" stroke-width="3" stroke-linecap="round")", ink::cut_face));
    const std::string motion_class = graph_.classes.size() > 1 ? ", " + clip.motion_class : "";
    svg_.text({margin, begin.y - 4}, title_of(clip.role) + motion_class,
              type(sans, 20, ink::black));
    svg_.text({margin, begin.y + 20}, shortened(clip.name), type(sans, 15, ink::quiet));
  }

  static std::string shortened(const std::string& name) {
    constexpr std::size_t longest = 30;
    return name.size() > longest ? name.substr(0, longest - 1) + "\u2026" : name;
  }

  /// A bar beside the clip's line while the foot is down.
  void draw_plants(std::size_t c, bool FootPlants::* foot, double below) {
    const MotionClip& clip = graph_.clips[c];
    for (std::size_t f = 0; f < clip.plants.size();) {
      std::size_t last = f;
      while (last < clip.plants.size() && clip.plants[last].*foot == clip.plants[f].*foot) ++last;
      if (clip.plants[f].*foot) {
        const Vec2 from = at(c, static_cast<double>(f)), to = at(c, static_cast<double>(last));
        svg_.rectangle({from.x, from.y + below}, {to.x - from.x, 4},
                       fmt::format(R"(fill="{}")", ink::stone));
      }
      f = last;
    }
  }

  /// The dearest lie below, so that the best passages are seen.
  void draw_transitions() {
    std::vector<const Transition*> dearest_first;
    dearest_first.reserve(graph_.transitions.size());
    for (const Transition& t : graph_.transitions) dearest_first.push_back(&t);
    std::ranges::sort(dearest_first, [](const Transition* a, const Transition* b) {
      return std::pair(-a->distance, a) < std::pair(-b->distance, b);
    });
    for (const Transition* t : dearest_first) draw_transition(*t);
  }

  void draw_transition(const Transition& t) {
    const Vec2 from = at(t.from), to = at(t.to);
    const std::string colour = colour_use_of(part_of(t.distance));
    svg_.path(
        arc(from, to, t.from.clip == t.to.clip),
        fmt::format(R"(fill="none" stroke="{}" stroke-width="1.3" stroke-opacity="0.5")", colour));
    svg_.circle(to, 3, fmt::format(R"(fill="{}")", colour));
  }

  /// Within a clip: forward over the line, back below it.
  static PathData arc(Vec2 from, Vec2 to, bool same_clip) {
    const Vec2 way = to - from;
    Vec2 bow = 0.14 * Vec2{-way.y, way.x};  // to the right where y is down
    if (same_clip)
      bow = {0, (way.x > 0 ? -1 : 1) * std::min(0.85 * row_height, 24 + 0.12 * std::abs(way.x))};
    return PathData().move_to(from).curve_to(0.5 * (from + to) + bow, to);
  }

  double part_of(double distance) const {
    return dearest_ > cheapest_ ? (distance - cheapest_) / (dearest_ - cheapest_) : 0;
  }

  void draw_key() {
    const double y = height_ - 62, left = margin + label_width, length = 320;
    constexpr int steps = 64;
    for (int i = 0; i < steps; ++i)
      svg_.rectangle({left + length * i / steps, y - 12}, {length / steps + 0.5, 12},
                     fmt::format(R"(fill="{}")", colour_use_of((i + 0.5) / steps)));
    svg_.text({left, y + 24}, fmt::format("{:.1f} cm", 100 * cheapest_),
              type(sans, 15, ink::quiet));
    svg_.text({left + length, y + 24}, fmt::format("{:.1f} cm", 100 * dearest_),
              type(sans, 15, ink::quiet, R"(text-anchor="end")"));
    svg_.text({left + length + 32, y},
              "how far the poses of a transition are apart; its dot is where it arrives",
              type(sans, 15, ink::quiet));
    svg_.rectangle({left + length + 32, y + 15}, {40, 4}, fmt::format(R"(fill="{}")", ink::stone));
    svg_.text({left + length + 84, y + 24},
              "a foot on the ground: left above the line, right below", type(sans, 15, ink::quiet));
  }

  const MotionGraph& graph_;
  double height_;
  Svg svg_;
  double pixels_a_second_ = 1;
  double cheapest_ = 0, dearest_ = 0;
};

}  // namespace

std::string draw_motion_graph(const MotionGraph& graph) {
  return GraphDrawing(graph).draw();
}

}  // namespace docent::draw
