#include "content/compiler/part_sizes.h"

#include <algorithm>
#include <map>
#include <string_view>

#include "content/compiler/open_museum.h"
#include "platform/sqlite/table_sizes.h"

namespace docent {

namespace {

/// A table, and what people call the part of the museum that it holds.
struct TablePart {
  std::string_view table, part;
};

constexpr TablePart table_parts[] = {
    {"floor", "plan"},       {"door", "plan"},           {"voronoi_diagram", "voronoi"},
    {"roadmap", "skeleton"}, {"tangent_graph", "paths"}, {"scenery", "scenery"},
    {"museum", "exhibits"},  {"room", "exhibits"},       {"exhibit", "exhibits"},
    {"language", "texts"},   {"text", "texts"},          {"image", "images"},
    {"joint", "clips"},      {"motion_clip", "clips"},   {"motion_graph", "motion_graph"},
    {"avatar", "avatar"},
};

}  // namespace

PartSizes part_sizes(const std::filesystem::path& file) {
  const Database database = open_or_throw(file);
  const std::map<std::string, std::uint64_t> tables = table_sizes(database);
  PartSizes sizes{.parts = {}, .file = database.bytes.size()};
  std::uint64_t rest = sizes.file;
  for (const auto& [table, part] : table_parts) {
    const auto found = tables.find(std::string(table));
    const std::uint64_t bytes = found == tables.end() ? 0 : found->second;
    rest -= bytes;
    const auto known = std::ranges::find(sizes.parts, part, [](const auto& p) { return p.first; });
    if (known == sizes.parts.end())
      sizes.parts.emplace_back(part, bytes);
    else
      known->second += bytes;
  }
  sizes.parts.emplace_back("other", rest);
  return sizes;
}

}  // namespace docent
