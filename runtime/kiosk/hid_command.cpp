#include "runtime/kiosk/hid_command.h"

#include <fmt/format.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "config/diagnostic_text.h"
#include "platform/file/read_file.h"
#include "platform/file/text_encoding.h"
#include "platform/hid/hid_devices.h"
#include "platform/hid/hid_report.h"
#include "runtime/input/decode_recording.h"
#include "runtime/kiosk/options.h"
#include "runtime/model/result.h"

namespace docent::kiosk {
namespace {

int list(bool as_json) {
  std::vector<hid::HidDevice> devices = hid::list_hid_devices();
  const auto config = config::load_kiosk_config(default_config);
  config::tell(config.diagnostics);
  if (config.value) hid::refuse_all_but(named_keypads(*config.value), devices);
  hid::try_to_open(devices);
  fmt::print("{}", as_json ? hid::describe_devices_json(devices) : hid::describe_devices(devices));
  return 0;
}

int decode(const std::string& file) {
  const Result<std::string> text = file::read_file(file);
  if (!text) return say(text.error());
  if (const auto fault = file::wide_encoding(*text))
    return say({Errc::InvalidInput, fmt::format("{}: {}; {}", file, fault->message, fault->hint)});
  const Result<input::HidRecording> recording =
      input::parse_hid_recording(file::without_byte_order_mark(*text), file);
  if (!recording) return say(recording.error());
  const Result<std::string> csv = input::decode_recording(*recording);
  if (!csv) return say({csv.error().code, file + ": " + csv.error().what});
  fmt::print("{}", *csv);
  return 0;
}

std::vector<input::KeyMeaning> meanings_of(const config::LocatedTexts& keys) {
  std::vector<input::KeyMeaning> meanings;
  for (const auto& [sent, meant] : keys)
    meanings.push_back({input::key_from_string(sent), input::key_from_string(meant.value)});
  return meanings;
}

StaffWord word_for(const hid::HidDevice& device) {
  if (!hid::is_for_visitors(device)) return StaffWord::Ignored;
  return device.kind.touch ? StaffWord::TouchScreen : StaffWord::Keypad;
}

}  // namespace

std::vector<StaffFact> device_facts(std::span<const input::NamedKeypad> keypads,
                                    const StaffWords& words) {
  std::vector<hid::HidDevice> devices = hid::list_hid_devices();
  hid::refuse_all_but(keypads, devices);
  std::vector<StaffFact> facts;
  for (const hid::HidDevice& device : devices)
    facts.push_back(
        {.label = std::string(words[word_for(device)]),
         .value = fmt::format("{:04x}:{:04x} {}{}{}", device.vendor, device.product, device.name,
                              hid::reason_of(device).empty() ? "" : ": ", hid::reason_of(device)),
         .is_of_machine = true});
  if (facts.empty())
    facts.push_back({.label = std::string(words[StaffWord::Devices]),
                     .value = std::string(words[StaffWord::NoDevices])});
  return facts;
}

std::vector<input::NamedKeypad> named_keypads(const config::KioskConfig& config) {
  std::vector<input::NamedKeypad> keypads;
  for (const config::KeypadSection& section : config.keypads)
    if (const auto id = input::device_id_from(section.device.value))
      keypads.push_back({*id, input::descriptor_hash_from(section.descriptor.value),
                         meanings_of(section.keys.value)});
  return keypads;
}

terminal::Command hid_command() {
  struct HidOptions {
    bool json = false;
    std::string recording;
  };
  const auto options = std::make_shared<HidOptions>();
  terminal::Command list_devices{
      .name = "list",
      .manual = "lists the hidraw devices present, and what each is taken for",
      .options = {{"--json", terminal::flag(options->json), "Print the list as JSON"}},
      .run = [options] { return list(options->json); }};
  terminal::Command decode_file{
      .name = "decode",
      .manual = "prints what a recorded device said, as CSV",
      .options = {{"FILE", terminal::file("FILE", options->recording),
                   "A recording in the text form of hid-recorder", terminal::Times::Once}},
      .run = [options] { return decode(options->recording); }};
  return {.name = "hid",
          .manual = "tells of touch screens and keypads",
          .commands = {std::move(list_devices), std::move(decode_file)}};
}

}  // namespace docent::kiosk
