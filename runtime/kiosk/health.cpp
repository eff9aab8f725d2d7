#include "runtime/kiosk/health.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <system_error>

#include "platform/file/read_file.h"

namespace docent::kiosk {
namespace {

constexpr std::string_view starts_metric = "docent_starts_total";

/// A label's value as the text format writes it: backslash, quote and line end escaped.
std::string quoted(std::string_view text) {
  std::string value;
  for (const char c : text) {
    if (c == '\\' || c == '"') value += '\\';
    value += c == '\n' ? ' ' : c;
  }
  return '"' + value + '"';
}

/// Lines of metrics, each with what it is.
class Page {
 public:
  void about(std::string_view name, std::string_view type, std::string_view help) {
    text_ += fmt::format("# HELP {0} {2}\n# TYPE {0} {1}\n", name, type, help);
  }
  void number(std::string_view name, double value) { text_ += fmt::format("{} {}\n", name, value); }
  void number(std::string_view name, std::string_view label, std::string_view of, double value) {
    text_ += fmt::format("{}{{{}={}}} {}\n", name, label, quoted(of), value);
  }
  void gauge(std::string_view name, std::string_view help, double value) {
    about(name, "gauge", help);
    number(name, value);
  }
  void counter(std::string_view name, std::string_view help, std::uint64_t value) {
    about(name, "counter", help);
    number(name, static_cast<double>(value));
  }
  std::string text() && { return std::move(text_); }

 private:
  std::string text_;
};

std::string_view name_of(Errc error) {
  switch (error) {
    case Errc::InvalidInput:
      return "invalid-input";
    case Errc::WrongUsage:
      return "wrong-usage";
    case Errc::Environment:
      return "environment";
    case Errc::NotFound:
      return "not-found";
    case Errc::WrongVersion:
      return "wrong-version";
    case Errc::Damaged:
      return "damaged";
  }
  return "unknown";
}

void add_cells(const PublishedCounts& day, Page& page) {
  using Kind = CountedCell::Kind;
  constexpr std::string_view help =
      "Visits of the last day that is over; what has fewer than 5 is left out";
  for (const Kind kind : {Kind::Exhibit, Kind::Route, Kind::Language}) {
    const std::string name = fmt::format("docent_day_{}_visits", to_string(kind));
    page.about(name, "gauge", help);
    for (const auto& [cell, count] : day.cells)
      if (cell.kind == kind)
        page.number(name, to_string(kind), cell.name, static_cast<double>(count));
  }
}

void add_day(const PublishedCounts& day, Page& page) {
  page.about("docent_day_info", "gauge", "The last day that is over, to which docent_day_* belong");
  page.number("docent_day_info", "day", day.day, 1);
  if (day.visits == 0) return;
  page.gauge("docent_day_visits", "Visits of the last day that is over",
             static_cast<double>(day.visits));
  if (day.touches > 0)
    page.gauge("docent_day_touches", "Touches of the last day that is over",
               static_cast<double>(day.touches));
  add_cells(day, page);
}

}  // namespace

std::string to_prometheus(const Health& health, const std::optional<PublishedCounts>& last_day) {
  const KioskStatus& status = health.status;
  Page page;
  page.gauge("docent_up", "Whether the kiosk runs; 0 after it was told to end",
             health.is_up ? 1 : 0);
  page.gauge("docent_start_time_seconds", "When it started", status.started);
  page.counter(starts_metric, "How often it was started since the machine was", health.starts);
  page.counter("docent_frames_total", "Frames made since it started", status.counts.frames);
  page.counter("docent_dropped_frames_total", "Frames that the screen missed since it started",
               status.counts.dropped_frames);
  page.gauge("docent_last_frame_time_seconds", "When the last frame was made",
             status.counts.last_frame);
  page.about("docent_content_info", "gauge", "The museum on the screen");
  page.number("docent_content_info", "museum", status.content.museum, 1);
  page.gauge("docent_content_time_seconds", "When its database was written",
             status.content.written);
  page.counter("docent_refused_databases_total",
               "Databases that were not taken up since it started", status.refusals.count);
  if (status.refusals.last) {
    page.about("docent_last_error_info", "gauge", "What kind of mistake the last one was");
    page.number("docent_last_error_info", "class", name_of(*status.refusals.last), 1);
  }
  if (status.free_bytes)
    page.gauge("docent_content_free_bytes", "Free space beside the database", *status.free_bytes);
  if (health.temperature)
    page.gauge("docent_temperature_celsius", "The hottest sensor", *health.temperature);
  if (last_day) add_day(*last_day, page);
  return std::move(page).text();
}

std::uint64_t starts_told_in(std::string_view text) noexcept {
  while (!text.empty()) {
    std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    if (!line.starts_with(starts_metric)) continue;
    line.remove_prefix(std::min(starts_metric.size() + 1, line.size()));
    std::uint64_t starts = 0;
    std::from_chars(line.data(), line.data() + line.size(), starts);
    return starts;
  }
  return 0;
}

std::optional<double> hottest_sensor(const std::filesystem::path& folder) {
  std::optional<double> hottest;
  std::error_code ignored;  // a machine without sensors has no such folder
  for (std::filesystem::directory_iterator entry(folder, ignored);
       !ignored && entry != std::filesystem::directory_iterator(); entry.increment(ignored)) {
    if (!entry->path().filename().string().starts_with("thermal_zone")) continue;
    const Result<std::string> text = file::read_file(entry->path() / "temp", 64);
    long thousandths = 0;
    if (!text ||
        std::from_chars(text->data(), text->data() + text->size(), thousandths).ec != std::errc{})
      continue;
    hottest = std::max(hottest.value_or(-273.15), static_cast<double>(thousandths) / 1000);
  }
  return hottest;
}

}  // namespace docent::kiosk
