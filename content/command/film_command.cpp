#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "content/command/commands.h"
#include "content/command/open_museum.h"
#include "content/command/query_io.h"
#include "content/command/stopwatch.h"
#include "content/content_error.h"
#include "content/film/contact_sheet.h"
#include "content/film/film_camera.h"
#include "content/film/studio.h"
#include "content/film/walk_film.h"
#include "content/film/webp_film.h"
#include "content/write/replace_file.h"
#include "platform/image/image.h"
#include "runtime/scene/look.h"

namespace docent::command {
namespace {

constexpr PixelSize sheet_picture{320, 320}, film_picture{480, 480};
constexpr std::uint32_t sheet_pictures = 12;
constexpr double film_rate = 20;              // pictures a second
constexpr std::uint32_t most_pictures = 600;  // in memory at once: half a gigabyte
constexpr double rest = 1;                    // seconds that are filmed after the walk

struct FilmOptions {
  std::string database, path, output, floor;
  film::View view = film::View::Kiosk;
  std::uint32_t look = 0;
  std::optional<std::array<double, 2>> at;  ///< Seconds.
  std::optional<std::uint32_t> frames;
};

[[noreturn]] void misuse(const std::string& option, const char* code, const std::string& message,
                         const std::string& hint = {}) {
  throw content::ContentError(Errc::WrongUsage, option, code, message, hint);
}

bool is_moving(const FilmOptions& options) {
  const std::string extension = std::filesystem::path(options.output).extension().string();
  if (extension != ".png" && extension != ".webp")
    misuse(options.output, "unknown-film-format", "a film ends in .png or .webp",
           ".png is a sheet of pictures, .webp moves");
  return extension == ".webp";
}

void check_times(const FilmOptions& options) {
  if (options.at && !(0 <= options.at->front() && options.at->front() <= options.at->back()))
    misuse("--at", "film-times", "the seconds S0,S1 must not be below 0, and S1 not before S0");
}

std::vector<std::pair<std::string_view, std::uint32_t>> named_looks() {
  std::vector<std::pair<std::string_view, std::uint32_t>> named;
  for (std::uint32_t i = 0; i < scene::looks.size(); ++i)
    named.emplace_back(scene::looks[i].name, i);
  return named;
}

std::uint32_t picture_count(const FilmOptions& options, double seconds, bool moves) {
  if (options.frames) return *options.frames;
  if (!moves) return sheet_pictures;
  const double wanted = seconds * film_rate + 1;
  if (wanted > most_pictures)
    misuse("--at", "long-film",
           fmt::format("{:.0f} s are {:.0f} pictures, and a film has at most {}", seconds, wanted,
                       most_pictures),
           "film a part of the walk (--at S0,S1), or with fewer pictures (--frames N)");
  return static_cast<std::uint32_t>(wanted);
}

film::WalkFilm plan_film(const FilmOptions& options, const guide::Avatar& walker,
                         film::WalkFilm film, bool moves) {
  const auto [from, to] =
      options.at.value_or(std::array<double, 2>{0, walker.plan->seconds() + rest});
  film.from = from;
  film.to = to;
  film.pictures = picture_count(options, to - from, moves);
  return film;
}

template <typename T>
T or_throw(Result<T> result, const std::string& file, const char* code, const char* hint = "") {
  if (!result) throw content::to_content_error(result.error(), file, code, hint);
  return std::move(*result);
}

std::vector<std::byte> developed(const std::vector<Pixels>& pictures, const film::WalkFilm& film,
                                 const FilmOptions& options, bool moves) {
  if (!moves)
    return or_throw(
        image::encode_png(film::contact_sheet(pictures, film::sheet_columns(pictures.size()))),
        options.output, "cannot-film");
  const double seconds =
      film.pictures > 1 ? (film.to - film.from) / (film.pictures - 1) : 1 / film_rate;
  return or_throw(film::encode_webp(pictures, seconds), options.output, "cannot-film");
}

void run_film(const FilmOptions& options) {
  const Stopwatch stopwatch;
  const bool moves = is_moving(options);
  check_times(options);
  const std::vector<Vec2> path = read_path(options.path);
  const Museum museum = load_or_throw(options.database);
  film::WalkFilm film{
      .floor = floor_named(museum, options.floor), .look = options.look, .view = options.view};
  guide::Avatar walker =
      or_throw(film::make_walker(museum, path, film), options.database, "cannot-walk");
  film = plan_film(options, walker, film, moves);
  film::Studio studio = or_throw(
      film::open_studio(museum, moves ? film_picture : sheet_picture), options.output,
      "nothing-to-draw-with", "films need OpenGL ES 3 through EGL; Mesa's software driver will do");
  const std::vector<Pixels> pictures = film_walk(museum, walker, film, studio);
  write::replace_file(options.output, developed(pictures, film, options, moves));
  stopwatch.say_wrote(options.output);
}

}  // namespace

terminal::Command film_command() {
  using film::View;
  using terminal::Times;
  auto options = std::make_shared<FilmOptions>();
  return {
      .name = "film",
      .manual = "films the guide on a path, as a sheet of pictures or a moving one",
      .options =
          {
              {"DB", terminal::file("DB", options->database), "The museum's database", Times::Once},
              {"--path", terminal::file("P.csv", options->path),
               "Columns x,y: a polyline in metres", Times::Once},
              {"-o,--output", terminal::file("FILE", options->output),
               "A sheet of pictures FILE.png, or a moving one FILE.webp", Times::Once},
              {"--view",
               terminal::one_of<View>({{"front", View::Front},
                                       {"side", View::Side},
                                       {"back", View::Back},
                                       {"above", View::Above},
                                       {"kiosk", View::Kiosk}},
                                      options->view),
               "From where; kiosk: as visitors see it", Times::AtMostOnce, "kiosk"},
              {"--look", terminal::one_of<std::uint32_t>(named_looks(), options->look), "Who walks",
               Times::AtMostOnce, scene::looks[0].name},
              {"--at", terminal::numbers("S0,S1", options->at), "From which second to which",
               Times::AtMostOnce, "the whole walk"},
              {"--frames",
               terminal::number(
                   "N",
                   {.of = terminal::Limits::Of::WholeNumbers, .least = 1, .most = most_pictures},
                   options->frames),
               "Pictures, at even times", Times::AtMostOnce, "12 on a sheet, else 20 a second"},
              {"--floor", terminal::text("NAME", options->floor), "On which floor",
               Times::AtMostOnce, "the kiosk's floor"},
          },
      .run = [options] {
        run_film(*options);
        return 0;
      }};
}

}  // namespace docent::command
