#include "content/compile/compile_images.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "content/compile/linked_pictures.h"
#include "content/compile/load_image.h"
#include "content/compile/load_video.h"
#include "content/content_error.h"
#include "content/parallel.h"
#include "content/read_source.h"
#include "platform/file/read_file.h"
#include "runtime/model/moving_picture.h"
#include "runtime/model/scenery_images.h"

namespace docent::compile {

namespace {

/// An image that is wanted, and by which line.
struct WantedImage {
  std::string name;  ///< Empty: the blank card.
  config::Place place;
  std::optional<content::ContentError> problem{};
  std::vector<std::string>
      lost{};  ///< Pictures that an SVG drawing links to, and that are not shown.
  bool is_video = false, has_sound = false, has_captions = false, is_touched = false;
  std::size_t bytes = 0;  ///< Of a video.
};

/// The files that exhibits name, each once, in the order of the exhibits.
class WantedImages {
 public:
  std::uint32_t index_of(const config::Located<std::string>& image) {
    const auto [known, is_new] =
        index_.emplace(image.value, static_cast<std::uint32_t>(all.size()));
    if (is_new) all.push_back({image.value, image.place, std::nullopt, {}});
    return known->second;
  }

  std::vector<WantedImage> all;

 private:
  std::map<std::string, std::uint32_t> index_;
};

/// Ties the exhibits, and what one leafs to, to their images. Those that are the exhibits' own have
/// the first indices.
std::vector<WantedImage> wanted_images(const config::MuseumConfig& config, Museum& museum) {
  WantedImages wanted;
  for (std::size_t i = 0; i < config.exhibits.size(); ++i) {
    museum.exhibits[i].image = wanted.index_of(config.exhibits[i].image);
    wanted.all[museum.exhibits[i].image].is_touched |= config.exhibits[i].touch.value;
  }
  for (FurtherPicture& picture : museum.pictures) {
    const auto& of_it = config.exhibits[picture.exhibit].pictures.value;
    const std::span<const FurtherPicture> all = further_pictures(museum, picture.exhibit);
    const config::PictureSection& section = of_it[static_cast<std::size_t>(&picture - all.data())];
    picture.image = wanted.index_of(section.image);
    wanted.all[picture.image].has_captions |= !section.captions.value.empty();
  }
  return std::move(wanted.all);
}

void load(const config::MuseumConfig& config, Images use, WantedImage& wanted,
          EncodedImage& image) {
  const std::filesystem::path file = config.folder / wanted.name;
  if (!wanted.name.empty() && !file::is_there(file)) return;  // already reported
  try {
    if (!wanted.name.empty() && (is_video(file) || wanted.name.ends_with(".webm"))) {
      LoadedVideo video = load_video(file, wanted.name);
      wanted.is_video = true;
      wanted.has_sound = video.has_sound;
      wanted.bytes = video.image.bytes.size();
      image = std::move(video.image);
      if (use == Images::Check) image = {.name = wanted.name, .width = 0, .height = 0, .bytes = {}};
      return;
    }
    if (use == Images::Make || wanted.is_touched)
      image = wanted.name.empty() ? blank_image() : load_image(file, wanted.name);
    else if (!wanted.name.empty())
      check_image(file);
    if (use == Images::Check) image.name = wanted.name;
    if (file.extension() == ".svg") wanted.lost = linked_pictures(content::read_source(file));
  } catch (const content::ContentError& error) {
    wanted.problem = error;
  }
}

Diagnostic warning(Diagnostic diagnostic) {
  diagnostic.severity = Severity::Warning;
  return diagnostic;
}

void tell(const config::MuseumConfig& config, const WantedImage& image, Report& report) {
  if (image.problem)
    report.add(config::diagnostic_at(config, image.place, image.problem->code,
                                     fmt::format("'{}': {}", image.name, image.problem->what()), {},
                                     image.problem->hint));
  for (const std::string& lost : image.lost)
    report.add(warning(config::diagnostic_at(
        config, image.place, "picture-dropped",
        fmt::format("the drawing '{}' links to the picture '{}', which is not shown", image.name,
                    lost),
        {}, "embed it in the drawing: in Inkscape, Extensions, Images, Embed Images")));
}

/// What of a video is not shown, and where none is.
void tell_of_video(const config::MuseumConfig& config, const WantedImage& image, bool is_first,
                   Report& report) {
  if (image.is_video && is_first)
    report.add(config::diagnostic_at(
        config, image.place, "video-as-first-picture",
        fmt::format("the video '{}' is an exhibit's first picture, which hangs in the model",
                    image.name),
        {}, "name a picture there, and the video in [[exhibit.pictures]]"));
  if (image.has_sound && !image.has_captions)
    report.add(warning(config::diagnostic_at(
        config, image.place, "video-silent",
        fmt::format("the sound of the video '{}' is left out", image.name), {},
        "write what is said and heard into a WebVTT file: captions.en = \"...\"")));
}

/// All of a database is read when a kiosk starts, to see that it is whole.
void tell_of_all_videos(const config::MuseumConfig& config, std::span<const WantedImage> images,
                        std::size_t many_bytes, Report& report) {
  std::size_t bytes = 0;
  for (const WantedImage& image : images) bytes += image.bytes;
  if (bytes <= many_bytes) return;
  const WantedImage& largest = *std::ranges::max_element(images, {}, &WantedImage::bytes);
  report.add(warning(config::diagnostic_at(
      config, largest.place, "videos-large",
      fmt::format("the videos of this museum have {} MB together, which each kiosk reads into "
                  "memory when it starts; the largest is '{}'",
                  bytes >> 20U, largest.name),
      {}, "make them shorter or smaller, for example with ffmpeg's -b:v 700k")));
}

/// Of those that hang in the model.
void make_small_pictures(const config::MuseumConfig& config, unsigned jobs, Museum& museum) {
  const std::size_t count = scenery_images(museum);
  const std::uint32_t side = scenery_image_side(count);
  content::for_each_index(count, jobs, [&](std::size_t i) {
    EncodedImage& image = museum.images[i];
    if (!image.bytes.empty() && !is_video(image))
      image.small = small_picture(config.folder / image.name, image, side);
  });
}

/// Exhibits of which visitors see a blank card.
void report_blank_cards(const config::MuseumConfig& config, Report& report) {
  for (const config::ExhibitSection& exhibit : config.exhibits)
    if (!exhibit.image.given && exhibit.image.value.empty() && !exhibit.id.value.empty() &&
        exhibit.image.place.range.line == exhibit.place.range.line)
      report.add(warning(config::diagnostic_at(
          config, exhibit.place, "no-picture",
          fmt::format("exhibit '{}' has no picture, and visitors see a blank card",
                      exhibit.id.value),
          {}, "image = \"images/...\"")));
}

}  // namespace

void compile_images(const config::MuseumConfig& config, Images use, unsigned jobs, Museum& museum,
                    Report& report, std::size_t many_bytes) {
  std::vector<WantedImage> wanted = wanted_images(config, museum);
  museum.images.resize(wanted.size());
  content::for_each_index(wanted.size(), jobs,
                          [&](std::size_t i) { load(config, use, wanted[i], museum.images[i]); });
  if (use == Images::Make) make_small_pictures(config, jobs, museum);
  const std::size_t first = scenery_images(museum);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    tell(config, wanted[i], report);
    tell_of_video(config, wanted[i], i < first, report);
  }
  tell_of_all_videos(config, wanted, many_bytes, report);
  report_blank_cards(config, report);
}

}  // namespace docent::compile
