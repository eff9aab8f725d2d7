#include "content/command/part_sizes.h"

#include <algorithm>
#include <map>
#include <string_view>

#include "content/command/open_museum.h"
#include "platform/sqlite/table_sizes.h"

namespace docent::command {

namespace {

/// A table, what people call the part of the museum that it holds, and the stage that makes it.
struct TablePart {
  std::string_view table, part, stage;
};

constexpr TablePart table_parts[] = {
    {"floor", "plan", "plan"},
    {"door", "plan", "plan"},
    {"voronoi_diagram", "voronoi", "voronoi"},
    {"roadmap", "skeleton", "voronoi"},
    {"sight_map", "paths", "paths"},
    {"tangent_graph", "paths", "paths"},
    {"hub_labels", "paths", "paths"},
    {"scenery", "scenery", "scenery"},
    {"museum", "exhibits", "exhibits"},
    {"room", "exhibits", "exhibits"},
    {"exhibit", "exhibits", "exhibits"},
    {"picture", "exhibits", "exhibits"},
    {"language", "texts", "exhibits"},
    {"text", "texts", "exhibits"},
    {"image", "images", "images"},
    {"object", "objects", "objects"},
    {"speech", "speech", "speech"},
    {"joint", "clips", "motion"},
    {"motion_clip", "clips", "motion"},
    {"motion_class", "transitions", "motion"},
    {"motion_graph", "transitions", "motion"},
    {"foresight", "foresight", "foresight"},
    {"avatar", "avatar", "avatar"},
};

void add(std::vector<std::pair<std::string, std::uint64_t>>& sizes, std::string_view name,
         std::uint64_t bytes) {
  const auto known = std::ranges::find(sizes, name, [](const auto& entry) { return entry.first; });
  if (known == sizes.end())
    sizes.emplace_back(name, bytes);
  else
    known->second += bytes;
}

}  // namespace

PartSizes part_sizes(const std::filesystem::path& file) {
  const sqlite::Database database = open_or_throw(file);
  const std::map<std::string, std::uint64_t> tables = sqlite::table_sizes(database);
  PartSizes sizes{.parts = {}, .stages = {}, .file = database.bytes.size()};
  std::uint64_t rest = sizes.file;
  for (const auto& [table, part, stage] : table_parts) {
    const auto found = tables.find(std::string(table));
    const std::uint64_t bytes = found == tables.end() ? 0 : found->second;
    rest -= bytes;
    add(sizes.parts, part, bytes);
    add(sizes.stages, stage, bytes);
  }
  sizes.parts.emplace_back("other", rest);
  sizes.stages.emplace_back("write", sizes.file);
  return sizes;
}

}  // namespace docent::command
