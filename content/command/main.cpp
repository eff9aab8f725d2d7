#include <algorithm>
#include <exception>
#include <span>
#include <string_view>

#include "config/diagnostic_text.h"
#include "content/command/commands.h"
#include "content/content_error.h"

namespace {

/// Did the user ask for JSON? Known before the command line is understood, so that every failure is
/// told as asked.
docent::config::DiagnosticForm form_of(std::span<const char* const> arguments) {
  const bool json = std::ranges::any_of(
      arguments, [](const char* argument) { return std::string_view(argument) == "--json"; });
  return json ? docent::config::DiagnosticForm::Json : docent::config::DiagnosticForm::Text;
}

int fail(const docent::Diagnostic& diagnostic, docent::Errc kind,
         docent::config::DiagnosticForm form) {
  docent::config::tell({&diagnostic, 1}, form);
  return docent::exit_code(kind);
}

int run(std::span<const char* const> arguments) {
  const auto asked = docent::terminal::parse(docent::command::program(), arguments);
  if (!asked) return fail(asked.error(), docent::Errc::WrongUsage, form_of(arguments));
  return (*asked)();
}

}  // namespace

int main(int argc, char** argv) {
  const auto arguments =
      std::span<const char* const>(argv, static_cast<std::size_t>(argc)).subspan(1);
  try {
    return run(arguments);
  } catch (const docent::content::ContentError& error) {
    return fail(docent::content::to_diagnostic(error), error.kind, form_of(arguments));
  } catch (const std::exception& error) {
    return fail({.file = "docent-content", .code = "cannot-go-on", .message = error.what()},
                docent::Errc::Environment, form_of(arguments));
  }
}
