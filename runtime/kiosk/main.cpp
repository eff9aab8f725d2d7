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
    return docent::run_hid_command(std::span<const char* const>(argv, argv + argc).subspan(2));
  docent::prepare_allocator_for(docent::Phase::Start);
  const docent::CommandLine line = docent::parse_command_line(argc, argv);
  if (line.exit) return *line.exit;
  return docent::run_kiosk(line.options, started);
}

}  // namespace

int main(int argc, char** argv) {
  docent::expect_reloads();
  try {
    return run(argc, argv, docent::monotonic_now());
  } catch (const std::exception& error) {  // no memory, or a library's exception
    std::fprintf(stderr, "docent: it cannot go on (%s)\n", error.what());
    return docent::exit_code(docent::Errc::Environment);
  }
}
