#include "runtime/kiosk/kiosk_status.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <system_error>
#include <utility>

#include "platform/clock/monotonic_clock.h"
#include "platform/hid/hid_devices.h"
#include "platform/journal/journal.h"
#include "platform/terminal/command_line.h"
#include "runtime/kiosk/statistics.h"

namespace docent::kiosk {
namespace {

/// A JSON string. What is not UTF-8 was refused where it came in, or is a device's name, whose
/// bytes are left out.
std::string json_string(std::string_view text) {
  std::string out = "\"";
  for (const char letter : text)
    if (letter == '"' || letter == '\\')
      out += {'\\', letter};
    else if (static_cast<unsigned char>(letter) < ' ')
      out += fmt::format("\\u{:04x}", static_cast<int>(letter));
    else
      out += letter;
  return out + '"';
}

std::string_view kind_name(const hid::HidDevice& device) {
  if (device.kind.touch) return "touch screen";
  return device.kind.keys.empty() ? "ignored" : "keypad";
}

/// The files that this process has open.
std::vector<std::string> open_files() {
  std::vector<std::string> files;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd", error)) {
    const auto file = std::filesystem::read_symlink(entry.path(), error);
    if (!error) files.push_back(file.string());
  }
  return files;
}

std::optional<double> free_bytes_at(const std::filesystem::path& file) {
  std::error_code error;
  const auto space =
      std::filesystem::space(file.parent_path().empty() ? "." : file.parent_path(), error);
  return error ? std::nullopt : std::optional(static_cast<double>(space.available));
}

std::string text_of(const DeviceFacts& device) {
  return fmt::format("{}: {}, {}{}", device.path, device.name, device.kind,
                     device.is_used ? "" : ", not used");
}

}  // namespace

std::vector<DeviceFacts> devices_now() {
  const std::vector<std::string> files = open_files();
  std::vector<DeviceFacts> devices;
  for (const hid::HidDevice& device : hid::list_hid_devices())
    if (hid::is_for_visitors(device))
      devices.push_back({.path = device.path,
                         .name = device.name,
                         .kind = std::string(kind_name(device)),
                         .is_used = std::ranges::find(files, device.path) != files.end()});
  return devices;
}

std::string to_json(const KioskStatus& s) {
  std::string devices;
  for (const DeviceFacts& device : s.devices)
    devices += fmt::format(R"({}{{"path": {}, "name": {}, "kind": {}, "used": {}}})",
                           devices.empty() ? "" : ", ", json_string(device.path),
                           json_string(device.name), json_string(device.kind), device.is_used);
  return fmt::format(
      "{{\n  \"version\": {},\n  \"uptime_s\": {:.1f},\n  \"restarts\": {},\n  \"display\": {},\n"
      "  \"content\": {{\"path\": {}, \"museum\": {}, \"checksum\": {}, \"schema\": {}, "
      "\"signature\": {}}},\n"
      "  \"frames\": {},\n  \"dropped_frames\": {},\n  \"visits\": {},\n  \"touches\": {},\n"
      "  \"routes\": {},\n  \"refused_databases\": {},\n  \"devices\": [{}],\n  \"last_error\": "
      "{},\n  \"free_bytes\": {}\n}}\n",
      json_string(s.version), s.uptime_seconds, s.restarts ? fmt::to_string(*s.restarts) : "null",
      json_string(s.display), json_string(s.content.path.string()), json_string(s.content.museum),
      json_string(s.content.checksum), s.content.schema, json_string(s.content.signature),
      s.counts.frames, s.counts.dropped_frames, s.counts.visits, s.counts.touches, s.counts.routes,
      s.refusals.count, devices, s.last_error.empty() ? "null" : json_string(s.last_error),
      s.free_bytes ? fmt::format("{:.0f}", *s.free_bytes) : "null");
}

std::string to_text(const KioskStatus& s) {
  std::string text = fmt::format(
      "docent {}, for {:.0f} s{}, on {}\n"
      "shows '{}', from {} (schema {}, checksum {:.16}, signature: {})\n"
      "{} frames, {} dropped; {} visits, {} touches, {} routes\n",
      s.version, s.uptime_seconds,
      s.restarts && *s.restarts > 0 ? fmt::format(", restarted {} times", *s.restarts) : "",
      s.display, s.content.museum, s.content.path.string(), s.content.schema, s.content.checksum,
      s.content.signature, s.counts.frames, s.counts.dropped_frames, s.counts.visits,
      s.counts.touches, s.counts.routes);
  for (const DeviceFacts& device : s.devices) text += text_of(device) + "\n";
  if (s.devices.empty()) text += "no touch screen and no keypad\n";
  text +=
      s.last_error.empty() ? "no error since it started\n" : "last error: " + s.last_error + "\n";
  if (s.free_bytes)
    text += fmt::format("{:.0f} MB free where the database lies\n", *s.free_bytes / 1e6);
  return text;
}

StatusBoard::StatusBoard(std::chrono::nanoseconds started, std::string display)
    : begun_(started),
      started_(time_now()),
      display_(std::move(display)),
      restarts_(count_start(std::getenv("RUNTIME_DIRECTORY"))) {}

void StatusBoard::shows(ContentFacts content) {
  const std::lock_guard lock(mutex_);  // held elsewhere for as long as it takes to copy a few words
  content_ = std::move(content);
}

void StatusBoard::refused(Errc why) {
  const std::lock_guard lock(mutex_);
  ++refusals_.count;
  refusals_.last = why;
}

KioskStatus StatusBoard::read() {
  KioskStatus status;
  status.version = terminal::version();
  status.started = started_;
  status.uptime_seconds = std::chrono::duration<double>(clock::monotonic_now() - begun_).count();
  status.restarts = restarts_;
  status.display = display_;
  {
    const std::lock_guard lock(reading_);
    if (const auto news = counts_.take()) last_counts_ = *news;
    status.counts = last_counts_;
  }
  {
    const std::lock_guard lock(mutex_);
    status.content = content_;
    status.refusals = refusals_;
  }
  status.last_error = journal::last_problem();
  status.free_bytes = free_bytes_at(status.content.path);
  return status;
}

double time_now() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

std::filesystem::path status_socket() {
  if (const char* service = std::getenv("RUNTIME_DIRECTORY"))
    return std::filesystem::path(service) / "status";
  if (const char* user = std::getenv("XDG_RUNTIME_DIR"))
    return std::filesystem::path(user) / "docent" / "status";
  return {};
}

std::optional<std::uint64_t> count_start(const char* runtime_directory) {
  if (runtime_directory == nullptr) return std::nullopt;
  const std::filesystem::path file = std::filesystem::path(runtime_directory) / "starts";
  std::uint64_t starts = 0;
  std::ifstream(file) >> starts;
  if (!write_whole(file, fmt::format("{}\n", starts + 1))) return std::nullopt;
  return starts;
}

}  // namespace docent::kiosk
