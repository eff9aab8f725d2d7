#include "runtime/kiosk/counts_folder.h"

#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <system_error>
#include <utility>

#include "platform/file/read_file.h"
#include "runtime/kiosk/statistics.h"

namespace docent::kiosk {
namespace {

constexpr std::size_t largest_day = std::size_t{1} << 20U;
constexpr std::string_view open_name = "open";

std::optional<std::chrono::sys_days> day_of(std::string_view text) {
  int year = 0;
  unsigned month = 0, day = 0;
  const char* const begin = text.data();
  const auto whole = [](std::from_chars_result read, const char* end) {
    return read.ec == std::errc{} && read.ptr == end;
  };
  if (text.size() != 10 || text[4] != '-' || text[7] != '-' ||
      !whole(std::from_chars(begin, begin + 4, year), begin + 4) ||
      !whole(std::from_chars(begin + 5, begin + 7, month), begin + 7) ||
      !whole(std::from_chars(begin + 8, begin + 10, day), begin + 10))
    return std::nullopt;
  const std::chrono::year_month_day date{std::chrono::year(year), std::chrono::month(month),
                                         std::chrono::day(day)};
  return date.ok() ? std::optional(std::chrono::sys_days(date)) : std::nullopt;
}

/// The published days of a folder, the first first.
std::vector<std::filesystem::path> published_days(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> days;
  std::error_code ignored;  // a folder that is not there holds no days
  for (std::filesystem::directory_iterator entry(folder, ignored);
       !ignored && entry != std::filesystem::directory_iterator(); entry.increment(ignored))
    if (entry->path().extension() == ".csv" && day_of(entry->path().stem().string()))
      days.push_back(entry->path());
  std::ranges::sort(days);
  return days;
}

void remove_days_before(const std::filesystem::path& folder, std::string_view today) {
  const std::optional<std::chrono::sys_days> now = day_of(today);
  for (const std::filesystem::path& file : published_days(folder)) {
    const auto day = day_of(file.stem().string());
    if (!now || !day || *now - *day <= std::chrono::days(days_kept)) continue;
    std::error_code ignored;
    std::filesystem::remove(file, ignored);
  }
}

}  // namespace

Result<void> replace_text(const std::filesystem::path& file, std::string_view text,
                          Readers readers) {
  using std::filesystem::perms;
  const std::filesystem::path beside = file.string() + ".new";
  Result<void> written = write_whole(beside, text);
  if (!written) return written;
  std::error_code error;
  perms wanted = perms::owner_read | perms::owner_write;
  if (readers == Readers::Everybody) wanted |= perms::group_read | perms::others_read;
  std::filesystem::permissions(beside, wanted, error);
  if (!error) std::filesystem::rename(beside, file, error);
  if (!error) return {};
  std::error_code ignored;
  std::filesystem::remove(beside, ignored);
  return std::unexpected(Error{Errc::Environment, fmt::format("{}: cannot be written ({})",
                                                              file.string(), error.message())});
}

std::optional<PublishedCounts> published_counts_from(std::string_view text) {
  // The same lines as an open day's, with one more, the sum of visits, which is told again.
  std::string rest(counts_header);
  if (!text.starts_with(counts_header)) return std::nullopt;
  text.remove_prefix(counts_header.size());
  while (!text.empty()) {
    const std::string_view line = text.substr(0, std::min(text.find('\n'), text.size() - 1) + 1);
    text.remove_prefix(line.size());
    if (line.find(",visits,,") == std::string_view::npos) rest += line;
  }
  const std::optional<DailyCounts> day = daily_counts_from(rest);
  return day ? std::optional(published(*day)) : std::nullopt;
}

CountsFolder::CountsFolder(std::filesystem::path folder) : folder_(std::move(folder)) {
  if (const auto text = file::read_file(folder_ / open_name, largest_day))
    open_ = daily_counts_from(*text).value_or(DailyCounts{});
  written_ = open_;
  const std::vector<std::filesystem::path> days = published_days(folder_);
  if (days.empty()) return;
  if (const auto text = file::read_file(days.back(), largest_day))
    last_ = published_counts_from(*text);
}

/// The published file comes first: killed in between, the next start finds that it is there, and
/// drops the day that was still open.
Result<void> CountsFolder::close_day(std::string_view today) {
  const std::filesystem::path file = folder_ / (open_.day + ".csv");
  if (!file::is_there(file)) {
    const PublishedCounts told = published(open_);
    const Result<void> written =
        replace_text(file, std::string(counts_header) + to_csv(told), Readers::Everybody);
    if (!written) return written;
    last_ = told;
  }
  remove_days_before(folder_, today);
  open_ = {.day = std::string(today), .touches = 0, .visits = {}};
  return {};
}

Result<void> CountsFolder::take(std::string_view today, const DailyCounts& more) {
  Result<void> closed;
  if (open_.day.empty() || today < open_.day) open_.day = today;
  if (today > open_.day) closed = close_day(today);
  open_ += more;
  if (!closed || open_ == written_) return closed;
  Result<void> written = replace_text(folder_ / open_name, to_text(open_), Readers::Owner);
  if (written) written_ = open_;
  return written;
}

Result<std::string> published_csv(const std::filesystem::path& folder) {
  if (!file::is_folder(folder))
    return std::unexpected(
        Error{Errc::NotFound,
              folder.string() +
                  ": there is no such folder; docent --counts names where counts are kept"});
  std::string csv(counts_header);
  for (const std::filesystem::path& day : published_days(folder)) {
    const Result<std::string> text = file::read_file(day, largest_day);
    if (!text) return std::unexpected(text.error());
    if (text->starts_with(counts_header)) csv += text->substr(counts_header.size());
  }
  return csv;
}

std::string today() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm local{};
  localtime_r(&now, &local);
  return fmt::format("{:04}-{:02}-{:02}", local.tm_year + 1900, local.tm_mon + 1, local.tm_mday);
}

}  // namespace docent::kiosk
