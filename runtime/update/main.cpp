#include <cstdio>
#include <exception>
#include <span>

#include "config/diagnostic_text.h"
#include "runtime/model/result.h"
#include "runtime/update/options.h"

namespace {

int run(int argc, char** argv) {
  docent::update::Options options;
  const auto asked = docent::terminal::parse(
      docent::update::program(options, [&] { return docent::update::run_update(options); }),
      std::span<const char* const>(argv, static_cast<std::size_t>(argc)).subspan(1));
  if (asked) return (*asked)();
  docent::config::tell({&asked.error(), 1});
  return docent::exit_code(docent::Errc::WrongUsage);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {  // no memory, or a library's exception
    std::fprintf(stderr, "docent-update: it cannot go on (%s)\n", error.what());
    return docent::exit_code(docent::Errc::Environment);
  }
}
