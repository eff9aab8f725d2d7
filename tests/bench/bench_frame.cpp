#include <GLES3/gl3.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <deque>
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

void run(kiosk::Exhibition& exhibition, double seconds) {
  for (int frame = 0; frame < std::lround(60 * seconds); ++frame) {
    exhibition.planner->wait();
    exhibition.guide->step(guide::Seconds{1.0F / 60});
    kiosk::apply_pieces(exhibition);
  }
}

/// The last of these on the glass: of an exhibit, its disc on the model.
const interface::Control* find(const kiosk::Exhibition& exhibition, const std::string& name) {
  const interface::Control* found = nullptr;
  for (const interface::Control& control : exhibition.guide->view()->controls)
    if (control.name == name && control.rect.width > 0) found = &control;
  return found;
}

void touch(kiosk::Exhibition& exhibition, const std::string& name) {
  const interface::Control* at = find(exhibition, name);
  if (at == nullptr) {
    std::fprintf(stderr, "%s is not on the glass\n", name.c_str());
    return;
  }
  const input::Contact finger{1, at->rect.x + at->rect.width / 2, at->rect.y + at->rect.height / 2};
  for (const auto kind : {input::InputEvent::Kind::Down, input::InputEvent::Kind::Up}) {
    exhibition.guide->touch({.kind = kind, .contact = finger});
    run(exhibition, 0.1);
  }
}

/// An exhibit that can be touched: one that is a shape of its own, where there is one.
const Exhibit* goal_of(const kiosk::Exhibition& exhibition) {
  const Exhibit* any = nullptr;
  for (const Exhibit& one : exhibition.museum.exhibits) {
    if (find(exhibition, "exhibit:" + one.id) == nullptr) continue;
    if (one.object >= 0) return &one;
    any = &one;
  }
  return any;
}

/// Something that is drawn, and what each of its frames took: milliseconds.
struct Contender {
  std::string name;
  std::function<void()> draw;
  std::function<void()> begin = [] {};  ///< What was drawn has been drawn over.
  std::vector<double> wall{}, processor{};
};

/// What a screen's own framebuffer is: it keeps what it is given. There is one.
class Panel {
 public:
  explicit Panel(PixelSize size)
      : target_{.size = size, .encoding = Encoding::Plain, .rotation = Rotation::None} {
    glGenRenderbuffers(1, &pixels_);
    glBindRenderbuffer(GL_RENDERBUFFER, pixels_);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, static_cast<GLsizei>(size.width),
                          static_cast<GLsizei>(size.height));
    glGenFramebuffers(1, &target_.framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, target_.framebuffer);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, pixels_);
  }
  const RenderTarget& target() const { return target_; }

 private:
  RenderTarget target_;
  GLuint pixels_ = 0;
};

constexpr int rounds = 5;

/// In turn, some frames each, so that whatever else the machine does is shared by all. The first
/// frames of a turn do not count: they draw everything.
void measure(std::vector<Contender>& contenders, int frames) {
  for (int round = 0; round < rounds; ++round)
    for (Contender& one : contenders) {
      one.begin();
      for (int frame = -2; frame < frames / rounds; ++frame) {
        const double begun = now();
        const std::clock_t worked = std::clock();
        one.draw();
        glFinish();
        if (frame < 0) continue;
        one.wall.push_back(1e3 * (now() - begun));
        one.processor.push_back(1e3 * static_cast<double>(std::clock() - worked) / CLOCKS_PER_SEC);
      }
    }
}

/// Frames one after the other, as a screen shows them: what differs of each is drawn.
struct Sequence {
  std::vector<scene::DrawList> frames;
  scene::ShownList shown{};
  std::size_t next = 0;
};

