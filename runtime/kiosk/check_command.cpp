#include "runtime/kiosk/check_command.h"

#include <fmt/format.h>

#include <memory>
#include <string>

#include "runtime/kiosk/exhibition.h"
#include "runtime/kiosk/options.h"

namespace docent::kiosk {
namespace {

int check(const std::string& database) {
  const Result<Museum> museum = read_museum(database);
  if (!museum) return say(museum.error(), journal::Message::Refused);
  fmt::print("{}: can be shown: {}\n", database, summary(*museum));
  return 0;
}

}  // namespace

terminal::Command check_command() {
  const auto database = std::make_shared<std::string>();
  return {.name = "check",
          .manual = "says whether a database can be shown, or why not",
          .options = {{"DB", terminal::file("DB", *database), "The compiled museum",
                       terminal::Times::Once}},
          .run = [database] { return check(*database); }};
}

}  // namespace docent::kiosk
