#include "content/compile/compile_tours.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "content/compile/compile_exhibits.h"
#include "runtime/path/building/museum_tour.h"

namespace docent::compile {
namespace {

constexpr double seconds_a_minute = 60;
/// A tour of fewer is none that is offered for a time.
constexpr std::size_t fewest_stops = 2;

class TourCompiler {
 public:
  TourCompiler(const config::MuseumConfig& config,
               std::span<const std::shared_ptr<const path::FloorMap>> maps, Museum& museum,
               Report& report)
      : config_(config),
        museum_(museum),
        report_(report),
        building_(museum, {maps.begin(), maps.end()}),
        wish_(path::tour_from_kiosk(museum)) {
    wish_.permissions.closed_too = true;  // what is closed may open
  }

  void add(const config::TourSection& section) {
    std::vector<std::uint32_t> exhibits;
    for (const config::Located<std::string>& id : section.exhibits.value) {
      const auto found = std::ranges::find(museum_.exhibits, id.value, &Exhibit::id);
      if (found == museum_.exhibits.end()) return;  // already reported
      exhibits.push_back(static_cast<std::uint32_t>(found - museum_.exhibits.begin()));
    }
    if (exhibits.empty() && !section.minutes.given) return;
    const path::MuseumTour walked = walk(section, exhibits);
    if (walked.why_not) return report_unreached(section, walked);
    if (walked.exhibits.empty()) return report_too_short(section);
    Tour& tour = museum_.tours.emplace_back();
    tour.id = section.id.value;
    tour.title = plain_texts(section.title.value);
    tour.fixed = section.fixed.value;
    tour.minutes = section.minutes.value;
    path::set_walk(tour, walked);
    if (section.minutes.given && walked.seconds() > section.minutes.value * seconds_a_minute)
      warn_of_length(section, walked);
  }

  /// Tours for who has so much time, each of more than what less time is enough for.
  void add_for_time() {
    const config::LocatedNumbers& asked = config_.museum.minutes.value;
    std::vector<double> all(config::usual_minutes.begin(), config::usual_minutes.end());
    if (config_.museum.minutes.given) {
      all.clear();
      for (const config::Located<double>& one : asked) all.push_back(std::round(one.value));
      std::ranges::sort(all);
    }
    double most = 0;
    for (const double minutes : all) {
      const path::MuseumTour walked =
          path::best_tour(museum_, building_, minutes * seconds_a_minute, wish_);
      if (walked.exhibits.size() < fewest_stops || walked.weight <= most) continue;
      most = walked.weight;
      Tour& tour = museum_.tours.emplace_back();
      tour.id = fmt::format("minutes-{:g}", minutes);
      tour.minutes = minutes;
      path::set_walk(tour, walked);
    }
  }

 private:
  path::MuseumTour walk(const config::TourSection& section,
                        std::span<const std::uint32_t> exhibits) const {
    if (exhibits.empty())
      return path::best_tour(museum_, building_, section.minutes.value * seconds_a_minute, wish_);
    if (section.fixed.value) return path::tour_in_order(museum_, building_, exhibits, wish_);
    return path::shortest_tour(museum_, building_, exhibits, {}, wish_);
  }

  void report_unreached(const config::TourSection& section, const path::MuseumTour& walked) {
    const config::Place& place = section.exhibits.place;
    if (walked.unreached.empty())
      return report_.add(config::diagnostic_at(
          config_, place, "tour-without-way",
          fmt::format("no order of tour '{}' can be walked: there is no way back from some of its "
                      "exhibits",
                      section.id.value),
          {}, "look for escalators that run one way only, and write a connection the other way"));
    const std::string& id = museum_.exhibits[walked.unreached.front()].id;
    Diagnostic diagnostic = config::diagnostic_at(
        config_, place, "tour-without-way",
        fmt::format("tour '{}' cannot be walked: there is no way to exhibit '{}'", section.id.value,
                    id),
        {},
        section.fixed.value ? fmt::format("from the exhibit before '{}', or from the kiosk; take "
                                          "it out, or leave fixed = true away",
                                          id)
                            : fmt::format("take '{}' out, or make a way to it", id));
    // Behind a door that is closed for a while it is only left out.
    const bool has_closed_door = std::ranges::any_of(
        config_.doors, [](const config::DoorSection& door) { return door.closed.value; });
    if (has_closed_door) diagnostic.severity = Severity::Warning;
    report_.add(std::move(diagnostic));
  }

  void report_too_short(const config::TourSection& section) {
    report_.add(config::diagnostic_at(
        config_, section.minutes.place, "tour-too-short",
        fmt::format("tour '{}' has no exhibit: none can be walked to and looked at in {:g} minutes",
                    section.id.value, section.minutes.value),
        {}, "give it more minutes, or name its exhibits"));
  }

  void warn_of_length(const config::TourSection& section, const path::MuseumTour& walked) {
    const double minutes = std::ceil(walked.seconds() / seconds_a_minute);
    Diagnostic diagnostic = config::diagnostic_at(
        config_, section.minutes.place, "tour-too-long",
        fmt::format("tour '{}' takes {:.0f} minutes, more than the {:g} that it says",
                    section.id.value, minutes, section.minutes.value),
        {},
        fmt::format("walking takes {:.0f} seconds and looking {:.0f}: write minutes = {:.0f}, or "
                    "take something out",
                    walked.walk_seconds, walked.looking_seconds, minutes));
    diagnostic.severity = Severity::Warning;
    report_.add(std::move(diagnostic));
  }

  const config::MuseumConfig& config_;
  Museum& museum_;
  Report& report_;
  path::BuildingMap building_;
  path::TourWish wish_;
};

}  // namespace

void compile_tours(const config::MuseumConfig& config,
                   std::span<const std::shared_ptr<const path::FloorMap>> maps, Museum& museum,
                   Report& report) {
  if (report.has_errors() || std::ranges::find(maps, nullptr) != maps.end()) return;
  TourCompiler compiler(config, maps, museum, report);
  for (const config::TourSection& section : config.tours) compiler.add(section);
  compiler.add_for_time();
}

}  // namespace docent::compile
