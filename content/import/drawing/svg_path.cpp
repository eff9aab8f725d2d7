#include "content/import/drawing/svg_path.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>

namespace docent::import {
namespace {

constexpr std::size_t most_points = 100'000;
constexpr int steps_of_curve = 12;

class PathReader {
 public:
  explicit PathReader(std::string_view data) : rest_(data) {}

  std::vector<SubPath> read() {
    char command = 0;
    while (points_ < most_points) {
      skip();
      if (rest_.empty()) break;
      if (std::isalpha(static_cast<unsigned char>(rest_.front()))) {
        command = rest_.front();
        rest_.remove_prefix(1);
      } else if (command == 'Z' || command == 'z') {
        break;  // Numbers after a closing belong to nothing.
      }
      if (!run(command)) break;
      if (command == 'M') command = 'L';
      if (command == 'm') command = 'l';
    }
    std::erase_if(paths_, [](const SubPath& path) { return path.points.size() < 2; });
    return std::move(paths_);
  }

  std::optional<double> number() {
    skip();
    if (rest_.starts_with('+')) rest_.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    if (error != std::errc{} || !std::isfinite(value)) return std::nullopt;
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return value;
  }

 private:
  void skip() {
    while (!rest_.empty() &&
           (std::isspace(static_cast<unsigned char>(rest_.front())) || rest_.front() == ','))
      rest_.remove_prefix(1);
  }

  /// The flags of arcs need no blank behind them.
  std::optional<bool> flag() {
    skip();
    if (!rest_.starts_with('0') && !rest_.starts_with('1')) return std::nullopt;
    const bool set = rest_.front() == '1';
    rest_.remove_prefix(1);
    return set;
  }

  std::optional<Vec2> place(bool relative) {
    const auto x = number(), y = x ? number() : std::nullopt;
    if (!y) return std::nullopt;
    return Vec2{*x, *y} + (relative ? at_ : Vec2{});
  }

  void go_to(Vec2 p) {
    if (paths_.empty() || paths_.back().closed) paths_.push_back({{at_}, false});
    paths_.back().points.push_back(p);
    at_ = p;
    ++points_;
  }

  /// One command with its numbers; false where they are not there.
  bool run(char command) {
    const bool relative = std::islower(static_cast<unsigned char>(command));
    const Vec2 base = relative ? at_ : Vec2{};
    const char kind = static_cast<char>(std::toupper(static_cast<unsigned char>(command)));
    if (kind != 'C' && kind != 'S') last_cubic_ = at_;
    if (kind != 'Q' && kind != 'T') last_quadratic_ = at_;
    switch (kind) {
      case 'M': {
        const auto p = place(relative);
        if (!p) return false;
        at_ = *p;
        paths_.push_back({{at_}, false});
        return true;
      }
      case 'Z':
        if (!paths_.empty()) {
          paths_.back().closed = true;
          at_ = paths_.back().points.front();
        }
        return true;
      case 'L': {
        const auto p = place(relative);
        if (p) go_to(*p);
        return p.has_value();
      }
      case 'H': {
        const auto x = number();
        if (x) go_to({*x + base.x, at_.y});
        return x.has_value();
      }
      case 'V': {
        const auto y = number();
        if (y) go_to({at_.x, *y + base.y});
        return y.has_value();
      }
      case 'C':
      case 'S':
        return cubic(kind == 'S', relative);
      case 'Q':
      case 'T':
        return quadratic(kind == 'T', relative);
      case 'A':
        return arc(relative);
      default:
        return false;
    }
  }

  bool cubic(bool smooth, bool relative) {
    const auto first = smooth ? std::optional(2.0 * at_ - last_cubic_) : place(relative);
    const auto second = first ? place(relative) : std::nullopt;
    const auto end = second ? place(relative) : std::nullopt;
    if (!end) return false;
    const Vec2 begin = at_;
    for (int i = 1; i <= steps_of_curve; ++i) {
      const double t = static_cast<double>(i) / steps_of_curve, s = 1 - t;
      go_to(s * s * s * begin + 3 * s * s * t * *first + 3 * s * t * t * *second +
            t * t * t * *end);
    }
    last_cubic_ = *second;
    return true;
  }

  bool quadratic(bool smooth, bool relative) {
    const auto middle = smooth ? std::optional(2.0 * at_ - last_quadratic_) : place(relative);
    const auto end = middle ? place(relative) : std::nullopt;
    if (!end) return false;
    const Vec2 begin = at_;
    for (int i = 1; i <= steps_of_curve; ++i) {
      const double t = static_cast<double>(i) / steps_of_curve, s = 1 - t;
      go_to(s * s * begin + 2 * s * t * *middle + t * t * *end);
    }
    last_quadratic_ = *middle;
    return true;
  }

  /// From end points to the centre: SVG 2, appendix B.2.4.
  bool arc(bool relative) {
    const auto rx0 = number(), ry0 = rx0 ? number() : std::nullopt;
    const auto degrees = ry0 ? number() : std::nullopt;
    const auto large = degrees ? flag() : std::nullopt;
    const auto positive = large ? flag() : std::nullopt;
    const auto end = positive ? place(relative) : std::nullopt;
    if (!end) return false;
    double rx = std::abs(*rx0), ry = std::abs(*ry0);
    if (rx < 1e-12 || ry < 1e-12 || *end == at_) {
      go_to(*end);
      return true;
    }
    const double turn = *degrees * std::numbers::pi / 180;
    const Vec2 along{std::cos(turn), std::sin(turn)};
    const Vec2 half = 0.5 * (at_ - *end);
    const Vec2 p{dot(half, along), dot(half, left_of(along))};
    const double stretch = p.x * p.x / (rx * rx) + p.y * p.y / (ry * ry);
    if (stretch > 1) {
      rx *= std::sqrt(stretch);
      ry *= std::sqrt(stretch);
    }
    const double down = rx * rx * p.y * p.y + ry * ry * p.x * p.x;
    const double up = std::max(0.0, rx * rx * ry * ry - down);
    const double factor = (*large == *positive ? -1 : 1) * std::sqrt(up / down);
    const Vec2 c{factor * rx * p.y / ry, -factor * ry * p.x / rx};
    const Vec2 centre = c.x * along + c.y * left_of(along) + 0.5 * (at_ + *end);
    const double from = std::atan2((p.y - c.y) / ry, (p.x - c.x) / rx);
    double sweep = std::atan2((-p.y - c.y) / ry, (-p.x - c.x) / rx) - from;
    if (*positive && sweep < 0) sweep += 2 * std::numbers::pi;
    if (!*positive && sweep > 0) sweep -= 2 * std::numbers::pi;
    const int steps = std::clamp(static_cast<int>(std::abs(sweep) * 10), 2, 60);
    for (int i = 1; i < steps; ++i) {
      const double angle = from + sweep * i / steps;
      go_to(centre + rx * std::cos(angle) * along + ry * std::sin(angle) * left_of(along));
    }
    go_to(*end);
    return true;
  }

  std::string_view rest_;
  std::vector<SubPath> paths_;
  std::size_t points_ = 0;
  Vec2 at_{}, last_cubic_{}, last_quadratic_{};
};

}  // namespace

std::vector<SubPath> parse_path(std::string_view data) {
  return PathReader(data).read();
}

std::vector<double> parse_numbers(std::string_view text) {
  PathReader reader(text);
  std::vector<double> numbers;
  while (const auto number = reader.number()) {
    numbers.push_back(*number);
    if (numbers.size() >= 2 * most_points) break;
  }
  return numbers;
}

}  // namespace docent::import
