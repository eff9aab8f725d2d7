#include "runtime/kiosk/staff_facts.h"

#include <fmt/format.h>

#include <algorithm>

#include "platform/terminal/command_line.h"
#include "runtime/interface/control.h"
#include "runtime/interface/phrases.h"

namespace docent::kiosk {
namespace {

std::string milliseconds(double value) {
  return fmt::format("{:.1f}", value);
}

std::string title_in(const Museum& museum, std::string_view language) {
  const auto spoken = std::ranges::find(museum.languages, language, &Language::tag);
  const auto index = spoken == museum.languages.end() ? 0 : spoken - museum.languages.begin();
  return std::string(
      interface::in_language(museum, static_cast<std::uint32_t>(index), museum.title));
}

}  // namespace

std::vector<StaffFact> facts_of(const RunningKiosk& kiosk, const StaffWords& words) {
  const Museum& museum = kiosk.museum;
  const Statistics& statistics = kiosk.statistics;
  const auto said = [&](StaffWord label, std::string value) {
    return StaffFact{.label = std::string(words[label]), .value = std::move(value)};
  };
  const auto of_machine = [&](StaffWord label, std::string value) {
    StaffFact fact = said(label, std::move(value));
    fact.is_of_machine = true;
    return fact;
  };
  return {
      of_machine(StaffWord::Version, std::string(terminal::version())),
      said(StaffWord::Shows,
           interface::filled_in(
               words.filled(StaffWord::ShowsWhat,
                            {{"floors", std::to_string(museum.floors.size())},
                             {"exhibits", std::to_string(museum.exhibits.size())},
                             {"languages", std::to_string(museum.languages.size())}}),
               "title", title_in(museum, words.language))),
      of_machine(StaffWord::Database, kiosk.database.string()),
      of_machine(StaffWord::Screen, kiosk.screen),
      said(StaffWord::Frames, words.filled(StaffWord::FramesMade,
                                           {{"made", std::to_string(statistics.frames)},
                                            {"late", std::to_string(statistics.dropped_frames)}})),
      said(StaffWord::FrameTime,
           words.filled(StaffWord::FrameTakes,
                        {{"n", milliseconds(statistics.frame_cpu.milliseconds_at(0.5))},
                         {"most", milliseconds(statistics.frame_cpu.longest_milliseconds())},
                         {"drawing", milliseconds(statistics.gl.milliseconds_at(0.5))}})),
      said(StaffWord::Touches,
           words.filled(StaffWord::SinceStart, {{"n", std::to_string(kiosk.touches)}}))};
}

}  // namespace docent::kiosk
