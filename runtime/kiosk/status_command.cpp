#include "runtime/kiosk/status_command.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "platform/service/status_socket.h"
#include "runtime/kiosk/kiosk_status.h"
#include "runtime/kiosk/options.h"

namespace docent::kiosk {
namespace {

constexpr const char* of_the_service = "/run/docent/status";

/// A kiosk that this user runs by hand, else the service.
Result<std::string> ask_whoever_runs(std::string_view question) {
  if (const std::filesystem::path mine = status_socket(); !mine.empty())
    if (Result<std::string> answer = service::ask(mine, question);
        answer || answer.error().code != Errc::NotFound)
      return answer;
  return service::ask(of_the_service, question);
}

int tell_status(bool as_json) {
  const Result<std::string> answer = ask_whoever_runs(as_json ? "json" : "text");
  if (answer) {
    fmt::print("{}", *answer);
    return 0;
  }
  if (answer.error().code == Errc::NotFound) {
    fmt::print(stderr,
               "docent: no kiosk runs here; `systemctl status docent` says how the last one "
               "ended\n");
    return exit_code(Errc::InvalidInput);
  }
  fmt::print(stderr, "docent: {}; ask as root or as a member of the group docent\n",
             answer.error().what);
  return exit_code(answer.error().code);
}

}  // namespace

terminal::Command status_command() {
  const auto as_json = std::make_shared<bool>(false);
  return {.name = "status",
          .manual = "tells how the running kiosk is: content, frames, devices, last error",
          .options = {{"--json", terminal::flag(*as_json), "Print it as one JSON object"}},
          .run = [as_json] { return tell_status(*as_json); }};
}

}  // namespace docent::kiosk
