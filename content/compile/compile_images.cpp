#include "content/compile/compile_images.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "content/compile/load_image.h"
#include "content/content_error.h"
#include "content/parallel.h"
#include "platform/file/read_file.h"

namespace docent::compile {

namespace {

/// An image that is wanted, and by which line.
struct WantedImage {
  std::string name;  ///< Empty: the blank card.
  config::Place place;
  std::optional<content::ContentError> problem;
};

/// The files that exhibits name, each once, in the order of the exhibits.
std::vector<WantedImage> wanted_images(const config::MuseumConfig& config, Museum& museum) {
  std::vector<WantedImage> wanted;
  std::map<std::string, std::uint32_t> index;
  for (std::size_t i = 0; i < config.exhibits.size(); ++i) {
    const config::Located<std::string>& image = config.exhibits[i].image;
    const auto [known, is_new] =
        index.emplace(image.value, static_cast<std::uint32_t>(wanted.size()));
    if (is_new) wanted.push_back({image.value, image.place, std::nullopt});
    museum.exhibits[i].image = known->second;
  }
  return wanted;
}

void load(const config::MuseumConfig& config, WantedImage& wanted, EncodedImage& image) {
  const std::filesystem::path file = config.folder / wanted.name;
  if (!wanted.name.empty() && !file::is_there(file)) return;  // already reported
  try {
    image = wanted.name.empty() ? blank_image() : load_image(file, wanted.name);
  } catch (const content::ContentError& error) {
    wanted.problem = error;
  }
}

}  // namespace

void compile_images(const config::MuseumConfig& config, unsigned jobs, Museum& museum,
                    Report& report) {
  std::vector<WantedImage> wanted = wanted_images(config, museum);
  museum.images.resize(wanted.size());
  content::for_each_index(wanted.size(), jobs,
                          [&](std::size_t i) { load(config, wanted[i], museum.images[i]); });
  for (const WantedImage& image : wanted)
    if (image.problem)
      report.add(config::diagnostic_at(config, image.place, image.problem->code,
                                       image.problem->what(), {}, image.problem->hint));
}

}  // namespace docent::compile