int measure(const std::string& database, PixelSize size, bool on_panel, int frames) {
  auto display = headless::open_headless(size);
  auto renderer = gles::make_renderer();
  auto loaded = kiosk::load_exhibition(database, kiosk::Selection{},
                                       {.shape = {.width = size.width, .height = size.height}});
  auto jagged = ReferenceScene::make(size, 1), smooth = ReferenceScene::make(size, 4);
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
  const Panel panel(size);
  const RenderTarget target = on_panel ? panel.target() : (*display)->target();
  renderer->warm_up(target);
  std::deque<Sequence> sequences;
  const auto record = [&]() -> Sequence& {
    Sequence& sequence = sequences.emplace_back();
    for (int frame = 0; frame < frames + 2 * rounds; ++frame) {
      run(exhibition, 1.0 / 60);
      sequence.frames.push_back(exhibition.guide->draw_list());
    }
    return sequence;
  };
  const auto shown = [&](std::string name, Sequence& sequence, float fineness = 1) -> Contender {
    const auto draw = [&, fineness] {
      const scene::DrawList& list = sequence.frames[sequence.next++ % sequence.frames.size()];
      const scene::Change change = sequence.shown.change(list, static_cast<float>(size.height));
      if (change.nothing()) return;
      renderer->draw(list, exhibition.holdings, target, change, fineness, 1);
      sequence.shown.keep(list, change);
    };
    return {std::move(name), draw, [&sequence] { sequence.shown.forget(); }};
  };
  const auto whole = [&](std::string name) -> Contender {
    return {std::move(name), [&, list = exhibition.guide->draw_list()] {
              renderer->draw(list, exhibition.holdings, target);
            }};
  };
  std::vector<Contender> all{{"reference, 1 sample", [&] { jagged->draw(); }},
                             {"reference, 4 samples", [&] { smooth->draw(); }}};
  run(exhibition, 1);
  all.push_back(shown("welcome", record()));
  touch(exhibition, "begin");
  run(exhibition, 2);
  const Exhibit* goal = goal_of(exhibition);
  if (goal == nullptr) {
    std::fprintf(stderr, "%s has no exhibit on its first floor\n", database.c_str());
    return 1;
  }
  touch(exhibition, "exhibit:" + goal->id);
  run(exhibition, 2);
  all.push_back(shown("the whole way", record()));
  run(exhibition, 6);
  Sequence& walk = record();
  all.push_back(shown("walking", walk));
  all.push_back(shown("walking, three quarters", walk, 0.75F));
  all.push_back(shown("walking, half", walk, 0.5F));
  all.push_back(shown("walking, quarter", walk, 0.25F));
  all.push_back(shown("walking, a fifth", walk, 0.1875F));
  for (int second = 0; second < 200 && !exhibition.guide->state().arrived; ++second)
    run(exhibition, 1);
  run(exhibition, 3);
  const std::string arrived = goal->object >= 0 ? "arrived at an object" : "arrived";
  all.push_back(shown(arrived, record()));
  all.push_back(whole(arrived + ", all of it"));
  measure(all, frames);

  const auto worked = [](const Contender& one) { return quantile(one.processor, 0.25); };
  std::printf(
      "%d triangles; milliseconds a frame at %u x %u, of %d: the median on the clock, and the "
      "lower quartile of processor time, which other work disturbs less\n",
      smooth->triangles(), size.width, size.height, frames);
  std::printf("%-24s %9s %9s  beside the reference: 1 sample  4 samples\n", "", "wall",
              "processor");
  for (const Contender& one : all)
    std::printf("%-24s %9.1f %9.1f %30.2f %10.2f\n", one.name.c_str(), median(one.wall),
                worked(one), worked(one) / worked(all[0]), worked(one) / worked(all[1]));
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
  std::pair<unsigned, unsigned> size{1920, 1080};
  app.add_option("database", database, "A museum, compiled")->required();
  app.add_option("--frames", frames, "Frames of each picture")->check(CLI::Range(1, 10000));
  app.add_option("--size", size, "Of the picture, such as 3840x2160")->delimiter('x');
  bool on_panel = false;
  app.add_flag("--panel", on_panel, "Onto a screen, to which each picture is copied");
  CLI11_PARSE(app, argc, argv);
  return docent::bench::measure(database, {size.first, size.second}, on_panel, frames);
}
