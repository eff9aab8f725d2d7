#include "tests/bench/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "content/draw/svg.h"
#include "tests/bench/measure.h"

namespace docent::bench {
namespace {

constexpr double panel_width = 560, panel_height = 430;
constexpr double margin_left = 78, margin_right = 132, margin_top = 118, margin_bottom = 64;
constexpr double label_height = 15;
constexpr std::string_view font = "font-family=\"Inter, Helvetica, Arial, sans-serif\"";

/// 0.5, 20, 3k, 2M: short enough for a tick.
std::string short_number(double value) {
  if (value >= 1e6) return fmt::format("{:g}M", value / 1e6);
  if (value >= 1e3) return fmt::format("{:g}k", value / 1e3);
  return fmt::format("{:g}", value);
}

/// A logarithmic axis: values to pixels, and where its ticks are.
class LogAxis {
 public:
  LogAxis(double low, double high, double from, double to) : from_(from), to_(to) {
    const double room = 0.06 * std::max(std::log10(high / low), 0.3);
    low_ = std::log10(low) - room;
    high_ = std::log10(high) + room;
  }

  [[nodiscard]] double pixel(double value) const {
    return from_ + (std::log10(value) - low_) / (high_ - low_) * (to_ - from_);
  }

  /// 1, 2 and 5 of every decade; the powers of ten alone where there are many decades.
  [[nodiscard]] std::vector<double> ticks() const {
    std::vector<double> result;
    for (int decade = static_cast<int>(std::floor(low_)); decade <= high_; ++decade)
      for (const double digit : {1.0, 2.0, 5.0}) {
        const double value = digit * std::pow(10.0, decade), place = std::log10(value);
        const bool is_shown = digit == 1 || high_ - low_ < 3.2;
        if (is_shown && place >= low_ && place <= high_) result.push_back(value);
      }
    return result;
  }

 private:
  double from_, to_;           // Pixels.
  double low_ = 0, high_ = 1;  // Decades.
};

struct Frame {
  LogAxis x, y;
  double left, right, top, bottom;
};

Frame frame_of(const Panel& panel, double left) {
  Vec2 low{1e300}, high{0};
  for (const Series& series : panel.series)
    for (const auto* points : {&series.dots, &series.line})
      for (const Vec2 p : *points) low = glm::min(low, p), high = glm::max(high, p);
  if (low.x > high.x) low = high = {1, 1};
  const double right = left + panel_width, bottom = margin_top + panel_height;
  return {LogAxis(low.x, high.x, left, right),
          LogAxis(low.y, high.y, bottom, margin_top),
          left,
          right,
          margin_top,
          bottom};
}

std::string text_style(double size, std::string_view colour, std::string_view anchor,
                       std::string_view weight = "400") {
  return fmt::format("font-size=\"{}\" fill=\"{}\" text-anchor=\"{}\" font-weight=\"{}\"", size,
                     colour, anchor, weight);
}

std::string turned(Vec2 about) {
  return fmt::format(" transform=\"rotate(-90 {:.1f} {:.1f})\"", about.x, about.y);
}

void draw_axes(draw::Svg& svg, const Panel& panel, const Frame& frame) {
  svg.rectangle({frame.left, frame.top}, {panel_width, panel_height},
                fmt::format("fill=\"{}\"", draw::ink::floor));
  const std::string grid = fmt::format("stroke=\"{}\" stroke-width=\"1\"", draw::ink::plaster);
  for (const double x : frame.x.ticks()) {
    const double at = frame.x.pixel(x);
    svg.path(draw::PathData().move_to({at, frame.top}).line_to({at, frame.bottom}), grid);
    svg.text({at, frame.bottom + 18}, short_number(x), text_style(12, draw::ink::quiet, "middle"));
  }
  for (const double y : frame.y.ticks()) {
    const double at = frame.y.pixel(y);
    svg.path(draw::PathData().move_to({frame.left, at}).line_to({frame.right, at}), grid);
    svg.text({frame.left - 8, at + 4}, short_number(y), text_style(12, draw::ink::quiet, "end"));
  }
  svg.path(draw::PathData()
               .move_to({frame.left, frame.top})
               .line_to({frame.left, frame.bottom})
               .line_to({frame.right, frame.bottom}),
           fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"1.2\"", draw::ink::quiet));
  svg.text({frame.left, frame.top - 14}, panel.title,
           text_style(15, draw::ink::black, "start", "600"));
  svg.text({(frame.left + frame.right) / 2, frame.bottom + 44}, panel.x_title,
           text_style(13, draw::ink::quiet, "middle"));
  const Vec2 y_title{frame.left - 54, (frame.top + frame.bottom) / 2};
  svg.text(y_title, panel.y_title, text_style(13, draw::ink::quiet, "middle") + turned(y_title));
}

void draw_mark(draw::Svg& svg, Vec2 at, const Series& series) {
  const std::string filled = fmt::format("fill=\"{}\"", series.colour);
  switch (series.mark) {
    case Series::Mark::Disc:
      return svg.circle(at, 4, filled);
    case Series::Mark::Ring:
      return svg.circle(at, 3.6,
                        fmt::format("fill=\"{}\" stroke=\"{}\" stroke-width=\"1.8\"",
                                    draw::ink::floor, series.colour));
    case Series::Mark::Square:
      return svg.rectangle(at - 3.5, {7, 7}, filled);
    case Series::Mark::Diamond:
      return svg.path(draw::PathData()
                          .move_to(at - Vec2{5, 0})
                          .line_to(at - Vec2{0, 5})
                          .line_to(at + Vec2{5, 0})
                          .line_to(at + Vec2{0, 5})
                          .close(),
                      filled);
  }
}

void draw_series(draw::Svg& svg, const Frame& frame, const Series& series) {
  const auto pixel = [&](Vec2 p) { return Vec2{frame.x.pixel(p.x), frame.y.pixel(p.y)}; };
  for (const Vec2 p : series.dots)
    svg.circle(pixel(p), 2.2, fmt::format("fill=\"{}\" fill-opacity=\"0.35\"", series.colour));
  if (series.line.empty()) return;
  draw::PathData line;
  line.move_to(pixel(series.line.front()));
  for (const Vec2 p : series.line) line.line_to(pixel(p));
  svg.path(line, fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" "
                             "stroke-linejoin=\"round\"{}",
                             series.colour, series.is_dashed ? 1.3 : 2.2,
                             series.is_dashed ? " stroke-dasharray=\"5 4\"" : ""));
  if (!series.is_dashed)
    for (const Vec2 p : series.line) draw_mark(svg, pixel(p), series);
}

