// How do time and memory of making a motion graph grow with the motion, from files to pruned
// transitions, and how many of the transitions that comparing all frames finds does the index of
// poses find?

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <ctime>
#include <fstream>
#include <set>
#include <thread>
#include <tuple>

#include "content/draw/svg.h"
#include "content/import/motion/bvh_write.h"
#include "content/motion/compile_motion.h"
#include "content/motion/foot_plants.h"
#include "tests/bench/made_motion.h"
#include "tests/bench/measure.h"
#include "tests/bench/plot.h"
#include "tests/support/reference_data.h"
#include "tests/support/temporary_folder.h"

namespace docent::bench {
namespace {

constexpr std::uint64_t seed = 4;

/// Writes a BVH file per clip; returns the seconds of motion.
double write_motion(const Recordings& recorded, double seconds,
                    const std::filesystem::path& folder) {
  return make_motion(recorded, seconds, seed, [&](const motion::offline::SourceClip& made) {
    import::write_bvh(recorded.skeleton, {made.clip.frame_rate, made.clip.root, made.clip.rotation},
                      folder / made.file);
  });
}

/// Transitions with nothing before and after them.
class Search {
 public:
  Search(const Recordings& recorded, double seconds) {
    make_motion(recorded, seconds, seed, [&](motion::offline::SourceClip made) {
      const motion::offline::JointPositions track =
          motion::offline::joint_positions(recorded.skeleton, made.clip);
      motion::offline::find_foot_plants(recorded.skeleton, track, made.clip);
      studied_.cloud.push_back(motion::offline::make_pose_cloud(recorded.skeleton, track));
      studied_.faults.push_back(
          motion::offline::find_capture_faults(recorded.skeleton, made.clip, track));
      clips_.push_back(std::move(made.clip));
    });
  }

  struct Found {
    double seconds = 0;
    std::set<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t>> transitions;
  };

  Found find(std::size_t compare_all_up_to, unsigned jobs) const {
    motion::offline::TransitionOptions options;
    options.compare_all_up_to = compare_all_up_to;
    Found found;
    const double begin = now();
    const std::vector<double> threshold =
        motion::offline::alike_thresholds(clips_, studied_, options);
    for (const Transition& t :
         motion::offline::find_transitions(clips_, studied_, threshold, options, jobs))
      found.transitions.insert({t.from.clip, t.from.frame, t.to.clip, t.to.frame});
    found.seconds = now() - begin;
    return found;
  }

