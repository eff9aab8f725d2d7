#pragma once

#include <optional>
#include <string>
#include <vector>

#include "platform/terminal/command_line.h"

namespace docent::terminal {

/// A program with something of everything that a table may hold.
struct Kitchen {
  std::vector<std::string> pots;
  std::string dish;
  std::optional<double> minutes;
  unsigned cooks = 1;
  std::vector<double> salt;
  bool hot = false, loud = false;
  int ran = 0;

  Command program() {
    Command boil{
        .name = "boil",
        .manual = "boils what is in pots",
        .options = {{"POT", file("POT", pots), "What is in it", Times::AtLeastOnce},
                    {"-o,--output", file("DISH", dish), "Where it goes", Times::Once},
                    {"--minutes", number("M", positive, minutes), "How long", Times::AtMostOnce,
                     "until it is done"},
                    {"--cooks", number("N", {Limits::Of::WholeNumbers, 1, 8}, cooks), "Cooks"},
                    {"--salt", number("G", {.least = 0, .most = 10}, salt), "A pinch, grams",
                     Times::AnyNumber},
                    {"--hot,!--no-hot", flag(hot), "Serve it hot"},
                    {"--loud", flag(loud), "Sing"}},
        .run = [this] { return 40 + ++ran; }};
    return {.name = "kitchen",
            .manual = "cooks",
            .commands = {std::move(boil),
                         {.name = "rinse", .manual = "rinses", .run = [] { return 7; }}},
            .sections = {exit_codes()}};
  }
};

}  // namespace docent::terminal
