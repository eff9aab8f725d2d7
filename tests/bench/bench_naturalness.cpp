// How natural are walks through a museum, measured on their frames alone and beside the clips that
// they are made of: on the shipped clips, on recordings, and on any folder given?

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <filesystem>

#include "content/motion/compile_motion.h"
#include "platform/sqlite/content_reader.h"
#include "runtime/motion/make_foresight.h"
#include "tests/bench/naturalness_table.h"
#include "tests/support/reference_data.h"

namespace docent::bench {
namespace {

/// A motion graph and what walks on it.
struct Walkable {
  MotionGraph motion;
  motion::WalkGraph graph;
};

std::unique_ptr<Walkable> walkable(const std::filesystem::path& clips) {
  auto made = std::make_unique<Walkable>();
  std::vector<Diagnostic> problems;
  made->motion = motion::offline::compile_motion(clips, {}, problems);
  Result<motion::WalkGraph> graph = motion::make_walk_graph(made->motion);
  if (!graph) throw std::runtime_error(clips.string() + ": " + graph.error().what);
  made->graph = std::move(*graph);
  made->motion.foresight = motion::make_foresight(made->graph);
  return made;
}

void run(const std::string& database, std::vector<std::string> folders,
         const std::string& held_out) {
  const Result<Museum> museum = sqlite::load_museum(database);
  if (!museum) throw std::runtime_error(museum.error().what);
  const std::vector<MuseumRoutes> routes = museum_routes(*museum);
  const auto recorded = test::reference_data() / "mocap/cmu-walk";
  if (folders.empty()) {
    folders.push_back((test::source_dir() / "content/clips").string());
    if (std::filesystem::exists(recorded)) folders.push_back(recorded.string());
  }
  for (const std::string& folder : folders) {
    const auto made = walkable(folder);
    std::vector<TrackedMotion> takes;
    const std::filesystem::path others = std::filesystem::path(folder) / held_out;
    if (!held_out.empty() && std::filesystem::exists(others))
      takes = track_clips(walkable(others)->graph);
    const std::string title =
        fmt::format("\n{}: {} clips, {} transitions", folder, made->motion.clips.size(),
                    made->motion.transitions.size());
    fmt::print("{}", to_table(title, measure_naturalness(made->graph, routes, takes)));
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace docent::bench

int main(int argc, char** argv) {
  std::string database, held_out = "second-takes";
  std::vector<std::string> clips;
  CLI::App app("Measures how natural walks through a museum are");
  app.add_option("database", database, "a compiled museum, for its ways")
      ->required()
      ->check(CLI::ExistingFile);
  app.add_option("--clips", clips, "folders of recordings; the shipped and the recorded walks")
      ->check(CLI::ExistingDirectory);
  app.add_option("--held-out", held_out, "subfolder of takes that are in no graph: a yardstick");
  CLI11_PARSE(app, argc, argv);
  try {
    docent::bench::run(database, clips, held_out);
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_naturalness: {}\n", error.what());
    return 2;
  }
  return 0;
}
