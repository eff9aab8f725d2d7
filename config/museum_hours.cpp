#include "config/museum_hours.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "runtime/model/hours/opening_hours.h"

namespace docent::config {
namespace {

class HoursChecker {
 public:
  HoursChecker(const MuseumConfig& config, std::vector<Diagnostic>& diagnostics)
      : config_(config), diagnostics_(diagnostics) {}

  void check_all(const auto& sections) {
    for (const auto& section : sections)
      if (section.hours.given) check(section.hours);
  }

  void check_holidays() {
    for (const Located<std::string>& day : config_.museum.holidays.value)
      if (const auto dates = parse_dates(day.value); !dates)
        diagnostics_.push_back(diagnostic_at(
            config_, day.place, "bad-hours",
            fmt::format("the holiday \"{}\" cannot be read: {}", day.value, dates.error().what),
            fmt::format("at its letter {}", dates.error().column), dates.error().hint));
  }

 private:
  void check(const Located<std::string>& written) {
    const auto hours = parse_opening_hours(written.value);
    if (!hours) return report(written, hours.error());
    if (!std::ranges::all_of(hours->rules, &OpeningHours::Rule::is_off)) return;
    Diagnostic diagnostic = diagnostic_at(
        config_, written.place, "never-open", "these hours are never open", "each rule is 'off'",
        fmt::format("what is open at other times begins with \"24/7; \"; what is never open is "
                    "closed = true"));
    diagnostic.severity = Severity::Warning;
    diagnostics_.push_back(std::move(diagnostic));
  }

  void report(const Located<std::string>& written, const HoursError& error) {
    Place place = written.place;
    place.range.column += static_cast<std::uint32_t>(error.column);  // and a quotation mark
    place.range.length = 1;
    diagnostics_.push_back(diagnostic_at(config_, place, "bad-hours",
                                         fmt::format("'hours' cannot be read: {}", error.what), {},
                                         error.hint));
  }

  const MuseumConfig& config_;
  std::vector<Diagnostic>& diagnostics_;
};

}  // namespace

void check_hours(const MuseumConfig& config, std::vector<Diagnostic>& diagnostics) {
  HoursChecker checker(config, diagnostics);
  checker.check_holidays();
  checker.check_all(config.rooms);
  checker.check_all(config.doors);
  checker.check_all(config.connections);
  checker.check_all(config.exhibits);
}

}  // namespace docent::config
