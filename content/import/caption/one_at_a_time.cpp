#include <algorithm>
#include <tuple>

#include "content/import/caption/webvtt.h"

namespace docent::import {
namespace {

void add(TimedCaption next, std::vector<TimedCaption>& all) {
  if (next.text.empty()) return;
  const bool goes_on = !all.empty() && all.back().end == next.begin &&
                       all.back().text == next.text && all.back().line == next.line;
  if (goes_on)
    all.back().end = next.end;
  else
    all.push_back(std::move(next));
}

}  // namespace

std::vector<TimedCaption> one_at_a_time(std::vector<TimedCaption> captions) {
  std::ranges::stable_sort(captions, {}, &TimedCaption::begin);
  std::vector<std::uint32_t> times;
  for (const TimedCaption& one : captions) times.insert(times.end(), {one.begin, one.end});
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());

  std::vector<TimedCaption> all;
  std::vector<const TimedCaption*> read;  // now
  auto next = captions.begin();
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    std::erase_if(read, [&](const TimedCaption* one) { return one->end <= times[i]; });
    for (; next != captions.end() && next->begin <= times[i]; ++next) read.push_back(&*next);
    TimedCaption now{.begin = times[i], .end = times[i + 1], .text = {}};
    for (const TimedCaption* one : read) now.text.append(now.text.empty() ? "" : "\n") += one->text;
    if (read.size() == 1) now.line = read.front()->line;
    add(std::move(now), all);
  }
  return all;
}

}  // namespace docent::import
