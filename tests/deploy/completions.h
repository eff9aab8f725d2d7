#pragma once

#include <string>

#include "platform/terminal/command_line.h"

/// A program's tables as what its shell offers at the Tab key.
namespace docent::test {

std::string bash_completion(const terminal::Command& program);
std::string zsh_completion(const terminal::Command& program);

}  // namespace docent::test
