#include <cstdio>
#include <exception>
#include <span>
#include <string_view>

#include "platform/clock/monotonic_clock.h"
#include "runtime/kiosk/allocations.h"
#include "runtime/kiosk/hid_command.h"
#include "runtime/kiosk/kiosk.h"
#include "runtime/kiosk/options.h"

namespace {

int run(int argc, char** argv, std::chrono::nanoseconds started) {
  if (argc > 1 && std::string_view(argv[1]) == "hid")
    return docent::kiosk::run_hid_command(
        std::span<const char* const>(argv, argv + argc).subspan(2));
  docent::kiosk::prepare_allocator_for(docent::kiosk::Phase::Start);
  const docent::kiosk::CommandLine line = docent::kiosk::parse_command_line(argc, argv);
  if (line.exit) return *line.exit;
  return docent::kiosk::run_kiosk(line.options, started);
}

}  // namespace

int main(int argc, char** argv) {
  docent::kiosk::expect_reloads();
  try {
    return run(argc, argv, docent::clock::monotonic_now());
  } catch (const std::exception& error) {  // no memory, or a library's exception
    std::fprintf(stderr, "docent: it cannot go on (%s)\n", error.what());
    return docent::exit_code(docent::Errc::Environment);
  }
}
