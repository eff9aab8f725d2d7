#include "runtime/kiosk/hid_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "platform/file/read_file.h"
#include "platform/hid/hid_devices.h"
#include "platform/hid/hid_report.h"
#include "runtime/input/decode_recording.h"
#include "runtime/model/result.h"

namespace docent::kiosk {
namespace {

constexpr int wrong_usage = 2;

int say(const Error& error) {
  fmt::print(stderr, "docent: {}\n", error.what);
  return exit_code(error.code);
}

int list(bool as_json) {
  std::vector<hid::HidDevice> devices = hid::list_hid_devices();
  hid::try_to_open(devices);
  fmt::print("{}", as_json ? hid::describe_devices_json(devices) : hid::describe_devices(devices));
  return 0;
}

int decode(const std::string& file) {
  const Result<std::string> text = file::read_file(file);
  if (!text) return say(text.error());
  const Result<input::HidRecording> recording = input::parse_hid_recording(*text, file);
  if (!recording) return say(recording.error());
  const Result<std::string> csv = input::decode_recording(*recording);
  if (!csv) return say({csv.error().code, file + ": " + csv.error().what});
  fmt::print("{}", *csv);
  return 0;
}

}  // namespace

int run_hid_command(std::span<const char* const> arguments) {
  const std::vector<std::string_view> words(arguments.begin(), arguments.end());
  const bool as_json = std::ranges::find(words, "--json") != words.end();
  if (!words.empty() && words[0] == "list" && words.size() == (as_json ? 2U : 1U))
    return list(as_json);
  if (words.size() == 2 && words[0] == "decode" && !as_json) return decode(std::string(words[1]));
  fmt::print(stderr,
             "usage: docent hid list [--json]\n"
             "       docent hid decode FILE.hid\n");
  const bool asked = !words.empty() && (words[0] == "--help" || words[0] == "-h");
  return asked ? 0 : wrong_usage;
}

}  // namespace docent::kiosk