 private:
  std::vector<MotionClip> clips_;
  motion::offline::StudiedClips studied_;
};

/// Times the matrix of the recordings themselves, every frame with every frame, on one thread.
void time_matrix(const Recordings& recorded) {
  std::vector<motion::offline::PoseCloud> clouds;
  std::size_t frames = 0;
  for (const motion::offline::SourceClip& source : recorded.clips) {
    clouds.push_back(motion::offline::make_pose_cloud(
        recorded.skeleton, motion::offline::joint_positions(recorded.skeleton, source.clip)));
    frames += frame_count(source.clip);
  }
  const std::size_t half = motion::offline::frames_in(0.15, recorded.clips.front().clip.frame_rate);
  std::vector<double> seconds;
  for (int round = 0; round < 5; ++round) {
    const double begin = now();
    for (std::size_t a = 0; a < clouds.size(); ++a)
      for (std::size_t b = a; b < clouds.size(); ++b)
        motion::offline::measure_distances(clouds[a], clouds[b], half);
    seconds.push_back(now() - begin);
  }
  fmt::print("matrix of {} by {} frames: {:.3f} s on one thread\n", frames, frames,
             median(seconds));
}

void measure_recall(const Recordings& recorded, double minutes, unsigned jobs) {
  const Search search(recorded, 60 * minutes);
  const auto all = search.find(std::numeric_limits<std::size_t>::max(), jobs);
  const auto some = search.find(0, jobs);
  std::size_t both = 0;
  for (const auto& transition : some.transitions) both += all.transitions.contains(transition);
  fmt::print("{} minutes: all frames compared {:.2f} s, by index {:.2f} s; {:.2f} % of {} found\n",
             minutes, all.seconds, some.seconds,
             100.0 * static_cast<double>(both) / static_cast<double>(all.transitions.size()),
             all.transitions.size());
}

/// Seconds that all threads of this process have worked, whatever else the machine did.
double worked() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

struct Growth {
  Series seconds{.name = "files to graph", .colour = std::string(draw::ink::vermilion)};
  Series processor{.name = "work of all threads",
                   .colour = std::string(draw::ink::ochre),
                   .mark = Series::Mark::Ring};
  Series megabytes{.name = "memory", .colour = std::string(draw::ink::teal)};
};

void measure_size(const Recordings& recorded, double minutes, unsigned jobs, Growth& growth) {
  const test::TemporaryFolder folder;
  const double length = write_motion(recorded, 60 * minutes, folder.path());
  forget_peak();
  std::vector<Diagnostic> problems;
  const double begin = now(), work_begin = worked();
  const MotionGraph graph =
      motion::offline::compile_motion(folder.path(), {.transitions = {}, .jobs = jobs}, problems);
  const double seconds = now() - begin, work = worked() - work_begin;
  std::size_t frames = 0;
  for (const MotionClip& clip : graph.clips) frames += frame_count(clip);
  fmt::print("{:>8.1f} {:>8} {:>8} {:>12} {:>10.2f} {:>10.2f} {:>10.0f}\n", length / 60,
             graph.clips.size(), frames, graph.transitions.size(), seconds, work, peak_megabytes());
  std::fflush(stdout);
  growth.seconds.line.emplace_back(length / 60, seconds);
  growth.processor.line.emplace_back(length / 60, work);
  growth.megabytes.line.emplace_back(length / 60, peak_megabytes());
}

void run(const Recordings& recorded, const std::vector<double>& minutes, double recall_minutes,
         unsigned jobs, const std::filesystem::path& out) {
  time_matrix(recorded);
  if (recall_minutes > 0) measure_recall(recorded, recall_minutes, jobs);
  Growth growth;
  fmt::print("{:>8} {:>8} {:>8} {:>12} {:>10} {:>10} {:>10}\n", "minutes", "clips", "frames",
             "transitions", "seconds", "work s", "MB");
  for (const double length : minutes) measure_size(recorded, length, jobs, growth);
  Panel time{"Time", "minutes of motion", "seconds", {}};
  Panel memory{"Memory", "minutes of motion", "megabytes at most", {}};
  if (minutes.size() > 1) {
    for (Series* series : {&growth.seconds, &growth.processor, &growth.megabytes})
      series->label = fmt::format("slope {:.2f}", fit_power_law(series->line).exponent);
    fmt::print("time grows with exponent {:.2f}, work with {:.2f}, memory with {:.2f}\n",
               fit_power_law(growth.seconds.line).exponent,
               fit_power_law(growth.processor.line).exponent,
               fit_power_law(growth.megabytes.line).exponent);
  }
  time.series = {growth.seconds, growth.processor};
  memory.series.push_back(growth.megabytes);
  std::ofstream(out / "motion_graph.svg")
      << draw_panels("A motion graph of much motion",
                     fmt::format("Recordings time-warped, mirrored and perturbed; {} threads, from "
                                 "BVH files to pruned transitions.",
                                 jobs),
                     {time, memory});
}

}  // namespace
}  // namespace docent::bench

int main(int argc, char** argv) {
  using namespace docent;
  std::string out = ".", write;
  std::vector<std::string> clips;
  std::vector<double> minutes{5, 10, 20, 40, 60};
  double recall_minutes = 5;
  unsigned jobs = std::max(1U, std::thread::hardware_concurrency());
  CLI::App app("Times motion graphs of up to an hour of motion");
  app.add_option("--clips", clips, "folders of recordings of one body; default: what is shipped");
  app.add_option("--minutes", minutes, "of motion, ascending")->delimiter(',');
  app.add_option("--recall", recall_minutes,
                 "minutes of motion to count what is found in; 0: none");
  app.add_option("--jobs", jobs, "threads")->check(CLI::PositiveNumber);
  app.add_option("--write", write, "only write so much motion into this folder, as BVH")
      ->check(CLI::ExistingDirectory);
  app.add_option("-o", out, "folder for motion_graph.svg")->check(CLI::ExistingDirectory);
  CLI11_PARSE(app, argc, argv);
  try {
    if (clips.empty()) clips.push_back((test::source_dir() / "content/clips").string());
    const bench::Recordings recorded = bench::read_recordings({clips.begin(), clips.end()});
    if (!write.empty())
      bench::write_motion(recorded, 60 * minutes.back(), write);
    else
      bench::run(recorded, minutes, recall_minutes, jobs, out);
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_motion_graph: {}\n", error.what());
    return 2;
  }
  return 0;
}
