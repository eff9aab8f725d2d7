#include "runtime/model/hours/time_zone.h"

#include <algorithm>

namespace docent {
namespace {

namespace chr = std::chrono;

/// Reads the TZ variable of POSIX.1-2017, chapter 8.3, with times of up to a week (RFC 8536).
class ZoneParser {
 public:
  explicit ZoneParser(std::string_view text) : rest_(text) {}

  std::optional<TimeZone> zone() {
    TimeZone zone;
    skip_name();
    zone.standard = -offset();
    zone.daylight = zone.standard + chr::hours(1);
    if (sound_ && !rest_.empty()) {
      zone.has_daylight = true;
      skip_name();
      if (!rest_.empty() && rest_[0] != ',') zone.daylight = -offset();
      expect(',');
      zone.begin = change();
      expect(',');
      zone.end = change();
    }
    if (!sound_ || !rest_.empty()) return std::nullopt;
    return zone;
  }

 private:
  bool take(char sign) {
    if (rest_.empty() || rest_[0] != sign) return false;
    rest_.remove_prefix(1);
    return true;
  }
  void expect(char sign) { sound_ = take(sign) && sound_; }

  void skip_name() {
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    if (take('<')) {
      const std::size_t end = rest_.find('>');
      if (end == std::string_view::npos) return void(sound_ = false);
      rest_.remove_prefix(end + 1);
      return;
    }
    const auto end = std::ranges::find_if_not(rest_, is_letter);
    sound_ = end - rest_.begin() >= 3 && sound_;
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.begin()));
  }

  int number(int least, int most) {
    int value = 0;
    std::size_t count = 0;
    for (; count < rest_.size() && count < 3 && rest_[count] >= '0' && rest_[count] <= '9'; ++count)
      value = 10 * value + (rest_[count] - '0');
    sound_ = count > 0 && value >= least && value <= most && sound_;
    rest_.remove_prefix(count);
    return value;
  }

  /// "-1", "5:30", "167:00:00".
  chr::seconds clock(int most_hours) {
    const bool is_negative = take('-');
    if (!is_negative) take('+');
    chr::seconds time = chr::hours(number(0, most_hours));
    if (take(':')) time += chr::minutes(number(0, 59));
    if (take(':')) time += chr::seconds(number(0, 59));
    return is_negative ? -time : time;
  }
  chr::seconds offset() { return clock(24); }

  TimeZone::Change change() {
    TimeZone::Change read;
    if (take('M')) {
      read.month = number(1, 12);
      expect('.');
      read.week = number(1, 5);
      expect('.');
      read.day = number(0, 6);
    } else if (take('J')) {
      read.kind = TimeZone::Change::Kind::JulianDay;
      read.day = number(1, 365);
    } else {
      read.kind = TimeZone::Change::Kind::DayOfYear;
      read.day = number(0, 365);
    }
    if (take('/')) read.time = clock(167);
    return read;
  }

  std::string_view rest_;
  bool sound_ = true;
};

chr::local_days day_of(const TimeZone::Change& change, chr::year year) noexcept {
  using Kind = TimeZone::Change::Kind;
  const chr::local_days new_year{year / chr::January / 1};
  switch (change.kind) {
    case Kind::JulianDay: {  // 1 March is always day 60
      const bool after_february = year.is_leap() && change.day >= 60;
      return new_year + chr::days(change.day - 1 + (after_february ? 1 : 0));
    }
    case Kind::DayOfYear:
      return new_year + chr::days(change.day);
    case Kind::MonthWeekDay:
      break;
  }
  const chr::month month(static_cast<unsigned>(change.month));
  const chr::weekday weekday(static_cast<unsigned>(change.day));
  if (change.week == 5) return chr::local_days(year / month / weekday[chr::last]);
  return chr::local_days(year / month / weekday[static_cast<unsigned>(change.week)]);
}

/// When a change of a year happens, by the clock that goes `offset` east of Greenwich until then.
chr::sys_seconds moment_of(const TimeZone::Change& change, chr::year year,
                           chr::seconds offset) noexcept {
  return chr::sys_seconds((day_of(change, year) + change.time - offset).time_since_epoch());
}

bool is_daylight(const TimeZone& zone, chr::sys_seconds at) noexcept {
  if (!zone.has_daylight) return false;
  // The last change before the moment decides; those of the years beside count near a year's end.
  const chr::year_month_day date(chr::floor<chr::days>(at));
  std::optional<chr::sys_seconds> last;
  bool is_on = false;
  for (const int years : {-1, 0, 1}) {
    const chr::year year = date.year() + chr::years(years);
    const auto begin = moment_of(zone.begin, year, zone.standard);
    const auto end = moment_of(zone.end, year, zone.daylight);
    if (begin <= at && (!last || begin >= *last)) {
      last = begin;
      is_on = true;
    }
    if (end <= at && (!last || end > *last)) {
      last = end;
      is_on = false;
    }
  }
  return is_on;
}

}  // namespace

std::optional<TimeZone> parse_time_zone(std::string_view posix) {
  return ZoneParser(posix).zone();
}

chr::local_seconds local_time(const TimeZone& zone, chr::sys_seconds at) noexcept {
  const chr::seconds offset = is_daylight(zone, at) ? zone.daylight : zone.standard;
  return chr::local_seconds(at.time_since_epoch() + offset);
}

chr::sys_seconds system_time(const TimeZone& zone, chr::local_seconds at) noexcept {
  // The larger offset is the earlier moment.
  const auto [least, most] = std::minmax(zone.standard, zone.daylight);
  for (const chr::seconds offset : {most, least}) {
    const chr::sys_seconds moment(at.time_since_epoch() - offset);
    if (local_time(zone, moment) == at) return moment;
  }
  return chr::sys_seconds(at.time_since_epoch() - least);
}

LocalMinute local_minute(const TimeZone& zone, chr::sys_seconds at) noexcept {
  return chr::floor<chr::minutes>(local_time(zone, at));
}

}  // namespace docent
