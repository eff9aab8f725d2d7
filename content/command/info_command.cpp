#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "content/command/commands.h"
#include "content/command/open_museum.h"
#include "content/command/part_sizes.h"
#include "runtime/schema/schema.h"

namespace docent::command {

namespace {

using Json = nlohmann::ordered_json;

/// Sums something over all floors.
std::size_t count_on_floors(const Museum& museum, auto&& count) {
  std::size_t sum = 0;
  for (const Floor& floor : museum.floors) sum += count(floor);
  return sum;
}

/// Metres of medial axis on all floors.
double skeleton_length(const Museum& museum) {
  double length = 0;
  for (const Floor& floor : museum.floors)
    for (const RoadmapEdge& edge : floor.roadmap.edges) length += edge.length;
  return length;
}

/// {"walk, jog": 2.8}: how unlike the gaits of two classes are.
Json coefficients_between(const std::vector<MotionClass>& classes) {
  Json coefficients = Json::object();
  for (std::size_t i = 0; i < classes.size(); ++i)
    for (std::size_t j = i + 1; j < classes.size(); ++j)
      coefficients[classes[i].name + ", " + classes[j].name] = classes[i].coefficient[j];
  return coefficients;
}

Json facts_about(const Museum& museum) {
  Json facts;
  facts["schema_version"] = schema::version;
  facts["floors"] = museum.floors.size();
  facts["exhibits"] = museum.exhibits.size();
  facts["exhibit_ids"] = Json::array();
  for (const Exhibit& exhibit : museum.exhibits) facts["exhibit_ids"].push_back(exhibit.id);
  facts["languages"] = Json::array();
  for (const Language& language : museum.languages) facts["languages"].push_back(language.tag);
  facts["sites"] =
      count_on_floors(museum, [](const Floor& floor) { return floor.diagram.site.size(); });
  facts["voronoi_vertices"] =
      count_on_floors(museum, [](const Floor& floor) { return floor.diagram.vertex.size(); });
  facts["edges"] =
      count_on_floors(museum, [](const Floor& floor) { return floor.diagram.edge.size(); });
  facts["regions"] = count_on_floors(
      museum, [](const Floor& floor) { return floor.diagram.region_first.size() - 1; });
  facts["skeleton_length"] = skeleton_length(museum);
  std::size_t frames = 0;
  std::set<std::string> classes;
  for (const MotionClip& clip : museum.motion.clips) {
    frames += frame_count(clip);
    classes.insert(clip.motion_class);
  }
  facts["clips"] = museum.motion.clips.size();
  facts["frames"] = frames;
  facts["transitions"] = museum.motion.transitions.size();
  facts["motion_classes"] = classes;
  facts["class_coefficients"] = coefficients_between(museum.motion.classes);
  return facts;
}

Json sizes_of(const std::string& file) {
  const PartSizes sizes = part_sizes(file);
  Json parts;
  for (const auto& [part, bytes] : sizes.parts) parts[part] = bytes;
  parts["total"] = sizes.file;
  return parts;
}

/// "voronoi_vertices" as people read it.
std::string words_of(std::string key) {
  std::ranges::replace(key, '_', ' ');
  return key;
}

std::string line_of(const Json& value) {
  if (value.is_number_float()) return fmt::format("{:.2f} m", value.get<double>());
  if (value.is_object()) {
    std::vector<std::string> items;
    for (const auto& [key, number] : value.items())
      items.push_back(fmt::format("{} {:.2f}", key, number.get<double>()));
    return fmt::format("{}", fmt::join(items, "; "));
  }
  if (!value.is_array()) return value.dump();
  std::vector<std::string> items;
  for (const Json& item : value) items.push_back(item.get<std::string>());
  return fmt::format("{}", fmt::join(items, ", "));
}

void print_for_people(const Json& facts, const Json& sizes) {
  for (const auto& [key, value] : facts.items())
    fmt::print("{:<18} {}\n", words_of(key), line_of(value));
  fmt::print("bytes\n");
  for (const auto& [part, bytes] : sizes.items())
    fmt::print("  {:<16} {:>10}\n", words_of(part), bytes.get<std::uint64_t>());
}

int run_info(const std::string& file, bool json) {
  Json facts = facts_about(load_or_throw(file));
  const Json sizes = sizes_of(file);
  if (json) {
    facts["bytes"] = sizes;
    fmt::print("{}\n", facts.dump());
  } else {
    print_for_people(facts, sizes);
  }
  return 0;
}

}  // namespace

terminal::Command info_command() {
  using terminal::Times;
  struct InfoOptions {
    std::string database;
    bool json = false;
  };
  const auto options = std::make_shared<InfoOptions>();
  return {.name = "info",
          .manual = "says what a database holds",
          .options = {{"DB", terminal::file("DB", options->database), "The museum's database",
                       Times::Once},
                      {"--json", terminal::flag(options->json), "Print it as JSON"}},
          .run = [options] { return run_info(options->database, options->json); }};
}

}  // namespace docent::command
