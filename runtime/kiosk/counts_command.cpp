#include "runtime/kiosk/counts_command.h"

#include <fmt/format.h>

#include <memory>
#include <string>

#include "runtime/kiosk/counts_folder.h"
#include "runtime/kiosk/options.h"

namespace docent::kiosk {
namespace {

constexpr const char* default_folder = "/var/lib/docent-counts";

int print_counts(const std::string& folder) {
  const Result<std::string> csv = published_csv(folder);
  if (!csv) return say(csv.error());
  fmt::print("{}", *csv);
  return 0;
}

}  // namespace

terminal::Command counts_command() {
  const auto folder = std::make_shared<std::string>(default_folder);
  return {
      .name = "counts",
      .manual =
          "prints the anonymous counts of all days that are over as CSV: day, kind, name, count",
      .options = {{"DIR", terminal::folder("DIR", *folder), "The folder of --counts",
                   terminal::Times::AtMostOnce, default_folder}},
      .run = [folder] { return print_counts(*folder); }};
}

}  // namespace docent::kiosk
