#include <GLES3/gl3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <glm/gtc/matrix_transform.hpp>
#include <span>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "platform/gles/renderer.h"
#include "platform/headless/headless_display.h"
#include "runtime/kiosk/exhibition.h"
#include "runtime/scene/look.h"
#include "tests/bench/measure.h"

namespace docent::bench {
namespace {

constexpr std::size_t guides = scene::guide_look_count, strollers = 40;

/// Lets the kiosk run in simulated time, the worker's answers always there.
void run(kiosk::Exhibition& exhibition, double seconds) {
  for (int frame = 0; frame < std::lround(60 * seconds); ++frame) {
    exhibition.planner->wait();
    exhibition.guide->step(guide::Seconds{1.0F / 60});
    kiosk::apply_pieces(exhibition);
  }
}

void press(kiosk::Exhibition& exhibition, input::Key key) {
  exhibition.guide->touch({.kind = input::InputEvent::Kind::KeyDown, .contact = {}, .key = key});
  run(exhibition, 0.1);
}

/// The leader again, elsewhere and in another look.
void add_beside(scene::DrawList& list, Vec2 offset, std::uint32_t look) {
  const Vec3 by = to_world(offset);
  scene::AvatarDraw other = list.avatars.front();
  const std::size_t joints = list.palette.size() / list.avatars.size();
  other.look = look;
  other.first_matrix = static_cast<std::uint32_t>(list.palette.size());
  other.centre += by;
  for (Vec3& foot : other.feet) foot += by;
  for (std::size_t j = 0; j < joints; ++j)
    list.palette.push_back(glm::translate(Mat4(1), by) * list.palette[j]);
  list.avatars.push_back(other);
}

/// One guide's picture with seven more guides and forty strolling visitors, scattered evenly over
/// `width` by `depth` metres from `corner`.
scene::DrawList with_company(const scene::DrawList& alone, Vec2 corner, double width,
                             double depth) {
  scene::DrawList list = alone;
  const Vec2 leader = to_floor(list.avatars.front().centre);
  for (std::size_t i = 1; i < guides + strollers; ++i) {
    // The additive recurrence of the plastic number: even, and never on a grid.
    const auto n = static_cast<double>(i);
    const Vec2 at = corner + Vec2{width * std::fmod(0.7548776662 * n, 1.0),
                                  depth * std::fmod(0.5698402910 * n, 1.0)};
    const std::size_t look =
        i < guides ? i
                   : scene::guide_look_count + i % (scene::looks.size() - scene::guide_look_count);
    add_beside(list, at - leader, static_cast<std::uint32_t>(look));
  }
  return list;
}

struct Cost {
  std::vector<double> wall, processor;  ///< Milliseconds a frame.
};

/// What a picture is drawn with, and to.
struct Easel {
  gles::Renderer& renderer;
  const gles::Holdings& holdings;
  headless::HeadlessDisplay& display;
};

void draw_once(const Easel& easel, const scene::DrawList& list, Cost& cost) {
  const double begun = now();
  const std::clock_t worked = std::clock();
  easel.renderer.draw(list, easel.holdings, easel.display.target());
  glFinish();
  cost.wall.push_back(1e3 * (now() - begun));
  cost.processor.push_back(1e3 * static_cast<double>(std::clock() - worked) / CLOCKS_PER_SEC);
}

/// What do seven more guides and forty visitors cost beside one guide, frame about frame?
void compare(const char* picture, const Easel& easel, const scene::DrawList& alone,
             const scene::DrawList& crowd, int frames) {
  Cost one, many;
  for (int frame = 0; frame < frames + 2; ++frame) {
    draw_once(easel, alone, one);
    draw_once(easel, crowd, many);
    if (frame == 1) one = many = {};  // textures and buffers have found their places
  }
  const auto report = [&](const char* clock, std::span<const double> a, std::span<const double> b) {
    std::printf("%-34s %-10s %8.1f %8.1f %8.2f\n", picture, clock, median(a), median(b),
                median(b) / median(a));
  };
  report("wall", one.wall, many.wall);
  report("processor", one.processor, many.processor);
}

int measure(const std::string& database, int frames) {
  constexpr PixelSize full_hd{1920, 1080};
  auto display = headless::open_headless(full_hd);
  auto renderer = gles::make_renderer();
  auto loaded = kiosk::load_exhibition(database, kiosk::Selection{},
                                       {.shape = {.width = 1920, .height = 1080}});
  if (!display || !renderer || !loaded) {
    const Error& error =
        !display ? display.error() : (!renderer ? renderer.error() : loaded.error());
    std::fprintf(stderr, "%s\n", error.what.c_str());
    return 1;
  }
  kiosk::Exhibition& exhibition = **loaded;
  kiosk::upload(exhibition);
  renderer->warm_up((*display)->target());
  const Easel easel{*renderer, exhibition.holdings, **display};
  std::printf("milliseconds a frame at 1920 x 1080     clock      1 avatar       48    ratio\n");

  run(exhibition, 0.5);
  press(exhibition, input::Key::Enter);
  run(exhibition, 2);
  const scene::DrawList overview = exhibition.guide->draw_list();
  compare("overview, all over the floor", easel, overview,
          with_company(overview, {0.5, 0.5}, 38, 30), frames);

  press(exhibition, input::Key::Down);
  press(exhibition, input::Key::Enter);
  run(exhibition, 4);
  const scene::DrawList walking = exhibition.guide->draw_list();
  compare("walking, all over the floor", easel, walking, with_company(walking, {0.5, 0.5}, 38, 30),
          frames);
  const Vec2 leader = to_floor(walking.avatars.front().centre);
  compare("walking, all within 14 m by 14 m", easel, walking,
          with_company(walking, leader - Vec2{7, 7}, 14, 14), frames);
  return 0;
}

}  // namespace
}  // namespace docent::bench

int main(int argc, char** argv) {
  CLI::App app("What 48 avatars cost beside one, in one run, on this machine's graphics driver.");
  std::string database;
  int frames = 40;
  app.add_option("database", database, "The sample museum, compiled")->required();
  app.add_option("--frames", frames, "Frames of each picture")->check(CLI::Range(1, 10000));
  CLI11_PARSE(app, argc, argv);
  return docent::bench::measure(database, frames);
}
