#include "content/compile/progress.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "platform/terminal/colour.h"

namespace docent::compile {

namespace {

double seconds_between(std::chrono::steady_clock::time_point a,
                       std::chrono::steady_clock::time_point b) {
  return std::chrono::duration<double>(b - a).count();
}

}  // namespace

Progress::Output progress_output(bool quiet) {
  if (quiet) return Progress::Output::Nothing;
  return terminal::is_terminal(stderr) ? Progress::Output::Bar : Progress::Output::Lines;
}

Progress::Progress(Output output) : output_(output) {}

Progress::~Progress() {
  clear();
}

void Progress::clear() {
  const std::lock_guard lock(mutex_);
  erase_bar();
}

void Progress::plan(std::string_view stage, double work) {
  const std::lock_guard lock(mutex_);
  entries_.push_back({.name = std::string(stage), .work = work});
}

Progress::Running Progress::start(std::string_view stage) {
  const std::lock_guard lock(mutex_);
  const auto entry = std::ranges::find(entries_, stage, &Entry::name);
  entry->state = Entry::State::Running;
  entry->begin = Clock::now();
  draw_bar();
  return {*this, static_cast<std::size_t>(entry - entries_.begin())};
}

void Progress::finish(std::size_t stage) {
  const std::lock_guard lock(mutex_);
  Entry& entry = entries_[stage];
  entry.state = Entry::State::Done;
  entry.seconds += seconds_between(entry.begin, Clock::now());
  if (output_ == Output::Lines) fmt::print(stderr, "{:<16} {:6.2f} s\n", entry.name, entry.seconds);
  draw_bar();
}

double Progress::seconds() const {
  return seconds_between(begin_, Clock::now());
}

std::vector<Progress::Stage> Progress::stages() const {
  const std::lock_guard lock(mutex_);
  std::vector<Stage> done;
  for (const Entry& entry : entries_)
    if (entry.state == Entry::State::Done)
      done.push_back({.name = entry.name, .seconds = entry.seconds});
  return done;
}

void Progress::draw_bar() {
  if (output_ != Output::Bar) return;
  double all = 0;
  double done = 0;
  std::string running;
  for (const Entry& entry : entries_) {
    all += entry.work;
    if (entry.state == Entry::State::Done) done += entry.work;
    if (entry.state == Entry::State::Running) running = entry.name;
  }
  constexpr int width = 30;
  const double share = all > 0 ? done / all : 0;
  const int filled = static_cast<int>(std::lround(share * width));
  // Work so far took that long, so the rest takes in proportion.
  const double left = share > 0 ? seconds_between(begin_, Clock::now()) * (1 - share) / share : 0;
  fmt::print(stderr, "\r\x1b[K[{:=<{}}{: <{}}] {}{}{}", "", filled, "", width - filled, running,
             share > 0 && !running.empty() ? ", " : "",
             share > 0 ? fmt::format("{:.0f} s left", std::ceil(left)) : "");
  std::fflush(stderr);
}

void Progress::erase_bar() {
  if (output_ != Output::Bar) return;
  fmt::print(stderr, "\r\x1b[K");
  std::fflush(stderr);
}

}  // namespace docent::compile
