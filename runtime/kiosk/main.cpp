#include <cstdio>
#include <exception>

#include "platform/clock/monotonic_clock.h"
#include "runtime/kiosk/kiosk.h"
#include "runtime/kiosk/options.h"

int main(int argc, char** argv) {
  const auto started = docent::monotonic_now();
  const docent::CommandLine line = docent::parse_command_line(argc, argv);
  if (line.exit) return *line.exit;
  return docent::run_kiosk(line.options, started);
}
