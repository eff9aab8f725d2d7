#include <span>
#include <string_view>

#include "platform/clock/monotonic_clock.h"
#include "runtime/kiosk/allocations.h"
#include "runtime/kiosk/hid_command.h"
#include "runtime/kiosk/kiosk.h"
#include "runtime/kiosk/options.h"

int main(int argc, char** argv) {
  const auto started = docent::monotonic_now();
  if (argc > 1 && std::string_view(argv[1]) == "hid")
    return docent::run_hid_command(std::span<const char* const>(argv, argv + argc).subspan(2));
  docent::prepare_allocator_for(docent::Phase::Start);
  const docent::CommandLine line = docent::parse_command_line(argc, argv);
  if (line.exit) return *line.exit;
  return docent::run_kiosk(line.options, started);
}
