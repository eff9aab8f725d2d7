#include <cstdio>
#include <exception>
#include <span>

#include "config/diagnostic_text.h"
#include "platform/clock/monotonic_clock.h"
#include "runtime/kiosk/allocations.h"
#include "runtime/kiosk/kiosk.h"
#include "runtime/kiosk/options.h"

namespace {

int run(int argc, char** argv, std::chrono::nanoseconds started) {
  docent::kiosk::prepare_allocator_for(docent::kiosk::Phase::Start);
  docent::kiosk::Options options;
  const auto asked = docent::terminal::parse(
      docent::kiosk::program(options, [&] { return docent::kiosk::run_kiosk(options, started); }),
      std::span<const char* const>(argv, static_cast<std::size_t>(argc)).subspan(1));
  if (asked) return (*asked)();
  docent::config::tell({&asked.error(), 1});
  return docent::exit_code(docent::Errc::WrongUsage);
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
