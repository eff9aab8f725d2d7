#include "tests/runtime/guide/situation.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <limits>

#include "platform/sqlite/content_reader.h"
#include "runtime/guide/crowd.h"
#include "runtime/path/floor_map.h"
#include "tests/runtime/path/floors.h"
#include "tests/support/sample_database.h"

namespace docent::test {
namespace {

constexpr double frame_seconds = 1.0 / 60;

/// A museum that is nothing but a floor and the shipped motion.
Museum museum_of(const FloorPlan& plan) {
  static const Museum sample = sqlite::load_museum(sample_database()).value();
  Museum museum;
  museum.motion = sample.motion;
  museum.avatar = sample.avatar;
  museum.body_radius = 0.25;
  museum.floors.push_back(
      floor_of(plan, {museum.body_radius + Museum::walking_room, museum.body_radius}));
  return museum;
}

class Stage {
 public:
  Stage(const Museum& museum, const Situation& situation)
      : planner_(museum, {}, situation.parts.size()),
        crowd_(museum, planner_),
        situation_(situation),
        next_(situation.parts.size(), 0) {
    scene_.radius = museum.body_radius;
    scene_.track.resize(situation.parts.size());
    scene_.arrival.assign(situation.parts.size(), std::numeric_limits<double>::infinity());
    for (const Part& part : situation.parts)
      crowd_.add(0, part.from, part.stays ? 1e9 : part.rank, part.pace);
  }

  Scene run() {
    step();
    step();
    for (std::uint32_t i = 0; i < situation_.parts.size(); ++i)
      if (!situation_.parts[i].stays)
        crowd_.send(i, 0, situation_.parts[i].to, situation_.parts[i].kind);
    const auto frames = static_cast<std::size_t>(situation_.seconds / frame_seconds);
    for (std::size_t f = 0; f < frames && !scene_.all_arrived(); ++f) {
      step();
      watch(static_cast<double>(f + 1) * frame_seconds);
    }
    return std::move(scene_);
  }

 private:
  void step() {
    planner_.wait();
    const auto began = std::chrono::steady_clock::now();
    crowd_.step(frame_seconds);
    const std::chrono::duration<double, std::milli> taken =
        std::chrono::steady_clock::now() - began;
    scene_.step_ms = std::max(scene_.step_ms, taken.count());
  }

  void watch(double seconds) {
    const path::FloorMap& map = *planner_.maps().front();
    for (std::uint32_t i = 0; i < crowd_.size(); ++i) {
      const Placement body = crowd_[i].avatar.body;
      auto& track = scene_.track[i];
      if (!track.empty())
        scene_.quickest_change =
            std::max(scene_.quickest_change, glm::distance(track.back().position, body.position));
      track.push_back(body);
      scene_.least_clearance =
          std::min(scene_.least_clearance, path::clearance_at(map, body.position));
      for (std::uint32_t j = 0; j < i; ++j)
        scene_.deepest_overlap = std::max(
            scene_.deepest_overlap,
            2 * scene_.radius - glm::distance(crowd_[j].avatar.body.position, body.position));
      const Part& part = situation_.parts[i];
      if (part.stays) {
        scene_.arrival[i] = 0;
      } else if (crowd_[i].has_arrived && crowd_[i].goal) {
        if (next_[i] < part.then.size() && seconds < part.rests) continue;
        if (next_[i] < part.then.size())
          crowd_.send(i, 0, part.then[next_[i]++], part.kind);
        else
          scene_.arrival[i] = std::min(scene_.arrival[i], seconds);
      }
    }
  }

  plan::Planner planner_;
  guide::Crowd crowd_;
  const Situation& situation_;
  std::vector<std::size_t> next_;
  Scene scene_;
};

}  // namespace

bool Scene::all_arrived() const {
  return std::ranges::all_of(arrival, [](double seconds) { return std::isfinite(seconds); });
}

Scene play(const Situation& situation) {
  const Museum museum = museum_of(situation.plan);
  return Stage(museum, situation).run();
}

std::vector<double> seconds_alone(const Situation& situation) {
  std::vector<double> out;
  const Museum museum = museum_of(situation.plan);
  for (const Part& part : situation.parts) {
    Situation alone;
    alone.parts = {part};
    alone.seconds = situation.seconds;
    out.push_back(part.stays ? 0 : Stage(museum, alone).run().arrival.front());
  }
  return out;
}

void draw_scene(const Situation& situation, const Scene& scene, const std::filesystem::path& file) {
  Vec2 low(1e9), high(-1e9);
  for (const Vec2 p : situation.plan.vertex) low = glm::min(low, p), high = glm::max(high, p);
  const double scale = std::min(1200 / (high.x - low.x + 0.4), 900 / (high.y - low.y + 0.4));
  const auto x = [&](Vec2 p) { return (p.x - low.x + 0.2) * scale; };
  const auto y = [&](Vec2 p) { return (high.y - p.y + 0.2) * scale; };
  std::ofstream out(file);
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << (high.x - low.x + 0.4) * scale
      << "\" height=\"" << (high.y - low.y + 0.4) * scale
      << "\"><rect width=\"100%\" height=\"100%\" fill=\"#888\"/><path fill=\"#fff\" "
         "fill-rule=\"evenodd\" d=\"";
  for (const auto& ring : situation.plan.ring) {
    for (std::uint32_t i = 0; i < ring.count; ++i) {
      const Vec2 p = situation.plan.vertex[ring.first + i];
      out << (i == 0 ? "M" : "L") << x(p) << "," << y(p);
    }
    out << "Z";
  }
  out << "\"/>\n";
  const std::size_t count = scene.track.size();
  for (std::size_t i = 0; i < count; ++i) {
    const double hue = 360.0 * static_cast<double>(i) / static_cast<double>(count);
    out << "<polyline fill=\"none\" stroke=\"hsl(" << hue << ",70%,45%)\" points=\"";
    for (std::size_t f = 0; f < scene.track[i].size(); f += 6)
      out << x(scene.track[i][f].position) << "," << y(scene.track[i][f].position) << " ";
    out << "\"/>";
    for (std::size_t f = 0; f < scene.track[i].size(); f += 60)
      out << "<circle fill=\"none\" stroke=\"hsl(" << hue << ",70%,"
          << 75 - 50.0 * static_cast<double>(f) / static_cast<double>(scene.track[i].size())
          << "%)\" cx=\"" << x(scene.track[i][f].position) << "\" cy=\""
          << y(scene.track[i][f].position) << "\" r=\"" << scene.radius * scale << "\"/>";
    out << "\n";
  }
  out << "</svg>\n";
}

}  // namespace docent::test
