#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "content/command/commands.h"
#include "content/command/open_museum.h"
#include "content/command/stopwatch.h"
#include "content/content_error.h"
#include "content/draw/graph/motion_graph_drawing.h"
#include "content/draw/picture_file.h"
#include "content/motion/classify.h"

namespace docent::command {
namespace {

struct GraphOptions {
  std::string database, output;
  bool json = false;
};

nlohmann::ordered_json to_json(const MotionClip& clip) {
  return {{"name", clip.name},
          {"role", motion::offline::name_of(clip.role)},
          {"class", clip.motion_class},
          {"frames", frame_count(clip)},
          {"frame_rate", clip.frame_rate}};
}

nlohmann::ordered_json to_json(const Transition& t) {
  return {{"from", {t.from.clip, t.from.frame}},
          {"to", {t.to.clip, t.to.frame}},
          {"radius", t.radius},
          {"distance", t.distance}};
}

nlohmann::ordered_json to_json(const MotionClass& motion_class) {
  return {{"name", motion_class.name}, {"coefficients", motion_class.coefficient}};
}

std::string to_json(const MotionGraph& graph) {
  nlohmann::ordered_json json{{"classes", nlohmann::ordered_json::array()},
                              {"clips", nlohmann::ordered_json::array()},
                              {"transitions", nlohmann::ordered_json::array()}};
  for (const MotionClass& c : graph.classes) json["classes"].push_back(to_json(c));
  for (const MotionClip& clip : graph.clips) json["clips"].push_back(to_json(clip));
  for (const Transition& t : graph.transitions) json["transitions"].push_back(to_json(t));
  return json.dump();
}

void run_graph(const GraphOptions& options) {
  const Stopwatch stopwatch;
  const Museum museum = load_or_throw(options.database);
  if (museum.motion.clips.empty())
    throw content::ContentError(options.database, 0, 0, "no-motion",
                                "this database holds no motion", "compile it without --no-motion");
  draw::write_picture(options.output, draw::draw_motion_graph(museum.motion));
  if (options.json)
    fmt::print("{}\n", to_json(museum.motion));
  else
    stopwatch.say_wrote(options.output);
}

}  // namespace

terminal::Command graph_command() {
  using terminal::Times;
  auto options = std::make_shared<GraphOptions>();
  return {
      .name = "graph",
      .manual = "draws the motion graph of a database",
      .options =
          {
              {"DB", terminal::file("DB", options->database), "The museum's database", Times::Once},
              {"-o,--output", terminal::file("FILE", options->output),
               "The picture: FILE.svg or FILE.png", Times::Once},
              {"--json", terminal::flag(options->json),
               "Print classes, clips and transitions as JSON"},
          },
      .run = [options] {
        run_graph(*options);
        return 0;
      }};
}

}  // namespace docent::command
