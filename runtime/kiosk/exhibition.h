#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "platform/gles/renderer.h"
#include "runtime/guide/guide.h"
#include "runtime/model/museum.h"
#include "runtime/model/result.h"
#include "runtime/plan/planner.h"

namespace docent {

/// A museum with everything that runs it: changed as one when a new database is taken up. Neither
/// copied nor moved, because its parts borrow each other.
struct Exhibition {
  Museum museum;
  std::unique_ptr<Planner> planner;
  std::unique_ptr<Guide> guide;
  std::vector<Pixels> scenery_pictures;   ///< By image, until they are in texture memory.
  std::vector<TextureId> scenery_memory;  ///< By image: where they are from then on.

  Exhibition() = default;
  Exhibition(const Exhibition&) = delete;
  Exhibition& operator=(const Exhibition&) = delete;
};

/// Reads a database and makes all of it ready; takes a while, so not on the frame thread.
Result<std::unique_ptr<Exhibition>> load_exhibition(const std::filesystem::path& database,
                                                    const GuideSettings& settings);

/// Carries the building with its pictures and the body into texture memory. Frame thread.
void upload(Exhibition& exhibition, Renderer& renderer);

/// Gives the memory of its texts and pictures back. Frame thread.
void release(const Exhibition& exhibition, Renderer& renderer) noexcept;

/// Applies what the worker's cache of pieces changed. Frame thread; does not allocate.
void apply_pieces(Guide& guide, Renderer& renderer) noexcept;

}  // namespace docent
