#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>

#include "config/diagnostic_text.h"
#include "content/command/commands.h"
#include "content/command/open_museum.h"
#include "content/command/query_io.h"
#include "content/command/stopwatch.h"
#include "content/content_error.h"
#include "content/import/motion/bvh_write.h"
#include "content/motion/paper_walk.h"
#include "content/motion/path_deviation.h"
#include "runtime/model/geometry/polyline.h"
#include "runtime/motion/path_track.h"
#include "runtime/motion/pose.h"
#include "runtime/motion/walk.h"
#include "runtime/motion/walk_graph.h"

namespace docent::command {
namespace {

constexpr double radians_per_degree = std::numbers::pi / 180;
constexpr double most_missing = 1.5;  // metres that a walk without a warp may end too early

enum class Search : std::uint8_t { Docent, Paper };

struct WalkOptions {
  std::string database, path, output;
  Search search = Search::Docent;
  std::optional<double> lookahead, use_rate, time_limit;
  std::optional<std::array<double, 3>> start;  ///< X, Y, heading in degrees.
  double fps = 0;                              ///< 0: the clips' own.
  bool exact = false, raw = false, json = false;
};

[[noreturn]] void misuse(const char* option, const std::string& message, const char* hint) {
  throw content::ContentError(Errc::WrongUsage, option, "walk-options", message, hint);
}

void check_options(const WalkOptions& options) {
  const bool is_paper = options.search == Search::Paper;
  if (is_paper && options.exact)
    misuse("--exact", "the paper's search gives the motion graph's own track and warps nothing",
           "leave --exact out");
  if (!is_paper && (options.lookahead || options.use_rate || options.time_limit))
    misuse("--lookahead", "--lookahead, --use-rate and --time-limit belong to --search paper",
           "leave them out");
  if (options.exact && options.raw)
    misuse("--raw", "a walk is exact or raw, not both", "leave one of them out");
}

/// The walk at another frame rate.
motion::Walk resampled(const motion::Walk& walk, double frame_rate) {
  motion::Walk out;
  out.frame_rate = frame_rate;
  out.joint_count = walk.joint_count;
  const double seconds = static_cast<double>(motion::frame_count(walk) - 1) / walk.frame_rate;
  const auto frames = static_cast<std::size_t>(std::floor(seconds * frame_rate + 1e-6)) + 1;
  out.rotation.resize(frames * walk.joint_count);
  for (std::size_t f = 0; f < frames; ++f) {
    motion::PoseView pose{{},
                          std::span(out.rotation).subspan(f * walk.joint_count, walk.joint_count)};
    motion::sample(walk, static_cast<double>(f) / frame_rate, pose);
    out.root.push_back(pose.root);
  }
  return out;
}

struct Outcome {
  motion::Walk walk;
  motion::offline::PathDeviation deviation;
  double path_length = 0, total_seconds = 0;
};

std::optional<Placement> start_of(const WalkOptions& options) {
  if (!options.start) return std::nullopt;
  const auto& [x, y, heading] = *options.start;
  return Placement{{x, y}, heading * radians_per_degree};
}

motion::Walk walk_by_docent(const motion::WalkGraph& graph, const std::vector<Vec2>& path,
                            const WalkOptions& options) {
  motion::WalkRequest request;
  request.path = path;
  request.start = start_of(options);
  request.fidelity = options.raw ? motion::Fidelity::Raw : motion::Fidelity::Exact;
  Result<motion::Walk> walk = motion::make_walk(graph, request);
  if (!walk)
    throw content::ContentError(walk.error().code, options.path, "cannot-walk", walk.error().what);
  return std::move(*walk);
}

void tell(const Diagnostic& diagnostic, const WalkOptions& options) {
  config::tell({&diagnostic, 1},
               options.json ? config::DiagnosticForm::Json : config::DiagnosticForm::Text);
}

/// Says on standard error where a search was stopped, and goes on with what it has.
void report_early_end(const motion::offline::PaperWalk& found, double path_length,
                      const WalkOptions& options) {
  tell({.file = options.path,
        .severity = Severity::Warning,
        .code = "search-stopped",
        .message = fmt::format("the paper's search had kept {:.2f} of {:.2f} m when it stopped "
                               "after {:.1f} s: the walk "
                               "ends there",
                               found.length, path_length, found.walk.search_seconds),
        .hint =
            "look ahead less (--lookahead), keep more (--use-rate) or wait longer (--time-limit)"},
       options);
}

/// A raw walk keeps to the path by its clips alone. Does it end long before the path does? Says so.
bool stops_short(const Outcome& outcome, const WalkOptions& options) {
  const double missing = outcome.path_length - outcome.deviation.reached;
  if (!options.raw || missing <= std::min(most_missing, outcome.path_length / 2)) return false;
  tell(
      {.file = options.path,
       .code = "stops-short",
       .message = fmt::format("the clips alone keep to {:.2f} of the path's {:.2f} m",
                              outcome.deviation.reached, outcome.path_length),
       .hint = "leave --raw out, so that the walk is warped onto the path; or add clips that turn"},
      options);
  return true;
}

motion::Walk walk_by_paper(const motion::WalkGraph& graph, const std::vector<Vec2>& path,
                           const WalkOptions& options) {
  motion::offline::PaperWalkRequest request;
  request.path = path;
  request.start = start_of(options);
  request.lookahead = options.lookahead.value_or(request.lookahead);
  request.use_rate = options.use_rate.value_or(request.use_rate);
  request.time_limit = options.time_limit.value_or(request.time_limit);
  motion::offline::PaperWalk found = motion::offline::make_paper_walk(graph, request);
  if (!found.reaches_end) report_early_end(found, polyline_length(path), options);
  return std::move(found.walk);
}

Outcome walk_along(const MotionGraph& motion, const std::vector<Vec2>& path,
                   const WalkOptions& options) {
  const auto graph = motion::make_walk_graph(motion);
  if (!graph)
    throw content::ContentError(graph.error().code, options.database, "cannot-walk",
                                graph.error().what);

  Outcome outcome;
  const auto began = std::chrono::steady_clock::now();
  outcome.walk = options.search == Search::Paper ? walk_by_paper(*graph, path, options)
                                                 : walk_by_docent(*graph, path, options);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
  outcome.total_seconds = took.count();

  std::vector<Vec2> roots;
  for (const Vec3& root : outcome.walk.root) roots.push_back(to_floor(root));
  outcome.deviation = motion::offline::measure_deviation(roots, outcome.walk.frame_rate, path);
  outcome.path_length = polyline_length(path);
  return outcome;
}

std::string to_json(const Outcome& outcome, std::uint32_t frames) {
  const motion::Walk& walk = outcome.walk;
  return fmt::format(
      R"({{"search_seconds": {}, "total_seconds": {}, "frames": {}, "path_length": {}, )"
      R"("reached": {}, "deviation_mean": {}, "deviation_max": {}, "transitions": {}, )"
      R"("expanded": {}}})",
      json_number(walk.search_seconds), json_number(outcome.total_seconds), frames,
      json_number(outcome.path_length), json_number(outcome.deviation.reached),
      json_number(outcome.deviation.mean), json_number(outcome.deviation.largest), walk.transitions,
      walk.expanded);
}

std::string to_sentence(const Outcome& outcome, std::uint32_t frames) {
  return fmt::format(
      "{} frames along {:.3f} m, {} transitions, {:.1f} ms; deviation {:.1f} cm on average, {:.1f} "
      "cm at most",
      frames, outcome.path_length, outcome.walk.transitions, outcome.total_seconds * 1e3,
      outcome.deviation.mean * 100, outcome.deviation.largest * 100);
}

int run_walk(const WalkOptions& options) {
  const Stopwatch stopwatch;
  check_options(options);
  const std::vector<Vec2> path = read_path(options.path);
  const Museum museum = load_or_throw(options.database);
  Outcome outcome = walk_along(museum.motion, path, options);
  const bool same_rate = options.fps == 0 || options.fps == outcome.walk.frame_rate;
  const motion::Walk other = same_rate ? motion::Walk{} : resampled(outcome.walk, options.fps);
  const motion::Walk& walk = same_rate ? outcome.walk : other;
  import::write_bvh(museum.motion.skeleton, {walk.frame_rate, walk.root, walk.rotation},
                    options.output);
  const std::uint32_t frames = motion::frame_count(walk);
  fmt::print("{}\n", options.json ? to_json(outcome, frames) : to_sentence(outcome, frames));
  if (!options.json) stopwatch.say_wrote(options.output);
  return stops_short(outcome, options) ? 1 : 0;
}

}  // namespace

terminal::Command walk_command() {
  using terminal::Times;
  auto options = std::make_shared<WalkOptions>();
  return {
      .name = "walk",
      .manual = "walks along a path and writes the motion as BVH",
      .options =
          {
              {"DB", terminal::file("DB", options->database), "The museum's database", Times::Once},
              {"--path", terminal::file("P.csv", options->path),
               "Columns x,y: a polyline in metres", Times::Once},
              {"-o,--output", terminal::file("W.bvh", options->output), "The walk", Times::Once},
              {"--search",
               terminal::one_of<Search>({{"docent", Search::Docent}, {"paper", Search::Paper}},
                                        options->search),
               "Our search, or the founding paper's", Times::AtMostOnce, "docent"},
              {"--lookahead", terminal::number("M", terminal::positive, options->lookahead),
               "paper: metres looked ahead in a step", Times::AtMostOnce, "1"},
              {"--use-rate", terminal::number("F", {.least = 0, .most = 1}, options->use_rate),
               "paper: share of a step that is kept", Times::AtMostOnce, "0.25"},
              {"--time-limit", terminal::number("S", terminal::positive, options->time_limit),
               "paper: seconds of search, then the walk ends where it is", Times::AtMostOnce,
               "600"},
              {"--start", terminal::numbers("X,Y,HEADING", options->start),
               "Where the walk begins: metres, degrees", Times::AtMostOnce,
               "the path's first point, along the path"},
              {"--fps", terminal::number("N", {.least = 1, .most = 1000}, options->fps),
               "Frames a second", Times::AtMostOnce, "the clips' own"},
              {"--exact", terminal::flag(options->exact),
               "Warp the walk onto the path and pin the planted feet; so it is unless --raw"},
              {"--raw", terminal::flag(options->raw), "Leave the motion graph's own track"},
              {"--json", terminal::flag(options->json), "Print the figures as JSON"},
          },
      .run = [options] { return run_walk(*options); }};
}

}  // namespace docent::command
