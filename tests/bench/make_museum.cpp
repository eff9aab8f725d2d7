// Writes a large museum's folder, as its staff would have written it: docent-content compile takes
// it from there.

#include <CLI/CLI.hpp>

#include "tests/support/large_museum.h"

int main(int count, char** arguments) {
  CLI::App app("Writes a museum of many floors and exhibits.");
  std::string folder;
  std::size_t floors = 12, exhibits = 5000;
  app.add_option("folder", folder)->required();
  app.add_option("--floors", floors)->check(CLI::PositiveNumber);
  app.add_option("--exhibits", exhibits)->check(CLI::PositiveNumber);
  CLI11_PARSE(app, count, arguments);
  docent::test::LargeMuseum(folder, floors, exhibits);
}
