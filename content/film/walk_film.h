#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "content/film/film_camera.h"
#include "content/film/studio.h"
#include "runtime/guide/avatar.h"
#include "runtime/model/museum.h"
#include "runtime/model/pixels.h"
#include "runtime/model/result.h"

namespace docent::film {

/// A guide on its way along a path, and how it is filmed.
struct WalkFilm {
  std::uint32_t floor = 0;
  std::uint32_t look = 0;  ///< Of scene::looks.
  View view = View::Kiosk;
  double from = 0, to = 0;     ///< Seconds since it sets out.
  std::uint32_t pictures = 1;  ///< At even times from the first second to the last.
};

/// The guide that walks along `path`, at its beginning. Fails where the museum's motion cannot.
Result<guide::Avatar> make_walker(const Museum& museum, std::span<const Vec2> path,
                                  const WalkFilm& film);

/// Time and camera go along with the walker, a kiosk's frame at a time, and the pictures are taken.
std::vector<Pixels> film_walk(const Museum& museum, guide::Avatar& walker, const WalkFilm& film,
                              Studio& studio);

}  // namespace docent::film
