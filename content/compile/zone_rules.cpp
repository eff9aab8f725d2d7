#include "content/compile/zone_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "platform/terminal/suggest.h"
#include "runtime/model/hours/time_zone.h"

namespace docent::compile {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view tables = "/usr/share/zoneinfo";

/// "Europe/Berlin", and nothing that leads out of the tables.
bool is_zone_name(std::string_view name) {
  const auto is_plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '/' ||
           c == '_' || c == '-' || c == '+';
  };
  return !name.empty() && name.front() != '/' && std::ranges::all_of(name, is_plain);
}

std::string bytes_of(const fs::path& file) {
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) return {};
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// "Did you mean": of the zones of the machine's tables.
std::string hint_for(const std::string& name) {
  std::error_code failed;
  std::vector<std::string> known;
  for (fs::recursive_directory_iterator entry(tables, failed);
       !failed && entry != fs::recursive_directory_iterator(); entry.increment(failed)) {
    const std::string zone = fs::relative(entry->path(), tables, failed).string();
    if (zone.find('/') != std::string::npos && !zone.starts_with("posix") &&
        !zone.starts_with("right"))
      known.push_back(zone);
  }
  if (known.empty())
    return "this machine has no tables of time zones: install tzdata, or write the rules, such as "
           "\"CET-1CEST,M3.5.0,M10.5.0/3\"";
  std::ranges::sort(known);
  const std::vector<std::string_view> names(known.begin(), known.end());
  const std::string_view meant = terminal::closest(name, names);
  return meant.empty() ? "a zone is called as in \"Europe/Berlin\""
                       : fmt::format("did you mean \"{}\"?", meant);
}

}  // namespace

std::string rules_of_table(std::string_view bytes) {
  if (!bytes.starts_with("TZif") || !bytes.ends_with('\n')) return {};
  bytes.remove_suffix(1);
  const std::size_t line = bytes.rfind('\n');
  return line == std::string_view::npos ? std::string() : std::string(bytes.substr(line + 1));
}

std::string zone_rules(const config::MuseumConfig& config, Report& report) {
  const config::Located<std::string>& written = config.museum.time_zone;
  if (!written.given) return {};
  if (written.value != "UTC" && parse_time_zone(written.value)) return written.value;
  if (is_zone_name(written.value)) {
    std::string rules = rules_of_table(bytes_of(fs::path(tables) / written.value));
    if (parse_time_zone(rules)) return rules;
  }
  if (written.value == "UTC") return "UTC0";
  report.add(config::diagnostic_at(config, written.place, "unknown-time-zone",
                                   fmt::format("there is no time zone '{}'", written.value), {},
                                   hint_for(written.value)));
  return {};
}

}  // namespace docent::compile