/// Labels at the ends of the lines, moved apart where they would cover each other.
void draw_labels(draw::Svg& svg, const Panel& panel, const Frame& frame) {
  struct Label {
    const Series* series;
    Vec2 at;
  };
  std::vector<Label> labels;
  for (const Series& series : panel.series)
    if (!series.line.empty())
      labels.push_back(
          {&series,
           {frame.x.pixel(series.line.back().x) + 10, frame.y.pixel(series.line.back().y) + 4}});
  std::ranges::stable_sort(labels, {}, [](const Label& label) { return label.at.y; });
  for (std::size_t i = 1; i < labels.size(); ++i)
    labels[i].at.y = std::max(labels[i].at.y, labels[i - 1].at.y + label_height);
  for (const Label& label : labels)
    svg.text(label.at, label.series->label.empty() ? label.series->name : label.series->label,
             text_style(12.5, label.series->colour, "start", "600"));
}

void draw_legend(draw::Svg& svg, const std::vector<Panel>& panels) {
  std::vector<std::string> seen;
  double x = margin_left;
  for (const Panel& panel : panels)
    for (const Series& series : panel.series) {
      if (series.is_dashed || std::ranges::find(seen, series.name) != seen.end()) continue;
      seen.push_back(series.name);
      svg.path(draw::PathData().move_to({x, 72}).line_to({x + 26, 72}),
               fmt::format("stroke=\"{}\" stroke-width=\"2.2\"", series.colour));
      draw_mark(svg, {x + 13, 72}, series);
      svg.text({x + 34, 76}, series.name, text_style(13, draw::ink::black, "start"));
      x += 60 + 7.4 * static_cast<double>(series.name.size());
    }
}

}  // namespace

std::string draw_panels(const std::string& heading, const std::string& note,
                        const std::vector<Panel>& panels) {
  const double step = margin_left + panel_width + margin_right;
  const Vec2 size{step * static_cast<double>(panels.size()),
                  margin_top + panel_height + margin_bottom};
  draw::Svg svg(size.x, size.y);
  svg.rectangle({0, 0}, size, fmt::format("fill=\"{}\"", draw::ink::paper));
  svg.begin_group(font);
  svg.text({margin_left, 32}, heading, text_style(19, draw::ink::black, "start", "700"));
  svg.text({margin_left, 53}, note, text_style(12.5, draw::ink::quiet, "start"));
  draw_legend(svg, panels);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const Frame frame = frame_of(panels[i], margin_left + step * static_cast<double>(i));
    draw_axes(svg, panels[i], frame);
    for (const Series& series : panels[i].series) draw_series(svg, frame, series);
    draw_labels(svg, panels[i], frame);
  }
  svg.end_group();
  return svg.document();
}

std::vector<Vec2> medians_by_octave(const std::vector<Vec2>& dots, std::size_t least) {
  std::map<int, std::vector<Vec2>> bins;
  for (const Vec2 p : dots) bins[static_cast<int>(std::floor(std::log2(p.x)))].push_back(p);
  std::vector<Vec2> line;
  for (const auto& [octave, points] : bins) {
    if (points.size() < least) continue;
    std::vector<double> x, y;
    for (const Vec2 p : points) x.push_back(p.x), y.push_back(p.y);
    line.emplace_back(median(x), median(y));
  }
  return line;
}

}  // namespace docent::bench
