#include <GLES3/gl3.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "platform/gles/renderer.h"
#include "platform/headless/headless_display.h"
#include "runtime/kiosk/exhibition.h"
#include "tests/bench/measure.h"
#include "tests/bench/reference_scene.h"

namespace docent::bench {
namespace {

constexpr PixelSize full_hd{1920, 1080};

void run(kiosk::Exhibition& exhibition, double seconds) {
  for (int frame = 0; frame < std::lround(60 * seconds); ++frame) {
    exhibition.planner->wait();
    exhibition.guide->step(guide::Seconds{1.0F / 60});
    kiosk::apply_pieces(exhibition);
  }
}

void touch(kiosk::Exhibition& exhibition, const std::string& name) {
  const auto& controls = exhibition.guide->view()->controls;
  const auto it = std::ranges::find_if(controls, [&](const interface::Control& control) {
    return control.name == name && control.rect.width > 0;
  });
  if (it == controls.end()) return;
  const input::Contact finger{1, it->rect.x + it->rect.width / 2, it->rect.y + it->rect.height / 2};
  for (const auto kind : {input::InputEvent::Kind::Down, input::InputEvent::Kind::Up}) {
    exhibition.guide->touch({.kind = kind, .contact = finger});
    run(exhibition, 0.1);
  }
}

/// Something that is drawn, and what each of its frames took: milliseconds.
struct Contender {
  std::string name;
  std::function<void()> draw;
  std::vector<double> wall{}, processor{};
};

/// Frame about frame, so that whatever else the machine does is shared by all.
void measure(std::vector<Contender>& contenders, int frames) {
  for (int frame = -2; frame < frames; ++frame)
    for (Contender& one : contenders) {
      const double begun = now();
      const std::clock_t worked = std::clock();
      one.draw();
      glFinish();
      if (frame < 0) continue;
      one.wall.push_back(1e3 * (now() - begun));
      one.processor.push_back(1e3 * static_cast<double>(std::clock() - worked) / CLOCKS_PER_SEC);
    }
}

int measure(const std::string& database, int frames) {
  auto display = headless::open_headless(full_hd);
  auto renderer = gles::make_renderer();
  auto loaded = kiosk::load_exhibition(database, kiosk::Selection{},
                                       {.shape = {.width = 1920, .height = 1080}});
  auto jagged = ReferenceScene::make(full_hd, 1), smooth = ReferenceScene::make(full_hd, 4);
  if (!display || !renderer || !loaded || !jagged || !smooth) {
    const Error& error = !display    ? display.error()
                         : !renderer ? renderer.error()
                         : !loaded   ? loaded.error()
                         : !jagged   ? jagged.error()
                                     : smooth.error();
    std::fprintf(stderr, "%s\n", error.what.c_str());
    return 1;
  }
  kiosk::Exhibition& exhibition = **loaded;
  kiosk::upload(exhibition);
  renderer->warm_up(exhibition.holdings, (*display)->target());
  const auto shown = [&](const scene::DrawList& list) {
    return [&renderer, &exhibition, &display, list] {
      renderer->draw(list, exhibition.holdings, (*display)->target());
    };
  };
  std::vector<Contender> all{{"reference, 1 sample", [&] { jagged->draw(); }},
                             {"reference, 4 samples", [&] { smooth->draw(); }}};
  run(exhibition, 1);
  all.push_back({"welcome", shown(exhibition.guide->draw_list())});
  touch(exhibition, "begin");
  run(exhibition, 2);
  // An exhibit that is a shape of its own, where there is one.
  const auto& exhibits = exhibition.museum.exhibits;
  const auto object =
      std::ranges::find_if(exhibits, [](const Exhibit& one) { return one.object >= 0; });
  const Exhibit& goal = object != exhibits.end() ? *object : exhibits[exhibits.size() / 3];
  touch(exhibition, "exhibit:" + goal.id);
  run(exhibition, 2);
  all.push_back({"the whole way", shown(exhibition.guide->draw_list())});
  run(exhibition, 6);
  all.push_back({"walking", shown(exhibition.guide->draw_list())});
  for (int second = 0; second < 200 && !exhibition.guide->state().arrived; ++second)
    run(exhibition, 1);
  run(exhibition, 3);
  all.push_back({object != exhibits.end() ? "arrived at an object" : "arrived",
                 shown(exhibition.guide->draw_list())});
  measure(all, frames);

  std::printf("%d triangles; milliseconds a frame at 1920 x 1080, the median of %d\n",
              smooth->triangles(), frames);
  std::printf("%-24s %9s %9s  beside the reference: 1 sample  4 samples\n", "", "wall",
              "processor");
  for (const Contender& one : all)
    std::printf("%-24s %9.1f %9.1f %30.2f %10.2f\n", one.name.c_str(), median(one.wall),
                median(one.processor), median(one.processor) / median(all[0].processor),
                median(one.processor) / median(all[1].processor));
  return 0;
}

}  // namespace
}  // namespace docent::bench

int main(int argc, char** argv) {
  CLI::App app(
      "What the kiosk's frames cost beside a plain scene of 50,000 lit triangles with a "
      "shadow map, in one run, on this machine's graphics driver.");
  std::string database;
  int frames = 40;
  app.add_option("database", database, "A museum, compiled")->required();
  app.add_option("--frames", frames, "Frames of each picture")->check(CLI::Range(1, 10000));
  CLI11_PARSE(app, argc, argv);
  return docent::bench::measure(database, frames);
}
