#include "config/today.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "config/fields.h"
#include "platform/terminal/suggest.h"

namespace docent::config {
namespace {

/// By Closable.
constexpr std::array<std::string_view, 4> closables{"door", "room", "connection", "exhibit"};
constexpr std::string_view entry_name = "[[closed]]";

std::vector<std::string_view> ids_of(Closable what, const Museum& museum) {
  std::vector<std::string_view> ids;
  const auto add = [&](const auto& things, auto member) {
    for (const auto& thing : things) ids.emplace_back(thing.*member);
  };
  switch (what) {
    case Closable::Door:
      for (const Floor& floor : museum.floors) add(floor.plan.doors, &Door::name);
      break;
    case Closable::Room:
      add(museum.rooms, &Room::id);
      break;
    case Closable::Connection:
      add(museum.connections, &Connection::id);
      break;
    case Closable::Exhibit:
      add(museum.exhibits, &Exhibit::id);
      break;
  }
  return ids;
}

class TodayReader {
 public:
  TodayReader(const std::string& file, const Museum& museum, std::vector<Diagnostic>& diagnostics)
      : file_(file), museum_(museum), diagnostics_(diagnostics) {}

  void read(const TomlNode& root, Today& today) {
    for (const TomlEntry& entry : root.entries) {
      if (entry.key != "closed") {
        error(entry.key_range, "unknown-key", fmt::format("today.toml has no '{}'", entry.key),
              "it may hold [[closed]]");
        continue;
      }
      if (entry.value.kind != TomlNode::Kind::Array) {
        error(entry.value.range, "wrong-type",
              "'closed' should be written [[closed]], once for each", "[[closed]]\ndoor = \"...\"");
        continue;
      }
      for (const TomlNode& item : entry.value.items) today.closed.push_back(closure(item));
    }
  }

 private:
  void error(SourceRange range, std::string code, std::string message, std::string hint) {
    diagnostics_.push_back({.file = file_,
                            .line = range.line,
                            .column = range.column,
                            .length = range.length,
                            .severity = Severity::Error,
                            .code = std::move(code),
                            .message = std::move(message),
                            .label = {},
                            .hint = std::move(hint)});
  }

  TodayClosure closure(const TomlNode& table) {
    TodayClosure read;
    if (table.kind != TomlNode::Kind::Table) {
      error(table.range, "wrong-type", "'closed' should hold tables", "[[closed]]\ndoor = \"...\"");
      return read;
    }
    int named = 0;
    for (const TomlEntry& entry : table.entries) {
      const auto what = std::ranges::find(closables, entry.key);
      if (what != closables.end()) {
        ++named;
        read.what = static_cast<Closable>(what - closables.begin());
        read_id(entry, read);
      } else if (entry.key == "until") {
        read_until(entry.value, read);
      } else if (entry.key == "reason") {
        read_reason(entry.value, read);
      } else {
        report_unknown(entry);
      }
    }
    if (named != 1)
      error(table.range, "missing-field",
            fmt::format("{} names {}", entry_name, named == 0 ? "nothing" : "several things"),
            "it holds one of: door, room, connection, exhibit");
    return read;
  }

  void report_unknown(const TomlEntry& entry) {
    const std::vector<std::string_view> known{"door",    "room",  "connection",
                                              "exhibit", "until", "reason"};
    const std::string_view meant = terminal::closest(entry.key, known);
    error(entry.key_range, "unknown-key", fmt::format("{} has no '{}'", entry_name, entry.key),
          meant.empty() ? fmt::format("it may hold {}", fmt::join(known, ", "))
                        : fmt::format("did you mean '{}'?", meant));
  }

  void read_id(const TomlEntry& entry, TodayClosure& read) {
    if (entry.value.kind != TomlNode::Kind::Text)
      return error(entry.value.range, "wrong-type",
                   fmt::format("'{}' should be a text in quotation marks", entry.key),
                   fmt::format("{} = \"...\"", entry.key));
    read.id = entry.value.text;
    const std::vector<std::string_view> ids = ids_of(read.what, museum_);
    if (std::ranges::find(ids, read.id) != ids.end()) return;
    const std::string_view meant = terminal::closest(read.id, ids);
    error(entry.value.range, "unknown-id",
          fmt::format("the museum has no {} '{}'", entry.key, read.id),
          meant.empty() ? fmt::format("docent-content compile knows the museum's {}s", entry.key)
                        : fmt::format("did you mean '{}'?", meant));
  }

  void read_until(const TomlNode& value, TodayClosure& read) {
    if (!value.date)
      return error(value.range, "wrong-type",
                   "'until' should be a day or a day and time by the museum's clock",
                   "until = 2026-12-24T18:00:00");
    namespace chr = std::chrono;
    read.until = value.has_time ? chr::ceil<chr::minutes>(*value.date)
                                : chr::ceil<chr::minutes>(*value.date + chr::days(1));
  }

  void read_reason(const TomlNode& value, TodayClosure& read) {
    const auto is_text = [](const TomlEntry& entry) {
      return entry.value.kind == TomlNode::Kind::Text;
    };
    if (value.kind != TomlNode::Kind::Table || !std::ranges::all_of(value.entries, is_text))
      return error(value.range, "wrong-type", "'reason' should be given by language",
                   "reason.en = \"...\"");
    for (const TomlEntry& entry : value.entries) read.reason[entry.key] = entry.value.text;
  }

  const std::string& file_;
  const Museum& museum_;
  std::vector<Diagnostic>& diagnostics_;
};

Loaded<Today> read_today(TomlFile toml, const std::string& name, const Museum& museum) {
  Loaded<Today> loaded{.value = std::nullopt, .diagnostics = std::move(toml.diagnostics)};
  if (!toml.root) return loaded;
  Today today;
  TodayReader(name, museum, loaded.diagnostics).read(*toml.root, today);
  if (loaded.diagnostics.empty()) loaded.value = std::move(today);
  return loaded;
}

}  // namespace

Loaded<Today> load_today(const std::filesystem::path& file, const Museum& museum) {
  return read_today(read_toml(file, file.string()), file.string(), museum);
}

Loaded<Today> parse_today(std::string_view text, const std::string& name, const Museum& museum) {
  return read_today(parse_toml(text, name), name, museum);
}

}  // namespace docent::config
