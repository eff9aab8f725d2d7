#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace docent::command {

/// Where the bytes of a database go.
struct PartSizes {
  std::vector<std::pair<std::string, std::uint64_t>> parts;   ///< By what they hold.
  std::vector<std::pair<std::string, std::uint64_t>> stages;  ///< By the stage that made them.
  std::uint64_t file = 0;
};

/// The bytes that floors, Voronoi diagrams, exhibits and so on take. Throws ContentError where the
/// database cannot be opened.
PartSizes part_sizes(const std::filesystem::path& database);

}  // namespace docent::command
